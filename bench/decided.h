/* decided.h - what the parts of the benchmark decided share. */
#ifndef DECIDED_H
#define DECIDED_H
#include "beside.h"
#include "measure.h"

/* ---- surfaces and rays whose answers are known from how they were made ---- */

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

/* ---- the answers of another edition of the library, made by the script beside ---- */

/* A shared object of beside.c; ends the program when the file is none. */
const beside_edition *beside_load(const char *file);

/* That edition's copy of the example's surface; free it with its surface_free. */
algsurf_surface *beside_surface(const beside_edition *other, const example *e);

/* How many rays it leaves undecided, and of how many it says what is wrong. */
void beside_judge(const beside_edition *other, const example *e, const algsurf_surface *surface,
                  size_t *undecided, size_t *wrong);

/* ---- what was found out ---- */

/* One surface and kind; times in microseconds a ray. */
typedef struct finding {
    const char *surface;
    int degree;
    kind kind;
    size_t rays, open;          /* open: what doubles leave to integers */
    double us, us_low, us_high; /* median; what 10 and 90 % of the rays do not exceed */
    double lanes;               /* of a clear ray by doubles alone, median; NaN: they do not decide it */
    double beside;              /* of the other edition, median; NaN: there is none */
    double ratio;               /* its time of a ray in units of this edition's, median of the rays */
    size_t undecided, wrong;    /* rays that it leaves undecided, or answers wrongly */
} finding;

/* A table; decided.csv and decided.svg, unless the folder is null.  other: what the other edition is called;
 * null: there is none. */
void report(const finding *f, size_t count, const char *other, const char *folder);

#endif
