/* mesh_make.h - triangles for an algebraic surface in an extent.
 *
 * Neither files nor threads nor messages: those are the caller's.
 */
#ifndef MESH_MAKE_H
#define MESH_MAKE_H
#include "mesh_data.h"

typedef struct mesh_options {
    int cells;      /* along the longest axis, MESH_LEAST_CELLS to MESH_MOST_CELLS */
    int solid;      /* 1: the extent closes what is inside, P < 0; 0: the surface alone */
    int on_surface; /* 1: smooth points are on the surface; 0: the mesh lies evenly on both sides of it
                       (mesh_balance.h) */
    const algsurf_plane *planes; /* cut the extent */
    size_t plane_count;
    mesh_runner *run; /* null: one after the other */
    void *run_data;
    int (*progress)(int done, int total, void *data); /* null: none; other than 0 cancels */
    void *progress_data;
} mesh_options;

/* Makes the mesh of a surface in a ball or a box; to be freed by mesh_free, whatever is returned.
 * Every edge has two triangles, or lies on the boundary of the extent or on a plane and has one; a solid has
 * no boundary.
 * Each vertex is in its own cell, or near it (mesh_vertex.h, mesh_balance.h).  The same mesh for every
 * runner.
 * Returns OK or CANCELLED.  Errors: those of mesh_space_begin, E_CAPACITY (above MESH_MOST_POINTS), and
 * those of algsurf_intersect_all.  Cost: 3 n^2 lines for n cells along each axis, and a microsecond or two
 * for each vertex.  Memory: some 200 bytes n^2, and 75 bytes a triangle. */
algsurf_status mesh_make(const algsurf_surface *surface, const algsurf_extent *extent,
                         const mesh_options *options, mesh *made);

#endif
