/* all_boxes_template.h - all complex roots: the entry points of a kernel. */
#ifndef ALGSURF_COMPLEX_ALL_BOXES_TEMPLATE_H
#define ALGSURF_COMPLEX_ALL_BOXES_TEMPLATE_H
#include "../poly/table_template.h"
#include "../simd/degrees.h"
#include "boxes.h"
#include "many_template.h"
#include "quadratic_template.h"

#define DEGREES_3_AND_4(statement) FOR_ONE_DEGREE(3, statement) FOR_ONE_DEGREE(4, statement)

APART int solve_one_real(const double *re, int stride, int n, algsurf_complex_root *roots) {
    polynomials p;
    p.real = 1;
    for (int k = 0; k <= n; k++) p.re[k] = all_lanes(re[k * stride]), p.im[k] = all_lanes(0);
    if (n == 2) return solve_quadratics(&p, 1, roots, 0) != 0;
    if (n > MOST_ROOTS) __builtin_unreachable();
    FOR_DEGREES(DEGREES_OF_ROOTS, n, return solve_boxes(&p, (layout){N, 1}, 1, roots, 0) != 0,
                DEGREES_3_AND_4(return solve_boxes(&p, (layout){N, 1}, 1, roots, 0) != 0)
                    FOR_ONE_DEGREE(6, return solve_boxes(&p, (layout){N, 1}, 1, roots, 0) != 0)
                        FOR_ONE_DEGREE(10, return solve_boxes(&p, (layout){N, 1}, 1, roots, 0) != 0))
}

APART int solve_one_complex(const double *re, const double *im, int stride, int n,
                            algsurf_complex_root *roots) {
    polynomials p;
    p.real = 0;
    for (int k = 0; k <= n; k++) p.re[k] = all_lanes(re[k * stride]), p.im[k] = all_lanes(im[k * stride]);
    if (n < 1 || n > MOST_ROOTS) __builtin_unreachable();
    return solve_boxes(&p, (layout){n, 1}, 1, roots, 0) != 0;
}

APART unsigned solve_real(polynomials *p, int n, unsigned wanted, algsurf_complex_root *roots) {
    p->real = 1;
    if (n == 2) return solve_quadratics(p, wanted, roots, 2);
    if (n > MOST_ROOTS) __builtin_unreachable();
    FOR_DEGREES(DEGREES_OF_ROOTS, n, return solve_boxes(p, (layout){N, 0}, wanted, roots, (size_t)N),
                DEGREES_3_AND_4(return solve_boxes(p, (layout){N, 0}, wanted, roots, (size_t)N)))
}

APART unsigned solve_complex(polynomials *p, int n, unsigned wanted, algsurf_complex_root *roots) {
    p->real = 0;
    if (n < 1 || n > MOST_ROOTS) __builtin_unreachable();
    return solve_boxes(p, (layout){n, 0}, wanted, roots, (size_t)n);
}

static int solve_one(const double *re, const double *im, int stride, int n, algsurf_complex_root *roots) {
    return im ? solve_one_complex(re, im, stride, n, roots) : solve_one_real(re, stride, n, roots);
}

static void solve_many(const algsurf_table *re, const algsurf_table *im, int n, size_t count,
                       algsurf_complex_root *roots, int *found) {
    for (size_t at = 0; at < count; at += LANES) {
        int many = count - at < LANES ? (int)(count - at) : LANES;
        unsigned wanted = (1u << many) - 1;
        polynomials p;
        mask real = ~no_lane();
        for (int k = 0; k <= n; k++) {
            p.re[k] = load_table(re, k, at, many);
            p.im[k] = im->at ? load_table(im, k, at, many) : all_lanes(0);
            if (im->at) real &= is_zero(p.im[k]);
        }
        algsurf_complex_root *to = roots + at * (size_t)n;
        unsigned solved = !(wanted & ~bits(real)) ? solve_real(&p, n, wanted, to)
                                                  : solve_complex(&p, n, wanted & ~bits(real), to);
        for (int l = 0; l < many; l++) found[at + (size_t)l] = solved >> l & 1 ? n : -1;
    }
}

const algsurf_i_allroots_kernel KERNEL(algsurf_i_allroots) = {solve_one, solve_many, approach, values};

#endif
