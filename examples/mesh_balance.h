/* mesh_balance.h - a mesh that lies evenly on both sides of its surface.
 *
 * A triangle with its corners on a curved surface lies on one side of it: a ball becomes too small.  Moved so
 * that the mean distance about each vertex is zero, the mesh comes twice as near, and encloses the right
 * volume up to the fourth order in the cells' size.
 */
#ifndef MESH_BALANCE_H
#define MESH_BALANCE_H
#include "mesh_data.h"

/* Moves the points on the surface, along their normals, by at most an eighth of a cell; those that are not
 * MESH_SMOOTH stay.  0: no memory.  Cost: P and its gradient once a triangle. */
int mesh_balance(mesh *m, const algsurf_surface *surface, mesh_runner *run, void *run_data);

#endif
