/* roots_mpsolve.c - MPSolve 3 (Bini, Fiorentino, Robol): Ehrlich-Aberth in as much precision as it takes,
 * with discs, for either of its goals: of doubles by its default algorithm, of integers by both of them.
 */
#include <math.h>
#include <mps/mps.h>
#include <stdlib.h>

#include "roots_others.h"

static int solve(mps_context *context, mps_monomial_poly *p, int degree, mps_output_goal goal,
                 other_root *roots) {
    cplx_t *centre = NULL;
    double *radius = NULL;
    int count = 0;
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

static int solve_doubles(const double *re, const double *im, int degree, mps_output_goal goal,
                         other_root *roots) {
    mps_context *context = mps_context_new();
    mps_monomial_poly *p = mps_monomial_poly_new(context, degree);
    for (int k = 0; k <= degree; k++)
        mps_monomial_poly_set_coefficient_d(context, p, k, re[k], im ? im[k] : 0);
    return solve(context, p, degree, goal, roots);
}

int by_mpsolve_isolate(const double *re, const double *im, int degree, other_root *roots) {
    return solve_doubles(re, im, degree, MPS_OUTPUT_GOAL_ISOLATE, roots);
}

int by_mpsolve_approximate(const double *re, const double *im, int degree, other_root *roots) {
    return solve_doubles(re, im, degree, MPS_OUTPUT_GOAL_APPROXIMATE, roots);
}

static void set_integer(mpq_t q, const algsurf_integer *z) {
    mpz_import(mpq_numref(q), (size_t)abs(z->length), -1, sizeof *z->limbs, 0, 0, z->limbs);
    if (z->length < 0) mpq_neg(q, q);
}

static int solve_integers(const algsurf_integer *re, const algsurf_integer *im, int degree,
                          mps_algorithm algorithm, mps_output_goal goal, other_root *roots) {
    mps_context *context = mps_context_new();
    mps_monomial_poly *p = mps_monomial_poly_new(context, degree);
    mpq_t real, imaginary;
    mpq_inits(real, imaginary, NULL);
    for (int k = 0; k <= degree; k++) {
        set_integer(real, &re[k]);
        if (im) set_integer(imaginary, &im[k]);
        mps_monomial_poly_set_coefficient_q(context, p, k, real, imaginary);
    }
    mpq_clears(real, imaginary, NULL);
    mps_context_select_algorithm(context, algorithm);
    return solve(context, p, degree, goal, roots);
}

/* One of the two algorithms with one of the two goals. */
#define BY(name, algorithm, goal)                                                                            \
    int name(const algsurf_integer *re, const algsurf_integer *im, int degree, other_root *roots) {          \
        return solve_integers(re, im, degree, algorithm, goal, roots);                                       \
    }
BY(by_mpsolve_secular_isolate, MPS_ALGORITHM_SECULAR_GA, MPS_OUTPUT_GOAL_ISOLATE)
BY(by_mpsolve_secular_approximate, MPS_ALGORITHM_SECULAR_GA, MPS_OUTPUT_GOAL_APPROXIMATE)
BY(by_mpsolve_classic_isolate, MPS_ALGORITHM_STANDARD_MPSOLVE, MPS_OUTPUT_GOAL_ISOLATE)
BY(by_mpsolve_classic_approximate, MPS_ALGORITHM_STANDARD_MPSOLVE, MPS_OUTPUT_GOAL_APPROXIMATE)
