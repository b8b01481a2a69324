/* boxes.h - all complex roots in lanes, by every kernel. */
#ifndef ALGSURF_COMPLEX_BOXES_H
#define ALGSURF_COMPLEX_BOXES_H
#include <stddef.h>

#include "../simd/kernel.h"
#include "algsurf/allroots.h"

#define ALGSURF_MOST_ROOTS_IN_LANES 24

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
} algsurf_i_allroots_kernel;

ALGSURF_KERNEL_TABLES(allroots);

#endif
