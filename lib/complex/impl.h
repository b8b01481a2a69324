/* impl.h - all complex roots of one polynomial, by the second engine. */
#ifndef ALGSURF_ALLROOTS_IMPL_H
#define ALGSURF_ALLROOTS_IMPL_H
#include "algsurf/allroots.h"

/* algsurf_complex_solver_run in the standard environment.  real_radii: those of real coefficients mean real
 * numbers. start may be null.  24 KiB of stack, and memory from elsewhere where that does not suffice. */
algsurf_status algsurf_i_all_roots(const algsurf_complex *c, const double *r, int degree, int real_radii,
                                   const algsurf_complex *start, algsurf_complex_root *roots, int *count,
                                   algsurf_complex_solver_stats *stats);

/* The roots but 0 of a polynomial of integers, to as many bits as `roots` wants; *at_zero: how many are 0. */
algsurf_status algsurf_i_find_precise_roots(const algsurf_integer *re, const algsurf_integer *im, int degree,
                                            size_t limit, algsurf_precise_roots *roots, int *at_zero);

#define ALGSURF_I_COMPLEX_MEMORY ((size_t)1 << 30) /* bytes */

#endif
