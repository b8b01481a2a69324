/* seed_case.h - polynomials with roots known exactly, for the tests of the seed's root finder.
 *
 * Roots are Gaussian integers, small enough that all coefficients are exact in double. */
#ifndef SEED_CASE_H
#define SEED_CASE_H
#include "algsurf/papers.h"
#include "allroots_case.h"

enum { SEED_DEGREE = 8 };

typedef struct seed_case {
    int n;
    algsurf_complex root[SEED_DEGREE];
    algsurf_complex p[SEED_DEGREE + 1];
} seed_case;

/* p = lead * product of (X - x_i), i != without; returns its degree. */
static inline int seed_product(const algsurf_complex *x, int n, int without, double lead,
                               algsurf_complex *p) {
    int m = 0;
    p[0] = (algsurf_complex){lead, 0};
    for (int i = 0; i < n; i++) {
        if (i == without) continue;
        p[m + 1] = (algsurf_complex){0, 0};
        for (int k = ++m; k >= 0; k--) {
            algsurf_complex a = k > 0 ? p[k - 1] : (algsurf_complex){0, 0},
                            b = k < m ? p[k] : (algsurf_complex){0, 0};
            p[k] = (algsurf_complex){a.re - (b.re * x[i].re - b.im * x[i].im) + 0.0,
                                     a.im - (b.re * x[i].im + b.im * x[i].re) + 0.0};
        }
    }
    return m;
}

/* Roots in [-5,5] + [-5,5] i; `distinct` or as they come. */
static inline seed_case seed_random(uint64_t *seed, int n, int distinct) {
    seed_case c = {.n = n};
    for (int i = 0; i < n; i++) {
        c.root[i] = (algsurf_complex){random_int(seed, 11) - 5, random_int(seed, 11) - 5};
        for (int j = 0; distinct && j < i; j++)
            if (c.root[j].re == c.root[i].re && c.root[j].im == c.root[i].im) i--, j = i;
    }
    (void)seed_product(c.root, n, -1, 1, c.p);
    return c;
}

/* How many roots, counted with multiplicity, are in the box. */
static inline int seed_count(const seed_case *c, algsurf_cinterval box) {
    int count = 0;
    for (int i = 0; i < c->n; i++) count += case_in(c->root[i], box);
    return count;
}

static inline void seed_print(const char *name, const algsurf_complex *c, int n) {
    fprintf(stderr, "%s =", name);
    for (int i = 0; i < n; i++) fprintf(stderr, " (%a, %a)", c[i].re, c[i].im);
    fprintf(stderr, "\n");
}

#endif
