/* lanes.c - all complex roots of one polynomial: the public calls.
 *
 * Exact polynomials of small degrees go to the lanes first (boxes_template.h); what those leave open, and all
 * others, to allroots.c. */
#include "../base/arithmetic.h"
#include "algsurf/allroots.h"

#include "../base/fpenv.h"
#include "../poly/degree.h"
#include "impl.h"
#include "boxes.h"

/* Real coefficients, one by one as complex ones; large: of more than ALGSURF_MAX_DEGREE. */
#define RUN_REAL(name, most)                                                                                 \
    static ALGSURF_NOINLINE algsurf_status name(const double *c, const double *r, int degree,                \
                                                algsurf_complex_root *roots, int *count) {                   \
        algsurf_complex z[most + 1];                                                                         \
        for (int i = 0; i <= degree; i++) z[i] = (algsurf_complex){c[i], 0};                                 \
        return algsurf_i_all_roots(z, r, degree, 1, NULL, roots, count, NULL);                               \
    }
RUN_REAL(run_real, ALGSURF_MAX_DEGREE)
RUN_REAL(run_large_real, ALGSURF_MAX_POLY_DEGREE)
#undef RUN_REAL

/* In lanes, if they can: exact coefficients k at re[k stride], im[k stride], im null if all are real. */
static int run_in_lanes(const algsurf_i_allroots_kernel *kernel, const double *re, const double *im,
                        int stride, int degree, algsurf_complex_root *roots, int *count) {
    while (degree > 0 && re[degree * stride] == 0 && (!im || im[degree * stride] == 0)) degree--;
    if (degree < 1 || degree > ALGSURF_MOST_ROOTS_IN_LANES) return 0;
    if (!kernel->one(re, im, stride, degree, roots)) return 0;
    *count = degree;
    return 1;
}

static ALGSURF_NOINLINE algsurf_status solve(const algsurf_i_allroots_kernel *kernel,
                                             const algsurf_complex *c, const double *r, int degree,
                                             algsurf_complex_root *roots, int *count) {
    int real = 1;
    for (int k = 0; k <= degree; k++) real = real && c[k].im == 0;
    if (!r && run_in_lanes(kernel, &c->re, real ? NULL : &c->im, 2, degree, roots, count)) return ALGSURF_OK;
    return algsurf_i_all_roots(c, r, degree, 0, NULL, roots, count, NULL);
}

static ALGSURF_NOINLINE algsurf_status solve_real(const algsurf_i_allroots_kernel *kernel, const double *c,
                                                  const double *r, int degree, algsurf_complex_root *roots,
                                                  int *count) {
    if (!r && run_in_lanes(kernel, c, NULL, 1, degree, roots, count)) return ALGSURF_OK;
    return degree <= ALGSURF_MAX_DEGREE ? run_real(c, r, degree, roots, count)
                                        : run_large_real(c, r, degree, roots, count);
}

static const algsurf_i_allroots_kernel *fastest(void) {
    return algsurf_i_allroots_kernel_for(algsurf_i_kernel_find(NULL));
}

algsurf_status algsurf_complex_roots(const algsurf_complex *c, const double *r, int degree,
                                     algsurf_complex_root *roots, int *count) {
    if (!c || !roots || !count) return ALGSURF_E_ARGUMENT;
    algsurf_status status = algsurf_i_check_degree(degree);
    if (status == ALGSURF_OK) ALGSURF_STANDARD(status = solve(fastest(), c, r, degree, roots, count));
    return status;
}

algsurf_status algsurf_complex_roots_of_real(const double *c, const double *r, int degree,
                                             algsurf_complex_root *roots, int *count) {
    if (!c || !roots || !count) return ALGSURF_E_ARGUMENT;
    algsurf_status status = algsurf_i_check_degree(degree);
    if (status == ALGSURF_OK) ALGSURF_STANDARD(status = solve_real(fastest(), c, r, degree, roots, count));
    return status;
}
