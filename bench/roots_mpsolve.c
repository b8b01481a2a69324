/* roots_mpsolve.c - MPSolve 3 (Bini, Fiorentino, Robol): Ehrlich-Aberth in as much precision as it takes,
 * with discs, by its default algorithm, for either of its goals.
 */
#include <math.h>
#include <mps/mps.h>
#include <stdlib.h>

#include "roots_others.h"

static int solve(const double *re, const double *im, int degree, mps_output_goal goal, other_root *roots) {
    mps_context *context = mps_context_new();
    mps_monomial_poly *p = mps_monomial_poly_new(context, degree);
    cplx_t *centre = NULL;
    double *radius = NULL;
    int count = 0;
    for (int k = 0; k <= degree; k++)
        mps_monomial_poly_set_coefficient_d(context, p, k, re[k], im ? im[k] : 0);
    mps_context_set_output_goal(context, goal);
    mps_context_set_output_prec(context, 53);
    mps_context_set_input_poly(context, MPS_POLYNOMIAL(p));
    mps_mpsolve(context);
    if (!mps_context_has_errors(context)) {
        int at_zero = mps_context_get_zero_roots(context); /* not among the others */
        mps_context_get_roots_d(context, &centre, &radius);
        for (; count < degree - at_zero; count++)
            roots[count] = (other_root){cplx_Re(centre[count]), cplx_Im(centre[count]), radius[count]};
        for (; count < degree; count++) roots[count] = (other_root){0, 0, 0};
    }
    if (centre) cplx_vfree(centre);
    free(radius);
    mps_polynomial_free(context, MPS_POLYNOMIAL(p));
    mps_context_free(context);
    return count;
}

int by_mpsolve_isolate(const double *re, const double *im, int degree, other_root *roots) {
    return solve(re, im, degree, MPS_OUTPUT_GOAL_ISOLATE, roots);
}

int by_mpsolve_approximate(const double *re, const double *im, int degree, other_root *roots) {
    return solve(re, im, degree, MPS_OUTPUT_GOAL_APPROXIMATE, roots);
}
