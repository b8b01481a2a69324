/* power.c - is P exactly c Q^k?
 *
 * Rays then ask Q, whose roots are simple where P's are k-fold: doubles decide them.
 *
 * P is a number times a primitive polynomial with integer coefficients, A; if P = c Q^k for any Q, then A =
 * +-Q^k for a primitive one (Gauss).  In the order of a surface's terms the first one of a product is the
 * product of the first ones, and so is the last one: k divides their exponents, and the first coefficient of
 * Q is the k-th root of A's, an integer.  With x, y, z = T, T^N, T^(N^2), N = degree + 1, A and Q are
 * polynomials in T, one place for each term, and A' Q = k A Q': for A_E, Q_F the first coefficients, E = k F,
 *     A_E Q_f (E - k f) = sum over f' > f, e = E + f - f' of A_e Q_f' (k f' - e).
 * So the coefficients of Q follow one from another, here modulo a prime of 62 bits.  Those of a Q that can be
 * stored, |Q_f| < 2^53, are the residues of least size; if A is no power, the first one that is not 0 is too
 * large as a rule.  Last, A' Q = k A Q' is verified modulo so many primes that both sides are equal, whose
 * coefficients are at most 2 E max |A_e| sum |Q_f|.  Then A / Q^k has derivative 0, and its first
 * coefficient is 1.
 *
 * What is no power costs some microseconds as a rule. */
#include "../base/arithmetic.h"
#include "impl.h"

#include <limits.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "../base/elementary.h"
#include "../base/fpenv.h"
#include "../poly/residue.h"

#define LARGEST ((algsurf_limb)1 << 53)
#define POINT 0x123456789abcdefu /* any residue */

/* One coefficient: +-magnitude 2^shift, in place `at` of the polynomials in T. */
typedef struct place {
    size_t at;
    algsurf_limb magnitude;
    int shift, negative;
} place;

typedef struct search {
    const algsurf_surface *s;
    int k;
    place *a;                 /* A's coefficients, the first one positive */
    place *q;                 /* Q's, in the same order: first place first */
    size_t count;             /* of Q's */
    algsurf_limb *residue;    /* Q's modulo a prime, in Montgomery's form, as all residues here */
    algsurf_limb *dense;      /* A's modulo the first prime, by place */
    algsurf_limb *difference; /* twice as many places: A' Q - k A Q' */
} search;

static size_t place_of(const search *p, int i, int j, int k) {
    const size_t n = (size_t)p->s->degree + 1;
    return ((size_t)k * n + (size_t)j) * n + (size_t)i;
}

static algsurf_limb gcd(algsurf_limb a, algsurf_limb b) {
    while (b) {
        algsurf_limb rest = a % b;
        a = b, b = rest;
    }
    return a;
}

/* A: the terms without their common number. */
static void set_integers(search *p) {
    algsurf_limb content = 0;
    int least = INT_MAX;
    for (size_t t = 0; t < p->s->term_count; t++) {
        const algsurf_term *term = p->s->terms + t;
        place *to = p->a + t;
        to->at = place_of(p, term->i, term->j, term->k);
        to->magnitude = algsurf_z_odd_part(fabs(term->a), &to->shift);
        to->negative = (term->a < 0) != (p->s->terms[0].a < 0);
        content = gcd(to->magnitude, content);
        least = to->shift < least ? to->shift : least;
    }
    for (size_t t = 0; t < p->s->term_count; t++) p->a[t].magnitude /= content, p->a[t].shift -= least;
}

/* r^k = x 2^shift for an integer r < 2^53? */
static algsurf_limb root_of(algsurf_limb x, int shift, int k) {
    if (shift % k) return 0;
    const algsurf_limb odd = (algsurf_limb)lrint(algsurf_i_exp2(algsurf_i_log2((double)x) / k));
    algsurf_limb rest = x;
    for (int i = 0; i < k; i++) {
        if (rest % odd) return 0;
        rest /= odd;
    }
    return rest == 1 && algsurf_limb_bits(odd) + shift / k <= 53 ? odd << shift / k : 0;
}

/* ---- modulo a prime ---- */

static algsurf_limb plus(algsurf_limb a, algsurf_limb b, const algsurf_prime *m) {
    return algsurf_residue_minus(a, b ? m->p - b : 0, m);
}

static algsurf_limb residue(algsurf_limb magnitude, int shift, int negative, const algsurf_prime *m) {
    algsurf_limb r = algsurf_residue_times(magnitude, m->square, m);
    if (shift > 0) {
        algsurf_limb two = algsurf_residue_times(2, m->square, m);
        r = algsurf_residue_times(r, algsurf_residue_power(two, (algsurf_limb)shift, m), m);
    }
    return negative && r ? m->p - r : r;
}

static algsurf_limb residue_of(const place *c, const algsurf_prime *m) {
    return residue(c->magnitude, c->shift, c->negative, m);
}

static algsurf_limb difference(size_t a, size_t b, const algsurf_prime *m) {
    return residue(a > b ? a - b : b - a, 0, a < b, m);
}

/* The sum for Q_f. */
static algsurf_limb known_part(const search *p, size_t f, const algsurf_prime *m) {
    const size_t first = p->a[0].at, k = (size_t)p->k;
    algsurf_limb sum = 0;
    for (size_t t = 0; t < p->count; t++) {
        const size_t e = first + f - p->q[t].at;
        if (!p->dense[e]) continue;
        const algsurf_limb term = algsurf_residue_times(p->dense[e], p->residue[t], m);
        sum = plus(sum, algsurf_residue_times(term, difference(k * p->q[t].at, e, m), m), m);
    }
    return sum;
}

/* Adds Q_f to Q if it is not 0; returns 0 if it is too large. */
static int add_coefficient(search *p, size_t f, const algsurf_prime *m) {
    algsurf_limb value = known_part(p, f, m);
    if (!value) return 1;
    algsurf_limb by = residue(p->a[0].at - (size_t)p->k * f, 0, 0, m);
    by = algsurf_residue_times(by, p->dense[p->a[0].at], m);
    value = algsurf_residue_times(value, algsurf_residue_inverse(by, m), m);
    const algsurf_limb plain = algsurf_residue_reduce(0, value, m);
    const int negative = plain > m->p / 2;
    p->residue[p->count] = value;
    p->q[p->count++] = (place){f, negative ? m->p - plain : plain, 0, negative};
    return p->q[p->count - 1].magnitude < LARGEST;
}

/* The only Q that there may be; 0: there is none. */
static int find_root(search *p) {
    const algsurf_prime m = algsurf_prime_first();
    const int degree = p->s->degree / p->k;
    const algsurf_limb first = root_of(p->a[0].magnitude, p->a[0].shift, p->k);
    if (!first) return 0;
    p->q[0] = (place){p->a[0].at / (size_t)p->k, first, 0, 0};
    p->residue[0] = residue(first, 0, 0, &m);
    p->count = 1;
    for (int k = degree; k >= 0; k--)
        for (int j = degree - k; j >= 0; j--)
            for (int i = degree - k - j; i >= 0; i--) {
                const size_t f = place_of(p, i, j, k);
                if (f < p->q[0].at && !add_coefficient(p, f, &m)) return 0;
            }
    return 1;
}

/* Is A' Q = k A Q' modulo a prime? */
static int is_power_modulo(search *p, const algsurf_prime *m) {
    const size_t last = p->a[0].at + p->q[0].at, k = (size_t)p->k;
    memset(p->difference, 0, (last + 1) * sizeof *p->difference);
    for (size_t t = 0; t < p->count; t++) p->residue[t] = residue_of(p->q + t, m);
    for (size_t t = 0; t < p->s->term_count; t++) {
        const algsurf_limb a = residue_of(p->a + t, m);
        for (size_t u = 0; u < p->count; u++) {
            const algsurf_limb factor = difference(p->a[t].at, k * p->q[u].at, m);
            algsurf_limb *to = p->difference + p->a[t].at + p->q[u].at;
            *to = plus(*to, algsurf_residue_times(algsurf_residue_times(a, p->residue[u], m), factor, m), m);
        }
    }
    for (size_t e = 0; e <= last; e++)
        if (p->difference[e]) return 0;
    return 1;
}

/* A polynomial in T at POINT, by Horner's rule. */
static algsurf_limb value_of(const place *c, size_t count, const algsurf_prime *m) {
    algsurf_limb sum = 0;
    for (size_t t = 0; t < count; t++) {
        const size_t gap = c[t].at - (t + 1 < count ? c[t + 1].at : 0);
        sum = plus(sum, residue_of(c + t, m), m);
        sum = algsurf_residue_times(sum, algsurf_residue_power(POINT, gap, m), m);
    }
    return sum;
}

/* Do Q^k and A agree at some point, modulo a prime?  If they are different, as a rule not. */
static int agree_at_a_point(const search *p) {
    const algsurf_prime m = algsurf_prime_first();
    const algsurf_limb q = value_of(p->q, p->count, &m);
    return algsurf_residue_power(q, (algsurf_limb)p->k, &m) == value_of(p->a, p->s->term_count, &m);
}

/* Q^k = A? */
static int is_power(search *p) {
    int bits = 3; /* of a coefficient of the difference: sums, and the sign */
    for (size_t t = 0; t < p->s->term_count; t++) {
        const int more = 3 + p->a[t].shift + algsurf_limb_bits(p->a[t].magnitude);
        bits = more > bits ? more : bits;
    }
    algsurf_limb sum = 0;
    for (size_t t = 0; t < p->count; t++) sum += p->q[t].magnitude >> 16; /* below 2^(37 + 13) */
    bits += 16 + algsurf_limb_bits(sum + p->count) + algsurf_limb_bits(2 * p->a[0].at);
    if (!agree_at_a_point(p)) return 0;
    algsurf_prime m = algsurf_prime_first();
    for (int proved = 0; proved < bits; proved += 61, m = algsurf_prime_next(&m))
        if (!is_power_modulo(p, &m)) return 0;
    return 1;
}

/* ---- a surface ---- */

/* P's sign decides that of c or, where k is odd, that of Q. */
static algsurf_status keep(const search *p, algsurf_surface *s) {
    const int n = s->degree + 1, negative = p->k % 2 && s->terms[0].a < 0;
    algsurf_term *terms = malloc(p->count * sizeof *terms);
    if (!terms) return ALGSURF_E_NO_MEMORY;
    for (size_t t = 0; t < p->count; t++) {
        const int at = (int)p->q[t].at;
        const double a = (double)p->q[t].magnitude;
        terms[t] = (algsurf_term){at % n, at / n % n, at / n / n, p->q[t].negative != negative ? -a : a};
    }
    s->power = p->k;
    s->power_sign = p->k % 2 || s->terms[0].a > 0 ? 1 : -1;
    algsurf_status status = algsurf_i_surface_make(terms, p->count, 0, 0, &s->root);
    free(terms);
    return status;
}

/* The greatest k that P's exponents allow. */
static int most_power(const algsurf_surface *s) {
    const algsurf_term *first = s->terms, *last = s->terms + s->term_count - 1;
    const int exponents[] = {first->i, first->j, first->k, last->i, last->j, last->k};
    algsurf_limb most = (algsurf_limb)s->degree;
    for (int i = 0; i < 6; i++) most = gcd((algsurf_limb)exponents[i], most);
    return (int)most;
}

ALGSURF_NOINLINE algsurf_status algsurf_i_surface_find_power(algsurf_surface *s) {
    const int most = s->error > 0 ? 0 : most_power(s);
    if (most < 2) return ALGSURF_OK;
    const size_t n = (size_t)s->degree + 1, count = s->term_count, half = n / 2 + 1;
    const size_t places = n * n * n, of_root = half * half * half;
    search p = {.s = s};
    p.a = malloc((count + of_root) * sizeof *p.a);
    p.dense = calloc(3 * places + of_root, sizeof *p.dense);
    algsurf_status status = p.a && p.dense ? ALGSURF_OK : ALGSURF_E_NO_MEMORY;
    if (status == ALGSURF_OK) {
        const algsurf_prime m = algsurf_prime_first();
        p.q = p.a + count, p.difference = p.dense + places, p.residue = p.difference + 2 * places;
        set_integers(&p);
        for (size_t t = 0; t < count; t++) p.dense[p.a[t].at] = residue_of(p.a + t, &m);
        for (p.k = most; p.k >= 2 && !s->root && status == ALGSURF_OK; p.k--)
            if (most % p.k == 0 && find_root(&p) && is_power(&p)) status = keep(&p, s);
    }
    free(p.a);
    free(p.dense);
    return status;
}
