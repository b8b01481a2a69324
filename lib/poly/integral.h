/* poly/integral.h - polynomials with integer coefficients, for exact decisions.
 *
 * All coefficients have the same width.  Functions that need room take it from the memory given, leave there
 * only what they return, and return 0 (nothing usable) when there is none.  A result's struct may be that of
 * an input. */
#ifndef ALGSURF_INTEGRAL_H
#define ALGSURF_INTEGRAL_H
#include "../base/integer.h"
#include "../base/memory.h"
#include "algsurf/poly.h"

typedef struct algsurf_zpoly {
    int degree;      /* -1: the zero polynomial */
    int width;       /* of each coefficient, in limbs */
    algsurf_limb *c; /* degree + 1 coefficients, lowest first */
} algsurf_zpoly;

static inline algsurf_limb *algsurf_zpoly_at(const algsurf_zpoly *p, int k) {
    return p->c + (size_t)k * (size_t)p->width;
}

/* Without leading zeros; nothing is copied. */
static inline algsurf_zpoly algsurf_zpoly_trimmed(const algsurf_zpoly *p) {
    algsurf_zpoly t = *p;
    while (t.degree >= 0 && algsurf_z_sign(algsurf_zpoly_at(&t, t.degree), t.width) == 0) t.degree--;
    return t;
}

int algsurf_zpoly_new(algsurf_memory *m, int degree, int width, algsurf_zpoly *p); /* all zero */
int algsurf_zpoly_copy(algsurf_memory *m, const algsurf_zpoly *a, int width, algsurf_zpoly *p);
/* Each coefficient plus, or minus, the one before it; then all but the first one again, and so on. */
static inline void algsurf_zpoly_join_neighbours(const algsurf_zpoly *p, int minus) {
    for (int i = 0; i < p->degree; i++)
        for (int k = p->degree; k > i; k--)
            algsurf_z_join(algsurf_zpoly_at(p, k), algsurf_zpoly_at(p, k - 1), p->width, minus);
}

/* From a caller's integers: OK; E_ZERO: all are 0; E_DEGREE; E_ARGUMENT: a negative degree, or no integers.
 */
algsurf_status algsurf_zpoly_check(const algsurf_integer *c, int degree);
int algsurf_zpoly_from_integers(algsurf_memory *m, const algsurf_integer *c, int degree, algsurf_zpoly *p);
/* From finite doubles c_0 = c[0], c_1 = c[step], ...: the exponent of the last bit that is set in any c_k
 * 2^(k unit), ALGSURF_Z_NO_BIT where there is none; and p_k = c_k 2^(k unit - least), without leading zeros,
 * for a `least` that is not above it. */
int algsurf_zpoly_least_bit(const double *c, int step, int degree, int unit);
int algsurf_zpoly_from_doubles(algsurf_memory *m, const double *c, int step, int degree, int unit, int least,
                               algsurf_zpoly *p);

int algsurf_zpoly_bits(const algsurf_zpoly *p);     /* the largest algsurf_z_bits of a coefficient */
int algsurf_zpoly_trailing(const algsurf_zpoly *p); /* the largest power of two that divides all of them */
/* Cuts leading zero coefficients, a common power of two, limbs too many; in place. */
void algsurf_zpoly_compact(algsurf_zpoly *p);
/* p / 2^zeros, which must divide p (ALGSURF_Z_NO_BIT: p = 0), with limbs too many cut off; the degree stays.
 */
void algsurf_zpoly_cut(algsurf_zpoly *p, int zeros);
/* The coefficients of p as factors; null without memory. */
algsurf_z_factor *algsurf_zpoly_factors(algsurf_memory *m, const algsurf_zpoly *p);
int algsurf_zpoly_derivative(algsurf_memory *m, const algsurf_zpoly *p, algsurf_zpoly *d);

/* The sign of p at N 2^-r (r of any sign; N has w limbs), -1, 0, 1, in *sign.  value, exponent: null, or p
 * there as value 2^exponent, 1/2 <= |value| <= 1, up to a relative error of 2^-52 (0, 0 for a root). */
int algsurf_zpoly_sign_at(algsurf_memory *m, const algsurf_zpoly *p, const algsurf_limb *N, int w, int r,
                          int *sign, double *value, int *exponent);

/* Bernstein coefficients of p over [at, at + 2^length_bits], times lcm C(n,k) and without a common power of
 * two: b gets degree and room of its own.  length_bits may be negative. */
int algsurf_zpoly_bernstein(algsurf_memory *m, const algsurf_zpoly *p, int64_t at, int length_bits,
                            algsurf_zpoly *b);

/* q = a / b if b divides a in Z[x] (*divides = 1); else *divides = 0.  b is primitive. */
int algsurf_zpoly_divide(algsurf_memory *m, const algsurf_zpoly *a, const algsurf_zpoly *b, int *divides,
                         algsurf_zpoly *q);
/* The greatest divisor of all coefficients taken out, in place of none: p = content * primitive. */
int algsurf_zpoly_primitive(algsurf_memory *m, const algsurf_zpoly *p, algsurf_zpoly *primitive);

/* poly/common.c: greatest common divisors. */

/* An upper bound on the degree of gcd(a, b) (b null: a'), 0 proves that it is constant: the least degree
 * modulo at most `tries` primes of 62 bits.  Both degrees at least 1. */
int algsurf_zpoly_gcd_degree(algsurf_memory *m, const algsurf_zpoly *a, const algsurf_zpoly *b, int tries,
                             int *degree);
/* a = g u, b = g v.  If !has_gcd, g was not made, and u and v lack the content of a. */
typedef struct algsurf_parts {
    algsurf_zpoly g, u, v;
    int has_gcd;
} algsurf_parts;

/* The parts of a and b (null: a'), with degrees of 1 at least, proved.  g is primitive with a positive
 * leading coefficient.  All that was taken stays taken: the caller sets a mark before.  Without b, g is not
 * made when it has a higher degree than u. */
int algsurf_zpoly_split(algsurf_memory *m, const algsurf_zpoly *a, const algsurf_zpoly *b, algsurf_parts *p);

/* poly/multiplicity.c. */

/* s[0], s[1], ...: s[i] holds, once each, the roots of p of multiplicity above i: with g_0 = p and
 * g_(i+1) = gcd(g_i, g_i'), s[i] is g_i / g_(i+1) up to a constant.  *count of them, the highest
 * multiplicity, 0 for a constant p; s[0] has all roots once.  count 1: p is squarefree, s[0] is p itself.
 * Equal members of the chain share their coefficients.  `s` has room for p->degree + 1 entries.  All that was
 * taken stays taken. */
int algsurf_zpoly_multiplicities(algsurf_memory *m, const algsurf_zpoly *p, algsurf_zpoly *s, int *count);
#endif
