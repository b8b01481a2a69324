/* test_common.c - common factors of integral polynomials, against products of known factors and against
 * Euclid's algorithm with GMP's integers.
 *
 * Breaks caught, each tried: an image of too high a degree not discarded, a prime that divides a leading
 * coefficient not skipped, a guess not proved, a gcd with content. */
#include "exact_zpolys.h"

#include "poly/residue.h"
#include "unit.h"

#define SEED 20240702u

typedef struct bench {
    exact_zpoly *a, *b, *f, *g, *u, *v, *t;
    uint64_t seed;
    uint64_t stack[4096];
    algsurf_memory m;
    algsurf_memory_mark empty;
} bench;

static void close_bench(void *made) {
    bench *t = made;
    exact_zpoly_free(t->a), exact_zpoly_free(t->b), exact_zpoly_free(t->f);
    exact_zpoly_free(t->g), exact_zpoly_free(t->u), exact_zpoly_free(t->t);
    exact_zpoly_free(t->v);
    free(t);
}

/* Until the test ends. */
static bench *open_bench(uint64_t seed) {
    bench *t = malloc(sizeof *t);
    if (!t) abort();
    *t = (bench){.seed = seed};
    t->a = exact_zpoly_new(), t->b = exact_zpoly_new(), t->f = exact_zpoly_new();
    t->g = exact_zpoly_new(), t->u = exact_zpoly_new(), t->t = exact_zpoly_new();
    t->v = exact_zpoly_new();
    algsurf_memory_begin(&t->m, t->stack, sizeof t->stack / sizeof *t->stack, (size_t)1 << 30);
    t->empty = algsurf_memory_here(&t->m);
    return unit_keep(t, close_bench);
}

static void failed(const bench *t, const char *what, int round) {
    exact_zpoly_print("a", t->a), exact_zpoly_print("b", t->b);
    exact_zpoly_print("wanted", t->f), exact_zpoly_print("gcd", t->g), exact_zpoly_print("cofactor", t->u);
    fail_msg("%s, seed %u round %d", what, SEED, round);
}

static void judge_parts(bench *t, const algsurf_parts *p, int round) {
    if (p->has_gcd) {
        exact_from_zpoly(t->g, &p->g);
        if (!exact_zpoly_equal(t->g, t->f)) failed(t, "gcd", round);
        exact_zpoly_multiply(t->t, t->g, t->u);
        if (!exact_zpoly_equal(t->t, t->a)) failed(t, "u", round);
        exact_zpoly_multiply(t->t, t->g, t->v);
        if (!exact_zpoly_equal(t->t, t->b)) failed(t, "v", round);
        return;
    }
    if (t->u->n + t->f->n != t->a->n) failed(t, "degree of u", round);
    exact_zpoly_multiply(t->t, t->u, t->b), exact_zpoly_multiply(t->g, t->v, t->a);
    if (!exact_zpoly_equal(t->t, t->g)) failed(t, "u a' = v a", round);
}

/* gcd(a, b) (or of a and a') must be f, up to sign and content; a = gcd u exactly, b = gcd v; without gcd, u
 * is a / f up to a constant, and u a' = v a. */
static void judge(bench *t, int own, int round) {
    algsurf_zpoly a = exact_to_zpoly(t->a, random_int(&t->seed, 2), random_int(&t->seed, 5) == 0);
    algsurf_zpoly b = exact_to_zpoly(t->b, random_int(&t->seed, 2), random_int(&t->seed, 5) == 0);
    algsurf_memory_mark here = algsurf_memory_here(&t->m);
    algsurf_parts p;
    int degree;
    exact_zpoly_primitive(t->f);
    assert_true(algsurf_zpoly_gcd_degree(&t->m, &a, own ? NULL : &b, 2, &degree));
    assert_true(t->m.at == here.at && t->m.last == here.last);
    if (degree < t->f->n) failed(t, "bound of the degree", round);
    if (t->a->n >= 1 && (own || t->b->n >= 1)) {
        assert_true(algsurf_zpoly_split(&t->m, &a, own ? NULL : &b, &p));
        assert_true(p.has_gcd || own);
        if (own) exact_zpoly_derive(t->b, t->a);
        exact_from_zpoly(t->u, &p.u), exact_from_zpoly(t->v, &p.v);
        judge_parts(t, &p, round);
    }
    algsurf_memory_release(&t->m, t->empty);
    exact_from_zpoly(t->t, &a); /* the arguments are as they were */
    t->t->n = t->t->n < t->a->n ? t->t->n : t->a->n;
    assert_true(exact_zpoly_equal(t->t, t->a));
    free(a.c), free(b.c);
}

static void euclid(bench *t) {
    exact_zpoly_set(t->f, t->a), exact_zpoly_set(t->t, t->b);
    exact_zpoly_euclid(t->f, t->t);
}

static int bits_for(uint64_t *seed, int round) {
    static const int most[] = {2, 8, 61, 62, 64, 130, 300, 2000};
    return most[round % 8] - (round % 8 > 5 ? random_int(seed, 100) : 0);
}

/* a = f r, b = f s with random r, s: f times what r and s share (mostly nothing). */
TEST(test_products) {
    bench *t = open_bench(SEED);
    int constant = 0, proper = 0, wide = 0;
    for (int i = 0; i < 1200; i++) {
        int size = i % 10 ? 5 : 14, bits = bits_for(&t->seed, i);
        if (size == 14 && bits > 300) bits = 300;
        random_zpoly(&t->seed, t->a, random_int(&t->seed, size), bits);
        random_zpoly(&t->seed, t->b, random_int(&t->seed, size), bits_for(&t->seed, i / 8));
        random_zpoly(&t->seed, t->f, random_int(&t->seed, size), bits);
        exact_zpoly_multiply(t->a, t->a, t->f);
        exact_zpoly_multiply(t->b, t->b, t->f);
        euclid(t);
        constant += t->f->n == 0, proper += t->f->n > 0 && t->f->n<t->a->n, wide += bits> 1000;
        judge(t, 0, i);
    }
    assert_true(constant > 100 && proper > 500 && wide > 50);
}

/* With a': products of powers, and squarefree ones. */
TEST(test_with_derivative) {
    bench *t = open_bench(SEED + 1);
    int squarefree = 0, powers = 0, mixed = 0;
    for (int i = 0; i < 800; i++) {
        int bits = bits_for(&t->seed, i), factors = random_int(&t->seed, 4);
        if (bits > 300) bits = 300;
        exact_zpoly_constant(t->a, random_int(&t->seed, 3) ? 1 : -36);
        for (int j = 0; j <= factors; j++) {
            random_zpoly(&t->seed, t->u, 1 + random_int(&t->seed, 3), bits);
            for (int k = random_int(&t->seed, 5); k >= 0; k--) exact_zpoly_multiply(t->a, t->a, t->u);
        }
        exact_zpoly_derive(t->b, t->a);
        euclid(t);
        squarefree += t->f->n == 0, powers += factors == 0, mixed += factors > 0 && t->f->n > 0;
        judge(t, 1, i);
        if (i % 4 == 0) judge(t, 0, i); /* the same, the derivative given */
    }
    assert_true(squarefree > 20 && powers > 100 && mixed > 300);
}

/* Leading coefficients that are multiples of the first primes, and roots that agree modulo these. */
TEST(test_unlucky_primes) {
    bench *t = open_bench(SEED + 2);
    mpz_t p;
    mpz_init(p);
    for (int i = 0; i < 300; i++) {
        algsurf_prime m = algsurf_prime_first();
        mpz_set_ui(p, 1);
        for (int j = 1 + random_int(&t->seed, 4); j > 0; j--) {
            mpz_t q;
            mpz_init(q);
            mpz_import(q, 1, -1, sizeof m.p, 0, 0, &m.p);
            if (random_int(&t->seed, 3)) mpz_mul(p, p, q);
            mpz_clear(q);
            m = algsurf_prime_next(&m);
        }
        random_zpoly(&t->seed, t->u, 1 + random_int(&t->seed, 4), 20);
        random_zpoly(&t->seed, t->f, random_int(&t->seed, 4), i & 1 ? 20 : 250);
        exact_zpoly_set(t->a, t->u), exact_zpoly_set(t->b, t->u);
        if (i % 3 == 0) { /* congruent factors */
            for (int k = 0; k <= t->b->n; k += 2) mpz_add(t->b->c[k], t->b->c[k], p);
            exact_zpoly_trim(t->b);
        } else if (i % 3 == 1) { /* vanishing leading coefficient */
            mpz_mul(t->a->c[t->a->n], t->a->c[t->a->n], p);
            mpz_mul(t->f->c[t->f->n], t->f->c[t->f->n], p);
        } else
            exact_zpoly_scale(t->f, p);
        exact_zpoly_multiply(t->a, t->a, t->f);
        exact_zpoly_multiply(t->b, t->b, t->f);
        euclid(t);
        judge(t, 0, i);
        exact_zpoly_multiply(t->a, t->a, t->b); /* nearly a square */
        exact_zpoly_derive(t->b, t->a);
        euclid(t);
        judge(t, 1, i);
    }
    mpz_clear(p);
}

/* b divides a, a divides b, both the same. */
TEST(test_divisors) {
    bench *t = open_bench(SEED + 3);
    for (int i = 0; i < 300; i++) {
        random_zpoly(&t->seed, t->a, 1 + random_int(&t->seed, 8), bits_for(&t->seed, i));
        random_zpoly(&t->seed, t->u, random_int(&t->seed, 8), 30);
        exact_zpoly_set(t->b, t->a);
        if (i & 1) exact_zpoly_primitive(t->a);
        exact_zpoly_multiply(t->b, t->b, t->u);
        euclid(t);
        judge(t, 0, i);
        exact_zpoly_set(t->u, t->a), exact_zpoly_set(t->a, t->b), exact_zpoly_set(t->b, t->u);
        judge(t, 0, i);
    }
}

TEST(test_constants_and_zero) {
    bench *t = open_bench(SEED + 4);
    for (int i = 0; i < 60; i++) {
        random_zpoly(&t->seed, t->a, random_int(&t->seed, 4) - 1, 70);
        random_zpoly(&t->seed, t->b, random_int(&t->seed, 2) - 1, 70);
        if (t->a->n < 0 && t->b->n < 0) continue;
        euclid(t);
        judge(t, 0, i);
    }
}

/* With every limit of memory either the right answer or none. */
TEST(test_out_of_memory) {
    bench *t = open_bench(SEED + 5);
    int failures = 0, successes = 0;
    random_zpoly(&t->seed, t->a, 12, 300);
    random_zpoly(&t->seed, t->f, 12, 300);
    exact_zpoly_multiply(t->b, t->f, t->f);
    exact_zpoly_multiply(t->a, t->a, t->b);
    algsurf_zpoly a = exact_to_zpoly(t->a, 0, 0);
    algsurf_parts p;
    exact_zpoly_derive(t->b, t->a);
    exact_zpoly_primitive(t->f);
    for (size_t size = 1; size < 4096; size += 13) {
        algsurf_memory m;
        algsurf_memory_begin(&m, t->stack, size, 0);
        if (algsurf_zpoly_split(&m, &a, NULL, &p)) {
            exact_from_zpoly(t->u, &p.u), exact_from_zpoly(t->v, &p.v);
            judge_parts(t, &p, (int)size);
            successes++;
        } else
            failures++;
    }
    assert_true(failures > 20 && successes > 20);
    free(a.c);
}

/* A large one: degree 512, in blocks that are allocated. */
TEST(test_large) {
    bench *t = open_bench(SEED + 6);
    random_zpoly(&t->seed, t->a, 60, 4000);
    random_zpoly(&t->seed, t->b, 40, 3000);
    random_zpoly(&t->seed, t->f, 2, 500);
    mpz_set_ui(t->a->c[0], 1); /* 0 is a root of f at most */
    exact_zpoly_multiply(t->a, t->a, t->f), exact_zpoly_multiply(t->b, t->b, t->f);
    judge(t, 0, 0);
    random_zpoly(&t->seed, t->f, 128, 12);
    exact_zpoly_multiply(t->b, t->f, t->f);
    random_zpoly(&t->seed, t->a, 256, 12);
    mpz_set_ui(t->a->c[0], 1);
    exact_zpoly_multiply(t->a, t->a, t->b);
    judge(t, 1, 1);
}
