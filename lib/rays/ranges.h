/* ranges.h - a ray and a surface whose coefficients are known to an error only, in integers. */
#ifndef ALGSURF_RANGES_H
#define ALGSURF_RANGES_H
#include "intersect_impl.h"
#include "region.h"

/* Where hits are, or may be: in [lo,hi]. */
typedef struct algsurf_i_ray_range {
    double lo, hi;
    int side; /* 0: undecided; else each polynomial of the set has one simple root there, and this
                 sign before it */
    algsurf_status reason; /* why it is undecided */
} algsurf_i_ray_range;

/* All of them along a checked ray in the region, in order; at most ALGSURF_MAX_DEGREE.
 * A root beyond the largest double has an infinite lo or hi, as in algsurf_i_exact_roots, which see for
 * stack, limit, observer.  OK or E_NO_MEMORY. */
algsurf_status algsurf_i_exact_ranges(const algsurf_surface *surface, const algsurf_i_region *region,
                                      const algsurf_ray *ray, size_t limit, algsurf_observer *observer,
                                      algsurf_i_ray_range ranges[ALGSURF_MAX_DEGREE], int *count);
#endif
