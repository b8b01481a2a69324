/* test_allroots_deflate.c - all roots by deflation; the three calls of the seed with bad input, in any
 * floating-point environment, at the highest degree; deflated coefficients multiplied out exactly.
 *
 * Breaks caught: a root short (the linear factor), polishing on the deflated polynomial, radii not handed on,
 * two boxes on one root called complete, a failing start hidden; an end rounded inward; an environment that
 * shows in results; an argument that is not checked, an output written before the check.
 */
#include "environments.h"
#include "seed_case.h"
#include "unit.h"

#define SEED 20240608u

/* Each root in one box of its own. */
static int each_once(const seed_case *c, const algsurf_paper_zero *zeros) {
    for (int k = 0; k < c->n; k++) {
        int boxes = 0;
        for (int i = 0; i < c->n; i++) boxes += case_in(c->root[k], zeros[i].box);
        if (boxes != 1) return 0;
    }
    return 1;
}

TEST(test_finds_all) {
    uint64_t seed = SEED;
    int complete_ones = 0;
    for (int round = 0; round < 500; round++) {
        seed_case c = seed_random(&seed, 1 + random_int(&seed, SEED_DEGREE), 1);
        algsurf_paper_zero zeros[SEED_DEGREE];
        algsurf_complex start[SEED_DEGREE];
        int complete = -1;
        for (int i = 0; i < c.n; i++) start[i] = (algsurf_complex){0.3 + 0.01 * i, 0.2 - 0.02 * i};
        assert_ok(algsurf_paper_zeros(c.p, NULL, c.n, start, NULL, zeros, &complete));
        for (int i = 0; i < c.n; i++) {
            assert_true(!zeros[i].verified || seed_count(&c, zeros[i].box) == 1);
            assert_true(!zeros[i].verified || (zeros[i].unique && zeros[i].inflations >= 1));
            assert_true(zeros[i].steps >= 2 && case_in(zeros[i].root, zeros[i].box));
        }
        complete_ones += complete;
        if (complete && !each_once(&c, zeros)) {
            seed_print("p", c.p, c.n + 1);
            fail_msg("round %d, seed %llu: complete, but not", round, (unsigned long long)SEED);
        }
    }
    assert_true(complete_ones >= 490);
}

/* Moved coefficients with radii: the boxes hold the old roots.  Without radii they are too small for that. */
TEST(test_radii_are_handed_on) {
    uint64_t seed = SEED;
    int complete_ones = 0;
    for (int round = 0; round < 200; round++) {
        seed_case c = seed_random(&seed, 2 + random_int(&seed, 5), 1);
        algsurf_paper_zero zeros[SEED_DEGREE];
        double r[SEED_DEGREE + 1];
        int complete;
        for (int k = 0; k <= c.n; k++) {
            double before = c.p[k].im;
            c.p[k].im += 0x1p-36 * fabs(c.p[k].re);
            r[k] = fabs(c.p[k].im - before);
        }
        const algsurf_complex start[SEED_DEGREE] = {{0.3, 0.2}, {-0.1, 0.5}, {0.2, -0.3},
                                                    {0.4, 0.4}, {1, 2},      {2, -1}};
        assert_ok(algsurf_paper_zeros(c.p, r, c.n, start, NULL, zeros, &complete));
        complete_ones += complete;
        assert_true(!complete || each_once(&c, zeros));
    }
    assert_true(complete_ones >= 190);
}

/* t^2 - 1/4, a sphere seen along a re-centred ray: the cold start stays on the imaginary axis. */
TEST(test_cold_start_fails_on_even) {
    const algsurf_complex p[] = {{-0.25, 0}, {0, 0}, {1, 0}}, off[] = {{0.1, 1}, {0.1, 1}};
    algsurf_paper_zero zeros[2];
    int complete = 1;
    assert_ok(algsurf_paper_zeros(p, NULL, 2, NULL, NULL, zeros, &complete));
    assert_int_equal(complete, 0);
    for (int i = 0; i < 2; i++) assert_true(!zeros[i].converged && !zeros[i].verified && !zeros[i].unique);
    assert_ok(algsurf_paper_zeros(p, NULL, 2, off, NULL, zeros, &complete));
    assert_int_equal(complete, 1);
    for (int i = 0; i < 2; i++) assert_true(zeros[i].converged && zeros[i].verified && zeros[i].unique);
}

/* With few steps the approximations are poor, the quotients worse, and polishing ends on some roots twice. */
TEST(test_slides_are_noticed) {
    const algsurf_paper_options few = {sizeof few, 0, 7, 0};
    uint64_t seed = SEED;
    int slid = 0, saved = 0;
    for (int round = 0; round < 300; round++) {
        seed_case c = seed_random(&seed, 3, 1);
        algsurf_paper_zero z[3];
        int complete, verified = 0;
        assert_ok(algsurf_paper_zeros(c.p, NULL, 3, NULL, &few, z, &complete));
        for (int i = 0; i < 3; i++) verified += z[i].verified;
        assert_int_equal(complete, verified == 3 && each_once(&c, z));
        slid += verified == 3 && !complete;
        algsurf_complex first, q[3]; /* what did not converge is not said to have, wherever polishing led */
        if (algsurf_paper_approximation(c.p, 3, (algsurf_complex){0, 1}, &few, &first, q, NULL) == ALGSURF_OK)
            continue;
        assert_true(!z[0].converged);
        saved += z[0].verified;
    }
    print_message("all verified, but two on one root: %d of 300\n", slid);
    assert_true(slid > 0 && saved > 0);
}

/* ---- (X - Z) Q has the coefficients of p in it, in exact arithmetic ---- */

typedef struct range {
    mpq_t lo, hi;
} range;

static void range_of(range *r, algsurf_interval a, int clear) {
    if (clear) {
        mpq_clears(r->lo, r->hi, NULL);
        return;
    }
    mpq_inits(r->lo, r->hi, NULL);
    exact_set(r->lo, a.lo), exact_set(r->hi, a.hi);
}

/* sum += sign a b */
static void range_product(range *sum, int sign, algsurf_interval a, algsurf_interval b) {
    mpq_t ends[4], x, y;
    mpq_inits(ends[0], ends[1], ends[2], ends[3], x, y, NULL);
    int least = 0, most = 0;
    for (int i = 0; i < 4; i++) {
        exact_set(x, i & 1 ? a.hi : a.lo), exact_set(y, i & 2 ? b.hi : b.lo);
        mpq_mul(ends[i], x, y);
        if (sign < 0) mpq_neg(ends[i], ends[i]);
        if (mpq_cmp(ends[i], ends[least]) < 0) least = i;
        if (mpq_cmp(ends[i], ends[most]) > 0) most = i;
    }
    mpq_add(sum->lo, sum->lo, ends[least]);
    mpq_add(sum->hi, sum->hi, ends[most]);
    mpq_clears(ends[0], ends[1], ends[2], ends[3], x, y, NULL);
}

static int range_has(const range *r, double x) {
    mpq_t q;
    mpq_init(q);
    exact_set(q, x);
    int has = mpq_cmp(r->lo, q) <= 0 && mpq_cmp(q, r->hi) <= 0;
    mpq_clear(q);
    return has;
}

/* p_k in Q_{k-1} - Z Q_k, both parts. */
static int multiplies_out(algsurf_complex p, const algsurf_cinterval *below, algsurf_cinterval Z,
                          const algsurf_cinterval *Q) {
    const algsurf_interval zero = {0, 0};
    range re, im;
    range_of(&re, below ? below->re : zero, 0), range_of(&im, below ? below->im : zero, 0);
    range_product(&re, -1, Z.re, Q->re), range_product(&re, 1, Z.im, Q->im);
    range_product(&im, -1, Z.re, Q->im), range_product(&im, -1, Z.im, Q->re);
    int has = range_has(&re, p.re) && range_has(&im, p.im);
    range_of(&re, zero, 1), range_of(&im, zero, 1);
    return has;
}

TEST(test_quotient_multiplies_out) {
    uint64_t seed = SEED;
    int verified = 0;
    for (int round = 0; round < 300; round++) {
        int n = 2 + random_int(&seed, 6), wide = round % 3 == 0 ? 40 : 2;
        algsurf_complex p[9], q[8], z, start = {random_unit(&seed), random_unit(&seed)};
        algsurf_cinterval Z, Q[8];
        for (int k = 0; k <= n; k++)
            p[k] = (algsurf_complex){random_wide(&seed, -wide, wide), random_wide(&seed, -wide, wide)};
        (void)algsurf_paper_approximation(p, n, start, NULL, &z, q, NULL);
        if (algsurf_paper_inclusion(p, NULL, n, z, q, NULL, &Z, Q, NULL, NULL) != ALGSURF_OK) continue;
        verified++;
        for (int k = 0; k < n; k++)
            if (!multiplies_out(p[k], k > 0 ? Q + k - 1 : NULL, Z, Q + k)) {
                seed_print("p", p, n + 1);
                fail_msg("round %d, seed %llu: coefficient %d is not in the product", round,
                         (unsigned long long)SEED, k);
            }
        assert_true(Q[n - 1].re.lo == p[n].re && Q[n - 1].re.hi == p[n].re && Q[n - 1].im.lo == p[n].im);
    }
    assert_true(verified > 200);
}

/* ---- the calls ---- */

/* X^512 - 1 at 1. */
TEST(test_highest_degree) {
    static algsurf_complex p[ALGSURF_MAX_POLY_DEGREE + 1], q[ALGSURF_MAX_POLY_DEGREE], z;
    static algsurf_cinterval Z, Q[ALGSURF_MAX_POLY_DEGREE];
    int n = ALGSURF_MAX_POLY_DEGREE, unique = 0;
    p[0].re = -1, p[n].re = 1;
    assert_ok(algsurf_paper_approximation(p, n, (algsurf_complex){1.0005, 0.0005}, NULL, &z, q, NULL));
    assert_ok(algsurf_paper_inclusion(p, NULL, n, z, q, NULL, &Z, Q, &unique, NULL));
    assert_true(unique && case_in((algsurf_complex){1, 0}, Z) && Z.re.hi - Z.re.lo < 1e-15);
    for (int k = 0; k < n; k++) assert_true(case_in((algsurf_complex){1, 0}, Q[k]));
}

typedef struct answers {
    algsurf_complex z, q[8];
    algsurf_cinterval Z, Q[8];
    algsurf_paper_zero zeros[8];
    int steps, unique, inflations, complete, status[3];
} answers;

static answers ask(const algsurf_complex *p, const double *r, int n, const algsurf_complex *start) {
    answers a;
    memset(&a, 0, sizeof a);
    a.status[0] = algsurf_paper_approximation(p, n, start[0], NULL, &a.z, a.q, &a.steps);
    a.status[1] = algsurf_paper_inclusion(p, r, n, a.z, a.q, NULL, &a.Z, a.Q, &a.unique, &a.inflations);
    a.status[2] = algsurf_paper_zeros(p, r, n, start, NULL, a.zeros, &a.complete);
    return a;
}

/* All fields, but no padding. */
static int same(const answers *a, const answers *b) {
    int equal = !memcmp(&a->z, &b->z, sizeof a->z) && !memcmp(a->q, b->q, sizeof a->q) &&
                !memcmp(&a->Z, &b->Z, sizeof a->Z) && !memcmp(a->Q, b->Q, sizeof a->Q) &&
                !memcmp(a->status, b->status, sizeof a->status) && a->steps == b->steps &&
                a->unique == b->unique && a->inflations == b->inflations && a->complete == b->complete;
    for (int i = 0; i < 8; i++) {
        const algsurf_paper_zero *x = a->zeros + i, *y = b->zeros + i;
        equal = equal && !memcmp(&x->box, &y->box, sizeof x->box) &&
                !memcmp(&x->root, &y->root, sizeof x->root) && x->verified == y->verified &&
                x->unique == y->unique && x->converged == y->converged && x->steps == y->steps &&
                x->inflations == y->inflations;
    }
    return equal;
}

/* The same bits in every environment, which comes back as it was; subnormal coefficients included. */
TEST(test_environments) {
    uint64_t seed = SEED;
    int verified = 0;
    for (int round = 0; round < 60; round++) {
        int n = 1 + random_int(&seed, 8), tiny = round % 2 ? -1040 : 0;
        algsurf_complex p[9], start[8];
        double r[9];
        for (int k = 0; k <= n; k++) {
            p[k] = (algsurf_complex){ldexp(random_unit(&seed), tiny), ldexp(random_unit(&seed), tiny)};
            r[k] = ldexp(fabs(random_unit(&seed)), tiny - 40);
        }
        for (int i = 0; i < n; i++) start[i] = (algsurf_complex){random_unit(&seed), random_unit(&seed)};
        answers usual = ask(p, r, n, start);
        verified += usual.status[1] == ALGSURF_OK;
        for (int e = 1; e < ENVIRONMENTS; e++) {
            environment_set(e);
            answers other = ask(p, r, n, start);
            assert_true(environment_unset(e));
            assert_true(same(&usual, &other));
        }
    }
    assert_true(verified > 40);
}

/* What is wrong with a call; the usual ones below are called with one thing wrong at a time. */
typedef struct call {
    algsurf_complex p[3], q[2], start[2];
    double r[3];
    int degree;
    algsurf_paper_options options;
} call;

static const call good = {{{-2, 0}, {0, 0}, {1, 0}},
                          {{1.4, 0}, {1, 0}},
                          {{1, 1}, {1, 1}},
                          {0, 0, 0},
                          2,
                          {sizeof(algsurf_paper_options), 0, 0, 0}};

/* Expected: the status of the approximation, of the iteration, of all zeros (1: not asked). */
static void refused(const call *c, int approximation, int iteration, int zeros) {
    unsigned char mark[4096], before[sizeof mark];
    memset(mark, 0x5a, sizeof mark);
    memcpy(before, mark, sizeof mark);
    void *out = mark;
    algsurf_complex *z = out;
    algsurf_cinterval *Z = out;
    algsurf_paper_zero *list = out;
    int *count = (int *)out + 900, *other = count + 1;
    if (approximation <= 0)
        assert_int_equal(
            algsurf_paper_approximation(c->p, c->degree, c->start[0], &c->options, z, z + 1, count),
            approximation);
    if (iteration <= 0)
        assert_int_equal(algsurf_paper_inclusion(c->p, c->r, c->degree, c->start[0], c->q, &c->options, Z,
                                                 Z + 1, count, other),
                         iteration);
    if (zeros <= 0)
        assert_int_equal(algsurf_paper_zeros(c->p, c->r, c->degree, c->start, &c->options, list, count),
                         zeros);
    assert_memory_equal(mark, before, sizeof mark);
}

TEST(test_bad_numbers) {
    const int argument = ALGSURF_E_ARGUMENT, finite = ALGSURF_E_NOT_FINITE;
    static const int degrees[] = {0, -1, ALGSURF_MAX_POLY_DEGREE + 1, 0x7fffffff};
    for (int i = 0; i < 4; i++) {
        call c = good;
        const int why = degrees[i] > 0 ? ALGSURF_E_DEGREE : argument;
        c.degree = degrees[i];
        refused(&c, why, why, why);
    }
    for (int i = 0; i < 2; i++) {
        double bad = i ? NAN : -INFINITY;
        call c = good;
        c.p[1].im = bad, refused(&c, finite, finite, finite);
        c = good, c.start[0].re = bad, refused(&c, finite, finite, finite);
        c = good, c.start[1].im = bad, refused(&c, 1, 1, finite);
        c = good, c.q[0].im = bad, refused(&c, 1, finite, 1);
        c = good, c.r[2] = bad, refused(&c, 1, finite, finite);
        c = good, c.options.relative_step = bad, refused(&c, finite, finite, finite);
    }
    call c = good;
    c.r[0] = -0x1p-1074, refused(&c, 1, argument, argument);
    c = good, c.p[2].re = 0, refused(&c, argument, argument, argument);
    c = good, c.options.relative_step = -1, refused(&c, argument, argument, argument);
    c = good, c.options.max_steps = -1, refused(&c, argument, argument, argument);
    c = good, c.options.max_inflations = -1, refused(&c, argument, argument, argument);
    c = good, c.options.size = 2, refused(&c, ALGSURF_E_SIZE, ALGSURF_E_SIZE, ALGSURF_E_SIZE);
}

/* A step towards a double root halves what is left; where that is 0 as a double, it is 0, and this ends. */
TEST(test_double_root_at_zero) {
    const algsurf_complex p[3] = {{0, 0}, {0, 0}, {1, 0}};
    const algsurf_paper_options options = {.size = sizeof options, .max_steps = 5000};
    algsurf_complex z, q[2];
    int steps;
    assert_int_equal(algsurf_paper_approximation(p, 2, (algsurf_complex){1, 0}, &options, &z, q, &steps),
                     ALGSURF_NOT_CONVERGED);
    assert_true(z.re == 0 && z.im == 0 && steps > 1000 && steps < 1200);
}

TEST(test_null) {
    const call c = good;
    algsurf_complex z = {5, 5}, q[2] = {{5, 5}, {5, 5}};
    algsurf_cinterval Z = {{5, 5}, {5, 5}};
    algsurf_paper_zero zeros[2];
    int complete = 5;
    memset(zeros, 5, sizeof zeros);
    assert_int_equal(algsurf_paper_approximation(NULL, 2, c.start[0], NULL, &z, q, NULL), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_paper_approximation(c.p, 2, c.start[0], NULL, NULL, q, NULL),
                     ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_paper_approximation(c.p, 2, c.start[0], NULL, &z, NULL, NULL),
                     ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_paper_inclusion(NULL, NULL, 2, z, q, NULL, &Z, NULL, NULL, NULL),
                     ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_paper_inclusion(c.p, NULL, 2, z, NULL, NULL, &Z, NULL, NULL, NULL),
                     ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_paper_inclusion(c.p, NULL, 2, z, q, NULL, NULL, NULL, NULL, NULL),
                     ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_paper_zeros(NULL, NULL, 2, NULL, NULL, zeros, &complete), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_paper_zeros(c.p, NULL, 2, NULL, NULL, NULL, &complete), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_paper_zeros(c.p, NULL, 2, NULL, NULL, zeros, NULL), ALGSURF_E_ARGUMENT);
    assert_true(z.re == 5 && q[1].im == 5 && Z.re.lo == 5 && complete == 5 && zeros[1].steps == 0x05050505);
    assert_int_equal(algsurf_paper_inclusion(c.p, NULL, 2, z, q, NULL, &Z, NULL, NULL, NULL),
                     ALGSURF_NOT_VERIFIED);
}
