/* test_intersect_touch.c - the certified tier where the surface has roots on the extent's own surface: they
 * are in it.
 *
 * P is the extent's equation, or that of one of its faces, times a plane and a factor without real roots; the
 * ray, which starts outside, meets the extent in two points that are roots of P whatever rounding does.  How
 * many roots are in the extent is known beforehand.
 *
 * Breaks caught, each tried: division that forgets a binomial, the middle coefficient's 2, a sign, the last
 * step or one of the two coefficients of what is left; that never reads backwards; roots on a face left out,
 * or uncertain.
 */
#include "intersect_case.h"

#include "rays/exact.h"
#include "rays/form.h"

#define SEED 73u

enum { ROUNDS = 300, MOST_TEXT = 400 };

static const algsurf_intersect_options certified = {.size = sizeof certified, .tier = ALGSURF_TIER_CERTIFIED};

typedef struct touch {
    intersect_case c;
    algsurf_extent extent;
    int wanted; /* roots in the extent */
} touch;

/* A number of few bits, so that texts are exact. */
static double quarter(uint64_t *seed, int most) {
    return 0.25 * (exact_random_int(seed, 8 * most + 1) - 4 * most);
}

static void judge(touch *e, int round) {
    intersect_answer a;
    unsigned char state, occluded;
    const algsurf_ray *r = &e->c.ray;
    const algsurf_ray_packet packet = {.size = sizeof packet,
                                       .count = 1,
                                       .origin = {&r->origin[0], &r->origin[1], &r->origin[2]},
                                       .direction = {&r->direction[0], &r->direction[1], &r->direction[2]},
                                       .t_min = &r->t_min,
                                       .t_max = &r->t_max};
    const algsurf_hit_packet hits = {.size = sizeof hits, .state = &state};
    intersect_ask(&e->c, &e->extent, &certified, &a);
    assert_int_equal(algsurf_intersect_packet(e->c.surface, &e->extent, &packet, &certified, &hits),
                     ALGSURF_OK);
    assert_int_equal(algsurf_occluded_packet(e->c.surface, &e->extent, &packet, &certified, &occluded),
                     ALGSURF_OK);
    const char *wrong = NULL;
    int wanted = e->wanted > 0 ? ALGSURF_HIT : ALGSURF_MISS;
    if (a.count != e->wanted) wrong = "not as many hits as roots in the extent";
    for (int i = 0; i < a.count; i++)
        if (a.all[i].state != ALGSURF_HIT) wrong = "an uncertain root";
    if (a.first.state != wanted || (int)a.occluded != wanted) wrong = "first or occluded disagrees";
    if (state != wanted || occluded != wanted) wrong = "a packet disagrees";
    if (wrong) {
        fprintf(stderr, "seed %u, round %d: %d roots are in the extent of kind %d\n", SEED, round, e->wanted,
                (int)e->extent.kind);
        exact_print_doubles("centre", e->extent.centre, 3), exact_print_doubles("size", e->extent.size, 3);
        intersect_fail(wrong, &e->c, &a);
    }
    algsurf_surface_free(e->c.surface);
}

/* From outside towards a point inside: both are less than 30 wide. */
static void aim(touch *e, uint64_t *seed, const double inside[3]) {
    double *d = e->c.ray.direction, longest = 0;
    for (int i = 0; i < 3; i++) {
        d[i] = exact_random_unit(seed);
        longest = fmax(longest, fabs(d[i]));
    }
    for (int i = 0; i < 3; i++) e->c.ray.origin[i] = inside[i] - 60 / longest * d[i];
    e->c.ray.t_min = 0, e->c.ray.t_max = INFINITY;
}

/* The plane's root is clear of the extent's surface, or the round is skipped. */
static int plane_in_sphere(const touch *e, double height, int *clear) {
    const algsurf_ray *r = &e->c.ray;
    double t = (height - r->origin[2]) / r->direction[2], square = 0;
    for (int i = 0; i < 3; i++) {
        double x = r->origin[i] + t * r->direction[i] - e->extent.centre[i];
        square += x * x;
    }
    double over = square - e->extent.size[0] * e->extent.size[0];
    *clear = fabs(over) > 1e-3 && t > 0;
    return over < 0;
}

static void test_sphere(void **state) {
    (void)state;
    uint64_t seed = SEED;
    int judged = 0;
    for (int round = 0; round < ROUNDS; round++) {
        touch e = {.extent = {.kind = ALGSURF_EXTENT_SPHERE}};
        char text[MOST_TEXT];
        double inside[3], height = quarter(&seed, 4), *c = e.extent.centre;
        int clear;
        e.extent.size[0] = 0.25 * (1 + exact_random_int(&seed, 40));
        for (int i = 0; i < 3; i++) {
            c[i] = quarter(&seed, 5);
            inside[i] = c[i] + e.extent.size[0] * 0.5 * exact_random_unit(&seed);
        }
        aim(&e, &seed, inside);
        e.wanted = 2 + plane_in_sphere(&e, height, &clear);
        if (!clear) continue;
        snprintf(text, sizeof text,
                 "((x - (%g))^2 + (y - (%g))^2 + (z - (%g))^2 - (%g)^2) (z - (%g)) (x^2 + y^2 + 3)", c[0],
                 c[1], c[2], e.extent.size[0], height);
        intersect_equation(&e.c, text);
        judge(&e, round);
        judged++;
    }
    assert_true(judged > ROUNDS / 2);
}

/* P vanishes on the face x = +-size alone; the ray enters and leaves through any. */
static void test_box(void **state) {
    (void)state;
    uint64_t seed = SEED;
    int on_face = 0;
    for (int round = 0; round < ROUNDS; round++) {
        touch e = {.extent = {.kind = ALGSURF_EXTENT_BOX}};
        char text[MOST_TEXT];
        double inside[3], *c = e.extent.centre, *h = e.extent.size;
        for (int i = 0; i < 3; i++) {
            c[i] = quarter(&seed, 5);
            h[i] = 0.25 * (1 + exact_random_int(&seed, 40));
            inside[i] = c[i] + h[i] * 0.5 * exact_random_unit(&seed);
        }
        aim(&e, &seed, inside);
        double face = exact_random_int(&seed, 2) ? c[0] + h[0] : c[0] - h[0];
        double t = (face - e.c.ray.origin[0]) / e.c.ray.direction[0];
        e.wanted = t > 0;
        for (int i = 1; i < 3; i++) {
            double x = e.c.ray.origin[i] + t * e.c.ray.direction[i] - c[i];
            e.wanted &= fabs(x) < h[i];
        }
        snprintf(text, sizeof text, "(x - (%g)) (x^2 + y^2 + z^2 + 3) (y^2 + 2)", face);
        intersect_equation(&e.c, text);
        judge(&e, round);
        on_face += e.wanted;
    }
    assert_in_range(on_face, ROUNDS / 10, ROUNDS);
}

/* P has a root at just one of the two points of the sphere, or one that is off by 2^-52 of it: neither is a
 * multiple of the sphere's equation.  The first stays uncertain, the second is decided. */
static void test_other_surface(void **state) {
    (void)state;
    touch e = {.extent = {.kind = ALGSURF_EXTENT_SPHERE, .size = {1}}};
    const algsurf_ray ray = {{-3, 0.125, 0.25}, {1, 0x1.5p-6, 0x1.3p-7}, 0, INFINITY};
    intersect_answer a;
    e.c.ray = ray;
    intersect_equation(&e.c, "x^2 + y^2 + z^2 - 1 - 2^-51");
    judge(&e, 0);
    e.wanted = 2;
    intersect_equation(&e.c, "x^2 + y^2 + z^2 - 1 + 2^-51");
    judge(&e, 1);
    e.c.ray = (algsurf_ray){{-3, 0.6, 0}, {1, 0, 0}, 0, INFINITY};
    e.extent.size[0] = 1;
    intersect_equation(&e.c, "(x - 0.6)(x^2 + 1)");
    e.c.ray = (algsurf_ray){{0, 0, 0}, {3, 4, 0}, 0.125, INFINITY}; /* leaves at t = 1/5, x = 3/5 */
    algsurf_surface_free(e.c.surface);
    intersect_equation(&e.c, "(5 x - 3)(x^2 + 1)");
    intersect_ask(&e.c, &e.extent, &certified, &a);
    assert_true(a.count == 1 && a.first.state == ALGSURF_UNCERTAIN && a.occluded == ALGSURF_UNCERTAIN);
    assert_int_equal(a.first.reason, ALGSURF_UNDECIDED_END);
    algsurf_surface_free(e.c.surface);
}

/* An end of the interval is the sphere's other point: the form's last coefficient is 0. */
static void test_backwards(void **state) {
    (void)state;
    touch e = {.extent = {.kind = ALGSURF_EXTENT_SPHERE, .size = {1}}};
    algsurf_i_exact_root root[ALGSURF_MAX_DEGREE + 1];
    e.c.ray = (algsurf_ray){{-4, 0, 0}, {1, 0, 0}, 0, INFINITY};
    intersect_equation(&e.c, "(x^2 + y^2 + z^2 - 1)(x^2 + 7)");
    const double ends[][2] = {{2.5, 5}, {3, 5.5}, {2.7, 5.1}, {3, 5}};
    for (size_t i = 0; i < sizeof ends / sizeof *ends; i++) {
        int count = algsurf_i_exact_roots(e.c.surface, &e.c.ray, &e.extent, ends[i][0], ends[i][1],
                                          ALGSURF_WANT_ALL, root);
        assert_int_equal(count, 2);
        for (int k = 0; k < 2; k++) {
            assert_int_equal(root[k].state, ALGSURF_HIT);
            assert_true(root[k].lo <= 3 + 2 * k && 3 + 2 * k <= root[k].hi);
        }
    }
    algsurf_surface_free(e.c.surface);
}

/* The unit sphere along the x axis, 1 - x^2, and what it divides. */
static void test_division(void **state) {
    (void)state;
    const algsurf_extent unit = {ALGSURF_EXTENT_SPHERE, {0, 0, 0}, {1, 0, 0}};
    const struct {
        const char *equation;
        double lo, hi;
        int divides;
    } cases[] = {
        {"(x^2 - 1)(x - 3)", 0, 2, 1},
        {"x^2 - 1", -3, INFINITY, 1},
        {"1 + 2 x - 2 x^2", 0, 2, 0}, /* what is left is 2 x (2 - x): one coefficient of two */
        {"x^2 - 2", 0, 1, 0},         /* the form's last coefficient is 0, */
        {"(x^2 - 1)(x + 7)", 0, 1, 1},
        {"x^2 - 2", -1, 0.5, 0}, /* the first, */
        {"x^2 - 1", -1, 1, 0},   /* and both, which is not told */
        {"x - 1", 0, 2, 0},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        intersect_case c = {.ray = {{0, 0, 0}, {1, 0, 0}, 0, INFINITY}};
        intersect_equation(&c, cases[i].equation);
        algsurf_i_ray_form f = {
            .surface = c.surface, .extent = &unit, .lo = cases[i].lo, .hi = cases[i].hi, .depth = 60};
        assert_true(algsurf_i_ray_form_make(&f, &c.ray));
        assert_int_equal(f.faces, 1);
        if (algsurf_i_face_divides(&f, 0) != cases[i].divides)
            fail_msg("%s on [%g, %g]: not %d", cases[i].equation, cases[i].lo, cases[i].hi, cases[i].divides);
        algsurf_i_ray_form_free(&f);
        algsurf_surface_free(c.surface);
    }
}

/* The ray passes the sphere, which divides P, by 2^-121; close to where it is nearest P has another root. */
static void test_passing_by(void **state) {
    (void)state;
    touch e = {.extent = {.kind = ALGSURF_EXTENT_SPHERE, .size = {1}}, .wanted = 0};
    e.c.ray = (algsurf_ray){{-4, 1, 0x1p-60}, {1, 0, 0}, 0, 4 + 0x1.5p-24}; /* 4 is not in the middle */
    intersect_equation(&e.c, "(x^2 + y^2 + z^2 - 1)(3 x - 2^-62)");
    judge(&e, 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_sphere),        cmocka_unit_test(test_box),
        cmocka_unit_test(test_other_surface), cmocka_unit_test(test_backwards),
        cmocka_unit_test(test_division),      cmocka_unit_test(test_passing_by)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
