/* polys.h - first roots of many polynomials at once, by every kernel. */
#ifndef ALGSURF_ROOTS_POLYS_H
#define ALGSURF_ROOTS_POLYS_H
#include <stddef.h>
#include <stdint.h>

#include "../simd/kernel.h"
#include "algsurf/batch.h"
#include "coefficients.h"
#include "watch.h"

/* The bounds of centred_template.h hold up to this degree. */
#define ALGSURF_MAX_POLYS_DEGREE 20

/* Polynomials of degree 1 to ALGSURF_MAX_POLYS_DEGREE with their intervals, and their answers. */
typedef struct algsurf_i_polys_job {
    algsurf_real_batch p;
    double tolerance; /* relative to the interval */
    uint8_t *state;
    double *root;             /* +inf where there is none; may be null */
    algsurf_real_root *roots; /* of all roots: those of number i from i degree on */
    int *found;               /* and how many; -1: undecided */
} algsurf_i_polys_job;

/* Brackets of the roots of p, of degree 1 to ALGSURF_MAX_DEGREE, in a finite interval lo < hi, in order, at
 * most `most`; each with its ends at doubles of certain sign, and no root before it but in those before.
 * Returns 1 when these are all, or as many as wanted; 0: what comes after them is undecided.  watch: null, or
 * of the caller's unit. */
typedef int algsurf_i_roots_single(const algsurf_i_coefficients *p, double lo, double hi, int most,
                                   algsurf_bracket *brackets, int *count, const algsurf_i_watch *watch);
algsurf_i_roots_single algsurf_i_roots_single_avx512, algsurf_i_roots_single_avx2,
    algsurf_i_roots_single_baseline;

typedef struct algsurf_i_roots_kernel {
    /* state and root; of an undecided polynomial only the state counts.  Returns 0 if there is none. */
    int (*solve)(const algsurf_i_polys_job *job);
    /* roots and found, of polynomials without radii. */
    void (*solve_all)(const algsurf_i_polys_job *job);
    algsurf_i_roots_single *single;
    /* Roots of p, each simple and alone in (lo,hi), with the sign before it, become final; multiplicity 0:
     * one that stays.  No |c_k| above 2^401, no end of a bracket so that |t|^degree is above 2^400. */
    void (*settle)(const algsurf_i_coefficients *p, algsurf_real_root *roots, int count);
} algsurf_i_roots_kernel;

ALGSURF_KERNEL_TABLES(roots);

#endif
