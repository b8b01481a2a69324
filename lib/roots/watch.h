/* watch.h - what a call tells its observer (algsurf/observe.h).
 *
 * Code that can be watched has a pointer to a watch, null if there is no observer.  Packets of more than two
 * lanes are never watched: there it costs nothing. */
#ifndef ALGSURF_WATCH_H
#define ALGSURF_WATCH_H
#include "algsurf/observe.h"

typedef struct algsurf_i_watch {
    algsurf_observer *observer;
    double lo, hi; /* what lanes know as 0 and 1 */
    int exponent;  /* values are told times 2^exponent */
    int power;     /* above 1: cells and points are those of a polynomial in t^power */
} algsurf_i_watch;

/* Has the caller's observer, or null, a size? */
algsurf_status algsurf_i_observer_check(const algsurf_observer *observer);

/* The place in [0,1] as the caller knows it. */
double algsurf_i_watched_place(const algsurf_i_watch *watch, double place);

/* The most variations of the signs -1, 0, 1, ALGSURF_SIGN_UNDECIDED that a choice of the undecided ones
 * allows: each as the opposite of the one before it.  That gains one and costs at most one, later. */
int algsurf_i_most_variations(const signed char *signs, int degree);

void algsurf_i_tell_cell(const algsurf_i_watch *watch, const algsurf_cell *cell);

/* value 2^exponent at t; what is not zero stays so. */
void algsurf_i_tell_point(const algsurf_i_watch *watch, double t, double value, int exponent, int engine);

#endif
