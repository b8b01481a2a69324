/* coefficients.h - a polynomial as a caller gives it. */
#ifndef ALGSURF_COEFFICIENTS_H
#define ALGSURF_COEFFICIENTS_H
#include <stddef.h>
#include <string.h>

#include "algsurf/isolate.h"

/* What deciding one polynomial may allocate, in bytes. */
#define ALGSURF_I_DECIDE_MEMORY ((size_t)1 << 30)

/* c[0] + ... + c[degree] t^degree, not zero; with radii r, or null, for all polynomials within them. */
typedef struct algsurf_i_coefficients {
    const double *c, *r;
    int degree;
} algsurf_i_coefficients;

/* OK, if all are finite, no radius is negative and p is not zero: leading zeros have gone then, and radii
 * that are all 0; E_DEGREE, E_NOT_FINITE, E_ARGUMENT, or E_ZERO, if there is nothing but zeros. */
algsurf_status algsurf_i_check_coefficients(algsurf_i_coefficients *p);

/* Doubles in their order: neighbours' numbers differ by 1, and 0 has number 0. */
static inline int64_t algsurf_i_number_of(double x) {
    int64_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits >= 0 ? bits : -(bits & INT64_MAX);
}

static inline double algsurf_i_double_of(int64_t number) {
    int64_t bits = number >= 0 ? number : -number;
    double x;
    memcpy(&x, &bits, sizeof x);
    return number >= 0 ? x : -x;
}

/* The double half way from lo to hi, lo <= hi, in that order: hi if these are neighbours or equal. */
static inline double algsurf_i_between(double lo, double hi) {
    int64_t from = algsurf_i_number_of(lo);
    uint64_t doubles = (uint64_t)algsurf_i_number_of(hi) - (uint64_t)from;
    return algsurf_i_double_of(from + (int64_t)((doubles + 1) / 2));
}

/* The largest exponent among the coefficients, or their radii, in units of 2^unit. */
int algsurf_i_common_exponent(const algsurf_i_coefficients *p, int unit);

/* p(2^unit u) 2^-common, the largest coefficient between 1 and 2: returns common.  r: the radii, and what
 * underflow may have lost. */
int algsurf_i_scale(const algsurf_i_coefficients *p, int unit, double *c, double *r);

/* A value p(x): its exact sign; size 2^exponent up to a relative error of 2^-52; about -p/p', 0 at a root. */
typedef struct algsurf_i_value {
    int sign, exponent;
    double size, newton;
} algsurf_i_value;

/* p, without radii, at x, finite.  Returns 0 when there is no memory. */
int algsurf_i_exact_value(const algsurf_i_coefficients *p, double x, algsurf_i_value *value);

/* The certain sign of p at x, finite: -1, +1, 0 for an exact zero, or ALGSURF_SIGN_UNKNOWN where radii hide
 * it (or there is no memory to tell). */
#define ALGSURF_SIGN_UNKNOWN 2
int algsurf_i_sign_at(const algsurf_i_coefficients *p, double x);

#endif
