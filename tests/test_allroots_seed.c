/* test_allroots_seed.c - approximation, interval iteration, and all roots by deflation, against exact roots.
 *
 * Breaks caught: a wrong sign in the elimination, a defect in plain double, a stopping test that z or q alone
 * meets, NaN from a vanishing derivative or an overflow, a scaling that changes results; radii forgotten,
 * also that of the leading coefficient; an inclusion accepted from outside, or of infinite boxes; a multiple
 * root called unique; a cold start that fails and is not reported.
 */
#include "seed_case.h"
#include "unit.h"

#define SEED 20240607u

static double distance(algsurf_complex a, algsurf_complex b) { return hypot(a.re - b.re, a.im - b.im); }

static int finite_all(const algsurf_complex *q, int n) {
    for (int i = 0; i < n; i++)
        if (!isfinite(q[i].re) || !isfinite(q[i].im)) return 0;
    return 1;
}

/* ---- approximation ---- */

/* Every root of random polynomials, from near by: to the last bits, and the quotient too. */
TEST(test_approximates) {
    uint64_t seed = SEED;
    for (int round = 0; round < 400; round++) {
        seed_case c = seed_random(&seed, 1 + random_int(&seed, SEED_DEGREE), 1);
        for (int i = 0; i < c.n; i++) {
            algsurf_complex z, q[SEED_DEGREE], exact[SEED_DEGREE + 1], start = c.root[i];
            start.re += 0.05 * random_unit(&seed), start.im += 0.05 * random_unit(&seed);
            int steps = 0;
            assert_ok(algsurf_paper_approximation(c.p, c.n, start, NULL, &z, q, &steps));
            assert_often(steps >= 1 && steps <= 12);
            (void)seed_product(c.root, c.n, i, 1, exact);
            double most = 1, off = 0;
            for (int k = 0; k < c.n; k++) {
                most = fmax(most, hypot(exact[k].re, exact[k].im));
                off = fmax(off, distance(q[k], exact[k]));
            }
            if (!(distance(z, c.root[i]) <= 1e-15 * fmax(1, hypot(z.re, z.im)) && off <= 1e-14 * most)) {
                seed_print("p", c.p, c.n + 1), seed_print("z", &z, 1), seed_print("q", q, c.n);
                fail_msg("seed %llu: %g, %g of %g", (unsigned long long)SEED, distance(z, c.root[i]), off,
                         most);
            }
            assert_true(q[c.n - 1].re == 1 && q[c.n - 1].im == 0);
        }
    }
}

/* The root 0, which only underflow reaches, leaves the other coefficients as they are. */
TEST(test_quotient_of_zero) {
    const algsurf_complex p[] = {{0, 0}, {316, 188}, {244, -128}, {13, -75}, {-4, 1}, {0, 4}, {1, 0}};
    algsurf_complex z, q[6];
    assert_ok(algsurf_paper_approximation(p, 6, (algsurf_complex){0.01, 0.02}, NULL, &z, q, NULL));
    assert_true(z.re == 0 && z.im == 0);
    assert_memory_equal(q, p + 1, sizeof q);
}

/* p(2^b X) 2^a has the roots 2^-b x: the same bits, the same steps.  (Not so for the root 0, which only
 * underflow reaches.) */
TEST(test_scaling_changes_nothing) {
    uint64_t seed = SEED;
    static const int shifts[][2] = {{0, 1}, {900, 0}, {-900, 0}, {0, 60}, {0, -60}, {500, -70}, {-400, 70}};
    for (int round = 0; round < 200; round++) {
        seed_case c = seed_random(&seed, 2 + random_int(&seed, SEED_DEGREE - 1), 1);
        if (c.p[0].re == 0 && c.p[0].im == 0) continue;
        algsurf_complex start = {random_unit(&seed), random_unit(&seed)}, z, q[SEED_DEGREE];
        int steps, a = shifts[round % 7][0], b = shifts[round % 7][1], again;
        algsurf_status status = algsurf_paper_approximation(c.p, c.n, start, NULL, &z, q, &steps);
        algsurf_complex p[SEED_DEGREE + 1], y, s[SEED_DEGREE];
        for (int k = 0; k <= c.n; k++)
            p[k] = (algsurf_complex){ldexp(c.p[k].re, a + k * b), ldexp(c.p[k].im, a + k * b)};
        start = (algsurf_complex){ldexp(start.re, -b), ldexp(start.im, -b)};
        assert_int_equal(algsurf_paper_approximation(p, c.n, start, NULL, &y, s, &again), status);
        assert_int_equal(again, steps);
        assert_true(ldexp(y.re, b) == z.re && ldexp(y.im, b) == z.im);
        for (int k = 0; k < c.n; k++)
            assert_true(s[k].re == ldexp(q[k].re, a + (k + 1) * b) &&
                        s[k].im == ldexp(q[k].im, a + (k + 1) * b));
    }
}

/* The first step is Newton's, -p/p'. */
TEST(test_first_step) {
    const algsurf_complex p[] = {{-2, 1}, {3, 0}, {0, -1}, {1, 0}}, start = {0.75, -0.5};
    const algsurf_paper_options one = {sizeof one, 0, 1, 0};
    algsurf_complex z, q[3], v = p[3], d = {0, 0};
    int steps;
    for (int k = 2; k >= 0; k--) {
        d = (algsurf_complex){d.re * start.re - d.im * start.im + v.re,
                              d.re * start.im + d.im * start.re + v.im};
        v = (algsurf_complex){v.re * start.re - v.im * start.im + p[k].re,
                              v.re * start.im + v.im * start.re + p[k].im};
    }
    double square = d.re * d.re + d.im * d.im;
    const algsurf_complex newton = {start.re - (v.re * d.re + v.im * d.im) / square,
                                    start.im - (v.im * d.re - v.re * d.im) / square};
    assert_int_equal(algsurf_paper_approximation(p, 3, start, &one, &z, q, &steps), ALGSURF_NOT_CONVERGED);
    assert_int_equal(steps, 1);
    assert_true(distance(z, newton) < 1e-15);
}

/* The even polynomial holds a start on the imaginary axis there; a vanishing derivative ends at once. */
TEST(test_symmetric_failures) {
    const algsurf_complex sphere[] = {{-0.25, 0}, {0, 0}, {1, 0}}, unit[] = {{1, 0}, {0, 0}, {1, 0}};
    algsurf_complex z, q[2];
    int steps = -1;
    assert_int_equal(algsurf_paper_approximation(sphere, 2, (algsurf_complex){0, 1}, NULL, &z, q, &steps),
                     ALGSURF_NOT_CONVERGED);
    assert_true(z.re == 0 && isfinite(z.im) && finite_all(q, 2) && steps == 50);
    assert_int_equal(algsurf_paper_approximation(unit, 2, (algsurf_complex){0, 0}, NULL, &z, q, &steps),
                     ALGSURF_NOT_CONVERGED);
    assert_true(z.re == 0 && z.im == 0 && finite_all(q, 2) && steps == 0);
    assert_int_equal(algsurf_paper_approximation(unit, 2, (algsurf_complex){3, 0}, NULL, &z, q, &steps),
                     ALGSURF_NOT_CONVERGED);
    assert_true(z.im == 0 && finite_all(q, 2)); /* a real start stays real */
    assert_ok(algsurf_paper_approximation(sphere, 2, (algsurf_complex){3, 0}, NULL, &z, q, NULL));
    assert_true(z.re == 0.5 && z.im == 0 && q[0].im == 0);
}

/* Degree 1: the quotient, from any start.  -1e600 is no double. */
TEST(test_linear) {
    const algsurf_complex p[] = {{3, -1}, {0.7, 0.1}}, huge[] = {{1e300, 0}, {1e-300, 0}};
    const algsurf_complex starts[] = {{0, 0}, {1e200, -1e-200}, {DBL_MAX, 0}, {-4, 2}};
    algsurf_complex z, q;
    algsurf_cinterval Z;
    int unique = 0;
    for (int i = 0; i < 4; i++) {
        int steps = 0;
        assert_ok(algsurf_paper_approximation(p, 1, starts[i], NULL, &z, &q, &steps));
        assert_true(steps <= 3);
        assert_true(distance(z, (algsurf_complex){-4, 2}) < 4e-15 && q.re == 0.7 && q.im == 0.1);
    }
    assert_int_equal(algsurf_paper_approximation(huge, 1, starts[0], NULL, &z, &q, NULL),
                     ALGSURF_NOT_CONVERGED);
    assert_true(finite_all(&z, 1));
    assert_ok(
        algsurf_paper_inclusion(p, NULL, 1, (algsurf_complex){-4, 2}, &q, NULL, &Z, NULL, &unique, NULL));
    assert_true(unique && Z.re.hi - Z.re.lo < 2e-15 && Z.im.hi - Z.im.lo < 2e-15);
}

/* A step so long that q overflows is not made. */
TEST(test_overflowing_step) {
    const algsurf_complex p[] = {{-1, -1}, {0x1p-1023, 0}, {1.9, -1.9}};
    algsurf_complex z, q[2];
    int steps;
    assert_int_equal(algsurf_paper_approximation(p, 2, (algsurf_complex){0, 0}, NULL, &z, q, &steps),
                     ALGSURF_NOT_CONVERGED);
    assert_true(steps == 0 && z.re == 0 && z.im == 0 && q[0].re == 0x1p-1023 && q[0].im == 0 &&
                q[1].re == 1.9);
}

/* 1 - 1.1 x + x^64, x = z 2^-20, from a start where the last coefficient is below the range of double. */
TEST(test_unit_follows) {
    algsurf_complex p[65] = {{0x1p640, 0}, {-1.1 * 0x1p620, 0}}, z, q[64];
    p[64].re = 0x1p-640;
    assert_ok(algsurf_paper_approximation(p, 64, (algsurf_complex){1, 0}, NULL, &z, q, NULL));
    double x = z.re * 0x1p-20;
    assert_true(x > 0.9 && x < 0.92 && fabs(1 - 1.1 * x + pow(x, 64)) < 1e-15);
}

/* Roots at the rims of the range; starts from which powers overflow. */
TEST(test_range) {
    const algsurf_complex big[] = {{1e300, 0}, {0, 0}, {1e-300, 0}},
                          small[] = {{1e-300, 0}, {0, 0}, {1e300, 0}};
    algsurf_complex z, q[64], p[65] = {{1, 0}};
    assert_ok(algsurf_paper_approximation(big, 2, (algsurf_complex){1e299, 9e299}, NULL, &z, q, NULL));
    assert_true(fabs(z.im / 1e300 - 1) < 1e-15);
    assert_ok(algsurf_paper_approximation(small, 2, (algsurf_complex){1e-301, 9e-301}, NULL, &z, q, NULL));
    assert_true(fabs(z.im / 1e-300 - 1) < 1e-15);
    p[64] = (algsurf_complex){1, 0};
    assert_int_equal(
        algsurf_paper_approximation(p, 64, (algsurf_complex){DBL_MAX, DBL_MAX}, NULL, &z, q, NULL),
        ALGSURF_NOT_CONVERGED);
    assert_true(finite_all(&z, 1) && finite_all(q, 64));
    p[64] = (algsurf_complex){DBL_MAX, DBL_MAX};
    (void)algsurf_paper_approximation(p, 64, (algsurf_complex){1e-320, 0}, NULL, &z, q, NULL);
    assert_true(finite_all(&z, 1) && finite_all(q, 64));
    /* A small root beside large ones: the stopping test looks at z too. */
    const algsurf_complex mixed[] = {{1e-9, 0}, {-1000, 0}, {1, 0}};
    assert_ok(algsurf_paper_approximation(mixed, 2, (algsurf_complex){1e-7, 1e-7}, NULL, &z, q, NULL));
    assert_true(fabs(z.re / 1.000000000001e-12 - 1) < 1e-12 && fabs(z.im) < 1e-26);
}

TEST(test_options) {
    const algsurf_complex p[] = {{-2, 0}, {1, 0}, {0, 0}, {1, 0}}, start = {3, 1};
    algsurf_complex z, q[3], y, s[3];
    int loose, usual, said;
    const algsurf_paper_options half = {sizeof half, 0.25, 0, 0}, spelt = {sizeof spelt, 1e-10, 50, 10};
    assert_ok(algsurf_paper_approximation(p, 3, start, &half, &z, q, &loose));
    algsurf_paper_options small = half;
    for (small.size = 0; small.size < sizeof small; small.size++) /* no release had a smaller one */
        assert_int_equal(algsurf_paper_approximation(p, 3, start, &small, &y, s, &said), ALGSURF_E_SIZE);
    assert_ok(algsurf_paper_approximation(p, 3, start, NULL, &z, q, &usual));
    assert_ok(algsurf_paper_approximation(p, 3, start, &spelt, &y, s, &said));
    assert_true(said == usual && loose < usual && y.re == z.re && y.im == z.im);
}

/* ---- interval iteration ---- */

static int verify(const seed_case *c, const double *r, algsurf_complex z, const algsurf_complex *q,
                  algsurf_cinterval *Z, algsurf_cinterval *Q, int *unique) {
    return algsurf_paper_inclusion(c->p, r, c->n, z, q, NULL, Z, Q, unique, NULL) == ALGSURF_OK;
}

/* Approximations of any quality, also of multiple roots: what is verified is true, and enough is (with a
 * schedule of inflations that does not grow, 3780).  `unique` without its test is not caught here nor
 * anywhere: in a million random cases, clusters and radii among them, no inclusion held that was not unique
 * too. */
TEST(test_inclusions_are_true) {
    uint64_t seed = SEED;
    int good = 0, verified = 0, tried = 0;
    for (int round = 0; round < 4000; round++) {
        seed_case c = seed_random(&seed, 1 + random_int(&seed, SEED_DEGREE), round % 4 != 0);
        int i = random_int(&seed, c.n), unique = 0, bits = 2 + random_int(&seed, 52);
        double noise = ldexp(1, -bits);
        algsurf_complex q[SEED_DEGREE + 1], z = c.root[i];
        algsurf_cinterval Z, Q[SEED_DEGREE];
        (void)seed_product(c.root, c.n, i, 1, q);
        z.re += noise * random_unit(&seed), z.im += noise * random_unit(&seed);
        for (int k = 0; k < c.n; k++) {
            q[k].re *= 1 + noise * random_unit(&seed);
            q[k].im *= 1 + noise * random_unit(&seed);
        }
        int done = verify(&c, NULL, z, q, &Z, Q, &unique), held = done ? seed_count(&c, Z) : 0;
        if (done && (held < 1 || (unique && held > 1))) {
            seed_print("p", c.p, c.n + 1), seed_print("z", &z, 1), seed_print("q", q, c.n);
            fail_msg("round %d, seed %llu: %d roots in the box", round, (unsigned long long)SEED, held);
        }
        for (int k = 0; done && unique && held == 1 && case_in(c.root[i], Z) && k < c.n; k++) {
            algsurf_complex exact[SEED_DEGREE + 1];
            (void)seed_product(c.root, c.n, i, 1, exact);
            assert_true(case_in(exact[k], Q[k]));
        }
        verified += done;
        if (round % 4 != 0 && bits >= 30) tried++, good += done && unique;
    }
    print_message("%d of %d near simple roots verified, %d of 4000 in all\n", good, tried, verified);
    assert_true(good == tried && tried > 1000 && verified < 4000);
    assert_often(verified > 3850);
}

/* Every coefficient is off by all of its radius, the leading one too; the old root is in the new box. */
TEST(test_radii) {
    uint64_t seed = SEED;
    int verified = 0;
    for (int round = 0; round < 1000; round++) {
        seed_case c = seed_random(&seed, 1 + random_int(&seed, SEED_DEGREE), 1);
        int i = random_int(&seed, c.n), only = random_int(&seed, c.n + 2);
        double r[SEED_DEGREE + 1], scale = ldexp(1, -24 - random_int(&seed, 16));
        for (int k = 0; k <= c.n; k++) { /* all of them, or only one */
            double size = only > c.n || only == k ? fmax(fabs(c.p[k].re), fabs(c.p[k].im)) : 0,
                   before = c.p[k].re;
            c.p[k].re += random_unit(&seed) < 0 ? -scale * size : scale * size;
            r[k] = fabs(c.p[k].re - before);
        }
        algsurf_complex z, q[SEED_DEGREE], exact[SEED_DEGREE + 1];
        algsurf_cinterval Z, Q[SEED_DEGREE];
        int unique = 0;
        assert_ok(algsurf_paper_approximation(c.p, c.n, c.root[i], NULL, &z, q, NULL));
        if (!verify(&c, r, z, q, &Z, Q, &unique)) continue;
        verified++;
        (void)seed_product(c.root, c.n, i, 1, exact);
        if (!case_in(c.root[i], Z)) {
            seed_print("p", c.p, c.n + 1), exact_print_doubles("r", r, c.n + 1);
            fail_msg("round %d, seed %llu: the root is lost", round, (unsigned long long)SEED);
        }
        for (int k = 0; unique && k < c.n; k++) assert_true(case_in(exact[k], Q[k]));
    }
    assert_often(verified > 900);
}

TEST(test_boxes_are_tight) {
    uint64_t seed = SEED;
    for (int round = 0; round < 300; round++) { /* roots that are no doubles */
        seed_case c = seed_random(&seed, 2 + random_int(&seed, 5), 1);
        for (int k = 0; k < c.n; k++) c.p[k].re += 0.3 * random_unit(&seed);
        algsurf_complex z, q[SEED_DEGREE];
        algsurf_cinterval Z;
        if (algsurf_paper_approximation(c.p, c.n, c.root[0], NULL, &z, q, NULL) != ALGSURF_OK) continue;
        assert_true(verify(&c, NULL, z, q, &Z, NULL, NULL));
        assert_true(fmax(Z.re.hi - Z.re.lo, Z.im.hi - Z.im.lo) <= 0x1p-51 * hypot(z.re, z.im));
    }
}

/* 2^10 X + 2^-1074 seen from 1: the constant term is lost in that unit, but not forgotten. */
TEST(test_underflow_is_enclosed) {
    const algsurf_complex p[] = {{0x1p-1074, 0}, {0x1p10, 0}};
    algsurf_cinterval Z;
    assert_ok(
        algsurf_paper_inclusion(p, NULL, 1, (algsurf_complex){1, 0}, p + 1, NULL, &Z, NULL, NULL, NULL));
    assert_true(Z.re.lo < 0 && Z.re.hi >= 0);
}

/* Nothing is written but the count, when there is no proof. */
TEST(test_no_proof) {
    const algsurf_complex square[] = {{0, 0}, {0, 0}, {1, 0}}, apart[] = {{-1, 0}, {0, 0}, {1, 0}};
    const algsurf_complex q[] = {{0, 0}, {1, 0}}, far[] = {{0.5, 0}, {1, 0}},
                          wild[] = {{1e308, -1e308}, {1, 0}};
    const algsurf_paper_options three = {sizeof three, 0, 0, 3};
    const algsurf_cinterval mark = {{7, 8}, {9, 10}};
    algsurf_cinterval Z = mark, Q[2] = {mark, mark};
    int unique = 5, inflations = -1;
    assert_int_equal(algsurf_paper_inclusion(square, NULL, 2, (algsurf_complex){0, 0}, q, NULL, &Z, Q,
                                             &unique, &inflations),
                     ALGSURF_NOT_VERIFIED);
    assert_int_equal(inflations, 0);
    assert_int_equal(algsurf_paper_inclusion(apart, NULL, 2, (algsurf_complex){0.5, 0}, far, NULL, &Z, Q,
                                             &unique, &inflations),
                     ALGSURF_NOT_VERIFIED);
    assert_int_equal(inflations, 10);
    assert_int_equal(algsurf_paper_inclusion(apart, NULL, 2, (algsurf_complex){0.5, 0}, far, &three, &Z, Q,
                                             &unique, &inflations),
                     ALGSURF_NOT_VERIFIED);
    assert_int_equal(inflations, 3);
    assert_int_equal(algsurf_paper_inclusion(apart, NULL, 2, (algsurf_complex){1, 0}, wild, NULL, &Z, Q,
                                             &unique, &inflations),
                     ALGSURF_NOT_VERIFIED);
    const double all[] = {1e308, 1e308, 1e308};
    assert_int_equal(
        algsurf_paper_inclusion(apart, all, 2, (algsurf_complex){1, 0}, q, NULL, &Z, Q, &unique, &inflations),
        ALGSURF_NOT_VERIFIED);
    assert_true(unique == 5 && !memcmp(&Z, &mark, sizeof mark) && !memcmp(Q + 1, &mark, sizeof mark));
}
