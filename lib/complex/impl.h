/* impl.h - all complex roots of one polynomial, by the second engine. */
#ifndef ALGSURF_ALLROOTS_IMPL_H
#define ALGSURF_ALLROOTS_IMPL_H
#include "algsurf/allroots.h"

/* algsurf_complex_solver_run in the standard environment.  real_radii: those of real coefficients mean real
 * numbers. start may be null.  24 KiB of stack, and memory from elsewhere where that does not suffice. */
algsurf_status algsurf_i_all_roots(const algsurf_complex *c, const double *r, int degree, int real_radii,
                                   const algsurf_complex *start, algsurf_complex_root *roots, int *count,
                                   algsurf_complex_solver_stats *stats);
#endif
