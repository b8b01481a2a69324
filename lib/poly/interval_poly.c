/* interval_poly.c - the range of a polynomial over an interval or a rectangle.
 *
 * Horner's scheme overestimates by the first order of the width.  The centred form
 *     p(x) = p(m) + q(x) (x - m),   q = the quotient of p - p(m) by x - m,
 * has an excess of the second order (Krawczyk, Neumaier 1985): the coefficients of q are the intermediate
 * results of Horner's scheme at the point m, highest first, so both run together.  That is an identity of
 * polynomials, good for complex ones too, where the mean value theorem is not.  q(x) is a slope, about half
 * as wide as the enclosure of p'(x) it replaces.
 */
#include "../base/arithmetic.h"
#include "interval_impl.h"
#include "interval_public.h"

static int degree_allowed(int degree) { return degree >= 0 && degree <= ALGSURF_MAX_POLY_DEGREE; }

/* ---- real ---- */

static int valid(const algsurf_interval *c, int degree, algsurf_interval x, const algsurf_interval *result) {
    if (!c || !result || !degree_allowed(degree) || !algsurf_i_interval_valid(x)) return 0;
    for (int i = 0; i <= degree; i++)
        if (!algsurf_i_interval_valid(c[i])) return 0;
    return 1;
}

static algsurf_interval horner(const algsurf_interval *c, int degree, algsurf_interval x) {
    algsurf_interval y = c[degree];
    for (int i = degree - 1; i >= 0; i--) y = algsurf_i_interval_add(algsurf_i_interval_mul(y, x), c[i]);
    return y;
}

static algsurf_interval centred(const algsurf_interval *c, int degree, algsurf_interval x) {
    algsurf_interval m = algsurf_i_interval_point(algsurf_i_interval_mid(x));
    algsurf_interval at_m = c[degree], slope = {0, 0};
    for (int i = degree - 1; i >= 0; i--) {
        slope = algsurf_i_interval_add(algsurf_i_interval_mul(slope, x), at_m);
        at_m = algsurf_i_interval_add(algsurf_i_interval_mul(at_m, m), c[i]);
    }
    return algsurf_i_interval_add(at_m, algsurf_i_interval_mul(slope, algsurf_i_interval_sub(x, m)));
}

static algsurf_status poly(const algsurf_interval *c, int degree, algsurf_interval x,
                           algsurf_interval *result) {
    if (!valid(c, degree, x, result)) return ALGSURF_E_ARGUMENT;
    *result = horner(c, degree, x);
    return ALGSURF_OK;
}

static algsurf_status poly_centred(const algsurf_interval *c, int degree, algsurf_interval x,
                                   algsurf_interval *result) {
    if (!valid(c, degree, x, result)) return ALGSURF_E_ARGUMENT;
    *result = algsurf_i_interval_meet(horner(c, degree, x), centred(c, degree, x));
    return ALGSURF_OK;
}

/* ---- complex ---- */

static int cvalid(const algsurf_cinterval *c, int degree, algsurf_cinterval z,
                  const algsurf_cinterval *result) {
    if (!c || !result || !degree_allowed(degree) || !algsurf_i_cinterval_valid(z)) return 0;
    for (int i = 0; i <= degree; i++)
        if (!algsurf_i_cinterval_valid(c[i])) return 0;
    return 1;
}

static algsurf_cinterval chorner(const algsurf_cinterval *c, int degree, algsurf_cinterval z) {
    algsurf_cinterval y = c[degree];
    for (int i = degree - 1; i >= 0; i--) y = algsurf_i_cinterval_add(algsurf_i_cinterval_mul(y, z), c[i]);
    return y;
}

static algsurf_cinterval ccentred(const algsurf_cinterval *c, int degree, algsurf_cinterval z) {
    algsurf_cinterval m = algsurf_i_cinterval_point(algsurf_i_cinterval_mid(z));
    algsurf_cinterval at_m = c[degree], slope = {{0, 0}, {0, 0}};
    for (int i = degree - 1; i >= 0; i--) {
        slope = algsurf_i_cinterval_add(algsurf_i_cinterval_mul(slope, z), at_m);
        at_m = algsurf_i_cinterval_add(algsurf_i_cinterval_mul(at_m, m), c[i]);
    }
    return algsurf_i_cinterval_add(at_m, algsurf_i_cinterval_mul(slope, algsurf_i_cinterval_sub(z, m)));
}

static algsurf_status cpoly(const algsurf_cinterval *c, int degree, algsurf_cinterval z,
                            algsurf_cinterval *result) {
    if (!cvalid(c, degree, z, result)) return ALGSURF_E_ARGUMENT;
    *result = chorner(c, degree, z);
    return ALGSURF_OK;
}

static algsurf_status cpoly_centred(const algsurf_cinterval *c, int degree, algsurf_cinterval z,
                                    algsurf_cinterval *result) {
    if (!cvalid(c, degree, z, result)) return ALGSURF_E_ARGUMENT;
    algsurf_cinterval a = chorner(c, degree, z), b = ccentred(c, degree, z);
    *result = (algsurf_cinterval){algsurf_i_interval_meet(a.re, b.re), algsurf_i_interval_meet(a.im, b.im)};
    return ALGSURF_OK;
}

#define PUBLIC_POLY(room, name, work)                                                                        \
    ALGSURF_I_PUBLIC(algsurf_status, name, work,                                                             \
                     (const algsurf_##room *c, int degree, algsurf_##room x, algsurf_##room *result),        \
                     (c, degree, x, result))

PUBLIC_POLY(interval, interval_poly, poly)
PUBLIC_POLY(interval, interval_poly_centred, poly_centred)
PUBLIC_POLY(cinterval, cinterval_poly, cpoly)
PUBLIC_POLY(cinterval, cinterval_poly_centred, cpoly_centred)
