/* test_render_fast.c - pictures of the fast tier, in single precision, beside those of the certified tier.
 *
 * Slices of pictures of all named surfaces, and of two of higher degrees: from near and from 1e4 radii away,
 * in balls and boxes, by tiles and row by row.  Few pixels may be wrong: another state, or a t that is off by
 * more than a thousandth of the extent's radius.  t and normals of the others are as good as floats make
 * them.  Neither slices, threads nor kernels may change a byte.
 *
 * It fails when t is measured from the eye in floats, when a step of Newton's method that leaves a sheet is
 * taken for the last one, and when pixels in a row are guessed from as many as there are lanes. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#include "catalogue.h"
#include "exact.h"
#include "algsurf/algsurf.h"

#include <math.h>
#include <string.h>

enum { WIDTH = 256, ROWS = 48, VIEWS = 8, MOST = 200 };

static const catalogue_entry more[] = {
    {.name = "degree 12",
     .degree = 12,
     .equation = "x^12 + y^12 + z^12 - 3(x y z)^4 + x^3 y^2 z - 0.3 = 0",
     .extent = {ALGSURF_EXTENT_SPHERE, {0, 0, 0}, {1.4, 1.4, 1.4}}},
    {.name = "degree 20",
     .degree = 20,
     .equation = "x^20 + y^20 + z^20 - x^4 y^4 z^4 + x y - 0.2 = 0",
     .extent = {ALGSURF_EXTENT_SPHERE, {0, 0, 0}, {1.3, 1.3, 1.3}}},
};

typedef struct slice {
    uint8_t bytes[ROWS * WIDTH * 3];
    double t[ROWS * WIDTH];
    float normals[ROWS * WIDTH * 3];
    unsigned char states[ROWS * WIDTH];
} slice;

typedef struct view {
    const catalogue_entry *entry;
    algsurf_surface *surface;
    algsurf_extent extent;
    algsurf_camera camera;
    int height, row; /* of the whole picture; where the slice begins */
    uint64_t seed;
} view;

/* Low pictures go row by row, high ones by tiles. */
static void set_view(view *v, int number) {
    static const double distances[] = {2.2, 4, 100, 1e4};
    double radius = v->entry->extent.size[0], far = distances[number % 4] * radius, eye[3], length = 0;
    const double up[3] = {0.1, 0.2, 1};
    v->extent = v->entry->extent;
    for (int i = 0; i < 3; i++) {
        eye[i] = exact_random_unit(&v->seed);
        length += eye[i] * eye[i];
    }
    for (int i = 0; i < 3; i++) eye[i] = v->extent.centre[i] + far * eye[i] / sqrt(length);
    if (number % 3 == 1) {
        v->extent.kind = ALGSURF_EXTENT_BOX;
        for (int i = 0; i < 3; i++) v->extent.size[i] = radius * (0.5 + 0.1 * i);
    }
    v->height = number < VIEWS / 2 ? 192 : 1600;
    v->row = v->height / 2 - ROWS / 2;
    double fov = 2 * atan(1.1 * radius / far) * 57.3 * v->height / (4 * WIDTH);
    assert_int_equal(algsurf_camera_pinhole(eye, v->extent.centre, up, fov, &v->camera), ALGSURF_OK);
}

static algsurf_scene *scene_of(const view *v, int tier, const char *kernel, int antialias) {
    const algsurf_intersect_options how = {.size = sizeof how, .tier = tier, .kernel = kernel};
    algsurf_scene *scene = NULL;
    assert_int_equal(algsurf_scene_create(v->surface, &scene), ALGSURF_OK);
    assert_int_equal(algsurf_scene_set_extent(scene, &v->extent), ALGSURF_OK);
    assert_int_equal(algsurf_scene_set_camera(scene, &v->camera), ALGSURF_OK);
    assert_int_equal(algsurf_scene_set_intersect(scene, &how), ALGSURF_OK);
    assert_int_equal(algsurf_scene_set_antialias(scene, antialias), ALGSURF_OK);
    return scene;
}

/* Rows from `begin` to end - 1 of the slice. */
static void draw(const view *v, int tier, const char *kernel, int antialias, int threads, int begin, int end,
                 slice *s) {
    size_t first = (size_t)begin * WIDTH;
    algsurf_scene *scene = scene_of(v, tier, kernel, antialias);
    const algsurf_picture planes = {.size = sizeof planes,
                                    .pixels = s->bytes + 3 * first,
                                    .t = s->t + first,
                                    .normals = s->normals + 3 * first,
                                    .state = s->states + first};
    const algsurf_render_options o = {.size = sizeof o,
                                      .width = WIDTH,
                                      .height = v->height,
                                      .row_begin = v->row + begin,
                                      .row_end = v->row + end,
                                      .threads = threads};
    assert_int_equal(algsurf_render(scene, &o, &planes, NULL), ALGSURF_OK);
    algsurf_scene_free(scene);
}

static void for_each_view(void (*check)(view *v), int step) {
    for (const catalogue_entry *entry = catalogue; entry;) {
        view v = {.entry = entry, .seed = 20261125};
        assert_int_equal(algsurf_surface_from_equation(entry->equation, NULL, 0, &v.surface, NULL),
                         ALGSURF_OK);
        for (int number = 0; number < VIEWS; number += step) {
            set_view(&v, number);
            check(&v);
        }
        algsurf_surface_free(v.surface);
        if (entry == more + 1) return;
        entry = entry == more ? more + 1 : (entry + 1)->name ? entry + 1 : more;
    }
}

/* ---- how good they are ---- */

static struct {
    long hits, wrong, unlike; /* pixels; of those that hit in both, those whose normals differ visibly */
    double far;               /* sum of errors of t, in radii */
} found;

static int is_wrong(const view *v, const slice *fast, const slice *sure, int i) {
    if (fast->states[i] != sure->states[i]) return 1;
    return sure->states[i] == ALGSURF_HIT && fabs(fast->t[i] - sure->t[i]) > 1e-3 * v->entry->extent.size[0];
}

static void compare_tiers(view *v) {
    static slice fast, sure;
    long wrong = 0, hits = 0;
    draw(v, ALGSURF_TIER_FAST, NULL, 1, 1, 0, ROWS, &fast);
    draw(v, ALGSURF_TIER_CERTIFIED, NULL, 1, 1, 0, ROWS, &sure);
    for (int i = 0; i < ROWS * WIDTH; i++) {
        hits += sure.states[i] == ALGSURF_HIT;
        wrong += is_wrong(v, &fast, &sure, i);
        if (sure.states[i] != ALGSURF_HIT || is_wrong(v, &fast, &sure, i)) continue;
        double cosine = 0;
        for (int k = 0; k < 3; k++) cosine += (double)fast.normals[3 * i + k] * sure.normals[3 * i + k];
        found.unlike += cosine < 0.9995;
        found.far += fabs(fast.t[i] - sure.t[i]) / v->entry->extent.size[0];
    }
    if (wrong > MOST)
        fail_msg("%s, height %d: %ld of %ld pixels are wrong", v->entry->name, v->height, wrong, hits);
    found.wrong += wrong;
    found.hits += hits;
}

static void errors_are_few(void **state) {
    (void)state;
    for_each_view(compare_tiers, 1);
    printf("%ld hits, %ld wrong, normals of %ld differ by 2 degrees; t by %.2g radii on average\n",
           found.hits, found.wrong, found.unlike, found.far / (double)found.hits);
    assert_true(found.hits > 500000);
    assert_true(found.wrong * 1700 < found.hits);
    assert_true(found.unlike * 700 < found.hits);
    assert_true(found.far < 2.2e-7 * (double)found.hits);
}

/* ---- always the same ---- */

static void compare_bytes(view *v) {
    static slice whole, other;
    for (int antialias = 1; antialias <= 2; antialias++) {
        memset(&whole, 0, sizeof whole), memset(&other, 0, sizeof other);
        draw(v, ALGSURF_TIER_FAST, NULL, antialias, 1, 0, ROWS, &whole);
        int cut = 1 + exact_random_int(&v->seed, ROWS - 1);
        draw(v, ALGSURF_TIER_FAST, NULL, antialias, 1, 0, cut, &other);
        draw(v, ALGSURF_TIER_FAST, NULL, antialias, 1, cut, ROWS, &other);
        assert_memory_equal(&whole, &other, sizeof whole);
        draw(v, ALGSURF_TIER_FAST, NULL, antialias, 3, 0, ROWS, &other);
        assert_memory_equal(&whole, &other, sizeof whole);
        for (int i = 0; algsurf_kernel_name(i); i++) {
            draw(v, ALGSURF_TIER_FAST, algsurf_kernel_name(i), antialias, 1, 0, ROWS, &other);
            assert_memory_equal(&whole, &other, sizeof whole);
        }
    }
}

static void nothing_changes_a_byte(void **state) {
    (void)state;
    for_each_view(compare_bytes, 3);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(errors_are_few),
                                       cmocka_unit_test(nothing_changes_a_byte)};
    return cmocka_run_group_tests_name("fast", tests, NULL, NULL);
}
