/* poly.c - evaluation with a proved error bound, and the change to the Bernstein basis.
 *
 * Every bound here is a recurrence that runs beside the computation (Higham 2002, section 5.1) and
 * uses three facts about rounding to nearest, u = 2^-53:
 *     |fl(x op y) - (x op y)| <= u |fl(x op y)|             for +, and for * without underflow;
 *     |fl(x * y) - x * y|     <= u |fl(x * y)| + 2^-1075    in any case;
 *     a sum never underflows: a subnormal sum is exact.
 * The recurrences are themselves computed in double.  Their terms are not negative, so each rounding
 * loses at most a factor 1 - u; there are fewer than 12 for each of at most 512 steps, which RAISE makes
 * good.  What underflow may take is added as a constant in each step, derived where it stands, and so is
 * multiplied by whatever the following steps multiply.  Overflow turns a bound into +inf.
 */
#include "../base/arithmetic.h"
#include <math.h>

#include "algsurf/poly.h"
#include "../base/eft.h"
#include "../base/fpenv.h"
#include "value.h"

#define RAISE (1.0 + 0x1p-39) /* (1 - u)^-(12 * 512) < 1 + 2^-40, and once more for its own rounding */

/* The index of the highest coefficient that is not exactly 0.  Steps above it are exact: counting them would
 * only let the constants for underflow grow with the powers of t. */
static int highest(const double *c, const double *r, int degree) {
    while (degree > 0 && c[degree] == 0 && (!r || r[degree] == 0)) degree--;
    return degree;
}

/* A finished bound: NaN, from 0 * inf or inf - inf, can only follow an overflow. */
static double raised(double bound) {
    bound = bound * RAISE + 0x1p-1074;
    return bound < INFINITY ? bound : INFINITY;
}

/* Horner: y <- fl(fl(y t) + c_i).  The error grows as |E| <- |t| |E| + u |product| + u |sum| + r_i + 2^-1075;
 * the bound's own two products may lose 2^-1075 each: 2^-1073 covers the three.  An infinite y makes the
 * bound infinite and, t being neither 0 nor NaN then, stays infinite. */
static algsurf_i_bounded horner(const double *c, const double *r, int degree, double t) {
    double y = c[degree], size = fabs(t), bound = r ? r[degree] : 0.0;
    for (int i = degree - 1; i >= 0; i--) {
        double product = y * t;
        y = product + c[i];
        bound = size * bound + (ALGSURF_U * (fabs(product) + fabs(y)) + 0x1p-1073);
        if (r) bound += r[i];
    }
    return (algsurf_i_bounded){y, raised(bound)};
}

/* The power of two that brings the largest coefficient or radius near 1. */
static double scale_to_one(const double *c, const double *r, int degree) {
    double largest = 0.0;
    for (int i = 0; i <= degree; i++) {
        largest = fmax(largest, fabs(c[i]));
        if (r) largest = fmax(largest, r[i]);
    }
    int exponent = 0;
    (void)frexp(largest, &exponent);
    return ldexp(1.0, exponent > 1000 ? -1000 : exponent < -1000 ? 1000 : -exponent);
}

/* Compensated Horner: with product + pi = y t and sum + sigma = product + c_i exactly,
 *     p(t) = y_0 + sum_i (pi_i + sigma_i) t^i,
 * and the second polynomial, small, is evaluated by Horner with the bound above, its coefficients
 * w = fl(pi + sigma) having radii u |w|.  Hence |E| <- |t| |E| + u (|product'| + |sum'| + |w|) + r_i + tiny,
 * and the last addition costs u |value|.  Tiny: two_prod is exact up to 5 * 2^-1074 (Ogita, Rump, Oishi
 * 2005, section 3), c_i * scale up to 2^-1075, r_i * scale likewise, plus the three of horner: < 2^-1070.
 * The scaling by a power of two keeps errors of products above underflow; it is undone at the end, where
 * value and bound may lose 2^-1075 each. */
static algsurf_i_bounded compensated_horner(const double *c, const double *r, int degree, double t) {
    double scale = scale_to_one(c, r, degree), size = fabs(t);
    double y = c[degree] * scale, error = 0.0, bound = (r ? r[degree] * scale : 0.0) + 0x1p-1070;
    for (int i = degree - 1; i >= 0; i--) {
        algsurf_dd product = algsurf_two_prod(y, t), sum = algsurf_two_sum(product.hi, c[i] * scale);
        double w = product.lo + sum.lo, moved = error * t;
        y = sum.hi;
        error = moved + w;
        bound = size * bound + (ALGSURF_U * (fabs(moved) + fabs(error) + fabs(w)) + 0x1p-1070);
        if (r) bound += r[i] * scale;
    }
    double value = y + error;
    bound = raised(bound + ALGSURF_U * fabs(value));
    return (algsurf_i_bounded){value / scale, bound / scale + 0x1p-1073};
}

algsurf_i_bounded algsurf_i_compensated(const double *c, const double *r, int degree, double t) {
    degree = highest(c, r, degree);
    algsurf_i_bounded y = compensated_horner(c, r, degree, t);
    int overflow = !(y.bound < INFINITY) || !isfinite(y.value); /* two_prod does so earlier than a product */
    return overflow ? horner(c, r, degree, t) : y;
}

static algsurf_status eval(const double *c, const double *r, int degree, double t, int compensated,
                           double *value, double *bound) {
    if (!c || !value) return ALGSURF_E_ARGUMENT;
    algsurf_status status = algsurf_i_check_polynomial(c, 1, r, degree);
    if (status != ALGSURF_OK) return status;
    if (!isfinite(t)) return ALGSURF_E_NOT_FINITE;
    algsurf_i_bounded y =
        compensated ? algsurf_i_compensated(c, r, degree, t) : horner(c, r, highest(c, r, degree), t);
    *value = y.value;
    if (bound) *bound = y.bound;
    return ALGSURF_OK;
}

#define PUBLIC_VALUE(name, compensated)                                                                      \
    ALGSURF_I_ENTRY(algsurf_status, name,                                                                    \
                    (const double *c, const double *r, int degree, double t, double *value, double *bound),  \
                    (c, r, degree, t, value, bound)) {                                                       \
        return eval(c, r, degree, t, compensated, value, bound);                                             \
    }
PUBLIC_VALUE(poly_value, 0)
PUBLIC_VALUE(poly_value_compensated, 1)

/* A Bernstein coefficient on its way, with its error bound. */
typedef struct {
    double b, e;
} coefficient;

/* weight * from * x, weight = k/m rounded, 0 < k <= m.  Three roundings: u |term| each, and what
 * underflows in weight * b, and in weight * e, is multiplied by |x|: 2^-1073 covers both. */
static coefficient term(int k, int m, coefficient from, double x) {
    double weight = (double)k / (double)m, b = (weight * from.b) * x;
    return (coefficient){b, (weight * from.e + 0x1p-1073) * fabs(x) + 3 * ALGSURF_U * fabs(b)};
}

/* Horner in Bernstein form: q <- t q + c_i raises the degree of q to m.  On [lo,hi], t is the linear form
 * lo (1-s) + hi s, so that
 *     b_j <- (m-j)/m lo b_j + j/m hi b_{j-1} + c_i,   j = 0..m,
 * a constant being the same in every degree: the blossom, one argument after the other.  The leading
 * coefficient starts as such a constant.
 * Underflow in a step: at most six products in two terms: 2^-1071 covers them and the last RAISE. */
ALGSURF_I_ENTRY(algsurf_status, poly_to_bernstein,
                (const double *c, const double *r, int degree, double lo, double hi, double *b, double *br),
                (c, r, degree, lo, hi, b, br)) {
    if (!c || !b) return ALGSURF_E_ARGUMENT;
    algsurf_status status = algsurf_i_check_polynomial(c, 1, r, degree);
    if (status != ALGSURF_OK) return status;
    if (!isfinite(lo) || !isfinite(hi)) return ALGSURF_E_NOT_FINITE;
    if (!(lo < hi)) return ALGSURF_E_ARGUMENT;
    int top = highest(c, r, degree), first = degree - top;
    coefficient q[ALGSURF_MAX_POLY_DEGREE + 1];
    for (int j = 0; j <= first; j++) q[j] = (coefficient){c[top], r ? r[top] : 0.0};
    for (int m = first + 1; m <= degree; m++) {
        double ci = c[degree - m], ri = r ? r[degree - m] : 0.0;
        for (int j = m; j >= 0; j--) {
            coefficient left = {0.0, 0.0}, right = {0.0, 0.0};
            if (j < m) left = term(m - j, m, q[j], lo);
            if (j > 0) right = term(j, m, q[j - 1], hi);
            double sum = left.b + right.b, y = sum + ci;
            q[j] = (coefficient){y, left.e + right.e + ri + ALGSURF_U * (fabs(sum) + fabs(y)) + 0x1p-1071};
        }
    }
    for (int j = 0; j <= degree; j++) {
        if (top > 0) q[j].e = raised(q[j].e);
        if (!isfinite(q[j].b) || !isfinite(q[j].e)) return ALGSURF_E_RANGE;
    }
    for (int j = 0; j <= degree; j++) b[j] = q[j].b;
    for (int j = 0; br && j <= degree; j++) br[j] = q[j].e;
    return ALGSURF_OK;
}
