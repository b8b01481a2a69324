/* test_exact_sign.c - the sign of a line or a concave parabola at a root, exactly.
 *
 * At base + side sqrt(radicand) q is x + y side sqrt(radicand) with rational x and y, whose sign follows from
 * squares.  Shared roots, near misses by 2^-k, and q far away; at roots that were refined or not.
 *
 * Breaks caught, each tried: shared roots not looked for (no end), or all common factors taken for shared
 * roots; a parabola negative at both ends taken for negative between; outer parts of a zoom not proved;
 * memory not given back. */
#include "exact_known.h"

#include "roots/exact_walk.h"
#include "unit.h"

#define SEED 20250312u

static uint64_t stack[700];

/* The sign of q (in t) at the root. */
static int true_sign(const exact_zpoly *q, const known_root *r) {
    mpq_t c, x, y, t;
    mpq_inits(c, x, y, t, NULL);
    for (int k = q->n; k >= 0; k--) { /* (x + y s) (base + s) + c */
        mpq_mul(t, y, r->radicand);
        mpq_mul(y, y, r->base), mpq_add(y, y, x);
        mpq_mul(x, x, r->base), mpq_add(x, x, t);
        mpq_set_z(c, q->c[k]), mpq_add(x, x, c);
    }
    if (r->side < 0) mpq_neg(y, y);
    int sx = mpq_sgn(x), sy = r->side ? mpq_sgn(y) : 0, sign = sx ? sx : sy;
    if (sx * sy < 0) {
        mpq_mul(x, x, x), mpq_mul(y, y, y), mpq_mul(y, y, r->radicand);
        sign = mpq_cmp(x, y) > 0 ? sx : mpq_equal(x, y) ? 0 : sy;
    }
    mpq_clears(c, x, y, t, NULL);
    return sign;
}

/* Judges q at all roots of k; returns how many are shared. */
static int judge(const known *k, const exact_zpoly *q, int unit, int refine, int round) {
    algsurf_memory m;
    algsurf_exact_walk walk;
    algsurf_exact_root r;
    algsurf_zpoly p = known_in_unit(k->p, unit), f = known_in_unit(q, unit);
    int i = 0, shared = 0, found;
    algsurf_memory_begin(&m, stack, (size_t)(round % 700), (size_t)1 << 28);
    assert_true(algsurf_exact_begin(&walk, &m, &p, unit, -HUGE_VAL, HUGE_VAL, refine, NULL));
    for (; (found = algsurf_exact_next(&walk, &r)) == ALGSURF_EXACT_ROOT; i++) {
        int sign = 5, truth = true_sign(q, k->root[i]);
        algsurf_memory_mark before = algsurf_memory_here(&m);
        assert_true(algsurf_exact_sign_at_root(&walk, &r, &f, &sign));
        assert_true(m.at == before.at && m.last == before.last);
        if (sign != truth) {
            known_print(k), exact_zpoly_print("q", q);
            fail_msg("sign %d in place of %d at root %d, refine %d, round %d seed %u", sign, truth, i, refine,
                     round, SEED);
        }
        shared += truth == 0;
    }
    assert_int_equal(found, ALGSURF_EXACT_END);
    assert_int_equal(i, k->count);
    algsurf_exact_end(&walk);
    assert_true(m.at == stack && m.allocated == 0);
    free(p.c), free(f.c);
    return shared;
}

static void random_rational(uint64_t *seed, mpq_t x) {
    long denominator = 1 + random_int(seed, 40);
    mpq_set_si(x, (long)random_int(seed, (int)(4 * denominator)) - 2 * denominator,
               (unsigned long)denominator);
    mpq_canonicalize(x);
}

static void random_pair(uint64_t *seed, known *k) {
    random_rational(seed, k->x);
    mpq_set_ui(k->y, 2, 1ul << (2 * random_int(seed, 8)));
    mpq_canonicalize(k->y);
}

/* q's roots: shared ones (kind 0), near misses (kind 1), anything (kind 2); of degree 1 or 2. */
static void make_condition(uint64_t *seed, known *q, const known *k, int kind, int degree) {
    const known_root *r = k->root[random_int(seed, k->count)];
    known_clear(q);
    mpq_set(q->x, r->base), mpq_set(q->y, r->radicand);
    if (kind == 2) random_pair(seed, q);
    if (kind == 1) {
        mpq_set_si(q->z, random_bits(seed) & 1 ? 1 : -1, 1);
        known_shift(q->z, q->z, -1 - random_int(seed, 120));
        mpq_add(q->x, q->x, q->z);
    }
    if (degree == 1) {
        known_add(q, q->x, 1);
    } else if (mpq_sgn(q->y) != 0) {
        if (kind == 2 && random_int(seed, 4) == 0) mpq_neg(q->y, q->y); /* negative everywhere */
        known_add_pair(q, q->x, q->y, 1);
    } else {
        known_add(q, q->x, 1);
        if (random_int(seed, 3)) random_rational(seed, q->x);
        known_add(q, q->x, 1);
    }
    int negate = degree == 2 || (random_bits(seed) & 1);
    for (int i = 0; i <= q->p->n && negate; i++) mpz_neg(q->p->c[i], q->p->c[i]);
}

TEST(test_conditions) {
    uint64_t seed = SEED;
    known *k = known_new(), *q = known_new();
    int shared[3] = {0}, rounds[3] = {0};
    for (int i = 0; i < 6000; i++) {
        int kind = random_int(&seed, 3);
        known_clear(k);
        for (int j = 1 + random_int(&seed, 3); j > 0; j--) {
            random_pair(&seed, k);
            int multiplicity = random_int(&seed, 4) ? 1 : 1 + random_int(&seed, 3);
            if (random_bits(&seed) & 1)
                known_add_pair(k, k->x, k->y, multiplicity);
            else
                known_add(k, k->x, multiplicity);
        }
        make_condition(&seed, q, k, kind, 1 + random_int(&seed, 2));
        shared[kind] += judge(k, q->p, random_int(&seed, 12) - 6, i % 2, i);
        rounds[kind]++;
    }
    assert_true(shared[0] > 1500 && rounds[1] > 1500 && rounds[2] > 1500);
}

/* p = q r, as where a surface contains its extent's boundary; and constants. */
TEST(test_factor) {
    uint64_t seed = SEED + 1;
    known *k = known_new(), *q = known_new();
    int shared = 0;
    for (int i = 0; i < 500; i++) {
        known_clear(k), known_clear(q);
        random_pair(&seed, k);
        known_add_pair(q, k->x, k->y, 1);
        known_add_pair(k, k->x, k->y, 1 + i % 2);
        random_pair(&seed, k);
        known_add_pair(k, k->x, k->y, 1);
        for (int j = 0; j <= 2; j++) mpz_neg(q->p->c[j], q->p->c[j]);
        shared += judge(k, q->p, 0, i % 3 == 0, i);
        exact_zpoly_constant(q->p, i % 3 - 1);
        judge(k, q->p, 0, 1, i);
    }
    assert_true(shared >= 1000);
}
