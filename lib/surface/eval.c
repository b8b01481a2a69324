/* eval.c - a surface and its gradient at a point, with error bounds.
 *
 * Horner's scheme, x inside y inside z, on the natural coefficients; derivatives by differentiating
 * the scheme (forward mode), so one pass over the coefficients gives all four numbers.  Next to it
 * runs the same scheme on magnitudes, M = sum (|c| + eta) |x|^i |y|^j |z|^k over all places (i,j,k)
 * of the dense rows, and its derivatives.
 *
 * Bound (Higham, Accuracy and Stability of Numerical Algorithms, 2002, 5.1, for nested schemes): a
 * term c x^i y^j z^k passes through at most 2i+1 roundings in its row, 2j+1 in its level, 2k+1 in
 * the last sum, and its coordinates may carry i+j+k more: 3n+3 factors (1+d), |d| <= u.  M comes out
 * too small by at most 2n+3 such factors.  Hence |error| <= (3n+3) u (1 + (5n+6) u) M, and
 *     bound = (4n+8) u M
 * leaves n+5 units u M to spare.  A term of a derivative is a sum over paths of the same length,
 * each counted once in the derivative of M: the same constant serves.
 * Underflow: a product may be off by 2^-1075, a coefficient of an `inexact` surface by 2^-1074, each
 * then multiplied by the coordinates that belong to its place.  eta = 2^-960 at every place where
 * that can happen covers it, times u, a hundred billion times over, and keeps M from underflow.
 *
 * Points the natural unit drives out of range, and values so small that eta would show, go through
 * the terms one by one, each a mantissa and an integer exponent, which cannot overflow.
 */
#include "../base/arithmetic.h"
#include <limits.h>
#include <math.h>

#include "../base/eft.h"
#include "../base/fpenv.h"
#include "../base/vec.h"
#include "../poly/value.h"
#include "impl.h"

#define ETA 0x1p-960

static double bound_factor(const algsurf_surface *s) { return (4 * s->degree + 8) * ALGSURF_U + s->error; }

/* A value and its three derivatives. */
typedef struct jet {
    double v, x, y, z;
} jet;

/* A step; on magnitudes a product with 0 is exact and needs no eta. */
static double step(double m, double t, double next, int sizes) {
    if (!sizes) return m * t + next;
    return m > 0 ? m * t + (next + ETA) : next;
}

/* The scheme, with derivatives or without, on magnitudes for `sizes`: then the coordinates are >= 0. */
static inline __attribute__((always_inline)) jet scheme(const algsurf_surface *s, double x, double y,
                                                        double z, int gradient, int sizes) {
    jet p = {0.0, 0.0, 0.0, 0.0};
    for (int k = s->level_count - 1; k >= 0; k--) {
        const algsurf_row *row = s->rows + s->levels[k].first;
        jet level = {0.0, 0.0, 0.0, 0.0};
        for (int j = s->levels[k].count - 1; j >= 0; j--) {
            const double *c = s->coef + row[j].first;
            double r = 0.0, r_x = 0.0;
            for (int i = row[j].length - 1; i >= 0; i--) {
                if (gradient) r_x = r_x * x + r; /* r holds an eta for this place, unless that is exact */
                r = r * x + (sizes ? fabs(c[i]) + ETA : c[i]);
            }
            if (gradient) level.x = step(level.x, y, r_x, sizes), level.y = step(level.y, y, level.v, sizes);
            level.v = step(level.v, y, r, sizes);
        }
        if (gradient) {
            p.x = step(p.x, z, level.x, sizes);
            p.y = step(p.y, z, level.y, sizes);
            p.z = step(p.z, z, p.v, sizes);
        }
        p.v = step(p.v, z, level.v, sizes);
    }
    return p;
}

static jet value_and_gradient(const algsurf_surface *s, const double x[3]) {
    return scheme(s, x[0], x[1], x[2], 1, 0);
}

static jet magnitudes(const algsurf_surface *s, const double x[3]) {
    return scheme(s, fabs(x[0]), fabs(x[1]), fabs(x[2]), 1, 1);
}

double algsurf_i_surface_magnitude(const algsurf_surface *s, const double x[3]) { return magnitudes(s, x).v; }

double algsurf_i_surface_value(const algsurf_surface *s, const double x[3], double gradient[3]) {
    jet p = value_and_gradient(s, x);
    gradient[0] = p.x;
    gradient[1] = p.y;
    gradient[2] = p.z;
    return p.v;
}

/* ---- the gradient at a complex point ---- */

typedef algsurf_i_complex complex_t;

static complex_t times_plus(complex_t a, complex_t x, complex_t b) {
    return (complex_t){a.re * x.re - a.im * x.im + b.re, a.re * x.im + a.im * x.re + b.im};
}

void algsurf_i_surface_gradient_complex(const algsurf_surface *s, const complex_t x[3],
                                        complex_t gradient[3]) {
    const complex_t zero = {0, 0};
    complex_t v = zero;
    gradient[0] = gradient[1] = gradient[2] = zero;
    for (int k = s->level_count - 1; k >= 0; k--) {
        const algsurf_row *row = s->rows + s->levels[k].first;
        complex_t level = zero, level_x = zero, level_y = zero;
        for (int j = s->levels[k].count - 1; j >= 0; j--) {
            const double *c = s->coef + row[j].first;
            complex_t r = zero, r_x = zero;
            for (int i = row[j].length - 1; i >= 0; i--) {
                r_x = times_plus(r_x, x[0], r);
                r = times_plus(r, x[0], (complex_t){c[i], 0});
            }
            level_x = times_plus(level_x, x[1], r_x);
            level_y = times_plus(level_y, x[1], level);
            level = times_plus(level, x[1], r);
        }
        gradient[0] = times_plus(gradient[0], x[2], level_x);
        gradient[1] = times_plus(gradient[1], x[2], level_y);
        gradient[2] = times_plus(gradient[2], x[2], v);
        v = times_plus(v, x[2], level);
    }
}

/* ---- bounds, in the caller's units ---- */

typedef algsurf_i_bounded bounded;

/* mantissa 2^exponent of one term, or of its derivative by coordinate `by` (-1: the term itself), at
 * the point m 2^e.  Mantissas are in [2^-65, 64] or 0: at most 64 factors in [1/2, 1). */
static double wide_term(const algsurf_term *t, const double m[3], const int e[3], int by, int *exponent) {
    int power[3] = {t->i, t->j, t->k};
    double product = frexp(t->a, exponent);
    if (by >= 0) product *= power[by]--;
    for (int axis = 0; axis < 3; axis++) {
        for (int p = 0; p < power[axis]; p++) product *= m[axis];
        *exponent += power[axis] * e[axis];
    }
    return product;
}

/* P, or a derivative of it, in the caller's units, without intermediate overflow.
 * Bound: each term carries at most n+1 roundings, the sum of N terms N more; a term that underflows
 * in the sum is off by 2^-1075, against 2^-66 or more of the largest; the last scaling by 2^-1075.
 * The factor N+n+8 covers these and the rounding of the magnitudes. */
static bounded wide_sum(const algsurf_surface *s, const double point[3], int by) {
    double m[3];
    int e[3], top = INT_MIN;
    for (int axis = 0; axis < 3; axis++) m[axis] = frexp(point[axis], &e[axis]);
    for (size_t t = 0; t < s->term_count; t++) {
        int exponent;
        if (wide_term(&s->terms[t], m, e, by, &exponent) != 0 && exponent > top) top = exponent;
    }
    if (top == INT_MIN) return (bounded){0.0, 0.0};
    double sum = 0.0, magnitude = 0.0;
    for (size_t t = 0; t < s->term_count; t++) {
        int exponent;
        double product = wide_term(&s->terms[t], m, e, by, &exponent);
        if (product == 0) continue;
        product = ldexp(product, exponent - top);
        sum += product;
        magnitude += fabs(product);
    }
    double factor = (double)(s->term_count + (size_t)s->degree + 8) * ALGSURF_U + s->error;
    double bound = factor * magnitude;
    return (bounded){ldexp(sum, top), ldexp(bound, top) + 0x1p-1073};
}

/* The point in natural units, exactly; 0 if it leaves the normal range. */
static int to_natural(const algsurf_surface *s, const double point[3], double x[3]) {
    for (int axis = 0; axis < 3; axis++) {
        x[axis] = ldexp(point[axis], -s->unit);
        if (point[axis] != 0 && !(fabs(x[axis]) >= 0x1p-1022 && fabs(x[axis]) < HUGE_VAL)) return 0;
    }
    return 1;
}

/* Magnitudes from which nothing overflowed and beside which eta is nothing: no place multiplies it by
 * more than the degree's power of the largest coordinate. */
static int in_range(const algsurf_surface *s, const double x[3], double magnitude) {
    int e;
    (void)frexp(algsurf_max_abs(x), &e);
    return magnitude >= ldexp(ETA, 80 + (e > 0 ? e * s->degree : 0)) && magnitude < HUGE_VAL;
}

int algsurf_i_surface_clear_gradient(const algsurf_surface *s, const double point[3], double gradient[3]) {
    double x[3];
    if (!to_natural(s, point, x)) return 0;
    jet m = magnitudes(s, x);
    if (!in_range(s, x, m.x + m.y + m.z)) return 0;
    (void)algsurf_i_surface_value(s, x, gradient);
    double bound = (bound_factor(s) - s->error) * fmax(m.x, fmax(m.y, m.z));
    return algsurf_max_abs(gradient) > ALGSURF_I_CLEAR * bound;
}

/* of[0] the value; with `gradient` of[1..3] the gradient.  Returns whether all are finite. */
static int evaluate(const algsurf_surface *s, const double point[3], int gradient, bounded of[4]) {
    const int count = gradient ? 4 : 1;
    double x[3];
    jet m = {0.0, 0.0, 0.0, 0.0};
    int natural = to_natural(s, point, x);
    if (natural) m = magnitudes(s, x);
    if (natural && in_range(s, x, m.v) && (!gradient || in_range(s, x, m.x + m.y + m.z))) {
        const jet p = gradient ? value_and_gradient(s, x) : scheme(s, x[0], x[1], x[2], 0, 0);
        const double value[4] = {p.v, p.x, p.y, p.z}, magnitude[4] = {m.v, m.x, m.y, m.z};
        for (int i = 0; i < count; i++) {
            const int exponent = -s->scale - (i > 0 ? s->unit : 0);
            of[i].value = ldexp(value[i], exponent);
            of[i].bound = ldexp(bound_factor(s) * magnitude[i], exponent) + 0x1p-1073;
        }
    } else {
        for (int i = 0; i < count; i++) of[i] = wide_sum(s, point, i - 1);
    }
    for (int i = 0; i < count; i++)
        if (!isfinite(of[i].value) || !isfinite(of[i].bound)) return 0;
    return 1;
}

ALGSURF_I_ENTRY(algsurf_status, surface_value,
                (const algsurf_surface *surface, const double point[3], double *value, double *bound),
                (surface, point, value, bound)) {
    bounded of[4];
    if (!surface || !point || !value) return ALGSURF_E_ARGUMENT;
    if (!algsurf_is_finite3(point)) return ALGSURF_E_NOT_FINITE;
    if (!evaluate(surface, point, 0, of)) return ALGSURF_E_RANGE;
    *value = of[0].value;
    if (bound) *bound = of[0].bound;
    return ALGSURF_OK;
}

ALGSURF_I_ENTRY(algsurf_status, surface_gradient,
                (const algsurf_surface *surface, const double point[3], double *value, double gradient[3],
                 double *value_bound, double gradient_bound[3]),
                (surface, point, value, gradient, value_bound, gradient_bound)) {
    bounded of[4];
    if (!surface || !point || !value || !gradient) return ALGSURF_E_ARGUMENT;
    if (!algsurf_is_finite3(point)) return ALGSURF_E_NOT_FINITE;
    if (!evaluate(surface, point, 1, of)) return ALGSURF_E_RANGE;
    *value = of[0].value;
    if (value_bound) *value_bound = of[0].bound;
    for (int axis = 0; axis < 3; axis++) {
        gradient[axis] = of[axis + 1].value;
        if (gradient_bound) gradient_bound[axis] = of[axis + 1].bound;
    }
    return ALGSURF_OK;
}
