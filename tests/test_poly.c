/* test_poly.c - every bound of poly.c against exact rationals.
 *
 * Breaks caught: a rounding not counted (a bound without its u |sum| part fails within a few rounds), a
 * radius not propagated, an absolute pad forgotten (the subnormal rounds), compensation lost (bounds as wide
 * as plain Horner's fail the tightness tests), a weight of the wrong index in the Bernstein scheme. */
#include "exact.h"

#include "algsurf/poly.h"
#include "environments.h"

#define SEED 5u
#define TOP ALGSURF_MAX_POLY_DEGREE

typedef algsurf_status (*evaluator)(const double *, const double *, int, double, double *, double *);

static void fill(uint64_t *seed, double *c, double *r, int n, int low, int high) {
    for (int i = 0; i <= n; i++) {
        c[i] = random_int(seed, 8) ? random_wide(seed, low, high) : 0.0;
        r[i] = random_int(seed, 3) ? fabs(ldexp(c[i], -random_int(seed, 60))) : 0.0;
    }
}

/* A member of the set at the extreme that is farthest from the centre for t, or some other corner. */
static void corner(uint64_t *seed, mpq_t *q, const double *c, const double *r, int n, double t, int extreme) {
    mpq_t radius;
    mpq_init(radius);
    for (int i = 0; i <= n; i++) {
        int up = extreme ? (t >= 0 || i % 2 == 0) : random_int(seed, 2);
        exact_set(q[i], c[i]), exact_set(radius, r[i]);
        if (up)
            mpq_add(q[i], q[i], radius);
        else
            mpq_sub(q[i], q[i], radius);
    }
    mpq_clear(radius);
}

static void horner_of(mpq_t y, mpq_t *q, int n, double t) {
    mpq_t x;
    mpq_init(x);
    exact_set(x, t), mpq_set_ui(y, 0, 1);
    for (int i = n; i >= 0; i--) mpq_mul(y, y, x), mpq_add(y, y, q[i]);
    mpq_clear(x);
}

static void check_eval(evaluator eval, uint64_t *seed, const double *c, const double *r, int n, double t,
                       int round) {
    mpq_t *q = malloc((size_t)(n + 1) * sizeof *q), y;
    mpq_init(y);
    for (int i = 0; i <= n; i++) mpq_init(q[i]);
    double value = 0, bound = 0;
    assert_ok(eval(c, NULL, n, t, &value, &bound));
    exact_poly_at(y, c, n, t);
    int holds = exact_within(value, y, bound);
    for (int extreme = 0; holds && extreme < 2; extreme++) {
        assert_ok(eval(c, r, n, t, &value, &bound));
        corner(seed, q, c, r, n, t, extreme);
        horner_of(y, q, n, t);
        holds = exact_within(value, y, bound);
    }
    if (!holds) {
        exact_print_doubles("c", c, n + 1), exact_print_doubles("r", r, n + 1), exact_print("p(t)", y);
        fail_msg("seed %u round %d t = %a: value %a, bound %a", SEED, round, t, value, bound);
    }
    for (int i = 0; i <= n; i++) mpq_clear(q[i]);
    free(q), mpq_clear(y);
}

static const struct {
    int rounds, degree, low, high, t_low, t_high;
} families[] = {
    {3000, 12, -4, 4, -3, 1},          /* what a ray gives */
    {300, 64, -4, 4, -2, 0},           /* high degree */
    {1000, 8, -1074, -1000, -20, 20},  /* subnormal coefficients */
    {1000, 10, -600, -400, -500, 60},  /* products that underflow, amplified or not */
    {1000, 8, -1000, 1000, -100, 100}, /* everything, overflow included */
    {300, 3, 900, 1023, -10, 10},      /* sums that overflow */
};

static void evaluate_families(evaluator eval) {
    uint64_t seed = SEED;
    double c[65], r[65];
    for (size_t f = 0; f < sizeof families / sizeof families[0]; f++)
        for (int i = 0; i < families[f].rounds; i++) {
            int n = random_int(&seed, families[f].degree + 1);
            fill(&seed, c, r, n, families[f].low, families[f].high);
            double t = random_wide(&seed, families[f].t_low, families[f].t_high);
            check_eval(eval, &seed, c, r, n, i % 50 ? t : 0.0, i);
        }
}

TEST(test_eval_encloses) { evaluate_families(algsurf_poly_value); }

TEST(test_compensated_encloses) { evaluate_families(algsurf_poly_value_compensated); }

TEST(test_largest_degree) {
    uint64_t seed = SEED;
    double c[TOP + 1], r[TOP + 1];
    for (int i = 0; i < 4; i++) {
        fill(&seed, c, r, TOP, -3, 3);
        check_eval(algsurf_poly_value, &seed, c, r, TOP, random_unit(&seed), i);
        check_eval(algsurf_poly_value_compensated, &seed, c, r, TOP, random_unit(&seed), i);
    }
}

/* sum |c_i t^i|. */
static double magnitude(const double *c, int n, double t) {
    double y = 0.0;
    for (int i = n; i >= 0; i--) y = y * fabs(t) + fabs(c[i]);
    return y;
}

/* The bounds are not only right but as small as promised, and the radii dominate when they should. */
TEST(test_bounds_are_tight) {
    uint64_t seed = SEED;
    double c[33], r[33], value, bound;
    for (int i = 0; i < 2000; i++) {
        int n = 1 + random_int(&seed, 32);
        fill(&seed, c, r, n, -4, 4);
        double t = random_unit(&seed), size = magnitude(c, n, t);
        assert_ok(algsurf_poly_value(c, NULL, n, t, &value, &bound));
        assert_true(bound <= 2 * n * 0x1p-52 * size + 0x1p-1000);
        assert_ok(algsurf_poly_value_compensated(c, NULL, n, t, &value, &bound));
        assert_true(bound <= 0x1p-52 * fabs(value) + 4.0 * n * n * 0x1p-105 * size + 0x1p-1000);
        double radii = magnitude(r, n, t);
        assert_ok(algsurf_poly_value_compensated(c, r, n, t, &value, &bound));
        assert_true(bound <=
                    1.001 * radii + 0x1p-52 * fabs(value) + 4.0 * n * n * 0x1p-105 * size + 0x1p-1000);
    }
}

/* (t-1)^8 close to 1, at ordinary, huge and tiny scale: plain Horner knows nothing, the compensated one all.
 */
TEST(test_compensation_pays) {
    static const double p[9] = {1, -8, 28, -56, 70, -56, 28, -8, 1};
    static const int scales[] = {0, 990, 1017, -990, -1070};
    for (size_t k = 0; k < sizeof scales / sizeof scales[0]; k++) {
        double c[9], value, bound;
        for (int i = 0; i <= 8; i++) c[i] = ldexp(p[i], scales[k]);
        assert_ok(algsurf_poly_value(c, NULL, 8, 1 + 0x1p-8, &value, &bound));
        assert_true(fabs(value) <= bound);
        if (scales[k] < -900) continue; /* the value itself underflows */
        assert_ok(algsurf_poly_value_compensated(c, NULL, 8, 1 + 0x1p-8, &value, &bound));
        assert_true(fabs(value - ldexp(1.0, scales[k] - 64)) <= bound);
        assert_true(bound < 0x1p-20 * value);
    }
}

/* Overflow: an infinite value has an infinite bound; a radius may overflow alone. */
TEST(test_overflow) {
    const double c[3] = {1, 0, 1e300}, r[3] = {0, 0, 1.7e308};
    double value, bound;
    assert_ok(algsurf_poly_value(c, NULL, 2, -1e10, &value, &bound));
    assert_true(value == INFINITY && bound == INFINITY);
    assert_ok(algsurf_poly_value_compensated(c, NULL, 2, -1e10, &value, &bound));
    assert_true(value == INFINITY && bound == INFINITY);
    assert_ok(algsurf_poly_value(c, r, 2, 2.0, &value, &bound));
    assert_true(value == 4e300 && bound == INFINITY);
    const double huge[2] = {1.7e308, 1.7e308};
    assert_ok(algsurf_poly_value(huge, huge, 1, 0.0, &value, &bound));
    assert_true(value == 1.7e308 && bound >= 1.7e308);
    const double top[3] = {0, DBL_MAX, 1}, top_r[3] = {0, DBL_MAX, 0}; /* 0 * inf on the way to the bound */
    assert_ok(algsurf_poly_value(top, top_r, 2, 0.0, &value, &bound));
    assert_true(value == 0 && bound == INFINITY);
}

/* c_n t^n + c_0, which cancel, where the first products lose bits to underflow that 50 powers of t then
 * lift up to 2^-75: far above the errors that are relative to anything. */
TEST(test_amplified_underflow) {
    uint64_t seed = SEED;
    mpq_t y;
    mpq_init(y);
    for (int i = 0; i < 200; i++) {
        double c[52] = {0}, value, bound;
        c[51] = fabs(random_wide(&seed, -1022, -1022));
        double t = fabs(random_wide(&seed, 19, 19)) * 1.01;
        exact_poly_at(y, c, 51, t);
        c[0] = -mpq_get_d(y);
        assert_ok(algsurf_poly_value_compensated(c, NULL, 51, t, &value, &bound));
        exact_poly_at(y, c, 51, t);
        assert_true(exact_within(value, y, bound));
    }
    mpq_clear(y);
}

/* ---- Bernstein ---- */

static void fail_bernstein(const char *what, int round, const double *c, const double *r, int n, double lo,
                           double hi, int j) {
    exact_print_doubles("c", c, n + 1), exact_print_doubles("r", r, n + 1);
    fail_msg("%s, seed %u round %d on [%a,%a], coefficient %d", what, SEED, round, lo, hi, j);
}

/* Any member's coefficients are enclosed.  Corners of the box of radii are made as doubles: c +- r with r a
 * power of two times an ulp of c would not be exact, so the member is c[i] + r[i] with r[i] = |c[i]| * 2^-k,
 * k <= 0, or r[i] = 0; both sums are exact. */
static void check_bernstein(uint64_t *seed, int n, const double *c, double lo, double hi, int round) {
    double r[TOP + 1], member[TOP + 1], b[TOP + 1], br[TOP + 1], zero[TOP + 1] = {0};
    mpq_t *exact = malloc((size_t)(n + 1) * sizeof *exact);
    for (int i = 0; i <= n; i++) {
        mpq_init(exact[i]);
        r[i] = random_int(seed, 2) ? fabs(c[i]) : 0.0;
        member[i] = c[i] + (random_int(seed, 2) ? r[i] : -r[i]);
    }
    assert_ok(algsurf_poly_to_bernstein(c, NULL, n, lo, hi, b, br));
    exact_bernstein(exact, c, n, lo, hi);
    for (int j = 0; j <= n; j++)
        if (!exact_within(b[j], exact[j], br[j])) fail_bernstein("exact", round, c, zero, n, lo, hi, j);
    assert_ok(algsurf_poly_to_bernstein(c, r, n, lo, hi, b, br));
    exact_bernstein(exact, member, n, lo, hi);
    for (int j = 0; j <= n; j++)
        if (!exact_within(b[j], exact[j], br[j])) fail_bernstein("radii", round, c, r, n, lo, hi, j);
    for (int i = 0; i <= n; i++) mpq_clear(exact[i]);
    free(exact);
}

TEST(test_bernstein_encloses) {
    static const struct {
        int rounds, degree, low, high, x_low, x_high;
    } family[] = {{500, 12, -4, 4, -3, 1},
                  {5, 48, -4, 4, -2, 1},
                  {300, 8, -1074, -1000, -60, 60},
                  {300, 6, -1000, -900, -1000, 100},
                  {100, 2, -400, -300, 300, 600}};
    uint64_t seed = SEED;
    double c[TOP + 1];
    for (size_t f = 0; f < sizeof family / sizeof family[0]; f++)
        for (int i = 0; i < family[f].rounds; i++) {
            int n = random_int(&seed, family[f].degree + 1);
            for (int k = 0; k <= n; k++) c[k] = random_wide(&seed, family[f].low, family[f].high);
            for (int k = n; k > 0 && random_int(&seed, 3) == 0; k--) c[k] = 0.0;
            double lo = random_wide(&seed, family[f].x_low, family[f].x_high), hi = lo;
            while (hi == lo) hi = random_wide(&seed, family[f].x_low, family[f].x_high);
            check_bernstein(&seed, n, c, fmin(lo, hi), fmax(lo, hi), i);
        }
}

/* 1 is 1 in every degree, t runs evenly from lo to hi; degree 512 stays within its promised error. */
TEST(test_bernstein_of_simple_polynomials) {
    double c[TOP + 1] = {1.0}, b[TOP + 1], br[TOP + 1], value, bound;
    assert_ok(algsurf_poly_to_bernstein(c, NULL, TOP, -3.0, 7.0, b, br));
    for (int j = 0; j <= TOP; j++) assert_true(b[j] == 1.0 && br[j] == 0.0);
    c[0] = 0.0, c[1] = 1.0; /* leading zeros: no pad for underflow may grow with the powers of t */
    assert_ok(algsurf_poly_value(c, NULL, TOP, 1e10, &value, &bound));
    assert_true(value == 1e10 && bound <= 1e10 * 0x1p-51);
    assert_ok(algsurf_poly_to_bernstein(c, NULL, TOP, -1.0, 1.0, b, br));
    for (int j = 0; j <= TOP; j++) {
        assert_true(fabs(b[j] - (-1.0 + 2.0 * j / TOP)) <= br[j] + 0x1p-52);
        assert_true(br[j] <= 8 * 0x1p-53);
    }
    for (int i = 0; i <= TOP; i++) c[i] = i % 2 ? -1.0 : 1.0;
    assert_ok(algsurf_poly_to_bernstein(c, NULL, TOP, -1.0, 1.0, b, br));
    for (int j = 0; j <= TOP; j++) assert_true(br[j] <= 8.0 * TOP * 0x1p-53 * (TOP + 1));
    assert_true(fabs(b[0] - (TOP + 1)) <= br[0] && fabs(b[TOP] - 1.0) <= br[TOP]);
    c[0] = 0.1;
    assert_ok(algsurf_poly_to_bernstein(c, NULL, 0, 0.0, 1.0, b, br));
    assert_true(b[0] == 0.1 && br[0] == 0.0);
}

TEST(test_bernstein_range) {
    const double c[3] = {1, 1, 1e-300}, r[3] = {0, 0, 1e200};
    double b[3] = {7, 7, 7}, br[3] = {7, 7, 7};
    assert_ok(algsurf_poly_to_bernstein(c, NULL, 2, -1e300, 1e300, b, br));
    assert_true(b[0] < 0 || br[0] > 0);
    b[0] = br[0] = 7;
    assert_int_equal(algsurf_poly_to_bernstein(c, r, 2, -1e300, 1e300, b, br), ALGSURF_E_RANGE);
    const double d[3] = {1, 1, 1};
    assert_int_equal(algsurf_poly_to_bernstein(d, NULL, 2, -1e300, 1e300, b, br), ALGSURF_E_RANGE);
    assert_int_equal(algsurf_poly_to_bernstein(d, NULL, 2, 0.0, 1e300, b, br), ALGSURF_E_RANGE);
    assert_true(b[0] == 7 && br[0] == 7);
}

/* ---- any environment, bad input ---- */

static struct { double c[9], r[9], t; } asked;

static void evaluate(void *answers) {
    double(*to)[9] = answers;
    (void)algsurf_poly_value(asked.c, asked.r, 8, asked.t, &to[0][0], &to[0][1]);
    (void)algsurf_poly_value_compensated(asked.c, asked.r, 8, asked.t, &to[0][2], &to[0][3]);
    (void)algsurf_poly_to_bernstein(asked.c, asked.r, 8, -1, 0.3, to[1], to[2]);
}

TEST(test_any_environment) {
    uint64_t seed = SEED;
    for (int i = 0; i < 300; i++) {
        int low = i % 2 ? -1074 : -4;
        fill(&seed, asked.c, asked.r, 8, low, low + 8);
        asked.t = random_unit(&seed);
        environments_agree(evaluate, sizeof(double[3][9]));
    }
}

static void refuse_eval(evaluator eval) {
    const double c[2] = {1, 2}, nan_c[2] = {1, NAN}, inf_c[2] = {-INFINITY, 1}, good[2] = {0, 1};
    const double negative[2] = {0, -0x1p-1074}, nan_r[2] = {NAN, 0}, inf_r[2] = {0, INFINITY};
    double value = 7, bound = 8;
    assert_int_equal(eval(NULL, NULL, 1, 0, &value, &bound), ALGSURF_E_ARGUMENT);
    assert_int_equal(eval(c, NULL, 1, 0, NULL, &bound), ALGSURF_E_ARGUMENT);
    assert_int_equal(eval(c, NULL, -1, 0, &value, &bound), ALGSURF_E_ARGUMENT);
    assert_int_equal(eval(c, NULL, TOP + 1, 0, &value, &bound), ALGSURF_E_DEGREE);
    assert_int_equal(eval(c, negative, 1, 0, &value, &bound), ALGSURF_E_ARGUMENT);
    assert_int_equal(eval(nan_c, NULL, 1, 0, &value, &bound), ALGSURF_E_NOT_FINITE);
    assert_int_equal(eval(inf_c, NULL, 1, 0, &value, &bound), ALGSURF_E_NOT_FINITE);
    assert_int_equal(eval(c, nan_r, 1, 0, &value, &bound), ALGSURF_E_NOT_FINITE);
    assert_int_equal(eval(c, inf_r, 1, 0, &value, &bound), ALGSURF_E_NOT_FINITE);
    assert_int_equal(eval(c, NULL, 1, NAN, &value, &bound), ALGSURF_E_NOT_FINITE);
    assert_int_equal(eval(c, NULL, 1, -INFINITY, &value, &bound), ALGSURF_E_NOT_FINITE);
    assert_true(value == 7 && bound == 8);
    assert_ok(eval(c, good, 1, 3, &value, &bound));
    assert_true(value == 7 && bound >= 3 && bound < 3.001);
}

TEST(test_bad_input_eval) {
    refuse_eval(algsurf_poly_value);
    refuse_eval(algsurf_poly_value_compensated);
}

TEST(test_bad_input_bernstein) {
    const double c[2] = {1, 2}, bad[2] = {NAN, 0}, negative[2] = {0, -1};
    double b[2] = {7, 7}, br[2] = {7, 7};
    assert_int_equal(algsurf_poly_to_bernstein(NULL, NULL, 1, 0, 1, b, br), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_poly_to_bernstein(c, NULL, 1, 0, 1, NULL, br), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_poly_to_bernstein(c, NULL, -1, 0, 1, b, br), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_poly_to_bernstein(c, NULL, TOP + 1, 0, 1, b, br), ALGSURF_E_DEGREE);
    assert_int_equal(algsurf_poly_to_bernstein(c, negative, 1, 0, 1, b, br), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_poly_to_bernstein(c, NULL, 1, 1, 1, b, br), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_poly_to_bernstein(c, NULL, 1, 2, 1, b, br), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_poly_to_bernstein(bad, NULL, 1, 0, 1, b, br), ALGSURF_E_NOT_FINITE);
    assert_int_equal(algsurf_poly_to_bernstein(c, bad, 1, 0, 1, b, br), ALGSURF_E_NOT_FINITE);
    assert_int_equal(algsurf_poly_to_bernstein(c, NULL, 1, NAN, 1, b, br), ALGSURF_E_NOT_FINITE);
    assert_int_equal(algsurf_poly_to_bernstein(c, NULL, 1, 0, INFINITY, b, br), ALGSURF_E_NOT_FINITE);
    assert_true(b[0] == 7 && b[1] == 7 && br[0] == 7 && br[1] == 7);
}
