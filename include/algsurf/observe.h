/* algsurf/observe.h - watching how roots are found: each interval, each point, by doubles or by integers.
 *
 * Calls that take an observer in their options (algsurf_isolate_options, algsurf_refine_options,
 * algsurf_intersect_options) give the same bits with and without it; without one, watching costs
 * nothing.  (Roots on the whole line, and of degrees 1 and 2, have a shorter way than the search that is
 * shown: without an observer, they take it.  So has P = c Q^k along a ray, in which Q is searched: t_lo and
 * t_hi, the last bits of t, and what the bounded tier leaves undecided differ then.)  Abscissae are the
 * caller's: t of the polynomial, t along the ray.
 *
 * Which cells and points there are may change with a version; what is said of each of them holds.  Roots are
 * isolated in cells: intervals whose variations of sign are counted.  The search begins with one cell or
 * several, which cover the interval or parts of it, and may reach beyond its ends.  A cell with two or more
 * variations is cut, and both parts are cells.  At the end of algsurf_isolate_all without radii, each point
 * of the interval lies in a cell without variations, which holds no root, or in one with one variation,
 * which holds one root, or on an end of these.  A search for the first root ends as soon as that is
 * isolated.
 *     Parts of the interval need no cells if something simpler shows where their roots are: a bound on the
 * roots, the signs of the coefficients, one term that exceeds all those of the other sign, or p_0 = 0.
 *     What doubles leave undecided is searched again in new cells, finally by integers, which always decide.
 * If p and p' have a common factor, the integers may begin again with p's squarefree part, p / gcd(p, p').
 *     A polynomial t^m q(t^k) is searched by way of q: signs and values are those of q.  If k is even, a cell
 * stands for its mirror image, too.
 */
#ifndef ALGSURF_OBSERVE_H
#define ALGSURF_OBSERVE_H
#include <stddef.h>

#include "algsurf/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/* What a cell or a value was computed with. */
typedef enum algsurf_engine {
    ALGSURF_ENGINE_NONE = 0,    /* nothing: there were no cells and no points */
    ALGSURF_ENGINE_DOUBLES = 1, /* doubles with error bounds */
    ALGSURF_ENGINE_INTEGERS = 2 /* integers, which decide what doubles leave undecided */
} algsurf_engine;

/* A sign as far as it is known. */
typedef enum algsurf_sign {
    ALGSURF_SIGN_NEGATIVE = -1, /* below 0 */
    ALGSURF_SIGN_ZERO = 0,      /* exactly 0 */
    ALGSURF_SIGN_POSITIVE = 1,  /* above 0 */
    ALGSURF_SIGN_UNDECIDED = 2  /* error bounds, or radii of coefficients, leave it open */
} algsurf_sign;

/* An interval whose variations of sign were counted.  Made by the library, and valid during the callback; a
 * later version may add members at its end. */
typedef struct algsurf_cell {
    double lo, hi;  /* its ends, rounded if they are not doubles; a common end of two cells is rounded once */
    int variations; /* changes of sign among the Bernstein coefficients on [lo,hi]; undecided signs are chosen
                       so that there are most.  0: no root in (lo,hi), verified.  1, with known signs at both
                       ends: exactly one root, verified */
    int engine;     /* an algsurf_engine */
    int degree;     /* of the polynomial whose coefficients these are */
    const signed char *signs; /* an algsurf_sign for each of its degree + 1 Bernstein coefficients; null for
                                 the places that integers find with radii, which have none */
} algsurf_cell;

/* Told of each cell, in the order of the search; data is the caller's, passed through. */
typedef void (*algsurf_cell_observer)(const algsurf_cell *cell, void *data);

/* Told of each point t at which a method of refinement evaluates p, in order, with the value computed.  If
 * integers evaluate p's squarefree part instead, it is the value of that, times some positive factor.
 * engine: an algsurf_engine. */
typedef void (*algsurf_point_observer)(double t, double value, int engine, void *data);

/* Callbacks, and counts.  Callbacks run in the library's floating-point environment (round to nearest, all
 * exceptions masked) and must leave it as it is, and return; they must not change the observer.  One observer
 * serves one call at a time. */
typedef struct algsurf_observer {
    size_t size;                     /* sizeof(algsurf_observer) */
    algsurf_cell_observer on_cell;   /* null: nobody is told of cells */
    algsurf_point_observer on_point; /* null: nobody is told of points */
    void *data;                      /* the caller's, passed to both */
    size_t cells;                    /* their number; each call adds to it, and none resets it */
    size_t evaluations;              /* the number of points; likewise */
    int engine;                      /* the highest algsurf_engine that was needed; no call lowers it */
} algsurf_observer;

#ifdef __cplusplus
}
#endif
#endif
