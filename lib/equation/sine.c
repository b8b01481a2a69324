/* sine.c - sine and cosine of constants, and pi, to double-double; see poly.h.
 *
 * x = k pi/2 + r with k the nearest whole number to x / (pi/2), so |r| < 0.7855 and |k| <= 64; then Taylor's
 * series of sine or cosine at r, which alternates and decreases: what is left out is less than its first
 * term.
 *
 * The error is absolute.  A double-double operation is right to 2^-102 of its result.  Reduction: the product
 * k pi/2 <= 101.6 is off by 2^-95.3, pi/2 itself, that many times, by 64 2^-109, the difference by 2^-102.
 * The series: its term number n is off by 3n operations, the sums by one each; since the terms' magnitudes
 * add up to cosh(0.7855) < 1.33, and those beyond the tenth to less than 2^-60, all of it is less than (30 +
 * 20) 2^-102 1.33, 2^-95.9, and what is left out less than 2^-110.  The sum of all is below 2^-94; without a
 * reduction, k = 0, it is that part of the value, since the value is at least 0.9 of the first term.  What m
 * is off by changes the sine by no more.
 */
#include "../base/arithmetic.h"
#include "poly.h"

#include <math.h>

static const algsurf_dd half_pi = {0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54}; /* off by less than 2^-109 */
static const double sine_error = 0x1p-94;
static const double left_out = 0x1p-110;

monomial algsurf_i_monomial_pi(void) {
    algsurf_dd pi = algsurf_dd_scale(half_pi, 2);
    return algsurf_i_monomial_make(pi, ALGSURF_DD_U * pi.hi, 0, 0);
}

/* sum of (-1)^n r^(2n+odd) / (2n+odd)!: the cosine, or the sine for odd = 1. */
static algsurf_dd series(algsurf_dd r, int odd) {
    algsurf_dd term = odd ? r : algsurf_dd_from(1), sum = term;
    algsurf_dd square = algsurf_dd_neg(algsurf_dd_mul(r, r));
    for (int n = odd + 1; fabs(term.hi) > left_out; n += 2) {
        term = algsurf_dd_div(algsurf_dd_mul(term, square), algsurf_dd_from((double)(n * (n + 1))));
        sum = algsurf_dd_add(sum, term);
    }
    return sum;
}

/* Of |x| < 2^-128: x, or 1, up to x^2. */
static monomial small(const monomial *m, int quarters) {
    monomial sine = *m;
    sine.err += left_out * fabs(m->v.hi);
    monomial one = algsurf_i_monomial_make(algsurf_dd_from(1), m->v.hi != 0 ? left_out : 0, 0, 0);
    if (quarters >= 2) sine.v = algsurf_dd_neg(sine.v), one.v = algsurf_dd_neg(one.v);
    return quarters % 2 == 0 ? sine : one;
}

monomial algsurf_i_monomial_sine(const monomial *m, int quarters) {
    if (m->v.hi == 0 || m->e < 0) return small(m, quarters);
    double k = rint(m->v.hi / half_pi.hi);
    algsurf_dd r = algsurf_dd_sub(m->v, algsurf_dd_mul_d(half_pi, k));
    int turn = ((int)k + quarters) & 3;
    algsurf_dd sine = series(r, turn % 2 == 0);
    if (turn >= 2) sine = algsurf_dd_neg(sine);
    double err = m->err + sine_error * (k == 0 ? fabs(sine.hi) : 1); /* r is exact then */
    return algsurf_i_monomial_make(sine, err, 0, 0);
}
