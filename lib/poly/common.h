/* poly/common.h - common factors of integer polynomials, for common.c and multiplicity.c. */
#ifndef ALGSURF_COMMON_H
#define ALGSURF_COMMON_H
#include "../base/wide.h"
#include "integral.h"

static inline int algsurf_larger(int a, int b) { return a > b ? a : b; }
static inline int algsurf_smaller(int a, int b) { return a < b ? a : b; }
static inline int algsurf_bits_of_int(int a) { return algsurf_limb_bits((algsurf_limb)a); }

static inline size_t algsurf_zpoly_words(const algsurf_zpoly *p) {
    return (size_t)(p->degree + 1) * (size_t)p->width;
}

/* Without leading zeros; nothing is copied. */
static inline algsurf_zpoly algsurf_zpoly_trimmed(const algsurf_zpoly *p) {
    algsurf_zpoly t = *p;
    while (t.degree >= 0 && algsurf_z_sign(algsurf_zpoly_at(&t, t.degree), t.width) == 0) t.degree--;
    return t;
}

/* Limbs for the coefficients of any factor of a in Z[x], of degree at most e (Mignotte): |c| <= 2^e |a|_2. */
static inline int algsurf_zpoly_factor_width(const algsurf_zpoly *a, int e) {
    return algsurf_z_width(algsurf_zpoly_bits(a) + 1 + e + (algsurf_bits_of_int(a->degree + 1) + 1) / 2);
}

/* a = g u, b = g v.  If !has_gcd, g was not made, and u and v lack the content of a. */
typedef struct algsurf_parts {
    algsurf_zpoly g, u, v;
    int has_gcd;
} algsurf_parts;

/* The parts of a and b (null: a'), with degrees of 1 at least and no leading zeros.  g is primitive with a
 * positive leading coefficient.  All that was taken stays taken: the caller sets a mark before.  Without b, g
 * is not made when it has a higher degree than u. */
int algsurf_zpoly_split(algsurf_memory *m, const algsurf_zpoly *a, const algsurf_zpoly *b, algsurf_parts *p);

/* A place for results, taken before their sizes are known. */
typedef struct algsurf_place {
    algsurf_memory_mark before, after;
    algsurf_limb *at;
} algsurf_place;

int algsurf_place_begin(algsurf_place *r, algsurf_memory *m, size_t words);
void algsurf_place_copy(algsurf_place *r, const algsurf_zpoly *p, algsurf_zpoly *copy);
/* Gives back everything behind what was copied; after a failure (done = 0) all of it.  Returns done. */
int algsurf_place_end(algsurf_place *r, algsurf_memory *m, int done);
#endif
