/* decided_cases.h - surfaces and rays whose answers are known from how they were made. */
#ifndef DECIDED_CASES_H
#define DECIDED_CASES_H
#include "algsurf/algsurf.h"
#include "measure.h"

/* What makes a ray hard. */
typedef enum kind {
    KIND_CLEAR,   /* nothing: one simple root */
    KIND_END,     /* it begins at the double before the root */
    KIND_GAP_20,  /* two roots, about 2^-20 of the extent apart */
    KIND_GAP_60,  /* 2^-60 */
    KIND_GAP_200, /* 2^-200 */
    KIND_TANGENT, /* it touches the surface */
    KIND_DOUBLE,  /* the surface is P = Q^2 */
    KIND_INSIDE,  /* it lies in the surface */
    KIND_BALL,    /* the surface is that of the extent */
    KINDS
} kind;
extern const char *const kind_names[KINDS];

/* A surface inside an extent, and rays that have the same answer. */
typedef struct example {
    const char *surface; /* its name, or "random" */
    int degree;
    kind kind;
    algsurf_surface *equation;
    algsurf_extent extent;
    size_t count;
    algsurf_ray *ray;
    double *t;        /* where the first hit is, to 1e-3 */
    int multiplicity; /* of all roots: of each */
    int least, most;  /* how many roots */
} example;

/* A random surface with all coefficients, of even degree; the same for the same arguments. */
void example_random(example *e, int degree, kind which, size_t count, int seed);

/* A surface of the catalogue, KIND_CLEAR or KIND_END: rays of its view that double arithmetic proves to
 * hit it, at a place where the sign of P changes. */
void example_named(example *e, const char *name, kind which, size_t count, int seed);

/* Is that where the first hit of ray i is? */
int example_hit_at(const example *e, size_t i, double t);

void example_free(example *e);

#endif
