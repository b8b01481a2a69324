/* coefficients.h - a polynomial as a caller gives it. */
#ifndef ALGSURF_COEFFICIENTS_H
#define ALGSURF_COEFFICIENTS_H

/* c[0] + ... + c[degree] t^degree, not zero; with radii r, or null, for all polynomials within them. */
typedef struct algsurf_i_coefficients {
    const double *c, *r;
    int degree;
} algsurf_i_coefficients;

/* The largest exponent among the coefficients, or their radii, in units of 2^unit. */
int algsurf_i_common_exponent(const algsurf_i_coefficients *p, int unit);

/* The certain sign of p at x, finite: -1, +1, 0 for an exact zero, or ALGSURF_SIGN_UNKNOWN where radii hide
 * it (or there is no memory to tell). */
#define ALGSURF_SIGN_UNKNOWN 2
int algsurf_i_sign_at(const algsurf_i_coefficients *p, double x);

#endif
