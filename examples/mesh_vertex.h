/* mesh_vertex.h - where in its cell the vertex of a sheet is. */
#ifndef MESH_VERTEX_H
#define MESH_VERTEX_H
#include "mesh_data.h"

typedef struct mesh_vertex {
    double at[3];
    float normal[3];     /* unit, out of the solid: that of the surface, where the sheet has a part of it */
    unsigned char kind;  /* MESH_SMOOTH, ... */
    unsigned char sharp; /* 1: the surface itself turns by more than 60 degrees in the cell */
} mesh_vertex;

/* Places the vertex of a sheet in its cell.
 *   crossing, count  where edges of the cell cross the sheet: 3 to 12
 *   low, high        the cell
 * First the least squares of the distances to the tangent planes at the crossings, by the eigenvectors
 * of their matrix, small ones left out (Ju, Losasso, Schaefer, Warren 2002); of a smooth sheet the mean
 * of the crossings suffices.  Then Newton's method onto all parts that are crossed at once, along the
 * faces of the cell where it would leave it.  So vertices of smooth sheets are on the surface, nearly
 * all to the last bits; one that is held at a face of its cell may be off by a thousandth of the cell.
 * Those of a cut are on both the surface and the extent, for which they may leave the cell by nearly its
 * edge: a sharp rim ends beyond the last cell whose corners tell of it.  So does a wedge where the
 * surface crosses itself, whose vertices may leave their cells as far. */
void mesh_vertex_place(const mesh_space *space, const mesh_crossing *crossing, int count, const double low[3],
                       const double high[3], mesh_vertex *vertex);

#endif
