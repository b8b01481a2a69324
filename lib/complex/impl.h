/* impl.h - all complex roots of one polynomial, by the second engine. */
#ifndef ALGSURF_ALLROOTS_IMPL_H
#define ALGSURF_ALLROOTS_IMPL_H
#include "algsurf/allroots.h"
#include "../poly/integral.h"

/* algsurf_complex_solver_run in the standard environment.  Coefficient k is re[k step] + i im[k step], with
 * step 1, im null, or 2, im = re + 1 or null: then it is real, and so is what its radius means.  start may be
 * null.  24 KiB of stack, and memory from elsewhere where that does not suffice. */
algsurf_status algsurf_i_all_roots(const double *re, const double *im, int step, const double *r, int degree,
                                   const algsurf_complex *start, algsurf_complex_root *roots, int *count,
                                   algsurf_complex_solver_stats *stats);

/* The roots but 0 of a polynomial of integers, to as many bits as `roots` wants; *at_zero: how many are 0. */
algsurf_status algsurf_i_find_precise_roots(const algsurf_integer *re, const algsurf_integer *im, int degree,
                                            size_t limit, algsurf_precise_roots *roots, int *at_zero);

#define ALGSURF_I_COMPLEX_MEMORY ((size_t)1 << 30) /* bytes */

#define ALGSURF_I_MOST_SWEEPS 1000

/* The only root of a polynomial in the open interval (a, b) 2^-r, at whose ends it has different signs; b
 * null: the point a 2^-r. */
typedef struct algsurf_i_root_on_axis {
    algsurf_limb *a, *b;
    int width, r;
} algsurf_i_root_on_axis;
/* All real roots of f, which is squarefree and of a degree of at least 3, in increasing order; `at` has room
 * for the degree.  *count -1: `most` sweeps did not find them. */
int algsurf_i_roots_on_axis(algsurf_memory *m, const algsurf_zpoly *f, int most, algsurf_i_root_on_axis *at,
                            int *count);

#endif
