/* test_intersect_options.c - methods, tolerances, tiers, the rules of the options struct, what is refused,
 * and the caller's floating-point environment.
 *
 * Breaks caught, each tried: a tolerance in the wrong unit (it is absolute in t, for any length of
 * direction), the method and the limit ignored, the root of the polynomial along the chord, whose rounding
 * exceeds small tolerances, taken for that of P, or a large tolerance made small, a capacity not looked at,
 * an unknown tail of options not looked at, an environment left as the caller's.
 */
#include "intersect_case.h"

#include "catalogue.h"
#include "environments.h"

#define SEED 43u
#define FEW 4 /* roundings of P at the hit that |t - exact| may have */

static intersect_case c;
static intersect_answer answer;
static const algsurf_intersect_options defaults = {.size = sizeof defaults};

static const char *const equations[] = {
    "x^2 + y^2 + z^2 - 1",
    "x^2 z + y^2",
    "x^4 - 5x^2 + y^4 - 5y^2 + z^4 - 5z^2 + 11.8",
    "x^2y^2 + x^2z^2 + y^2z^2 + x y z",
    "x^3 + y^3 + z^3 + 1 - 0.25 (x + y + z + 1)^3",
    "x^6 + y^6 + z^6 - 3x^2y^2z^2 + x y z - 0.5",
};
enum { EQUATIONS = sizeof equations / sizeof equations[0] };

/* From a distance of about 1, with directions of length about 2^length. */
static void random_ray(uint64_t *seed, int length) {
    for (int i = 0; i < 3; i++) {
        double target = random_unit(seed), d = random_unit(seed);
        c.ray.origin[i] = target - d;
        c.ray.direction[i] = ldexp(d, length);
    }
    c.ray.t_min = 0, c.ray.t_max = ldexp(2, -length);
}

/* What |t - exact| is promised to be within, for a ray that ends with the extent. */
static double promised(double t, double tolerance) {
    double x[3], value, gradient[3], size = 0;
    for (int i = 0; i < 3; i++) x[i] = fma(t, c.ray.direction[i], c.ray.origin[i]);
    assert_ok(algsurf_surface_gradient(c.surface, x, &value, gradient, NULL, NULL));
    for (int k = 0; k < c.count; k++)
        size +=
            fabs(c.terms[k].a * pow(x[0], c.terms[k].i) * pow(x[1], c.terms[k].j) * pow(x[2], c.terms[k].k));
    double slope = 0;
    for (int i = 0; i < 3; i++) slope += gradient[i] * c.ray.direction[i];
    double chord = tolerance > 0 ? c.ray.t_max - c.ray.t_min : 0;
    return tolerance + 0x1p-49 * chord + FEW * 0x1p-53 * size / fabs(slope) + 0x1p-52 * fabs(t);
}

enum { TOLERANCES = 6 };
static const double tolerances_down[TOLERANCES] = {1e-6, 1e-9, 1e-10, 1e-11, 1e-13, 0};

/* The first hit, by all methods that promise an error; the largest one at the largest tolerance. */
static double try_tolerances(const catalogue_entry *entry, double root) {
    double seen = 0;
    for (int k = 0; k < TOLERANCES; k++)
        for (int i = 0; i < 6; i++) {
            algsurf_intersect_options options = defaults;
            options.tier = i % 2, options.method = i / 2;
            options.max_iterations = 1000; /* so that the default is not the packets' own */
            options.absolute_tolerance = tolerances_down[k];
            intersect_ask(&c, &entry->extent, &options, &answer);
            double error = fabs(answer.first.t - root), most = promised(root, options.absolute_tolerance);
            if (k == 0) seen = fmax(seen, error);
            if (answer.first.state == ALGSURF_STATE_HIT && error <= most) continue;
            fprintf(stderr, "%s, tier %d, method %d, tolerance %g: at %a, exact %a, off by %g, promised %g\n",
                    entry->name, options.tier, options.method, options.absolute_tolerance, answer.first.t,
                    root, error, most);
            intersect_fail("not within the tolerance and rounding at the hit", &c, &answer);
        }
    return seen;
}

/* One pixel in 8 x 8 of a picture of 96 x 72, the one named among them: there rounding moves the root of the
 * polynomial along the chord by 2e-11, 2e-11 and 4e-10.  The largest tolerance is to be seen. */
TEST(test_tolerance_and_rounding) {
    static const struct {
        const char *name;
        int x, y;
    } hard[] = {{"boy", 44, 57}, {"labs", 48, 39}, {"barth-decic", 43, 33}};
    for (int i = 0; i < 3; i++) {
        const catalogue_entry *entry = catalogue_find(hard[i].name);
        double seen = 0;
        int hits = 0;
        intersect_equation(&c, entry->equation);
        algsurf_camera camera = pinhole_of(entry->eye, entry->look_at, entry->up, entry->fov);
        for (int pixel = 0; pixel < 9 * 12; pixel++) {
            double x = hard[i].x % 8 + pixel % 12 * 8 + 0.5, y = hard[i].y % 8 + pixel / 12 * 8 + 0.5;
            int meets;
            assert_ok(algsurf_camera_ray(&camera, 96, 72, x, y, &c.ray));
            assert_ok(algsurf_ray_clip(&c.ray, &entry->extent, NULL, 0, &c.ray, &meets));
            algsurf_hit known = first_hit_of(c.surface, &entry->extent, &c.ray, NULL);
            if (!meets || known.state != ALGSURF_STATE_HIT) continue;
            exact_sturm s = exact_sturm_along(c.terms, c.count, c.degree, &c.ray);
            double root = exact_root(&s, known.t_lo, known.t_hi, 0);
            seen = fmax(seen, try_tolerances(entry, root));
            exact_sturm_clear(&s);
            hits++;
        }
        if (hits < 20 || seen < 1e-8) fail_msg("%s: %d hits, off by %g", entry->name, hits, seen);
    }
}

TEST(test_methods_and_tolerances) {
    static const double tolerances[] = {0, 1e-12, 1e-7, 1e-3};
    uint64_t seed = SEED;
    int hits = 0, short_of = 0;
    for (int e = 0; e < EQUATIONS; e++) {
        intersect_equation(&c, equations[e]);
        for (int i = 0; i < 40; i++) {
            int length = i % 4 == 0 ? 40 : i % 4 == 1 ? -40 : 0;
            random_ray(&seed, length);
            exact_sturm s = exact_sturm_along(c.terms, c.count, c.degree, &c.ray);
            for (int m = ALGSURF_METHOD_DEFAULT; m <= ALGSURF_METHOD_REGULA_FALSI; m++)
                for (int k = 0; k < 4; k++) {
                    algsurf_intersect_options options = defaults;
                    options.method = m, options.absolute_tolerance = ldexp(tolerances[k], -length);
                    options.max_iterations = m == ALGSURF_METHOD_REGULA_FALSI ? 20000 : 0;
                    intersect_ask(&c, NULL, &options, &answer);
                    assert_null(intersect_agree(&answer));
                    for (int h = 0; h < answer.count; h++) {
                        const algsurf_hit *hit = answer.all + h;
                        if (hit->state != ALGSURF_STATE_HIT ||
                            exact_count_roots(&s, hit->t_lo, hit->t_hi) != 1)
                            continue;
                        double root = exact_root(&s, hit->t_lo, hit->t_hi, 0), error = fabs(hit->t - root);
                        /* Regula falsi ends when its steps are short. */
                        int within = error <= promised(root, options.absolute_tolerance);
                        if (m == ALGSURF_METHOD_REGULA_FALSI) {
                            short_of += error > 100 * options.absolute_tolerance + ldexp(1e-10, -length);
                        } else if (!within) {
                            fprintf(stderr, "method %d tolerance %g error %g\n", m,
                                    options.absolute_tolerance, error);
                            intersect_fail("not within the tolerance", &c, &answer);
                        }
                        hits++;
                    }
                }
            exact_sturm_clear(&s);
        }
    }
    if (hits < 2000 || short_of * 100 > hits) fail_msg("%d hits, regula falsi short of %d", hits, short_of);
}

/* A small limit of iterations: the state is as proved as ever, t is what there was. */
TEST(test_iteration_limit) {
    algsurf_intersect_options options = defaults;
    options.method = ALGSURF_METHOD_BISECTION, options.max_iterations = 3, options.absolute_tolerance = 1e-9;
    intersect_equation(&c, equations[0]);
    c.ray = (algsurf_ray){{0.1, 0.2, -3}, {0.05, 0, 1}, 0, 6};
    intersect_judge(&c, &options, &answer);
    assert_int_equal(answer.count, 2);
    algsurf_hit rough = answer.first;
    options.max_iterations = 0;
    intersect_judge(&c, &options, &answer);
    assert_true(fabs(rough.t - answer.first.t) > 1e-6 && fabs(rough.t - answer.first.t) < 1);
}

/* ---- what is refused ---- */

static void expect(algsurf_status wanted, const algsurf_surface *s, const algsurf_extent *extent,
                   const algsurf_ray *ray, const algsurf_intersect_options *options) {
    algsurf_hit hits[3], untouched[3];
    int occluded = 77;
    int count = 77;
    memset(hits, 0x5a, sizeof hits), memcpy(untouched, hits, sizeof hits);
    assert_int_equal(algsurf_intersect_first(s, extent, ray, options, hits), wanted);
    assert_int_equal(algsurf_intersect_all(s, extent, ray, options, hits + 1, 2, &count), wanted);
    assert_int_equal(algsurf_occluded(s, extent, ray, options, &occluded), wanted);
    if (wanted == ALGSURF_OK) return;
    assert_memory_equal(hits, untouched, sizeof hits);
    assert_true(count == 77 && (int)occluded == 77);
}

TEST(test_bad_input) {
    const algsurf_ray good = {{0, 0, -4}, {0, 0, 1}, 0, 9};
    const algsurf_extent sphere = {ALGSURF_EXTENT_SPHERE, {0, 0, 0}, {2, 0, 0}};
    algsurf_extent extent = sphere;
    algsurf_ray ray = good;
    algsurf_hit hit;
    int count;
    intersect_equation(&c, equations[0]);
    expect(ALGSURF_OK, c.surface, &sphere, &good, &defaults);
    expect(ALGSURF_E_ARGUMENT, NULL, NULL, &good, NULL);
    expect(ALGSURF_E_ARGUMENT, c.surface, NULL, NULL, NULL);
    ray.direction[2] = 0, expect(ALGSURF_E_ARGUMENT, c.surface, NULL, &ray, NULL);
    ray = good, ray.t_min = NAN, expect(ALGSURF_E_NOT_FINITE, c.surface, NULL, &ray, NULL);
    ray = good, ray.t_max = NAN, expect(ALGSURF_E_NOT_FINITE, c.surface, NULL, &ray, NULL);
    ray = good, ray.origin[1] = NAN, expect(ALGSURF_E_NOT_FINITE, c.surface, NULL, &ray, NULL);
    ray = good, ray.direction[1] = INFINITY, expect(ALGSURF_E_NOT_FINITE, c.surface, NULL, &ray, NULL);
    extent.size[0] = 0, expect(ALGSURF_E_ARGUMENT, c.surface, &extent, &good, NULL);
    extent.size[0] = -1, expect(ALGSURF_E_ARGUMENT, c.surface, &extent, &good, NULL);
    extent = sphere, extent.kind = 7, expect(ALGSURF_E_ARGUMENT, c.surface, &extent, &good, NULL);
    assert_int_equal(algsurf_intersect_first(c.surface, NULL, &good, NULL, NULL), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_intersect_all(c.surface, NULL, &good, NULL, NULL, 2, &count),
                     ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_intersect_all(c.surface, NULL, &good, NULL, &hit, 2, NULL), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_intersect_all(c.surface, NULL, &good, NULL, &hit, -1, &count),
                     ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_occluded(c.surface, NULL, &good, NULL, NULL), ALGSURF_E_ARGUMENT);
}

TEST(test_capacity) {
    const algsurf_ray ray = {{0, 0, -4}, {0, 0, 1}, 0, 9};
    algsurf_hit hits[2], untouched[2];
    int count = 77;
    memset(hits, 0x5a, sizeof hits), memcpy(untouched, hits, sizeof hits);
    intersect_equation(&c, equations[0]);
    assert_int_equal(algsurf_intersect_all(c.surface, NULL, &ray, NULL, hits, 0, &count), ALGSURF_E_CAPACITY);
    assert_int_equal(algsurf_intersect_all(c.surface, NULL, &ray, NULL, hits, 1, &count), ALGSURF_E_CAPACITY);
    assert_memory_equal(hits, untouched, sizeof hits);
    assert_int_equal(count, 77);
    assert_ok(algsurf_intersect_all(c.surface, NULL, &ray, NULL, hits, 2, &count));
    assert_int_equal(count, 2);
}

TEST(test_options) {
    const algsurf_ray ray = {{0.1, 0.2, -4}, {0, 0, 1}, 0, 9};
    const algsurf_extent *all = NULL;
    struct {
        algsurf_intersect_options known;
        char unknown[16];
    } newer = {defaults, {0}};
    algsurf_intersect_options o = defaults;
    intersect_equation(&c, equations[0]);
    newer.known.size = sizeof newer, expect(ALGSURF_OK, c.surface, all, &ray, &newer.known);
    newer.unknown[3] = 1, expect(ALGSURF_E_SIZE, c.surface, all, &ray, &newer.known);
    for (o.size = 0; o.size < sizeof o; o.size++) /* no release had a smaller one */
        expect(ALGSURF_E_SIZE, c.surface, all, &ray, &o);
    o = defaults, o.absolute_tolerance = NAN;
    expect(ALGSURF_E_NOT_FINITE, c.surface, all, &ray, &o);
    o.absolute_tolerance = -1, expect(ALGSURF_E_ARGUMENT, c.surface, all, &ray, &o);
    o.absolute_tolerance = INFINITY, expect(ALGSURF_E_NOT_FINITE, c.surface, all, &ray, &o);
    o = defaults, o.max_iterations = -1, expect(ALGSURF_E_ARGUMENT, c.surface, all, &ray, &o);
    o = defaults, o.tier = 2, expect(ALGSURF_E_ARGUMENT, c.surface, all, &ray, &o);
    o = defaults, o.method = 4, expect(ALGSURF_E_ARGUMENT, c.surface, all, &ray, &o);
}

/* ---- the environment ---- */

TEST(test_environment) {
    uint64_t seed = SEED;
    for (int e = 0; e < EQUATIONS; e++) {
        intersect_equation(&c, equations[e]);
        for (int i = 0; i < 24; i++) {
            intersect_answer other;
            algsurf_intersect_options options = defaults;
            options.tier = i / 4 % 2;
            options.method = i % 4;
            random_ray(&seed, i % 5 ? 0 : -300);
            if (i % 6 == 0) c.ray = (algsurf_ray){{0, i % 4, -2}, {0, 0, 1}, 0x1p-1060, 4};
            intersect_ask(&c, NULL, &options, &answer);
            for (int k = 1; k < ENVIRONMENTS; k++) {
                memset(&other, 0, sizeof other);
                environment_set(k);
                int s1 = algsurf_intersect_first(c.surface, NULL, &c.ray, &options, &other.first);
                int s2 = algsurf_intersect_all(c.surface, NULL, &c.ray, &options, other.all,
                                               ALGSURF_MAX_DEGREE + 1, &other.count);
                int s3 = algsurf_occluded(c.surface, NULL, &c.ray, &options, &other.occluded);
                assert_true(environment_unset(k));
                assert_true(s1 == ALGSURF_OK && s2 == ALGSURF_OK && s3 == ALGSURF_OK);
                if (memcmp(&answer, &other, sizeof answer) != 0) {
                    fprintf(stderr, "environment %d\n", k);
                    intersect_fail("another answer in another environment", &c, &answer);
                }
            }
        }
    }
}
