/* algsurf/isolate.h - real roots of a polynomial in an interval, isolated by Descartes' rule of signs.
 *
 * The number of sign variations of the Bernstein coefficients on [a,b] exceeds the number of roots
 * in the open interval (a,b), counted with multiplicity, by an even number >= 0; for 0 and 1 it is
 * exact.  (The same number as the variations of (1+x)^n p((a+bx)/(1+x)): no Taylor shift is needed.)
 * An interval with more variations is halved, the left half first (Lane, Riesenfeld 1981).  Doubles are tried
 * first; a sign counts only if the value exceeds its error bound.  What they leave undecided is decided by
 * integers, exactly.  The interval asked for contains its ends, and may be infinite.
 *
 * Without radii every root is decided.  There is one entry for each root, in increasing order, with its
 * multiplicity:
 * - exact, lo = hi: the root is this double;
 * - a bracket: lo < root < hi, and `sign` is p's sign just before the root.
 * A bracket wider than two neighbouring doubles isolates, and the signs of p at lo and hi are opposite.  Two
 * neighbouring doubles may hold several roots: each has an entry with this bracket.  Roots of even
 * multiplicity always have such a bracket.  Only such a bracket may end at a double that is a root, which has
 * an entry of its own.  The bracket of a root beyond the largest double reaches from this to infinity.
 *
 * Coefficients with radii stand for a set of polynomials, and answers hold for all of them.  Two entries have
 * at most an end in common.  An undecided entry is a place where the radii leave the answer open.  If the
 * zero polynomial is in the set (each |c[k]| <= r[k]) the answer is one undecided entry, the whole interval.
 */
#ifndef ALGSURF_ISOLATE_H
#define ALGSURF_ISOLATE_H
#include <stdint.h>

#include "algsurf/observe.h"
#include "algsurf/poly.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A real root. */
typedef struct algsurf_real_root {
    double root;      /* lo or hi: within one unit in the last place of the exact root; finite */
    double lo, hi;    /* encloses: lo = hi is the root exactly, or it lies between these neighbouring doubles
                         (the largest and infinity among them) */
    int multiplicity; /* >= 1 */
    int sign;         /* of p just before the root, -1 or +1 */
} algsurf_real_root;

/* The real roots in [lo,hi], lo <= hi, either may be infinite; in increasing order, each once with its
 * multiplicity, all of them: verified.  Nothing is left to refine.  (For radii, or an observer, call
 * algsurf_isolate_all, and refine its brackets.)
 *   c                 degree+1 coefficients, power basis, lowest first
 *   roots, capacity   room for the answer; the degree, at least 1, always suffices
 *   count             how many were written
 * Errors: E_ARGUMENT (null, negative degree, lo > hi), E_DEGREE (above ALGSURF_MAX_POLY_DEGREE), E_CAPACITY,
 * E_NOT_FINITE (coefficients, NaN as an end), E_ZERO (all are zero), E_NO_MEMORY: nothing is written.
 * Cost: for degrees 2 to 10 about a microsecond where doubles decide, as in algsurf_isolate_first, else 2 to
 * 20, in integers of some hundred bits; larger ones are allocated, 1 GiB at most.
 * Source: Descartes' rule of signs in exact arithmetic (Rouillier, Zimmermann 2004), multiplicities by
 * greatest common divisors (Yun 1976).  56 KiB of stack.  Since 1.0. */
ALGSURF_API algsurf_status algsurf_real_roots(const double *c, int degree, double lo, double hi,
                                              algsurf_real_root *roots, int capacity, int *count);

/* The first (smallest) root in [lo,hi], for programs that call it often.  It gives the same bits as
 * algsurf_first_roots_batch.
 *   c       degree+1 coefficients, power basis, lowest first
 *   root    approximate: the error is at most 1e-12 of the interval's length, plus a rounding of the root;
 *           ill-conditioned roots, and those in an interval with an infinite end, are those of
 *           algsurf_real_roots.  Untouched if there is none
 *   found   0: no root in [lo,hi]; 1: there is one, and none before it: verified
 * Errors: those of algsurf_real_roots, without E_CAPACITY.  Cost: some 0.3 to 0.8 microseconds for degrees 3
 * to 10 where doubles decide, else as algsurf_real_roots.  54 KiB of stack.  Since 1.0. */
ALGSURF_API algsurf_status algsurf_real_root_first(const double *c, int degree, double lo, double hi,
                                                   double *root, int *found);

/* algsurf_real_roots for integer coefficients.  (Rational and decimal ones become integers when all are
 * multiplied by a common denominator.)  Errors: as above, E_ARGUMENT also for more than ALGSURF_MAX_LIMBS
 * limbs or null ones.  Cost: for degrees 2 to 10 one or two microseconds where doubles decide, else 2 to 20,
 * 15 for degree 8 and 1000 bits; sizes that differ cost nothing by themselves, also if roots are far beyond
 * the doubles on either side (milliseconds for a cubic with one coefficient of 2^18 bits).  62 KiB of stack.
 * Since 1.0. */
ALGSURF_API algsurf_status algsurf_real_roots_integers(const algsurf_integer *c, int degree, double lo,
                                                       double hi, algsurf_real_root *roots, int capacity,
                                                       int *count);

/* What is known of a place. */
typedef enum algsurf_bracket_kind {
    ALGSURF_BRACKET_ISOLATED = 0, /* this root is in (lo,hi), others only if these are neighbours: verified */
    ALGSURF_BRACKET_EXACT = 1,    /* lo = hi is a root exactly: verified */
    /* Only with radii: from 0 to `multiplicity` roots in [lo,hi] (the zero polynomial aside).  The number
     * differs among the polynomials of the set, or is not known; `status` says why. */
    ALGSURF_BRACKET_UNDECIDED = 2
} algsurf_bracket_kind;

/* An entry: a root, or an interval where roots may be. */
typedef struct algsurf_bracket {
    double lo, hi;    /* in the unit of the caller's interval.  If an end of an isolating bracket is infinite,
                         the other is the largest double; ends of an undecided entry may be infinite, too */
    int kind;         /* an algsurf_bracket_kind */
    int sign;         /* isolated: of p just before the root, -1 or +1; exact, undecided: 0 */
    int multiplicity; /* without radii: of the root, verified.  With radii: 1 if isolated; exact or undecided:
                         an upper bound, >= 1, on the number of roots in it, counted with multiplicity */
    int status;       /* an algsurf_status: ALGSURF_OK, or why it is undecided */
} algsurf_bracket;

/* How roots are isolated. */
typedef struct algsurf_isolate_options {
    size_t size;                /* sizeof(algsurf_isolate_options) */
    algsurf_observer *observer; /* null: nobody watches */
} algsurf_isolate_options;

/* The first (smallest) root in [lo,hi], lo <= hi, either may be infinite.
 *   c, r     degree+1 coefficients, power basis, lowest first; radii or null
 *   options  null: all defaults
 *   bracket  where the root is, if *found is 1, else untouched.  None lies in [lo, bracket->lo): verified.
 *   found    0: no root in [lo,hi], verified; 1: see bracket
 * Returns OK, or bracket->status (positive) if it is undecided, which happens only with radii.
 * Errors: E_ARGUMENT (null, bad options, negative degree, lo > hi, negative radius), E_DEGREE (above
 * ALGSURF_MAX_POLY_DEGREE), E_NOT_FINITE (coefficients, radii, NaN as an end), E_ZERO (all coefficients and
 * radii are zero), E_NO_MEMORY: nothing is written.
 * Cost: below a microsecond up to degree 10 where doubles decide (up to degree 64, if roots are neither of
 * very different sizes nor too close to each other), else as algsurf_real_roots, with radii four times that;
 * O(degree^2) operations for each interval visited.  Doubles allocate nothing, integers what they need, 1 GiB
 * at most.  40 KiB of stack.  Since 1.0. */
ALGSURF_API algsurf_status algsurf_isolate_first(const double *c, const double *r, int degree, double lo,
                                                 double hi, const algsurf_isolate_options *options,
                                                 algsurf_bracket *bracket, int *found);

/* All roots in [lo,hi], in increasing order, each once; the first entry is that of algsurf_isolate_first.
 *   options              null: all defaults
 *   brackets, capacity   room for the answer; capacity >= degree, at least 1, always suffices
 *   count                how many were written
 * Returns OK: every entry is a root, and there are no others: verified.  Positive, only with radii: the
 * status of the first undecided entry; no root lies outside the entries.
 * If there are more than `degree` entries, neighbours are joined to one undecided entry.
 * Errors: as above; E_CAPACITY.  40 KiB of stack.  Since 1.0. */
ALGSURF_API algsurf_status algsurf_isolate_all(const double *c, const double *r, int degree, double lo,
                                               double hi, const algsurf_isolate_options *options,
                                               algsurf_bracket *brackets, int capacity, int *count);

/* The number of distinct roots in [lo,hi]: verified when OK, which it is without radii.  With radii the
 * status may be positive, as that of algsurf_isolate_all; roots in undecided entries are not counted then.
 * Errors: as above.  Cost: as above; on the whole line, without radii, less than that up to degree 24,
 * and up to degree 3 as little as a discriminant costs.  44 KiB of stack.  Since 1.0. */
ALGSURF_API algsurf_status algsurf_count_roots(const double *c, const double *r, int degree, double lo,
                                               double hi, int *count);

#ifdef __cplusplus
}
#endif
#endif
