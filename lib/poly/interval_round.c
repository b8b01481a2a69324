/* interval_round.c - directed rounding at the ends of the range, where error terms overflow or underflow.
 *
 * The operands are brought near 1 by powers of two, which is exact; there the exact result is known as an
 * unevaluated sum, and scale_sum brings it back with one rounding whose error is again compared exactly.
 */
#include "../base/arithmetic.h"
#include "interval_round.h"

/* (m.hi + m.lo) 2^k rounded up, 1/4 <= |m.hi| <= 2, |m.lo| <= ulp(m.hi) / 2.  With r the nearest double:
 * r 2^-k is a double, or infinite; d = m.hi - r 2^-k is exact, since r 2^-k is 0 or within a factor 2 of
 * m.hi; and d is 0 or at least ulp(m.hi), so d + m.lo has the sign of the error.  Overflow: d is infinite,
 * -inf for r = +inf, which stays, and +inf for r = -inf, which is stepped up to -DBL_MAX. */
static double scale_sum(algsurf_dd m, int k) {
    double r = ldexp(m.hi, k), d = m.hi - ldexp(r, -k);
    return algsurf_i_step_up(r, d + m.lo > 0);
}

/* Here an operand is infinite, the sum overflows, or two_sum does inside, for a = +-DBL_MAX only, and then
 * not with the operands exchanged (Boldo, Graillat, Muller 2017). */
double algsurf_i_add_up_far(double a, double b) {
    double s = a + b;
    if (isinf(a) || isinf(b)) return s;
    if (isinf(s)) return algsurf_i_step_up(s, s < 0);
    return algsurf_i_step_up(s, algsurf_two_sum(b, a).lo > 0);
}

double algsurf_i_mul_up_far(double x, double y) {
    if (x == 0 || y == 0) return 0.0;
    if (isinf(x) || isinf(y)) return x * y;
    int i, j;
    double mx = frexp(x, &i), my = frexp(y, &j);
    return scale_sum(algsurf_two_prod(mx, my), i + j);
}

double algsurf_i_div_up_far(double x, double y) {
    if (x == 0 || isinf(y)) return 0.0;
    if (isinf(x)) return x / y;
    int i, j;
    double mx = frexp(x, &i), my = frexp(y, &j), q = mx / my;
    return scale_sum((algsurf_dd){q, algsurf_i_remainder(mx, q, my) / my}, i - j);
}

/* A root lies well inside the range, so that the way back is exact. */
double algsurf_i_sqrt_far(double x, int side) {
    if (!(x > 0 && x < INFINITY)) return x + 0.0;
    return x < 1 ? 0x1p-256 * algsurf_i_sqrt(0x1p512 * x, side)
                 : 0x1p256 * algsurf_i_sqrt(0x1p-512 * x, side);
}

double algsurf_i_scale_up(double x, int k) {
    if (x == 0 || isinf(x)) return x + 0.0;
    int i;
    double m = frexp(x, &i);
    return scale_sum((algsurf_dd){m, 0.0}, i + k);
}
