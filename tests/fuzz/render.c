/* render.c - fuzzes small pictures: "KIND CX CY CZ SX SY SZ" (the extent), "PARALLEL EX EY EZ LX LY LZ UX UY
 * UZ FOV" (the camera), "QUALITY SAMPLES", then terms "I J K A".
 *
 * All kernels must draw the same bytes; and a pixel must show what algsurf_intersect_first says of its ray,
 * unless the ray's own rounding matters: where rays a millionth of a pixel beside it get other answers.
 */
#include "algsurf/render.h"
#include "fuzz.h"

enum { MOST_TERMS = 24, MOST_DEGREE = 12, SIDE = 8, PIXELS = SIDE * SIDE };

typedef struct picture {
    uint8_t bytes[3 * PIXELS];
    double hits[PIXELS];
    float normals[3 * PIXELS];
    unsigned char states[PIXELS], ways[PIXELS];
    algsurf_render_stats stats;
} picture;

typedef struct view {
    algsurf_surface *surface;
    algsurf_extent extent;
    algsurf_camera camera;
    int samples;
    algsurf_scene *scene;
} view;

static algsurf_surface *read_surface(fuzz_numbers *in) {
    algsurf_term terms[MOST_TERMS];
    algsurf_surface *surface = NULL;
    size_t count = 0;
    for (; count < MOST_TERMS && fuzz_left(in) > 0; count++) {
        int i = fuzz_whole(in, 0, MOST_DEGREE), j = fuzz_whole(in, 0, MOST_DEGREE - i);
        int k = fuzz_whole(in, 0, MOST_DEGREE - i - j);
        terms[count] = (algsurf_term){i, j, k, fuzz_finite(in)};
    }
    if (count > 0) (void)algsurf_surface_from_terms(terms, count, &surface);
    return surface;
}

static void read_three(fuzz_numbers *in, double x[3]) {
    for (int k = 0; k < 3; k++) x[k] = fuzz_finite(in);
}

static int read_camera(fuzz_numbers *in, algsurf_camera *camera) {
    double eye[3], look[3], up[3], angle;
    int parallel = fuzz_whole(in, 0, 1);
    read_three(in, eye), read_three(in, look), read_three(in, up);
    angle = fabs(fuzz_finite(in));
    return (parallel ? algsurf_camera_orthographic(eye, look, up, angle, camera)
                     : algsurf_camera_pinhole(eye, look, up, angle, camera)) == ALGSURF_OK;
}

/* OK, or a refusal that leaves the pixels as they were. */
static algsurf_status draw(const view *v, const char *kernel, picture *p) {
    const algsurf_intersect_options how = {.size = sizeof how, .kernel = kernel};
    const algsurf_render_options o = {.size = sizeof o, .width = SIDE, .height = SIDE, .threads = 1};
    const algsurf_picture planes = {.size = sizeof planes,
                                    .pixels = p->bytes,
                                    .t = p->hits,
                                    .normals = p->normals,
                                    .state = p->states,
                                    .way = p->ways};
    memset(p, 0x5a, sizeof *p);
    p->stats.size = sizeof p->stats;
    fuzz_check(algsurf_scene_set_intersect_options(v->scene, &how) == ALGSURF_OK);
    algsurf_status status = algsurf_render(v->scene, &o, &planes, &p->stats);
    fuzz_check(status == ALGSURF_OK || status == ALGSURF_E_NOT_FINITE);
    return status;
}

/* The answers about rays through and closely around a pixel's middle; 0: they differ. */
static int answers_around(const view *v, int pixel, int *state, double t[2]) {
    static const double beside[5][2] = {{0, 0}, {1e-6, 0}, {-1e-6, 0}, {0, 1e-6}, {0, -1e-6}};
    t[0] = INFINITY, t[1] = -INFINITY;
    for (int i = 0; i < 5; i++) {
        double x = pixel % SIDE + 0.5 + beside[i][0], y = pixel / SIDE + 0.5 + beside[i][1];
        algsurf_ray ray;
        algsurf_hit hit;
        if (algsurf_camera_ray(&v->camera, SIDE, SIDE, x, y, &ray) != ALGSURF_OK) return 0;
        if (algsurf_intersect_first(v->surface, &v->extent, &ray, NULL, &hit) != ALGSURF_OK) return 0;
        if (hit.state == ALGSURF_STATE_UNDECIDED || (i > 0 && hit.state != *state)) return 0;
        *state = hit.state;
        t[0] = fmin(t[0], hit.t), t[1] = fmax(t[1], hit.t);
    }
    return 1;
}

static void check_pixels(const view *v, const picture *p) {
    for (int i = 0; i < PIXELS; i++) {
        int state = ALGSURF_STATE_MISS;
        double t[2];
        int way = p->ways[i] & 3;
        fuzz_check(p->hits[i] >= 0 && p->states[i] <= ALGSURF_STATE_UNDECIDED);
        fuzz_check(way != ALGSURF_WAY_EMPTY || p->states[i] == ALGSURF_STATE_MISS);
        fuzz_check(way != ALGSURF_WAY_SHEET || p->states[i] == ALGSURF_STATE_HIT);
        if (!answers_around(v, i, &state, t)) continue;
        if (state != p->states[i])
            fprintf(stderr, "pixel %d,%d: %a, single rays say %d at %a\n", i % SIDE, i / SIDE, p->hits[i],
                    state, t[0]);
        fuzz_check(state == p->states[i]);
        double slack = 8 * (t[1] - t[0]) + 1e-9 * t[1];
        if (state == ALGSURF_STATE_HIT && !(p->hits[i] >= t[0] - slack && p->hits[i] <= t[1] + slack))
            fprintf(stderr, "pixel %d,%d: %a, single rays say %a to %a\n", i % SIDE, i / SIDE, p->hits[i],
                    t[0], t[1]);
        if (state == ALGSURF_STATE_HIT) fuzz_check(p->hits[i] >= t[0] - slack && p->hits[i] <= t[1] + slack);
    }
}

static void check_picture(const view *v) {
    picture p, other;
    const char *kernel = algsurf_kernel_name(0);
    if (draw(v, kernel, &p) != ALGSURF_OK) return;
    uint64_t samples = (uint64_t)(PIXELS * v->samples * v->samples), drawn = 0;
    for (int i = 0; i < PIXELS; i++) drawn += p.states[i] != ALGSURF_STATE_MISS;
    fuzz_check(p.stats.rays == samples && p.stats.hits + p.stats.undecided <= samples);
    fuzz_check(drawn <= p.stats.hits + p.stats.undecided);
    fuzz_check(v->samples > 1 || drawn == p.stats.hits + p.stats.undecided);
    for (int i = 1; (kernel = algsurf_kernel_name(i)); i++) {
        fuzz_check(draw(v, kernel, &other) == ALGSURF_OK);
        fuzz_check(memcmp(p.bytes, other.bytes, sizeof p.bytes) == 0);
        fuzz_check(memcmp(p.hits, other.hits, sizeof p.hits) == 0);
        fuzz_check(memcmp(p.normals, other.normals, sizeof p.normals) == 0);
        fuzz_check(memcmp(p.states, other.states, sizeof p.states) == 0);
    }
    if (v->samples == 1) check_pixels(v, &p);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    fuzz_numbers in = fuzz_numbers_of(data, size);
    view v;
    v.extent.kind = fuzz_whole(&in, 0, 2);
    read_three(&in, v.extent.centre), read_three(&in, v.extent.size);
    int seen = read_camera(&in, &v.camera), quality = fuzz_whole(&in, 0, 2);
    v.samples = fuzz_whole(&in, 1, 2);
    if (!seen || !(v.surface = read_surface(&in))) return 0;
    fuzz_check(algsurf_scene_create(v.surface, &v.scene) == ALGSURF_OK);
    fuzz_check(algsurf_scene_set_camera(v.scene, &v.camera) == ALGSURF_OK);
    fuzz_check(algsurf_scene_set_quality(v.scene, (algsurf_quality)quality) == ALGSURF_OK);
    fuzz_check(algsurf_scene_set_antialias(v.scene, v.samples) == ALGSURF_OK);
    if (algsurf_scene_set_extent(v.scene, &v.extent) == ALGSURF_OK) check_picture(&v);
    algsurf_scene_free(v.scene);
    algsurf_surface_free(v.surface);
    return 0;
}
