/* ray_impl.h - checks of rays and extents, and the clip itself, for the rooms below ray. */
#ifndef ALGSURF_RAY_IMPL_H
#define ALGSURF_RAY_IMPL_H
#include <math.h>
#include <stddef.h>

#include "algsurf/ray.h"

/* Is any t of [t_min, t_max] a double?  None is if an infinite end is on the wrong side. */
static inline int algsurf_i_has_points(double t_min, double t_max) {
    return t_min <= t_max && t_min < HUGE_VAL && t_max > -HUGE_VAL;
}

/* OK, E_ARGUMENT (null, NaN t, zero direction) or E_NOT_FINITE. */
algsurf_status algsurf_i_ray_check(const algsurf_ray *ray);

/* OK, E_ARGUMENT (unknown kind, size not positive) or E_NOT_FINITE; null is all of space. */
algsurf_status algsurf_i_extent_check(const algsurf_extent *extent);

/* algsurf_extent_clip for checked arguments, in the standard floating-point environment. */
int algsurf_i_extent_clip(const algsurf_extent *extent, const algsurf_ray *ray, algsurf_ray *chord);

/* What is shown: an extent, and of it what planes keep. */
typedef struct algsurf_i_region {
    const algsurf_extent *extent; /* null: all of space */
    const algsurf_plane *planes;
    size_t plane_count;
} algsurf_i_region;

/* The chord of a region a little larger, and which part of it is inside for sure: a line enters and leaves
 * a ball at irrational places, which the ends of a chord only approximate. */
typedef struct algsurf_i_edges {
    int cut;                   /* 0: all of the chord is inside */
    double inner_lo, inner_hi; /* no part is for sure if inner_lo > inner_hi */
} algsurf_i_edges;

/* Checked arguments, as above: returns 0 when the ray surely has no point in the region. */
int algsurf_i_region_bracket(const algsurf_i_region *region, const algsurf_ray *ray, algsurf_ray *chord,
                             algsurf_i_edges *edges);

#endif
