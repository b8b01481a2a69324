/* algsurf/batch.h - the first roots, or all roots, of many real polynomials of one degree, side by side.
 *
 * What isolate.h and refine.h do for one polynomial, the SIMD code of this processor does here for
 * several at once.  A polynomial that it leaves undecided is decided alone. */
#ifndef ALGSURF_BATCH_H
#define ALGSURF_BATCH_H
#include <stddef.h>

#include "algsurf/isolate.h"
#include "algsurf/poly.h"
#include "algsurf/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Polynomials of one degree, each with an interval [lo, hi], both ends included; either may be infinite. */
typedef struct algsurf_real_batch {
    size_t size;                /* sizeof(algsurf_real_batch) */
    size_t count;               /* of polynomials; pointers may be null when it is 0 */
    int degree;                 /* a bound, 0..ALGSURF_MAX_POLY_DEGREE: leading zeros are allowed */
    algsurf_table coefficients; /* in the power basis */
    algsurf_table radii;        /* of the coefficients; at null: they are exact */
    const double *lo, *hi;      /* polynomial i: lo[i * interval_step] < hi[i * interval_step] */
    ptrdiff_t interval_step;    /* 0: one interval for all; 1: one for each */
} algsurf_real_batch;

/* What is known of the first root. */
typedef enum algsurf_first_root_state {
    ALGSURF_FIRST_ROOT_NONE = 0,  /* no root in the interval: verified; root is +inf */
    ALGSURF_FIRST_ROOT_FOUND = 1, /* there is one: verified */
    /* The answer differs among the polynomials within the radii; or all coefficients may be 0; or memory ran
     * out.  No root lies before the undecided place, and root is a point of that place (+inf if memory ran
     * out). */
    ALGSURF_FIRST_ROOT_UNDECIDED = 2
} algsurf_first_root_state;

/* The first (smallest) root of each polynomial in its interval.
 *   options  null: all defaults
 *   state    an algsurf_first_root_state for each polynomial
 *   root     the root of each polynomial; null: not asked for
 * state and root may not overlap the input.
 * Guarantee: a state other than UNDECIDED is verified, and is that of algsurf_isolate_first.  (With radii, it
 * may be verified although the single call is undecided.)  Without radii, only the zero polynomial is
 * UNDECIDED.  Multiple roots are found like others.  A root lies in a bracket that isolates the first one;
 * its place there is approximate: it is off by at most 1e-12 of the interval's length, by default, and by the
 * rounding of the root.  Ill-conditioned roots, and those in an interval with an infinite end, are the roots
 * of algsurf_real_roots.  The bits of an answer depend on its polynomial only, not on the kernel, the other
 * polynomials or their number.
 * Errors: E_ARGUMENT (null, degree outside 0..ALGSURF_MAX_POLY_DEGREE, lo >= hi, NaN as an end, negative
 * radius, relative_tolerance or kernel), E_NOT_FINITE (coefficients, radii): that of the first bad
 * polynomial, and nothing is written.  E_NO_MEMORY: at least one polynomial is UNDECIDED for want of memory;
 * the other answers are valid.
 * Cost: O(degree^2) for each, 3 to 100 nanoseconds for degrees 2 to 10 and batches of 100 or more.  A
 * polynomial that is decided alone takes 1 to 20 microseconds; so does each of degree above 20 or with an
 * infinite interval.  Integers allocate what they need, 1 GiB at most, and give it back.
 * Source: Taylor shift, Descartes' rule (Lane, Riesenfeld 1981), bracketed Halley iteration.  54 KiB of
 * stack.  Since 1.0. */
ALGSURF_API algsurf_status algsurf_first_roots_batch(const algsurf_real_batch *batch,
                                                     const algsurf_batch_options *options,
                                                     unsigned char *state, double *root);

/* All real roots of each polynomial in its interval, as algsurf_real_roots gives them, bit for bit.
 *   batch    without radii
 *   options  null: all defaults
 *   roots    room for m = max(degree, 1) of each polynomial: those of polynomial i start at roots[i * m], in
 *            increasing order; the rest of the room may be overwritten
 *   count    the number of roots of each polynomial; or, if the single call fails, its error, a negative
 *            algsurf_status: E_ZERO, E_NO_MEMORY
 * roots and count may not overlap the input.  Returns the first error in count, or OK; the answers for all
 * other polynomials are valid.
 * Guarantee: all are found, each with its multiplicity: verified.
 * Errors: as above, E_ARGUMENT also for radii or a relative_tolerance: nothing is written then; and those in
 * count.
 * Cost: O(degree^2) for each root, 40 to 200 nanoseconds a polynomial of degrees 2 to 10 in batches of 100 or
 * more.  A polynomial that doubles leave undecided costs as much as in algsurf_real_roots; so does each of
 * degree above 20 or with an infinite interval.
 * Source: as above; signs beside the roots by the compensated Horner scheme (Graillat, Langlois, Louvet
 * 2005).  54 KiB of stack.  Since 1.0. */
ALGSURF_API algsurf_status algsurf_real_roots_batch(const algsurf_real_batch *batch,
                                                    const algsurf_batch_options *options,
                                                    algsurf_real_root *roots, int *count);

#ifdef __cplusplus
}
#endif
#endif
