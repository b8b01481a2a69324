/* render_case.h - a small picture of a torus, for the tests of the room render. */
#ifndef RENDER_CASE_H
#define RENDER_CASE_H
#include "algsurf/algsurf.h"
#include "scenes.h"

#define W 44
#define H 33
#define STRIDE (3 * W + 5)
#define SENTINEL 0x5a

typedef struct picture {
    uint8_t bytes[H * STRIDE];
    double hits[H * W];
    float normals[H * W * 3];
    unsigned char states[H * W], ways[H * W];
    algsurf_render_stats stats;
} picture;

/* All planes of a picture, from a row on. */
static inline algsurf_picture planes_of(picture *p, int row) {
    size_t first = (size_t)row;
    return (algsurf_picture){.size = sizeof(algsurf_picture),
                             .pixels = p->bytes + first * STRIDE,
                             .stride = STRIDE,
                             .t = p->hits + first * W,
                             .normals = p->normals + first * W * 3,
                             .state = p->states + first * W,
                             .way = p->ways + first * W};
}

static const double origin[3] = {0, 0, 0}, z_up[3] = {0, 0, 1};
static const algsurf_extent ball = {ALGSURF_EXTENT_SPHERE, {0, 0, 0}, {3.2, 0, 0}};
static const algsurf_material plain = {.size = sizeof plain,
                                       .outside = {0.9, 0.5, 0.3},
                                       .inside = {0.2, 0.4, 0.8},
                                       .diffuse = 0.6,
                                       .ambient = 0.2,
                                       .fill = 0.15,
                                       .specular = 0.4,
                                       .roughness = 0.25,
                                       .haze = 0.3};

static inline algsurf_surface *torus(void) { return surface_of("(x^2+y^2+z^2+3.51)^2 - 16(x^2+y^2)"); }

static inline algsurf_camera camera_at(double x, double y, double z, double fov) {
    const double eye[3] = {x, y, z};
    return pinhole_of(eye, origin, z_up, fov);
}

static inline algsurf_scene *torus_scene(const algsurf_surface *surface, algsurf_quality quality,
                                         int antialias) {
    algsurf_camera camera = camera_at(7, 4, 5, 36);
    algsurf_scene *scene = scene_of(surface, &ball, &camera, NULL);
    assert_ok(algsurf_scene_set_quality(scene, quality));
    assert_ok(algsurf_scene_set_antialias(scene, antialias));
    return scene;
}

static inline algsurf_render_options options_for(int threads) {
    algsurf_render_options o = {.size = sizeof o, .width = W, .height = H, .threads = threads};
    return o;
}

static inline void blank(picture *p) {
    memset(p, SENTINEL, sizeof *p);
    p->stats.size = sizeof p->stats;
}

static inline void render(const algsurf_scene *scene, const algsurf_render_options *o, picture *p) {
    const algsurf_picture planes = planes_of(p, o->row_begin);
    assert_ok(algsurf_render(scene, o, &planes, &p->stats));
}

/* Released when the test ends. */
static inline picture *new_picture(void) {
    picture *p = malloc(sizeof *p);
    assert_non_null(p);
    blank(p);
    return unit_keep(p, free);
}

static inline picture *drawn(const algsurf_scene *scene, int threads) {
    picture *p = new_picture();
    algsurf_render_options o = options_for(threads);
    render(scene, &o, p);
    return p;
}

static inline void add_stats(algsurf_render_stats *sum, const algsurf_render_stats *more) {
    sum->rays += more->rays;
    sum->hits += more->hits;
    sum->undecided += more->undecided;
    sum->shadow_rays += more->shadow_rays;
    sum->single_rays += more->single_rays;
    sum->iterations += more->iterations;
}

/* The picture in slices between the cuts, 0 to H, from the bottom up, with changing numbers of threads; the
 * counts are added up. */
static inline picture *sliced(const algsurf_scene *scene, const int *cuts) {
    picture *p = new_picture();
    algsurf_render_stats sum = {.size = sizeof sum};
    int count = 0;
    while (cuts[count] < H) count++;
    for (int k = count - 1; k >= 0; k--) {
        algsurf_render_options o = options_for(k % 2 + 1);
        o.row_begin = cuts[k], o.row_end = cuts[k + 1];
        render(scene, &o, p);
        add_stats(&sum, &p->stats);
    }
    p->stats = sum;
    return p;
}

static inline void assert_same_row(const picture *a, const picture *b, int row) {
    size_t first = (size_t)row;
    assert_memory_equal(a->bytes + first * STRIDE, b->bytes + first * STRIDE, STRIDE);
    assert_memory_equal(a->hits + first * W, b->hits + first * W, W * sizeof *a->hits);
    assert_memory_equal(a->normals + first * W * 3, b->normals + first * W * 3, 3 * W * sizeof *a->normals);
    assert_memory_equal(a->states + first * W, b->states + first * W, W);
    assert_memory_equal(a->ways + first * W, b->ways + first * W, W);
}

static inline void assert_same_picture(const picture *a, const picture *b) {
    assert_memory_equal(a->bytes, b->bytes, sizeof a->bytes);
    assert_memory_equal(a->hits, b->hits, sizeof a->hits);
    assert_memory_equal(a->normals, b->normals, sizeof a->normals);
    assert_memory_equal(a->states, b->states, sizeof a->states);
    assert_memory_equal(a->ways, b->ways, sizeof a->ways);
}

#endif
