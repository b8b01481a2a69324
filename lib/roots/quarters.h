/* quarters.h - which parts of an interval can have roots, by Descartes' rule on the quarters of the line. */
#ifndef ALGSURF_QUARTERS_H
#define ALGSURF_QUARTERS_H
#include "coefficients.h"
#include "watch.h"

/* A part of the line.  sign 0: [lo,hi] may have any number of roots.  Else (lo,hi) has exactly one, which is
 * simple, p has this sign before it, and no end is a root. */
typedef struct algsurf_i_part {
    double lo, hi;
    int sign;
} algsurf_i_part;

enum {
    ALGSURF_I_PARTS = 4,
    ALGSURF_I_PARTS_DEGREE = 16
}; /* below, a walk is not much dearer than what may spare it */

/* Halvings of what doubles leave undecided: the most, and before the parts have been looked at, which is
 * cheaper. */
enum { ALGSURF_I_HALVINGS = 3 };
static inline int algsurf_i_halvings_at_first(int degree) {
    return degree < ALGSURF_I_PARTS_DEGREE ? ALGSURF_I_HALVINGS : 0;
}

/* The parts of [lo,hi], lo <= hi, in order, that can have roots of p, which is without radii and has no
 * leading zero; returns their number.  Where the rule does not help that is one, the interval.  watch: null,
 * or who is told of the quarters. */
int algsurf_i_parts_of(const algsurf_i_coefficients *p, double lo, double hi, algsurf_i_part *parts,
                       const algsurf_i_watch *watch);
#endif
