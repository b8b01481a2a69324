/* exact_zpolys.h - polynomials with GMP's integers as coefficients, for tests. */
#ifndef EXACT_ZPOLYS_H
#define EXACT_ZPOLYS_H
#include "exact_limbs.h"
#include "exact_roots.h"

#include "poly/integral.h"

#define EXACT_DEGREE 640

typedef struct exact_zpoly {
    int n; /* degree, -1: 0 */
    mpz_t c[EXACT_DEGREE + 1];
} exact_zpoly;

static inline exact_zpoly *exact_zpoly_new(void) {
    exact_zpoly *p = malloc(sizeof *p);
    if (!p) abort();
    p->n = -1;
    for (int k = 0; k <= EXACT_DEGREE; k++) mpz_init(p->c[k]);
    return p;
}

static inline void exact_zpoly_free(exact_zpoly *p) {
    for (int k = 0; k <= EXACT_DEGREE; k++) mpz_clear(p->c[k]);
    free(p);
}

static inline void exact_zpoly_set(exact_zpoly *p, const exact_zpoly *a) {
    p->n = a->n;
    for (int k = 0; k <= a->n; k++) mpz_set(p->c[k], a->c[k]);
}

static inline void exact_zpoly_constant(exact_zpoly *p, long a) {
    p->n = a ? 0 : -1;
    mpz_set_si(p->c[0], a);
}

static inline void exact_zpoly_trim(exact_zpoly *p) {
    while (p->n >= 0 && mpz_sgn(p->c[p->n]) == 0) p->n--;
}

static inline void exact_zpoly_multiply(exact_zpoly *r, const exact_zpoly *a, const exact_zpoly *b) {
    exact_zpoly *t = exact_zpoly_new();
    t->n = a->n < 0 || b->n < 0 ? -1 : a->n + b->n;
    for (int i = 0; i <= a->n; i++)
        for (int j = 0; j <= b->n; j++) mpz_addmul(t->c[i + j], a->c[i], b->c[j]);
    exact_zpoly_set(r, t);
    exact_zpoly_free(t);
}

static inline void exact_zpoly_scale(exact_zpoly *p, const mpz_t f) {
    for (int k = 0; k <= p->n; k++) mpz_mul(p->c[k], p->c[k], f);
}

static inline void exact_zpoly_derive(exact_zpoly *r, const exact_zpoly *a) {
    for (int k = 1; k <= a->n; k++) mpz_mul_si(r->c[k - 1], a->c[k], k);
    r->n = a->n < 0 ? -1 : a->n - 1;
}

/* Without content, the leading coefficient positive. */
static inline void exact_zpoly_primitive(exact_zpoly *p) {
    exact_primitive(p->c, p->n);
    for (int k = 0, negate = p->n >= 0 && mpz_sgn(p->c[p->n]) < 0; k <= p->n && negate; k++)
        mpz_neg(p->c[k], p->c[k]);
}

/* a becomes the primitive gcd, b becomes 0. */
static inline void exact_zpoly_euclid(exact_zpoly *a, exact_zpoly *b) {
    if (a->n < 0) exact_zpoly_set(a, b);
    if (b->n >= 0) a->n = exact_gcd(a->c, a->c, a->n, b->c, b->n);
    b->n = -1;
    exact_zpoly_primitive(a);
}

static inline int exact_zpoly_equal(const exact_zpoly *a, const exact_zpoly *b) {
    int equal = a->n == b->n;
    for (int k = 0; equal && k <= a->n; k++) equal = mpz_cmp(a->c[k], b->c[k]) == 0;
    return equal;
}

static inline void exact_zpoly_print(const char *name, const exact_zpoly *p) {
    fprintf(stderr, "%s =", name);
    for (int k = 0; k <= p->n; k++) gmp_fprintf(stderr, " %+Zd*x^%d", p->c[k], k);
    fprintf(stderr, "\n");
}

/* Numbers of up to `bits` bits of either sign: full size, short, a power of two or 0. */
static inline void random_mpz(uint64_t *seed, mpz_t z, int bits) {
    int kind = random_int(seed, 12), length = kind < 8 ? bits : 1 + random_int(seed, bits);
    mpz_set_ui(z, 0);
    if (kind == 10) mpz_setbit(z, (mp_bitcnt_t)length - 1);
    for (int i = 0; kind < 10 && i < length; i += 32) {
        mpz_mul_2exp(z, z, 32);
        mpz_add_ui(z, z, (unsigned long)(random_bits(seed) >> 32));
    }
    if (kind < 10) mpz_fdiv_r_2exp(z, z, (mp_bitcnt_t)length);
    if (random_bits(seed) & 1) mpz_neg(z, z);
}

static inline void random_zpoly(uint64_t *seed, exact_zpoly *p, int n, int bits) {
    p->n = n;
    for (int k = 0; k <= n; k++) random_mpz(seed, p->c[k], bits);
    if (n >= 0 && mpz_sgn(p->c[n]) == 0) mpz_set_si(p->c[n], random_bits(seed) & 1 ? 1 : -1);
}

static inline void exact_from_zpoly(exact_zpoly *r, const algsurf_zpoly *p) {
    r->n = p->degree;
    for (int k = 0; k <= p->degree; k++) exact_limbs(r->c[k], algsurf_zpoly_at(p, k), p->width);
}

/* The limbs are the caller's to free; `more` limbs and leading zero coefficients than necessary. */
static inline algsurf_zpoly exact_to_zpoly(const exact_zpoly *p, int more_limbs, int more_terms) {
    size_t bits = 0;
    for (int k = 0; k <= p->n; k++)
        bits = bits > mpz_sizeinbase(p->c[k], 2) ? bits : mpz_sizeinbase(p->c[k], 2);
    algsurf_zpoly z = {p->n + more_terms, algsurf_z_width((int)bits) + more_limbs, NULL};
    z.c = calloc((size_t)(z.degree + 2) * (size_t)z.width, sizeof *z.c);
    if (!z.c) abort();
    for (int k = 0; k <= p->n; k++) {
        mpz_export(algsurf_zpoly_at(&z, k), NULL, -1, sizeof *z.c, 0, 0, p->c[k]);
        if (mpz_sgn(p->c[k]) < 0) algsurf_z_negate(algsurf_zpoly_at(&z, k), z.width);
    }
    return z;
}

/* Without leading zeros, a common power of two, limbs too many. */
static inline int exact_is_compact(const algsurf_zpoly *p) {
    if (p->degree < 0) return p->degree == -1;
    return algsurf_z_sign(algsurf_zpoly_at(p, p->degree), p->width) != 0 && algsurf_zpoly_trailing(p) == 0 &&
           p->width == algsurf_z_width(algsurf_zpoly_bits(p));
}
#endif
