/* integers.h - integer coefficients in doubles. */
#ifndef ALGSURF_INTEGERS_H
#define ALGSURF_INTEGERS_H
#include "line.h"

/* The integers as c with radii r, up to a power of two, and its degree without leading zeros; no r is set
 * where c is exact.  Returns 0 where exponents differ too much for doubles, or the degree is above
 * ALGSURF_MAX_DEGREE. */
int algsurf_i_integers_round(const algsurf_i_line *line, double *c, double *r, int *degree);

/* Simple roots in brackets b, near those of the rounded polynomial, become those of the integers; returns how
 * many do, from the first on. */
int algsurf_i_integers_close_in(const algsurf_i_line *line, const algsurf_bracket *b, int count,
                                algsurf_real_root *roots);
#endif
