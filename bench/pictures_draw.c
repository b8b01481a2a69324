/* pictures_draw.c - see pictures_draw.h.
 *
 * The view is the same for all surfaces: R being the radius of the extent, the eye is 4 R from its centre,
 * and the picture is 2.2 R high there.  So a surface fills a picture as another one does.
 *
 * The lifted surface is P + c with c = 2 sum |a| X^i Y^j Z^k, where X, Y, Z are the largest |x|, |y|, |z| in
 * the extent: |P| is at most half of that there, whatever rounding does to the sum, and P + c has no zero.
 */
#define _POSIX_C_SOURCE 200809L /* clock_gettime */
#include "pictures_draw.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "cli.h"
#include "must.h"

static const double DISTANCE = 4, HALF_HEIGHT = 1.1; /* in radii */
static const double TOWARDS_EYE[3] = {2, -3, 1.2};

typedef struct canvas {
    uint8_t *pixels;
    double *hits;
} canvas;

struct stage {
    const catalogue_entry *entry;
    int width, height;
    algsurf_camera camera;
    algsurf_surface *surface, *lifted;
    algsurf_scene *scene, *lifted_scene;
    canvas reference, smooth, canvas;
};

static size_t pixel_count(const stage *s) { return (size_t)s->width * (size_t)s->height; }

/* ---- the stage ---- */

static void place_camera(stage *s) {
    const algsurf_extent *extent = &s->entry->extent;
    const double *to = TOWARDS_EYE, up[3] = {0, 0, 1};
    double length = sqrt(to[0] * to[0] + to[1] * to[1] + to[2] * to[2]), eye[3];
    double fov = 2 * atan(HALF_HEIGHT / DISTANCE) * (180 / acos(-1));
    for (int i = 0; i < 3; i++) eye[i] = extent->centre[i] + DISTANCE * extent->size[0] * (to[i] / length);
    must(algsurf_camera_pinhole(eye, extent->centre, up, fov, &s->camera), s->entry->name);
}

/* Twice the most that |P| can be in a ball. */
static double above_all(const algsurf_term *terms, size_t count, const algsurf_extent *ball) {
    double largest[3], sum = 0;
    for (int i = 0; i < 3; i++) largest[i] = fabs(ball->centre[i]) + ball->size[0];
    for (size_t n = 0; n < count; n++)
        sum += fabs(terms[n].a) * pow(largest[0], terms[n].i) * pow(largest[1], terms[n].j) *
               pow(largest[2], terms[n].k);
    return 2 * sum;
}

static algsurf_surface *lift(const algsurf_surface *surface, const catalogue_entry *entry) {
    size_t count = algsurf_surface_term_count(surface);
    algsurf_term *terms = must_allocate(count + 1, sizeof *terms);
    algsurf_surface *lifted;
    must(algsurf_surface_terms(surface, terms), entry->name);
    terms[count] = (algsurf_term){0, 0, 0, above_all(terms, count, &entry->extent)};
    must(algsurf_surface_from_terms(terms, count + 1, &lifted), entry->name);
    free(terms);
    return lifted;
}

static algsurf_scene *make_scene(const stage *s, const algsurf_surface *surface) {
    algsurf_scene *scene;
    must(algsurf_scene_create(surface, &scene), s->entry->name);
    must(algsurf_scene_set_extent(scene, &s->entry->extent), s->entry->name);
    must(algsurf_scene_set_camera(scene, &s->camera), s->entry->name);
    return scene;
}

static canvas make_canvas(const stage *s) {
    size_t count = pixel_count(s);
    return (canvas){must_allocate(count, 3), must_allocate(count, sizeof(double))};
}

static void render(stage *s, const manner *m, const canvas *to, drawing *d);

stage *stage_open(const catalogue_entry *entry, int width, int height) {
    const manner reference = {.threads = 1, .quality = ALGSURF_QUALITY_STANDARD};
    drawing untimed;
    stage *s = must_allocate(1, sizeof *s);
    s->entry = entry;
    s->width = width;
    s->height = height;
    if (entry->extent.kind != ALGSURF_EXTENT_SPHERE)
        cli_fail(CLI_BROKEN, "%s: not inside a sphere", entry->name);
    place_camera(s);
    must(algsurf_surface_from_equation(entry->equation, NULL, 0, &s->surface, NULL), entry->name);
    s->lifted = lift(s->surface, entry);
    s->scene = make_scene(s, s->surface);
    s->lifted_scene = make_scene(s, s->lifted);
    s->reference = make_canvas(s);
    s->smooth = make_canvas(s);
    s->canvas = make_canvas(s);
    render(s, &reference, &s->reference, &untimed);
    return s;
}

void stage_close(stage *s) {
    algsurf_scene_free(s->lifted_scene);
    algsurf_scene_free(s->scene);
    algsurf_surface_free(s->lifted);
    algsurf_surface_free(s->surface);
    free(s->canvas.hits);
    free(s->canvas.pixels);
    free(s->smooth.hits);
    free(s->smooth.pixels);
    free(s->reference.hits);
    free(s->reference.pixels);
    free(s);
}

static algsurf_ray ray_of(const stage *s, size_t pixel) {
    size_t x = pixel % (size_t)s->width, y = pixel / (size_t)s->width;
    algsurf_ray ray;
    must(algsurf_camera_ray(&s->camera, s->width, s->height, (double)x + 0.5, (double)y + 0.5, &ray),
         s->entry->name);
    return ray;
}

size_t stage_rays(const stage *s) {
    size_t rays = 0;
    for (size_t i = 0; i < pixel_count(s); i++) {
        algsurf_ray ray = ray_of(s, i);
        int meets;
        must(algsurf_ray_clip(&ray, &s->entry->extent, NULL, 0, &ray, &meets), s->entry->name);
        rays += meets != 0;
    }
    return rays;
}

static size_t count_hits(const stage *s, const canvas *c) {
    size_t hits = 0;
    for (size_t i = 0; i < pixel_count(s); i++) hits += isinf(c->hits[i]) == 0;
    return hits;
}

size_t stage_hits(const stage *s) { return count_hits(s, &s->reference); }

/* ---- a picture ---- */

static double wall_clock(void) {
    struct timespec now = {0, 0};
    (void)clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static void render(stage *s, const manner *m, const canvas *to, drawing *d) {
    algsurf_scene *scene = m->lifted ? s->lifted_scene : s->scene;
    const algsurf_intersect_options intersect = {
        .size = sizeof intersect, .tier = m->tier, .method = m->method, .kernel = m->kernel};
    const algsurf_render_options options = {
        .size = sizeof options, .width = s->width, .height = s->height, .threads = m->threads};
    const algsurf_picture picture = {.size = sizeof picture, .pixels = to->pixels, .t = to->hits};
    algsurf_render_stats stats = {.size = sizeof stats};
    must(algsurf_scene_set_intersect_options(scene, &intersect), s->entry->name);
    must(algsurf_scene_set_quality(scene, m->quality), s->entry->name);
    must(algsurf_scene_set_antialias(scene, m->antialias > 0 ? m->antialias : 1), s->entry->name);
    must(algsurf_scene_set_antialias_threshold(scene, m->threshold), s->entry->name);
    double begun = wall_clock();
    must(algsurf_render(scene, &options, &picture, &stats), s->entry->name);
    d->seconds[PART_ALL] = wall_clock() - begun;
    d->seconds[PART_EXPAND] = stats.expand_s;
    d->seconds[PART_SOLVE] = stats.solve_s;
    d->seconds[PART_POINT] = stats.point_s;
    d->seconds[PART_SHADOW] = stats.shadow_s;
    d->seconds[PART_SHADE] = stats.shade_s;
    d->threads = stats.threads;
}

/* ---- its duty ---- */

static int same_pixels(const stage *s) {
    return memcmp(s->canvas.pixels, s->reference.pixels, 3 * pixel_count(s)) == 0;
}

static int same_hits(const stage *s) {
    return memcmp(s->canvas.hits, s->reference.hits, pixel_count(s) * sizeof(double)) == 0;
}

static int is_left_open(const stage *s, size_t pixel) {
    const algsurf_intersect_options bounded = {.size = sizeof bounded, .tier = ALGSURF_TIER_BOUNDED};
    algsurf_ray ray = ray_of(s, pixel);
    algsurf_hit hit;
    must(algsurf_intersect_first(s->surface, &s->entry->extent, &ray, &bounded, &hit), s->entry->name);
    return hit.state == ALGSURF_STATE_UNDECIDED;
}

/* The same pixels with a hit; with `more` allowed at least those; with `open` allowed but for pixels that
 * doubles leave open. */
static int same_mask(const stage *s, int more, int open) {
    for (size_t i = 0; i < pixel_count(s); i++) {
        int here = !isinf(s->canvas.hits[i]), there = !isinf(s->reference.hits[i]);
        if (here != there && !(more && here) && !(open && is_left_open(s, i))) return 0;
    }
    return 1;
}

/* What was drawn, as a second picture to compare with. */
static void keep(stage *s) {
    canvas drawn = s->canvas;
    s->canvas = s->smooth;
    s->smooth = drawn;
}

static int same_as_either(const stage *s) {
    for (size_t i = 0; i < pixel_count(s); i++) {
        const uint8_t *drawn = s->canvas.pixels + 3 * i;
        if (memcmp(drawn, s->reference.pixels + 3 * i, 3) != 0 &&
            memcmp(drawn, s->smooth.pixels + 3 * i, 3) != 0)
            return 0;
    }
    return 1;
}

static const char *breach(const stage *s, duty owed) {
    switch (owed) {
    case DUTY_PICTURE:
        if (!same_pixels(s)) return "another picture than the reference";
        if (!same_hits(s)) return "other hits than the reference";
        break;
    case DUTY_HITS:
        return same_hits(s) ? NULL : "other hits than the reference";
    case DUTY_MASK:
        return same_mask(s, 0, 0) ? NULL : "hits at other pixels than the reference";
    case DUTY_OPEN:
        return same_mask(s, 0, 1) ? NULL : "hits at other pixels than the reference";
    case DUTY_SMOOTH:
        return same_mask(s, 1, 0) ? NULL : "no hit where the reference has one";
    case DUTY_EITHER:
        return same_as_either(s) ? NULL : "a pixel that is neither smooth nor as in the reference";
    case DUTY_EMPTY:
        return count_hits(s, &s->canvas) == 0 ? NULL : "a hit where there is no surface";
    }
    return NULL;
}

const char *stage_draw(stage *s, const manner *m, drawing *d) {
    render(s, m, &s->canvas, d);
    const char *failure = breach(s, m->duty);
    if (!failure && m->duty == DUTY_SMOOTH) keep(s);
    return failure;
}
