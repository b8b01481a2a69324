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
void roots_first(const roots_effort *effort, contest_table *table);
void roots_interval(const roots_effort *effort, contest_table *table);
void roots_line(const roots_effort *effort, contest_table *table);
void roots_complex(const roots_effort *effort, contest_table *table);
void roots_families(const roots_effort *effort, contest_table *table);
void roots_pictures(const roots_effort *effort, contest_table *table);

/* Counts roots that are in no box, and boxes that are left without, in the row, and the largest error of
 * simple roots.  A disc must reach the box, a root without a disc must come within 1e-6 of it: of its size,
 * or of `unit` where that is larger. */
void roots_judge(const algsurf_complex_root *box, int boxes, const other_root *root, int roots, double unit,
                 contest_row *row);

enum { ROOTS_AT_ONCE = 1024, ROOTS_FEW = 8 }; /* polynomials in a packet */

/* Polynomials of one degree, to be searched in [-1,1]. */
typedef struct roots_set {
    const char *name;
    int degree;
    size_t count;
    double *c;  /* polynomial by polynomial, lowest power first */
    double *im; /* imaginary parts; null: none */
} roots_set;

/* Along rays of a surface of the catalogue, the chord being [-1,1]. */
void roots_set_of_rays(roots_set *set, const char *surface, size_t count);

/* ((t-a)^2 - e^2), or + e^2, times positive quadratics; a in [-0.9,0.9], e from 1e-2 to 1e-7: a ray that
 * grazes. */
void roots_set_grazing(roots_set *set, const char *name, int degree, size_t count);

/* Parts of coefficients uniform in [-1,1]. */
void roots_set_at_random(roots_set *set, const char *name, int degree, int complex, size_t count);

/* c or im of polynomials begin, begin+1 .., as the library reads them. */
algsurf_table roots_set_rows(const roots_set *set, const double *c, size_t begin);

void roots_set_free(roots_set *set);

#endif
