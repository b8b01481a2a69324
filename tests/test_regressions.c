/* test_regressions.c - one case for each defect that was found and mended in isolate, expand, intersect.
 *
 * Each once gave a wrong or a needlessly undecided answer; what was wrong is said above it. */
#include "isolate_case.h"
#include "intersect_case.h"
#include "algsurf/expand.h"
#include "environments.h"

static isolate_answer answer;
static intersect_case c;
static intersect_answer hits;

/* Of polynomials: isolated and judged, without a reason to be undecided. */
TEST(polynomials) {
    const double inf = INFINITY, most = DBL_MAX;
    const struct {
        int degree;
        double c[17], lo, hi;
    } cases[] = {
        /* a root was lost when there were more entries than the degree */
        {3,
         {0x1.90e2a2d88acf1p+97, 0x1.436b07756fbffp+293, 0x1.5535f08e37ea1p-227, -0x1.54179f651fcf7p-283},
         -inf,
         inf},
        /* stretches between groups of roots stayed undecided; of coefficients between 2^-10 and 2^10 */
        {5, {1, 0, 0, 0, -0x1p300, 0x1p-300}, -inf, inf},
        {16,
         {0x1.8699ddff70eaep-9, -0x1.0aa588a8f941ep+9, 0x1.1926a5c0c9d89p-10, -0x1.536b012bf476cp+5,
          0x1.c9a4a1041ff32p+0, 0x1.9bc53dd3e1e3ep+0, 0x1.11d09464557e5p+2, -0x1.4d491cef191acp-2,
          0x1.f9d5254a73d7ep+7, 0x1.9d53d1c86fb7dp-6, -0x1.4cbe606301a84p+0, -0x1.b0eebd1443416p+3,
          0x1.b14e616ac45p+2, -0x1.61c5e1f0e985ep-9, 0x1.dec11c82ab7efp-2, -0x1.0032fdad83ba9p-10,
          -0x1.2d788d120c85fp+9},
         -inf,
         inf},
        /* signs were evaluated unscaled */
        {2, {-most, most, most}, -inf, inf},
        {2, {0x1p-1074, 0, -0x1p-1060}, -1, 1},
        {2, {-0x1p-1000, 0, 1}, -0x1p-500, 0x1p-500},
        {2, {0, 0x1p300, 0x1p-600}, -inf, inf},
        /* the far end of an interval overflowed */
        {1, {1, -2}, -1e300, -1e200},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        isolate_judge(cases[i].c, cases[i].degree, cases[i].lo, cases[i].hi, &answer);
        assert_ok(answer.status);
    }
}
/* A root was lost when there were more entries than the degree. */
TEST(lost_root_with_radii) {
    const double p[] = {-1, 1, 0}, r[] = {0, 0, 0x1p-30};
    algsurf_bracket b[3];
    int n = 0;
    assert_true(algsurf_isolate_all(p, r, 2, -INFINITY, INFINITY, NULL, b, 3, &n) > 0);
    assert_true(b[n - 1].hi ==
                INFINITY); /* x - 1 + 2^-30 x^2 / 2 has a root at -2^31; -2^-30 x^2 / 2 one at +2^31 */
}
/* Arguments were checked before flush-to-zero was switched off. */
TEST(daz_isolate) {
    const double p[] = {0x1p-1074, 0, -0x1p-1060};
    int n = 0;
    environment_set(4);
    algsurf_status s = algsurf_count_roots(p, NULL, 2, -1, 1, &n);
    environment_set(0);
    assert_true(s >= 0);
}
TEST(daz_intersect) {
    intersect_equation(&c, "x^2 + y^2 + z^2 - 1");
    c.ray = (algsurf_ray){{0, 0, -2}, {0, 0, 0x1p-1030}, 0, INFINITY};
    double p[3];
    environment_set(4);
    algsurf_status s = algsurf_intersect_first(c.surface, NULL, &c.ray, NULL, &hits.first);
    algsurf_status e = algsurf_expand_power(c.surface, &c.ray, p, NULL);
    environment_set(0);
    assert_true(s == ALGSURF_OK && e == ALGSURF_OK);
}
/* Brackets had infinite ends. */
TEST(infinite_bracket) {
    const double p[] = {3, -4, 1};
    isolate_judge(p, 2, -INFINITY, INFINITY, &answer);
    for (int i = 0; i < answer.count; i++) assert_true(isfinite(answer.b[i].lo) && isfinite(answer.b[i].hi));
}
/* The most roots an entry could hold, once told in place of the multiplicity, came out below it. */
TEST(multiplicities) {
    const double p[] = {0, 0, -1, 1}, q[] = {-12, 4, 12, -4, -3, 1};
    isolate_judge(p, 3, -2, 2, &answer);
    assert_true(answer.b[0].multiplicity == 2 && answer.b[0].lo == 0 && answer.b[0].hi == 0);
    isolate_judge(q, 5, 0, 4, &answer); /* (x^2 - 2)^2 (x - 3) */
    assert_true(answer.b[0].multiplicity == 2 && answer.b[1].multiplicity == 1);
}
/* A later bracket was swallowed by an undecided first one. */
TEST(first_swallows) {
    const double q[] = {-12, 4, 12, -4, -3, 1};
    isolate_judge(q, 5, 0, 4, &answer);
    assert_true(answer.count == 2 && answer.first.hi == answer.b[0].hi);
}
/* A direction that underflows in natural units became 0 without a radius. */
TEST(expand_underflow) {
    double p[3], r[3];
    mpq_t q;
    mpq_init(q);
    intersect_equation(&c, "x^2 + 1e100 y - 1e200");
    c.ray = (algsurf_ray){{0, 0, 0}, {1, 1e-250, 0}, 0, 1};
    assert_ok(algsurf_expand_power(c.surface, &c.ray, p, r));
    exact_line line = exact_line_of(c.terms, c.count, c.degree, &c.ray);
    for (int k = 0; k < 3; k++) exact_line_coefficient(q, &line, k), assert_true(exact_within(p[k], q, r[k]));
    exact_line_clear(&line), mpq_clear(q);
}
/* The tolerance was taken for the wrong unit far out. */
TEST(tolerance) {
    algsurf_intersect_options o = {
        .size = sizeof o, .method = ALGSURF_METHOD_BISECTION, .absolute_tolerance = 1e-3};
    intersect_equation(&c, "x z - 10 + y");
    c.ray = (algsurf_ray){{0, 0, 0}, {1, 0, 1e-8}, 0, INFINITY};
    for (int m = 0; m < 3; m++) {
        o.method = m;
        intersect_ask(&c, NULL, &o, &hits);
        if (!(fabs(hits.first.t - 31622.776601683792) < 2e-3)) fail_msg("method %d: t = %g", m, hits.first.t);
    }
}
static void drop(const char *equation, algsurf_ray ray, int count) {
    intersect_equation(&c, equation);
    c.ray = ray;
    intersect_judge(&c, NULL, &hits);
    if (hits.count != count || (count && hits.all[count - 1].state != ALGSURF_STATE_HIT))
        intersect_fail("degree drop", &c, &hits);
}
/* A vanishing leading coefficient left infinite rays undecided. */
TEST(degree_drop) {
    drop("x^2 + y^2 - 1", (algsurf_ray){{0, 0, -2}, {0, 0, 1}, 0, INFINITY}, 0);
    drop("x^2 z + y^2", (algsurf_ray){{0, 1, 1}, {1, 0, 0}, 0, INFINITY}, 0);
    drop("x^2 z + y^2", (algsurf_ray){{-2, 1, -1}, {1, 0, 0}, 0, INFINITY}, 2);
    drop("x^2 z + y^2", (algsurf_ray){{1, 1, -2}, {0, 0, 1}, 0, INFINITY}, 1);
    drop("x^2y^2 + x^2z^2 + y^2z^2 + x y z", (algsurf_ray){{0.125, 0.125, -2}, {0, 0, 1}, 0, INFINITY}, 2);
    drop("x^3 + y^3 + z^3 - 1", (algsurf_ray){{1, 0, 0}, {1, -1, 0}, -INFINITY, INFINITY}, 2);
}
/* A ray of no length was undecided where the exact sign overflows. */
TEST(single_point) {
    intersect_equation(&c, "x^64 + y^64 + z^64 - 1");
    c.ray = (algsurf_ray){{0.3, 0.7, -1.5}, {0.1, 0.2, 1}, 0, 0};
    intersect_ask(&c, NULL, NULL, &hits);
    assert_int_equal(hits.first.state, ALGSURF_STATE_MISS);
    intersect_equation(&c, "(x + y + z - 1)^20");
    c.ray = (algsurf_ray){{0.3, 0.7, 0.5}, {0.1, 0.2, 1}, 0, 0};
    intersect_ask(&c, NULL, NULL, &hits);
    assert_int_equal(hits.first.state, ALGSURF_STATE_MISS);
}
/* A hit beyond the range of double had t = inf. */
TEST(t_infinite) {
    intersect_equation(&c, "x^2 + y^2 + z^2 - 1");
    c.ray = (algsurf_ray){{0, 0, -2}, {0, 0, 1e-320}, -INFINITY, INFINITY};
    intersect_ask(&c, NULL, NULL, &hits);
    assert_true(hits.first.state != ALGSURF_STATE_HIT || isfinite(hits.first.t));
}
/* A ray in the surface was a hit at either end, with nothing in between, where the degree dropped to 1. */
TEST(zeros_at_both_ends) {
    intersect_equation(&c, "(x - 2 y)^2");
    c.ray = (algsurf_ray){{2, 1, 1.75}, {2, 1, 3}, 0, 20};
    intersect_judge(&c, NULL, &hits);
    assert_true(hits.count == 1 && hits.first.t == 0 && hits.first.multiplicity == 0);
}
/* Sums of the ends of a chord overflowed, and t was far from its root. */
TEST(near_the_largest_double) {
    const algsurf_extent box = {ALGSURF_EXTENT_BOX, {0, 0, 0}, {0x1p1022, 0x1p1022, 0x1p1022}};
    const algsurf_intersect_options certified = {.size = sizeof certified, .tier = ALGSURF_TIER_CERTIFIED};
    intersect_equation(&c, "x - 1/4");
    c.ray = (algsurf_ray){{-0x1.8p1022, 0, 0}, {1, 0, 0}, 0, INFINITY};
    intersect_ask(&c, &box, &certified, &hits);
    assert_int_equal(hits.first.state, ALGSURF_STATE_HIT);
    assert_true(fabs(hits.first.t / 0x1.8p1022 - 1) < 1e-15 && hits.count == 1);
    assert_true(hits.first.t_hi - hits.first.t_lo < 0x1p975);
}
/* Another root just behind the end of the chord was told as the first, 20 units after it. */
TEST(first_root_taken_for_the_end) {
    const algsurf_extent box = {
        ALGSURF_EXTENT_BOX, {0, 0, 0}, {0x1.54ef15d3fa91cp+5, 0x1.b51c9b0d5fee6p+5, 0x1.6e5145f5cdd56p+5}};
    intersect_equation(&c, "(14 x^2 - 101 x + 171) (x^2 + y^2 + z^2 + 1)");
    c.ray = (algsurf_ray){{-0x1.ap+0, 0x1.fe4bc62bdf7fp+0, -0x1.fb94cbea3c378p+1},
                          {0x1.73b36a77344e6p-4, 0x1.8f5b0674e3fa2p-1, 0x1.a4fa130c48b78p-2},
                          0,
                          INFINITY};
    intersect_ask(&c, &box, NULL, &hits);
    assert_int_equal(hits.first.state, ALGSURF_STATE_HIT);
    assert_true(fabs(hits.first.t - 47.817255749408247) < 1e-12);
}
/* With an error of coefficients an endless ray's answer hung on its neighbour in the packet. */
TEST(neighbour_of_an_endless_ray) {
    const algsurf_surface *s = surface_with_error(surface_of("x^8 - y^8"), 1e-6);
    const double o[3][2] = {{2, 2}, {1.5, 1.5}, {-2, -2}};
    const double d[3][2] = {{-0x1.3bf5ee51d1f7dp-1, -0x1.475f76c61ca41p-1},
                            {-0x1.1532029273269p-1, -0x1.0a5bc25e3a45p-1},
                            {0x1.245cb22083fa2p-1, 0x1.21de85333915ep-1}};
    const algsurf_ray second = {{2, 1.5, -2}, {d[0][1], d[1][1], d[2][1]}, 0, INFINITY};
    double t[2], lo[2];
    unsigned char state[2];
    const algsurf_ray_packet rays = {
        .size = sizeof rays, .count = 2, .origin = {o[0], o[1], o[2]}, .direction = {d[0], d[1], d[2]}};
    const algsurf_hit_packet to = {.size = sizeof to, .state = state, .t = t, .t_lo = lo};
    assert_ok(algsurf_intersect_packet(s, NULL, &rays, NULL, &to));
    const algsurf_hit hit = first_hit_of(s, NULL, &second, NULL);
    assert_true(state[1] == hit.state && t[1] == hit.t && lo[1] == hit.t_lo);
}
/* Of faces whose t round to one double the first in a list counted, not the first on the ray. */
TEST(entry_far_away) {
    const algsurf_extent box = {ALGSURF_EXTENT_BOX, {0, 0, 0}, {1, 1, 1}};
    const algsurf_ray ray = {{-1e17, 0, 0}, {1, 0, 0}, 0, INFINITY};
    const algsurf_hit hit = first_hit_of(surface_of("z = 0"), &box, &ray, NULL); /* enters at 1e17 - 1 */
    assert_true(hit.state == ALGSURF_STATE_HIT && hit.t_lo == nextafter(1e17, 0) && hit.t_hi == 1e17);
}
/* With an error of coefficients there were more entries than the degree. */
TEST(more_places_than_the_degree) {
    const algsurf_surface *s = surface_with_error(surface_of("x^2 = y^2"), 1e-3);
    const algsurf_ray ray = {{3, 1, 0}, {1, 1, 0}, -INFINITY, INFINITY};
    algsurf_hit found[2];
    int count;
    assert_ok(algsurf_intersect_all(s, NULL, &ray, NULL, found, 2, &count));
    assert_true(count > 0 && found[0].t_lo == -INFINITY && found[count - 1].t_hi == INFINITY);
}
/* Rays that lack memory were said to be at (0, 0, 0). */
TEST(position_without_memory) {
    const double o[3] = {5, 3, 1}, d[3] = {-1, -0.5, -0.2}, begin = -8;
    double at[3], t;
    unsigned char state;
    const algsurf_intersect_options little = {.size = sizeof little, .max_memory = 1};
    const algsurf_ray_packet rays = {.size = sizeof rays,
                                     .count = 1,
                                     .origin = {o, o + 1, o + 2},
                                     .direction = {d, d + 1, d + 2},
                                     .t_min = &begin};
    const algsurf_hit_packet to = {
        .size = sizeof to, .state = &state, .t = &t, .position = {at, at + 1, at + 2}};
    const algsurf_surface *s = surface_of("(x^2 + y^2 + z^2 - 1)^12 + (x y - z)^23 (x - 7)");
    assert_int_equal(algsurf_intersect_packet(s, NULL, &rays, &little, &to), ALGSURF_E_NO_MEMORY);
    assert_true(state == ALGSURF_STATE_UNDECIDED && t == -8);
    for (int k = 0; k < 3; k++) assert_true(fabs(at[k] - (o[k] - 8 * d[k])) < 1e-15);
}
/* In complex space a part of a ray that is a point was undecided: powers of its length vanished. */
TEST(complex_point) {
    const algsurf_complex_space space = {.size = sizeof space, .sector = {0, 3}};
    const algsurf_ray ray = {{0, 0, 0}, {1, 0, 0}, 2, 2};
    algsurf_hit hit;
    assert_ok(algsurf_intersect_complex(surface_of("x^2 + y^2 + z^2 = 1"), NULL, &ray, &space, NULL, NULL,
                                        &hit, NULL));
    assert_int_equal(hit.state, ALGSURF_STATE_MISS);
}
