/* roots_line.h - a line of input becomes a polynomial, and a polynomial the rows of its roots. */
#ifndef ROOTS_LINE_H
#define ROOTS_LINE_H
#include "cli.h"
#include "roots_fraction.h"

enum { ROOTS_MAX_FIELDS = ALGSURF_MAX_POLY_DEGREE + 1 };

typedef struct roots_interval {
    double lo, hi; /* may be infinite */
    int given;
} roots_interval;

/* The polynomial of a line, times a positive number. */
typedef struct roots_polynomial {
    int degree;                          /* without leading zeros */
    int real;                            /* all imaginary parts are 0 */
    algsurf_complex c[ROOTS_MAX_FIELDS]; /* lowest degree first */
    int off;                             /* c is rounded; exact are the integers: */
    algsurf_integer integer[ROOTS_MAX_FIELDS], imaginary[ROOTS_MAX_FIELDS];
    roots_fraction part[2 * ROOTS_MAX_FIELDS]; /* as the line has it: re, im */
    uint64_t *limbs;                           /* of the integers; to be freed */
    size_t capacity;
} roots_polynomial;

/* Why there is no answer to a line. */
typedef struct roots_complaint {
    char text[192];
} roots_complaint;

/* A root or a cluster of roots: the box is proved to hold so many. */
typedef struct roots_row {
    algsurf_complex value;
    algsurf_cinterval box;
    int multiplicity;
} roots_row;

/* The polynomial in a line's `count` fields, exactly or with its numbers rounded to doubles; 0 and a
 * complaint when there is none. */
int roots_parse(char *const *field, int count, int rounded, roots_polynomial *p, roots_complaint *why);

/* All complex roots: at most ALGSURF_MAX_POLY_DEGREE rows.  Returns their number, -1 and a complaint when
 * there is no answer. */
int roots_all(const roots_polynomial *p, roots_row *rows, roots_complaint *why);

/* The same for the real roots in an interval, in increasing order; tolerance 0: as narrow as doubles allow.
 */
int roots_real(const roots_polynomial *p, const roots_interval *where, double tolerance, roots_row *rows,
               roots_complaint *why);

/* The roots of an exact polynomial to so many bits: all, or the real ones in an interval if it is given.
 * Their numbers go to index; *roots is to be freed where there are any.  Returns how many, -1 and a complaint
 * when there is no answer. */
int roots_precisely(const roots_polynomial *p, const roots_interval *where, int bits,
                    algsurf_precise_roots **roots, int *index, roots_complaint *why);

#endif
