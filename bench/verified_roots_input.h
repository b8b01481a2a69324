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

/* The same with neighbours, whose coefficients differ by up to 2^-10 of their size: about as much as those of
 * two rays through adjacent pixels. */
void polynomials_with_neighbours(int degree, measure_random *random, polynomial *p, int count);

/* Leading coefficient 1, roots in the unit disc at places whose parts are multiples of 1/8, all different. At
 * the first of them stand `cluster` roots instead of one, on a circle about it, each `gap` from the next; the
 * coefficients are those of the product, rounded, which moves the roots of a cluster by about
 * (2^-53)^(1/cluster) more.  gap 0: a multiple root, exactly; degree <= 12.  No neighbours. */
void polynomials_with_cluster(int degree, int cluster, double gap, measure_random *random, polynomial *p,
                              int count);

#endif
