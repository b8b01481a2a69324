/* verified_roots_input.h - the polynomials that verified_roots solves. */
#ifndef VERIFIED_ROOTS_INPUT_H
#define VERIFIED_ROOTS_INPUT_H
#include "catalogue.h"
#include "measure.h"

/* p_0 + p_1 X + ... + p_degree X^degree, p_degree not 0, degree > 0; the coefficients are exact. */
typedef struct polynomial {
    int degree;
    algsurf_complex c[ALGSURF_MAX_DEGREE + 1];
    int has_near;
    algsurf_complex near[ALGSURF_MAX_DEGREE]; /* start values from a neighbour, by increasing magnitude */
} polynomial;

/* Polynomials along rays of random pixels of the surface's view in the catalogue, those that meet its
 * extent.  The variable runs over [-1,1] on the chord inside the extent.  Ends the program when it cannot. */
void polynomials_of_rays(const catalogue_entry *entry, measure_random *random, polynomial *p, int count);

/* Complex coefficients, uniform in [-1,1] x [-1,1] i; no neighbours. */
void polynomials_at_random(int degree, measure_random *random, polynomial *p, int count);

#endif
