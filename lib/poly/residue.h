/* poly/residue.h - integers and polynomials modulo primes of 62 bits.
 *
 * A residue is a limb below p.  Products are Montgomery's: times(a, b) = a b / R with R = 2^64, so that times
 * is the product of numbers kept as a R mod p ("in Montgomery's form"). */
#ifndef ALGSURF_RESIDUE_H
#define ALGSURF_RESIDUE_H
#include "../base/integer.h"
#include "../base/wide.h"

typedef struct algsurf_prime {
    algsurf_limb p;
    algsurf_limb negative_inverse; /* -1/p modulo R */
    algsurf_limb one, square;      /* R and R^2 modulo p: 1 and R in Montgomery's form */
    int index;                     /* 0: the largest prime below 2^62, 1: the next one below, ... */
} algsurf_prime;

algsurf_prime algsurf_prime_first(void);
algsurf_prime algsurf_prime_next(const algsurf_prime *before);

/* (high R + low) / R, for high < p.  With q = low (-1/p) mod R, low + q p is a multiple of R, and the sum is
 * below p R + R p, so that one subtraction suffices. */
static inline algsurf_limb algsurf_residue_reduce(algsurf_limb high, algsurf_limb low,
                                                  const algsurf_prime *m) {
    algsurf_limb carry;
    (void)algsurf_limb_product(low * m->negative_inverse, m->p, low, 0, &carry);
    algsurf_limb r = high + carry;
    return r >= m->p ? r - m->p : r;
}

/* a b / R, for a b < p R: a or b may be any limb when the other one is a residue. */
static inline algsurf_limb algsurf_residue_times(algsurf_limb a, algsurf_limb b, const algsurf_prime *m) {
    algsurf_limb high, low = algsurf_limb_product(a, b, 0, 0, &high);
    return algsurf_residue_reduce(high, low, m);
}

static inline algsurf_limb algsurf_residue_minus(algsurf_limb a, algsurf_limb b, const algsurf_prime *m) {
    return a >= b ? a - b : a + m->p - b;
}

/* a^e in Montgomery's form. */
algsurf_limb algsurf_residue_power(algsurf_limb a, algsurf_limb e, const algsurf_prime *m);

/* 1/a in Montgomery's form, a not 0. */
algsurf_limb algsurf_residue_inverse(algsurf_limb a, const algsurf_prime *m);

/* r[k] = R^(-w) times the k-th of `count` integers of w limbs each. */
void algsurf_residues_of(algsurf_limb *r, const algsurf_limb *a, int count, int w, const algsurf_prime *m);

/* The derivative of a (degree n), divided by R. */
void algsurf_residues_derive(algsurf_limb *r, const algsurf_limb *a, int n, const algsurf_prime *m);

/* A multiple of gcd(a, b), left in *a or in *b: *gcd points to it; returns its degree.  Both are destroyed.
 * a has degree da >= 0, its leading coefficient is not 0; b has degree at most db, or is 0. */
int algsurf_residues_gcd(algsurf_limb *a, int da, algsurf_limb *b, int db, algsurf_limb **gcd,
                         const algsurf_prime *m);

/* a / b, for b of degree db monic in Montgomery's form (b[db] is not read): quotient in a[db .. da], the
 * remainder below it. */
void algsurf_residues_divide(algsurf_limb *a, int da, const algsurf_limb *b, int db, const algsurf_prime *m);
#endif
