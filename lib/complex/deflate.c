/* deflate.c - all roots one after the other: approximate, polish, verify, deflate.
 *
 * A root is approximated on the deflated polynomial, whose rounded coefficients no guarantee may rest on;
 * then polished and verified on the original one.  The deflated polynomial is divided by the root
 * approximated on it (that quotient is what the approximation leaves), not by the polished one, because that
 * keeps its backward error small.  A root that did not converge is divided out all the same: at a multiple
 * root the iteration misses its stopping test and yet is close.  Polishing may slide onto a root already
 * found: whether the boxes are all the roots is decided at the end, by whether they are disjoint.
 */
#include "../base/arithmetic.h"
#include "papers.h"
#include "../base/fpenv.h"
#include "../poly/interval_impl.h"

static const algsurf_complex cold_start = {0, 1};

static int all_disjoint(const algsurf_paper_zero *zeros, int n) {
    for (int i = 0; i < n; i++) {
        if (!zeros[i].verified) return 0;
        for (int j = 0; j < i; j++)
            if (algsurf_i_cinterval_valid(algsurf_i_cinterval_meet(zeros[i].box, zeros[j].box))) return 0;
    }
    return 1;
}

/* The number in the box nearest to x. */
static double nearest(algsurf_interval box, double x) { return fmin(fmax(x, box.lo), box.hi); }

/* From an approximation to a root of p with what is proved of it. */
static algsurf_paper_zero finish(const algsurf_complex *p, const double *r, int n, algsurf_complex near,
                                 const algsurf_paper_options *options) {
    algsurf_complex q[ALGSURF_MAX_POLY_DEGREE];
    algsurf_paper_zero zero;
    zero.converged =
        algsurf_i_paper_approximation(p, n, near, options, &zero.root, q, &zero.steps) == ALGSURF_OK;
    zero.root = (algsurf_complex){zero.root.re + 0.0, zero.root.im + 0.0}; /* no -0 */
    zero.unique = 0;
    zero.verified = algsurf_i_paper_inclusion(p, r, n, zero.root, q, options, &zero.box, NULL, &zero.unique,
                                              &zero.inflations) == ALGSURF_OK;
    if (zero.verified)
        zero.root = (algsurf_complex){nearest(zero.box.re, zero.root.re), nearest(zero.box.im, zero.root.im)};
    else
        zero.box = (algsurf_cinterval){{zero.root.re, zero.root.re}, {zero.root.im, zero.root.im}};
    return zero;
}

ALGSURF_I_ENTRY(algsurf_status, paper_zeros,
                (const algsurf_complex *p, const double *r, int degree, const algsurf_complex *start,
                 const algsurf_paper_options *given, algsurf_paper_zero *zeros, int *complete),
                (p, r, degree, start, given, zeros, complete)) {
    algsurf_paper_options options;
    algsurf_complex deflated[ALGSURF_MAX_POLY_DEGREE + 1], q[ALGSURF_MAX_POLY_DEGREE], z;
    algsurf_status status = algsurf_i_paper_check(p, r, degree, given, &options);
    if (status != ALGSURF_OK) return status;
    for (int i = 0; start && i < degree; i++)
        if (!algsurf_i_finite(start[i])) return ALGSURF_E_NOT_FINITE;
    if (!zeros || !complete) return ALGSURF_E_ARGUMENT;
    if (algsurf_i_size(p[degree]) == 0) return ALGSURF_E_ARGUMENT;
    for (int k = 0; k <= degree; k++) deflated[k] = p[k];
    for (int i = 0, n = degree; i < degree; i++, n--) {
        int steps;
        int converged = algsurf_i_paper_approximation(deflated, n, start ? start[i] : cold_start, &options,
                                                      &z, q, &steps) == ALGSURF_OK;
        for (int k = 0; k < n; k++) deflated[k] = q[k];
        zeros[i] = finish(p, r, degree, z, &options);
        zeros[i].converged = zeros[i].converged && converged;
        zeros[i].steps += steps;
    }
    *complete = all_disjoint(zeros, degree);
    return ALGSURF_OK;
}
