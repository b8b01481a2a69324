/* quadratic.h - brackets of the roots of polynomials of degree 1 and 2 without a walk. */
#ifndef ALGSURF_QUADRATIC_H
#define ALGSURF_QUADRATIC_H
#include "algsurf/isolate.h"

/* The roots of c, of degree 1 or 2, c[degree] != 0, in a finite interval lo < hi, at most two, in order, each
 * with its ends at doubles of certain sign.  Returns 0 when rounding hides what decides; nothing is written
 * then. */
int algsurf_i_quadratic_isolate(const double *c, int degree, double lo, double hi, algsurf_bracket *brackets,
                                int *count);

#endif
