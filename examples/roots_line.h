/* roots_line.h - a line of input becomes a polynomial, and a polynomial the rows of its roots. */
#ifndef ROOTS_LINE_H
#define ROOTS_LINE_H
#include "cli.h"

enum { ROOTS_MAX_FIELDS = ALGSURF_MAX_POLY_DEGREE + 1 };

typedef struct roots_interval {
    double lo, hi; /* may be infinite */
    int given;
} roots_interval;

typedef struct roots_polynomial {
    algsurf_complex c[ROOTS_MAX_FIELDS]; /* lowest degree first */
    int degree;                          /* without leading zeros */
} roots_polynomial;

/* A root or a cluster of roots, or a place that may hold some. */
typedef struct roots_row {
    algsurf_complex value;
    algsurf_cinterval box;
    int multiplicity; /* 0: not known */
    int verified;     /* the box is proved to hold exactly so many roots (a real one, if that is not known) */
} roots_row;

/* The polynomial in a line's `count` fields; 0 and a complaint when there is none. */
int roots_parse(size_t line, char *const *field, int count, roots_polynomial *p);

/* All complex roots: at most ALGSURF_MAX_POLY_DEGREE rows.  Returns their number, -1 after a complaint. */
int roots_all(size_t line, algsurf_root_solver *solver, const roots_polynomial *p, roots_row *rows);

/* The same for the real roots in an interval, in increasing order. */
int roots_real(size_t line, const roots_polynomial *p, const roots_interval *where, double tolerance,
               roots_row *rows);

#endif
