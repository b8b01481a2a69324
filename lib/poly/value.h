/* value.h - a polynomial's value with a bound, for callers who have checked what they give. */
#ifndef ALGSURF_VALUE_H
#define ALGSURF_VALUE_H

typedef struct algsurf_i_bounded {
    double value, bound;
} algsurf_i_bounded;

/* algsurf_poly_value_compensated for finite c, r (or null) and t, in the library's floating-point
 * environment.
 */
algsurf_i_bounded algsurf_i_compensated(const double *c, const double *r, int degree, double t);

#endif
