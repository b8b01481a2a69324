/* algsurf/refine.h - a bracket becomes a root.
 *
 * All methods keep an interval whose ends have opposite signs.  They differ in how they choose the
 * next point, and in nothing else: same stopping rule, same counts, so that they can be compared.
 */
#ifndef ALGSURF_REFINE_H
#define ALGSURF_REFINE_H
#include <stddef.h>

#include "algsurf/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/* How the next point is chosen. */
typedef enum algsurf_method {
    ALGSURF_METHOD_DEFAULT = 0,     /* a polynomial: Newton guarded by its bracket; a function: Brent */
    ALGSURF_METHOD_BRENT = 1,       /* Brent, Algorithms for Minimization without Derivatives, 1973, ch. 4 */
    ALGSURF_METHOD_BISECTION = 2,   /* halving */
    ALGSURF_METHOD_REGULA_FALSI = 3 /* plain false position: may need any number of steps */
} algsurf_method;

/* How a root is refined. */
typedef struct algsurf_refine_options {
    size_t size;           /* sizeof(algsurf_refine_options) */
    algsurf_method method; /* 0: default */
    int max_iterations;    /* 0: 1000 */
    double tolerance;      /* wanted half width of the bracket, >= 0, in the unit of the abscissa;
                              4 * 2^-53 * max(|root|, smallest normal double) is always added */
} algsurf_refine_options;

/* A refined root, and what it took. */
typedef struct algsurf_root {
    double root;     /* the end of [lo,hi] with the smaller |f|, a zero when one was met */
    double lo, hi;   /* the final bracket, lo <= root <= hi */
    double value;    /* f(root) as computed */
    int evaluations; /* of f (for the guarded Newton: of f together with f'), ends included */
    int iterations;  /* points chosen by the method */
    int converged;   /* 1: hi - lo <= 2 (tolerance + rounding) or value == 0; 0: the limit was reached.
                        Regula falsi also stops, as converged, when two consecutive points differ by no
                        more than that: near a root or only slow, it cannot tell. */
} algsurf_root;

/* Real function of a real variable; data is the caller's, passed through. */
typedef double (*algsurf_function)(double x, void *data);

/* A root of f in [lo,hi], f(lo) and f(hi) of opposite sign (or one of them zero).
 *   options  null: all defaults
 * Guarantee: approximate; for exact signs of f the final bracket encloses a root.
 * Returns OK; NOT_CONVERGED (result filled) at the iteration limit.  Errors: E_ARGUMENT (null, lo > hi,
 * same signs, bad options), E_NOT_FINITE (an end, or f returned NaN).
 * The function is called in the caller's floating-point environment and may use all of libm.
 * So is the arithmetic on the bracket: the guarantee does not depend on it, the last digits may.
 * Infinite values count by their sign.
 * Cost: evaluations: bisection log2((hi-lo)/tolerance); Brent at worst the square of that.  Since 1.0. */
ALGSURF_API algsurf_status algsurf_refine_function(algsurf_function f, void *data, double lo, double hi,
                                                   const algsurf_refine_options *options,
                                                   algsurf_root *result);

/* The same for a polynomial in the power basis, degree+1 coefficients, lowest first.
 * The default method needs no more than 395 evaluations for any bracket (plain halving may need 2000).
 * Errors: also E_ARGUMENT for a degree outside 0..ALGSURF_MAX_POLY_DEGREE, E_NOT_FINITE.  Since 1.0. */
ALGSURF_API algsurf_status algsurf_refine_poly(const double *c, int degree, double lo, double hi,
                                               const algsurf_refine_options *options, algsurf_root *result);

/* Called with a point and the polynomial's value there, as the method computed it; data is the caller's. */
typedef void (*algsurf_refine_observer)(double x, double value, void *data);

/* algsurf_refine_poly, watched: the same result, bit for bit, and `observe` called once for each evaluation,
 * in their order: lo, hi, then the points the method chooses.  (With algsurf_refine_function it is the
 * function that sees them.)  The observer runs in the library's floating-point environment, round to nearest,
 * and must leave that as it is.
 * Errors: as above, and E_ARGUMENT for a null observer; with equal signs it has seen both ends.
 * Since 1.0. */
ALGSURF_API algsurf_status algsurf_refine_poly_observed(const double *c, int degree, double lo, double hi,
                                                        const algsurf_refine_options *options,
                                                        algsurf_refine_observer observe, void *data,
                                                        algsurf_root *result);

#ifdef __cplusplus
}
#endif
#endif
