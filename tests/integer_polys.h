/* integer_polys.h - polynomials of Gaussian integers, families of them by name, and Newton's method in
 * numbers of as many bits as it takes. */
#ifndef INTEGER_POLYS_H
#define INTEGER_POLYS_H
#include <stdio.h> /* before gmp.h, which then declares gmp_fprintf */

#include <gmp.h>

#include "algsurf/algsurf.h"
#include "random.h"
#include "unit.h"

enum { MOST = ALGSURF_MAX_POLY_DEGREE };

/* Gaussian integers. */
typedef struct poly {
    int degree;
    mpz_t re[MOST + 1], im[MOST + 1];
} poly;

static inline poly *make(int degree) {
    poly *p = malloc(sizeof *p);
    assert_non_null(p);
    p->degree = degree;
    for (int k = 0; k <= MOST; k++) mpz_inits(p->re[k], p->im[k], NULL);
    return p;
}

static inline void drop(poly *p) {
    for (int k = 0; k <= MOST; k++) mpz_clears(p->re[k], p->im[k], NULL);
    free(p);
}

static inline poly *product(const poly *a, const poly *b) {
    poly *p = make(a->degree + b->degree);
    for (int i = 0; i <= a->degree; i++)
        for (int k = 0; k <= b->degree; k++) {
            mpz_addmul(p->re[i + k], a->re[i], b->re[k]), mpz_submul(p->re[i + k], a->im[i], b->im[k]);
            mpz_addmul(p->im[i + k], a->re[i], b->im[k]), mpz_addmul(p->im[i + k], a->im[i], b->re[k]);
        }
    return p;
}

/* p times (d z - (a + ib)). */
static inline poly *times_root(poly *p, long a, long b, long d) {
    poly *f = make(1);
    mpz_set_si(f->re[1], d), mpz_set_si(f->re[0], -a), mpz_set_si(f->im[0], -b);
    poly *q = product(p, f);
    drop(f), drop(p);
    return q;
}

static inline int is_real(const poly *p) {
    for (int k = 0; k <= p->degree; k++)
        if (mpz_sgn(p->im[k])) return 0;
    return 1;
}

static inline void integers(mpz_t *c, int n, algsurf_integer *z) {
    for (int k = 0; k <= n; k++)
        z[k] = (algsurf_integer){mpz_limbs_read(c[k]), mpz_sgn(c[k]) * (int)mpz_size(c[k])};
}

/* ---- families ---- */

/* c_(k+1) = (a z + b) c_k - c c_(k-1), from 1: CHEBYSHEV's T, Hermite's H, Laguerre's n! L. */
typedef enum family { CHEBYSHEV, HERMITE, LAGUERRE } family;

static inline poly *orthogonal(family f, int n) {
    poly *before = make(0), *p = make(0);
    mpz_t w;
    mpz_init(w);
    mpz_set_ui(p->re[0], 1);
    for (long k = 0; k < n; k++) {
        const long a = f == LAGUERRE              ? -1
                       : f == CHEBYSHEV && k == 0 ? 1
                                                  : 2,
                   b = f == LAGUERRE ? 2 * k + 1 : 0,
                   c = f == LAGUERRE  ? k * k
                       : f == HERMITE ? 2 * k
                                      : 1;
        poly *next = make((int)k + 1);
        for (int i = 0; i <= k; i++) {
            mpz_mul_si(w, p->re[i], a), mpz_add(next->re[i + 1], next->re[i + 1], w);
            mpz_mul_si(w, p->re[i], b), mpz_add(next->re[i], next->re[i], w);
            if (i < k) mpz_mul_si(w, before->re[i], c), mpz_sub(next->re[i], next->re[i], w);
        }
        drop(before);
        before = p, p = next;
    }
    mpz_clear(w);
    drop(before);
    return p;
}

/* 2^n P_n = sum (-1)^k C(n,k) C(2n-2k,n) z^(n-2k). */
static inline poly *legendre(int n) {
    poly *p = make(n);
    mpz_t w;
    mpz_init(w);
    for (int k = 0; 2 * k <= n; k++) {
        mpz_t *c = p->re + n - 2 * k;
        mpz_bin_uiui(*c, (unsigned)n, (unsigned)k), mpz_bin_uiui(w, 2 * (unsigned)(n - k), (unsigned)n);
        mpz_mul(*c, *c, w);
        if (k % 2) mpz_neg(*c, *c);
    }
    mpz_clear(w);
    return p;
}

/* Roots 1 .. n. */
static inline poly *wilkinson(int n) {
    poly *p = make(0);
    mpz_set_ui(p->re[0], 1);
    for (int k = 1; k <= n; k++) p = times_root(p, k, 0, 1);
    return p;
}

/* n! sum z^k / k!. */
static inline poly *exponential(int n) {
    poly *p = make(n);
    mpz_set_ui(p->re[n], 1);
    for (int k = n; k > 0; k--) mpz_mul_si(p->re[k - 1], p->re[k], k);
    return p;
}

/* z -> z^2 + c, k times from 0, over c, as a polynomial in c: of degree 2^(k-1) - 1. */
static inline poly *mandelbrot(int k) {
    poly *p = make(0);
    mpz_set_ui(p->re[0], 1);
    for (; k > 1; k--) {
        poly *q = product(p, p), *next = make(q->degree + 1);
        for (int i = 0; i <= q->degree; i++) mpz_set(next->re[i + 1], q->re[i]);
        mpz_add_ui(next->re[0], next->re[0], 1);
        drop(p), drop(q);
        p = next;
    }
    return p;
}

/* z^n - m (a z - 1)^2: two real roots at 1/a, for m = 1 about 2 a^-(n/2+1) apart. */
static inline poly *mignotte(int n, long a, long m) {
    poly *p = make(n);
    mpz_set_ui(p->re[n], 1);
    mpz_set_si(p->re[0], -m), mpz_mul_si(p->re[1], p->re[0], -2 * a), mpz_set_si(p->re[2], -m * a);
    mpz_mul_si(p->re[2], p->re[2], a);
    return p;
}

/* ---- Newton's method ---- */

typedef struct number {
    mpf_t re, im;
} number;

static number x, y, v, d, t;

static inline void times(number *a, const number *b) {
    mpf_mul(t.re, a->re, b->re), mpf_mul(t.im, a->im, b->im), mpf_sub(t.re, t.re, t.im);
    mpf_mul(t.im, a->re, b->im), mpf_mul(a->im, a->im, b->re), mpf_add(a->im, a->im, t.im);
    mpf_set(a->re, t.re);
}

/* |a|^2 as part 2^exponent. */
static inline double square(const number *a, long *exponent) {
    mpf_mul(t.re, a->re, a->re), mpf_mul(t.im, a->im, a->im), mpf_add(t.re, t.re, t.im);
    return mpf_get_d_2exp(exponent, t.re);
}

/* v = p(x), d = p'(x). */
static inline void values(const poly *p) {
    mpf_set_ui(v.re, 0), mpf_set_ui(v.im, 0), mpf_set_ui(d.re, 0), mpf_set_ui(d.im, 0);
    for (int k = p->degree; k >= 0; k--) {
        times(&d, &x), mpf_add(d.re, d.re, v.re), mpf_add(d.im, d.im, v.im);
        times(&v, &x);
        mpf_set_z(y.re, p->re[k]), mpf_set_z(y.im, p->im[k]);
        mpf_add(v.re, v.re, y.re), mpf_add(v.im, v.im, y.im);
    }
}

/* One step of Newton's method from x; returns log2 of |p/p'|. */
static inline double step(const poly *p) {
    long a, b;
    values(p);
    double up = square(&v, &a), down = square(&d, &b);
    if (up == 0) return -1e6;
    if (down == 0) return 1e6;
    mpf_mul(y.re, d.re, d.re), mpf_mul(y.im, d.im, d.im), mpf_add(y.re, y.re, y.im);
    mpf_neg(d.im, d.im), times(&v, &d);
    mpf_div(v.re, v.re, y.re), mpf_div(v.im, v.im, y.re);
    mpf_sub(x.re, x.re, v.re), mpf_sub(x.im, x.im, v.im);
    return 0.5 * ((double)(a - b) + log2(up / down));
}

static inline void set_precision(unsigned long bits) {
    number *const all[] = {&x, &y, &v, &d, &t};
    for (size_t i = 0; i < sizeof all / sizeof *all; i++) {
        if (!all[i]->re->_mp_d) mpf_init(all[i]->re), mpf_init(all[i]->im);
        mpf_set_prec(all[i]->re, bits), mpf_set_prec(all[i]->im, bits);
    }
}

static inline void end_precision(void) {
    number *const all[] = {&x, &y, &v, &d, &t};
    for (size_t i = 0; i < sizeof all / sizeof *all; i++) mpf_clear(all[i]->re), mpf_clear(all[i]->im);
}

/* ---- chance ---- */

static uint64_t seed = 20261126;

static inline int random_below(int n) { return random_int(&seed, n); }

static inline int is_reduced(long a, long b) {
    while (b) {
        const long rest = a % b;
        a = b, b = rest;
    }
    return a == 1;
}

/* prod f[i]^m[i] of one to four random factors, real or Gaussian; Gaussian ones may share roots with their
 * conjugates.  Roots have denominators of 3, or `wild`: up to 2^19 + 1. */
static inline poly *random_product(int real, int wild, const int m[4], poly *f[4]) {
    int factors = 1 + random_below(4), taken = 0;
    poly *p = make(0);
    mpz_set_ui(p->re[0], 1);
    for (int i = 0; i < factors; i++) {
        int roots = 1 + random_below(4);
        f[i] = make(0);
        mpz_set_ui(f[i]->re[0], 1);
        for (int k = 0; k < roots; k++) { /* reduced, with numerators that differ: so do real parts */
            long a = 7 * ++taken + random_below(5), b = random_below(3) * (1 + random_below(9));
            long under = 3;
            while (wild && !is_reduced(a, under = 1L << random_below(20) | 1)) continue;
            f[i] = times_root(f[i], a, b, under);
            if (b && (real || random_below(2))) f[i] = times_root(f[i], a, -b, under);
        }
        for (int k = 0; k < m[i]; k++) {
            poly *q = product(p, f[i]);
            drop(p);
            p = q;
        }
    }
    return p;
}

#endif
