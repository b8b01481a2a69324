/* zerofind_solve.h - the roots along a ray, and how algsurf_intersect_first comes to the first of them. */
#ifndef ZEROFIND_SOLVE_H
#define ZEROFIND_SOLVE_H
#include "chord.h"

enum {
    ZEROFIND_MOST_CELLS = 1000,
    ZEROFIND_MOST_POINTS = 1010 /* the limit of iterations that is the default, the ends, steps on P itself */
};

/* A part of the ray whose variations of sign were counted. */
typedef struct zerofind_cell {
    double t_lo, t_hi;
    int variations, engine;
    char signs[ALGSURF_MAX_DEGREE + 2]; /* of Bernstein coefficients: + - 0, ? where not known */
} zerofind_cell;

/* An evaluation of the polynomial. */
typedef struct zerofind_point {
    double t, value;
    double t_lo, t_hi; /* the bracket that is known then */
    int is_end, engine;
} zerofind_point;

typedef struct zerofind {
    chord chord;
    algsurf_hit hits[ALGSURF_MAX_DEGREE + 1]; /* in increasing t, as algsurf_intersect_all finds them */
    int count;
    zerofind_cell cells[ZEROFIND_MOST_CELLS]; /* the first of them, in the order of the search */
    int cell_count;
    zerofind_point points[ZEROFIND_MOST_POINTS]; /* for the first hit */
    int point_count;                             /* 0: there is no hit, or it needed none */
    const zerofind_cell *bracket; /* the cell that isolates the first hit; null: there is none */
} zerofind;

/* chord and the rest of `result` are filled.  how: it has no observer.  Returns OK, or what
 * algsurf_intersect_all says. */
algsurf_status zerofind_solve(const algsurf_surface *surface, const algsurf_extent *extent,
                              const algsurf_ray *ray, const chord *on, const algsurf_intersect_options *how,
                              zerofind *result);

#endif
