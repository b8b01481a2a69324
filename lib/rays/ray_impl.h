/* ray_impl.h - checks of rays and extents; the part of a ray in an extent. */
#ifndef ALGSURF_RAY_IMPL_H
#define ALGSURF_RAY_IMPL_H
#include <math.h>

#include "algsurf/ray.h"

/* Is any t of [t_min, t_max] a double?  None is if an infinite end is on the wrong side. */
static inline int algsurf_i_has_points(double t_min, double t_max) {
    return t_min <= t_max && t_min < HUGE_VAL && t_max > -HUGE_VAL;
}

/* A coordinate of a ray's point at a finite t, clamped to the range of double. */
double algsurf_i_coordinate_at(const algsurf_ray *ray, int axis, double t);

/* OK, E_ARGUMENT (null, NaN t, zero direction) or E_NOT_FINITE. */
algsurf_status algsurf_i_ray_check(const algsurf_ray *ray);

/* OK, E_ARGUMENT (unknown kind, size not positive) or E_NOT_FINITE; null is all of space. */
algsurf_status algsurf_i_extent_check(const algsurf_extent *extent);

/* algsurf_extent_clip for checked arguments, in the standard floating-point environment. */
int algsurf_i_extent_clip(const algsurf_extent *extent, const algsurf_ray *ray, algsurf_ray *chord);

/* Where the line of a checked ray enters and leaves a checked extent; infinite also where that is beyond the
 * largest double.  Returns 0 when it does not meet it, as computed. */
int algsurf_i_line_clip(const algsurf_extent *extent, const algsurf_ray *ray, double ends[2]);

#endif
