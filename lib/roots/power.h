/* power.h - polynomials p(t) = t^m q(t^k): the roots of p from those of q. */
#ifndef ALGSURF_POWER_H
#define ALGSURF_POWER_H
#include "algsurf/isolate.h"

typedef struct algsurf_i_power {
    int zeros, step;                       /* m, k */
    int degree;                            /* of q */
    double q[ALGSURF_MAX_POLY_DEGREE + 1]; /* q[0] and q[degree] are not 0 */
} algsurf_i_power;

/* The largest m and k for p, of degree >= 0 with c[degree] not 0; returns 0 where q is not worth having. */
int algsurf_i_power_of(const double *c, int degree, algsurf_i_power *w);

/* The interval of q's roots that holds those of p in [lo,hi]: at 0 or above for even k. */
void algsurf_i_power_interval(const algsurf_i_power *w, double lo, double hi, double *from, double *to);

/* brackets: those of q's roots there, *count of them, become those of p's roots in [lo,hi], with their signs
 * also where they are exact.  Returns 0, with brackets lost, where they are too wide for that: beside a
 * multiple root, or beyond the range of doubles.  Room for p's degree, at least 1. */
int algsurf_i_power_roots(const algsurf_i_power *w, const double *c, double lo, double hi,
                          algsurf_bracket *brackets, int *count);
#endif
