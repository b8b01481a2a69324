/* exact.h - the oracle of the tests: rational arithmetic (GMP), where every double is exact.
 *
 * Names: exact_*.  An mpq_t handed out must be initialised by the caller (mpq_init) and cleared.
 */
#ifndef EXACT_H
#define EXACT_H
#include <math.h>
#include <stdint.h>
#include <stdio.h> /* before gmp.h, which then declares gmp_fprintf */
#include <stdlib.h>

#include <gmp.h>

#include "random.h"

/* q = x exactly; x must be finite.  (GMP reads the bits: rounding mode and FTZ/DAZ play no part.) */
static inline void exact_set(mpq_t q, double x) {
    if (!isfinite(x)) {
        fprintf(stderr, "exact_set: %a is not a number to compute with\n", x);
        abort();
    }
    mpq_set_d(q, x);
}

/* q = hi + lo exactly: a double-double. */
static inline void exact_set2(mpq_t q, double hi, double lo) {
    mpq_t t;
    mpq_init(t);
    exact_set(q, hi), exact_set(t, lo);
    mpq_add(q, q, t);
    mpq_clear(t);
}

/* value = c[0] + c[1] t + ... + c[n] t^n. */
static inline void exact_poly(mpq_t value, const double *c, int n, const mpq_t t) {
    mpq_t y, ci;
    mpq_inits(y, ci, NULL);
    for (int i = n; i >= 0; i--) {
        exact_set(ci, c[i]);
        mpq_mul(y, y, t), mpq_add(y, y, ci);
    }
    mpq_set(value, y);
    mpq_clears(y, ci, NULL);
}

static inline void exact_poly_at(mpq_t value, const double *c, int n, double t) {
    mpq_t q;
    mpq_init(q);
    exact_set(q, t);
    exact_poly(value, c, n, q);
    mpq_clear(q);
}

/* The sign of p(t): -1, 0, +1. */
static inline int exact_poly_sign(const double *c, int n, double t) {
    mpq_t q;
    mpq_init(q);
    exact_poly_at(q, c, n, t);
    int sign = mpq_sgn(q);
    mpq_clear(q);
    return sign;
}

/* Bernstein coefficients b[0..n] (initialised) of sum a_i t^i on [lo,hi], from the definition: with
 * p(lo + (hi-lo) s) = sum a_i s^i,  b_j = sum_{i<=j} C(j,i) / C(n,i) a_i.  Changes a. */
static inline void exact_bernstein_of(mpq_t *b, mpq_t *a, int n, double lo, double hi) {
    mpq_t x, w;
    mpz_t choose;
    mpq_inits(x, w, NULL), mpz_init(choose);
    exact_set(x, lo);
    for (int k = 0; k < n; k++) /* Taylor shift by lo */
        for (int i = n - 1; i >= k; i--) mpq_mul(w, x, a[i + 1]), mpq_add(a[i], a[i], w);
    exact_set(w, hi), mpq_sub(x, w, x), mpq_set_ui(w, 1, 1);
    for (int i = 1; i <= n; i++) mpq_mul(w, w, x), mpq_mul(a[i], a[i], w); /* scaling by hi - lo */
    for (int j = 0; j <= n; j++) {
        mpq_set_ui(b[j], 0, 1);
        for (int i = 0; i <= j; i++) {
            mpz_bin_uiui(choose, (unsigned long)j, (unsigned long)i), mpq_set_z(w, choose);
            mpz_bin_uiui(choose, (unsigned long)n, (unsigned long)i), mpq_set_z(x, choose);
            mpq_div(w, w, x), mpq_mul(w, w, a[i]), mpq_add(b[j], b[j], w);
        }
    }
    mpq_clears(x, w, NULL), mpz_clear(choose);
}

/* The same of doubles. */
static inline void exact_bernstein(mpq_t *b, const double *c, int n, double lo, double hi) {
    mpq_t *a = malloc((size_t)(n + 1) * sizeof *a);
    for (int i = 0; i <= n; i++) mpq_init(a[i]), exact_set(a[i], c[i]);
    exact_bernstein_of(b, a, n, lo, hi);
    for (int i = 0; i <= n; i++) mpq_clear(a[i]);
    free(a);
}

/* error = |x - q|. */
static inline void exact_error(mpq_t error, double x, const mpq_t q) {
    exact_set(error, x);
    mpq_sub(error, error, q);
    mpq_abs(error, error);
}

/* Is |x - q| <= bound?  A bound of +inf always holds, a NaN or negative bound never; neither does
 * a value that is not finite with a finite bound. */
static inline int exact_within(double x, const mpq_t q, double bound) {
    if (isnan(x) || isnan(bound) || bound < 0) return 0;
    if (isinf(bound)) return 1;
    if (isinf(x)) return 0;
    mpq_t error, limit;
    mpq_inits(error, limit, NULL);
    exact_error(error, x, q), exact_set(limit, bound);
    int within = mpq_cmp(error, limit) <= 0;
    mpq_clears(error, limit, NULL);
    return within;
}

/* Is lo <= q <= hi?  lo and hi may be infinite. */
static inline int exact_between(double lo, const mpq_t q, double hi) {
    mpq_t end;
    mpq_init(end);
    int above = isinf(lo) ? lo < 0 : (exact_set(end, lo), mpq_cmp(end, q) <= 0);
    int below = isinf(hi) ? hi > 0 : (exact_set(end, hi), mpq_cmp(q, end) <= 0);
    mpq_clear(end);
    return above && below;
}

/* For messages: `name = value` in decimal, about 17 digits, whatever the exponent. */
static inline void exact_print(const char *name, const mpq_t q) {
    mpf_t f;
    mpf_init2(f, 128);
    mpf_set_q(f, q);
    gmp_fprintf(stderr, "%s = %.17Fe\n", name, f);
    mpf_clear(f);
}

/* For messages: `name = {0x..., ...}`, as it can be pasted into C. */
static inline void exact_print_doubles(const char *name, const double *x, int count) {
    fprintf(stderr, "%s = {", name);
    for (int i = 0; i < count; i++) fprintf(stderr, "%s%a", i ? ", " : "", x[i]);
    fprintf(stderr, "}\n");
}

#endif
