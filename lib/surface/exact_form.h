/* surface/exact_form.h - P along a ray, with integer coefficients. */
#ifndef ALGSURF_EXACT_FORM_H
#define ALGSURF_EXACT_FORM_H
#include "algsurf/surface.h"

#include "../poly/integral.h"
#include "exact_axis.h"

/* p(u) = 2^scale P(origin + 2^e u direction) for the exact doubles, with integer coefficients, without
 * leading zeros and without a common power of two; scale is whatever makes that so.  degree -1: the ray lies
 * in the surface (scale 0 then).  scale may be null.  Returns 0 when there is no memory. */
int algsurf_i_exact_form(algsurf_memory *m, const algsurf_surface *s, const double origin[3],
                         const double direction[3], int e, algsurf_zpoly *p, int *scale);

/* For forms made in another way: first room for a result of at most that degree, whose coefficients of v^k,
 * v = 2^shift u, are below 2^bits; then the work; at last p(u) = 2^-low sum(v), from a sum that may be
 * changed, and all memory taken since is given back, except p's.  Returns low, 0 if p is zero. */
typedef struct algsurf_i_exact_result {
    algsurf_limb *c;
    int shift;
    algsurf_memory_mark before, work;
} algsurf_i_exact_result;
int algsurf_i_exact_form_begin(algsurf_memory *m, int degree, int bits, int shift, algsurf_i_exact_result *r);
int algsurf_i_exact_form_end(algsurf_memory *m, const algsurf_i_exact_result *r, algsurf_i_exact_sum *sum,
                             algsurf_zpoly *p);
#endif
