/* power.h - polynomials p(t) = q(t^k): the roots of p from those of q. */
#ifndef ALGSURF_POWER_H
#define ALGSURF_POWER_H
#include "algsurf/isolate.h"

typedef struct algsurf_i_power {
    int step, degree;                      /* k, above 1; of q */
    double q[ALGSURF_MAX_POLY_DEGREE + 1]; /* q[0] and q[degree] are not 0 */
} algsurf_i_power;

/* The largest k for p, of degree >= 1 with c[0] and c[degree] not 0; returns 0 where it is 1. */
int algsurf_i_power_of(const double *c, int degree, algsurf_i_power *w);

/* The interval of q's roots that holds those of p in [lo,hi]: at 0 or above for even k. */
void algsurf_i_power_interval(const algsurf_i_power *w, double lo, double hi, double *from, double *to);

/* q's roots there, isolated or refined, *count of them, become brackets of p's roots in [lo,hi]; these need
 * not be final where q's are.  Returns 0, with roots lost, where q's are too wide for that: beside a multiple
 * root, or beyond the range of doubles.  Room for p's degree. */
int algsurf_i_power_roots(const algsurf_i_power *w, const double *c, double lo, double hi,
                          algsurf_real_root *roots, int *count);
#endif
