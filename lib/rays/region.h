/* region.h - what is shown: an extent, and of it what planes keep; the part of a ray in it. */
#ifndef ALGSURF_REGION_H
#define ALGSURF_REGION_H
#include <math.h>
#include <stddef.h>

#include "algsurf/ray.h"
#include "algsurf/surface.h"

typedef struct algsurf_i_region {
    const algsurf_extent *extent; /* null: all of space */
    const algsurf_plane *planes;
    size_t plane_count;
} algsurf_i_region;

/* Is any t of [t_min, t_max] a double?  None is if an infinite end is on the wrong side. */
static inline int algsurf_i_has_points(double t_min, double t_max) {
    return t_min <= t_max && t_min < HUGE_VAL && t_max > -HUGE_VAL;
}

/* A coordinate of a ray's point at a finite t, clamped to the range of double. */
double algsurf_i_coordinate_at(const algsurf_ray *ray, int axis, double t);

/* OK, E_ARGUMENT (null, zero direction) or E_NOT_FINITE. */
algsurf_status algsurf_i_ray_check(const algsurf_ray *ray);

/* OK, E_ARGUMENT (unknown kind, size not positive) or E_NOT_FINITE; null is all of space. */
algsurf_status algsurf_i_extent_check(const algsurf_extent *extent);

/* OK, E_ARGUMENT (more than ALGSURF_MAX_CLIP_PLANES, null, a normal that is 0) or E_NOT_FINITE. */
algsurf_status algsurf_i_planes_check(const algsurf_plane *planes, size_t count);

/* All that follows is for what is checked, in the standard floating-point environment. */

/* A ray enters and leaves a ball at irrational t.  So its chord in a region is known to reach from some t to
 * some other. */
typedef struct algsurf_i_chord {
    double lo, hi;             /* no point of the ray that is in the region is before or behind */
    double inner_lo, inner_hi; /* all between are in it; lo > hi: of none it is certain */
} algsurf_i_chord;

/* The chord of a ray.  Returns 0 when the ray certainly has no point in the region. */
int algsurf_i_region_chord(const algsurf_i_region *region, const algsurf_ray *ray, algsurf_i_chord *chord);

/* Cuts a chord down to what all planes keep.  Returns 0 when that is surely nothing. */
int algsurf_i_planes_cut(const algsurf_plane *planes, size_t count, const algsurf_ray *ray,
                         algsurf_i_chord *chord);

/* A plane in a unit of 2^exponent, its normal multiplied by a power of two so that its largest component is
 * in [1/2,1); components of less than 2^-1000 of that may be lost. */
algsurf_plane algsurf_i_plane_in_unit(const algsurf_plane *plane, int exponent);

/* A surface that is exactly the sphere which bounds the extent is not cut by it: then *wider, a ball twice as
 * large, may stand in its place, so that the roots of rays are not all on the extent's edge.  Returns that,
 * or the extent. */
const algsurf_extent *algsurf_i_without_own_ball(const algsurf_surface *surface, const algsurf_extent *extent,
                                                 algsurf_extent *wider);

#endif
