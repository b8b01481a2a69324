/* algsurf/interval.h - real intervals and rectangular complex intervals, outward rounded.
 *
 * An interval [lo,hi] is the set of all reals between its ends, ends included; lo may be -inf, hi +inf,
 * lo <= hi always.  Every operation encloses: the result holds f(x,y) for all x and y of the operands.
 * Real operations are tight: each end is the exact end rounded outward, also near overflow and underflow
 * and among subnormals.  Complex operations are made of real ones; their results enclose the exact rectangle.
 * Guarantees hold in any rounding mode and with flush-to-zero set, as everywhere in this library.
 *
 * {x, x} is the number x, {-a.hi, -a.lo} is -a; {z.re, {-z.im.hi, -z.im.lo}} is the conjugate of z.
 * examples/intervals.c proves roots of a polynomial, real and complex, with these operations alone.
 *
 * Operations return their result unless they can fail; those return a status and leave the output
 * untouched on failure.  Operands that are not intervals (lo > hi, NaN, lo = +inf, hi = -inf) are the
 * caller's error: the status is E_ARGUMENT; without a status the result is unspecified, maybe no interval.
 * Check values that come from outside by algsurf_interval_make.
 * An infinite end stands for arbitrarily large numbers: 0 times it is 0, and a finite number divided by it is
 * 0.  An end that is zero comes out as +0.
 * Cost: 5 to 20 ns for a real operation, 0.1 us for a complex product, modulus or argument, 0.4 us for a
 * complex quotient.  Source: Dekker 1971, error-free transforms, instead of switched rounding modes.
 */
#ifndef ALGSURF_INTERVAL_H
#define ALGSURF_INTERVAL_H
#include "algsurf/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A complex number. */
typedef struct algsurf_complex {
    double re, im; /* real and imaginary part */
} algsurf_complex;

/* [lo,hi]: all real numbers from lo to hi, both included. */
typedef struct algsurf_interval {
    double lo, hi; /* lo <= hi; lo may be -inf, hi +inf */
} algsurf_interval;

/* The rectangle re x im of the complex plane. */
typedef struct algsurf_cinterval {
    algsurf_interval re, im; /* of the real parts, of the imaginary parts */
} algsurf_cinterval;

/* ---- real ---- */

/* [lo,hi], checked.  Errors: E_ARGUMENT (null, NaN, lo > hi, an end infinite on the wrong side).
 * Since 1.0, as all that follows. */
ALGSURF_API algsurf_status algsurf_interval_make(double lo, double hi, algsurf_interval *result);
/* { x + y : x in a, y in b } */
ALGSURF_API algsurf_interval algsurf_interval_add(algsurf_interval a, algsurf_interval b);
/* { x - y : x in a, y in b } */
ALGSURF_API algsurf_interval algsurf_interval_sub(algsurf_interval a, algsurf_interval b);
/* { x y : x in a, y in b } */
ALGSURF_API algsurf_interval algsurf_interval_mul(algsurf_interval a, algsurf_interval b);
/* { x / y : x in a, y in b }.  Errors: E_ARGUMENT (null), E_RANGE (b contains 0). */
ALGSURF_API algsurf_status algsurf_interval_div(algsurf_interval a, algsurf_interval b,
                                                algsurf_interval *result);
/* { x^n : x in a }, tighter than a product if a contains 0: an even power is never negative.  By repeated
 * squaring of the ends' magnitudes, each step rounded outward (encloses; tight for -1 <= n <= 2); 0^0 = 1.
 * Errors: E_ARGUMENT (null), E_RANGE (n < 0 and a contains 0). */
ALGSURF_API algsurf_status algsurf_interval_pow(algsurf_interval a, int n, algsurf_interval *result);
/* { sqrt(x) : x in a }.  Errors: E_ARGUMENT (null), E_RANGE (a.lo < 0). */
ALGSURF_API algsurf_status algsurf_interval_sqrt(algsurf_interval a, algsurf_interval *result);
/* { |x| : x in a }; its upper end is the largest magnitude in a. */
ALGSURF_API algsurf_interval algsurf_interval_abs(algsurf_interval a);
/* The least interval that holds both. */
ALGSURF_API algsurf_interval algsurf_interval_hull(algsurf_interval a, algsurf_interval b);
/* What both have in common: two enclosures of one number make a narrower one.  Errors: E_ARGUMENT (null),
 * E_RANGE (they have nothing in common). */
ALGSURF_API algsurf_status algsurf_interval_intersect(algsurf_interval a, algsurf_interval b,
                                                      algsurf_interval *result);
/* hi - lo rounded up; +inf if an end is infinite. */
ALGSURF_API double algsurf_interval_width(algsurf_interval a);
/* A finite double inside, nearest to the middle (0 for the whole line; for a half line the finite double
 * farthest along it). */
ALGSURF_API double algsurf_interval_mid(algsurf_interval a);
/* 1 if x lies in a (no infinity does, an interval being a set of reals), else 0. */
ALGSURF_API int algsurf_interval_contains(algsurf_interval a, double x);
/* 1 if a is a subset of the interior of b (an end at infinity is no boundary), else 0.  The test that
 * ends a verification: if a is bounded and encloses the values over b of a continuous function, that function
 * has a fixed point in a (Brouwer). */
ALGSURF_API int algsurf_interval_interior(algsurf_interval a, algsurf_interval b);
/* sum c_k x^k, degree+1 coefficients, lowest first.  Encloses the values of every polynomial with
 * coefficients in c.  It is what two enclosures have in common: that of Horner's scheme, and the centred form
 * p(m) + q(x) (x - m), m the middle of x, q the quotient of p - p(m) by x - m, whose excess over the exact
 * range is of second order in the width of x.  Where that is too wide, split x.
 * Errors: E_ARGUMENT (null, negative degree, an operand that is no interval), E_DEGREE (above
 * ALGSURF_MAX_POLY_DEGREE).
 * Cost: about 55 ns times degree, half of that if x is one number.  Source: Krawczyk, Neumaier 1985. */
ALGSURF_API algsurf_status algsurf_interval_poly(const algsurf_interval *c, int degree, algsurf_interval x,
                                                 algsurf_interval *result);

/* ---- complex ---- */

/* { z + w : z in a, w in b } */
ALGSURF_API algsurf_cinterval algsurf_cinterval_add(algsurf_cinterval a, algsurf_cinterval b);
/* { z - w : z in a, w in b } */
ALGSURF_API algsurf_cinterval algsurf_cinterval_sub(algsurf_cinterval a, algsurf_cinterval b);
/* Encloses { z w : z in a, w in b }. */
ALGSURF_API algsurf_cinterval algsurf_cinterval_mul(algsurf_cinterval a, algsurf_cinterval b);
/* Encloses { z / w : z in a, w in b }: a times the hull of 1/b.  For points of any size, a few units in the
 * last place of the modulus.
 * Errors: E_ARGUMENT (null), E_RANGE (b contains 0).  Source: Rokne, Lancaster 1971. */
ALGSURF_API algsurf_status algsurf_cinterval_div(algsurf_cinterval a, algsurf_cinterval b,
                                                 algsurf_cinterval *result);
/* { |z| : z in a }, ends within a few units in the last place. */
ALGSURF_API algsurf_interval algsurf_cinterval_abs(algsurf_cinterval a);
/* { arg z : z in a }, a without 0, as an interval [lo,hi], -pi <= lo <= pi, lo <= hi <= lo + 2 pi.  Arguments
 * are in (-pi,pi]; a rectangle that crosses the negative real axis, or touches it from below, gets hi > pi:
 * 2 pi is added to the arguments below the axis, so that there is no jump.  A rectangle on the real axis
 * gives exactly [0,0] or [pi_lo,pi_hi], the two doubles around pi.  pi in these bounds means the double on
 * its outer side.  Ends are the best double or the next one.  Errors: E_ARGUMENT (null), E_RANGE (a contains
 * 0). */
ALGSURF_API algsurf_status algsurf_cinterval_arg(algsurf_cinterval a, algsurf_interval *result);
/* The least rectangle that holds both. */
ALGSURF_API algsurf_cinterval algsurf_cinterval_hull(algsurf_cinterval a, algsurf_cinterval b);
/* What both have in common.  Errors: E_ARGUMENT (null), E_RANGE (they have nothing in common). */
ALGSURF_API algsurf_status algsurf_cinterval_intersect(algsurf_cinterval a, algsurf_cinterval b,
                                                       algsurf_cinterval *result);
/* The larger of both widths. */
ALGSURF_API double algsurf_cinterval_width(algsurf_cinterval a);
/* The middles of both intervals. */
ALGSURF_API algsurf_complex algsurf_cinterval_mid(algsurf_cinterval a);
/* 1 if z lies in a, else 0. */
ALGSURF_API int algsurf_cinterval_contains(algsurf_cinterval a, algsurf_complex z);
/* 1 if a is a subset of the interior of b, else 0: what it proves is said above. */
ALGSURF_API int algsurf_cinterval_interior(algsurf_cinterval a, algsurf_cinterval b);
/* sum c_k z^k over the rectangle z, as above.  Errors: E_ARGUMENT, as above.  Cost: about 230 ns times
 * degree, a third of that if z is one number. */
ALGSURF_API algsurf_status algsurf_cinterval_poly(const algsurf_cinterval *c, int degree, algsurf_cinterval z,
                                                  algsurf_cinterval *result);

#ifdef __cplusplus
}
#endif
#endif
