/* zerofind_solve.h - the roots along a chord, and how a method of refinement comes to the first of them. */
#ifndef ZEROFIND_SOLVE_H
#define ZEROFIND_SOLVE_H
#include "chord.h"

enum { ZEROFIND_MOST_POINTS = 1002 }; /* the two ends, and the limit of iterations that is the default */

/* An evaluation of the polynomial. */
typedef struct zerofind_point {
    double s, value;
    double s_lo, s_hi; /* the bracket that is known then */
} zerofind_point;

typedef struct zerofind {
    chord chord;
    algsurf_hit hits[ALGSURF_MAX_DEGREE + 1]; /* in increasing t, as algsurf_intersect_all finds them */
    int count;
    zerofind_point points[ZEROFIND_MOST_POINTS]; /* for the first hit: the ends of its bracket, iterates */
    int bracketed;           /* a bracket of the first hit is known: */
    algsurf_bracket bracket; /* of s */
    int point_count; /* 0: there is no hit, it is exactly at an end of the chord, or doubles cannot bracket it:
                        a multiple root, or roots close together */
    int converged;
    double root; /* s of the first hit, as well as double can tell, where there are points */
} zerofind;

/* chord and the rest of `result` are filled.  tolerance: as in algsurf_intersect_options.  Returns OK, or
 * what algsurf_intersect_all says. */
algsurf_status zerofind_solve(const algsurf_surface *surface, const algsurf_extent *extent,
                              const algsurf_ray *ray, const chord *on, algsurf_method method,
                              double tolerance, zerofind *result);

#endif
