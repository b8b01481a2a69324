/* refine_impl.h - refinement, called inside the library. */
#ifndef ALGSURF_REFINE_IMPL_H
#define ALGSURF_REFINE_IMPL_H
#include "algsurf/refine.h"
#include "coefficients.h"

/* As algsurf_refine_poly with no options, for a bracket that is one. */
algsurf_status algsurf_i_refine_bracket(const algsurf_i_coefficients *p, double lo, double hi,
                                        algsurf_refined_root *result);

/* As algsurf_refine_function, with f in the library's environment, and the default method Newton's, guarded.
 * Nobody is told.
 *   newton  Newton's step from where f was called last, -f/f' */
algsurf_status algsurf_i_refine_function(algsurf_function f, void *data, const double *newton, double lo,
                                         double hi, const algsurf_refine_options *options,
                                         algsurf_refined_root *result);

/* Are method, limits and observer good ones? */
algsurf_status algsurf_i_refine_check(const algsurf_refine_options *how);

/* ---- search.c: the bracket that all refinement methods share, and the methods ---- */

/* b is the best end, the one with the smaller |f|; c the other, f(b) f(c) <= 0; a the b before (Brent's
 * letters). */
typedef struct algsurf_i_search {
    algsurf_function f;
    void *data;
    double tolerance; /* wanted half width of the bracket, without the rounding part */
    double rounding;  /* that, relative to b */
    int max_iterations;
    double a, b, c, fa, fb, fc;
    double x; /* the newest point */
    int evaluations, iterations;
    int nan, settled; /* f returned NaN; the method itself decided to stop */
} algsurf_i_search;

/* Values at both ends; the newest point is hi.  Do the signs differ, or is one of them zero? */
int algsurf_i_search_begin(algsurf_i_search *s, double lo, double hi);

/* Until the bracket is narrow enough.
 *   newton  null: the default method is Brent's; else it is Newton's, guarded, and *newton is its step from
 *           s->x, -f/f', written whenever f is called.  The bracket is as sure as the signs of f. */
void algsurf_i_search_run(algsurf_i_search *s, int method, const double *newton);

algsurf_status algsurf_i_search_finish(const algsurf_i_search *s, algsurf_refined_root *result);

#endif
