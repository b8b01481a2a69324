/* test_multiplicity.c - roots by multiplicity: products of powers of known coprime squarefree factors.
 *
 * Breaks caught, each tried: a chain without the members that repeat, a step that forgets k u', a share of
 * the degree not reduced, memory not given back, the first member with too few roots. */
#include "exact_zpolys.h"
#include "unit.h"

#define SEED 20240703u
#define MOST 64 /* the highest multiplicity, but for the large ones */

typedef struct bench {
    exact_zpoly *p, *f, *s, *t;
    exact_zpoly *wanted[MOST]; /* wanted[i]: the product of the factors with multiplicity above i */
    int count;
    uint64_t seed;
    uint64_t stack[2048];
    algsurf_memory m;
} bench;

static void close_bench(void *made) {
    bench *t = made;
    exact_zpoly_free(t->p), exact_zpoly_free(t->f), exact_zpoly_free(t->s), exact_zpoly_free(t->t);
    for (int i = 0; i < MOST; i++) exact_zpoly_free(t->wanted[i]);
    free(t);
}

/* Until the test ends. */
static bench *open_bench(uint64_t seed) {
    bench *t = malloc(sizeof *t);
    if (!t) abort();
    *t = (bench){.seed = seed};
    t->p = exact_zpoly_new(), t->f = exact_zpoly_new(), t->s = exact_zpoly_new(), t->t = exact_zpoly_new();
    for (int i = 0; i < MOST; i++) t->wanted[i] = exact_zpoly_new();
    return unit_keep(t, close_bench);
}

static void begin(bench *t, long content) {
    exact_zpoly_constant(t->p, content);
    t->count = 0;
    for (int i = 0; i < MOST; i++) exact_zpoly_constant(t->wanted[i], 1);
}

static int is_constant_gcd(bench *t, const exact_zpoly *a, const exact_zpoly *b) {
    exact_zpoly_set(t->s, a), exact_zpoly_set(t->t, b);
    exact_zpoly_euclid(t->s, t->t);
    return t->s->n == 0;
}

/* p *= f^k, if f is squarefree and new. */
static void join(bench *t, int k) {
    exact_zpoly *d = exact_zpoly_new();
    exact_zpoly_derive(d, t->f);
    int fits = t->f->n > 0 && is_constant_gcd(t, t->f, d) && is_constant_gcd(t, t->f, t->wanted[0]) &&
               t->p->n + k * t->f->n <= EXACT_DEGREE;
    for (int i = 0; i < k && fits; i++) {
        exact_zpoly_multiply(t->p, t->p, t->f);
        exact_zpoly_multiply(t->wanted[i], t->wanted[i], t->f);
    }
    if (fits && k > t->count) t->count = k;
    exact_zpoly_free(d);
}

static void failed(const bench *t, const char *what, int round, int i) {
    exact_zpoly_print("p", t->p);
    exact_zpoly_print("found", t->s);
    if (i < MOST) exact_zpoly_print("wanted", t->wanted[i]);
    fail_msg("%s %d, seed %u round %d", what, i, SEED, round);
}

static void judge(bench *t, int round) {
    algsurf_zpoly p = exact_to_zpoly(t->p, random_int(&t->seed, 2), random_int(&t->seed, 5) == 0);
    algsurf_zpoly *s = malloc((size_t)(p.degree + 1) * sizeof *s);
    int count;
    if (!s) abort();
    algsurf_memory_begin(&t->m, t->stack, sizeof t->stack / sizeof *t->stack, (size_t)1 << 30);
    algsurf_memory_mark empty = algsurf_memory_here(&t->m);
    assert_true(algsurf_zpoly_multiplicities(&t->m, &p, s, &count));
    if (count != t->count) failed(t, "count", round, count);
    for (int i = 0; i < count; i++) {
        exact_from_zpoly(t->s, s + i);
        exact_zpoly_primitive(t->s), exact_zpoly_primitive(t->wanted[i]);
        if (!exact_zpoly_equal(t->s, t->wanted[i])) failed(t, "member", round, i);
    }
    algsurf_memory_release(&t->m, empty);
    free(s), free(p.c);
}

TEST(test_products) {
    static const int most_bits[] = {2, 5, 40, 62, 64, 200, 1000};
    bench *t = open_bench(SEED);
    int squarefree = 0, uniform = 0, mixed = 0;
    for (int i = 0; i < 700; i++) {
        int bits = most_bits[i % 7], factors = 1 + random_int(&t->seed, 4);
        begin(t, i % 5 ? 1 : i % 3 ? -360 : 1L << 40);
        for (int j = 0; j < factors; j++) {
            random_zpoly(&t->seed, t->f, 1 + random_int(&t->seed, 4), bits);
            join(t, 1 + random_int(&t->seed, i % 4 ? 8 : 2) * (bits < 1000));
        }
        if (t->count == 0) continue;
        int distinct = 1;
        for (int k = 1; k < t->count; k++) distinct += t->wanted[k]->n != t->wanted[k - 1]->n;
        squarefree += t->count == 1, uniform += t->count > 1 && distinct == 1, mixed += distinct > 1;
        judge(t, i);
    }
    assert_true(squarefree > 50 && uniform > 100 && mixed > 200);
}

TEST(test_powers) {
    bench *t = open_bench(SEED + 1);
    for (int i = 0; i < 30; i++) {
        begin(t, i % 2 ? 1 : 6);
        random_zpoly(&t->seed, t->f, 1 + i % 4, 20 + 10 * i);
        join(t, 2 + random_int(&t->seed, MOST - 2) % (i % 4 == 3 ? 16 : MOST - 2));
        if (t->count) judge(t, i);
    }
}

/* (1 - x)^512, and prod (x - i)^i for i to 30. */
TEST(test_large) {
    bench *t = open_bench(SEED + 2);
    algsurf_zpoly s[513];
    int count;
    t->f->n = 1;
    mpz_set_si(t->f->c[0], 1), mpz_set_si(t->f->c[1], -1);
    exact_zpoly_set(t->p, t->f);
    for (int i = 0; i < 9; i++) exact_zpoly_multiply(t->p, t->p, t->p);
    algsurf_zpoly p = exact_to_zpoly(t->p, 0, 0);
    algsurf_memory_begin(&t->m, t->stack, sizeof t->stack / sizeof *t->stack, (size_t)1 << 30);
    algsurf_memory_mark empty = algsurf_memory_here(&t->m);
    assert_true(algsurf_zpoly_multiplicities(&t->m, &p, s, &count));
    assert_int_equal(count, 512);
    for (int i = 0; i < count; i++) {
        exact_from_zpoly(t->s, s + i);
        exact_zpoly_primitive(t->s), exact_zpoly_primitive(t->f);
        assert_true(exact_zpoly_equal(t->s, t->f));
    }
    algsurf_memory_release(&t->m, empty);
    free(p.c);
    begin(t, 1);
    for (int i = 1; i <= 30; i++) {
        t->f->n = 1;
        mpz_set_si(t->f->c[0], -i), mpz_set_si(t->f->c[1], 1);
        join(t, i);
    }
    judge(t, 0);
}

TEST(test_constants) {
    bench *t = open_bench(SEED + 3);
    algsurf_zpoly s[2];
    int count;
    for (int i = -1; i < 2; i++) {
        exact_zpoly_constant(t->p, i);
        algsurf_zpoly p = exact_to_zpoly(t->p, 1, 1);
        algsurf_memory_begin(&t->m, t->stack, 4, 0);
        assert_true(algsurf_zpoly_multiplicities(&t->m, &p, s, &count));
        assert_int_equal(count, 0);
        free(p.c);
    }
}

/* With every limit of memory either the right answer or none, and nothing is left behind. */
TEST(test_out_of_memory) {
    bench *t = open_bench(SEED + 4);
    int failures = 0, successes = 0, count;
    algsurf_zpoly s[40];
    begin(t, -6);
    for (int k = 1; k < 4; k++) random_zpoly(&t->seed, t->f, 2, 90), join(t, k);
    algsurf_zpoly p = exact_to_zpoly(t->p, 0, 0);
    for (size_t size = 1; size < 2048; size += 11) {
        algsurf_memory_begin(&t->m, t->stack, size, 0);
        if (algsurf_zpoly_multiplicities(&t->m, &p, s, &count)) {
            assert_int_equal(count, t->count);
            exact_from_zpoly(t->s, s + count - 1);
            exact_zpoly_primitive(t->s), exact_zpoly_primitive(t->wanted[count - 1]);
            assert_true(exact_zpoly_equal(t->s, t->wanted[count - 1]));
            successes++;
        } else {
            assert_true(t->m.at == t->stack && !t->m.last);
            failures++;
        }
    }
    if (failures < 20 || successes < 20) fail_msg("%d failures, %d successes", failures, successes);
    free(p.c);
}
