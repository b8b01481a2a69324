/* coefficients.c - sizes and signs of a caller's polynomial: compensated values where their bounds tell, else
 * integers. */
#include "../base/arithmetic.h"

#include <math.h>

#include "../base/eft.h"
#include "../base/fpenv.h"
#include "../poly/value.h"
#include "../poly/integral.h"
#include "coefficients.h"

algsurf_status algsurf_i_check_coefficients(algsurf_i_coefficients *p) {
    algsurf_status status = algsurf_i_check_polynomial(p->c, 1, p->r, p->degree);
    if (status != ALGSURF_OK) return status;
    int known = p->r ? p->degree : -1;
    while (known >= 0 && p->r[known] == 0) known--;
    if (known < 0) p->r = NULL;
    while (p->degree >= 0 && p->c[p->degree] == 0 && !(p->r && p->r[p->degree] > 0)) p->degree--;
    return p->degree < 0 ? ALGSURF_E_ZERO : ALGSURF_OK;
}

int algsurf_i_common_exponent(const algsurf_i_coefficients *p, int unit) {
    int common = -(1 << 20); /* below all: (degree + 1) times a subnormal's exponent is -551,000 */
    for (int k = 0; k <= p->degree; k++) {
        double a = fmax(fabs(p->c[k]), p->r ? p->r[k] : 0);
        if (a > 0 && ilogb(a) + k * unit > common) common = ilogb(a) + k * unit;
    }
    return common;
}

int algsurf_i_scale(const algsurf_i_coefficients *p, int unit, double *c, double *r) {
    int common = algsurf_i_common_exponent(p, unit);
    for (int k = 0; k <= p->degree; k++) {
        int shift = k * unit - common;
        c[k] = ldexp(p->c[k], shift);
        r[k] = (p->r ? ldexp(p->r[k], shift) : 0) + (fabs(c[k]) < 0x1p-1000 && p->c[k] != 0 ? 0x1p-1073 : 0);
    }
    return common;
}

/* q at N 2^-r, and Newton's step from there. */
static int exact_step(algsurf_memory *m, const algsurf_zpoly *q, algsurf_limb N, int r, algsurf_i_value *v) {
    algsurf_zpoly d;
    int sign, exponent;
    double slope;
    if (!algsurf_zpoly_sign_at(m, q, &N, 1, r, &v->sign, &v->size, &v->exponent)) return 0;
    if (v->sign == 0) return 1;
    if (!algsurf_zpoly_derivative(m, q, &d) ||
        !algsurf_zpoly_sign_at(m, &d, &N, 1, r, &sign, &slope, &exponent))
        return 0;
    v->newton = ldexp(-v->size / slope, v->exponent - exponent);
    return 1;
}

/* Does Horner's rule end at 0 without having rounded?  Products within 2^+-900 have a low part that is exact.
 */
static int vanishes_plainly(const algsurf_i_coefficients *p, double x) {
    double y = p->c[p->degree];
    for (int k = p->degree - 1; k >= 0; k--) {
        algsurf_dd product = algsurf_two_prod(y, x), sum = algsurf_two_sum(product.hi, p->c[k]);
        double size = fabs(product.hi);
        if (product.lo != 0 || sum.lo != 0 || !(size < 0x1p900 && (size > 0x1p-900 || y == 0 || x == 0)))
            return 0;
        y = sum.hi;
    }
    return y == 0;
}

int algsurf_i_exact_value(const algsurf_i_coefficients *p, double x, algsurf_i_value *value) {
    algsurf_limb block[512];
    algsurf_memory memory;
    algsurf_zpoly q;
    int e, low = algsurf_zpoly_least_bit(p->c, 1, p->degree, 0);
    algsurf_limb odd = algsurf_z_odd_part(x, &e), N = x < 0 ? 0 - odd : odd;
    *value = (algsurf_i_value){0};
    if (vanishes_plainly(p, x)) return 1;
    if (low == ALGSURF_Z_NO_BIT) low = 0;
    algsurf_memory_mark begin =
        algsurf_memory_begin(&memory, block, sizeof block / sizeof *block, ALGSURF_I_DECIDE_MEMORY);
    int done = algsurf_zpoly_from_doubles(&memory, p->c, 1, p->degree, 0, low, &q) &&
               exact_step(&memory, &q, N, odd ? -e : 0, value);
    value->exponent += low;
    algsurf_memory_release(&memory, begin);
    return done;
}

/* In the unit of x, so that nothing overflows; what the scaling may lose goes into the radii. */
static ALGSURF_NOINLINE algsurf_i_bounded scaled_value(const algsurf_i_coefficients *p, double x) {
    double c[ALGSURF_MAX_POLY_DEGREE + 1], r[ALGSURF_MAX_POLY_DEGREE + 1];
    int unit = x == 0 ? 0 : ilogb(x);
    (void)algsurf_i_scale(p, unit, c, r);
    return algsurf_i_compensated(c, r, p->degree, ldexp(x, -unit));
}

int algsurf_i_sign_at(const algsurf_i_coefficients *p, double x) {
    if (x == 0 && (!p->r || p->r[0] == 0 || fabs(p->c[0]) > p->r[0])) return (p->c[0] > 0) - (p->c[0] < 0);
    algsurf_i_bounded y = algsurf_i_compensated(p->c, p->r, p->degree, x);
    if (!(fabs(y.value) > y.bound)) y = scaled_value(p, x);
    if (fabs(y.value) > y.bound) return y.value > 0 ? 1 : -1;
    algsurf_i_value exact;
    return !p->r && algsurf_i_exact_value(p, x, &exact) ? exact.sign : ALGSURF_SIGN_UNKNOWN;
}
