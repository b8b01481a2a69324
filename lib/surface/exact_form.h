/* surface/exact_form.h - P along a ray, with integer coefficients. */
#ifndef ALGSURF_EXACT_FORM_H
#define ALGSURF_EXACT_FORM_H
#include "algsurf/surface.h"

#include "../poly/integral.h"

/* p(u) = 2^scale P(origin + 2^e u direction) for the exact doubles, with integer coefficients, without
 * leading zeros and without a common power of two; scale is whatever makes that so.  degree -1: the ray lies
 * in the surface (scale 0 then).  scale may be null.  Returns 0 when there is no memory. */
int algsurf_i_exact_form(algsurf_memory *m, const algsurf_surface *s, const double origin[3],
                         const double direction[3], int e, algsurf_zpoly *p, int *scale);
#endif
