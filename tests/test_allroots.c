/* test_allroots.c - the robust solver: its contract, its limits, and the places where solvers break.
 *
 * Catches: an output written before a refusal, an exact zero taken for a root at infinity or left in a
 * cluster, real roots claimed for radii that allow complex ones, a leading coefficient that may be 0, boxes
 * that meet where roots leave the range of double, overflow in evaluation far out that ends the iteration,
 * start values that decide the answer, the caller's rounding mode in the result, memory of the last call.
 * (Seen to fail with the check of the leading coefficient, the joining of boxes after unscaling, the recall
 * of points from far out, the outward rounding of unscaling, or the switch of the environment removed.)
 */
#include "algsurf/algsurf.h"
#include "allroots_case.h"
#include "environments.h"
#include "unit.h"

enum { LARGE = ALGSURF_MAX_POLY_DEGREE };
#define BIG DBL_MAX
#define TINY DBL_TRUE_MIN

static algsurf_complex_solver *solver;
static algsurf_complex_root boxes[LARGE];
static algsurf_complex large[LARGE + 1];

static int solve(const double *c, const double *r, int degree) {
    int count = -1;
    assert_ok(algsurf_complex_roots_of_real(c, r, degree, boxes, &count));
    return count;
}

/* ---- refusals ---- */

static void refused(algsurf_status expected, const algsurf_complex *c, const double *r, int degree) {
    algsurf_complex_root e[3], before[3];
    algsurf_complex_solver_stats stats = {sizeof stats, 77, 77};
    int count = 77;
    memset(e, 0x5a, sizeof e), memset(before, 0x5a, sizeof before);
    assert_int_equal(algsurf_complex_roots(c, r, degree, e, &count), expected);
    assert_int_equal(algsurf_complex_solver_run(solver, c, r, degree, NULL, e, &count, &stats), expected);
    if (c && degree >= 0 && degree <= 2) {
        double real[3];
        int all_real = 1;
        for (int k = 0; k <= degree; k++) real[k] = c[k].re, all_real = all_real && c[k].im == 0;
        if (all_real) assert_int_equal(algsurf_complex_roots_of_real(real, r, degree, e, &count), expected);
    }
    assert_memory_equal(e, before, sizeof e);
    assert_int_equal(count, 77);
    assert_int_equal(stats.iterations, 77);
}

TEST(test_refusals) {
    const algsurf_complex good[3] = {{1, 0}, {3, 0}, {1, 0}}, zero[3] = {{0, 0}, {-0.0, 0}, {0, -0.0}};
    const double radii[3] = {0, 0, 0}, negative[3] = {0, -1e-300, 0};
    const double bad[] = {NAN, HUGE_VAL, -HUGE_VAL};
    refused(ALGSURF_E_ARGUMENT, NULL, NULL, 2);
    refused(ALGSURF_E_ARGUMENT, good, NULL, -1);
    refused(ALGSURF_E_ARGUMENT, good, negative, 2);
    refused(ALGSURF_E_ZERO, zero, NULL, 2);
    refused(ALGSURF_E_ZERO, zero, radii, 2);
    refused(ALGSURF_E_ZERO, zero, NULL, 0);
    for (int k = 0; k < 9; k++) {
        algsurf_complex re[3], im[3];
        double r[3] = {0, 0, 0};
        memcpy(re, good, sizeof re), memcpy(im, good, sizeof im);
        re[k % 3].re = im[k % 3].im = r[k % 3] = bad[k / 3];
        refused(ALGSURF_E_NOT_FINITE, re, NULL, 2);
        refused(ALGSURF_E_NOT_FINITE, im, NULL, 2);
        refused(ALGSURF_E_NOT_FINITE, good, r, 2);
    }
    const double real[3] = {1, 3, 1};
    int count = 77;
    assert_int_equal(algsurf_complex_roots(good, NULL, 2, NULL, &count), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_complex_roots(good, NULL, 2, boxes, NULL), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_complex_roots(large, NULL, ALGSURF_MAX_POLY_DEGREE + 1, boxes, &count),
                     ALGSURF_E_DEGREE);
    assert_int_equal(algsurf_complex_roots_of_real(NULL, NULL, 2, boxes, &count), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_complex_roots_of_real(real, NULL, 2, NULL, &count), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_complex_roots_of_real(real, NULL, 2, boxes, NULL), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_complex_roots_of_real(real, NULL, ALGSURF_MAX_POLY_DEGREE + 1, boxes, &count),
                     ALGSURF_E_DEGREE);
    assert_int_equal(algsurf_complex_solver_run(NULL, good, NULL, 2, NULL, boxes, &count, NULL),
                     ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_complex_solver_run(solver, good, NULL, 2, NULL, NULL, &count, NULL),
                     ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_complex_solver_run(solver, good, NULL, 2, NULL, boxes, NULL, NULL),
                     ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_complex_solver_run(solver, large, NULL, LARGE + 1, NULL, boxes, &count, NULL),
                     ALGSURF_E_DEGREE);
    assert_int_equal(count, 77);
}

TEST(test_solver_refusals) {
    algsurf_complex_solver *untouched = (algsurf_complex_solver *)(void *)&solver, *s = untouched;
    const algsurf_complex cubic[4] = {{1, 0}, {0, 0}, {0, 0}, {1, 0}};
    int count = 77;
    assert_int_equal(algsurf_complex_solver_create(3, NULL), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_complex_solver_create(0, &s), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_complex_solver_create(-1, &s), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_complex_solver_create(LARGE + 1, &s), ALGSURF_E_DEGREE);
    assert_ptr_equal(s, untouched);
    assert_ok(algsurf_complex_solver_create(2, &s));
    assert_int_equal(algsurf_complex_solver_run(s, cubic, NULL, 3, NULL, boxes, &count, NULL),
                     ALGSURF_E_DEGREE);
    assert_int_equal(count, 77);
    algsurf_complex_solver_free(s);
}

/* ---- small polynomials ---- */

TEST(test_low_degrees) {
    assert_int_equal(solve((double[]){3}, NULL, 0), 0);
    assert_int_equal(solve((double[]){5, 0, -0.0, 0}, NULL, 3), 0);
    assert_int_equal(solve((double[]){1, 1, -0.0}, NULL, 2), 1);
    assert_true(boxes[0].real && case_in((algsurf_complex){-1, 0}, boxes[0].box));
    assert_int_equal(solve((double[]){0, 0, 1, 1, 0, 0}, NULL, 5), 2);
    assert_int_equal(boxes[1].multiplicity, 2);
    assert_int_equal(boxes[1].real, 1);
    const algsurf_cinterval zero = {{0, 0}, {0, 0}};
    assert_memory_equal(&boxes[1].box, &zero, sizeof zero);
    assert_int_equal(solve((double[]){0, 0, 0, 2}, NULL, 3), 1);
    assert_int_equal(boxes[0].multiplicity, 3);
    assert_int_equal(solve((double[]){TINY, -TINY}, NULL, 1), 1);
    assert_true(case_in((algsurf_complex){1, 0}, boxes[0].box));
    assert_true(boxes[0].box.re.hi - boxes[0].box.re.lo <= 2 * DBL_EPSILON);
    assert_int_equal(solve((double[]){-2 * TINY, TINY, TINY}, NULL, 2), 2); /* (x + 2)(x - 1) */
    assert_true(case_in((algsurf_complex){-2, 0}, boxes[0].box) &&
                case_in((algsurf_complex){1, 0}, boxes[1].box));
    assert_int_equal(solve((double[]){BIG, BIG, BIG, BIG, BIG}, NULL, 4), 4); /* fifth roots of unity */
    for (int i = 0; i < 4; i++) assert_true(fabs(hypot(boxes[i].root.re, boxes[i].root.im) - 1) < 1e-15);
}

/* Roots that leave the range of double are in boxes that say so, and still do not meet. */
TEST(test_range) {
    static const struct {
        double c[5];
        int degree;
    } cases[] = {{{1e300, 1e-300}, 1},
                 {{1e-300, 1e300}, 1},
                 {{TINY, 0x1p1023, TINY}, 2},
                 {{1e300, -1.1e-9, 1e-319}, 2},      /* 1e309, 1e310 */
                 {{1e300, 0, 1e-319}, 2},            /* +-3e309 i */
                 {{0, TINY, -0x1p600, 0x1p1000}, 3}, /* 0, 2^-1674, 2^-400 */
                 {{0, 1e-320, -1.1e-9, 1e303}, 3},   /* 0 and two subnormal numbers */
                 {{TINY, -0x1.8p-1000, 0x1p-900, 1}, 3},
                 {{BIG, TINY, BIG, TINY, BIG}, 4},
                 {{TINY, BIG, TINY, BIG, TINY}, 4},
                 {{1e-300, 1, 1e300, 1, 1e-300}, 4}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        int count = solve(cases[i].c, NULL, cases[i].degree);
        const char *what = case_boxes_wrong(cases[i].degree, boxes, count);
        if (what) fail_msg("case %zu: %s", i, what);
    }
    assert_int_equal(solve((double[]){1e300, 1e-300}, NULL, 1), 1);
    assert_true(boxes[0].box.re.lo == -HUGE_VAL && boxes[0].box.re.hi <= -BIG && boxes[0].real);
    assert_int_equal(solve((double[]){-1e-300, 1e300}, NULL, 1), 1);
    assert_true(boxes[0].box.re.lo >= -TINY && boxes[0].box.re.hi > 0 && boxes[0].box.re.hi <= 2 * TINY);
    assert_int_equal(solve((double[]){-0x1p-60, 0x1.8p1000}, NULL, 1), 1); /* 2^-1060 / 1.5, subnormal */
    assert_true(boxes[0].box.re.lo * 0x1.8p1000 < 0x1p-60 && boxes[0].box.re.hi * 0x1.8p1000 > 0x1p-60);
    assert_true(boxes[0].box.re.hi - boxes[0].box.re.lo <= 2 * TINY);
    /* z (z - 1e-200) (z - 1e200): the exact zero does not swallow a root, nor the other way round */
    assert_int_equal(solve((double[]){0, 1, -1e200, 1}, NULL, 3), 3);
}

/* ---- radii ---- */

TEST(test_radii) {
    const algsurf_complex two[3] = {{-1, 0}, {0, 0}, {1, 0}}, through[3] = {{0, 0}, {1, 0}, {1, 0}};
    int count = -1;
    /* -1 + 1e-3 i is one of the constants meant: its roots are not real */
    assert_ok(algsurf_complex_roots(two, (double[]){1e-3, 0, 0}, 2, boxes, &count));
    assert_int_equal(count, 2);
    for (int i = 0; i < 2; i++) {
        assert_int_equal(boxes[i].real, 0);
        assert_true(boxes[i].box.im.lo <= -5e-4 && boxes[i].box.im.hi >= 5e-4);
    }
    for (int again = 0; again < 3; again++) { /* a constant of 0 that need not be: the same each time */
        memset(boxes, again ? 0x7f : 0, sizeof boxes);
        assert_ok(algsurf_complex_roots(through, (double[]){1e-10, 0, 0}, 2, boxes, &count));
        assert_int_equal(count, 2);
        assert_true(fabs(boxes[1].root.re) < 1e-9 && boxes[1].box.re.hi >= 1e-10);
        assert_true(boxes[1].box.re.hi < 1e-9 && boxes[1].box.re.lo <= -1e-10);
    }
    /* z^3 - z with an undecided middle: the exact zero and the others stay apart, or are one box */
    assert_ok(algsurf_complex_roots((algsurf_complex[]){{0, 0}, {-1, 0}, {0, 0}, {1, 0}},
                                    (double[]){0, 3, 0, 0}, 3, boxes, &count));
    assert_null(case_boxes_wrong(3, boxes, count));
    refused(ALGSURF_E_RANGE, two, (double[]){0, 0, 1}, 2);
    refused(ALGSURF_E_RANGE, (algsurf_complex[]){{1, 0}, {1, 0}, {0, 0}}, (double[]){0, 0, 1e-9}, 2);
    refused(ALGSURF_E_RANGE, (algsurf_complex[]){{0, 0}, {0, 0}, {0, 0}}, (double[]){1, 0, 1e-9}, 2);
    for (int k = 31; k < 54; k++) /* below a power of two, which is below it by more than its size shows */
        refused(ALGSURF_E_RANGE, (algsurf_complex[]){{1, 0}, {1, 0}}, (double[]){0, 1 - ldexp(1, -k)}, 1);
}

/* ---- high degrees, start values, reuse ---- */

static int run(int degree, const algsurf_complex *start, algsurf_complex_solver_stats *stats) {
    int count = -1;
    assert_ok(algsurf_complex_solver_run(solver, large, NULL, degree, start, boxes, &count, stats));
    const char *what = case_boxes_wrong(degree, boxes, count);
    if (what) fail_msg("degree %d: %s", degree, what);
    return count;
}

TEST(test_unity) {
    for (int degree = 64; degree <= LARGE; degree *= 2) {
        memset(large, 0, sizeof large);
        large[0].re = -1, large[degree].re = 1;
        assert_int_equal(run(degree, NULL, NULL), degree);
        int exact = 0;
        for (int i = 0; i < degree; i++) {
            const algsurf_complex v = boxes[i].root;
            double k = atan2(v.im, v.re) * degree / 6.283185307179586;
            assert_true(fabs(hypot(v.re, v.im) - 1) < 1e-15 && fabs(k - round(k)) < 1e-12);
            for (int j = 0; j < 4; j++)
                exact += case_in((algsurf_complex){j == 0   ? 1
                                                   : j == 1 ? -1
                                                            : 0,
                                                   j == 2   ? 1
                                                   : j == 3 ? -1
                                                            : 0},
                                 boxes[i].box);
            assert_true(boxes[i].box.re.hi - boxes[i].box.re.lo <= 4 * DBL_EPSILON);
        }
        assert_int_equal(exact, 4);
        static algsurf_complex_root simple[LARGE];
        int count = 0;
        assert_ok(algsurf_complex_roots(large, NULL, degree, simple, &count));
        assert_int_equal(count, degree);
        assert_memory_equal(simple, boxes, (size_t)degree * sizeof *simple);
    }
}

/* Roots of random polynomials lie near the unit circle, apart: none may drag the others into one box. */
TEST(test_random_high_degrees) {
    uint64_t seed = 7;
    for (int round = 0; round < 24; round++) {
        int degree = round % 3 == 0 ? 128 : round % 3 == 1 ? 300 : LARGE;
        for (int k = 0; k <= degree; k++)
            large[k] = (algsurf_complex){random_unit(&seed), round % 2 ? random_unit(&seed) : 0};
        int count = run(degree, NULL, NULL);
        if (count < degree - degree / 50) fail_msg("round %d: %d boxes for degree %d", round, count, degree);
    }
    /* (z^256 - 3.8^256)(z^256 - 0.2375^256): coefficients too far apart for one scale */
    memset(large, 0, sizeof large);
    large[512].re = 1, large[256].re = -pow(3.8, 256), large[0].re = pow(3.8, 256) * pow(0.2375, 256);
    assert_int_equal(run(LARGE, NULL, NULL), LARGE);
}

TEST(test_start_values) {
    enum { N = 10 };
    algsurf_complex_solver_stats cold = {.size = sizeof cold}, warm = {.size = sizeof warm};
    algsurf_complex start[N];
    const double odd[] = {NAN, HUGE_VAL, 1e300, 1e155, 1e-155, 1e-300, TINY, 0, 1, -3};
    memset(large, 0, sizeof large);
    for (int k = 0; k <= N; k++) large[k] = (algsurf_complex){k % 3 - 0.5, k % 4 - 1.25};
    assert_int_equal(run(N, NULL, &cold), N);
    algsurf_complex_root expected[N];
    memcpy(expected, boxes, sizeof expected);
    for (int i = 0; i < N; i++) start[i] = boxes[i].root;
    assert_int_equal(run(N, start, &warm), N);
    assert_true(cold.iterations >= 2 * N && warm.iterations <= 2 * N && warm.retries == 0);
    for (size_t o = 0; o < sizeof odd / sizeof *odd; o++)
        for (int equal = 0; equal < 2; equal++) {
            for (int i = 0; i < N; i++)
                start[i] = (algsurf_complex){odd[o] * (equal ? 1 : 1 + i), equal ? 0 : odd[o] * i};
            int count = run(N, start, NULL);
            assert_int_equal(count, N);
            for (int i = 0; i < N; i++) assert_true(case_meet(boxes[i].box, expected[i].box));
        }
}

TEST(test_reuse_and_environments) {
    enum { N = 9 };
    algsurf_complex c[N + 1] = {{0, 0}};
    algsurf_complex_root first[N], again[N];
    int count, count_again;
    for (int k = 0; k <= N; k++) c[k] = (algsurf_complex){1.0 / (k + 1), k == 4 ? 0x1p-1060 : 0.1 * k};
    assert_ok(algsurf_complex_roots(c, NULL, N, first, &count));
    for (int i = 0; i < 2 * ENVIRONMENTS; i++) {
        if (i == ENVIRONMENTS) { /* after a large and different problem */
            memset(large, 0, sizeof large), large[0].re = 7, large[100].im = 1;
            (void)run(100, NULL, NULL);
        }
        memset(again, 0, sizeof again);
        environment_set(i % ENVIRONMENTS);
        algsurf_status status =
            i % 2 ? algsurf_complex_roots(c, NULL, N, again, &count_again)
                  : algsurf_complex_solver_run(solver, c, NULL, N, NULL, again, &count_again, NULL);
        assert_true(environment_unset(i % ENVIRONMENTS));
        assert_ok(status);
        assert_int_equal(count, count_again);
        for (int k = 0; k < count; k++) {
            assert_memory_equal(&first[k].box, &again[k].box, sizeof first[k].box);
            assert_memory_equal(&first[k].root, &again[k].root, sizeof first[k].root);
        }
    }
}

int main(void) {
    if (algsurf_complex_solver_create(LARGE, &solver) != ALGSURF_OK) return 1;
    int failed = unit_run("allroots");
    algsurf_complex_solver_free(solver);
    algsurf_complex_solver_free(NULL);
    return failed;
}
