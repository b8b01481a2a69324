/* complex_batch.c - all complex roots of many polynomials: side by side (complex/all_boxes_template.h), and
 * what stays undecided one by one. */
#include "../base/arithmetic.h"
#include "algsurf/batch.h"

#include "../base/fpenv.h"
#include "../base/options.h"
#include "../complex/boxes.h"
#include "../poly/value.h"

/* Polynomial i by itself. */
static ALGSURF_NOINLINE algsurf_status solve_alone(const algsurf_complex_batch *p, size_t i,
                                                   algsurf_complex_root *roots, int *count) {
    algsurf_complex c[ALGSURF_MAX_POLY_DEGREE + 1];
    double r[ALGSURF_MAX_POLY_DEGREE + 1], *radii = p->radii.at ? r : NULL;
    algsurf_i_table_row(&p->re, p->degree, i, &c->re, p->im.at ? 2 : 1);
    if (radii) algsurf_i_table_row(&p->radii, p->degree, i, r, 1);
    if (!p->im.at) return algsurf_complex_roots_of_real(&c->re, radii, p->degree, roots, count);
    algsurf_i_table_row(&p->im, p->degree, i, &c->im, 2);
    return algsurf_complex_roots(c, radii, p->degree, roots, count);
}

static algsurf_status solve(const algsurf_i_allroots_kernel *kernel, const algsurf_complex_batch *p,
                            algsurf_complex_root *roots, int *count) {
    algsurf_status first = ALGSURF_OK;
    int in_lanes = !p->radii.at && p->degree > 0 && p->degree <= ALGSURF_MOST_ROOTS_IN_LANES;
    if (in_lanes) kernel->many(&p->re, &p->im, p->degree, p->count, roots, count);
    for (size_t i = 0; i < p->count; i++) {
        if (in_lanes && count[i] >= 0) continue;
        algsurf_status status = solve_alone(p, i, roots + i * (size_t)p->degree, count + i);
        if (status < 0) count[i] = status;
        if (first == ALGSURF_OK) first = status;
    }
    return first;
}

ALGSURF_I_ENTRY(algsurf_status, complex_roots_batch,
                (const algsurf_complex_batch *batch, const algsurf_batch_options *options,
                 algsurf_complex_root *roots, int *count),
                (batch, options, roots, count)) {
    algsurf_complex_batch p;
    algsurf_batch_options o = {.size = sizeof o};
    algsurf_status status = algsurf_options_read(&p, sizeof p, batch);
    if (status == ALGSURF_OK && options) status = algsurf_options_read(&o, sizeof o, options);
    if (status == ALGSURF_OK)
        status = algsurf_i_check_number(o.relative_tolerance, o.relative_tolerance == 0);
    if (status == ALGSURF_OK) status = algsurf_i_check_degree(p.degree);
    if (status != ALGSURF_OK) return status;
    const algsurf_i_kernel *kernel = algsurf_i_kernel_find(o.kernel);
    if (!kernel) return ALGSURF_E_ARGUMENT;
    if (p.count > 0 && !(p.re.at && roots && count)) return ALGSURF_E_ARGUMENT;
    return solve(algsurf_i_allroots_kernel_for(kernel), &p, roots, count);
}
