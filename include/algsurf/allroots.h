/* algsurf/allroots.h - all complex roots of a polynomial, enclosed and counted.
 *
 * Always n roots for degree n: disjoint boxes with multiplicities that add up to n, each proved to hold
 * exactly that many.  (papers.h has published algorithms that go root by root, and can fail.)
 *
 * Coefficients are complex numbers, lowest degree first.  With an optional array of radii r >= 0 they stand
 * for all polynomials with complex coefficients c'_k, |c'_k - c_k| <= r_k, and every guarantee holds for each
 * of these.
 */
#ifndef ALGSURF_ALLROOTS_H
#define ALGSURF_ALLROOTS_H
#include <stddef.h>

#include "algsurf/interval.h"
#include "algsurf/poly.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A root, simple or multiple, or a cluster of roots that could not be told apart. */
typedef struct algsurf_complex_root {
    algsurf_cinterval box; /* encloses; holds exactly `multiplicity` roots: verified */
    algsurf_complex root;  /* approximate, in the box */
    int multiplicity;      /* >= 1; 1: a simple root, alone in its box: isolates */
    int real;              /* 1: all of them are real, box.im is [0,0]; 0: not real, or not known: radii,
                              clusters */
} algsurf_complex_root;

/* All roots of sum c_k z^k.
 *   c, r    degree+1 coefficients, lowest first; radii or null
 *   roots   room for `degree` entries, at least 1: no capacity is handed over
 *   count   how many were written; their multiplicities add up to the degree of the polynomial, which
 *           is `degree` less the number of leading coefficients that are exactly 0 (roots at infinity)
 * If the lowest coefficients are exactly 0, the root 0 is exact, or shares a box with roots that doubles
 * cannot separate from it.  Without radii (null, or all 0) each different root has a box of its own, with
 * its exact multiplicity, unless doubles cannot separate it from another.  A box is at most two units in the
 * last place of its larger part wide.  Real roots are proved real, with radii those of real polynomials;
 * other roots of real polynomials are in exactly conjugate boxes. With radii, roots that cannot be separated
 * share a box.  Entries are in increasing order of root.re, then of root.im.
 * Errors: E_ARGUMENT (null, negative degree or radius), E_DEGREE (above ALGSURF_MAX_POLY_DEGREE),
 * E_NOT_FINITE, E_ZERO, E_RANGE (the leading coefficient may be 0: its radius is 1 - 2^-30 of it, or more),
 * E_NO_MEMORY.
 * Cost: with exact coefficients 0.1 to 3 microseconds (degrees 2 to 16) where roots are simple and apart;
 * else integers of as many bits as it takes: Wilkinson's polynomial of degree 20 0.2 milliseconds,
 * Chebyshev's of degree 160 0.05 seconds.  With radii 4 to 90 microseconds (degrees 3 to 20).
 * Memory: some KiB for each degree and root, 1 GiB at most, where 15 KiB of the stack do not suffice.  All is
 * freed.
 * Source: Bini 1996 (start values), Ehrlich 1967, Aberth 1973 (iteration), Smith 1970 (inclusion discs), Yun
 * 1976 (multiplicities).  64 KiB of stack.  Since 1.0. */
ALGSURF_API algsurf_status algsurf_complex_roots(const algsurf_complex *c, const double *r, int degree,
                                                 algsurf_complex_root *roots, int *count);

/* The same for real coefficients; radii then stand for real coefficients too, so that roots can be proved
 * real.  64 KiB of stack.  Since 1.0. */
ALGSURF_API algsurf_status algsurf_complex_roots_of_real(const double *c, const double *r, int degree,
                                                         algsurf_complex_root *roots, int *count);

/* The same for integer coefficients, real or complex (Gaussian) ones, of any length.
 *   re, im  degree+1 real parts, and imaginary parts; im null: the coefficients are real
 * Errors: E_ARGUMENT (null, negative degree, more than ALGSURF_MAX_LIMBS limbs or null ones), E_DEGREE,
 * E_ZERO, E_NO_MEMORY.
 * Ends of boxes beyond the range of double are infinite.  Cost: that of ill-conditioned polynomials above.
 * 28 KiB of stack.  Since 1.0. */
ALGSURF_API algsurf_status algsurf_complex_roots_integers(const algsurf_integer *re,
                                                          const algsurf_integer *im, int degree,
                                                          algsurf_complex_root *roots, int *count);

/* ---- roots to any number of bits ---- */

/* The most bits that roots may be asked for: 301,000 decimals. */
#define ALGSURF_MAX_ROOT_BITS 1000000

/* All roots of one polynomial. */
typedef struct algsurf_precise_roots algsurf_precise_roots;

/* One of them: (re + i im) 2^exponent, off by at most radius 2^exponent in each part. */
typedef struct algsurf_precise_root {
    algsurf_integer re, im; /* limbs belong to the algsurf_precise_roots */
    int exponent, radius;   /* radius 0: this is the root exactly */
    int multiplicity;       /* exact */
    int real;         /* 1: real, im is 0; 0: not real */
} algsurf_precise_root;

/* All roots of a polynomial of integers, to as many bits as are asked for.
 *   re, im, degree  as algsurf_complex_roots_integers takes them
 *   bits            1..ALGSURF_MAX_ROOT_BITS: a root's radius is at most 2^-bits of its larger part
 *   max_memory      bytes that work may allocate, beside the answer; 0: 1 GiB
 *   roots           to be freed by algsurf_precise_roots_free
 * Guarantee: each different root is there once, with its exact multiplicity, in a box of its own: verified.
 * Roots of real polynomials are real, or come in exactly conjugate pairs.  They are in increasing order of
 * re, then of im.
 * Returns OK; or NOT_CONVERGED, if 1000 steps have not separated the roots, which is not known to happen:
 * nothing is written then.
 * Errors: E_ARGUMENT (null, bits, limbs as above), E_DEGREE, E_ZERO, E_NO_MEMORY.
 * Cost: beside that of algsurf_complex_roots_integers, about twice degree^2 (bits / 64)^2 products of words.
 * Source: as above, then Newton's method.  36 KiB of stack.  Since 1.0. */
ALGSURF_API algsurf_status algsurf_precise_roots_create(const algsurf_integer *re, const algsurf_integer *im,
                                                        int degree, int bits, size_t max_memory,
                                                        algsurf_precise_roots **roots);
/* How many there are; 0 for null.  Since 1.0. */
ALGSURF_API int algsurf_precise_roots_count(const algsurf_precise_roots *roots);
/* Root i, from 0.  Errors: E_ARGUMENT.  Since 1.0. */
ALGSURF_API algsurf_status algsurf_precise_roots_get(const algsurf_precise_roots *roots, int i,
                                                     algsurf_precise_root *root);
/* Releases roots, and the limbs of each; null is allowed.  Since 1.0. */
ALGSURF_API void algsurf_precise_roots_free(algsurf_precise_roots *roots);

/* ---- a solver: start values, and what a solve took ---- */

/* It may keep work memory from one call to the next; not to be used by two threads at once. */
typedef struct algsurf_complex_solver algsurf_complex_solver;

/* What a solve took, in this version. */
typedef struct algsurf_complex_solver_stats {
    size_t size;    /* sizeof(algsurf_complex_solver_stats), set by the caller */
    int iterations; /* corrections of single roots by the Ehrlich-Aberth iteration in double, in all */
    int retries;    /* those with values by integers */
} algsurf_complex_solver_stats;

/* A solver for degrees up to max_degree, 1..ALGSURF_MAX_POLY_DEGREE.  Errors: E_ARGUMENT, E_DEGREE,
 * E_NO_MEMORY.  Since 1.0. */
ALGSURF_API algsurf_status algsurf_complex_solver_create(int max_degree, algsurf_complex_solver **solver);
/* Releases a solver and its memory; null is allowed.  Since 1.0. */
ALGSURF_API void algsurf_complex_solver_free(algsurf_complex_solver *solver);
/* As algsurf_complex_roots.
 *   start  null, or `degree` start values for the iteration, all different: good ones save time, bad ones
 *          cost it; the answer is as certain with either
 *   stats  null, or receives what the solve took
 * Errors: as algsurf_complex_roots; E_DEGREE (above the solver's).  28 KiB of stack.  Since 1.0. */
ALGSURF_API algsurf_status algsurf_complex_solver_run(algsurf_complex_solver *solver,
                                                      const algsurf_complex *c, const double *r, int degree,
                                                      const algsurf_complex *start,
                                                      algsurf_complex_root *roots, int *count,
                                                      algsurf_complex_solver_stats *stats);

#ifdef __cplusplus
}
#endif
#endif
