/* test_surface_eval.c - values, gradients and their bounds, against rational arithmetic.
 *
 * Each test says which breaks it catches.
 */
#include "scenes.h"
#include "surface/impl.h"

static const uint64_t seed = 20240607;

static void print_case(const algsurf_surface *s, const double point[3]) {
    fprintf(stderr, "seed %llu\n", (unsigned long long)seed);
    for (size_t t = 0; t < s->term_count; t++) {
        fprintf(stderr, "%d %d %d %a\n", s->terms[t].i, s->terms[t].j, s->terms[t].k, s->terms[t].a);
    }
    exact_print_doubles("point", point, 3);
}

static void power(mpq_t q, const mpq_t x, int n) {
    mpz_pow_ui(mpq_numref(q), mpq_numref(x), (unsigned long)n);
    mpz_pow_ui(mpq_denref(q), mpq_denref(x), (unsigned long)n);
}

/* value = P or its derivative by coordinate `by` (-1: none) at x; size = the same on magnitudes. */
static void exact_surface(mpq_t value, mpq_t size, const algsurf_surface *s, mpq_t x[3], int by) {
    mpq_t product, factor;
    mpq_inits(product, factor, NULL);
    mpq_set_ui(value, 0, 1), mpq_set_ui(size, 0, 1);
    for (size_t t = 0; t < s->term_count; t++) {
        int e[3] = {s->terms[t].i, s->terms[t].j, s->terms[t].k};
        exact_set(product, s->terms[t].a);
        if (by >= 0) {
            if (e[by] == 0) continue;
            mpq_set_si(factor, e[by]--, 1), mpq_mul(product, product, factor);
        }
        for (int axis = 0; axis < 3; axis++)
            power(factor, x[axis], e[axis]), mpq_mul(product, product, factor);
        mpq_add(value, value, product);
        mpq_abs(product, product), mpq_add(size, size, product);
    }
    mpq_clears(product, factor, NULL);
}

/* q 2^e */
static void scale(mpq_t q, int e) {
    e >= 0 ? mpq_mul_2exp(q, q, (mp_bitcnt_t)e) : mpq_div_2exp(q, q, (mp_bitcnt_t)-e);
}

/* Is x <= 2^e? */
static int below(const mpq_t x, int e) {
    mpq_t limit;
    mpq_init(limit);
    mpq_set_ui(limit, 1, 1), scale(limit, e);
    int yes = mpq_cmp(x, limit) <= 0;
    mpq_clear(limit);
    return yes;
}

/* The bound encloses, and is no larger than a few roundings of each term. */
static int bound_holds(double value, double bound, const mpq_t exact, mpq_t size, const algsurf_surface *s) {
    mpq_t limit, absolute, got;
    mpq_inits(limit, absolute, got, NULL);
    mpq_set_ui(limit, (unsigned long)(5 * s->degree + 20) + s->term_count, 1);
    mpq_mul(limit, limit, size), scale(limit, -53);
    mpq_set_ui(absolute, 1, 1), scale(absolute, -1072), mpq_add(limit, limit, absolute);
    exact_set(got, bound);
    int holds = exact_within(value, exact, bound) && mpq_cmp(got, limit) <= 0;
    mpq_clears(limit, absolute, got, NULL);
    return holds;
}

/* All four numbers at a point; returns 0 for an honest E_RANGE. */
static int check_point(const algsurf_surface *s, const double point[3]) {
    double value, bound, v, gradient[3], bounds[4];
    mpq_t x[3], exact[4], size[4];
    int small = 1;
    for (int axis = 0; axis < 3; axis++) mpq_init(x[axis]), exact_set(x[axis], point[axis]);
    for (int n = 0; n < 4; n++) {
        mpq_inits(exact[n], size[n], NULL);
        exact_surface(exact[n], size[n], s, x, n - 1);
        small &= below(size[n], 1023);
    }
    algsurf_status a = algsurf_surface_value(s, point, &value, &bound);
    algsurf_status b = algsurf_surface_gradient(s, point, &v, gradient, &bounds[0], &bounds[1]);
    int ok = a == ALGSURF_OK ? bound_holds(value, bound, exact[0], size[0], s) : a == ALGSURF_E_RANGE;
    ok &= a == ALGSURF_OK || !below(size[0], 1023);
    ok &= b == ALGSURF_OK || (b == ALGSURF_E_RANGE && !small);
    if (b == ALGSURF_OK) {
        ok &= bound_holds(v, bounds[0], exact[0], size[0], s);
        for (int n = 1; n < 4; n++) {
            /* A derivative's padding may show next to a larger one: judge the size of all three. */
            mpq_t *largest = mpq_cmp(size[1], size[2]) > 0 ? &size[1] : &size[2];
            if (mpq_cmp(*largest, size[3]) < 0) largest = &size[3];
            ok &= bound_holds(gradient[n - 1], bounds[n], exact[n], *largest, s);
        }
    }
    for (int axis = 0; axis < 3; axis++) mpq_clear(x[axis]);
    for (int n = 0; n < 4; n++) mpq_clears(exact[n], size[n], NULL);
    if (!ok) print_case(s, point);
    assert_true(ok);
    return b == ALGSURF_OK;
}

/* Moves point[0] to where P changes sign in double, if it does in [-2,2]: terms cancel there. */
static void move_to_surface(const algsurf_surface *s, double point[3]) {
    double lo = -2, hi = 2, at_lo, v;
    point[0] = lo;
    if (algsurf_surface_value(s, point, &at_lo, NULL) != ALGSURF_OK) return;
    for (int i = 0; i < 70; i++) {
        point[0] = (lo + hi) / 2;
        assert_ok(algsurf_surface_value(s, point, &v, NULL));
        if ((v < 0) == (at_lo < 0)) {
            lo = point[0];
        } else {
            hi = point[0];
        }
    }
}

/* Catches: a bound factor of u/8, a derivative without its inner value, unit or scale left out. */
TEST(test_ordinary_points) {
    uint64_t state = seed;
    for (int n = 0; n < 1500; n++) {
        algsurf_surface *s = surface_of_random_terms(&state, n % 50 == 0 ? 64 : 1 + n % 12, -12, 12);
        double point[3] = {random_unit(&state), 2 * random_unit(&state), random_unit(&state)};
        if (n % 5 == 0) point[n % 3] = 0;
        assert_true(check_point(s, point));
        move_to_surface(s, point);
        assert_true(check_point(s, point));
    }
}

/* Coefficients and points over the whole range.  Catches: no fallback where the natural unit drives
 * the point out of range, no absolute part in the bounds, to_natural without its check. */
TEST(test_extreme_points) {
    uint64_t state = seed;
    int in_range = 0, rounds = 1200;
    for (int n = 0; n < rounds; n++) {
        int wide = n % 2 ? 1020 : 300;
        algsurf_surface *s = surface_of_random_terms(&state, 1 + n % 7, n % 3 ? -wide : -1074, wide);
        double point[3];
        int reach = n % 4 ? 1073 : 100;
        for (int axis = 0; axis < 3; axis++) point[axis] = random_wide(&state, -reach, reach - 50);
        in_range += check_point(s, point);
    }
    assert_true(in_range > rounds / 4);
}

/* The natural unit is far from the point's, the value is not.  Catches: no fallback on overflow. */
TEST(test_small_lower_term) {
    const algsurf_term terms[] = {{1, 0, 0, 1e300}, {0, 0, 0, 1e-300}};
    algsurf_surface *s = surface_of_terms(terms, 2);
    const double points[][3] = {{1, 0, 0}, {-1e-300, 5, 1e300}, {0, 0, 0}, {0x1p-1074, 0, 0}, {1e8, 0, 0}};
    for (size_t p = 0; p < 5; p++) assert_true(check_point(s, points[p]));
}

/* The private function works in natural units: powers of two away from the public one, bit for bit.
 * Catches: a unit or scale forgotten, a value that depends on whether the gradient is wanted. */
TEST(test_natural_units) {
    uint64_t state = seed;
    for (int n = 0; n < 1000; n++) {
        algsurf_surface *s = surface_of_random_terms(&state, 1 + n % 9, -40, 40);
        double natural[3], point[3], gradient[3], public_gradient[3], public_value;
        for (int axis = 0; axis < 3; axis++) {
            natural[axis] = random_wide(&state, -3, 1);
            point[axis] = ldexp(natural[axis], s->unit);
        }
        assert_ok(algsurf_surface_gradient(s, point, &public_value, public_gradient, NULL, NULL));
        double value = algsurf_i_surface_value(s, natural, gradient);
        assert_true(ldexp(value, -s->scale) == public_value);
        for (int axis = 0; axis < 3; axis++)
            assert_true(ldexp(gradient[axis], -s->scale - s->unit) == public_gradient[axis]);
    }
}

/* Catches: each missing check, an output written on failure. */
TEST(test_refused_points) {
    const algsurf_term square = {2, 0, 0, 1e300};
    algsurf_surface *s = surface_of_terms(&square, 1);
    double v = 7, b = 7, g[3] = {7, 7, 7}, gb[3] = {7, 7, 7};
    const double good[3] = {1, 2, 3}, huge[3] = {1e10, 0, 0};
    const double bad[3][3] = {{NAN, 0, 0}, {0, INFINITY, 0}, {0, 0, -INFINITY}};
    for (int p = 0; p < 3; p++) {
        assert_int_equal(algsurf_surface_value(s, bad[p], &v, &b), ALGSURF_E_NOT_FINITE);
        assert_int_equal(algsurf_surface_gradient(s, bad[p], &v, g, &b, gb), ALGSURF_E_NOT_FINITE);
    }
    assert_int_equal(algsurf_surface_value(s, huge, &v, &b), ALGSURF_E_RANGE);
    assert_int_equal(algsurf_surface_gradient(s, huge, &v, g, &b, gb), ALGSURF_E_RANGE);
    assert_int_equal(algsurf_surface_value(NULL, good, &v, &b), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_surface_value(s, NULL, &v, &b), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_surface_value(s, good, NULL, &b), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_surface_gradient(NULL, good, &v, g, &b, gb), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_surface_gradient(s, NULL, &v, g, &b, gb), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_surface_gradient(s, good, NULL, g, &b, gb), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_surface_gradient(s, good, &v, NULL, &b, gb), ALGSURF_E_ARGUMENT);
    assert_true(v == 7 && b == 7 && g[0] == 7 && g[1] == 7 && g[2] == 7 && gb[0] == 7);
    assert_ok(algsurf_surface_gradient(s, good, &v, g, NULL, NULL));
    assert_true(v == 1e300 && g[0] == 2e300 && g[1] == 0);
}
