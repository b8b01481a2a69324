/* roots_others.h - other people's root finders behind a few signatures.  One file for each package; only
 * those that are installed are compiled (see bench/roots).
 *
 * Coefficients come lowest degree first, the leading one is not 0; degree <= ALGSURF_MAX_DEGREE where roots
 * of doubles are wanted.
 */
#ifndef ROOTS_OTHERS_H
#define ROOTS_OTHERS_H
#include "algsurf/poly.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct other_root {
    double re, im;
    double radius; /* of a disc that the solver says holds the root; NaN: it says nothing */
} other_root;

/* The least real root in [-1,1]; NaN: none. */
typedef double other_first(const double *c, int degree);

/* The real roots in [-1,1], each once, in increasing order; returns how many. */
typedef int other_interval(const double *c, int degree, double *roots);

/* The number of different real roots, by isolating or by counting them. */
typedef int other_line(const double *c, int degree);

/* The root in [lo,hi], the signs at its ends being opposite, to half of an interval of 2 tolerance. */
typedef double other_refine(const double *c, int degree, double lo, double hi, double tolerance);

/* All roots, by multiplicity; returns how many came.  im null: the coefficients are real. */
typedef int other_all(const double *re, const double *im, int degree, other_root *roots);

/* The same for integers of any length; degree <= ALGSURF_MAX_POLY_DEGREE. */
typedef int other_integers(const algsurf_integer *re, const algsurf_integer *im, int degree,
                           other_root *roots);

other_first by_gsl_first, by_pari_first, by_cy_first;
other_interval by_gsl_interval, by_arb_interval, by_pari_interval, by_cy_interval;
other_line by_flint_isolated, by_flint_counted, by_pari_isolated, by_pari_counted;
other_refine by_toms748;
other_all by_gsl_all, by_arb_all, by_mpsolve_isolate, by_mpsolve_approximate, by_pari_all;
other_integers by_arb_integers, by_pari_integers, by_mpsolve_secular_isolate, by_mpsolve_secular_approximate,
    by_mpsolve_classic_isolate, by_mpsolve_classic_approximate;

/* Those in [-1,1] among all roots, in increasing order: those count as real whose imaginary part is exactly
 * 0. */
int others_in_interval(const other_root *roots, int count, double *real);

#ifdef __cplusplus
}
#endif
#endif
