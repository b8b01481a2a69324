/* ray_impl.h - checks of rays and extents, and the clip itself, for the rooms below ray. */
#ifndef ALGSURF_RAY_IMPL_H
#define ALGSURF_RAY_IMPL_H
#include "algsurf/ray.h"

/* OK, E_ARGUMENT (null, NaN t, zero direction) or E_NOT_FINITE. */
algsurf_status algsurf_i_ray_check(const algsurf_ray *ray);

/* OK, E_ARGUMENT (unknown kind, size not positive) or E_NOT_FINITE; null is all of space. */
algsurf_status algsurf_i_extent_check(const algsurf_extent *extent);

/* algsurf_extent_clip for checked arguments, in the standard floating-point environment. */
int algsurf_i_extent_clip(const algsurf_extent *extent, const algsurf_ray *ray, algsurf_ray *chord);

#endif
