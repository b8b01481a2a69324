/* test_intersect_certified.c - the certified tier on rays that double-double cannot decide, judged by a Sturm
 * chain over integers; and what a caller may want done with the rest.
 *
 * Two roots a hair apart: (Q(x,y))^2 -+ z^2 on rays in planes z = 2^-10 to 2^-85, where Q has a root.
 *
 * Breaks caught, each tried: a half cell passed over, a half scaled wrongly, a power of w without its
 * binomials, the factor k! (n-k)! wrong, the root of a split point or of an end not looked at, ends not moved
 * outward, a carry lost, a hit behind an open place forgotten, a place not set apart, roots found before it
 * kept twice, a root between two parts found twice, the unit of an infinite end lost, the simplest number in
 * an interval not looked at, a root there found twice.  Not caught: overlapping entries decided apart.
 */
#include "intersect_case.h"

#include "rays/exact.h"

#define SEED 53u

static const algsurf_intersect_options certified = {.size = sizeof certified, .tier = ALGSURF_TIER_CERTIFIED};
static intersect_case c;
static intersect_answer answer;

static double short_number(uint64_t *seed, int bits) {
    return ldexp(floor(ldexp(exact_random_unit(seed), bits)), -bits);
}

static void ray_in_plane(uint64_t *seed, int bits) {
    double eye = exact_random_int(seed, 2) ? 4 : 0;
    for (int i = 0; i < 2; i++) c.ray.direction[i] = short_number(seed, bits);
    if (c.ray.direction[0] == 0) c.ray.direction[0] = 1;
    for (int i = 0; i < 2; i++) c.ray.origin[i] = short_number(seed, bits) - eye * c.ray.direction[i];
    c.ray.origin[2] = ldexp(1, -10 - exact_random_int(seed, 76));
    c.ray.direction[2] = 0;
    c.ray.t_min = exact_random_int(seed, 3) ? 0 : -1;
    c.ray.t_max = exact_random_int(seed, 3) ? eye + 4 : exact_random_int(seed, 2) ? 1e4 : INFINITY;
}

static void hairs_apart(void **state) {
    static const char *const equations[] = {"(x^2 + y^2 - 2)^2 - z^2",
                                            "(x^2 + y^2 - 2)^2 + z^2",
                                            "(x^3 - y + x y^2)^2 - z^2",
                                            "(x^3 - y + x y^2)^2 + z^2",
                                            "(x y - 1/4)^3 - z^3",
                                            "((x^2 + 2y^2 - 3)^2 + z^2) (x - y + 5)",
                                            "(x^2 + y^2 - 2)^2 (x - 3) - z^2",
                                            "(x^5 + y^5 - x + 1/8)^2 - z^2"};
    enum { EQUATIONS = sizeof equations / sizeof *equations, ROUNDS = 40 };
    uint64_t seed = SEED;
    int doubtful = 0, open = 0, rays = 0;
    (void)state;
    for (int e = 0; e < EQUATIONS; e++) {
        intersect_equation(&c, equations[e]);
        for (int i = 0; i < ROUNDS; i++, rays++) {
            ray_in_plane(&seed, i % 2 ? 20 : 52);
            intersect_judge(&c, NULL, &answer);
            doubtful += answer.first.state == ALGSURF_UNCERTAIN;
            intersect_judge(&c, &certified, &answer);
            open += answer.first.state == ALGSURF_UNCERTAIN;
            for (int k = 0; k < answer.count; k++)
                if (answer.all[k].state == ALGSURF_UNCERTAIN) intersect_fail("undecided", &c, &answer);
        }
        algsurf_surface_free(c.surface);
    }
    if (open > 0 || doubtful * 5 < rays)
        fail_msg("seed %u: %d rays, %d doubtful, %d left open", SEED, rays, doubtful, open);
}

/* What is exactly so: a touch at a number that is no double, at one that is, at an end, along the ray. */
static void exactly(void **state) {
    static const struct {
        const char *equation;
        algsurf_ray ray;
        int first, count, hits;
    } cases[] = {
        {"(3x - 1)^2 - y^2", {{0, 0, 0}, {1, 0, 0}, 0, 1}, ALGSURF_UNCERTAIN, 1, 0},
        {"x^2 + y^2 - 1", {{-3, 1, 0}, {1, 0, 0}, 0, INFINITY}, ALGSURF_HIT, 1, 1},
        {"x^2 + y^2 - 1", {{-3, 1, 0}, {1, 0, 0}, -INFINITY, 4}, ALGSURF_HIT, 1, 1},
        {"(3x - 1)^2 (x - 2)", {{0, 0, 0}, {1, 0, 0}, 0, 4}, ALGSURF_UNCERTAIN, 2, 1},
        {"(3x - 1)^2 ((x - 2)^2 - y^2)", {{0, 0x1p-90, 0}, {1, 0, 0}, 0, 4}, ALGSURF_UNCERTAIN, 3, 2},
        {"(x - 1)^2 - y^2", {{0, 0x1p-90, 0}, {1, 0, 0}, 0, 1}, ALGSURF_HIT, 1, 1},
        {"(x - 1)^2 - y^2", {{0, 0x1p-90, 0}, {1, 0, 0}, 1, 2}, ALGSURF_HIT, 1, 1},
        {"(x - 1)^2 + y^2", {{0, 0, 0}, {1, 0, 0}, 0, 1}, ALGSURF_HIT, 1, 1},
        {"(x - 1)^2 (x + y) (x - 3)", {{0, -0x1p-60, 0}, {1, 0, 0}, 0, 1}, ALGSURF_HIT, 2, 2},
        {"(x - 1)^3 - y^3", {{0, 0x1p-60, 0}, {1, 0, 0}, 1, 2}, ALGSURF_HIT, 1, 1},
        {"x^2 + y^2 - z^2", {{-0x1p-70, 0x1p-80, 0}, {1, 0, 0}, 0, INFINITY}, ALGSURF_MISS, 0, 0},
        /* roots of very different size */
        {"(x - 1)(x - 2)(1 + 1e-40 x)", {{0, 0, 0}, {1, 0, 0}, 0, INFINITY}, ALGSURF_HIT, 2, 2},
        {"(x - 1)(x - 2)(1 + 1e-40 x)", {{0, 0, 0}, {-1, 0, 0}, -INFINITY, 0}, ALGSURF_HIT, 2, 2},
        {"(x - 1)(x - 2)(1 - 1e-200 x)", {{0, 0, 0}, {1, 0, 0}, 0, INFINITY}, ALGSURF_HIT, 3, 3},
        {"(x - 1)(x - 2) + 1e-60 x^4", {{0, 0, 0}, {1, 0, 0}, 0, INFINITY}, ALGSURF_HIT, 2, 2},
    };
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        intersect_equation(&c, cases[i].equation);
        c.ray = cases[i].ray;
        intersect_judge(&c, &certified, &answer);
        int hits = 0;
        for (int k = 0; k < answer.count; k++) hits += answer.all[k].state == ALGSURF_HIT;
        if (answer.first.state != cases[i].first || answer.count != cases[i].count || hits != cases[i].hits)
            intersect_fail("exactly", &c, &answer);
        algsurf_surface_free(c.surface);
    }
}

/* Roots that bisection of the whole interval cannot reach, each found once and in full: with others before,
 * behind, at the ends of what is set apart, and on the negative side. */
static void roots_of_all_sizes(void **state) {
    static const double inf = INFINITY;
    static const struct {
        const char *equation;
        double lo, hi;
        int count;
        double root[5];
    } cases[] = {
        {"(x - 3)(x - 0x1p70)", 0, inf, 2, {3, 0x1p70}},
        {"(x - 3)(x - 0x1p70)(x - 0x1p200)", 1, inf, 3, {3, 0x1p70, 0x1p200}},
        {"(x + 3)(x + 0x1p70)(x + 0x1p200)", -inf, 0, 3, {-0x1p200, -0x1p70, -3}},
        {"(x + 3)(x + 0x1p70)(x - 0x1p200)", -inf, 4, 2, {-0x1p70, -3}},
        {"x (x - 0x1p-80) (3x - 0x1p-70) (x - 5)", 0, 16, 4, {0, 0x1p-80, 0x1p-70 / 3, 5}},
        {"x (x - 0x1p-80) (x - 0x1p-79) (x - 5)", 0, inf, 4, {0, 0x1p-80, 0x1p-79, 5}},
        {"(3x - 1)(x - 0x1p90)", 0, 0x1p90, 2, {1.0 / 3, 0x1p90}},
    };
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const algsurf_ray ray = {{0, 0, 0}, {1, 0, 0}, cases[i].lo, cases[i].hi};
        algsurf_i_exact_root roots[6];
        intersect_equation(&c, cases[i].equation);
        int n =
            algsurf_i_exact_roots(c.surface, &ray, NULL, cases[i].lo, cases[i].hi, ALGSURF_WANT_ALL, roots);
        int as_told = n == cases[i].count;
        for (int k = 0; as_told && k < n; k++) {
            double size = 0x1p-49 * fabs(cases[i].root[k]);
            as_told = roots[k].state == ALGSURF_HIT && fabs(roots[k].t.hi - cases[i].root[k]) <= size &&
                      roots[k].lo - size <= cases[i].root[k] && cases[i].root[k] <= roots[k].hi + size;
        }
        if (!as_told) {
            for (int k = 0; k < n; k++)
                fprintf(stderr, "%d: %a in [%a, %a]\n", roots[k].state, roots[k].t.hi, roots[k].lo,
                        roots[k].hi);
            fail_msg("%s on [%a, %a]: %d roots", cases[i].equation, cases[i].lo, cases[i].hi, n);
        }
        algsurf_surface_free(c.surface);
    }
}

/* The third root is where a place that is set apart ends: 2^-60 of the interval, rounded outward. */
static void a_root_between_parts(void **state) {
    const double end = nextafter(nextafter(0x1p30 + 32, INFINITY), INFINITY);
    const algsurf_ray ray = {{0, -end, 0}, {1, 1, 0}, 0, 0x1p90};
    algsurf_i_exact_root roots[4];
    (void)state;
    intersect_equation(&c, "(x - 1)(x - 3) y");
    int n = algsurf_i_exact_roots(c.surface, &ray, NULL, 0, 0x1p90, ALGSURF_WANT_ALL, roots);
    assert_int_equal(n, 3);
    assert_true(roots[2].lo <= end && end <= roots[2].hi);
    algsurf_surface_free(c.surface);
}

/* Surfaces with integer coefficients and rays of few bits: they often touch. */
static void random_rays(void **state) {
    uint64_t seed = SEED;
    int rays = 0, open = 0;
    (void)state;
    for (int i = 0; i < 150; i++) {
        algsurf_term terms[8];
        for (int k = 0; k < 8; k++) {
            int e[3] = {0, 0, 0};
            for (int total = exact_random_int(&seed, 7); total > 0; total--) e[exact_random_int(&seed, 3)]++;
            terms[k] = (algsurf_term){e[0], e[1], e[2], exact_random_int(&seed, 9) - 4};
        }
        if (!intersect_terms(&c, terms, 8) || c.degree < 1) {
            algsurf_surface_free(c.surface);
            continue;
        }
        for (int k = 0; k < 4; k++) {
            ray_in_plane(&seed, 3);
            c.ray.direction[2] = short_number(&seed, 3), c.ray.origin[2] = short_number(&seed, 3);
            exact_sturm s = exact_sturm_along(c.terms, c.count, c.degree, &c.ray);
            int zero = s.count == 0;
            exact_sturm_clear(&s);
            if (zero) continue;
            intersect_judge(&c, &certified, &answer);
            rays++, open += answer.first.state == ALGSURF_UNCERTAIN;
        }
        algsurf_surface_free(c.surface);
    }
    if (rays < 300 || open * 20 > rays) fail_msg("seed %u: %d rays, %d open", SEED, rays, open);
}

static void what_becomes_of_doubt(void **state) {
    static const struct {
        const char *equation;
        algsurf_doubt doubt;
        int first, count;
        double t;
    } cases[] = {
        {"(3x - 1)^2 - y^2", ALGSURF_DOUBT_REPORT, ALGSURF_UNCERTAIN, 1, 1 / 3.0},
        {"(3x - 1)^2 - y^2", ALGSURF_DOUBT_HIT, ALGSURF_HIT, 1, 1 / 3.0},
        {"(3x - 1)^2 - y^2", ALGSURF_DOUBT_MISS, ALGSURF_MISS, 0, INFINITY},
        {"(3x - 1)^2 (x - 2)", ALGSURF_DOUBT_MISS, ALGSURF_HIT, 1, 2},
        {"(3x - 1)^2 (x - 2)", ALGSURF_DOUBT_HIT, ALGSURF_HIT, 2, 1 / 3.0},
    };
    static const algsurf_tier tiers[] = {ALGSURF_TIER_STANDARD, ALGSURF_TIER_CERTIFIED};
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases * 2; i++) {
        const algsurf_intersect_options o = {
            .size = sizeof o, .tier = tiers[i % 2], .doubt = cases[i / 2].doubt};
        unsigned char one = 99, occluded = 99;
        double t = 99;
        intersect_equation(&c, cases[i / 2].equation);
        c.ray = (algsurf_ray){{0, 0, 0}, {1, 0, 0}, 0, 4};
        intersect_ask(&c, NULL, &o, &answer);
        const algsurf_ray_packet ray = {
            .size = sizeof ray,
            .count = 1,
            .t_max = &c.ray.t_max,
            .origin = {c.ray.origin, c.ray.origin + 1, c.ray.origin + 2},
            .direction = {c.ray.direction, c.ray.direction + 1, c.ray.direction + 2}};
        const algsurf_hit_packet to = {.size = sizeof to, .state = &one, .t = &t};
        assert_int_equal(algsurf_intersect_packet(c.surface, NULL, &ray, &o, &to), ALGSURF_OK);
        assert_int_equal(algsurf_occluded_packet(c.surface, NULL, &ray, &o, &occluded), ALGSURF_OK);
        int whether = cases[i / 2].count == 2 || cases[i / 2].first != ALGSURF_UNCERTAIN
                          ? cases[i / 2].count > 0 ? ALGSURF_HIT : ALGSURF_MISS
                          : ALGSURF_UNCERTAIN;
        if (answer.first.state != cases[i / 2].first || answer.count != cases[i / 2].count ||
            (int)answer.occluded != whether || one != answer.first.state || occluded != answer.occluded ||
            !(answer.first.t == cases[i / 2].t || fabs(answer.first.t - cases[i / 2].t) < 1e-12))
            intersect_fail("doubt", &c, &answer);
        algsurf_surface_free(c.surface);
    }
}

static void bad_options(void **state) {
    algsurf_intersect_options o = {.size = sizeof o, .tier = (algsurf_tier)3};
    algsurf_hit hit;
    (void)state;
    intersect_equation(&c, "x - 1");
    c.ray = (algsurf_ray){{0, 0, 0}, {1, 0, 0}, 0, 4};
    assert_int_equal(algsurf_intersect_first(c.surface, NULL, &c.ray, &o, &hit), ALGSURF_E_ARGUMENT);
    o.tier = ALGSURF_TIER_CERTIFIED, o.doubt = (algsurf_doubt)3;
    assert_int_equal(algsurf_intersect_first(c.surface, NULL, &c.ray, &o, &hit), ALGSURF_E_ARGUMENT);
    algsurf_surface_free(c.surface);
}

/* Rays made to touch, at numbers of few digits: multiple roots that are decided, each once. */
static void touching_rays(void **state) {
    static const struct {
        const char *equation;
        algsurf_ray ray;
        int count;
        double t[3];
    } rows[] = {
        {"x^2 + y^2 + z^2 - 1", {{-4, 1, 0}, {1, 0, 0}, 0, INFINITY}, 1, {4}},
        {"x^2 + y^2 + z^2 - 1", {{-4, 1, 0}, {-1, 0, 0}, -INFINITY, 0}, 1, {-4}},
        {"x^2 + y^2 + z^2 - 1", {{0, 0, -1}, {0.75, 0, 0}, -1, 1}, 1, {0}},
        {"x^2 + y^2 + z^2 - 1", {{-3.8125, 0, 1}, {2, 0, 0}, 0, 9}, 1, {1.90625}},
        {"(x - 1)^2 (x - 2)", {{0, 5, 0}, {1, 1, 0}, 0, INFINITY}, 2, {1, 2}},
        {"(x - 1)^3 (x - 1.0009765625)^2 (x + 3)", {{0, 5, 0}, {1, 1, 0}, -7, 7}, 3, {-3, 1, 1.0009765625}},
        {"(x^2 + y^2 - 2)^2 - z^2", {{-3, 1, 0}, {1, 0, 0}, 0, INFINITY}, 2, {2, 4}},
    };
    (void)state;
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        intersect_equation(&c, rows[i].equation);
        c.ray = rows[i].ray;
        intersect_judge(&c, &certified, &answer);
        if (answer.count != rows[i].count) intersect_fail("number of hits", &c, &answer);
        for (int k = 0; k < answer.count; k++)
            if (answer.all[k].state != ALGSURF_HIT || answer.all[k].t != rows[i].t[k])
                intersect_fail("not decided", &c, &answer);
        algsurf_surface_free(c.surface);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(hairs_apart),        cmocka_unit_test(exactly),
        cmocka_unit_test(roots_of_all_sizes), cmocka_unit_test(a_root_between_parts),
        cmocka_unit_test(random_rays),        cmocka_unit_test(what_becomes_of_doubt),
        cmocka_unit_test(touching_rays),      cmocka_unit_test(bad_options)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
