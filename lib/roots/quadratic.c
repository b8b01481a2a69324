/* quadratic.c - signs at the ends, the discriminant, and the sign at the vertex.
 *
 * Different signs at the ends: one root.  Equal ones: two or none, and two only where the ends have the sign
 * of c_2, the discriminant D = c_1^2 - 4 c_0 c_2 is positive and p' changes its sign in between.
 *
 * Error.  Horner's rule for n <= 2 rounds 2 n times, its sum of magnitudes S as often: |error| <= 4 u S to
 * first order, taken as 8 u S.  D rounds twice in each term and once in its sum: 3 u (c_1^2 + 4 |c_0 c_2|),
 * taken as 8 u; p' = 2 c_2 x + c_1 likewise.  What underflows changes sums by less than 2^-1070: where
 * magnitudes are within 2^+-900 that is in the slack. */
#include "../base/arithmetic.h"
#include "quadratic.h"

#include <math.h>

#include "../base/eft.h"

enum { UNKNOWN = 2 };

/* The sign of a sum of that size, off by 8 u of it at most. */
static int sign_of(double sum, double size) {
    if (!(size > 0x1p-900 && size < 0x1p900)) return UNKNOWN;
    return sum > 8 * ALGSURF_U * size ? 1 : sum < -8 * ALGSURF_U * size ? -1 : UNKNOWN;
}

static int sign_at(const double *c, int n, double x) {
    double a = n == 2 ? c[2] : 0, r = fabs(x);
    return sign_of((a * x + c[1]) * x + c[0], (fabs(a) * r + fabs(c[1])) * r + fabs(c[0]));
}

static int slope_sign(const double *c, double x) {
    return sign_of(2 * c[2] * x + c[1], 2 * fabs(c[2] * x) + fabs(c[1]));
}

static algsurf_bracket bracket(double lo, double hi, int sign) {
    return (algsurf_bracket){lo, hi, ALGSURF_BRACKET_ISOLATED, sign, 1, ALGSURF_OK};
}

int algsurf_i_quadratic_isolate(const double *c, int degree, double lo, double hi, algsurf_bracket *brackets,
                                int *count) {
    int before = sign_at(c, degree, lo), after = sign_at(c, degree, hi);
    if (before == UNKNOWN || after == UNKNOWN) return 0;
    *count = before != after;
    if (*count) brackets[0] = bracket(lo, hi, before);
    if (*count || degree == 1 || (c[2] > 0) != (before > 0)) return 1;
    double square = c[1] * c[1], product = 4 * c[0] * c[2], middle = -0.5 * c[1] / c[2];
    int roots = sign_of(square - product, square + fabs(product));
    int falls = slope_sign(c, lo), rises = slope_sign(c, hi);
    if (roots == UNKNOWN || falls == UNKNOWN || rises == UNKNOWN) return 0;
    if (roots < 0 || falls == rises) return 1;
    if (!(lo < middle && middle < hi) || sign_at(c, 2, middle) != -before) return 0;
    *count = 2;
    brackets[0] = bracket(lo, middle, before);
    brackets[1] = bracket(middle, hi, -before);
    return 1;
}
