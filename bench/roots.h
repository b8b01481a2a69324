/* roots.h - what the parts of the comparison of root finders share: effort, and sets of polynomials. */
#ifndef ROOTS_H
#define ROOTS_H
#include "algsurf/algsurf.h"
#include "contest.h"
#include "roots_others.h"

/* How much is done. */
typedef struct roots_effort {
    int takes;
    size_t real, complex; /* polynomials in a set */
    double budget;        /* seconds that a take of one contestant may last, more or less */
    int most_degree;      /* of random polynomials */
    int most_of_family;   /* degree */
    int patience;         /* seconds that a program has for a polynomial of a family */
} roots_effort;

/* The contests, each a section of the table or two. */
typedef void roots_contests(const roots_effort *effort, contest_table *table);
roots_contests roots_first, roots_interval, roots_line, roots_complex, roots_families, roots_pictures;

/* ---- sets of polynomials ---- */

/* Searched in [-1,1], or on the line. */
typedef struct roots_set {
    const char *name;
    int degree; /* the largest */
    size_t count;
    int *degrees,
        *real;  /* of each, where they differ: degree, and number of different real roots; else null */
    double *c;  /* degree + 1 numbers for each, lowest power first */
    double *im; /* imaginary parts; null: none */
} roots_set;

/* So many, all zero. */
void roots_set_open(roots_set *set, const char *name, int degree, int complex, size_t count);

/* Along rays of a surface of the catalogue, the chord being [-1,1]. */
void roots_set_of_rays(roots_set *set, const char *surface, size_t count);

/* ((t-a)^2 - e^2), or + e^2, times positive quadratics; a in [-0.9,0.9], e from 1e-2 to 1e-7: a ray that
 * grazes. */
void roots_set_grazing(roots_set *set, const char *name, int degree, size_t count);

/* Parts of coefficients uniform in [-1,1]. */
void roots_set_at_random(roots_set *set, const char *name, int degree, int complex, size_t count);

/* c or im of polynomial i; of polynomials begin, begin+1 .., as the library reads them. */
double *roots_set_at(const roots_set *set, double *c, size_t i);
algsurf_table roots_set_rows(const roots_set *set, double *c, size_t begin);

void roots_set_free(roots_set *set);

/* ---- who solves them ---- */

typedef struct roots_solver roots_solver;
struct roots_solver {
    const char *program;
    void (*solve)(const roots_solver *self, size_t begin, size_t end);
    size_t packet; /* polynomials that it takes at once; 0: as many as there are */
    union {
        other_first *first;
        other_refine *refine;
        other_interval *interval;
        other_all *all;
        other_line *line;
    } by;
    int proves;                 /* its answers must be right */
    int real_only, most_degree; /* where it takes no others; 0: it does */
    const roots_set *on;
    int *count; /* of the answers to each polynomial; and room for `degree` of them: */
    double *real;
    other_root *root;
    algsurf_complex_root *box;
};

enum { ROOTS_AT_ONCE = 1024, ROOTS_FEW = 8 }; /* polynomials in a packet */

typedef struct roots_contest {
    const char *section, *unit;
    const roots_solver *solvers; /* what the first of them finds is right */
    size_t count;
    void (*judge)(const roots_solver *s, const roots_solver *first, contest_row *row);
    int whole; /* everybody gets to the end of the set, not the first only */
} roots_contest;

void roots_contend(const roots_contest *contest, const roots_set *on, const roots_effort *effort,
                   contest_table *table);

/* Counts roots that are in no box, and boxes that are left without, in the row, and the largest error of
 * simple roots.  A disc must reach the box, a root without a disc must come within 1e-6 of it: of its size,
 * or of `unit` where that is larger. */
void roots_judge(const algsurf_complex_root *box, int boxes, const other_root *root, int roots, double unit,
                 contest_row *row);

/* The end of the program, if who proves its answers contradicts this library. */
void roots_check(const char *program, int proves, const contest_row *row);

#endif
