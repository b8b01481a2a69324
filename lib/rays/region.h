/* region.h - what is shown: an extent, and of it what planes keep. */
#ifndef ALGSURF_REGION_H
#define ALGSURF_REGION_H
#include <stddef.h>

#include "algsurf/ray.h"

typedef struct algsurf_i_region {
    const algsurf_extent *extent; /* null: all of space */
    const algsurf_plane *planes;
    size_t plane_count;
} algsurf_i_region;

/* A ray enters and leaves a ball at irrational t.  So a chord is the part of the ray in a region a little
 * larger, and its edges tell which part of it is certainly in the region. */
typedef struct algsurf_i_edges {
    int cut;                   /* 0: all of the chord is in the region */
    double inner_lo, inner_hi; /* the part that is; inner_lo > inner_hi: of no part it is certain */
} algsurf_i_edges;

/* The chord of a ray; it, the extent and the planes are checked.  Returns 0 when the ray certainly has no
 * point in the region. */
int algsurf_i_region_bracket(const algsurf_i_region *region, const algsurf_ray *ray, algsurf_ray *chord,
                             algsurf_i_edges *edges);

#endif
