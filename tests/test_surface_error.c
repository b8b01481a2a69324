/* test_surface_error.c - surfaces whose coefficients have an error: what is certain of them must hold for
 * every surface they may stand for; and how well an equation's coefficients are rounded.
 *
 * Members are taken at random, each coefficient at one end of its range, at the other, or between.
 *
 * Breaks caught, each tried: the error left out of bounds of values, of expansions, of a picture's rows, of
 * packets; q_ijk in place of its magnitudes in a picture; exact arithmetic on coefficients that are not
 * exact; an error of computation not counted in the rounding.
 */
#include "intersect_case.h"

#include "algsurf/algsurf.h"

#define SEED 83u

enum { MEMBERS = 3, SIDE = 48, TUBE = 3 };

static intersect_case c, member;
static intersect_answer answer;

static const int tiers[] = {ALGSURF_TIER_BOUNDED, ALGSURF_TIER_CERTIFIED};

static const char *const equations[] = {"(x^2+y^2+z^2+3.51)^2 - 16(x^2+y^2)", "x^2 z + y^2",
                                        "x^4-5x^2+y^4-5y^2+z^4-5z^2+11.8", "(x-y)^2 + z^2 - 1/16",
                                        "(x+y+z)^6 - 20 x^3 y + 3"};

static double random_sign(uint64_t *seed) {
    return random_int(seed, 3) ? random_int(seed, 3) - 1 : random_unit(seed);
}

/* A surface that c.surface, with the error, stands for. */
static void make_member(uint64_t *seed, double error) {
    algsurf_term terms[INTERSECT_TERMS];
    for (int i = 0; i < c.count; i++) {
        terms[i] = c.terms[i];
        double most = 0.999999 * error * fabs(terms[i].a);
        terms[i].a += most * random_sign(seed);
        if (fabs(terms[i].a - c.terms[i].a) > error * fabs(c.terms[i].a))
            terms[i].a = c.terms[i].a; /* rounded */
    }
    assert_true(intersect_terms(&member, terms, c.count));
    member.ray = c.ray;
}

static algsurf_surface *with_error(double error) {
    algsurf_surface *s = surface_with_error(c.surface, error);
    return s;
}

static void random_ray(uint64_t *seed) {
    double distance = random_int(seed, 2) ? 6 : 0;
    for (int i = 0; i < 3; i++) c.ray.direction[i] = random_unit(seed);
    for (int i = 0; i < 3; i++) c.ray.origin[i] = 2 * random_unit(seed) - distance * c.ray.direction[i];
    c.ray.t_min = 0;
    c.ray.t_max = random_int(seed, 2) ? 8 : random_int(seed, 2) ? 8 : INFINITY;
}

/* Certain answers of the surface with an error, single rays and a packet of one, held against its members. */
static void judge(const algsurf_surface *s, uint64_t *seed, double error, int *certain) {
    const algsurf_ray *ray = &c.ray;
    static packet_case one;
    for (int t = 0; t < 2; t++) {
        const algsurf_intersect_options o = {.size = sizeof o, .tier = tiers[t]};
        packet_put(&one, 0, ray);
        assert_ok(packet_ask(&one, 0, 1, s, NULL, &o));
        for (int m = 0; m < MEMBERS; m++) {
            make_member(seed, error);
            algsurf_surface *own = member.surface;
            member.surface = (algsurf_surface *)(uintptr_t)s;
            intersect_ask(&member, NULL, &o, &answer);
            member.surface = own;
            exact_sturm chain = exact_sturm_along(member.terms, member.count, member.degree, ray);
            const char *wrong = intersect_truth(&member, &chain, &answer);
            int roots = exact_count_roots(&chain, ray->t_min, ray->t_max);
            if (!wrong && one.state[0] == ALGSURF_STATE_MISS && roots > 0) wrong = "packet misses";
            if (!wrong && one.state[0] == ALGSURF_STATE_HIT && roots == 0) wrong = "packet hits nothing";
            if (wrong) intersect_fail(wrong, &member, &answer);
            *certain += answer.first.state != ALGSURF_STATE_UNDECIDED;
            exact_sturm_clear(&chain);
        }
    }
}

TEST(rays) {
    static const double errors[] = {1e-2, 1e-5, 1e-14, 0x1p-53};
    uint64_t seed = SEED;
    int certain = 0, judged = 0;
    for (size_t e = 0; e < sizeof equations / sizeof *equations; e++) {
        intersect_equation(&c, equations[e]);
        for (size_t k = 0; k < sizeof errors / sizeof *errors; k++) {
            algsurf_surface *s = with_error(errors[k]);
            for (int i = 0; i < 20; i++, judged += 2 * MEMBERS) {
                random_ray(&seed);
                judge(s, &seed, errors[k], &certain);
            }
        }
    }
    if (certain * 2 < judged) fail_msg("seed %u: only %d of %d certain", SEED, certain, judged);
}

/* High powers along rays from afar: bounds about the ray's origin, and not the place, decide nothing.
 * Catches: places that are not looked at again, or from a point beside the ray; radii rounded down there. */
TEST(high_powers) {
    static const char *const high[] = {"10z^12 - 3", "x^10 + y^10 + z^10 - 0.7", "(x+y)^8 z^4 + x^9 - 0.3y"};
    static const double errors[] = {1e-3, 1e-9, 0x1p-53};
    uint64_t seed = SEED;
    int certain = 0, judged = 0;
    for (size_t e = 0; e < sizeof high / sizeof *high; e++) {
        intersect_equation(&c, high[e]);
        for (size_t k = 0; k < sizeof errors / sizeof *errors; k++) {
            algsurf_surface *s = with_error(errors[k]);
            for (int i = 0; i < 12; i++, judged += 2 * MEMBERS) {
                random_ray(&seed);
                judge(s, &seed, errors[k], &certain);
            }
        }
    }
    if (certain * 3 < judged * 2) fail_msg("seed %u: only %d of %d certain", SEED, certain, judged);
    const algsurf_extent ball = {ALGSURF_EXTENT_SPHERE, {0, 0, 0}, {3.95, 0, 0}};
    const algsurf_ray down = {{0, 0, 5}, {0, 0, -1}, 0, INFINITY};
    algsurf_hit hits[2];
    int count;
    intersect_equation(&c, "z^30 - 0.3");
    algsurf_surface *s = with_error(0x1p-53);
    assert_ok(algsurf_intersect_all(s, &ball, &down, NULL, hits, 2, &count));
    assert_int_equal(count, 2);
    for (int i = 0; i < count; i++) {
        double z = (i ? -1 : 1) * pow(0.3, 1.0 / 30), width = hits[i].t_hi - hits[i].t_lo;
        assert_true(hits[i].state == ALGSURF_STATE_HIT && width < 1e-14 && fabs(5 - hits[i].t - z) < 1e-14);
    }
}

/* Roots far out, and far beyond the largest double: all of them count on a ray without an end. */
TEST(far_roots) {
    static const double errors[] = {1e-2, 1e-5, 1e-9};
    uint64_t seed = SEED;
    int certain = 0, judged = 0;
    for (int i = 0; i < 300; i++) {
        algsurf_term terms[4];
        int n = 1 + random_int(&seed, 3);
        for (int k = 0; k <= n; k++)
            terms[k] = (algsurf_term){k, 0, 0, ldexp(random_unit(&seed), random_int(&seed, 2060) - 1040)};
        double error = errors[random_int(&seed, 3)];
        if (!intersect_terms(&c, terms, n + 1)) continue;
        algsurf_surface *s = with_error(error);
        double scale = ldexp(1, random_int(&seed, 3) ? 0 : random_int(&seed, 600) - 300);
        c.ray = (algsurf_ray){{random_unit(&seed), 0, 0}, {scale * random_unit(&seed), 0, 0}, 0, 0};
        c.ray.t_min = random_int(&seed, 3) ? -INFINITY : random_unit(&seed);
        c.ray.t_max = isinf(c.ray.t_min) && random_int(&seed, 2) ? random_unit(&seed) : INFINITY;
        judge(s, &seed, error, &certain);
        judged += 2 * MEMBERS;
    }
    if (certain * 4 < judged) fail_msg("seed %u: only %d of %d certain", SEED, certain, judged);
    const algsurf_term line[] = {{0, 0, 0, 1}, {1, 0, 0, 0x1p-1030}};
    const algsurf_ray along = {{0, 0, 0}, {1, 0, 0}, -INFINITY, INFINITY};
    assert_true(intersect_terms(&c, line, 2));
    algsurf_surface *s = with_error(0x1p-53);
    algsurf_hit hit = first_hit_of(s, NULL, &along, NULL);
    assert_true(hit.state == ALGSURF_STATE_HIT && hit.side == -1 && hit.t == -DBL_MAX && isinf(hit.t_lo));
}

TEST(values) {
    uint64_t seed = SEED;
    for (size_t e = 0; e < sizeof equations / sizeof *equations; e++) {
        intersect_equation(&c, equations[e]);
        algsurf_surface *s = with_error(1e-3);
        for (int i = 0; i < 50; i++) {
            double x[3], v, bound, g[3], g_bound[3], own, own_g[3];
            for (int k = 0; k < 3; k++) x[k] = 2 * random_unit(&seed);
            make_member(&seed, 1e-3);
            assert_ok(algsurf_surface_gradient(s, x, &v, g, &bound, g_bound));
            assert_ok(algsurf_surface_gradient(member.surface, x, &own, own_g, NULL, NULL));
            int within = fabs(own - v) <= bound;
            for (int k = 0; k < 3; k++) within &= fabs(own_g[k] - g[k]) <= g_bound[k];
            if (!within) fail_msg("seed %u, %s: %a at %a %a %a", SEED, equations[e], v, x[0], x[1], x[2]);
        }
    }
}

/* About (off, off, 0): away from the origin the terms are larger than what they add up to. */
static void draw(const algsurf_surface *s, double off, int tier, double *t, uint64_t *undecided) {
    const double eye[3] = {off + 3, off - 4, 2}, at[3] = {off + 0.05, off + 0.03, 0.02}, up[3] = {0, 0, 1};
    const algsurf_extent ball = {ALGSURF_EXTENT_SPHERE, {off, off, 0}, {2.5, 0, 0}};
    const algsurf_intersect_options how = {
        .size = sizeof how, .tier = tier, .undecided_as = ALGSURF_AS_UNDECIDED};
    const algsurf_render_options o = {.size = sizeof o, .width = SIDE, .height = SIDE};
    static uint8_t bytes[3 * SIDE * SIDE];
    const algsurf_picture planes = {.size = sizeof planes, .pixels = bytes, .t = t};
    algsurf_render_stats stats = {.size = sizeof stats};
    algsurf_camera camera = pinhole_of(eye, at, up, 50);
    algsurf_scene *scene = scene_of(s, NULL, NULL, NULL);
    assert_ok(algsurf_scene_set_extent(scene, &ball));
    assert_ok(algsurf_scene_set_camera(scene, &camera));
    assert_ok(algsurf_scene_set_quality(scene, ALGSURF_QUALITY_PREVIEW));
    assert_ok(algsurf_scene_set_intersect_options(scene, &how));
    assert_ok(algsurf_render(scene, &o, &planes, &stats));
    *undecided = (uint64_t)stats.undecided;
}

/* A picture's undecided pixels are counted, not marked: members may differ from it in no more than those. */
TEST(pictures) {
    static double t[SIDE * SIDE], own[SIDE * SIDE];
    uint64_t seed = SEED, undecided, none;
    for (size_t e = 0; e < sizeof equations / sizeof *equations; e++) {
        intersect_equation(&c, equations[e]);
        algsurf_surface *s = with_error(5e-4);
        double off = e == TUBE ? 12 : 0;
        draw(s, off, ALGSURF_TIER_BOUNDED, t, &undecided);
        for (int m = 0; m < 6; m++) {
            uint64_t different = 0;
            make_member(&seed, 5e-4);
            draw(member.surface, off, ALGSURF_TIER_CERTIFIED, own, &none);
            for (int i = 0; i < SIDE * SIDE; i++) different += isinf(t[i]) != isinf(own[i]);
            if (different > undecided || undecided > SIDE * SIDE / 2)
                fail_msg("seed %u, %s: %d pixels differ, %d are undecided", SEED, equations[e],
                         (int)different, (int)undecided);
        }
    }
}

static double rounding_of(const char *equation) {
    intersect_equation(&c, equation);
    double rounding = algsurf_surface_rounding(c.surface);
    return rounding;
}

TEST(rounding) {
    assert_true(rounding_of("x^2 + y^2 - 1.5 z^3 + 1/1024") == 0);
    assert_true(rounding_of("(x^2 + y^2 + 2^60 z^2)(x - 1)/3*3") < 0x1p-90);
    assert_true(rounding_of("(x^2 + y^2 + 2^60 z^2)(x - 1)^5 + sqrt(49/4)") == 0);
    assert_true(rounding_of("0x1p-1074 x") == 0);
    assert_true(rounding_of("0x1p130 x + 0x1p120 x = y") == 0); /* exponents that differ */
    assert_true(rounding_of("x + 0x1p600 x = y") > 0);
    assert_true(rounding_of("x + 0x1p800 x = y") > 0);
    double decimal = rounding_of("x^2 - 0.1"); /* 0.1 as a double: 0x1.999999999999ap-4 */
    assert_true(decimal > 0x1.9p-55 && decimal < 0x1.ap-54);
    double root = rounding_of("x^2 - sqrt(5) y"); /* off by 0.36 of half a unit */
    assert_true(root > 0x1p-56 && root <= 0x1.0001p-53);
    assert_true(rounding_of("x^2 - sqrt(2)^2 y") < 0x1p-90); /* 2 but for the error of computing it */
    assert_true(rounding_of("x^2 - sqrt(2)^2 y") > 0);
    assert_true(rounding_of("x^2 - (sqrt(1 + 1e-24) - 1) y") > 0x1p-60); /* cancels */
    assert_true(rounding_of("x - 0.1*1e-310") > 0x1p-50);
    assert_true(algsurf_surface_rounding(NULL) == 0);
}

TEST(a_surface_with_error_is_the_same) {
    algsurf_term given[40], kept[40];
    intersect_equation(&c, "x^2 - 0.1 y + z^3");
    algsurf_surface *s = with_error(algsurf_surface_rounding(c.surface)), *none = NULL;
    assert_int_equal(algsurf_surface_degree(s), 3);
    assert_int_equal(algsurf_surface_term_count(s), 3);
    assert_true(algsurf_surface_rounding(s) == algsurf_surface_rounding(c.surface));
    assert_ok(algsurf_surface_terms(c.surface, given));
    assert_ok(algsurf_surface_terms(s, kept));
    for (int i = 0; i < 3; i++)
        assert_true(given[i].i == kept[i].i && given[i].j == kept[i].j && given[i].k == kept[i].k &&
                    given[i].a == kept[i].a);
    assert_int_equal(algsurf_surface_with_error(NULL, 0, &none), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_surface_with_error(s, 0, NULL), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_surface_with_error(s, 1, &none), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_surface_with_error(s, -1e-9, &none), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_surface_with_error(s, NAN, &none), ALGSURF_E_NOT_FINITE);
    assert_null(none);
}

/* A point that is on the surface for some coefficients only. */
TEST(a_point) {
    const algsurf_intersect_options o = {.size = sizeof o, .tier = ALGSURF_TIER_CERTIFIED};
    intersect_equation(&c, "x - 1");
    algsurf_surface *s = with_error(0x1p-53);
    const algsurf_ray at_one = {{0, 0, 0}, {1, 0, 0}, 1, 1}, beside = {{0, 0, 0}, {1, 0, 0}, 1.5, 1.5};
    algsurf_hit hit = first_hit_of(s, NULL, &at_one, &o);
    assert_int_equal(hit.state, ALGSURF_STATE_UNDECIDED);
    assert_int_equal(hit.reason, ALGSURF_UNDECIDED_ZERO);
    assert_ok(algsurf_intersect_first(s, NULL, &beside, &o, &hit));
    assert_int_equal(hit.state, ALGSURF_STATE_MISS);
}
