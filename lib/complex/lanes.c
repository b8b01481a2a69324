/* lanes.c - all complex roots of one polynomial: the public calls.
 *
 * Exact polynomials of small degrees go to the lanes first (boxes_template.h); what those leave open, and all
 * others, to allroots.c. */
#include "../base/arithmetic.h"
#include "algsurf/allroots.h"

#include "../base/fpenv.h"
#include "../poly/value.h"
#include "impl.h"
#include "boxes.h"

/* Coefficient k is re[k step] + i im[k step]; im null: all are real. */
static ALGSURF_NOINLINE algsurf_status solve(const double *re, const double *im, int step, const double *r,
                                             int given, algsurf_complex_root *roots, int *count) {
    const algsurf_i_allroots_kernel *kernel = algsurf_i_allroots_kernel_for(algsurf_i_kernel_find(NULL));
    int real = 1, degree = given;
    for (int k = 0; im && k <= given; k++) real = real && im[k * step] == 0;
    while (degree > 0 && re[degree * step] == 0 && (real || im[degree * step] == 0)) degree--;
    if (degree < 1 || r || degree > ALGSURF_MOST_ROOTS_IN_LANES ||
        !kernel->one(re, real ? NULL : im, step, degree, roots))
        return algsurf_i_all_roots(re, im, step, r, given, NULL, roots, count, NULL);
    *count = degree;
    return ALGSURF_OK;
}

algsurf_status algsurf_complex_roots(const algsurf_complex *c, const double *r, int degree,
                                     algsurf_complex_root *roots, int *count) {
    if (!c || !roots || !count) return ALGSURF_E_ARGUMENT;
    algsurf_status status = algsurf_i_check_degree(degree);
    if (status == ALGSURF_OK) ALGSURF_STANDARD(status = solve(&c->re, &c->im, 2, r, degree, roots, count));
    return status;
}

algsurf_status algsurf_complex_roots_of_real(const double *c, const double *r, int degree,
                                             algsurf_complex_root *roots, int *count) {
    if (!c || !roots || !count) return ALGSURF_E_ARGUMENT;
    algsurf_status status = algsurf_i_check_degree(degree);
    if (status == ALGSURF_OK) ALGSURF_STANDARD(status = solve(c, NULL, 1, r, degree, roots, count));
    return status;
}
