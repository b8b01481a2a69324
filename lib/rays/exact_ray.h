/* exact_ray.h - the roots along a ray by integers: every ray of an exact surface is decided. */
#ifndef ALGSURF_RAYS_EXACT_RAY_H
#define ALGSURF_RAYS_EXACT_RAY_H
#include "../surface/impl.h"
#include "algsurf/intersect.h"
#include "region.h"

/* A root along a ray; or, where the surface's coefficients are known to an error only, a place where there
 * may be some. */
typedef struct algsurf_i_ray_root {
    int multiplicity;      /* 0: the ray lies in the surface */
    int side;              /* the sign of P just before it, 0 for a ray in the surface */
    double t, t_lo, t_hi;  /* as in algsurf_hit */
    algsurf_status reason; /* OK; or why the place is undecided: then t_lo and t_hi alone mean something */
} algsurf_i_ray_root;

typedef enum algsurf_i_want { ALGSURF_WANT_FIRST, ALGSURF_WANT_ALL, ALGSURF_WANT_ANY } algsurf_i_want;

/* Roots of P along a checked ray in [t_min, t_max] and in the region, both as they are given, in increasing
 * order: the first (`want` FIRST), all, or, for ANY, one of which only that it exists is known.  There are no
 * more than the surface's degree, or 1.  A ray in the surface has one root, of multiplicity 0, at the first t
 * that counts.  A root beyond the largest double has an infinite t_lo or t_hi.  Of coefficients with an error
 * all roots and places are given, whatever is wanted; a root is one simple root of each polynomial of the
 * set. limit  bytes that may be allocated observer  null, or who is told Returns OK or E_NO_MEMORY.  Stack:
 * 20 KiB, of which 16 serve as memory before anything is allocated. */
algsurf_status algsurf_i_exact_roots(const algsurf_surface *surface, const algsurf_i_region *region,
                                     const algsurf_ray *ray, algsurf_i_want want, size_t limit,
                                     algsurf_observer *observer, algsurf_i_ray_root *roots, int *count);

#endif
