/* exact.h - the exact sign of a polynomial at a double. */
#ifndef ALGSURF_POLY_EXACT_H
#define ALGSURF_POLY_EXACT_H
#include "../base/expansion.h"

/* -1, 0, +1, or ALGSURF_SIGN_UNKNOWN when an intermediate product leaves the range of double. */
int algsurf_i_poly_exact_sign(const double *c, int degree, double x);

#endif
