/* decide.h - the real roots of a polynomial given as doubles or integers, by integers. */
#ifndef ALGSURF_DECIDE_H
#define ALGSURF_DECIDE_H
#include <stddef.h>

#include "algsurf/isolate.h"
#include "line.h"

/* What deciding one polynomial may allocate, in bytes. */
#define ALGSURF_I_DECIDE_MEMORY ((size_t)1 << 30)

/* The roots on a line in increasing order, whatever is wanted, the first `capacity` of them; the degree
 * always suffices.  lo = hi is a root; else there is one in (lo,hi), with the sign before it, and either
 * these are neighbours or, where not `refined`, the root is simple, alone there, and p is not 0 at the ends.
 * Returns OK or E_NO_MEMORY.  Stack: 20 KiB, and what the walk takes. */
algsurf_status algsurf_i_decide(const algsurf_i_line *line, algsurf_real_root *roots, int capacity,
                                int *count);

/* The roots in [lo,hi] of all polynomials within the radii, as brackets and undecided places, at most
 * `capacity` >= 1, in order (the last one covers what there is no room for).  watch: null, or who is told.
 * OK or E_NO_MEMORY. */
algsurf_status algsurf_i_decide_ranges(const algsurf_i_coefficients *p, double lo, double hi,
                                       algsurf_bracket *brackets, int capacity, int *count,
                                       const algsurf_i_watch *watch);

/* The sign at x, finite, that all polynomials within the radii have in common, or ALGSURF_SIGN_UNKNOWN: there
 * is none.  OK or E_NO_MEMORY. */
algsurf_status algsurf_i_decide_sign(const algsurf_i_coefficients *p, double x, int *sign);

#endif
