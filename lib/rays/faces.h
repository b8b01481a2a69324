/* rays/faces.h - when a point of a ray is in a region (an extent, of which planes keep a part), as signs of
 * polynomials with integer coefficients. */
#ifndef ALGSURF_FACES_H
#define ALGSURF_FACES_H
#include "../poly/integral.h"
#include "region.h"

enum { ALGSURF_MOST_FACES = 6 + ALGSURF_MAX_CLIP_PLANES };

/* The conditions for X = origin + 2^e u direction to be in the region: all face[i](u) >= 0.  Each is a power
 * of two times R^2 - |X - c|^2 (a ball: one, of degree 2), h_i - (X_i - c_i), h_i + (X_i - c_i) (a box: six,
 * of degree <= 1) or c - n.X (a plane: one, likewise; -1 where the ray lies in that face).
 * Returns 0 when there is no memory. */
int algsurf_i_faces(algsurf_memory *m, const algsurf_i_region *region, const double origin[3],
                    const double direction[3], int e, algsurf_zpoly face[ALGSURF_MOST_FACES], int *count);
#endif
