/* algsurf/papers.h - complex roots by the algorithms of Sanjuan-Estrada, Casado, Garcia, as published.
 *
 * Root by root: Approximation, IntervalIteration, deflation, together AllCPolyZeros (after Hammer, Hocks,
 * Kulisch, Ratz 1995).  They can fail, as published: multiple roots are never verified, close ones seldom.
 * allroots.h finds all roots of any polynomial; these algorithms are here for comparison, and for those who
 * want one root, or the deflated polynomial.  What the papers say of pictures is algsurf_scene_set_coherence
 * (render.h).  Names are the papers': p is the polynomial, z a root, q the deflated polynomial, Z and Q
 * enclosures.  Coefficients, and radii, are as in allroots.h.
 */
#ifndef ALGSURF_PAPERS_H
#define ALGSURF_PAPERS_H
#include <stddef.h>

#include "algsurf/interval.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Limits of the three algorithms below; null options: all defaults. */
typedef struct algsurf_paper_options {
    size_t size;          /* sizeof(algsurf_paper_options) */
    double relative_step; /* the approximation stops when the last steps of z and of q are below this times
                             their sizes; 0: 1e-10 */
    int max_steps;        /* of the approximation, 0: 50 */
    int max_inflations;   /* of the interval iteration, 0: 10 */
} algsurf_paper_options;

/* Newton's method for a root z together with the deflated polynomial q, p(X) = (X - z) sum q_i X^i.
 *   p       degree+1 coefficients, degree 1..ALGSURF_MAX_POLY_DEGREE, p[degree] not 0
 *   start   first z; the first q is the quotient that Horner's scheme gives.  With a real polynomial and a
 *           real start all values are real.  Degree 1 is solved from any start, if its root is above
 *           2^-1100.
 *   z, q    the approximation; q has degree entries, q[degree-1] = p[degree]
 *   steps   number of steps made; may be null
 * Guarantee: approximate.  Returns OK, or NOT_CONVERGED (outputs hold the last values, always finite) after
 * too many steps, at a vanishing derivative, or if z or q overflows.  Errors: E_ARGUMENT (null, degree
 * below 1, p[degree] = 0, bad options), E_DEGREE, E_NOT_FINITE.  Cost: O(degree) a step.  Source: Hammer,
 * Hocks, Kulisch, Ratz 1995, ch. 9; Sanjuan-Estrada, Casado, Garcia, 2.1, with its listing corrected.
 * 44 KiB of stack.  Since 1.0. */
ALGSURF_API algsurf_status algsurf_paper_approximation(const algsurf_complex *p, int degree,
                                                       algsurf_complex start,
                                                       const algsurf_paper_options *options,
                                                       algsurf_complex *z, algsurf_complex *q, int *steps);

/* Verifies an approximation by interval iteration with epsilon inflation.
 *   p, r      the polynomial and radii of its coefficients, or null
 *   z, q      as algsurf_paper_approximation leaves them; q[degree-1] is taken to be p[degree]
 *   Z, Q      enclose a root and its deflated coefficients (degree entries; Q may be null), for every
 *             polynomial in the set: verified
 *   unique    1: the root in Z is simple and the only one there (0 is not in the enclosure of q(Z)):
 *             verified; 0: not known.  May be null
 *   inflations  number of inflations made; may be null
 * Returns OK, or NOT_VERIFIED (only inflations is written).  Multiple roots are never verified, roots closer
 * together than about 1e-8 times their size seldom.  Errors: as above.  Cost: O(degree)
 * each inflation.  Source: as above, 2.2; the residual is computed in doubled precision (the
 * original uses an exact dot product).  80 KiB of stack.  Since 1.0. */
ALGSURF_API algsurf_status algsurf_paper_inclusion(const algsurf_complex *p, const double *r, int degree,
                                                   algsurf_complex z, const algsurf_complex *q,
                                                   const algsurf_paper_options *options, algsurf_cinterval *Z,
                                                   algsurf_cinterval *Q, int *unique, int *inflations);

/* A root found by algsurf_paper_zeros. */
typedef struct algsurf_paper_zero {
    algsurf_cinterval box; /* encloses a root if verified; otherwise the approximation alone */
    algsurf_complex root;  /* the approximation, polished on the whole polynomial; in the box */
    int verified;          /* the interval iteration ended in an inclusion */
    int unique;            /* verified, and the root is simple and alone in the box */
    int converged;         /* the approximation met its stopping test, on both polynomials */
    int steps, inflations; /* numbers: of the approximation, of the interval iteration */
} algsurf_paper_zero;

/* The paper's algorithm: approximate a root of the deflated polynomial, polish and verify it on the
 * original one, deflate, go on; the last root is that of the linear factor.
 *   start    null: every root is approximated from 0 + i (even and odd real polynomials keep that on the
 *            imaginary axis); or `degree` start values, best by increasing magnitude (dividing by a large
 *            root first costs the small ones their digits)
 *   zeros    `degree` entries, in the order found
 *   complete 1: all are verified and their boxes are disjoint, hence these are all roots: verified.
 *            0: at least one failed, or two approximations went to the same root
 * Returns OK also when some failed.  Errors: as algsurf_paper_approximation.
 * Cost: O(degree^2) times the steps.  Source: as above, AllCPolyZeros.  110 KiB of stack.  Since 1.0. */
ALGSURF_API algsurf_status algsurf_paper_zeros(const algsurf_complex *p, const double *r, int degree,
                                               const algsurf_complex *start,
                                               const algsurf_paper_options *options,
                                               algsurf_paper_zero *zeros, int *complete);

#ifdef __cplusplus
}
#endif
#endif
