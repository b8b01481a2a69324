/* interval.c - real intervals: the public operations.
 *
 * Products, quotients, squares and powers; of all other operations what they compute stands in
 * interval_impl.h.
 */
#include "../base/arithmetic.h"
#include "../base/fpenv.h"
#include "value.h"
#include "interval_impl.h"

/* Both factors have both signs. */
static algsurf_interval mul_mixed(algsurf_interval a, algsurf_interval b) {
    double lo1 = algsurf_i_mul_down(a.lo, b.hi), lo2 = algsurf_i_mul_down(a.hi, b.lo);
    double hi1 = algsurf_i_mul_up(a.lo, b.lo), hi2 = algsurf_i_mul_up(a.hi, b.hi);
    return (algsurf_interval){lo1 < lo2 ? lo1 : lo2, hi1 > hi2 ? hi1 : hi2};
}

/* By exchange and a common change of sign, a >= 0. */
algsurf_interval algsurf_i_interval_mul(algsurf_interval a, algsurf_interval b) {
    if (a.lo < 0 && a.hi > 0) {
        if (b.lo < 0 && b.hi > 0) return mul_mixed(a, b);
        algsurf_interval t = a;
        a = b, b = t;
    }
    if (a.lo < 0) a = (algsurf_interval){-a.hi, -a.lo}, b = (algsurf_interval){-b.hi, -b.lo};
    return (algsurf_interval){algsurf_i_mul_down(b.lo >= 0 ? a.lo : a.hi, b.lo),
                              algsurf_i_mul_up(b.hi >= 0 ? a.hi : a.lo, b.hi)};
}

/* By a common change of sign, b > 0. */
algsurf_interval algsurf_i_interval_div(algsurf_interval a, algsurf_interval b) {
    if (b.lo < 0) a = (algsurf_interval){-a.hi, -a.lo}, b = (algsurf_interval){-b.hi, -b.lo};
    return (algsurf_interval){algsurf_i_div_down(a.lo, a.lo >= 0 ? b.hi : b.lo),
                              algsurf_i_div_up(a.hi, a.hi >= 0 ? b.lo : b.hi)};
}

algsurf_interval algsurf_i_interval_sqr(algsurf_interval a) {
    a = algsurf_i_interval_abs(a);
    return (algsurf_interval){algsurf_i_mul_down(a.lo, a.lo), algsurf_i_mul_up(a.hi, a.hi)};
}

ALGSURF_I_ENTRY(algsurf_status, interval_make, (double lo, double hi, algsurf_interval *result),
                (lo, hi, result)) {
    algsurf_interval a = {lo + 0.0, hi + 0.0};
    if (!result || !algsurf_i_interval_valid(a)) return ALGSURF_E_ARGUMENT;
    *result = a;
    return ALGSURF_OK;
}

ALGSURF_I_ENTRY(algsurf_status, interval_sqrt, (algsurf_interval a, algsurf_interval *result), (a, result)) {
    if (!result || !algsurf_i_interval_valid(a)) return ALGSURF_E_ARGUMENT;
    if (a.lo < 0) return ALGSURF_E_RANGE;
    *result = algsurf_i_interval_sqrt(a);
    return ALGSURF_OK;
}

/* size^n, size >= 0 */
static algsurf_interval power_of_size(algsurf_interval size, unsigned n) {
    algsurf_interval y = {1, 1};
    for (; n > 0; n >>= 1, size = algsurf_i_interval_sqr(size))
        if (n & 1) y = algsurf_i_interval_mul(y, size);
    return y;
}

/* x^n at an end x, n odd */
static algsurf_interval odd_power(double x, unsigned n) {
    algsurf_interval y = power_of_size((algsurf_interval){fabs(x), fabs(x)}, n);
    return x < 0 ? algsurf_i_interval_neg(y) : y;
}

/* a^-n, 0 not in a.  The power of |a| is positive; rounded outward it may have become [0,..]. */
static algsurf_interval reciprocal_power(algsurf_interval a, unsigned n) {
    algsurf_interval p = power_of_size(algsurf_i_interval_abs(a), n);
    algsurf_interval y = {algsurf_i_div_down(1, p.hi), p.lo > 0 ? algsurf_i_div_up(1, p.lo) : INFINITY};
    return a.hi < 0 && n % 2 == 1 ? algsurf_i_interval_neg(y) : y;
}

static algsurf_interval power(algsurf_interval a, int n) {
    unsigned size = n < 0 ? 0u - (unsigned)n : (unsigned)n;
    if (n < 0) return reciprocal_power(a, size);
    if (size % 2 == 0) return power_of_size(algsurf_i_interval_abs(a), size);
    return (algsurf_interval){odd_power(a.lo, size).lo, odd_power(a.hi, size).hi};
}

ALGSURF_I_ENTRY(algsurf_status, interval_pow, (algsurf_interval a, int n, algsurf_interval *result),
                (a, n, result)) {
    if (!result || !algsurf_i_interval_valid(a)) return ALGSURF_E_ARGUMENT;
    if (n < 0 && algsurf_i_interval_has_zero(a)) return ALGSURF_E_RANGE;
    *result = power(a, n);
    return ALGSURF_OK;
}

#define RANGE algsurf_interval
#define POINT double
#define CALL(name) interval_##name
#define OP(name) algsurf_i_interval_##name
#include "interval_calls_template.h"
