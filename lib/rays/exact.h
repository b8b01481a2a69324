/* exact.h - the last step of the certified tier: roots in an interval by exact arithmetic. */
#ifndef ALGSURF_INTERSECT_EXACT_H
#define ALGSURF_INTERSECT_EXACT_H
#include "intersect_impl.h"

/* A root of P(origin + t direction), or a place where some may be, lo <= t <= hi. */
typedef struct algsurf_i_exact_root {
    int state; /* ALGSURF_HIT or ALGSURF_UNCERTAIN */
    algsurf_status reason;
    double lo, hi;
    algsurf_dd t; /* in the middle, to double-double */
} algsurf_i_exact_root;

/* The roots in [lo,hi], lo <= hi, not both infinite, that lie in the extent (null: all of them), in
 * increasing order; for WANT_FIRST the first entry, for WANT_ANY all up to the first hit.  Uncertain are only
 * places of width 2^-60 (hi - lo), and less than 2^-30 of what they are from 0, with a multiple root or
 * several roots; or a root next to an extent's sphere, or on it if the ray's other point of the sphere is not
 * on P = 0; and all of [lo,hi] where P vanishes on it.
 *
 *   roots  room for degree + 1
 *
 * Returns how many were written; -1, and nothing is known, when the numbers need too many digits (some
 * thousand decimal ones between the largest and the least of the ray's numbers to the power of the degree),
 * or more memory than there is, or when the surface's coefficients are not exact.  Cost: some 20 microseconds
 * for degree 6; grows with the fifth power of the degree, and with the digits that the ray's numbers span.
 * Allocates. */
int algsurf_i_exact_roots(const algsurf_surface *surface, const algsurf_ray *ray,
                          const algsurf_extent *extent, double lo, double hi, algsurf_i_want want,
                          algsurf_i_exact_root *roots);

#endif
