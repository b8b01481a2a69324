/* mesh_open.h - a surface that is open where the extent ends: its points, and a shell of it. */
#ifndef MESH_OPEN_H
#define MESH_OPEN_H
#include "mesh_data.h"

/* Drops points that no triangle has, and gives triangles that share a point but no edges there points of
 * their own, so that the mesh is a manifold with boundary.  0: no memory. */
int mesh_open_tidy(mesh *m);

/* Turns all triangles and normals around. */
void mesh_open_turn(mesh *m);

/* Makes a closed shell of an open or closed surface: both sides moved along the normals by half the
 * thickness, joined along the boundary.  It meets itself where the surface bends with a radius below that, at
 * singular points, and where two sheets are nearer than the thickness.  0: no memory. */
int mesh_open_thicken(mesh *m, double thickness);

#endif
