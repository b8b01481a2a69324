/* test_thin.c - what is thin is drawn, all of it and nothing else.
 *
 * Which surfaces have thin parts is known: the handle of Whitney's umbrella, x = y = 0 < z; the axes beyond
 * 1/2 on Steiner's surface; the origin on x^2 + y^2 = z^2 (z - 1).  At sizes from 5 to 2048 each pixel that
 * a point of them is seen through shows it, or what hides it, so a line has no gaps; only where a line
 * begins, 6 pixels may show the sheets there.  Nothing else thin is shown, but beside the line, where it
 * begins, and along its continuation, where sheets cross.  Smooth surfaces are drawn to the byte as without,
 * from random eyes, far, near and at silhouettes.  Slices, threads and kernels do not change a byte.
 *
 * Breaks tried, each caught by the test named:
 *   smooth_surfaces_are_as_before: what neighbours see accounts for nothing beside it; all columns for the
 *       pixel's; a sign of the ray that is never known
 *   thin_parts_are_drawn: boxes as wide as pixels
 *   samples_are_finer_pixels: samples with the cells of whole pixels
 *   edges_have_no_halo: neighbours' rays that are asked of integers alone
 *   undecided_places_hide_nothing: boxes that end before an undecided place, in either way of drawing it
 *
 *     test_thin [views [seed]]
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#include "catalogue.h"
#include "exact.h"
#include "algsurf/algsurf.h"

#include <math.h>
#include <string.h>

enum { MOST = 2048, SMALL = 19 /* pixels: there sheets are thin, too, or hide everything */ };

static int views = 6;
static uint64_t first_seed = 20261125;

static const double red[3] = {1, 0, 0};

typedef struct image {
    int size;
    uint8_t bytes[MOST * MOST * 4];
    double t[MOST * MOST];
    float normals[MOST * MOST * 3];
    unsigned char states[MOST * MOST];
    algsurf_render_stats stats;
} image;

static image first, second;

/* Rows begin to end - 1 of a square picture; end 0: all. */
static void draw_rows(const algsurf_scene *scene, int size, int begin, int end, int threads, image *to) {
    size_t at = (size_t)begin * (size_t)size;
    const algsurf_picture planes = {.size = sizeof planes,
                                    .pixels = to->bytes + 4 * at,
                                    .format = ALGSURF_RGBA8,
                                    .t = to->t + at,
                                    .normals = to->normals + 3 * at,
                                    .state = to->states + at};
    const algsurf_render_options o = {.size = sizeof o,
                                      .width = size,
                                      .height = size,
                                      .row_begin = begin,
                                      .row_end = end,
                                      .threads = threads};
    to->size = size;
    to->stats = (algsurf_render_stats){.size = sizeof to->stats};
    assert_int_equal(algsurf_render(scene, &o, &planes, &to->stats), ALGSURF_OK);
}

static void draw(const algsurf_scene *scene, int size, image *to) { draw_rows(scene, size, 0, 0, 1, to); }

static void assert_same(const image *a, const image *b) {
    size_t count = (size_t)a->size * (size_t)a->size;
    assert_memory_equal(a->bytes, b->bytes, 4 * count);
    assert_memory_equal(a->t, b->t, count * sizeof *a->t);
    assert_memory_equal(a->normals, b->normals, 3 * count * sizeof *a->normals);
    assert_memory_equal(a->states, b->states, count);
}

static algsurf_scene *scene_of(const algsurf_surface *surface, const algsurf_extent *extent,
                               const algsurf_camera *camera) {
    algsurf_scene *scene;
    assert_int_equal(algsurf_scene_create(surface, &scene), ALGSURF_OK);
    assert_int_equal(algsurf_scene_set_extent(scene, extent), ALGSURF_OK);
    assert_int_equal(algsurf_scene_set_camera(scene, camera), ALGSURF_OK);
    return scene;
}

static algsurf_surface *surface_of(const char *equation) {
    algsurf_surface *surface;
    assert_int_equal(algsurf_surface_from_equation(equation, NULL, 0, &surface, NULL), ALGSURF_OK);
    return surface;
}

/* ---- what is to be drawn ---- */

/* Where a point is seen: in pixels, and its t; a: size of a pixel there. */
typedef struct place {
    double x, y, t, pixel;
} place;

static double dot(const double a[3], const double b[3]) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

static place place_of(const algsurf_camera *camera, int size, const double point[3]) {
    double from_eye[3], scale = 0.5 * size / camera->half_height;
    for (int i = 0; i < 3; i++) from_eye[i] = point[i] - camera->eye[i];
    double deep = dot(from_eye, camera->forward), shrunk = camera->orthographic ? 1 : deep;
    return (place){0.5 * size + scale * dot(from_eye, camera->right) / shrunk,
                   0.5 * size - scale * dot(from_eye, camera->up) / shrunk,
                   camera->orthographic ? deep : sqrt(dot(from_eye, from_eye)), shrunk / scale};
}

/* A thin part: the points from + s along, 0 <= s <= 1, as far as they are in the extent. */
typedef struct part {
    double from[3], along[3];
} part;

typedef struct thin_surface {
    const char *equation;
    algsurf_extent extent;
    int count;
    part parts[6];
} thin_surface;

static const thin_surface umbrella = {
    "x^2 z + y^2", {ALGSURF_EXTENT_SPHERE, {0, 0, 0}, {2, 0, 0}}, 1, {{{0, 0, 0}, {0, 0, 2}}}};
static const thin_surface steiner = {"x^2 y^2 + x^2 z^2 + y^2 z^2 + x y z",
                                     {ALGSURF_EXTENT_BOX, {0, 0, 0}, {0.8, 0.9, 1}},
                                     6,
                                     {{{0.5, 0, 0}, {0.3, 0, 0}},
                                      {{-0.5, 0, 0}, {-0.3, 0, 0}},
                                      {{0, 0.5, 0}, {0, 0.4, 0}},
                                      {{0, -0.5, 0}, {0, -0.4, 0}},
                                      {{0, 0, 0.5}, {0, 0, 0.5}},
                                      {{0, 0, -0.5}, {0, 0, -0.5}}}};
static const thin_surface isolated = {
    "x^2 + y^2 - z^2 (z - 1)", {ALGSURF_EXTENT_SPHERE, {0, 0, 0}, {2, 0, 0}}, 1, {{{0, 0, 0}, {0, 0, 0}}}};

/* Marks the pixels about those that a thin part is seen through, with its t. */
static double marks[MOST * MOST];

static void mark(const image *of, const place *p, int around) {
    for (int dy = -around; dy <= around; dy++)
        for (int dx = -around; dx <= around; dx++) {
            double x = floor(p->x) + dx, y = floor(p->y) + dy;
            if (x < 0 || y < 0 || x >= of->size || y >= of->size) continue;
            marks[(size_t)y * (size_t)of->size + (size_t)x] = p->t;
        }
}

/* The pixel of a place shows it, or what is before it; or, where the sheets begin, sheets are next to it. */
static long check_place(const image *of, const place *p, int may_be_sheet) {
    if (!(p->x >= 0 && p->y >= 0 && p->x < of->size && p->y < of->size)) return 0;
    size_t i = (size_t)p->y * (size_t)of->size + (size_t)p->x;
    if (of->states[i] == ALGSURF_THIN) {
        assert_true(fabs(of->t[i] - p->t) < 12 * p->pixel || of->t[i] < p->t || may_be_sheet);
        return 1;
    }
    int is_hidden = of->states[i] == ALGSURF_HIT && of->t[i] < p->t + 8 * p->pixel;
    if (!is_hidden && !may_be_sheet)
        fail_msg("size %d: nothing at pixel %.2f,%.2f, state %d", of->size, p->x, p->y, of->states[i]);
    return 0;
}

/* The parts are drawn, while on the other side of where they begin, where sheets cross, there may be spots,
 * and the extent ends them to a few pixels; returns how many of the places that were looked at show them. */
static long check_parts(const thin_surface *s, const algsurf_camera *camera, const image *of) {
    long shown = 0;
    for (int p = 0; p < s->count; p++)
        for (int k = -8 * of->size; k <= 4 * of->size + 40; k++) {
            double point[3], share = k / (4.0 * of->size);
            for (int i = 0; i < 3; i++) point[i] = s->parts[p].from[i] + share * s->parts[p].along[i];
            const place at = place_of(camera, of->size, point),
                        begin = place_of(camera, of->size, s->parts[p].from);
            int near_sheets =
                dot(s->parts[p].along, s->parts[p].along) > 0 && hypot(at.x - begin.x, at.y - begin.y) < 6;
            int at_end = share > 1 - 8.0 / of->size;
            if (share >= 0 && share <= 1) shown += check_place(of, &at, near_sheets || at_end);
            mark(of, &at, near_sheets ? 2 + (int)sqrt(of->size) : 1);
        }
    return shown;
}

static void check_nothing_else(const image *of) {
    uint64_t count = 0;
    for (size_t i = 0; i < (size_t)of->size * (size_t)of->size; i++) {
        if (of->states[i] != ALGSURF_THIN) continue;
        count++;
        if (marks[i] == 0)
            fail_msg("size %d: something at pixel %d,%d", of->size, (int)i % of->size, (int)i / of->size);
        assert_true(of->bytes[4 * i] == 255 && of->bytes[4 * i + 1] == 0 && of->bytes[4 * i + 3] == 255);
        for (int k = 0; k < 3; k++) assert_true(of->normals[3 * i + (size_t)k] == 0);
    }
    assert_true(count == of->stats.thin);
}

static void random_camera(uint64_t *seed, double far, const double look[3], double fov, int parallel,
                          algsurf_camera *camera) {
    double eye[3], up[3], length = 0;
    for (int i = 0; i < 3; i++) {
        eye[i] = exact_random_unit(seed);
        up[i] = exact_random_unit(seed);
        length += eye[i] * eye[i];
    }
    for (int i = 0; i < 3; i++) eye[i] = look[i] + far * eye[i] / sqrt(length);
    if (parallel)
        assert_int_equal(algsurf_camera_orthographic(eye, look, up, 2 * far * tan(fov / 114.6), camera),
                         ALGSURF_OK);
    else
        assert_int_equal(algsurf_camera_pinhole(eye, look, up, fov, camera), ALGSURF_OK);
}

static void check_surface(const thin_surface *s, int size, int count, uint64_t *seed) {
    static const double centre[3] = {0, 0, 0};
    algsurf_surface *surface = surface_of(s->equation);
    long shown = 0;
    for (int view = 0; view < count; view++) {
        algsurf_camera camera;
        random_camera(seed, view % 3 == 2 ? 60 : 7, centre, view % 3 == 2 ? 3 : 20 + 60 * (view % 2),
                      view % 4 == 3, &camera);
        algsurf_scene *scene = scene_of(surface, &s->extent, &camera);
        assert_int_equal(algsurf_scene_set_thin(scene, red), ALGSURF_OK);
        draw(scene, size, &first);
        memset(marks, 0, (size_t)size * (size_t)size * sizeof *marks);
        shown += check_parts(s, &camera, &first);
        if (size > SMALL) check_nothing_else(&first);
        algsurf_scene_free(scene);
    }
    assert_true(shown > 0 || size <= SMALL);
    algsurf_surface_free(surface);
}

static void thin_parts_are_drawn(void **state) {
    static const int sizes[] = {5, 12, 19, 64, 65, 100, 128, 256, 511, 1024, 2048};
    (void)state;
    uint64_t seed = first_seed;
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        int count = sizes[i] > 1000 ? 1 + views / 12 : views;
        check_surface(&umbrella, sizes[i], count, &seed);
        check_surface(&steiner, sizes[i], count, &seed);
        check_surface(&isolated, sizes[i], count, &seed);
    }
}

/* Behind a place where it is undecided what a ray hits: the rays of the middle column touch the line x = y =
 * 0, which doubles do not decide, and what stands for it is the middle of the chord, before the line. */
static void undecided_places_hide_nothing(void **state) {
    enum { SIZE = 65 };
    static const algsurf_extent extent = {ALGSURF_EXTENT_SPHERE, {1.5, 0, 0}, {2, 0, 0}};
    (void)state;
    algsurf_surface *surface = surface_of("x^2 + y^2");
    algsurf_camera camera;
    assert_int_equal(
        algsurf_camera_pinhole((double[]){9, 0, 0}, (double[]){0, 0, 0}, (double[]){0, 0, 1}, 25, &camera),
        ALGSURF_OK);
    for (int as = ALGSURF_AS_UNDECIDED; as <= ALGSURF_AS_MISS; as++) {
        const algsurf_intersect_options how = {
            .size = sizeof how, .tier = ALGSURF_TIER_BOUNDED, .undecided_as = as};
        algsurf_scene *scene = scene_of(surface, &extent, &camera);
        assert_int_equal(algsurf_scene_set_intersect(scene, &how), ALGSURF_OK);
        draw(scene, SIZE, &first);
        assert_true(first.stats.undecided + first.stats.hits > 40 || as == ALGSURF_AS_MISS);
        assert_int_equal(algsurf_scene_set_thin(scene, red), ALGSURF_OK);
        draw(scene, SIZE, &second);
        assert_true(second.stats.thin > 40);
        for (size_t i = 0; i < SIZE * SIZE; i++) {
            assert_true(first.states[i] == ALGSURF_MISS || second.states[i] == ALGSURF_THIN);
            assert_true(second.states[i] == ALGSURF_MISS || fabs(second.t[i] - 9) < 0.3);
        }
        algsurf_scene_free(scene);
    }
    algsurf_surface_free(surface);
}

/* ---- what is not ---- */

static void smooth_surfaces_are_as_before(void **state) {
    static const char *const names[] = {"sphere", "chair", "tangle", "torus", "pillow", "bicube", "cusp"};
    static const int sizes[] = {64, 90, 200, 333};
    static const double distances[] = {1.5, 3, 4, 40}, zooms[] = {1, 0.3, 0.1};
    (void)state;
    uint64_t seed = first_seed;
    for (size_t n = 0; n < sizeof names / sizeof *names; n++) {
        const catalogue_entry *entry = catalogue_find(names[n]);
        algsurf_surface *surface = surface_of(entry->equation);
        double radius = entry->extent.size[0];
        for (int view = 0; view < 2 * views; view++) {
            double look[3], far = distances[view % 4] * radius;
            algsurf_camera camera;
            for (int i = 0; i < 3; i++)
                look[i] = entry->extent.centre[i] + (view % 3 ? 0.5 * radius * exact_random_unit(&seed) : 0);
            random_camera(&seed, far, look, 114.6 * atan(zooms[view % 5 % 3] * fmin(1.1 * radius / far, 1)),
                          view % 7 == 6, &camera);
            algsurf_scene *scene = scene_of(surface, &entry->extent, &camera);
            assert_int_equal(algsurf_scene_set_antialias(scene, 1 + view % 5 / 4), ALGSURF_OK);
            draw(scene, sizes[view % 4], &first);
            assert_int_equal(algsurf_scene_set_thin(scene, red), ALGSURF_OK);
            draw(scene, sizes[view % 4], &second);
            if (second.stats.thin > 0) fail_msg("%s, view %d", names[n], view);
            assert_same(&first, &second);
            algsurf_scene_free(scene);
        }
        algsurf_surface_free(surface);
    }
}

/* Double sheets and cusps end where the pixels do that see them, but for corners; also where a plane cuts
 * them, and where doubles alone decide what neighbours see.  (Of double sheets they decide nothing.) */
static void edges_have_no_halo(void **state) {
    static const char *const equations[] = {"(x^2 + y^2 + z^2 - 1)^2", "(z^3 - 2)^2 + (x^2 + y^2 - 3)^3",
                                            "x^2 y^2 + (z^2 - 1)^3"};
    static const double centre[3] = {0, 0, 0};
    static const algsurf_intersect_options bounded = {.size = sizeof bounded, .tier = ALGSURF_TIER_BOUNDED},
                                           as_hits = {.size = sizeof as_hits,
                                                      .tier = ALGSURF_TIER_BOUNDED,
                                                      .undecided_as = ALGSURF_AS_HIT};
    static const algsurf_intersect_options *const ways[] = {NULL, NULL, &bounded, &as_hits};
    static const algsurf_plane cut = {{0.3, 0.5, 0.8}, 0.4};
    const algsurf_extent extent = {ALGSURF_EXTENT_SPHERE, {0, 0, 0}, {2.5, 0, 0}};
    (void)state;
    uint64_t seed = first_seed;
    for (size_t n = 0; n < sizeof equations / sizeof *equations; n++) {
        algsurf_surface *surface = surface_of(equations[n]);
        for (int view = 0; view < views * 4; view += 3) {
            int way = view / 3 % 4;
            algsurf_camera camera;
            random_camera(&seed, 7, centre, 30, view / 12 % 2, &camera);
            if (n == 0 && way > 0) continue;
            algsurf_scene *scene = scene_of(surface, &extent, &camera);
            assert_int_equal(algsurf_scene_set_thin(scene, red), ALGSURF_OK);
            if (ways[way]) assert_int_equal(algsurf_scene_set_intersect(scene, ways[way]), ALGSURF_OK);
            if (way == 1) assert_int_equal(algsurf_scene_set_clip(scene, &cut, 1), ALGSURF_OK);
            draw(scene, 80, &first);
            assert_true(first.stats.hits > 500);
            if (n == 0) assert_true(first.stats.exact_rays > first.stats.hits); /* neighbours' rays, too */
            uint64_t most = n == 0 ? 0 : 12;                                    /* a halo takes a hundred */
            if (first.stats.thin > most)
                fail_msg("%s, way %d, view %d: %d", equations[n], way, view, (int)first.stats.thin);
            algsurf_scene_free(scene);
        }
        algsurf_surface_free(surface);
    }
}

/* P is small, but not 0. */
static void empty_surfaces_stay_empty(void **state) {
    static const char *const equations[] = {"x^2 + 1/1000000", "(x + y + z)^2 + x^2 + 1/10000000",
                                            "(x^2 + y^2 + z^2 - 1)^2 + 1/10000", "(x - y z)^2 + 1/1000000",
                                            "-(x^2 + y^2)^2 - 1/1000000000"};
    static const double centre[3] = {0, 0, 0};
    const algsurf_extent extent = {ALGSURF_EXTENT_SPHERE, {0, 0, 0}, {1.5, 0, 0}};
    (void)state;
    uint64_t seed = first_seed;
    for (size_t n = 0; n < sizeof equations / sizeof *equations; n++) {
        algsurf_surface *surface = surface_of(equations[n]);
        for (int view = 0; view < views; view++) {
            algsurf_camera camera;
            random_camera(&seed, 7, centre, 20, view % 4 == 3, &camera);
            algsurf_scene *scene = scene_of(surface, &extent, &camera);
            assert_int_equal(algsurf_scene_set_thin(scene, red), ALGSURF_OK);
            draw(scene, view % 2 ? 333 : 200, &first);
            if (first.stats.thin > 0) fail_msg("%s, view %d: %d", equations[n], view, (int)first.stats.thin);
            algsurf_scene_free(scene);
        }
        algsurf_surface_free(surface);
    }
}

/* Where nothing is searched. */
static void out_of_reach_is_as_before(void **state) {
    static const algsurf_extent all = {.kind = ALGSURF_EXTENT_ALL};
    static const algsurf_intersect_options brent = {.size = sizeof brent, .method = ALGSURF_METHOD_BRENT};
    static const algsurf_complex_space space = {.size = sizeof space, .sector = {0, 0.1}};
    (void)state;
    algsurf_camera camera;
    assert_int_equal(algsurf_camera_pinhole((double[]){5.6, -3.2, 1.9}, (double[]){0, 0, 0},
                                            (double[]){0, 0, 1}, 45, &camera),
                     ALGSURF_OK);
    for (int way = 0; way < 5; way++) {
        algsurf_surface *surface = surface_of(way == 3 ? "x^2 z^11 + y^2" : umbrella.equation);
        algsurf_scene *scene = scene_of(surface, way == 0 ? &all : &umbrella.extent, &camera);
        if (way == 1) assert_int_equal(algsurf_scene_set_intersect(scene, &brent), ALGSURF_OK);
        if (way == 2) assert_int_equal(algsurf_scene_set_complex_space(scene, &space), ALGSURF_OK);
        draw(scene, 64, &first);
        assert_int_equal(algsurf_scene_set_thin(scene, red), ALGSURF_OK);
        if (way == 4) { /* no longer wanted */
            draw(scene, 64, &second);
            assert_true(second.stats.thin > 0);
            assert_int_equal(algsurf_scene_set_thin(scene, NULL), ALGSURF_OK);
        }
        draw(scene, 64, &second);
        assert_true(second.stats.thin == 0);
        assert_same(&first, &second);
        algsurf_scene_free(scene);
        algsurf_surface_free(surface);
    }
}

/* ---- the same always ---- */

static void compare_ways(const algsurf_surface *surface, const algsurf_extent *extent,
                         const algsurf_camera *camera, int antialias, double threshold, uint64_t least) {
    enum { SIZE = 150, CUT = 77 };
    algsurf_scene *scene = scene_of(surface, extent, camera);
    assert_int_equal(algsurf_scene_set_thin(scene, red), ALGSURF_OK);
    assert_int_equal(algsurf_scene_set_background(scene, NULL), ALGSURF_OK);
    assert_int_equal(algsurf_scene_set_antialias(scene, antialias), ALGSURF_OK);
    assert_int_equal(algsurf_scene_set_antialias_threshold(scene, threshold), ALGSURF_OK);
    draw(scene, SIZE, &first);
    assert_true(first.stats.thin >= least);
    uint64_t whole = first.stats.thin;
    draw_rows(scene, SIZE, 0, CUT, 1, &second);
    uint64_t upper = second.stats.thin;
    draw_rows(scene, SIZE, CUT, SIZE, 1, &second);
    assert_true(upper + second.stats.thin == whole);
    assert_same(&first, &second);
    draw_rows(scene, SIZE, 0, SIZE, 3, &second);
    assert_true(second.stats.thin == whole);
    assert_same(&first, &second);
    for (int i = 0; algsurf_kernel_name(i); i++) {
        const algsurf_intersect_options how = {.size = sizeof how, .kernel = algsurf_kernel_name(i)};
        assert_int_equal(algsurf_scene_set_intersect(scene, &how), ALGSURF_OK);
        draw(scene, SIZE, &second);
        assert_same(&first, &second);
    }
    algsurf_scene_free(scene);
}

static void nothing_changes_a_byte(void **state) {
    static const char *const names[] = {"whitney", "steiner", "barth"};
    (void)state;
    for (int n = 0; n < 3; n++) {
        const catalogue_entry *entry = catalogue_find(names[n]);
        algsurf_surface *surface = surface_of(entry->equation);
        algsurf_camera camera;
        assert_int_equal(algsurf_camera_pinhole(entry->eye, entry->look_at, entry->up, entry->fov, &camera),
                         ALGSURF_OK);
        uint64_t least = n < 2; /* of points like those of Barth's sextic rays see enough */
        compare_ways(surface, &entry->extent, &camera, 1, 0, least);
        compare_ways(surface, &entry->extent, &camera, 3, 0, least);
        compare_ways(surface, &entry->extent, &camera, 3, 0.1, least);
        algsurf_surface_free(surface);
    }
}

/* A cell of each sample: 4 x 4 of them are a picture with as many times more pixels. */
static void samples_are_finer_pixels(void **state) {
    enum { N = 4, SIZE = 96 };
    (void)state;
    algsurf_surface *surface = surface_of(umbrella.equation);
    algsurf_camera camera;
    assert_int_equal(algsurf_camera_pinhole((double[]){5.6, -3.2, 1.9}, (double[]){0, 0, 0},
                                            (double[]){0.1, 0, 1}, 45, &camera),
                     ALGSURF_OK);
    algsurf_scene *scene = scene_of(surface, &umbrella.extent, &camera);
    assert_int_equal(algsurf_scene_set_thin(scene, red), ALGSURF_OK);
    assert_int_equal(algsurf_scene_set_background(scene, NULL), ALGSURF_OK);
    draw(scene, N * SIZE, &first);
    assert_int_equal(algsurf_scene_set_antialias(scene, N), ALGSURF_OK);
    draw(scene, SIZE, &second);
    assert_true(first.stats.thin == second.stats.thin);
    for (int y = 0; y < SIZE; y++)
        for (int x = 0; x < SIZE; x++) {
            int shown = 0;
            for (int k = 0; k < N * N; k++)
                shown += first.states[(N * y + k / N) * N * SIZE + N * x + k % N] != ALGSURF_MISS;
            assert_int_equal(second.bytes[4 * (y * SIZE + x) + 3], (int)(255.0 * shown / (N * N) + 0.5));
        }
    algsurf_scene_free(scene);
    algsurf_surface_free(surface);
}

int main(int argc, char **argv) {
    if (argc > 1) views = atoi(argv[1]);
    if (argc > 2) first_seed = strtoull(argv[2], NULL, 0);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(thin_parts_are_drawn),          cmocka_unit_test(undecided_places_hide_nothing),
        cmocka_unit_test(smooth_surfaces_are_as_before), cmocka_unit_test(edges_have_no_halo),
        cmocka_unit_test(empty_surfaces_stay_empty),     cmocka_unit_test(out_of_reach_is_as_before),
        cmocka_unit_test(nothing_changes_a_byte),        cmocka_unit_test(samples_are_finer_pixels)};
    return cmocka_run_group_tests_name("thin", tests, NULL, NULL);
}
