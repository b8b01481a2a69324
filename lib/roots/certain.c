/* certain.c - a polynomial's value whose sign is the polynomial's own: plain or compensated where the bound
 * tells, else exact.
 *
 * With |t| < 2^(unit+1), u = t / 2^unit and coefficients c_k 2^(k unit + exponent) below 2, |u| < 2: a sum is
 * below (n + 1) 2^(n+1) <= 2^523, and nothing overflows.  Where no c_k exceeds 2^401 and |t|^n stays below
 * 2^400 they are left as they are.  What becomes subnormal is off by 2^-1075 at most, which is its radius.
 *
 * Horner's rule is off by at most 2 n u S (first order), S = sum |c_k| |u|^k (Higham 2002, 5.1), and by what
 * underflow loses in products and coefficients: 2^-1074 each, times at most 2^513, together below 2^-550.
 * (2 n + 4) u S covers the higher orders, and the rounding of S.
 */
#include "../base/arithmetic.h"
#include <float.h>
#include <math.h>
#include <stdlib.h>

#include "../base/fpenv.h"
#include "../poly/value.h"
#include "refine_impl.h"

enum { MODEST = 400 };
#define NEAR 0x1p10 /* values are off by less than 1/NEAR of themselves: near enough for a step */

static double shift(double x, int e) { return e == 0 ? x : ldexp(x, e); }

void algsurf_i_polynomial_scale(algsurf_i_polynomial *p, double farthest, double *c, double *r) {
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

double algsurf_i_polynomial_unscaled(const algsurf_i_polynomial *p, double y) {
    double value = ldexp(y, -p->exponent);
    return value == 0 && y != 0 ? copysign(DBL_TRUE_MIN, y) : value;
}

/* The sign at an infinite end. */
static double value_at_infinity(const algsurf_i_polynomial *p, double t) {
    int n = p->given.degree;
    while (n > 0 && p->given.c[n] == 0) n--;
    return n == 0 ? p->given.c[0] : copysign(INFINITY, n % 2 && t < 0 ? -p->given.c[n] : p->given.c[n]);
}

/* Scaled; what underflows keeps its sign. */
static ALGSURF_NOINLINE double exact_value(algsurf_i_polynomial *p, double t) {
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

static double with_step(algsurf_i_polynomial *p, double y, double slope) {
    p->newton = shift(-y / slope, p->unit);
    return y;
}

double algsurf_i_polynomial_certain(double t, void *data) {
    algsurf_i_polynomial *p = data;
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
