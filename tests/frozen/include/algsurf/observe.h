/* algsurf/observe.h - how roots are found: each interval that is looked at, each point, and who decides.
 *
 * Calls that take an observer in their options (algsurf_isolate_options, algsurf_refine_options,
 * algsurf_intersect_options) run alike with and without it, and give the same bits; without one,
 * watching costs nothing.  Abscissae are the caller's: t of the polynomial, t along the ray.
 *
 * Isolation looks at cells.  It begins with the whole interval, or with parts of it, and cuts what has two
 * variations of sign or more; both parts are cells.  After algsurf_isolate_all, without radii, each point of
 * the interval lies in a cell without variations, in one with one variation, which holds one root, or on an
 * end of these; a search for the first root ends sooner.  There are no cells where something simpler decides:
 * a bound on the roots, one term that exceeds all others, a zero coefficient p_0.  A cell may reach beyond
 * the interval.  Where doubles leave something undecided there are further cells of the same places, at last
 * those of the integers, which always decide; these begin again with p's squarefree part where p shares a
 * factor with p'.  Of a polynomial t^m q(t^k) it is q that is looked at: signs and values are q's, and where
 * k is even, cells stand for their mirror images, too.
 */
#ifndef ALGSURF_OBSERVE_H
#define ALGSURF_OBSERVE_H
#include <stddef.h>

#include "algsurf/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Who looks, and who decides. */
typedef enum algsurf_engine {
    ALGSURF_ENGINE_NONE = 0,    /* nobody had to: no cells, no points */
    ALGSURF_ENGINE_DOUBLES = 1, /* doubles with error bounds */
    ALGSURF_ENGINE_INTEGERS = 2 /* integers: what doubles leave undecided */
} algsurf_engine;

/* A sign as far as it is known. */
typedef enum algsurf_sign {
    ALGSURF_SIGN_NEGATIVE = -1, /* below 0 */
    ALGSURF_SIGN_ZERO = 0,      /* exactly 0 */
    ALGSURF_SIGN_POSITIVE = 1,  /* above 0 */
    ALGSURF_SIGN_UNDECIDED = 2  /* error bounds, or radii of coefficients, leave it open */
} algsurf_sign;

/* An interval whose variations of sign were counted.  Made by the library, for the length of a callback; may
 * grow at its end. */
typedef struct algsurf_cell {
    double lo, hi;  /* its ends, rounded where they are no doubles; those of neighbours are the same */
    int variations; /* of sign of the Bernstein coefficients on [lo,hi]; of undecided signs those that give
                       the most.  Verified: 0, no root in (lo,hi); 1, the signs at both ends known, one */
    int engine;     /* an algsurf_engine */
    int degree;     /* of the polynomial looked at */
    const signed char *signs; /* an algsurf_sign for each of its degree + 1 Bernstein coefficients; null where
                                 variations were known without them: of a quadratic polynomial (they are its
                                 roots), and of quarters of the line */
} algsurf_cell;

/* Told of each cell, in the order of the search; data is the caller's, passed through. */
typedef void (*algsurf_cell_observer)(const algsurf_cell *cell, void *data);

/* Told of each point t at which a method of refinement evaluates, in its order, with the value that it gets:
 * p's; of its squarefree part, up to a positive factor, where integers look at that.  engine: an
 * algsurf_engine. */
typedef void (*algsurf_point_observer)(double t, double value, int engine, void *data);

/* Who watches.  Callbacks run in the library's floating-point environment, round to nearest, all exceptions
 * masked, and must leave that as it is; they must not change the observer.  One observer serves one call at
 * a time. */
typedef struct algsurf_observer {
    size_t size;                     /* sizeof(algsurf_observer) */
    algsurf_cell_observer on_cell;   /* null: nobody is told of cells */
    algsurf_point_observer on_point; /* null: nobody is told of points */
    void *data;                      /* the caller's, passed to both */
    size_t cells;                    /* how many; each call adds to it, and nobody resets it */
    size_t evaluations;              /* at points; likewise */
    int engine; /* the highest algsurf_engine of them, who decided; a call may raise it */
} algsurf_observer;

#ifdef __cplusplus
}
#endif
#endif
