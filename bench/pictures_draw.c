/* pictures_draw.c - see pictures.h.
 *
 * The view is rays_camera: a surface fills a picture as another one does.
 *
 * The lifted surface is P + c with c = 2 sum |a| X^i Y^j Z^k, where X, Y, Z are the largest |x|, |y|, |z| in
 * the extent: |P| is at most half of that there, whatever rounding does to the sum, and P + c has no zero.
 */
#include "pictures.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "must.h"
#include "rays.h"

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
    size_t count;
    algsurf_term *terms = rays_terms(surface, &count);
    algsurf_surface *lifted;
    terms[count] = (algsurf_term){0, 0, 0, above_all(terms, count, &entry->extent)};
    must(algsurf_surface_from_terms(terms, count + 1, &lifted), entry->name);
    free(terms);
    return lifted;
}

static canvas make_canvas(const stage *s) {
    size_t count = pixel_count(s);
    return (canvas){must_allocate(count, 3), must_allocate(count, sizeof(double))};
}

static void free_canvas(canvas *c) {
    free(c->hits);
    free(c->pixels);
}

static void render(stage *s, const manner *m, const canvas *to, algsurf_render_stats *stats) {
    algsurf_scene *scene = m->lifted ? s->lifted_scene : s->scene;
    const algsurf_intersect_options intersect = {
        .size = sizeof intersect, .tier = m->tier, .method = m->method, .kernel = m->kernel};
    const algsurf_render_options options = {
        .size = sizeof options, .width = s->width, .height = s->height, .threads = m->threads};
    const algsurf_picture picture = {.size = sizeof picture, .pixels = to->pixels, .t = to->hits};
    stats->size = sizeof *stats;
    must(algsurf_scene_set_intersect_options(scene, &intersect), s->entry->name);
    must(algsurf_scene_set_quality(scene, m->quality), s->entry->name);
    must(algsurf_scene_set_antialias(scene, m->antialias > 0 ? m->antialias : 1), s->entry->name);
    must(algsurf_scene_set_antialias_threshold(scene, m->threshold), s->entry->name);
    must(algsurf_render(scene, &options, &picture, stats), s->entry->name);
}

stage *stage_open(const catalogue_entry *entry, int width, int height) {
    const manner reference = {.threads = 1, .quality = ALGSURF_QUALITY_STANDARD};
    algsurf_render_stats untimed;
    stage *s = must_allocate(1, sizeof *s);
    if (entry->extent.kind != ALGSURF_EXTENT_SPHERE)
        cli_fail(CLI_BROKEN, "%s: not inside a sphere", entry->name);
    *s = (stage){.entry = entry, .width = width, .height = height, .camera = rays_camera(&entry->extent)};
    s->surface = rays_surface(entry);
    s->lifted = lift(s->surface, entry);
    s->scene = rays_scene(s->surface, &entry->extent, &s->camera);
    s->lifted_scene = rays_scene(s->lifted, &entry->extent, &s->camera);
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
    free_canvas(&s->canvas);
    free_canvas(&s->smooth);
    free_canvas(&s->reference);
    free(s);
}

static algsurf_ray ray_of(const stage *s, size_t pixel) {
    int x = (int)(pixel % (size_t)s->width), y = (int)(pixel / (size_t)s->width);
    return rays_ray(&s->camera, s->width, s->height, x, y);
}

size_t stage_rays(const stage *s) {
    size_t rays = 0;
    for (size_t i = 0; i < pixel_count(s); i++) {
        algsurf_ray ray = ray_of(s, i);
        rays += rays_clip(&ray, &s->entry->extent, &ray) != 0;
    }
    return rays;
}

static size_t count_hits(const stage *s, const canvas *c) {
    size_t hits = 0;
    for (size_t i = 0; i < pixel_count(s); i++) hits += isinf(c->hits[i]) == 0;
    return hits;
}

size_t stage_hits(const stage *s) { return count_hits(s, &s->reference); }

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

const char *stage_draw(stage *s, const manner *m, algsurf_render_stats *stats) {
    render(s, m, &s->canvas, stats);
    const char *failure = breach(s, m->duty);
    if (!failure && m->duty == DUTY_SMOOTH) keep(s);
    return failure;
}
