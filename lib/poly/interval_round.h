/* interval_round.h - sums, products, quotients and square roots of doubles, rounded up or down.
 *
 * No rounding mode is switched.  The operation to nearest has an error whose sign can be computed
 * exactly (Dekker 1971; Knuth; Ogita, Rump, Oishi 2005): if the exact result lies above the rounded one, the
 * next double up is the best upper end; otherwise the rounded one is.  Rounding down is rounding up with
 * the sign changed.  All results are the best doubles there are, over the whole range.  The sign is that of
 *     a + b - s          by two_sum, which knows no underflow;
 *     x y - p            by two_prod, exact for operands below 2^995 and 2^-960 <= |p| <= 2^1000;
 *     x - q y            = (x - high) - low with high + low = q y by two_prod: the first difference is
 *                        exact (Sterbenz: high is within a factor 2 of x), so the second has the right sign;
 *     x - s^2            likewise.
 * What lies outside those ranges, zeros and infinities, goes to the *_far functions.
 *
 * The rules for ends at infinity and zero: an end at infinity stands for arbitrarily large numbers, so
 * 0 * inf = 0 and x / inf = 0; overflow of a finite result gives +inf upward, -DBL_MAX for -inf.
 * An upper end that is zero is +0.  Everything here assumes the standard environment of fpenv.h.
 */
#ifndef ALGSURF_INTERVAL_ROUND_H
#define ALGSURF_INTERVAL_ROUND_H
#include <math.h>
#include <stdint.h>
#include <string.h>

#include "../base/eft.h"

double algsurf_i_add_up_far(double a, double b);
double algsurf_i_mul_up_far(double x, double y);
double algsurf_i_div_up_far(double x, double y);
double algsurf_i_sqrt_far(double x, int side);
/* x 2^k rounded up. */
double algsurf_i_scale_up(double x, int k);

/* The next double above x if step is 1, x if it is 0; no step from +inf or -0.  The bits of a double count
 * upward with its magnitude.  Adding +0.0 turns -0 into +0. */
static inline double algsurf_i_step_up(double x, int step) {
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    bits += (uint64_t)step * (1 - 2 * (bits >> 63));
    memcpy(&x, &bits, sizeof bits);
    return x + 0.0;
}

static inline double algsurf_i_add_up(double a, double b) {
    algsurf_dd s = algsurf_two_sum(a, b);
    if (!(fabs(s.lo) < INFINITY)) return algsurf_i_add_up_far(a, b);
    return algsurf_i_step_up(s.hi, s.lo > 0);
}

static inline double algsurf_i_mul_up(double x, double y) {
    double p = fabs(x * y);
    if (!(p >= 0x1p-960 && p <= 0x1p1000 && fabs(x) < 0x1p995 && fabs(y) < 0x1p995))
        return algsurf_i_mul_up_far(x, y);
    algsurf_dd e = algsurf_two_prod(x, y);
    return algsurf_i_step_up(e.hi, e.lo > 0);
}

/* x - q y with the right sign, or 0; q is x / y rounded to nearest. */
static inline double algsurf_i_remainder(double x, double q, double y) {
    algsurf_dd p = algsurf_two_prod(q, y);
    return (x - p.hi) - p.lo;
}

/* y > 0 */
static inline double algsurf_i_div_up(double x, double y) {
    double q = x / y, size = fabs(q);
    if (!(size > 0 && size < 0x1p995 && y < 0x1p995 && fabs(x) >= 0x1p-960 && fabs(x) <= 0x1p1000))
        return algsurf_i_div_up_far(x, y);
    return algsurf_i_step_up(q, algsurf_i_remainder(x, q, y) > 0);
}

/* The square root of x >= 0, rounded up (side = 1) or down (side = -1). */
static inline double algsurf_i_sqrt(double x, int side) {
    if (!(x >= 0x1p-960 && x <= 0x1p1000)) return algsurf_i_sqrt_far(x, side);
    double s = sqrt(x), r = algsurf_i_remainder(x, s, s);
    return side * algsurf_i_step_up(side * s, side * r > 0);
}

/* Downward.  0.0 - x is -x, but +0 for both zeros. */
static inline double algsurf_i_add_down(double a, double b) { return 0.0 - algsurf_i_add_up(-a, -b); }
static inline double algsurf_i_mul_down(double x, double y) { return 0.0 - algsurf_i_mul_up(-x, y); }
static inline double algsurf_i_div_down(double x, double y) { return 0.0 - algsurf_i_div_up(-x, y); }
static inline double algsurf_i_scale_down(double x, int k) { return 0.0 - algsurf_i_scale_up(-x, k); }

#endif
