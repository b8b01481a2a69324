/* algsurf/isolate.h - real roots of a polynomial in an interval, isolated by Descartes' rule of signs.
 *
 * The number of sign variations of the Bernstein coefficients on [a,b] exceeds the number of roots
 * in the open interval (a,b), counted with multiplicity, by an even number >= 0; for 0 and 1 it is
 * exact.  (The same number as the variations of (1+x)^n p((a+bx)/(1+x)): no Taylor shift is needed.)
 * An interval with more variations is halved, the left half first (Lane, Riesenfeld 1981).  Signs
 * are used only where they exceed the error bound; where double precision cannot tell, the work is
 * done again in double-double.  Ends belong to the interval, each root counts once.
 *
 * The interval may be infinite: the line is cut at +-h and the far parts are treated as 1/t in a
 * bounded interval, so that a vanishing leading coefficient (a root at infinity) is no special case.
 *
 * Every root is in an entry.  A bracket needs two doubles at which the signs show; where there are none the
 * entry is undecided: for a root beyond the largest double (one end is then infinite), between two adjacent
 * doubles of which one is itself a root, or between two adjacent doubles together with another root.
 * Coefficients with radii stand for a set of polynomials, and answers hold for all of them; if the zero
 * polynomial is one of them (each |c[k]| <= r[k]) the answer is one undecided entry, the whole interval.
 */
#ifndef ALGSURF_ISOLATE_H
#define ALGSURF_ISOLATE_H
#include "algsurf/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A real root. */
typedef struct algsurf_real_root {
    double value;     /* lo or hi: within one unit in the last place of the root; finite */
    double lo, hi;    /* encloses: lo = hi is the root exactly, or it lies between these neighbouring doubles
                         (the largest and infinity among them) */
    int multiplicity; /* >= 1 */
    int sign;         /* of p just before the root, -1 or +1 */
} algsurf_real_root;

/* The real roots in [lo,hi], lo <= hi, either may be infinite; in increasing order, each once with its
 * multiplicity, all of them: verified.
 *   c                 degree+1 coefficients, power basis, lowest first
 *   roots, capacity   room for the answer; the degree, at least 1, always suffices
 *   count             how many were written
 * Errors: E_ARGUMENT (null, degree outside 0..ALGSURF_MAX_POLY_DEGREE, lo > hi, NaN, capacity too small: nothing is
 * written), E_NOT_FINITE (coefficients), E_ZERO (all are zero), E_NO_MEMORY.
 * Cost: 2 to 20 microseconds for degrees 2 to 10, in integers of some hundred bits; 20 KiB of stack, more is
 * allocated, 1 GiB at most.  Source: Descartes' rule of signs in exact arithmetic (Rouillier, Zimmermann 2004),
 * multiplicities by greatest common divisors (Yun 1976).  Since 1.0. */
ALGSURF_API algsurf_status algsurf_real_roots(const double *c, int degree, double lo, double hi,
                                              algsurf_real_root *roots, int capacity, int *count);

/* What is known of a place. */
typedef enum algsurf_root_kind {
    ALGSURF_ROOT_BRACKET = 0,  /* lo < root < hi: isolates; the signs at lo and hi differ: verified */
    ALGSURF_ROOT_EXACT = 1,    /* lo = hi is a root exactly: verified */
    ALGSURF_ROOT_UNDECIDED = 2 /* 0 .. most roots in [lo,hi]; status says why it stays open */
} algsurf_root_kind;

/* A place where a root is, or where roots may be. */
typedef struct algsurf_bracket {
    double lo, hi;         /* in the unit of the caller's interval; may be infinite when undecided */
    int kind;              /* an algsurf_root_kind */
    int sign;              /* of p at lo, -1 or +1, for a bracket; 0 otherwise */
    int multiplicity;      /* of the root; undecided, and for coefficients with radii: the roots in it, counted
                              with multiplicity, are at most this, >= 1 */
    algsurf_status status; /* ALGSURF_OK, or why it is undecided */
} algsurf_bracket;

/* The first (smallest) root in [lo,hi], lo <= hi, either may be infinite.
 *   c, r     degree+1 coefficients, power basis, lowest first; radii or null
 *   bracket  where the root is, when *found is 1.  No root lies in [lo, bracket->lo): verified.
 *   found    0: no root in [lo,hi], verified; 1: see bracket
 * Returns OK, or bracket->status (positive) when the bracket is undecided.
 * Errors: E_ARGUMENT (null, degree outside 0..ALGSURF_MAX_POLY_DEGREE, lo > hi, NaN, negative radius),
 * E_NOT_FINITE (coefficients, radii), E_ZERO (all coefficients and radii are zero).
 * Cost: O(degree^2) for each interval visited, their number bounded by a small multiple of
 * degree * 50; no allocation; about 100 KiB of stack.  Since 1.0. */
ALGSURF_API algsurf_status algsurf_isolate_first(const double *c, const double *r, int degree, double lo,
                                                 double hi, algsurf_bracket *bracket, int *found);

/* algsurf_isolate_first, and what it cost: `intervals` receives the number of intervals whose variations of
 * sign were counted, those of a second walk in double-double included; 0 where none is needed (lo = hi).
 * Errors: as above, and E_ARGUMENT for a null pointer to it.  Since 1.0. */
ALGSURF_API algsurf_status algsurf_isolate_first_counted(const double *c, const double *r, int degree,
                                                         double lo, double hi, algsurf_bracket *bracket,
                                                         int *found, int *intervals);

/* All roots in [lo,hi], in increasing order, as brackets that share ends at most (an undecided one may end
 * on an exact root, which then is among the `most` of both).
 *   brackets, capacity   room for the answer; capacity >= degree, at least 1, always suffices
 *   count                how many were written
 * Returns OK: every entry is a bracket or an exact root, and there are no others: verified.  A
 * positive status: at least one entry is undecided (the first one's reason); no root lies outside
 * the entries.  Errors: as above; E_ARGUMENT when capacity is too small.  Since 1.0. */
ALGSURF_API algsurf_status algsurf_isolate_all(const double *c, const double *r, int degree, double lo,
                                               double hi, algsurf_bracket *brackets, int capacity,
                                               int *count);

/* The number of distinct roots in [lo,hi]: verified when OK; otherwise undecided places count as
 * none.  Errors, cost: as above.  Since 1.0. */
ALGSURF_API algsurf_status algsurf_count_roots(const double *c, const double *r, int degree, double lo,
                                               double hi, int *count);

#ifdef __cplusplus
}
#endif
#endif
