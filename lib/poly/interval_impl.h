/* interval_impl.h - interval operations for code that already runs in the standard environment (fpenv.h).
 *
 * The operations of algsurf/interval.h without the cost of entering and leaving the environment; same
 * results, same conventions, operands unchecked.  Each end is one directed rounding of the one corner that
 * gives it, found from the signs of the operands (Moore 1966; Hickey, Ju, van Emden 2001).
 */
#ifndef ALGSURF_INTERVAL_IMPL_H
#define ALGSURF_INTERVAL_IMPL_H
#include <float.h>

#include "algsurf/interval.h"
#include "interval_round.h"

/* ---- real ---- */

static inline int algsurf_i_interval_valid(algsurf_interval a) {
    return a.lo <= a.hi && a.lo < INFINITY && a.hi > -INFINITY;
}

static inline int algsurf_i_interval_has_zero(algsurf_interval a) { return a.lo <= 0 && a.hi >= 0; }

static inline algsurf_interval algsurf_i_interval_point(double x) {
    return (algsurf_interval){x + 0.0, x + 0.0};
}

static inline algsurf_interval algsurf_i_interval_neg(algsurf_interval a) {
    return (algsurf_interval){0.0 - a.hi, 0.0 - a.lo};
}

static inline algsurf_interval algsurf_i_interval_add(algsurf_interval a, algsurf_interval b) {
    return (algsurf_interval){algsurf_i_add_down(a.lo, b.lo), algsurf_i_add_up(a.hi, b.hi)};
}

static inline algsurf_interval algsurf_i_interval_sub(algsurf_interval a, algsurf_interval b) {
    return (algsurf_interval){algsurf_i_add_down(a.lo, -b.hi), algsurf_i_add_up(a.hi, -b.lo)};
}

algsurf_interval algsurf_i_interval_mul(algsurf_interval a, algsurf_interval b);

/* b does not contain 0. */
algsurf_interval algsurf_i_interval_div(algsurf_interval a, algsurf_interval b);

static inline algsurf_interval algsurf_i_interval_abs(algsurf_interval a) {
    double lo = fabs(a.lo), hi = fabs(a.hi), most = lo > hi ? lo : hi, least = lo > hi ? hi : lo;
    return (algsurf_interval){algsurf_i_interval_has_zero(a) ? 0.0 : least, most};
}

algsurf_interval algsurf_i_interval_sqr(algsurf_interval a);

/* a.lo >= 0 */
static inline algsurf_interval algsurf_i_interval_sqrt(algsurf_interval a) {
    return (algsurf_interval){algsurf_i_sqrt(a.lo, -1), algsurf_i_sqrt(a.hi, 1)};
}

/* a 2^k */
static inline algsurf_interval algsurf_i_interval_scale(algsurf_interval a, int k) {
    if (k == 0) return a;
    return (algsurf_interval){algsurf_i_scale_down(a.lo, k), algsurf_i_scale_up(a.hi, k)};
}

static inline algsurf_interval algsurf_i_interval_hull(algsurf_interval a, algsurf_interval b) {
    return (algsurf_interval){(a.lo < b.lo ? a.lo : b.lo) + 0.0, (a.hi > b.hi ? a.hi : b.hi) + 0.0};
}

/* What both have in common; no interval (lo > hi) if nothing. */
static inline algsurf_interval algsurf_i_interval_meet(algsurf_interval a, algsurf_interval b) {
    return (algsurf_interval){(a.lo > b.lo ? a.lo : b.lo) + 0.0, (a.hi < b.hi ? a.hi : b.hi) + 0.0};
}

static inline double algsurf_i_interval_width(algsurf_interval a) { return algsurf_i_add_up(a.hi, -a.lo); }

/* Half of the sum is rounded once: a sum below 2^-1021 is exact, and halving any larger one is.  Where the
 * sum overflows, both ends are above 2^969 and their halves exact. */
static inline double algsurf_i_interval_mid(algsurf_interval a) {
    if (isinf(a.lo) || isinf(a.hi))
        return isinf(a.lo) && isinf(a.hi) ? 0.0 : isinf(a.hi) ? DBL_MAX : -DBL_MAX;
    double sum = a.lo + a.hi;
    return isinf(sum) ? 0.5 * a.lo + 0.5 * a.hi : 0.5 * sum + 0.0;
}

/* x is a real number: no infinity, no NaN. */
static inline int algsurf_i_interval_contains(algsurf_interval a, double x) {
    return a.lo <= x && x <= a.hi && fabs(x) < INFINITY;
}

static inline int algsurf_i_interval_inside(algsurf_interval a, algsurf_interval b) {
    return b.lo <= a.lo && a.hi <= b.hi;
}

/* An end at infinity is no boundary. */
static inline int algsurf_i_interval_interior(algsurf_interval a, algsurf_interval b) {
    return (b.lo < a.lo || b.lo == -INFINITY) && (a.hi < b.hi || b.hi == INFINITY);
}

/* ---- complex ---- */

static inline int algsurf_i_cinterval_valid(algsurf_cinterval a) {
    return algsurf_i_interval_valid(a.re) && algsurf_i_interval_valid(a.im);
}

static inline int algsurf_i_cinterval_has_zero(algsurf_cinterval a) {
    return algsurf_i_interval_has_zero(a.re) && algsurf_i_interval_has_zero(a.im);
}

static inline algsurf_cinterval algsurf_i_cinterval_point(algsurf_complex z) {
    return (algsurf_cinterval){algsurf_i_interval_point(z.re), algsurf_i_interval_point(z.im)};
}

/* add, sub, hull, meet. */
#define ALGSURF_I_BY_COMPONENTS(name)                                                                        \
    static inline algsurf_cinterval algsurf_i_cinterval_##name(algsurf_cinterval a, algsurf_cinterval b) {   \
        return (algsurf_cinterval){algsurf_i_interval_##name(a.re, b.re),                                    \
                                   algsurf_i_interval_##name(a.im, b.im)};                                   \
    }
ALGSURF_I_BY_COMPONENTS(add)
ALGSURF_I_BY_COMPONENTS(sub)
ALGSURF_I_BY_COMPONENTS(hull)
ALGSURF_I_BY_COMPONENTS(meet)

static inline algsurf_cinterval algsurf_i_cinterval_scale(algsurf_cinterval a, int k) {
    return (algsurf_cinterval){algsurf_i_interval_scale(a.re, k), algsurf_i_interval_scale(a.im, k)};
}

algsurf_cinterval algsurf_i_cinterval_mul(algsurf_cinterval a, algsurf_cinterval b);

static inline algsurf_complex algsurf_i_cinterval_mid(algsurf_cinterval a) {
    return (algsurf_complex){algsurf_i_interval_mid(a.re), algsurf_i_interval_mid(a.im)};
}

/* b does not contain 0. */
algsurf_cinterval algsurf_i_cinterval_div(algsurf_cinterval a, algsurf_cinterval b);
algsurf_interval algsurf_i_cinterval_abs(algsurf_cinterval a);
/* a does not contain 0. */
algsurf_interval algsurf_i_cinterval_arg(algsurf_cinterval a);

#endif
