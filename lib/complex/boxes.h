/* boxes.h - all complex roots in lanes, by every kernel. */
#ifndef ALGSURF_COMPLEX_BOXES_H
#define ALGSURF_COMPLEX_BOXES_H
#include <stddef.h>
#include <stdint.h>

#include "../simd/kernel.h"
#include "algsurf/allroots.h"

#define ALGSURF_MOST_ROOTS_IN_LANES 24

/* A polynomial of any degree in doubles: coefficient k of p is (re_k + i im_k) 2^(top - k unit). */
typedef struct algsurf_i_flat {
    int n, exact;      /* exact: nothing is rounded but what is below 2^-1000 */
    int64_t unit, top; /* no part exceeds 2 */
    const double *re, *im, *size,
        *noise; /* n+1; size: magnitudes; noise: 2^53 times what values are off by */
} algsurf_i_flat;

/* Approximations of its roots, in units of 2^unit, and steps that make them better ones. */
typedef struct algsurf_i_approach {
    const algsurf_i_flat *p;
    double *x, *y, *step_x, *step_y;
    int *state;
} algsurf_i_approach;
enum {
    ALGSURF_I_MOVES,
    ALGSURF_I_RESTS,   /* no more steps are needed */
    ALGSURF_I_BLURRED, /* nor are they possible: p is lost in rounding, and other points may be as near */
    ALGSURF_I_LOST     /* there is no step */
};

/* For exact coefficients and degrees 1 to ALGSURF_MOST_ROOTS_IN_LANES.  Roots are simple and in order; what
 * is not proved is left to allroots.c.  Both give the same bits. */
typedef struct algsurf_i_allroots_kernel {
    /* One polynomial, coefficient k at re[k stride] and im[k stride]; im null: real.  Whether it is solved.
     */
    int (*one)(const double *re, const double *im, int stride, int n, algsurf_complex_root *roots);
    /* `count` polynomials, im.at null: all are real; the roots of number i are roots[i n + k].  found[i]
     * becomes n, or -1 where roots are not solved. */
    void (*many)(const algsurf_table *re, const algsurf_table *im, int n, size_t count,
                 algsurf_complex_root *roots, int *found);
    /* Ehrlich's and Aberth's steps of the `count` points that `who` names; reversed: by the polynomial of the
     * inverse roots. */
    void (*approach)(const algsurf_i_approach *a, const int *who, int count, int reversed);
    /* p at `count` points, |z| >= 2^-500 or 0, in doubled precision: off by 32 n (n + 2) u^2 sum + u |p|, sum
     * >= sum |c_k| |z|^k, and by less than 2^-950 max(1,|z|)^n for what underflows.  What overflows is no
     * number, or infinite. */
    void (*values)(const algsurf_i_flat *p, const double *x, const double *y, int count, double *re,
                   double *im, double *sum);
} algsurf_i_allroots_kernel;

ALGSURF_KERNEL_TABLES(allroots);

#endif
