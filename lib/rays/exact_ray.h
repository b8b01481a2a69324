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

/* Which roots are wanted, and how they are found. */
typedef struct algsurf_i_wanted {
    algsurf_i_want want;
    int side;                   /* the sign of P before them; 0: any */
    size_t limit;               /* bytes that may be allocated */
    algsurf_observer *observer; /* null, or who is told */
} algsurf_i_wanted;

/* Roots of P along a checked ray in [t_min, t_max] and in the region, both as they are given, in increasing
 * order: the first (FIRST), all, or, for ANY, one of which only that it exists is known.  There are no
 * more than the surface's degree, or 1.  A ray in the surface has one root, of multiplicity 0, at the first t
 * that counts.  A root beyond the largest double has an infinite t_lo or t_hi.  Of coefficients with an error
 * all roots and places are given, whatever is wanted; a root is one simple root of each polynomial of the
 * set.
 *   miss_side  if there are none: the sign of P where the ray's part in the region ends; 0 if there is
 *              no such part, if rounding hides it, or if P is 0 on it
 * Returns OK or E_NO_MEMORY.  Stack: 20 KiB, of which 16 serve as memory before anything is allocated. */
algsurf_status algsurf_i_exact_roots(const algsurf_surface *surface, const algsurf_i_region *region,
                                     const algsurf_ray *ray, const algsurf_i_wanted *wanted,
                                     algsurf_i_ray_root *roots, int *count, int *miss_side);

#endif
