/* low.h - polynomials of the lowest degrees, by formula. */
#ifndef ALGSURF_LOW_H
#define ALGSURF_LOW_H
#include "algsurf/isolate.h"
#include "coefficients.h"

/* The real roots of p, of degree 1 or 2, exact, c[0] and c[degree] not 0, in order, isolated: each is in
 * (lo,hi), about 2^-29 of its size wide.  Returns how many, or -1: not known. */
int algsurf_i_low_roots(const algsurf_i_coefficients *p, algsurf_real_root *roots);

/* How many a p of degree 1 to 3 has, simple ones, or -1. */
int algsurf_i_low_number(const algsurf_i_coefficients *p);
#endif
