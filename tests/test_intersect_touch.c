/* test_intersect_touch.c - where the surface has roots on the extent's own surface: they
 * are in it.
 *
 * P is the extent's equation, or that of one of its faces, times a plane and a factor without real roots; the
 * ray, which starts outside, meets the extent in two points that are roots of P whatever rounding does.  How
 * many roots are in the extent is known beforehand.
 *
 * Breaks caught, each tried: a face that shares the root taken for one that is negative there, one of the
 * sphere's two points left out, roots on a face left out.
 */
#include "intersect_case.h"

#include "rays/exact_ray.h"

#define SEED 73u

enum { ROUNDS = 300, MOST_TEXT = 400 };

typedef struct touch {
    intersect_case c;
    algsurf_extent extent;
    int wanted; /* roots in the extent */
} touch;

/* A number of few bits, so that texts are exact. */
static double quarter(uint64_t *seed, int most) { return 0.25 * (random_int(seed, 8 * most + 1) - 4 * most); }

static void judge(touch *e, int round) {
    intersect_answer a;
    intersect_judge_in(&e->c, &e->extent, NULL, &a);
    if (a.count != e->wanted) {
        fprintf(stderr, "seed %u, round %d: %d roots are in the extent of kind %d\n", SEED, round, e->wanted,
                (int)e->extent.kind);
        exact_print_doubles("centre", e->extent.centre, 3), exact_print_doubles("size", e->extent.size, 3);
        intersect_fail("not as many hits as roots in the extent", &e->c, &a);
    }
}

/* From outside towards a point inside: both are less than 30 wide. */
static void aim(touch *e, uint64_t *seed, const double inside[3]) {
    double *d = e->c.ray.direction, longest = 0;
    for (int i = 0; i < 3; i++) {
        d[i] = random_unit(seed);
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

TEST(test_sphere) {
    uint64_t seed = SEED;
    int judged = 0;
    for (int round = 0; round < ROUNDS; round++) {
        touch e = {.extent = {.kind = ALGSURF_EXTENT_SPHERE}};
        char text[MOST_TEXT];
        double inside[3], height = quarter(&seed, 4), *c = e.extent.centre;
        int clear;
        e.extent.size[0] = 0.25 * (1 + random_int(&seed, 40));
        for (int i = 0; i < 3; i++) {
            c[i] = quarter(&seed, 5);
            inside[i] = c[i] + e.extent.size[0] * 0.5 * random_unit(&seed);
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
TEST(test_box) {
    uint64_t seed = SEED;
    int on_face = 0;
    for (int round = 0; round < ROUNDS; round++) {
        touch e = {.extent = {.kind = ALGSURF_EXTENT_BOX}};
        char text[MOST_TEXT];
        double inside[3], *c = e.extent.centre, *h = e.extent.size;
        for (int i = 0; i < 3; i++) {
            c[i] = quarter(&seed, 5);
            h[i] = 0.25 * (1 + random_int(&seed, 40));
            inside[i] = c[i] + h[i] * 0.5 * random_unit(&seed);
        }
        aim(&e, &seed, inside);
        double face = random_int(&seed, 2) ? c[0] + h[0] : c[0] - h[0];
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
 * multiple of the sphere's equation. */
TEST(test_other_surface) {
    touch e = {.extent = {.kind = ALGSURF_EXTENT_SPHERE, .size = {1}}};
    e.c.ray = (algsurf_ray){{-3, 0.125, 0.25}, {1, 0x1.5p-6, 0x1.3p-7}, 0, INFINITY};
    intersect_equation(&e.c, "x^2 + y^2 + z^2 - 1 - 2^-51");
    judge(&e, 0);
    e.wanted = 2;
    intersect_equation(&e.c, "x^2 + y^2 + z^2 - 1 + 2^-51");
    judge(&e, 1);
    e.c.ray = (algsurf_ray){{0, 0, 0}, {3, 4, 0}, 0.125, INFINITY}; /* leaves at t = 1/5, x = 3/5 */
    e.wanted = 1;
    intersect_equation(&e.c, "(5 x - 3)(x^2 + 1)");
    judge(&e, 2);
    intersect_equation(&e.c, "(5 x - 3)^2 (x^2 + 1)");
    judge(&e, 3);
    e.wanted = 0;
    intersect_equation(&e.c, "(5 x - 3 - 2^-50)(x^2 + 1)");
    judge(&e, 4);
}

/* Ends of the ray at, and next to, the sphere's points. */
TEST(test_backwards) {
    touch e = {.extent = {.kind = ALGSURF_EXTENT_SPHERE, .size = {1}}};
    algsurf_i_ray_root root[ALGSURF_MAX_DEGREE];
    e.c.ray = (algsurf_ray){{-4, 0, 0}, {1, 0, 0}, 0, INFINITY};
    intersect_equation(&e.c, "(x^2 + y^2 + z^2 - 1)(x^2 + 7)");
    const double ends[][2] = {{2.5, 5}, {3, 5.5}, {2.7, 5.1}, {3, 5}};
    const algsurf_i_region region = {&e.extent, NULL, 0};
    for (size_t i = 0; i < sizeof ends / sizeof *ends; i++) {
        int count = 0, side;
        e.c.ray.t_min = ends[i][0], e.c.ray.t_max = ends[i][1];
        assert_ok(algsurf_i_exact_roots(
            e.c.surface, &region, &e.c.ray,
            &(algsurf_i_wanted){ALGSURF_WANT_ALL, .limit = ALGSURF_DEFAULT_MEMORY}, root, &count, &side));
        int first = ends[i][0] <= 3 ? 0 : 1, last = ends[i][1] >= 5;
        assert_int_equal(count, last - first + 1);
        for (int k = first; k <= last; k++) {
            assert_int_equal(root[k - first].multiplicity, 1);
            assert_true(root[k - first].t == 3 + 2 * k);
        }
    }
}

/* The ray passes the sphere, which divides P, by 2^-121; close to where it is nearest P has another root. */
TEST(test_passing_by) {
    touch e = {.extent = {.kind = ALGSURF_EXTENT_SPHERE, .size = {1}}, .wanted = 0};
    e.c.ray = (algsurf_ray){{-4, 1, 0x1p-60}, {1, 0, 0}, 0, 4 + 0x1.5p-24}; /* 4 is not in the middle */
    intersect_equation(&e.c, "(x^2 + y^2 + z^2 - 1)(3 x - 2^-62)");
    judge(&e, 0);
}
