/* test_render_tiles.c - pictures by tiles against pictures ray by ray, for all named surfaces.
 *
 * Slices of high pictures: there pixels are small enough for tiles up to degree 10.  A third of them is cut
 * by planes.  The reference is the same scene with another method of refinement, which takes every ray
 * through algsurf_intersect_first.  No pixel may differ, nor its t by more than render.h allows: 2^-36 of the
 * extent's radius, or what rounding makes of a zero of P there; and neither slices, threads nor kernels may
 * change a byte, with one sample a pixel or more.
 *
 *     test_render_tiles [views [seed]]
 */
#include "catalogue.h"
#include "scenes.h"

enum { WIDTH = 250, HEIGHT = 2000, ROWS = 37, TILED_DEGREE = 10 };

static int views = 6;
static uint64_t first_seed = 20261124;

typedef struct slice {
    uint8_t bytes[ROWS * WIDTH * 4];
    double t[ROWS * WIDTH];
    float normals[ROWS * WIDTH * 3];
    unsigned char states[ROWS * WIDTH], ways[ROWS * WIDTH];
} slice;

typedef struct view {
    const catalogue_entry *entry;
    int number, row;
    algsurf_surface *surface;
    algsurf_extent extent;
    algsurf_camera camera;
    algsurf_plane planes[2];
    size_t plane_count;
    uint64_t seed;
} view;

/* Through about the middle of what is shown. */
static void set_planes(view *v) {
    v->plane_count = v->number % 3 == 2 ? 1 + (size_t)random_int(&v->seed, 2) : 0;
    for (size_t k = 0; k < v->plane_count; k++) {
        algsurf_plane *p = &v->planes[k];
        p->offset = 0.3 * v->entry->extent.size[0] * random_unit(&v->seed);
        for (int i = 0; i < 3; i++) {
            p->normal[i] = random_unit(&v->seed);
            p->offset += p->normal[i] * v->extent.centre[i];
        }
    }
}

/* Near, far and inside; parallel and not; balls and boxes; at the centre, past it, and close to it. */
static void set_view(view *v) {
    static const double distances[] = {0.6, 2, 4, 40, 1e4};
    double radius = v->entry->extent.size[0], far = distances[v->number % 5] * radius, eye[3], look[3], up[3],
           length = 0, zoom = v->number % 4 == 2 ? 0.05 : 1;
    v->extent = v->entry->extent;
    for (int i = 0; i < 3; i++) {
        eye[i] = random_unit(&v->seed);
        up[i] = random_unit(&v->seed);
        length += eye[i] * eye[i];
    }
    for (int i = 0; i < 3; i++) {
        look[i] = v->extent.centre[i] + (v->number % 3 ? 0.6 * radius * random_unit(&v->seed) : 0);
        eye[i] = v->extent.centre[i] + far * eye[i] / sqrt(length);
    }
    if (v->number % 3 == 1) {
        v->extent.kind = ALGSURF_EXTENT_BOX;
        for (int i = 0; i < 3; i++) v->extent.size[i] = radius * (0.5 + 0.1 * i);
    }
    if (v->number % 2)
        assert_ok(algsurf_camera_orthographic(eye, look, up, 2.2 * zoom * radius, &v->camera));
    else
        assert_ok(algsurf_camera_pinhole(eye, look, up, 2 * atan(zoom * fmin(1.1 * radius / far, 1)) * 57.3,
                                         &v->camera));
    set_planes(v);
    v->row = HEIGHT / 2 - ROWS + random_int(&v->seed, ROWS);
}

static algsurf_scene *scene_with(const view *v, const algsurf_intersect_options *how, int antialias,
                                 double threshold) {
    algsurf_scene *scene = scene_of(v->surface, &v->extent, &v->camera, how);
    assert_ok(algsurf_scene_set_clip(scene, v->planes, v->plane_count));
    assert_ok(algsurf_scene_set_antialias(scene, antialias));
    if (threshold > 0) assert_ok(algsurf_scene_set_antialias_threshold(scene, threshold));
    return scene;
}

/* Rows from `begin` to end - 1 of the slice. */
static void draw(const view *v, const algsurf_scene *scene, int begin, int end, int threads, slice *s) {
    size_t first = (size_t)begin * WIDTH;
    const algsurf_picture planes = {.size = sizeof planes,
                                    .pixels = s->bytes + 4 * first,
                                    .format = ALGSURF_RGBA8,
                                    .t = s->t + first,
                                    .normals = s->normals + 3 * first,
                                    .state = s->states + first,
                                    .way = s->ways + first};
    const algsurf_render_options o = {.size = sizeof o,
                                      .width = WIDTH,
                                      .height = HEIGHT,
                                      .row_begin = v->row + begin,
                                      .row_end = v->row + end,
                                      .threads = threads};
    assert_ok(algsurf_render(scene, &o, &planes, NULL));
}

static long hits, misses;

static void check_pixel(const view *v, int i, const slice *tiles, const slice *rays) {
    algsurf_ray ray;
    double t = tiles->t[i];
    int same = tiles->states[i] == rays->states[i];
    assert_ok(algsurf_camera_ray(&v->camera, WIDTH, HEIGHT, i % WIDTH + 0.5, v->row + i / WIDTH + 0.5, &ray));
    hits += isfinite(t), misses += isinf(t) != 0;
    double apart = same && isfinite(t) ? fabs(t - rays->t[i]) : 0;
    if (apart > 0x1p-36 * v->entry->extent.size[0]) same = is_zero(v->surface, &ray, t) && apart < 1e-6 * t;
    if (!same)
        fail_msg("%s, view %d (seed %#llx), pixel %d,%d: state %d, not %d; t = %a, not %a", v->entry->name,
                 v->number, (unsigned long long)first_seed, i % WIDTH, v->row + i / WIDTH, tiles->states[i],
                 rays->states[i], t, rays->t[i]);
}

static void compare_with_rays(view *v) {
    static slice tiles, rays;
    const algsurf_intersect_options by_rays = {.size = sizeof by_rays, .method = ALGSURF_METHOD_BRENT};
    algsurf_scene *scene = scene_with(v, NULL, 1, 0), *other = scene_with(v, &by_rays, 1, 0);
    draw(v, scene, 0, ROWS, 1, &tiles);
    draw(v, other, 0, ROWS, 1, &rays);
    for (int i = 0; i < ROWS * WIDTH; i++) check_pixel(v, i, &tiles, &rays);
}

/* One sample, all pixels with several, edges only: by slices, threads and kernels. */
static void compare_with_others(view *v) {
    static slice whole, other;
    for (int way = 0; way < 3; way++) {
        algsurf_scene *scene = scene_with(v, NULL, way ? 3 : 1, way == 2 ? 0.05 : 0);
        memset(&whole, 0, sizeof whole), memset(&other, 0, sizeof other);
        draw(v, scene, 0, ROWS, 1, &whole);
        int cut = 1 + random_int(&v->seed, ROWS - 1);
        draw(v, scene, 0, cut, 1, &other), draw(v, scene, cut, ROWS, 1, &other);
        assert_memory_equal(&whole, &other, sizeof whole);
        draw(v, scene, 0, ROWS, 3, &other);
        assert_memory_equal(&whole, &other, sizeof whole);
        for (int i = 0; algsurf_kernel_name(i); i++) {
            const algsurf_intersect_options how = {.size = sizeof how, .kernel = algsurf_kernel_name(i)};
            scene = scene_with(v, &how, way ? 3 : 1, way == 2 ? 0.05 : 0);
            draw(v, scene, 0, ROWS, 1, &other);
            assert_memory_equal(&whole, &other, sizeof whole);
        }
    }
}

/* Of every named surface that is drawn by tiles. */
static void for_each_view(void (*check)(view *v), int count) {
    for (const catalogue_entry *entry = catalogue; entry->name; entry++) {
        view v = {.entry = entry, .seed = first_seed + (uint64_t)(entry - catalogue)};
        if (entry->degree > TILED_DEGREE || catalogue_first_of(entry) != entry) continue;
        v.surface = surface_of(entry->equation);
        for (v.number = 0; v.number < count; v.number++) {
            set_view(&v);
            check(&v);
        }
    }
}

TEST(hits_as_by_rays) {
    for_each_view(compare_with_rays, views);
    printf("%ld hits, %ld misses\n", hits, misses);
    assert_true(hits * 4 > misses && misses * 10 > hits);
}

TEST(nothing_changes_a_byte) { for_each_view(compare_with_others, (views + 2) / 3); }

int main(int argc, char **argv) {
    if (argc > 1) views = atoi(argv[1]);
    if (argc > 2) first_seed = strtoull(argv[2], NULL, 0);
    return unit_run("tiles");
}
