/* mesh_space.h - the part of space that is meshed: a lattice over an extent, and what bounds the mesh there.
 *
 * A solid is what is inside: P < 0, in the extent, kept by all planes.  Its boundary has parts: the surface,
 * and faces of the extent.  A part is known by a number, MESH_SURFACE or more.
 */
#ifndef MESH_SPACE_H
#define MESH_SPACE_H
#include "algsurf/algsurf.h"

enum {
    MESH_SURFACE = 0,
    MESH_BALL = 1,
    MESH_BOX = 1 /* of six faces */,
    MESH_PLANE = 7 /* the first plane */
};
enum { MESH_LEAST_CELLS = 4, MESH_MOST_CELLS = 2048 };

/* Of a cell: vertices keep that far from its faces, so that those of neighbours differ, near the origin as
 * floats, too. */
#define MESH_MARGIN 0x1p-12

typedef struct mesh_space {
    const algsurf_surface *surface;
    algsurf_extent extent; /* a ball or a box */
    const algsurf_plane *planes;
    size_t plane_count;
    algsurf_plane plane[ALGSURF_MAX_CLIP_PLANES]; /* the same, with normals of about 1 */
    int cells[3];                                 /* along each axis; there is a point more */
    double h;                                     /* the edge of a cell */
    double *point[3];                             /* coordinates of the lattice's points */
} mesh_space;

/* A lattice of cubes, `cells` of them along the longest axis of the extent.  The outermost points lie
 * outside. It is moved off the extent's centre by fractions of a cell that no surface is likely to know, so
 * that planes of symmetry do not pass through its points.  Errors: E_ARGUMENT (cells, an extent without end,
 * too many planes), E_RANGE (the longest axis is below 1e-30, a coordinate above 1e30, or so large that
 * doubles do not show MESH_MARGIN there), E_NO_MEMORY; free with mesh_space_end, also then. */
algsurf_status mesh_space_begin(mesh_space *space, int cells);
void mesh_space_end(mesh_space *space);

/* By a square root alone, so that all platforms agree. */
double mesh_length(const double v[3]);

/* How far a point is outside of a part's side of space, to first order in the distance, and the unit normal
 * there, outwards; returns 0 where there is none. */
int mesh_space_part(const mesh_space *space, int part, const double x[3], double *distance, double normal[3]);

/* The part of the line through x along an axis that is in the extent and kept by the planes, as coordinates,
 * and which part of the boundary each end is on; returns 0 where it is empty. */
int mesh_space_span(const mesh_space *space, int axis, const double x[3], double span[2], int part[2]);

#endif
