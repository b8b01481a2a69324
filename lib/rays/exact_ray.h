/* exact_ray.h - the roots along a ray by integers: every ray of an exact surface is decided. */
#ifndef ALGSURF_RAYS_EXACT_RAY_H
#define ALGSURF_RAYS_EXACT_RAY_H
#include "intersect_impl.h"
#include "region.h"

/* The unit 2^unit of t that suits a chord; of one without ends, about the way from the origin to the
 * surface. */
int algsurf_i_exact_unit(const algsurf_surface *surface, const algsurf_ray *ray, double t_min, double t_max);

/* Roots of P along a checked ray in [t_min, t_max] and in the region, both as they are given, in increasing
 * order: the first (`want` FIRST), all, or, for ANY, one of which only that it exists is known.  At most
 * `capacity` are written, the surface's degree, at least 1, always suffices.  A ray in the surface has one
 * root, of multiplicity 0, at the first t that counts.
 *   limit  bytes that may be allocated
 *   observer  null, or who is told
 * Returns OK or E_NO_MEMORY.  Stack: 20 KiB, of which 16 serve as memory before anything is allocated. */
algsurf_status algsurf_i_exact_roots(const algsurf_surface *surface, const algsurf_i_region *region,
                                     const algsurf_ray *ray, algsurf_i_want want, size_t limit,
                                     algsurf_observer *observer, algsurf_i_ray_root *roots, int capacity,
                                     int *count);

#endif
