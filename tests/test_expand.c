/* test_expand.c - the polynomial along a ray, and its radii, against integers.
 *
 * Breaks caught, each tried: radii of a quarter of a rounding, radii sixteen times too wide, radii not scaled
 * like the coefficients, the pad for underflow left out, the middle of the chord computed without its
 * rounding error, an expansion about a far origin.  (Radii that count half of the roundings still hold: those
 * add up like a random walk.)
 */
#include "exact_ray.h"

#include "algsurf/expand.h"
#include "environments.h"
#include "scenes.h"

#define SEED 21u

enum { MOST_TERMS = 300 };

typedef struct random_case {
    algsurf_surface *surface;
    algsurf_term terms[MOST_TERMS];
    int count, degree;
    algsurf_ray ray;
} random_case;

/* Dense up to degree 10, or a few terms; coefficients of one size or over 20 orders of magnitude; then X is
 * replaced by X / scale, as if the whole scene were that much larger. */
static int make_surface(random_case *r, uint64_t *seed, int exponent) {
    int n = 1 + random_int(seed, 10), dense = random_int(seed, 3) == 0, count = 0;
    int wide = random_int(seed, 4) == 0 ? 30 : 1;
    for (int i = 0; i <= n; i++)
        for (int j = 0; j <= n - i; j++)
            for (int k = 0; k <= n - i - j; k++)
                if (dense || i + j + k == 0 || random_int(seed, n) == 0) {
                    double a = random_wide(seed, -wide, wide);
                    if (count < MOST_TERMS)
                        r->terms[count++] = (algsurf_term){i, j, k, ldexp(a, (n - i - j - k) * exponent)};
                }
    if (algsurf_surface_from_terms(r->terms, (size_t)count, &r->surface) != ALGSURF_OK) return 0;
    r->count = count, r->degree = algsurf_surface_degree(r->surface);
    return 1;
}

/* A ray towards the surface from `distance`, some components exactly zero, not of unit length. */
static void make_ray(random_case *r, uint64_t *seed, double distance, int exponent, int length) {
    double d[3];
    for (int i = 0; i < 3; i++) d[i] = random_int(seed, 5) ? random_unit(seed) : 0;
    if (d[0] == 0 && d[1] == 0 && d[2] == 0) d[random_int(seed, 3)] = 1;
    for (int i = 0; i < 3; i++) {
        r->ray.origin[i] = ldexp(random_int(seed, 6) ? random_unit(seed) - distance * d[i] : 0, exponent);
        r->ray.direction[i] = ldexp(d[i], exponent + length);
    }
    r->ray.t_min = ldexp(distance - fabs(random_unit(seed)), -length);
    r->ray.t_max = ldexp(distance + fabs(random_unit(seed)) + 0.01, -length);
}

static _Noreturn void expand_fail(const char *what, const random_case *r, int round, int k) {
    for (int i = 0; i < r->count; i++)
        fprintf(stderr, "{%d, %d, %d, %a}, ", r->terms[i].i, r->terms[i].j, r->terms[i].k, r->terms[i].a);
    fprintf(stderr, "\n");
    exact_print_doubles("origin", r->ray.origin, 3), exact_print_doubles("direction", r->ray.direction, 3);
    fail_msg("%s: seed %u round %d coefficient %d, t in [%a, %a]", what, SEED, round, k, r->ray.t_min,
             r->ray.t_max);
    abort();
}

static void judge_power(const random_case *r, int round, double *c, double *radius) {
    exact_line line = exact_line_of(r->terms, r->count, r->degree, &r->ray);
    mpq_t q;
    mpq_init(q);
    for (int k = 0; k <= r->degree; k++) {
        exact_line_coefficient(q, &line, k);
        if (!exact_within(c[k], q, radius[k])) expand_fail("power", r, round, k);
    }
    mpq_clear(q), exact_line_clear(&line);
}

static void judge_bernstein(const random_case *r, int round, double *b, double *radius) {
    exact_line line = exact_line_of(r->terms, r->count, r->degree, &r->ray);
    mpq_t q[16], a[16];
    for (int k = 0; k <= r->degree; k++) mpq_inits(q[k], a[k], NULL), exact_line_coefficient(a[k], &line, k);
    exact_bernstein_of(q, a, r->degree, r->ray.t_min, r->ray.t_max);
    for (int k = 0; k <= r->degree; k++)
        if (!exact_within(b[k], q[k], radius[k])) expand_fail("Bernstein", r, round, k);
    for (int k = 0; k <= r->degree; k++) mpq_clears(q[k], a[k], NULL);
    exact_line_clear(&line);
}

static const struct {
    int rounds;
    double distance;
    int exponent, length; /* of the scene, of the direction, in powers of two */
} families[] = {
    {600, 4, 0, 0},   {200, 1e4, 0, 0}, {200, 1e8, 0, 0}, {200, 0, 0, 0},    {40, 4, 0, 900},
    {40, 4, 0, -900}, {40, 4, 90, 0},   {40, 4, -90, 0},  {30, 4, 90, -300}, {30, 1e8, -90, 300},
};

TEST(test_radii_hold) {
    uint64_t seed = SEED;
    int done = 0, all = 0;
    for (size_t f = 0; f < sizeof families / sizeof families[0]; f++)
        for (int i = 0; i < families[f].rounds; i++) {
            static random_case r;
            double c[16], radius[16], alone[16];
            if (!make_surface(&r, &seed, families[f].exponent)) continue;
            make_ray(&r, &seed, families[f].distance, families[f].exponent, families[f].length);
            algsurf_status status = algsurf_expand_power(r.surface, &r.ray, c, radius);
            if (status == ALGSURF_OK) {
                judge_power(&r, i, c, radius);
                assert_ok(algsurf_expand_power(r.surface, &r.ray, alone, NULL));
                assert_memory_equal(c, alone, (size_t)(r.degree + 1) * sizeof *c);
            } else
                assert_int_equal(status, ALGSURF_E_RANGE);
            status = algsurf_expand_bernstein(r.surface, &r.ray, c, radius);
            if (status == ALGSURF_OK)
                judge_bernstein(&r, i, c, radius);
            else
                assert_int_equal(status, ALGSURF_E_RANGE);
            done += status == ALGSURF_OK, all++;
            algsurf_surface_free(r.surface);
        }
    if (done * 100 < all * 99) fail_msg("seed %u: %d of %d", SEED, done, all);
}

/* Components of direction and origin among subnormal numbers; the surface's unit is 1. */
TEST(test_tiny_components) {
    uint64_t seed = SEED;
    for (int i = 0; i < 100; i++) {
        random_case r = {.count = 3, .degree = 2};
        r.terms[0] = (algsurf_term){2, 0, 0, 1}, r.terms[1] = (algsurf_term){0, 1, 0, 0.5 + i};
        r.terms[2] = (algsurf_term){i % 2, 0, i % 2, -0.25};
        assert_ok(algsurf_surface_from_terms(r.terms, 3, &r.surface));
        r.ray = (algsurf_ray){{0, 0, 0}, {1, 0, 0}, -0.5, 1};
        for (int k = 0; k < 3; k++) {
            r.ray.origin[k] = random_int(&seed, 2) ? random_wide(&seed, -1074, -1000) : 0;
            if (k > 0) r.ray.direction[k] = random_wide(&seed, -1074, -1000);
        }
        double c[3], radius[3];
        algsurf_status status = algsurf_expand_power(r.surface, &r.ray, c, radius);
        assert_ok(status);
        judge_power(&r, i, c, radius);
        assert_ok(algsurf_expand_bernstein(r.surface, &r.ray, c, radius));
        judge_bernstein(&r, i, c, radius);
        algsurf_surface_free(r.surface);
    }
}

static int ascending(const void *a, const void *b) {
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* Radius over u (4 n + 8) (exact sum of magnitudes), the median and the largest over all coefficients: so
 * many roundings are counted, and 1 is what they should be. */
TEST(test_radii_are_small) {
    static double ratio[4000];
    uint64_t seed = SEED;
    int count = 0;
    for (int i = 0; i < 300; i++) {
        static random_case r;
        double c[16], radius[16];
        if (!make_surface(&r, &seed, 0)) continue;
        make_ray(&r, &seed, 4, 0, 0);
        assert_ok(algsurf_expand_power(r.surface, &r.ray, c, radius));
        exact_line size = exact_magnitudes_of(r.terms, r.count, r.degree, &r.ray);
        mpq_t q;
        mpq_init(q);
        for (int k = 0; k <= r.degree && count < 4000; k++) {
            exact_line_coefficient(q, &size, k);
            double magnitude = mpq_get_d(q);
            if (magnitude > 0)
                ratio[count++] = radius[k] / (0x1p-53 * (4 * r.degree + 8) * magnitude);
            else
                assert_true(radius[k] <= 0x1p-300); /* underflow, in the surface's unit */
        }
        mpq_clear(q), exact_line_clear(&size);
        algsurf_surface_free(r.surface);
    }
    qsort(ratio, (size_t)count, sizeof *ratio, ascending);
    assert_true(count > 1000);
    if (!(ratio[count / 2] < 1.01 && ratio[count - 1] < 1.1))
        fail_msg("median %g, largest %g", ratio[count / 2], ratio[count - 1]);
}

/* The same chord of the same line, seen from far away: the Bernstein radii stay what they were. */
TEST(test_far_camera) {
    const algsurf_term sextic[] = {{6, 0, 0, 1}, {2, 2, 2, -3}, {0, 4, 1, 0.5},
                                   {0, 0, 6, 1}, {1, 1, 1, 2},  {0, 0, 0, -1}};
    algsurf_surface *s = surface_of_terms(sextic, 6);
    double radii[2][7], b[2][7], p[7], pr[7];
    for (int far = 0; far < 2; far++) {
        double distance = far ? 0x1p20 : 4;
        algsurf_ray ray = {{0.25, -0.5, -distance}, {0, 0, 1}, distance - 1.25, distance + 1.25};
        assert_ok(algsurf_expand_bernstein(s, &ray, b[far], radii[far]));
        assert_ok(algsurf_expand_power(s, &ray, p, pr));
    }
    for (int k = 0; k < 7; k++) {
        assert_true(radii[1][k] <= 1.01 * radii[0][k] && radii[1][k] < 1e-12);
        assert_true(fabs(b[0][k] - b[1][k]) <= radii[0][k] + radii[1][k]);
    }
    assert_true(pr[0] > 1e3); /* and the power form about the far origin knows nothing, and says so */
}

static void expect(algsurf_status wanted, algsurf_status bernstein, const algsurf_surface *s,
                   const algsurf_ray *ray) {
    double c[3] = {7, 7, 7}, r[3] = {8, 8, 8};
    assert_int_equal(algsurf_expand_power(s, ray, c, r), wanted);
    if (wanted != ALGSURF_OK)
        assert_true(c[0] == 7 && c[1] == 7 && c[2] == 7 && r[0] == 8 && r[1] == 8 && r[2] == 8);
    c[0] = c[1] = c[2] = 7, r[0] = r[1] = r[2] = 8;
    assert_int_equal(algsurf_expand_bernstein(s, ray, c, r), bernstein);
    assert_true(c[0] == 7 && c[1] == 7 && c[2] == 7 && r[0] == 8 && r[1] == 8 && r[2] == 8);
}

TEST(test_bad_input) {
    const algsurf_term sphere[] = {{2, 0, 0, 1}, {0, 2, 0, 1}, {0, 0, 2, 1}, {0, 0, 0, -1}};
    const algsurf_ray good = {{0, 0, -4}, {0, 0, 1}, 2, 6};
    algsurf_ray ray = good;
    double c[3];
    algsurf_surface *s = surface_of_terms(sphere, 4);
    expect(ALGSURF_E_ARGUMENT, ALGSURF_E_ARGUMENT, NULL, &ray);
    expect(ALGSURF_E_ARGUMENT, ALGSURF_E_ARGUMENT, s, NULL);
    assert_int_equal(algsurf_expand_power(s, &ray, NULL, c), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_expand_bernstein(s, &ray, NULL, c), ALGSURF_E_ARGUMENT);
    ray.direction[2] = 0, expect(ALGSURF_E_ARGUMENT, ALGSURF_E_ARGUMENT, s, &ray);
    ray = good, ray.direction[0] = NAN, expect(ALGSURF_E_NOT_FINITE, ALGSURF_E_NOT_FINITE, s, &ray);
    ray = good, ray.origin[1] = INFINITY, expect(ALGSURF_E_NOT_FINITE, ALGSURF_E_NOT_FINITE, s, &ray);
    ray = good, ray.t_max = INFINITY, expect(ALGSURF_OK, ALGSURF_E_NOT_FINITE, s, &ray);
    ray = good, ray.t_min = 6, expect(ALGSURF_OK, ALGSURF_E_ARGUMENT, s, &ray);
    ray = good, ray.t_min = 7, expect(ALGSURF_OK, ALGSURF_E_ARGUMENT, s, &ray);
    ray = good, ray.t_min = NAN, expect(ALGSURF_OK, ALGSURF_E_NOT_FINITE, s, &ray);
    ray = good, ray.origin[1] = 1e200, expect(ALGSURF_E_RANGE, ALGSURF_E_RANGE, s, &ray);
    /* A chord so short, against the size of the surface, that its ends cannot be told apart. */
    const algsurf_term plane[] = {{1, 0, 0, 0x1p-454}, {0, 0, 0, -0x1p486}};
    s = surface_of_terms(plane, 2);
    ray = (algsurf_ray){{0, 0, 0x1p109}, {0, 0, 0x1p-720}, 2, 10};
    expect(ALGSURF_OK, ALGSURF_E_RANGE, s, &ray);
}

static random_case one;

static void expand_both(void *answers) {
    double(*to)[16] = answers;
    to[4][0] = algsurf_expand_power(one.surface, &one.ray, to[0], to[1]);
    to[4][1] = algsurf_expand_bernstein(one.surface, &one.ray, to[2], to[3]);
}

TEST(test_environment) {
    uint64_t seed = SEED;
    for (int i = 0; i < 40; i++) {
        if (!make_surface(&one, &seed, i % 3 ? 0 : -90)) continue;
        make_ray(&one, &seed, 4, i % 3 ? 0 : -90, 0);
        environments_agree(expand_both, sizeof(double[5][16]));
        algsurf_surface_free(one.surface);
    }
}
