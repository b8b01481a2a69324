/* exact_radii.h - the real roots of all polynomials whose coefficients differ from given integers by no more
 * than given radii. */
#ifndef ALGSURF_EXACT_RADII_H
#define ALGSURF_EXACT_RADII_H
#include "exact_walk.h"

/* Where roots are.
 * - sign_lo 1 or -1, lo < hi: every polynomial of the set has exactly one root in (lo,hi), a simple one, the
 *   sign sign_lo at lo and the other one at hi.  hi - lo is as small as doubles and radii allow.  One of them
 *   is infinite, and the other one the largest double, for a root beyond this.
 * - sign_lo 0: undecided; [lo,hi] holds any number of roots, not the same for all polynomials of the set.
 * With lo = hi: a root of all of them or of some; their signs there tell. */
typedef struct algsurf_exact_range {
    double lo, hi;
    int sign_lo;
} algsurf_exact_range;

/* The roots t = 2^unit u in [lo,hi], lo <= hi, infinite ends allowed, of the polynomials p + e, |e_k| <=
 * radius_k.  Radius has no negative coefficients; its degree may be above p's.  Outside of the ranges found,
 * which are in order and at most `capacity` >= 1, no polynomial of the set has a root in [lo,hi]; when there
 * is no room for more, ranges are joined to undecided ones.  watch: null, or who is told.  Returns 0 when
 * there is no memory; nothing of it is kept. */
int algsurf_exact_radii_isolate(algsurf_memory *m, const algsurf_zpoly *p, const algsurf_zpoly *radius,
                                int unit, double lo, double hi, algsurf_exact_range *found, int capacity,
                                int *count, const algsurf_i_watch *watch);

/* The sign at t, finite, that all these polynomials have in common, or 2: there is none.  Returns as above.
 */
int algsurf_exact_radii_sign(algsurf_memory *m, const algsurf_zpoly *p, const algsurf_zpoly *radius, int unit,
                             double t, int *sign);
#endif
