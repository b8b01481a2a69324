/* seed_rivals.h - ways from a bracket to a root: the library's, and rivals that are no part of it. */
#ifndef SEED_RIVALS_H
#define SEED_RIVALS_H
#include "algsurf/algsurf.h"

/* As algsurf_refine_poly without radii, whose arguments a rival takes for granted: a bracket with different
 * signs at its finite ends, and options. */
typedef algsurf_status seed_solver(const double *c, int degree, double lo, double hi,
                                   const algsurf_refine_options *options, algsurf_refined_root *result);

typedef struct seed_method {
    const char *name;
    seed_solver *solve;
    int method;   /* for the library's */
    int library;  /* else a rival */
    int may_fail; /* its stopping rule cannot tell near from slow: its wrong roots are counted */
} seed_method;

enum { SEED_BISECTION, SEED_REGULA_FALSI, SEED_BRENT, SEED_DEFAULT, SEED_OWN, SEED_METHODS = 7 };

/* SEED_OWN of the library, then the rivals. */
extern const seed_method seed_methods[SEED_METHODS];

/* One of them, with a wanted half width and at most so many iterations. */
algsurf_status seed_solve(const seed_method *method, const double *c, int degree, double lo, double hi,
                          double tolerance, int most, algsurf_refined_root *result);

/* Plain false position that does not stop where it only hardly moves: at the limit of iterations, at
 * |p| <= small, or when the bracket is as narrow as is wanted, which as a rule it never is. */
algsurf_status seed_false_position(const double *c, int degree, double lo, double hi, double tolerance,
                                   double small, int most, algsurf_refined_root *result);

/* p, and its derivative if slope is not null. */
double seed_value(const double *c, int degree, double x, double *slope);

#endif
