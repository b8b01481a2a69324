/* algsurf/batch.h - the roots of many polynomials of one degree, side by side: the first real ones, all real
 * ones, all complex ones.
 *
 * What isolate.h, refine.h and allroots.h do for one polynomial, the SIMD code of this processor does here
 * for several at once.  A polynomial that it leaves undecided is decided alone.  One that the single call
 * refuses is refused alone: its state or count says so, and all others are answered. */
#ifndef ALGSURF_BATCH_H
#define ALGSURF_BATCH_H
#include <stddef.h>

#include "algsurf/allroots.h"
#include "algsurf/isolate.h"
#include "algsurf/poly.h"
#include "algsurf/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/* How the roots of many polynomials are found. */
typedef struct algsurf_batch_options {
    size_t size;        /* sizeof(algsurf_batch_options) */
    const char *kernel; /* the SIMD code, by a name that algsurf_kernel_name (intersect.h) gives; null: the
                           fastest that runs here.  All of them give the same bits. */
    double relative_tolerance; /* for algsurf_first_roots_batch: wanted error of a root, relative to the
                                  length of its interval, 0 <= relative_tolerance < 1; 0: 1e-12 or better.
                                  The other calls require 0 */
} algsurf_batch_options;

/* ---- real roots ---- */

/* Polynomials of one degree, each with an interval [lo, hi], both ends included; either may be infinite. */
typedef struct algsurf_real_batch {
    size_t size;                /* sizeof(algsurf_real_batch) */
    size_t count;               /* of polynomials; pointers may be null when it is 0 */
    int degree;                 /* a bound, 0..ALGSURF_MAX_POLY_DEGREE: leading zeros are allowed */
    algsurf_table coefficients; /* in the power basis */
    algsurf_table radii;        /* of the coefficients; if `at` is null, these are exact */
    const double *lo, *hi;      /* polynomial i: lo[i * interval_step] <= hi[i * interval_step]; lo null: -inf
                                   for all; hi null: +inf for all */
    ptrdiff_t interval_step;    /* in doubles; 0: one interval for all */
} algsurf_real_batch;

/* What is known of the first root. */
typedef enum algsurf_first_root_state {
    ALGSURF_FIRST_ROOT_NONE = 0,  /* no root in the interval: verified; root is +inf */
    ALGSURF_FIRST_ROOT_FOUND = 1, /* there is one: verified */
    /* The answer differs among the polynomials within the radii; or memory ran out.  No root lies before the
     * undecided place, and root is a point of that place (+inf if memory ran out). */
    ALGSURF_FIRST_ROOT_UNDECIDED = 2,
    ALGSURF_FIRST_ROOT_REFUSED = 4 /* a bad polynomial or interval; root is +inf */
} algsurf_first_root_state;

/* The first (smallest) root of each polynomial in its interval.
 *   options  null: all defaults
 *   state    an algsurf_first_root_state for each polynomial
 *   root     the root of each polynomial; null: not asked for
 * state and root may not overlap the input.
 * Guarantee: NONE and FOUND are verified, and are the answers of algsurf_isolate_first.  (With radii, one may
 * be verified although the single call is undecided.)  Without radii, every good polynomial is decided.
 * Multiple roots are found like others.  A root lies in a bracket that isolates the first one;
 * its place there is approximate: it is off by at most 1e-12 of the interval's length, by default, and by the
 * rounding of the root.  Ill-conditioned roots, and those in an interval with an infinite end, are the roots
 * of algsurf_real_roots.  The bits of an answer depend on its polynomial only, not on the kernel, the other
 * polynomials or their number.
 * Errors: E_ARGUMENT (null, degree < 0, tolerance, unknown kernel), E_DEGREE: nothing is written.
 * Those of algsurf_real_root_first for a polynomial (with radii, of algsurf_isolate_first): it is REFUSED,
 * or, for want of memory, UNDECIDED.  All others are answered, and the first such error is returned.
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
 *            algsurf_status
 * roots and count may not overlap the input.
 * Guarantee: all are found, each with its multiplicity: verified.
 * Errors: E_ARGUMENT (null, degree < 0, unknown kernel, radii, a tolerance), E_DEGREE: nothing is written.
 * Those in count: all other polynomials are answered, and the first of them is returned.
 * Cost: O(degree^2) for each root, 40 to 200 nanoseconds a polynomial of degrees 2 to 10 in batches of 100 or
 * more.  A polynomial that doubles leave undecided costs as much as in algsurf_real_roots; so does each of
 * degree above 20 or with an infinite interval.
 * Source: as above; signs beside the roots by the compensated Horner scheme (Graillat, Langlois, Louvet
 * 2005).  54 KiB of stack.  Since 1.0. */
ALGSURF_API algsurf_status algsurf_real_roots_batch(const algsurf_real_batch *batch,
                                                    const algsurf_batch_options *options,
                                                    algsurf_real_root *roots, int *count);

/* ---- complex roots ---- */

/* Polynomials of one degree with complex or real coefficients. */
typedef struct algsurf_complex_batch {
    size_t size;         /* sizeof(algsurf_complex_batch) */
    size_t count;        /* of polynomials; pointers may be null when it is 0 */
    int degree;          /* a bound, 0..ALGSURF_MAX_POLY_DEGREE: leading zeros are allowed */
    algsurf_table re;    /* real parts of the coefficients */
    algsurf_table im;    /* imaginary parts; if `at` is null, the coefficients are real */
    algsurf_table radii; /* of the coefficients; if `at` is null, these are exact */
} algsurf_complex_batch;

/* All roots of each polynomial of a batch: bit for bit what algsurf_complex_roots_of_real returns for it (no
 * imaginary parts), or algsurf_complex_roots.
 *   options  null: all defaults
 *   roots    count times degree entries; those of polynomial i start at roots[i * degree]
 *   count    for each polynomial the number of its entries; or, if the single call fails, its error, a
 *            negative algsurf_status: its entries mean nothing then
 * roots and count may not overlap the input.
 * Errors: E_ARGUMENT (null, degree < 0, unknown kernel, a tolerance), E_DEGREE: nothing is written.
 * Those in count: all other polynomials are answered, and the first of them is returned.
 * Guarantee: verified, as algsurf_complex_roots.
 * Cost: polynomials without radii of degree 24 at most are solved side by side, as many as the kernel has
 * lanes.  Those that this does not prove, and all others, are solved one by one.
 * Source: as algsurf_complex_roots; degree 2 with real coefficients in closed form, in doubled precision.
 * 64 KiB of stack.  Since 1.0. */
ALGSURF_API algsurf_status algsurf_complex_roots_batch(const algsurf_complex_batch *batch,
                                                       const algsurf_batch_options *options,
                                                       algsurf_complex_root *roots, int *count);

#ifdef __cplusplus
}
#endif
#endif
