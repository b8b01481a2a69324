/* decide.h - the real roots of a polynomial given as doubles or integers, by integers. */
#ifndef ALGSURF_DECIDE_H
#define ALGSURF_DECIDE_H
#include <stddef.h>

#include "algsurf/isolate.h"
#include "coefficients.h"
#include "watch.h"

/* What deciding one polynomial may allocate, in bytes. */
#define ALGSURF_I_DECIDE_MEMORY ((size_t)1 << 30)

/* The roots in [lo,hi], lo <= hi, of c[0] + ... + c[degree] t^degree, not the zero polynomial, in increasing
 * order, the first `capacity` of them; the degree always suffices.  watch: null, or who is told.  Returns OK
 * or E_NO_MEMORY.  Stack: 20 KiB, and what the walk takes. */
algsurf_status algsurf_i_decide_roots(const double *c, int degree, double lo, double hi,
                                      algsurf_real_root *roots, int capacity, int *count,
                                      const algsurf_i_watch *watch);

/* The same as brackets: those of simple roots hold no other root, p not being 0 at the ends. */
algsurf_status algsurf_i_decide_brackets(const double *c, int degree, double lo, double hi,
                                         algsurf_bracket *brackets, int capacity, int *count,
                                         const algsurf_i_watch *watch);

/* The same for integer coefficients. */
algsurf_status algsurf_i_decide_integers(const algsurf_integer *c, int degree, double lo, double hi,
                                         algsurf_real_root *roots, int capacity, int *count);

/* isolate.c: the roots in [lo,hi], or the first, as brackets, by doubles; returns 0 when these leave
 * something undecided.  c[degree] is not 0; `degree` entries suffice.  All brackets hold simple roots.
 * [lo,hi] is cut to where roots can be.  halvings: how often what is undecided is halved and tried again. */
int algsurf_i_isolate_in_lane(const algsurf_i_coefficients *p, double *lo, double *hi, int first_only,
                              int halvings, algsurf_bracket *brackets, int *count);

/* real_roots.c: what algsurf_real_roots says, where lo <= hi.  Room for `degree` roots suffices; there may be
 * numbers behind those found, or instead of them where the status is not OK. */
algsurf_status algsurf_i_real_roots(const double *c, int degree, double lo, double hi,
                                    algsurf_real_root *roots, int *count);

/* real_roots.c: the first of them; *count: 0 or 1.  c is finite and not zero throughout; OK or E_NO_MEMORY.
 */
algsurf_status algsurf_i_first_root(const double *c, int degree, double lo, double hi,
                                    algsurf_real_root *root, int *count);

/* real_roots.c: simple roots in brackets, between neighbouring doubles; multiplicity 0: not known. */
void algsurf_i_settle(const algsurf_i_coefficients *p, const algsurf_bracket *b, int count,
                      algsurf_real_root *roots);

/* integers.c: algsurf_i_decide_integers where doubles tell the roots apart; returns 0 where they do not. */
int algsurf_i_integers_in_doubles(const algsurf_integer *c, int degree, double lo, double hi,
                                  algsurf_real_root *roots, int *count);

/* The roots in [lo,hi] of all polynomials within the radii, as brackets and undecided places, at most
 * `capacity` >= 1, in order (the last one covers what there is no room for).  watch as above.  OK or
 * E_NO_MEMORY. */
algsurf_status algsurf_i_decide_ranges(const algsurf_i_coefficients *p, double lo, double hi,
                                       algsurf_bracket *brackets, int capacity, int *count,
                                       const algsurf_i_watch *watch);

/* The sign at x, finite, that all polynomials within the radii have in common, or ALGSURF_SIGN_UNKNOWN: there
 * is none.  OK or E_NO_MEMORY. */
algsurf_status algsurf_i_decide_sign(const algsurf_i_coefficients *p, double x, int *sign);

#endif
