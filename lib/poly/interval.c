/* interval.c - real intervals: the public operations.
 *
 * Products, quotients and squares; of all other operations what they compute stands in interval_impl.h.  Here
 * are also the checks, powers, and the environment.
 */
#include "../base/arithmetic.h"
#include "../base/fpenv.h"
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

static algsurf_status make(double lo, double hi, algsurf_interval *result) {
    algsurf_interval a = {lo + 0.0, hi + 0.0};
    if (!result || !algsurf_i_interval_valid(a)) return ALGSURF_E_ARGUMENT;
    *result = a;
    return ALGSURF_OK;
}

static algsurf_status divide(algsurf_interval a, algsurf_interval b, algsurf_interval *result) {
    if (!result || !algsurf_i_interval_valid(a) || !algsurf_i_interval_valid(b)) return ALGSURF_E_ARGUMENT;
    if (algsurf_i_interval_has_zero(b)) return ALGSURF_E_RANGE;
    *result = algsurf_i_interval_div(a, b);
    return ALGSURF_OK;
}

static algsurf_status square_root(algsurf_interval a, algsurf_interval *result) {
    if (!result || !algsurf_i_interval_valid(a)) return ALGSURF_E_ARGUMENT;
    if (a.lo < 0) return ALGSURF_E_RANGE;
    *result = algsurf_i_interval_sqrt(a);
    return ALGSURF_OK;
}

static algsurf_status intersect(algsurf_interval a, algsurf_interval b, algsurf_interval *result) {
    if (!result || !algsurf_i_interval_valid(a) || !algsurf_i_interval_valid(b)) return ALGSURF_E_ARGUMENT;
    algsurf_interval both = algsurf_i_interval_meet(a, b);
    if (both.lo > both.hi) return ALGSURF_E_RANGE;
    *result = both;
    return ALGSURF_OK;
}

/* size^n, size >= 0 */
static algsurf_interval power(algsurf_interval size, unsigned n) {
    algsurf_interval y = {1, 1};
    for (; n > 0; n >>= 1, size = algsurf_i_interval_sqr(size))
        if (n & 1) y = algsurf_i_interval_mul(y, size);
    return y;
}

/* x^n at an end x, n odd */
static algsurf_interval odd_power(double x, unsigned n) {
    algsurf_interval y = power((algsurf_interval){fabs(x), fabs(x)}, n);
    return x < 0 ? algsurf_i_interval_neg(y) : y;
}

/* a^-n, 0 not in a.  The power of |a| is positive; rounded outward it may have become [0,..]. */
static algsurf_interval reciprocal_power(algsurf_interval a, unsigned n) {
    algsurf_interval p = power(algsurf_i_interval_abs(a), n);
    algsurf_interval y = {algsurf_i_div_down(1, p.hi), p.lo > 0 ? algsurf_i_div_up(1, p.lo) : INFINITY};
    return a.hi < 0 && n % 2 == 1 ? algsurf_i_interval_neg(y) : y;
}

static algsurf_status raise_to(algsurf_interval a, int n, algsurf_interval *result) {
    if (!result || !algsurf_i_interval_valid(a)) return ALGSURF_E_ARGUMENT;
    if (n < 0 && algsurf_i_interval_has_zero(a)) return ALGSURF_E_RANGE;
    unsigned size = n < 0 ? 0u - (unsigned)n : (unsigned)n;
    if (n < 0)
        *result = reciprocal_power(a, size);
    else if (size % 2 == 0)
        *result = power(algsurf_i_interval_abs(a), size);
    else
        *result = (algsurf_interval){odd_power(a.lo, size).lo, odd_power(a.hi, size).hi};
    return ALGSURF_OK;
}

#define PUBLIC_1(type, name)                                                                                 \
    ALGSURF_I_PUBLIC(type, interval_##name, algsurf_i_interval_##name, (algsurf_interval a), (a))
#define PUBLIC_2(type, name)                                                                                 \
    ALGSURF_I_PUBLIC(type, interval_##name, algsurf_i_interval_##name,                                       \
                     (algsurf_interval a, algsurf_interval b), (a, b))

ALGSURF_I_PUBLIC(algsurf_status, interval_make, make, (double lo, double hi, algsurf_interval *result),
                 (lo, hi, result))
ALGSURF_I_PUBLIC(algsurf_interval, interval_point, algsurf_i_interval_point, (double x), (x))
PUBLIC_1(algsurf_interval, neg)
PUBLIC_2(algsurf_interval, add)
PUBLIC_2(algsurf_interval, sub)
PUBLIC_2(algsurf_interval, mul)
ALGSURF_I_PUBLIC(algsurf_status, interval_div, divide,
                 (algsurf_interval a, algsurf_interval b, algsurf_interval *result), (a, b, result))
PUBLIC_1(algsurf_interval, sqr)
ALGSURF_I_PUBLIC(algsurf_status, interval_pow, raise_to,
                 (algsurf_interval a, int n, algsurf_interval *result), (a, n, result))
ALGSURF_I_PUBLIC(algsurf_status, interval_sqrt, square_root, (algsurf_interval a, algsurf_interval *result),
                 (a, result))
PUBLIC_1(algsurf_interval, abs)
PUBLIC_2(algsurf_interval, hull)
ALGSURF_I_PUBLIC(algsurf_status, interval_intersect, intersect,
                 (algsurf_interval a, algsurf_interval b, algsurf_interval *result), (a, b, result))
PUBLIC_1(double, width)
PUBLIC_1(double, mid)
ALGSURF_I_PUBLIC(int, interval_contains, algsurf_i_interval_contains, (algsurf_interval a, double x), (a, x))
PUBLIC_2(int, inside)
PUBLIC_2(int, interior)
