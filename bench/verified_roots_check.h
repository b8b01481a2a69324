/* verified_roots_check.h - what can be said against an answer of a solver without solving again. */
#ifndef VERIFIED_ROOTS_CHECK_H
#define VERIFIED_ROOTS_CHECK_H
#include "verified_roots_input.h"

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

#endif
