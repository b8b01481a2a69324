/* algsurf/refine.h - a root to full accuracy, from an interval that isolates it (a bracket).
 *
 * All methods keep an interval whose ends have opposite signs, or one of them is a root, and count
 * evaluations by the same rule, so that they can be compared.  They differ in how they choose the next point.
 *
 * The default method for polynomials knows every sign that it uses: it computes a value in about doubled
 * precision, with an error bound; if that leaves the sign open, it computes with integers.  So its bracket
 * always holds the root, and shrinks to two units in the last place.  The other methods, asked for by name,
 * are as in textbooks: they evaluate by Horner's rule in double and use the signs that come out.  Where
 * rounding, overflow or underflow hides the value, they may miss the root, take a computed 0 for a root, or
 * refuse a bracket whose signs look equal.
 */
#ifndef ALGSURF_REFINE_H
#define ALGSURF_REFINE_H
#include <stddef.h>

#include "algsurf/observe.h"
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
    size_t size;                /* sizeof(algsurf_refine_options) */
    int method;                 /* an algsurf_method, 0: default */
    int max_iterations;         /* points that the method may choose, >= 0; 0: 1000 */
    double absolute_tolerance;  /* wanted error of the root, in the unit of the abscissa, >= 0.  The search
                                   ends when hi - lo is at most this plus 2^-50 max(|root|, smallest normal
                                   double); the default method for polynomials: plus 2^-52 |root|, or twice
                                   the smallest double */
    algsurf_observer *observer; /* null: nobody watches; else it is told each evaluation in its order: lo, hi,
                                   then the points that the method chooses */
} algsurf_refine_options;

/* A refined root, and what it took. */
typedef struct algsurf_refined_root {
    double root;     /* the end of [lo,hi] with the smaller |f|, or a zero that was met */
    double lo, hi;   /* the final bracket, lo <= root <= hi */
    double residual; /* f(root), as computed.  By the default method for polynomials its sign is certain, and
                        0 means that `root` is a root */
    int evaluations; /* of f (for the guarded Newton: of f together with f'), ends included */
    int iterations;  /* points chosen by the method */
    int converged; /* 1: hi - lo <= absolute_tolerance + rounding or residual == 0; 0: the limit was reached.
                      Regula falsi also stops, as converged, when two consecutive points differ by no
                      more than that; it cannot tell whether it is near a root or only slow */
} algsurf_refined_root;

/* Real function of a real variable, which must return; data is the caller's, passed through. */
typedef double (*algsurf_function)(double x, void *data);

/* A root of f in [lo,hi], f(lo) and f(hi) of opposite sign, or one of them zero; lo = hi has to be a root.
 *   options  null: all defaults
 * Guarantee: approximate.  If f is continuous and the signs of its values are right, the final bracket holds
 * a root.
 * Returns OK; NOT_CONVERGED (result filled) at the iteration limit.  Errors: E_ARGUMENT (null, lo > hi,
 * same signs, bad options), E_NOT_FINITE (an end, or f returned NaN).
 * f is called in the caller's floating-point environment, which it may change; it may use all of libm.  The
 * arithmetic on the bracket is done in the library's environment, and so are calls of an observer.
 * Infinite values count by their sign.
 * Cost: evaluations: bisection log2((hi-lo)/absolute_tolerance); Brent at worst the square of that.
 * Since 1.0. */
ALGSURF_API algsurf_status algsurf_refine_function(algsurf_function f, void *data, double lo, double hi,
                                                   const algsurf_refine_options *options,
                                                   algsurf_refined_root *result);

/* The same for a polynomial in the power basis.
 *   c, r     degree+1 coefficients, lowest first; radii or null (null for all methods but the default).  The
 *            zero polynomial is accepted, without radii: every number is a root
 *   options  null: all defaults
 * By the default method:
 * - encloses: the final bracket holds a root of the exact polynomial: verified.  With absolute_tolerance 0
 *   it is at most two units in the last place wide; lo = hi where a double is the root;
 * - every bracket that algsurf_isolate_first or _all returns without radii is accepted.  Two neighbouring
 *   doubles, or the largest one and infinity, are the final bracket if there is a root between or on them,
 *   whatever the signs there;
 * - no bracket takes more than 248 evaluations (plain halving may need 2000).
 * With radii:
 * - encloses: the final bracket holds a root of each polynomial of the set, and the rest of [lo,hi] holds
 *   none: verified.  It is as narrow as absolute_tolerance, the radii and doubles allow;
 * - isolated and exact brackets of algsurf_isolate_first or _all for c and r are accepted.  Undecided ones,
 *   and others, are E_ARGUMENT if a polynomial of the set may have equal signs at lo and hi;
 * - root, residual, counts and converged are of c alone: root is in [lo,hi], as a rule not at an end, and
 *   converged says nothing of hi - lo.  An observer is told of cells, too.
 * Errors: also E_ARGUMENT for a negative degree or radius, E_DEGREE (above ALGSURF_MAX_POLY_DEGREE),
 * E_NOT_FINITE (coefficients, radii; an infinite end, unless the other one is the largest double);
 * E_NO_MEMORY (by default, where integers decide: 1 GiB at most).
 * Cost: by default some nine evaluations of O(degree) operations from an isolating bracket, 0.3 microseconds
 * at degree 4, 0.5 at 10, 2.3 at 64; a microsecond or more for each value that integers decide, which few
 * roots need; with radii 20 to 100 microseconds more at degrees 2 to 10.  42 KiB of stack.  Since 1.0. */
ALGSURF_API algsurf_status algsurf_refine_poly(const double *c, const double *r, int degree, double lo,
                                               double hi, const algsurf_refine_options *options,
                                               algsurf_refined_root *result);

#ifdef __cplusplus
}
#endif
#endif
