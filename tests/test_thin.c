/* test_thin.c - what is thin is drawn, all of it, a pixel wide, and nothing else.
 *
 * Which surfaces have thin parts is known.  An isolated point is one dot, wherever in the lattice of pixels
 * it is; a line without sheets shows, in each column it passes (or row, if it is steep), the pixel that it
 * passes there, or what hides it; nothing else is thin.  Surfaces without thin parts have none: smooth ones,
 * cones, double sheets, edges, from random eyes, far, near and at silhouettes.  Slices, threads and kernels
 * do not change a byte.
 *
 * Breaks tried, each caught by the test named:
 *   points_are_one_dot: no longer steps where P is like a power; pixels that are closed on both sides
 *   lines_are_a_pixel_wide: lines that are not followed to the pixel's column; a sheet's test that takes flat
 *       directions for sheets; places that are only looked for where rays miss
 *   curves_have_no_gaps: lines that are not followed where tangents seem curved on the way
 *   others_have_nothing_thin: no test of the gradient; of cones; of sheets; of what is behind
 *
 *     test_thin [views [seed]]
 */
#include "catalogue.h"
#include "scenes.h"

enum { MOST = 1024 };

ARGUMENT(1, int, views, 6)
ARGUMENT(2, uint64_t, first_seed, 20261125)

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
    assert_ok(algsurf_render(scene, &o, &planes, &to->stats));
}

static void draw(const algsurf_scene *scene, int size, image *to) { draw_rows(scene, size, 0, 0, 1, to); }

static void assert_same(const image *a, const image *b) {
    size_t count = (size_t)a->size * (size_t)a->size;
    assert_memory_equal(a->bytes, b->bytes, 4 * count);
    assert_memory_equal(a->t, b->t, count * sizeof *a->t);
    assert_memory_equal(a->normals, b->normals, 3 * count * sizeof *a->normals);
    assert_memory_equal(a->states, b->states, count);
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
    double deep = dot(from_eye, camera->forward),
           shrunk = camera->kind == ALGSURF_CAMERA_ORTHOGRAPHIC ? 1 : deep;
    return (place){0.5 * size + scale * dot(from_eye, camera->right) / shrunk,
                   0.5 * size - scale * dot(from_eye, camera->up) / shrunk,
                   camera->kind == ALGSURF_CAMERA_ORTHOGRAPHIC ? deep : sqrt(dot(from_eye, from_eye)),
                   shrunk / scale};
}

static void random_camera(uint64_t *seed, double far, const double look[3], double fov, int parallel,
                          algsurf_camera *camera) {
    double eye[3], up[3], length = 0;
    for (int i = 0; i < 3; i++) {
        eye[i] = random_unit(seed);
        up[i] = random_unit(seed);
        length += eye[i] * eye[i];
    }
    for (int i = 0; i < 3; i++) eye[i] = look[i] + far * eye[i] / sqrt(length);
    if (parallel)
        assert_ok(algsurf_camera_orthographic(eye, look, up, 2 * far * tan(fov / 114.6), camera));
    else
        assert_ok(algsurf_camera_pinhole(eye, look, up, fov, camera));
}

static int is_drawn(int state) { return state == ALGSURF_STATE_THIN || state == ALGSURF_STATE_HIT; }

TEST(points_are_one_dot) {
    static const struct {
        const char *equation;
        double at[3];
    } points[] = {{"x^2 + y^2 + z^2", {0, 0, 0}},
                  {"x^4 + y^2 + z^2", {0, 0, 0}},
                  {"x^4 + y^4 + z^2", {0, 0, 0}},
                  {"(x-1)^4 + y^2 + z^2", {1, 0, 0}},
                  {"x^4 + 3 y^4 + z^4", {0, 0, 0}},
                  {"x^6 + y^2 + 2 z^2", {0, 0, 0}},
                  {"-x^2 - 5 (y-1)^2 - z^4", {0, 1, 0}},
                  {"x^2 + y^2 + (z^2-x)^2", {0, 0, 0}},
                  {"x^2 + y^2 + (x-y)^2 + z^4 - 2 z^2 x", {0, 0, 0}}};
    static const int sizes[] = {16, 65, 200, 300};
    const algsurf_extent extent = {ALGSURF_EXTENT_SPHERE, {0, 0, 0}, {2, 0, 0}};
    uint64_t seed = first_seed;
    int lost = 0, all = 0;
    for (size_t n = 0; n < sizeof points / sizeof *points; n++) {
        algsurf_surface *surface = surface_of(points[n].equation);
        for (int view = 0; view < 4 * views; view++) {
            const int size = sizes[view % 4];
            double look[3]; /* in the middle of a pixel or between four, or anywhere */
            for (int i = 0; i < 3; i++) look[i] = points[n].at[i] + (view < 8 ? 0 : 0.5 * random_unit(&seed));
            algsurf_camera camera;
            random_camera(&seed, view % 3 ? 7 : 40, look, view % 3 ? 40 : 6, view % 5 == 4, &camera);
            algsurf_scene *scene = scene_of(surface, &extent, &camera, NULL);
            assert_ok(algsurf_scene_set_thin(scene, red));
            draw(scene, size, &first);
            const place p = place_of(&camera, size, points[n].at);
            int dots = 0, near = 0;
            for (int i = 0; i < size * size; i++) {
                if (!is_drawn(first.states[i])) continue;
                dots++;
                near += fabs(i % size + 0.5 - p.x) < 0.52 && fabs(i / size + 0.5 - p.y) < 0.52;
            }
            lost += dots != 1, all++; /* or in both of the pixels whose border it is next to */
            if ((dots != 1 || near != 1) && !(random_salt && dots == near && dots <= 2))
                fail_msg("%s, view %d: %d dots, %d near %a,%a", points[n].equation, view, dots, near, p.x,
                         p.y);
        }
    }
    assert_true(lost * 100 <= all);
}

/* A line: the points from + s along, 0 <= s <= 1. */
typedef struct part {
    double from[3], along[3];
} part;

typedef struct thin_surface {
    const char *equation;
    algsurf_extent extent;
    int least, count; /* size of a picture that is fine enough; lines */
    part parts[6];
} thin_surface;

static const thin_surface lines[] = {
    {"x^2 z + y^2", {ALGSURF_EXTENT_SPHERE, {0, 0, 0}, {2, 0, 0}}, 0, 1, {{{0, 0, 0.1}, {0, 0, 1.85}}}},
    {"y^6 + z^6", {ALGSURF_EXTENT_SPHERE, {0, 0, 0}, {2, 0, 0}}, 0, 1, {{{-1.95, 0, 0}, {3.9, 0, 0}}}},
    {"(y-1)^2 + 3 (z-1/2)^2",
     {ALGSURF_EXTENT_SPHERE, {0, 0, 0}, {2, 0, 0}},
     0,
     1,
     {{{-1.6, 1, 0.5}, {3.2, 0, 0}}}},
    {"x^4 y^2 + x^2 y^4 - x^2 y^2 + z^6",
     {ALGSURF_EXTENT_BOX, {0, 0, 0}, {2, 2, 2}},
     300,
     4,
     {{{1.25, 0, 0}, {0.5, 0, 0}},
      {{-1.25, 0, 0}, {-0.5, 0, 0}},
      {{0, 1.25, 0}, {0, 0.5, 0}},
      {{0, -1.25, 0}, {0, -0.5, 0}}}},
    {"x^2 y^2 + x^2 z^2 + y^2 z^2 + x y z",
     {ALGSURF_EXTENT_BOX, {0, 0, 0}, {0.8, 0.9, 1}},
     0,
     6,
     {{{0.53, 0, 0}, {0.25, 0, 0}},
      {{-0.53, 0, 0}, {-0.25, 0, 0}},
      {{0, 0.53, 0}, {0, 0.35, 0}},
      {{0, -0.53, 0}, {0, -0.35, 0}},
      {{0, 0, 0.53}, {0, 0, 0.45}},
      {{0, 0, -0.53}, {0, 0, -0.45}}}}};

/* Where a line is seen in the middle of column c, or row c. */
static place cross(const algsurf_camera *camera, int size, const part *l, int steep, double c) {
    double lo = 0, hi = 1, point[3];
    place p = {0};
    for (int turn = 0; turn < 60; turn++) {
        double s = 0.5 * (lo + hi);
        for (int i = 0; i < 3; i++) point[i] = l->from[i] + s * l->along[i];
        p = place_of(camera, size, point);
        const place end = place_of(camera, size, l->from);
        double at = steep ? p.y : p.x, from = steep ? end.y : end.x;
        if (fabs(at - from) < fabs(c - from))
            lo = s;
        else
            hi = s;
    }
    return p;
}

/* Is the line seen in a pixel, or hidden there? */
static int shows_line(const image *of, int x, int y, const place *p) {
    if (x < 0 || y < 0 || x >= of->size || y >= of->size) return 1;
    const int i = y * of->size + x;
    return (of->states[i] == ALGSURF_STATE_THIN && of->t[i] < p->t + 8 * p->pixel) ||
           (of->states[i] == ALGSURF_STATE_HIT && of->t[i] < p->t + 8 * p->pixel);
}

static int gaps; /* one in thousands of pixels, where surfaces and lines are a pixel apart */

/* Returns how many columns, or rows, were looked at; -1: the line is seen from its end. */
static int check_line(const algsurf_camera *camera, const part *l, const char *equation, const image *of) {
    const double end[3] = {l->from[0] + l->along[0], l->from[1] + l->along[1], l->from[2] + l->along[2]};
    const place a = place_of(camera, of->size, l->from), b = place_of(camera, of->size, end);
    const int steep = fabs(b.y - a.y) > fabs(b.x - a.x);
    const double from = steep ? a.y : a.x, to = steep ? b.y : b.x;
    if (sqrt(dot(l->along, l->along)) > 3 * a.pixel * fabs(to - from)) return -1; /* seen from its end */
    const int first_column = (int)ceil(fmax(fmin(from, to) + 0.5, 0)),
              last = (int)fmin(fmax(from, to) - 1.5, of->size - 1);
    for (int c = first_column; c <= last; c++) {
        const place p = cross(camera, of->size, l, steep, c + 0.5);
        const double across = steep ? p.x : p.y, at = floor(across), rest = across - at;
        const int k = (int)at;
        int shown = steep ? shows_line(of, k, c, &p) : shows_line(of, c, k, &p);
        if (!shown && rest < 0.05)
            shown = steep ? shows_line(of, k - 1, c, &p) : shows_line(of, c, k - 1, &p);
        if (!shown && rest > 0.95)
            shown = steep ? shows_line(of, k + 1, c, &p) : shows_line(of, c, k + 1, &p);
        if (!shown && !random_salt)
            fail_msg("%s, size %d: nothing at pixel %.3f,%.3f", equation, of->size, p.x, p.y);
        gaps += !shown;
    }
    return last >= first_column ? last - first_column + 1 : 0;
}

TEST(lines_are_a_pixel_wide) {
    static const int sizes[] = {64, 101, 300, 640};
    static const double centre[3] = {0, 0, 0}, beside[3] = {2, 0, 0};
    uint64_t seed = first_seed;
    int columns_seen = 0;
    for (size_t n = 0; n < sizeof lines / sizeof *lines; n++) {
        algsurf_surface *surface = surface_of(lines[n].equation);
        for (int view = 0; view < 2 * views; view++) {
            algsurf_camera camera;
            const int size = sizes[view % 4] < lines[n].least ? lines[n].least : sizes[view % 4];
            random_camera(&seed, view % 3 == 2 ? 60 : 7, view % 4 == 1 ? beside : centre,
                          view % 3 == 2 ? 5 : 50, view % 5 == 4, &camera);
            if (view == 0)
                assert_ok(
                    algsurf_camera_pinhole((double[]){2, -5, 0}, beside, (double[]){0, 0, 1}, 60, &camera));
            if (view == 3)
                assert_ok(
                    algsurf_camera_pinhole((double[]){0, -6, 0}, centre, (double[]){0, 0, 1}, 50, &camera));
            algsurf_scene *scene = scene_of(surface, &lines[n].extent, &camera, NULL);
            assert_ok(algsurf_scene_set_thin(scene, red));
            draw(scene, size, &first);
            int length = 0, from_end = 0;
            for (int i = 0; i < lines[n].count; i++) {
                int columns = check_line(&camera, lines[n].parts + i, lines[n].equation, &first);
                from_end |= columns < 0;
                length += columns;
                columns_seen += columns;
            }
            /* a pixel in each, and a few where lines begin and end */
            if (!from_end && (int)first.stats.thin > length + 24 + length)
                fail_msg("%s, view %d: %d thin, length %d", lines[n].equation, view, (int)first.stats.thin,
                         length);
        }
    }
    assert_true(gaps * 1000 <= columns_seen);
}

/* Behind a place where it is undecided what a ray hits: the rays of the middle column touch the line x = y =
 * 0, which doubles do not decide, and what stands for it is the middle of the chord, before the line. */
TEST(undecided_places_hide_nothing) {
    enum { SIZE = 65 };
    static const algsurf_extent extent = {ALGSURF_EXTENT_SPHERE, {1.5, 0, 0}, {2, 0, 0}};
    algsurf_surface *surface = surface_of("x^2 + y^2");
    algsurf_camera camera;
    assert_ok(
        algsurf_camera_pinhole((double[]){9, 0, 0}, (double[]){0, 0, 0}, (double[]){0, 0, 1}, 25, &camera));
    for (int as = ALGSURF_AS_UNDECIDED; as <= ALGSURF_AS_MISS; as++) {
        const algsurf_intersect_options how = {
            .size = sizeof how, .tier = ALGSURF_TIER_BOUNDED, .undecided_as = as};
        algsurf_scene *scene = scene_of(surface, &extent, &camera, NULL);
        assert_ok(algsurf_scene_set_intersect_options(scene, &how));
        draw(scene, SIZE, &first);
        assert_true(first.stats.undecided + first.stats.hits > 40 || as == ALGSURF_AS_MISS);
        assert_ok(algsurf_scene_set_thin(scene, red));
        draw(scene, SIZE, &second);
        assert_true(second.stats.thin > 40);
        for (size_t i = 0; i < SIZE * SIZE; i++) {
            assert_true(first.states[i] == ALGSURF_STATE_MISS || second.states[i] == ALGSURF_STATE_THIN);
            assert_true(second.states[i] == ALGSURF_STATE_MISS || fabs(second.t[i] - 9) < 0.3);
        }
    }
}

/* A closed curve has no ends: each of its pixels has two neighbours, but for one or two where it turns.  Of
 * other views than those here one in 200 or so has a pixel less than that. */
TEST(curves_have_no_gaps) {
    enum { SIZE = 300 };
    const algsurf_extent extent = {ALGSURF_EXTENT_SPHERE, {0, 0, 0}, {2, 0, 0}};
    static const double centre[3] = {0, 0, 0.4};
    uint64_t seed = first_seed;
    algsurf_surface *surface = surface_of("(x^2 + y^2 - 1)^2 + (z - x^2)^2");
    for (int view = 0; view < 2 * views; view++) {
        algsurf_camera camera;
        random_camera(&seed, 7, centre, 25, view % 5 == 4, &camera);
        algsurf_scene *scene = scene_of(surface, &extent, &camera, NULL);
        assert_ok(algsurf_scene_set_thin(scene, red));
        draw(scene, SIZE, &first);
        int ends = 0;
        for (int y = 1; y < SIZE - 1; y++)
            for (int x = 1; x < SIZE - 1; x++) {
                int near = 0;
                for (int k = 0; k < 9; k++)
                    near += is_drawn(first.states[(y + k / 3 - 1) * SIZE + x + k % 3 - 1]);
                ends += is_drawn(first.states[y * SIZE + x]) && near < 3;
            }
        assert_true(first.stats.thin > SIZE / 2);
        if (ends > (random_salt ? 4 : 2)) fail_msg("view %d: %d ends", view, ends);
    }
}

/* ---- what is not ---- */

TEST(others_have_nothing_thin) {
    static const char *const equations[] = {"x^2 + y^2 + z^2 - 1",
                                            "x^2 + y^2 - 1",
                                            "x^2 + y^2 - z^2",
                                            "(x^2 + y^2 + z^2 + 9/16 - 1/16)^2 - 9/4 (x^2 + y^2)",
                                            "z^2",
                                            "(x + y + z)^6",
                                            "(x^2 + y^2 + z^2 - 1)^2",
                                            "(x + y + z)^12",
                                            "(x^2 + y^2 + z^2 - 1)^6",
                                            "x^2 + 1/1000000",
                                            "(x + y + z)^2 + x^2 + 1/10000000",
                                            "(x - y z)^2 + 1/1000000",
                                            "z^3 + x z + y"};
    static const char *const names[] = {"barth", "chair", "tangle", "boy", "torus", "pillow", "bicube"};
    static const double distances[] = {1.7, 3, 5, 40};
    const size_t own = sizeof equations / sizeof *equations, all = own + sizeof names / sizeof *names;
    uint64_t seed = first_seed;
    for (size_t n = 0; n < all; n++) {
        const catalogue_entry *entry = n < own ? NULL : catalogue_find(names[n - own]);
        const algsurf_extent extent =
            entry ? entry->extent : (algsurf_extent){ALGSURF_EXTENT_SPHERE, {0, 0, 0}, {2, 0, 0}};
        const char *equation = entry ? entry->equation : equations[n];
        algsurf_surface *surface = surface_of(equation);
        const int slow = n >= 4 && n <= 8; /* integers */
        for (int view = 0; view < (slow ? 2 : 2 * views); view++) {
            double look[3], radius = extent.size[0], far = distances[view % 4] * radius;
            algsurf_camera camera;
            for (int i = 0; i < 3; i++)
                look[i] = extent.centre[i] + (view % 3 ? 0.5 * radius * random_unit(&seed) : 0);
            random_camera(&seed, far, look, 114.6 * atan(fmin(1.1 * radius / far, 1)), view % 7 == 6,
                          &camera);
            algsurf_scene *scene = scene_of(surface, &extent, &camera, NULL);
            assert_ok(algsurf_scene_set_thin(scene, red));
            draw(scene, slow ? 60 : view % 2 ? 333 : 150, &first);
            if (first.stats.thin > 0) fail_msg("%s, view %d: %d", equation, view, (int)first.stats.thin);
        }
    }
}

/* A small sphere in a large extent, seen from near and far. */
TEST(small_things_are_not_thin) {
    const algsurf_extent extent = {ALGSURF_EXTENT_SPHERE, {0, 0, 0}, {1e6, 0, 0}};
    static const double centre[3] = {0, 0, 0};
    uint64_t seed = first_seed;
    algsurf_surface *surface = surface_of("x^2 + y^2 + z^2 - 1");
    for (int view = 0; view < 2 * views; view++) {
        algsurf_camera camera;
        const double far = view % 2 ? 4 : 1000;
        random_camera(&seed, far, centre, 114.6 * atan(1.2 / far), view % 3 == 2, &camera);
        algsurf_scene *scene = scene_of(surface, &extent, &camera, NULL);
        assert_ok(algsurf_scene_set_thin(scene, red));
        draw(scene, 300, &first);
        if (first.stats.thin > 0) fail_msg("view %d: %d", view, (int)first.stats.thin);
    }
}

/* Where nothing is searched. */
TEST(out_of_reach_is_as_before) {
    static const algsurf_extent all = {.kind = ALGSURF_EXTENT_ALL};
    static const algsurf_intersect_options brent = {.size = sizeof brent, .method = ALGSURF_METHOD_BRENT};
    static const algsurf_complex_space space = {.size = sizeof space, .sector = {0, 0.1}};
    algsurf_camera camera;
    assert_ok(algsurf_camera_pinhole((double[]){5.6, -3.2, 1.9}, (double[]){0, 0, 0}, (double[]){0, 0, 1}, 45,
                                     &camera));
    for (int way = 0; way < 5; way++) {
        algsurf_surface *surface = surface_of(way == 3 ? "x^2 z^23 + y^2" : lines[0].equation);
        algsurf_scene *scene = scene_of(surface, way == 0 ? &all : &lines[0].extent, &camera, NULL);
        if (way == 1) assert_ok(algsurf_scene_set_intersect_options(scene, &brent));
        if (way == 2) assert_ok(algsurf_scene_set_complex_space(scene, &space));
        draw(scene, 64, &first);
        assert_ok(algsurf_scene_set_thin(scene, red));
        if (way == 4) { /* no longer wanted */
            draw(scene, 64, &second);
            assert_true(second.stats.thin > 0);
            assert_ok(algsurf_scene_set_thin(scene, NULL));
        }
        draw(scene, 64, &second);
        assert_true(second.stats.thin == 0);
        assert_same(&first, &second);
    }
}

/* ---- the same always ---- */

static void compare_ways(const algsurf_surface *surface, const algsurf_extent *extent,
                         const algsurf_camera *camera, int antialias, double threshold, uint64_t least) {
    enum { SIZE = 150, CUT = 77 };
    algsurf_scene *scene = scene_of(surface, extent, camera, NULL);
    assert_ok(algsurf_scene_set_thin(scene, red));
    assert_ok(algsurf_scene_set_background(scene, NULL));
    assert_ok(algsurf_scene_set_antialias(scene, antialias));
    assert_ok(algsurf_scene_set_antialias_threshold(scene, threshold));
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
        assert_ok(algsurf_scene_set_intersect_options(scene, &how));
        draw(scene, SIZE, &second);
        assert_same(&first, &second);
    }
}

TEST(nothing_changes_a_byte) {
    static const char *const names[] = {"whitney", "steiner", "barth"};
    for (int n = 0; n < 3; n++) {
        const catalogue_entry *entry = catalogue_find(names[n]);
        algsurf_surface *surface = surface_of(entry->equation);
        algsurf_camera camera = pinhole_of(entry->eye, entry->look_at, entry->up, entry->fov);
        uint64_t least = n < 2; /* of points like those of Barth's sextic rays see enough */
        compare_ways(surface, &entry->extent, &camera, 1, 0, least);
        compare_ways(surface, &entry->extent, &camera, 3, 0, least);
        compare_ways(surface, &entry->extent, &camera, 3, 0.1, least);
    }
}

/* Of a steep line alone, in the middle of a row: how many pixels it seems wide, and where. */
static void measure_row(const image *of, int y, double *width, double *at) {
    *width = *at = 0;
    for (int x = 0; x < of->size; x++) {
        const double share = of->bytes[4 * (y * of->size + x) + 3] / 255.0;
        *width += share;
        *at += share * (x + 0.5);
    }
    *at /= *width;
}

/* Many samples a pixel show a line a pixel wide, smoothly: to a sample's width. */
TEST(samples_make_lines_smooth) {
    enum { SIZE = 200, END = 12 };
    static const int sides[] = {2, 4, 9};
    const thin_surface *l = &lines[2];
    uint64_t seed = first_seed;
    algsurf_surface *surface = surface_of(l->equation);
    for (int view = 0; view < 2 * views; view++) {
        const int n = sides[view % 3];
        const double slope = 0.9 * random_unit(&seed), eye[3] = {2 * slope, -7, 3};
        algsurf_camera camera = pinhole_of(eye, (double[]){0, 1, 0.5}, (double[]){1, 0, slope}, 40);
        algsurf_scene *scene = scene_of(surface, &l->extent, &camera, NULL);
        assert_ok(algsurf_scene_set_thin(scene, red));
        assert_ok(algsurf_scene_set_background(scene, NULL));
        assert_ok(algsurf_scene_set_antialias(scene, n));
        for (int adaptive = 0; adaptive < 2; adaptive++) {
            assert_ok(algsurf_scene_set_antialias_threshold(scene, 0.1 * adaptive));
            draw(scene, SIZE, &first);
            const double end[3] = {l->parts[0].from[0] + l->parts[0].along[0], l->parts[0].from[1],
                                   l->parts[0].from[2]};
            const place a = place_of(&camera, SIZE, l->parts[0].from), b = place_of(&camera, SIZE, end);
            int rows = 0;
            for (int y = (int)fmin(a.y, b.y) + END; y < fmin(fmax(a.y, b.y), SIZE) - END; y++, rows++) {
                double width, at;
                const place p = cross(&camera, SIZE, &l->parts[0], 1, y + 0.5);
                measure_row(&first, y, &width, &at);
                if (!(fabs(width - 1) < 1.2 / n && fabs(at - p.x) < 0.7 / n))
                    fail_msg("%d samples, view %d, row %d: %.3f wide at %.3f, not %.3f", n, view, y, width,
                             at, p.x);
            }
            assert_true(rows > SIZE / 4);
        }
    }
}

/* The light of what is thin: as a tube has it that lies along the line, from above and from below. */
TEST(lines_are_lit) {
    enum { SIZE = 64 }; /* the line is seen between two rows: no ray meets it */
    algsurf_surface *surface = surface_of("y^2 + z^2");
    const algsurf_extent extent = {ALGSURF_EXTENT_SPHERE, {0, 0, 0}, {2, 0, 0}};
    const algsurf_material plain = {
        .size = sizeof plain, .outside = {0, 1, 0}, .inside = {0, 1, 0}, .diffuse = 1, .roughness = 0.5};
    algsurf_camera camera;
    assert_ok(
        algsurf_camera_pinhole((double[]){0, -9, 0}, (double[]){0, 0, 0}, (double[]){0, 0, 1}, 25, &camera));
    algsurf_scene *scene = scene_of(surface, &extent, &camera, NULL);
    assert_ok(algsurf_scene_set_thin(scene, red));
    assert_ok(algsurf_scene_set_material(scene, &plain));
    const double at[3][3] = {{0, -40, 0}, {0, -40, 40}, {0, 40, 0}}; /* before it, higher, behind */
    int brightness[3];
    for (int i = 0; i < 3; i++) {
        algsurf_light light = {.colour = {1, 1, 1}};
        algsurf_lighting lighting = {.size = sizeof lighting};
        algsurf_light room[ALGSURF_MAX_LIGHTS];
        double colour[3];
        unsigned char bytes[3];
        memcpy(light.position, at[i], sizeof at[i]);
        assert_ok(algsurf_scene_set_lights(scene, &light, 1));
        draw(scene, SIZE, &first);
        const int upper = (SIZE / 2 - 1) * SIZE + SIZE / 2,
                  middle = first.states[upper] == ALGSURF_STATE_THIN ? upper : upper + SIZE;
        const uint8_t *pixel = first.bytes + 4 * middle;
        assert_int_equal(first.states[middle], ALGSURF_STATE_THIN);
        assert_ok(algsurf_scene_get_lighting(scene, room, &lighting));
        algsurf_material material = *lighting.material;
        memcpy(material.outside, red, sizeof red);
        lighting.material = &material;
        assert_ok(algsurf_shade(&lighting, NULL, (double[]){0, 0, 0}, (double[]){0, -1, 0},
                                (double[]){0, 1, 0}, colour));
        assert_ok(algsurf_srgb_encode(colour, bytes));
        for (int k = 0; k < 3; k++) assert_in_range(pixel[k] - bytes[k] + 1, 0, 2);
        brightness[i] = pixel[0];
    }
    assert_true(brightness[0] > brightness[1] + 10 && brightness[1] > brightness[2] + 10);
}
