/* exact_known.h - polynomials built from roots that are known exactly, for tests of the exact walk.
 *
 * A root is base + side sqrt(radicand), side -1, 0, 1, base and radicand rational: it can be compared with
 * any rational number by squaring, and with another such root at 6000 binary digits. */
#ifndef EXACT_KNOWN_H
#define EXACT_KNOWN_H
#include "exact_zpolys.h"
#include "unit.h"

enum { KNOWN_ROOTS = 128, KNOWN_DIGITS = 9000 };

typedef struct known_root {
    mpq_t base, radicand;
    mpf_t value;
    int side, multiplicity;
} known_root;

typedef struct known {
    exact_zpoly *p; /* in t */
    int count;      /* of roots, in order */
    known_root *root[KNOWN_ROOTS];
    mpq_t x, y, z; /* work space */
} known;

static inline void known_clear(known *k) {
    for (int i = 0; i < k->count; i++) {
        mpq_clears(k->root[i]->base, k->root[i]->radicand, NULL);
        mpf_clear(k->root[i]->value);
        free(k->root[i]);
    }
    k->count = 0;
    exact_zpoly_constant(k->p, 1);
}

static inline void known_free(void *made) {
    known *k = made;
    known_clear(k);
    mpq_clears(k->x, k->y, k->z, NULL);
    exact_zpoly_free(k->p);
    free(k);
}

/* Until the test ends. */
static inline known *known_new(void) {
    known *k = malloc(sizeof *k);
    if (!k) abort();
    k->p = exact_zpoly_new();
    k->count = 0;
    exact_zpoly_constant(k->p, 1);
    mpq_inits(k->x, k->y, k->z, NULL);
    return unit_keep(k, known_free);
}

/* p *= f0 + f1 t + f2 t^2. */
static inline void known_times(exact_zpoly *p, const mpz_t f0, const mpz_t f1, const mpz_t f2) {
    mpz_t sum;
    mpz_init(sum);
    int more = mpz_sgn(f2) ? 2 : 1;
    for (int i = 1; i <= more; i++) mpz_set_ui(p->c[p->n + i], 0);
    p->n += more;
    for (int i = p->n; i >= 0; i--) {
        mpz_mul(sum, p->c[i], f0);
        if (i > 0) mpz_addmul(sum, p->c[i - 1], f1);
        if (i > 1) mpz_addmul(sum, p->c[i - 2], f2);
        mpz_set(p->c[i], sum);
    }
    mpz_clear(sum);
}

/* The sign of (root - x). */
static inline int known_compare(const known_root *r, const mpq_t x) {
    mpq_t d, square;
    mpq_inits(d, square, NULL);
    mpq_sub(d, x, r->base);
    int sign = -mpq_sgn(d);
    if (r->side && sign * r->side >= 0) {
        sign = r->side;
    } else if (r->side) { /* |d| against the square root */
        mpq_mul(square, d, d);
        int c = mpq_cmp(r->radicand, square);
        sign = c == 0 ? 0 : c > 0 ? r->side : -r->side;
    }
    mpq_clears(d, square, NULL);
    return sign;
}

/* The sign of (root - x) for any double that is not NaN. */
static inline int known_compare_double(const known_root *r, double x) {
    if (isinf(x)) return x > 0 ? -1 : 1;
    mpq_t q;
    mpq_init(q);
    mpq_set_d(q, x);
    int sign = known_compare(r, q);
    mpq_clear(q);
    return sign;
}

static inline void known_insert(known *k, const mpq_t base, const mpq_t radicand, int side,
                                int multiplicity) {
    known_root *r = malloc(sizeof *r);
    if (!r || k->count == KNOWN_ROOTS) abort();
    mpq_inits(r->base, r->radicand, NULL);
    mpf_init2(r->value, KNOWN_DIGITS);
    mpq_set(r->base, base), mpq_set(r->radicand, radicand);
    r->side = side, r->multiplicity = multiplicity;
    mpf_set_q(r->value, radicand);
    mpf_sqrt(r->value, r->value);
    if (side < 0) mpf_neg(r->value, r->value);
    if (side == 0) mpf_set_ui(r->value, 0);
    mpf_t b;
    mpf_init2(b, KNOWN_DIGITS);
    mpf_set_q(b, base);
    mpf_add(r->value, r->value, b);
    mpf_clear(b);
    int at = 0;
    for (; at < k->count; at++) {
        known_root *o = k->root[at];
        if (o->side == side && mpq_equal(o->base, base) && (side == 0 || mpq_equal(o->radicand, radicand))) {
            o->multiplicity += multiplicity;
            mpq_clears(r->base, r->radicand, NULL);
            mpf_clear(r->value);
            free(r);
            return;
        }
    }
    for (at = k->count; at > 0 && mpf_cmp(k->root[at - 1]->value, r->value) > 0; at--)
        k->root[at] = k->root[at - 1];
    k->root[at] = r;
    k->count++;
}

/* (t - x)^multiplicity */
static inline void known_add(known *k, const mpq_t x, int multiplicity) {
    mpz_t f0, f2;
    mpq_t zero;
    mpz_inits(f0, f2, NULL), mpq_init(zero);
    mpz_neg(f0, mpq_numref(x));
    for (int i = 0; i < multiplicity; i++) known_times(k->p, f0, mpq_denref(x), f2);
    known_insert(k, x, zero, 0, multiplicity);
    mpz_clears(f0, f2, NULL), mpq_clear(zero);
}

/* ((t - base)^2 - radicand)^multiplicity; the radicand is negative or no square. */
static inline void known_add_pair(known *k, const mpq_t base, const mpq_t radicand, int multiplicity) {
    mpq_t c0, c1;
    mpz_t lcm, f0, f1;
    mpq_inits(c0, c1, NULL), mpz_inits(lcm, f0, f1, NULL);
    mpq_mul(c0, base, base), mpq_sub(c0, c0, radicand);
    mpq_add(c1, base, base), mpq_neg(c1, c1);
    mpz_lcm(lcm, mpq_denref(c0), mpq_denref(c1));
    mpz_divexact(f0, lcm, mpq_denref(c0)), mpz_mul(f0, f0, mpq_numref(c0));
    mpz_divexact(f1, lcm, mpq_denref(c1)), mpz_mul(f1, f1, mpq_numref(c1));
    for (int i = 0; i < multiplicity; i++) known_times(k->p, f0, f1, lcm);
    for (int side = -1; side <= 1 && mpq_sgn(radicand) > 0; side += 2)
        known_insert(k, base, radicand, side, multiplicity);
    mpq_clears(c0, c1, NULL), mpz_clears(lcm, f0, f1, NULL);
}

/* q = x 2^shift */
static inline void known_shift(mpq_t q, const mpq_t x, int shift) {
    if (shift >= 0)
        mpq_mul_2exp(q, x, (mp_bitcnt_t)shift);
    else
        mpq_div_2exp(q, x, (mp_bitcnt_t)-shift);
}

/* p as a polynomial in u, t = 2^unit u, without a common power of two; the limbs are the caller's to free. */
static inline algsurf_zpoly known_in_unit(const exact_zpoly *p, int unit) {
    exact_zpoly *q = exact_zpoly_new();
    int up = unit < 0 ? -unit : unit;
    mp_bitcnt_t common = ~(mp_bitcnt_t)0;
    q->n = p->n;
    for (int i = 0; i <= p->n; i++) {
        mpz_mul_2exp(q->c[i], p->c[i], (mp_bitcnt_t)(up * (unit < 0 ? p->n - i : i)));
        if (mpz_sgn(q->c[i]) && mpz_scan1(q->c[i], 0) < common) common = mpz_scan1(q->c[i], 0);
    }
    for (int i = 0; i <= p->n; i++) mpz_fdiv_q_2exp(q->c[i], q->c[i], common);
    algsurf_zpoly z = exact_to_zpoly(q, 0, 0);
    exact_zpoly_free(q);
    return z;
}

/* x = N 2^exponent */
static inline void known_of_limbs(mpq_t x, const algsurf_limb *N, int width, int exponent) {
    exact_limbs(mpq_numref(x), N, width);
    mpz_set_ui(mpq_denref(x), 1);
    known_shift(x, x, exponent);
}

static inline void known_print(const known *k) {
    fprintf(stderr, "p =");
    for (int i = 0; i <= k->p->n; i++) gmp_fprintf(stderr, " %+#Zx*t^%d", k->p->c[i], i);
    fprintf(stderr, "\n");
    for (int i = 0; i < k->count; i++) {
        const known_root *r = k->root[i];
        gmp_fprintf(stderr, "root %Qd %s sqrt(%Qd), %d times\n", r->base, r->side < 0 ? "-" : "+",
                    r->radicand, r->multiplicity);
    }
}
#endif
