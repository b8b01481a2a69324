/* elementary.c - logarithm, power, sine and cosine from their series.
 *
 * Each argument is reduced to where the Taylor series is short; its first terms are summed as
 * double-doubles, the others, which are small, as doubles.  What these lose, relative to the result:
 *   log2    2^-57: with s = (m-1)/(m+1), m next to 1, ln m = 2s + 2s^3 (1/3 + s^2/5 + ...), s^2 < 0.0295
 *   exp2    2^-57: with |r| < 0.347, e^r = 1 + r + r^2/2 + r^3 (1/6 + ...)
 *   circle  2^-54: with |r| < 0.786, sin r = r - r^3 (1/6 - ...), cos r = 1 - r^2/2 + r^4 (1/24 - ...)
 * What is truncated is less.  A power is exp2 of y log2 x: what the logarithm lost is multiplied by that.
 */
#include "arithmetic.h"
#include "elementary.h"

#include <math.h>

#include "eft.h"

static const algsurf_dd log2_of_e = {0x1.71547652b82fep+0, 0x1.777d0ffda0d24p-56};
static const algsurf_dd ln_of_2 = {0x1.62e42fefa39efp-1, 0x1.abc9e3b39803fp-56};
static const algsurf_dd half_pi = {0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54};

/* c[0] + c[1] x + ... + c[n] x^n; even and odd powers side by side. */
static double series(const double *c, int n, double x) {
    double sum[2] = {0, 0}, square = x * x;
    for (; n >= 0; n--) sum[n % 2] = sum[n % 2] * square + c[n];
    return sum[0] + x * sum[1];
}

static algsurf_dd log2_of(double x) {
    static const double c[] = {1.0 / 3,  1.0 / 5,  1.0 / 7,  1.0 / 9,  1.0 / 11, 1.0 / 13,
                               1.0 / 15, 1.0 / 17, 1.0 / 19, 1.0 / 21, 1.0 / 23, 1.0 / 25};
    int k;
    double m = frexp(x, &k);
    if (m < 0.70710678118654752) {
        m *= 2;
        k--;
    }
    algsurf_dd above = algsurf_two_sum(m, 1);
    double s = (m - 1) / above.hi;
    algsurf_dd product = algsurf_two_prod(s, above.hi);
    double low = ((m - 1 - product.hi) - product.lo - s * above.lo) / above.hi;
    algsurf_dd half_ln = algsurf_fast_two_sum(s, low + s * (s * s) * series(c, 11, s * s));
    return algsurf_dd_add_d(algsurf_dd_mul(algsurf_dd_scale(half_ln, 2), log2_of_e), k);
}

static double exp2_of(algsurf_dd x) {
    static const double c[] = {
        1.0 / 6,           1.0 / 24,           1.0 / 120,           1.0 / 720,      1.0 / 5040,
        1.0 / 40320,       1.0 / 362880,       1.0 / 3628800,       1.0 / 39916800, 1.0 / 479001600,
        1.0 / 6227020800., 1.0 / 87178291200., 1.0 / 1307674368000.};
    if (!(fabs(x.hi) < 1100)) return x.hi > 0 ? HUGE_VAL : x.hi < 0 ? 0 : x.hi;
    double whole = rint(x.hi);
    algsurf_dd r = algsurf_dd_mul(algsurf_fast_two_sum(x.hi - whole, x.lo), ln_of_2);
    algsurf_dd sum = algsurf_dd_add(r, algsurf_dd_scale(algsurf_dd_mul(r, r), 0.5));
    double tail = r.hi * r.hi * r.hi * series(c, 12, r.hi);
    algsurf_dd result = algsurf_fast_two_sum(1, sum.hi);
    return ldexp(result.hi + (result.lo + (sum.lo + tail)), (int)whole);
}

double algsurf_i_log2(double x) { return log2_of(x).hi; }

double algsurf_i_exp2(double x) { return exp2_of(algsurf_dd_from(x)); }

double algsurf_i_pow(double x, double y) {
    if (!(x < HUGE_VAL) && y > 0) return x;
    if (x == 1 || y == 0) return 1;
    if (!(x > 0)) return x;
    algsurf_dd log = log2_of(x);
    double rough = log.hi * y; /* out of range, it may overflow, and so would the product below */
    return exp2_of(fabs(rough) < 1100 ? algsurf_dd_mul_d(log, y) : algsurf_dd_from(rough));
}

void algsurf_i_circle(double angle, double point[2]) {
    static const double sine[] = {
        -1.0 / 6,         1.0 / 120,         -1.0 / 5040,           1.0 / 362880,
        -1.0 / 39916800., 1.0 / 6227020800., -1.0 / 1307674368000., 1.0 / 355687428096000.};
    static const double cosine[] = {
        1.0 / 24,        -1.0 / 720,          1.0 / 40320,           -1.0 / 3628800,
        1.0 / 479001600, -1.0 / 87178291200., 1.0 / 20922789888000., -1.0 / 6402373705728000.};
    double quarters = rint(angle / half_pi.hi);
    algsurf_dd r = algsurf_dd_sub(algsurf_dd_from(angle), algsurf_dd_mul_d(half_pi, quarters));
    algsurf_dd half_square = algsurf_dd_scale(algsurf_dd_mul(r, r), 0.5);
    double z = r.hi * r.hi;
    double s = r.hi + (r.lo * (1 - half_square.hi) + r.hi * z * series(sine, 7, z));
    algsurf_dd c = algsurf_two_sum(1, -half_square.hi);
    c.hi += c.lo + (z * z * series(cosine, 7, z) - half_square.lo);
    int quarter = (int)(quarters - 4 * floor(quarters / 4));
    point[0] = quarter == 0 ? c.hi : quarter == 1 ? -s : quarter == 2 ? -c.hi : s;
    point[1] = quarter == 0 ? s : quarter == 1 ? c.hi : quarter == 2 ? -s : -c.hi;
}
