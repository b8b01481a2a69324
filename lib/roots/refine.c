/* refine.c - roots refined (search.c): of a function, of a polynomial.
 *
 * Radii.  Outside of the ranges that integers find (algsurf_i_decide_ranges) no polynomial of the set has a
 * root in [lo,hi].  So each has the same sign from lo to the first range and from the last one to hi, and if
 * those differ, a root between.  The final bracket is what spans the ranges and that of the middle
 * polynomial; only this one is refined by steps.
 *
 * Certain values are plain or compensated where the bound tells their sign, else exact.  With |t| <
 * 2^(unit+1), u = t / 2^unit and coefficients c_k 2^(k unit + exponent) below 2, |u| < 2: a sum is below
 * (n + 1) 2^(n+1) <= 2^523, and nothing overflows.  Where no c_k exceeds 2^401 and |t|^n stays below 2^400
 * they are left as they are.  What becomes subnormal is off by 2^-1075 at most, less than its radius.
 *
 * Horner's rule is off by at most 2 n u S (first order), S = sum |c_k| |u|^k (Higham 2002, 5.1), and by what
 * underflow loses in products and coefficients: 2^-1074 each, times at most 2^513, together below 2^-550.
 * (2 n + 4) u S covers the higher orders, and the rounding of S. */
#include "../base/arithmetic.h"
#include <float.h>
#include <math.h>
#include <stdlib.h>

#include "algsurf/refine.h"

#include "../base/fpenv.h"
#include "../base/options.h"
#include "../poly/value.h"
#include "line.h"
#include "refine_impl.h"

/* ---- what both entries share ---- */

algsurf_status algsurf_i_refine_check(const algsurf_refine_options *how) {
    const int good = how->method >= ALGSURF_METHOD_DEFAULT && how->method <= ALGSURF_METHOD_REGULA_FALSI &&
                     how->max_iterations >= 0;
    if (!good) return ALGSURF_E_ARGUMENT;
    algsurf_status status = algsurf_i_check_number(how->absolute_tolerance, how->absolute_tolerance >= 0);
    return status == ALGSURF_OK ? algsurf_i_observer_check(how->observer) : status;
}

static algsurf_status read_options(algsurf_i_search *s, const algsurf_refine_options *options, int *method,
                                   algsurf_observer **observer) {
    algsurf_refine_options known = {.size = sizeof known};
    algsurf_status status = options ? algsurf_options_read(&known, sizeof known, options) : ALGSURF_OK;
    if (status == ALGSURF_OK) status = algsurf_i_refine_check(&known);
    if (status != ALGSURF_OK) return status;
    s->rounding = 0x1p-51;
    s->tolerance = fmin(0.5 * known.absolute_tolerance, 0.25 * DBL_MAX); /* twice it must be finite */
    s->max_iterations = known.max_iterations ? known.max_iterations : 1000;
    *method = known.method;
    *observer = known.observer;
    return ALGSURF_OK;
}

/* ---- a function ---- */

/* The caller's function, the environment that it is called in, and who watches. */
typedef struct visit {
    algsurf_function f;
    void *data;
    algsurf_fpenv *host;
    algsurf_i_watch watch;
} visit;

static double call_in_host(double x, void *data) {
    const visit *v = data;
    algsurf_fpenv_leave(v->host);
    double y = v->f(x, v->data);
    algsurf_fpenv_enter(v->host); /* with the flags that f has raised */
    if (v->watch.observer) algsurf_i_tell_point(&v->watch, x, y, 0, ALGSURF_ENGINE_DOUBLES);
    return y;
}

/* newton: null, or Newton's step, for the default method. */
static ALGSURF_NOINLINE algsurf_status refine_function(algsurf_i_search *s, algsurf_observer **observer,
                                                       const double *newton, double lo, double hi,
                                                       const algsurf_refine_options *options,
                                                       algsurf_refined_root *result) {
    int method;
    algsurf_status status = read_options(s, options, &method, observer);
    if (status != ALGSURF_OK) return status;
    if (!isfinite(lo) || !isfinite(hi)) return ALGSURF_E_NOT_FINITE;
    if (lo > hi) return ALGSURF_E_ARGUMENT;
    int bracketed = algsurf_i_search_begin(s, lo, hi);
    if (!s->nan && !bracketed) return ALGSURF_E_ARGUMENT;
    algsurf_i_search_run(s, method, newton);
    return algsurf_i_search_finish(s, result);
}

algsurf_status algsurf_refine_function(algsurf_function f, void *data, double lo, double hi,
                                       const algsurf_refine_options *options, algsurf_refined_root *result) {
    if (!f || !result) return ALGSURF_E_ARGUMENT;
    algsurf_fpenv host;
    algsurf_fpenv_enter(&host);
    visit v = {.f = f, .data = data, .host = &host};
    algsurf_i_search s = {.f = call_in_host, .data = &v};
    algsurf_status status = refine_function(&s, &v.watch.observer, NULL, lo, hi, options, result);
    algsurf_fpenv_leave(&host);
    return status;
}

algsurf_status algsurf_i_refine_function(algsurf_function f, void *data, const double *newton, double lo,
                                         double hi, const algsurf_refine_options *options,
                                         algsurf_refined_root *result) {
    algsurf_i_search s = {.f = f, .data = data};
    algsurf_observer *nobody;
    return refine_function(&s, &nobody, newton, lo, hi, options, result);
}

/* ---- a polynomial ---- */

/* What a polynomial's values are computed from: 2^exponent p(t) = sum c_k (t / 2^unit)^k. */
typedef struct polynomial {
    algsurf_i_coefficients given; /* the caller's, without radii */
    const double *c, *r;          /* r: what scaling may have lost, or null */
    int unit, exponent;
    double newton; /* Newton's step at the last point: from certain_value */
    int no_memory; /* a value could not be told, and is NaN */
    algsurf_function inner;
    int engine;                 /* that found the last value: set to the doubles' by who asks */
    algsurf_observer *observer; /* null: nobody looks */
} polynomial;

enum { MODEST = 400 };
#define NEAR 0x1p10 /* values are off by less than 1/NEAR of themselves: near enough for a step */

static double shift(double x, int e) { return e == 0 ? x : ldexp(x, e); }

/* For |t| <= farthest, if there is need, with unit and exponent 0 before. */
static void scale(polynomial *p, double farthest, double *c, double *r) {
    int n = p->given.degree, unit = farthest > 0 ? ilogb(farthest) : 0;
    double largest = 0;
    for (int k = 0; k <= n; k++) largest = fmax(largest, fabs(p->c[k]));
    int modest = largest < 0x1p401 && largest > 0x1p-401 && n * (abs(unit) + 1) <= MODEST;
    if (largest == 0 || modest) return;
    p->unit = unit;
    p->exponent = -algsurf_i_scale(&p->given, unit, c, r);
    p->c = c;
    p->r = r;
}

/* p from a scaled value; what is not zero stays so. */
static double unscaled(const polynomial *p, double y) {
    double value = ldexp(y, -p->exponent);
    return value == 0 && y != 0 ? copysign(DBL_TRUE_MIN, y) : value;
}

/* The sign at an infinite end. */
static double value_at_infinity(const polynomial *p, double t) {
    int n = p->given.degree;
    while (n > 0 && p->given.c[n] == 0) n--;
    return n == 0 ? p->given.c[0] : copysign(INFINITY, n % 2 && t < 0 ? -p->given.c[n] : p->given.c[n]);
}

/* Scaled; what underflows keeps its sign. */
static ALGSURF_NOINLINE double exact_value(polynomial *p, double t) {
    algsurf_i_value v;
    p->engine = ALGSURF_ENGINE_INTEGERS;
    if (isinf(t)) return value_at_infinity(p, t);
    if (!algsurf_i_exact_value(&p->given, t, &v)) {
        p->no_memory = 1;
        return NAN;
    }
    p->newton = v.newton;
    double y = ldexp(v.size, v.exponent + p->exponent);
    return y == 0 && v.sign ? copysign(DBL_TRUE_MIN, v.sign) : y;
}

static double with_step(polynomial *p, double y, double slope) {
    p->newton = shift(-y / slope, p->unit);
    return y;
}

/* The scaled value at t, finite or not, with its certain sign; 0 for a root only. */
static double certain_value(double t, void *data) {
    polynomial *p = data;
    int n = p->given.degree;
    double u = shift(t, -p->unit), y = p->c[n], slope = 0, size = fabs(y), far = fabs(u);
    if (isinf(t) || shift(u, p->unit) != t) return exact_value(p, t); /* u has underflowed */
    for (int k = n - 1; k >= 0; k--) {
        slope = slope * u + y;
        y = y * u + p->c[k];
        size = size * far + fabs(p->c[k]);
    }
    if (fabs(y) > 0x1p-500 && NEAR * (2 * n + 4) * 0x1p-53 * size < fabs(y)) return with_step(p, y, slope);
    algsurf_i_bounded v = algsurf_i_compensated(p->c, p->r, n, u);
    return NEAR * v.bound <= fabs(v.value) ? with_step(p, v.value, slope) : exact_value(p, t);
}

/* Horner's rule.  Coefficients are below 2^500 (balance), so a sum that overflows does so for |t| > 2 and
 * outweighs all that is still to come: the sign of an infinite value is right. */
static double plain_value(double t, void *data) {
    const polynomial *p = data;
    double y = p->c[p->given.degree];
    for (int i = p->given.degree - 1; i >= 0; i--) y = y * t + p->c[i];
    return y;
}

/* The inner function, watched. */
static double told(double t, void *data) {
    polynomial *p = data;
    p->engine = ALGSURF_ENGINE_DOUBLES;
    double y = p->inner(t, data);
    const algsurf_i_watch watch = {.observer = p->observer};
    algsurf_i_tell_point(&watch, t, y, -p->exponent, p->engine);
    return y;
}

/* Brings coefficients that are all tiny, or some of them huge, to about 1, so that values neither vanish nor
 * overflow without need. */
static void balance(polynomial *p, double *room) {
    int exponent = algsurf_i_common_exponent(&p->given, 0) + 1;
    if (exponent < -1074 || (exponent > -500 && exponent < 500)) return;
    for (int i = 0; i <= p->given.degree; i++) room[i] = ldexp(p->c[i], -exponent);
    p->c = room;
    p->exponent = -exponent;
}

/* Does a root lie between neighbouring doubles?  Signs tell nothing of two roots, nor of a double one. */
static algsurf_status find_root_between(const polynomial *p, double lo, double hi) {
    const algsurf_i_watch watch = {.observer = p->observer};
    const algsurf_i_line line = {
        .p = p->given, .lo = lo, .hi = hi, .refined = 1, .watch = p->observer ? &watch : NULL};
    algsurf_real_root root;
    int count;
    algsurf_status status = algsurf_i_decide(&line, &root, 1, &count);
    return status == ALGSURF_OK && count == 0 ? ALGSURF_E_ARGUMENT : status;
}

/* What spans the roots in [lo,hi] of all polynomials of the set; E_ARGUMENT where one of them may have none.
 */
static ALGSURF_NOINLINE algsurf_status span_roots(const algsurf_i_coefficients *set, double lo, double hi,
                                                  algsurf_observer *observer, algsurf_bracket *span) {
    const algsurf_i_watch watch = {.observer = observer};
    int count, at_lo = 0, at_hi = 0;
    algsurf_status status = algsurf_i_decide_ranges(set, lo, hi, span, 1, &count, observer ? &watch : NULL);
    if (status != ALGSURF_OK) return status;
    if (count == 0) return ALGSURF_E_ARGUMENT;
    if (span->kind != ALGSURF_BRACKET_UNDECIDED) return ALGSURF_OK;
    if (isinf(lo) || isinf(hi)) return ALGSURF_E_ARGUMENT;
    status = algsurf_i_decide_sign(set, lo, &at_lo);
    if (status == ALGSURF_OK) status = algsurf_i_decide_sign(set, hi, &at_hi);
    return status == ALGSURF_OK && at_lo * at_hi != -1 ? ALGSURF_E_ARGUMENT : status;
}

static algsurf_status refine_certain(algsurf_i_search *s, polynomial *p, double lo, double hi,
                                     algsurf_refined_root *result) {
    double c[ALGSURF_MAX_POLY_DEGREE + 1], r[ALGSURF_MAX_POLY_DEGREE + 1];
    scale(p, fmin(fmax(fabs(lo), fabs(hi)), DBL_MAX), c, r);
    s->rounding = 0x1p-53;
    s->settled = nextafter(lo, hi) == hi;
    int bracketed = algsurf_i_search_begin(s, lo, hi);
    if (!s->nan && !bracketed) {
        algsurf_status status = s->settled ? find_root_between(p, lo, hi) : ALGSURF_E_ARGUMENT;
        if (status != ALGSURF_OK) return status;
    }
    algsurf_i_search_run(s, ALGSURF_METHOD_DEFAULT, &p->newton);
    algsurf_status status = p->no_memory ? ALGSURF_E_NO_MEMORY : algsurf_i_search_finish(s, result);
    if (status == ALGSURF_OK && result->residual == 0 && !s->settled) result->lo = result->hi = result->root;
    return status;
}

algsurf_status algsurf_i_refine_bracket(const algsurf_i_coefficients *p, double lo, double hi,
                                        algsurf_refined_root *result) {
    polynomial whole = {.given = *p, .c = p->c};
    algsurf_i_search s = {.f = certain_value, .data = &whole, .max_iterations = 1000};
    return refine_certain(&s, &whole, lo, hi, result);
}

static algsurf_status refine_plain(algsurf_i_search *s, polynomial *p, double lo, double hi, int method,
                                   algsurf_refined_root *result) {
    double room[ALGSURF_MAX_POLY_DEGREE + 1];
    balance(p, room);
    int bracketed = algsurf_i_search_begin(s, lo, hi);
    if (!s->nan && !bracketed) return ALGSURF_E_ARGUMENT;
    algsurf_i_search_run(s, method, NULL);
    return algsurf_i_search_finish(s, result);
}

/* Finite ends; or the largest double and infinity, between which the default method has nothing to do. */
static algsurf_status check_ends(double lo, double hi, int method) {
    int beyond = method == ALGSURF_METHOD_DEFAULT && nextafter(lo, hi) == hi;
    if (isnan(lo) || isnan(hi) || (isinf(lo) && (isinf(hi) || !beyond)) || (isinf(hi) && !beyond))
        return ALGSURF_E_NOT_FINITE;
    return lo <= hi ? ALGSURF_OK : ALGSURF_E_ARGUMENT;
}

/* The zero polynomial is one like others here; without radii, so are leading zeros. */
static algsurf_status check_coefficients(algsurf_i_coefficients *p) {
    int degree = p->degree;
    algsurf_status status = algsurf_i_check_coefficients(p);
    if (!p->r) p->degree = degree;
    return status == ALGSURF_E_ZERO ? ALGSURF_OK : status;
}

static algsurf_status ALGSURF_NOINLINE refine_poly(algsurf_i_coefficients set, double lo, double hi,
                                                   const algsurf_refine_options *options,
                                                   algsurf_refined_root *result) {
    polynomial p = {.c = set.c};
    algsurf_i_search s = {.data = &p};
    algsurf_bracket span;
    int method;
    algsurf_status status = read_options(&s, options, &method, &p.observer);
    if (status == ALGSURF_OK && set.r && method != ALGSURF_METHOD_DEFAULT) status = ALGSURF_E_ARGUMENT;
    if (status == ALGSURF_OK) status = check_ends(lo, hi, method);
    if (status == ALGSURF_OK) status = check_coefficients(&set);
    if (status == ALGSURF_OK && set.r) status = span_roots(&set, lo, hi, p.observer, &span);
    if (status != ALGSURF_OK) return status;
    p.given = (algsurf_i_coefficients){set.c, NULL, set.degree};
    p.inner = method == ALGSURF_METHOD_DEFAULT ? certain_value : plain_value;
    s.f = p.observer ? told : p.inner;
    status = method == ALGSURF_METHOD_DEFAULT ? refine_certain(&s, &p, lo, hi, result)
                                              : refine_plain(&s, &p, lo, hi, method, result);
    if (status < 0) return status;
    result->residual = unscaled(&p, result->residual);
    if (set.r) result->lo = fmin(result->lo, span.lo), result->hi = fmax(result->hi, span.hi);
    return status;
}

algsurf_status algsurf_refine_poly(const double *c, const double *r, int degree, double lo, double hi,
                                   const algsurf_refine_options *options, algsurf_refined_root *result) {
    if (!c || !result) return ALGSURF_E_ARGUMENT;
    algsurf_status status;
    const algsurf_i_coefficients set = {c, r, degree};
    ALGSURF_STANDARD(status = refine_poly(set, lo, hi, options, result));
    return status;
}
