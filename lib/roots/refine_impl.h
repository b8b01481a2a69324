/* refine_impl.h - the bracket that all refinement methods share.
 *
 * b is the best end, the one with the smaller |f|; c the other, f(b) f(c) <= 0; a the b before
 * (Brent's letters).  A method chooses the next point x, algsurf_i_search_step does the rest.
 */
#ifndef ALGSURF_REFINE_IMPL_H
#define ALGSURF_REFINE_IMPL_H
#include <float.h>
#include <math.h>

#include "algsurf/refine.h"

typedef struct algsurf_i_search {
    algsurf_function f;
    void *data;
    double tolerance; /* wanted half width of the bracket, without the rounding part */
    int max_iterations;
    double a, b, c, fa, fb, fc;
    double x, fx; /* the newest point */
    int evaluations, iterations;
    int nan, settled; /* f returned NaN; the method itself decided to stop */
} algsurf_i_search;

/* Evaluates f at x and makes x an end of the bracket.  Returns 1 when x took the place of c, that is
 * when the root lies between x and the old b; 0 otherwise. */
int algsurf_i_search_step(algsurf_i_search *s, double x);

/* Neither a zero, nor narrow enough, nor stopped, nor at the limit of iterations? */
int algsurf_i_search_running(const algsurf_i_search *s);

/* The half width at which the bracket is narrow enough: tolerance + 4u max(|b|, smallest normal). */
static inline double algsurf_i_search_tolerance(const algsurf_i_search *s) {
    double size = fabs(s->b);
    return s->tolerance + 0x1p-51 * (size > DBL_MIN ? size : DBL_MIN);
}

/* (c - b)/2 without overflow. */
static inline double algsurf_i_search_half(const algsurf_i_search *s) {
    double width = s->c - s->b;
    return isfinite(width) ? 0.5 * width : 0.5 * s->c - 0.5 * s->b;
}

void algsurf_i_refine_brent(algsurf_i_search *s);
void algsurf_i_refine_bisection(algsurf_i_search *s);
void algsurf_i_refine_regula_falsi(algsurf_i_search *s);

/* f is a polynomial; *derivative is its derivative at s->x, written whenever f is called. */
void algsurf_i_refine_newton(algsurf_i_search *s, const double *derivative);

#endif
