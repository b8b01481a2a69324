/* verified_roots.h - what the parts of the benchmark verified_roots share; its test uses two of them. */
#ifndef VERIFIED_ROOTS_H
#define VERIFIED_ROOTS_H
#include "catalogue.h"
#include "measure.h"

/* ---- the polynomials ---- */

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

/* ---- what can be said against an answer of a solver without solving again ---- */

typedef struct answer_root {
    algsurf_cinterval box;
    algsurf_complex value;
    int multiplicity; /* how many roots the box is said to hold, at least; 0: nothing is proved of it */
    int simple;       /* it is said to hold a simple root and no other */
} answer_root;

typedef struct answer {
    int count;
    int complete; /* it is said that the boxes are disjoint and hold all roots */
    answer_root root[ALGSURF_MAX_DEGREE];
} answer;

/* Null, or what contradicts an answer, a static text.  Values are in their boxes.  Complete: multiplicities
 * add up to the degree, boxes are disjoint, and p_degree times the product of all (X - box), each as often as
 * its multiplicity says, holds p. */
const char *contradiction(const polynomial *p, const answer *a);

/* The same of two answers: a box in which a root is proved meets one of the complete answer; if a is complete
 * too, also the other way round. */
const char *contradiction_between(const answer *a, const answer *complete);

/* How many roots are proved to be simple: boxes that say so, and of those that meet only the first, because
 * they may hold the same root. */
int simple_roots(const answer *a);

/* ---- what was found out ---- */

/* One solver and start on one family of polynomials. */
typedef struct row {
    char family[24];
    const char *solver, *start;
    int degree, cluster; /* cluster 0: a family without */
    double gap;
    size_t polynomials;
    double complete, simple; /* per cent */
    double ulps50, ulps99;   /* NaN: no box was verified */
    double widest;           /* of a polynomial's verified boxes, real or imaginary part: median */
    double us;
} row;

/* A table; verified_roots.csv, verified_roots_degree.svg, verified_roots_cluster.svg, unless the folder is
 * null. */
void report(const row *rows, int count, int seed, int tsv, const char *folder);

#endif
