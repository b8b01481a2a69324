/* test_intersect_certified.c - rays that double cannot decide: all are, in the certified tier, judged by the
 * oracle for hits; and what a caller may want done with what the bounded tier leaves open.
 *
 * Two roots a hair apart: (Q(x,y))^2 -+ z^2 on rays in planes z = 2^-10 to 2^-85, where Q has a root.
 *
 * Breaks caught, each tried: the root of a split point or of an end not looked at, ends not moved outward, a
 * carry lost, the unit of an infinite end lost, a common factor not divided out, roots found before it
 * reported twice.
 */
#include "intersect_case.h"

#include "rays/exact_ray.h"

#define SEED 53u

static const algsurf_intersect_options bounded = {.size = sizeof bounded, .tier = ALGSURF_TIER_BOUNDED};
static intersect_case c;
static intersect_answer answer;

static void ray_in_plane(uint64_t *seed, int bits) {
    double eye = random_int(seed, 2) ? 4 : 0;
    for (int i = 0; i < 2; i++) c.ray.direction[i] = random_short(seed, bits);
    if (c.ray.direction[0] == 0) c.ray.direction[0] = 1;
    for (int i = 0; i < 2; i++) c.ray.origin[i] = random_short(seed, bits) - eye * c.ray.direction[i];
    c.ray.origin[2] = ldexp(1, -10 - random_int(seed, 76));
    c.ray.direction[2] = 0;
    c.ray.t_min = random_int(seed, 3) ? 0 : -1;
    c.ray.t_max = random_int(seed, 3) ? eye + 4 : random_int(seed, 2) ? 1e4 : INFINITY;
}

TEST(hairs_apart) {
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
    int undecided = 0, rays = 0;
    for (int e = 0; e < EQUATIONS; e++) {
        intersect_equation(&c, equations[e]);
        for (int i = 0; i < ROUNDS; i++, rays++) {
            ray_in_plane(&seed, i % 2 ? 20 : 52);
            intersect_judge(&c, &bounded, &answer);
            undecided += answer.first.state == ALGSURF_STATE_UNDECIDED;
            intersect_judge(&c, NULL, &answer);
        }
    }
    if (undecided * 5 < rays) fail_msg("seed %u: %d rays, %d undecided", SEED, rays, undecided);
}

/* What is exactly so: a touch at a number that is no double, at one that is, at an end, along the ray. */
TEST(exactly) {
    static const struct {
        const char *equation;
        algsurf_ray ray;
        int count, multiplicity; /* of the first */
    } cases[] = {
        {"(3x - 1)^2 - y^2", {{0, 0, 0}, {1, 0, 0}, 0, 1}, 1, 2},
        {"x^2 + y^2 - 1", {{-3, 1, 0}, {1, 0, 0}, 0, INFINITY}, 1, 2},
        {"x^2 + y^2 - 1", {{-3, 1, 0}, {1, 0, 0}, -INFINITY, 4}, 1, 2},
        {"(3x - 1)^2 (x - 2)", {{0, 0, 0}, {1, 0, 0}, 0, 4}, 2, 2},
        {"(3x - 1)^2 ((x - 2)^2 - y^2)", {{0, 0x1p-90, 0}, {1, 0, 0}, 0, 4}, 3, 2},
        {"(x - 1)^2 - y^2", {{0, 0x1p-90, 0}, {1, 0, 0}, 0, 1}, 1, 1},
        {"(x - 1)^2 - y^2", {{0, 0x1p-90, 0}, {1, 0, 0}, 1, 2}, 1, 1},
        {"(x - 1)^2 + y^2", {{0, 0, 0}, {1, 0, 0}, 0, 1}, 1, 2},
        {"(x - 1)^2 (x + y) (x - 3)", {{0, -0x1p-60, 0}, {1, 0, 0}, 0, 1}, 2, 1},
        {"(x - 1)^3 - y^3", {{0, 0x1p-60, 0}, {1, 0, 0}, 1, 2}, 1, 1},
        {"x^2 + y^2 - z^2", {{-0x1p-70, 0x1p-80, 0}, {1, 0, 0}, 0, INFINITY}, 0, 0},
        /* roots of very different size */
        {"(x - 1)(x - 2)(1 + 1e-40 x)", {{0, 0, 0}, {1, 0, 0}, 0, INFINITY}, 2, 1},
        {"(x - 1)(x - 2)(1 + 1e-40 x)", {{0, 0, 0}, {-1, 0, 0}, -INFINITY, 0}, 2, 1},
        {"(x - 1)(x - 2)(1 - 1e-200 x)", {{0, 0, 0}, {1, 0, 0}, 0, INFINITY}, 3, 1},
        {"(x - 1)(x - 2) + 1e-60 x^4", {{0, 0, 0}, {1, 0, 0}, 0, INFINITY}, 2, 1},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        intersect_equation(&c, cases[i].equation);
        c.ray = cases[i].ray;
        intersect_judge(&c, NULL, &answer);
        if (answer.count != cases[i].count || answer.first.multiplicity != cases[i].multiplicity)
            intersect_fail("exactly", &c, &answer);
    }
}

/* Roots that bisection of the whole interval cannot reach, each found once and in full: with others before,
 * behind, at the ends of what is set apart, and on the negative side. */
TEST(roots_of_all_sizes) {
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
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const algsurf_ray ray = {{0, 0, 0}, {1, 0, 0}, cases[i].lo, cases[i].hi};
        static const algsurf_i_region everywhere = {NULL, NULL, 0};
        algsurf_i_ray_root roots[6];
        int n = 0, side;
        intersect_equation(&c, cases[i].equation);
        assert_ok(algsurf_i_exact_roots(
            c.surface, &everywhere, &ray,
            &(algsurf_i_wanted){ALGSURF_WANT_ALL, .limit = ALGSURF_DEFAULT_MEMORY}, roots, &n, &side));
        int as_told = n == cases[i].count;
        for (int k = 0; as_told && k < n; k++)
            as_told = roots[k].multiplicity == 1 && roots[k].t == cases[i].root[k] &&
                      roots[k].t_lo <= cases[i].root[k] && cases[i].root[k] <= roots[k].t_hi;
        if (!as_told) {
            for (int k = 0; k < n; k++)
                fprintf(stderr, "x%d: %a in [%a, %a]\n", roots[k].multiplicity, roots[k].t, roots[k].t_lo,
                        roots[k].t_hi);
            fail_msg("%s on [%a, %a]: %d roots", cases[i].equation, cases[i].lo, cases[i].hi, n);
        }
    }
}

/* Surfaces with integer coefficients and rays of few bits: they often touch. */
TEST(random_rays) {
    uint64_t seed = SEED;
    int rays = 0, multiple = 0;
    for (int i = 0; i < 600; i++) {
        algsurf_term terms[8];
        int count = 3 + i % 6;
        for (int k = 0; k < count; k++) {
            int e[3] = {0, 0, 0};
            for (int total = random_int(&seed, 7); total > 0; total--) e[random_int(&seed, 3)]++;
            terms[k] = (algsurf_term){e[0], e[1], e[2], random_int(&seed, 9) - 4};
        }
        if (!intersect_terms(&c, terms, count) || c.degree < 1) {
            continue;
        }
        for (int k = 0; k < 4; k++) {
            int bits = k % 2 ? 3 : 1;
            ray_in_plane(&seed, bits);
            c.ray.direction[2] = random_short(&seed, bits), c.ray.origin[2] = random_short(&seed, bits);
            intersect_judge(&c, NULL, &answer);
            rays++;
            for (int h = 0; h < answer.count; h++) multiple += answer.all[h].multiplicity != 1;
        }
    }
    if (rays < 300 || multiple < 20) fail_msg("seed %u: %d rays, %d multiple roots", SEED, rays, multiple);
}

/* In the bounded tier; in the certified one nothing is left open, whatever is to become of it. */
TEST(what_becomes_of_undecided) {
    static const struct {
        int as;
        int state;
    } cases[] = {{ALGSURF_AS_UNDECIDED, ALGSURF_STATE_UNDECIDED},
                 {ALGSURF_AS_HIT, ALGSURF_STATE_HIT},
                 {ALGSURF_AS_MISS, ALGSURF_STATE_MISS}};
    intersect_equation(&c, "(3x - 1)^2 - y^2");
    c.ray = (algsurf_ray){{0, 0, 0}, {1, 0, 0}, 0, 4};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        algsurf_intersect_options o = {.size = sizeof o, .undecided_as = cases[i].as};
        intersect_judge(&c, &o, &answer);
        assert_true(answer.count == 1 && answer.first.multiplicity == 2);
        o.tier = ALGSURF_TIER_BOUNDED;
        intersect_ask(&c, NULL, &o, &answer);
        const char *wrong = intersect_wrong_packet(&c, NULL, &o, &answer);
        const algsurf_hit *h = &answer.first;
        if (h->state != cases[i].state || (int)answer.occluded != cases[i].state) wrong = "state";
        if (answer.count != (cases[i].state != ALGSURF_STATE_MISS)) wrong = "count";
        if (answer.count && (answer.all[0].state != cases[i].state || h->reason <= ALGSURF_OK)) wrong = "all";
        if (answer.count && !(h->t_lo <= 1.0 / 3 && 1.0 / 3 <= h->t_hi && h->multiplicity == 0)) wrong = "t";
        if (wrong) intersect_fail(wrong, &c, &answer);
    }
}

TEST(bad_options) {
    algsurf_intersect_options o = {.size = sizeof o, .tier = 2};
    algsurf_hit hit;
    intersect_equation(&c, "x - 1");
    c.ray = (algsurf_ray){{0, 0, 0}, {1, 0, 0}, 0, 4};
    assert_int_equal(algsurf_intersect_first(c.surface, NULL, &c.ray, &o, &hit), ALGSURF_E_ARGUMENT);
    o.tier = ALGSURF_TIER_CERTIFIED, o.undecided_as = 3;
    assert_int_equal(algsurf_intersect_first(c.surface, NULL, &c.ray, &o, &hit), ALGSURF_E_ARGUMENT);
}

/* Rays made to touch, at numbers of few digits: multiple roots that are decided, each once. */
TEST(touching_rays) {
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
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        intersect_equation(&c, rows[i].equation);
        c.ray = rows[i].ray;
        intersect_judge(&c, NULL, &answer);
        if (answer.count != rows[i].count) intersect_fail("number of hits", &c, &answer);
        for (int k = 0; k < answer.count; k++)
            if (answer.all[k].state != ALGSURF_STATE_HIT || answer.all[k].t != rows[i].t[k])
                intersect_fail("not decided", &c, &answer);
    }
}
