/* allocate.c - the memory of a picture, one block: what all threads share, and what each draws with.
 *
 * It is laid out twice: the first time at no address, which tells how much it is. */
#include "../base/arithmetic.h"
#include "impl.h"

#include <stdlib.h>

/* Memory from which arrays are taken, one behind the other. */
typedef struct arena {
    unsigned char *base; /* null: only to be measured */
    size_t used;
} arena;

#define ALIGNED 64 /* bytes: a line of the cache */
#define APART 192  /* more between arrays: not a multiple of a page apart, for the cache's sake */

static void *take(arena *from, size_t count, size_t size) {
    void *taken = from->base ? from->base + from->used : NULL;
    from->used += (count * size + ALIGNED - 1) / ALIGNED * ALIGNED + APART;
    return taken;
}

static double *take_doubles(arena *from, size_t count) { return take(from, count, sizeof(double)); }
static float *take_floats(arena *from, size_t count) { return take(from, count, sizeof(float)); }
static int *take_ints(arena *from, size_t count) { return take(from, count, sizeof(int)); }
static uint8_t *take_bytes(arena *from, size_t count) { return take(from, count, 1); }

/* How large what is laid out is. */
typedef struct sizes {
    size_t width, side; /* of a row; degree + 1 */
    size_t dense;       /* samples of a row: as many as are taken together */
    size_t shares;      /* of light, where there are shadows */
    int taylor;         /* 1: shadow rays are seen side by side */
    size_t places;      /* leaves of a band */
    size_t dips;        /* of a row */
    int lanes;          /* 1: pixels of real space are solved side by side */
    size_t roots;       /* in complex space */
    int format;         /* of middles */
    const algsurf_picture *planes;
} sizes;

static sizes sizes_of(const algsurf_i_picture *picture) {
    const size_t degree = (size_t)picture->scene->surface->degree, width = (size_t)picture->width;
    const size_t across = (size_t)algsurf_i_cells_across(picture);
    return (sizes){.width = width + ALGSURF_I_MOST_ACROSS, /* a pixel's samples fit in any picture */
                   .side = degree + 1,
                   .dense = picture->selective ? (size_t)picture->scene->antialias : 1,
                   .shares = picture->shadows ? picture->lighting.light_count + 1 : 0,
                   .taylor = picture->geometry && picture->shadows && degree <= ALGSURF_MAX_TAYLOR_DEGREE &&
                             picture->scene->extent.kind != ALGSURF_EXTENT_ALL,
                   .dips = picture->thin ? ALGSURF_I_MOST_DIPS * width : 0,
                   .lanes = picture->geometry && !picture->scene->complex,
                   .places = picture->tiled ? across * (ALGSURF_I_TILES / ALGSURF_I_LEAF) : 0,
                   .roots = picture->geometry && picture->scene->complex ? degree : 0,
                   .format = picture->scene->transparent ? ALGSURF_RGBA8 : picture->planes.format,
                   .planes = &picture->planes};
}

static void lay_out_shown(arena *a, const sizes *s, algsurf_i_shown *shown) {
    shown->samples = take(a, s->width, sizeof *shown->samples);
    shown->sum = take_doubles(a, 3 * s->width);
    shown->nearest = take_doubles(a, s->width);
    shown->normal = s->planes->normals ? take_doubles(a, 3 * s->width) : NULL;
    shown->state = s->planes->state ? take_bytes(a, s->width) : NULL;
    shown->way = s->planes->way ? take_bytes(a, s->width) : NULL;
}

static void lay_out_line(arena *a, const sizes *s, algsurf_i_line *line) {
    algsurf_i_points *p = &line->points;
    line->pixel = take_ints(a, s->width);
    line->list = take_ints(a, s->width);
    line->state = take_bytes(a, s->dense * s->width);
    line->way = s->planes->way ? take_bytes(a, s->dense * s->width) : NULL;
    p->t = take_doubles(a, s->width);
    for (int k = 0; k < 3; k++) {
        p->position[k] = take_doubles(a, s->width);
        p->normal[k] = take_doubles(a, s->width);
        p->direction[k] = take_doubles(a, s->width);
        p->looks.place[k] = take_floats(a, s->width);
        p->looks.normal[k] = take_floats(a, s->width);
        p->looks.direction[k] = take_floats(a, s->width);
    }
    line->colour = take_floats(a, 3 * s->width);
    line->bytes = take(a, s->width, sizeof *line->bytes);
    line->depth = take_doubles(a, s->width);
    line->sure = take_bytes(a, s->width);
    line->imaginary = s->roots > 0 ? take_doubles(a, s->width) : NULL;
    line->visible = take_doubles(a, s->shares * s->width);
    line->rays = s->shares > 0 ? take(a, 1, algsurf_i_shadow_memory()) : NULL;
    lay_out_shown(a, s, &line->shown);
}

static void lay_out_middles(arena *a, const sizes *s, algsurf_i_middles *middles) {
    const algsurf_picture *planes = s->planes;
    /* alpha tells what is empty, states tell what is thin */
    for (int slot = 0; slot < 3; slot++)
        middles->shown[slot] =
            (algsurf_picture){.pixels = take_bytes(a, 4 * s->width),
                              .format = s->format,
                              .t = planes->t ? take_doubles(a, s->width) : NULL,
                              .normals = planes->normals ? take_floats(a, 3 * s->width) : NULL,
                              .state = take_bytes(a, s->width),
                              .way = planes->way ? take_bytes(a, s->width) : NULL};
    middles->apart = take_bytes(a, 4 * s->width);
    middles->wanted = take_bytes(a, s->width);
}

/* Two bands, two levels of lists. */
static void lay_out_tiling(arena *a, const sizes *s, algsurf_i_tiling *t) {
    for (int b = 0; b < 2; b++) {
        t->band[b].number = -1;
        t->band[b].cell = take_ints(a, s->places);
        t->band[b].tiles = take(a, s->places, sizeof *t->band[b].tiles);
    }
    t->beam.c = take_doubles(a, s->places > 0 ? s->side * s->side * s->side : 0);
    t->square = take_doubles(a, s->side * s->side);
    t->from = take_doubles(a, 2 * s->places);
    t->at = take_ints(a, 2 * s->places);
    t->low = take_doubles(a, s->width);
    t->high = take_doubles(a, s->width);
    t->enough = take_doubles(a, s->width);
    t->list_low = take_doubles(a, s->width);
    t->pixel_low = take_doubles(a, s->width);
    t->pixel_depth = take_doubles(a, s->width);
    t->pixel = take_ints(a, s->dense * s->width);
    t->pixel_state = take_bytes(a, s->width);
    t->dips.at = take_ints(a, s->dips);
    t->dips.depth = take_doubles(a, s->dips);
    t->thin = take_doubles(a, s->dips);
    for (int k = 0; k < 3; k++) t->thin_along[k] = take_doubles(a, s->dips);
}

static void lay_out_frame(arena *a, const sizes *s, algsurf_i_frame_form *frame) {
    frame->q = take_doubles(a, s->side * s->side * s->side);
    frame->basis = take_doubles(a, s->side * s->side);
    frame->sizes = take_doubles(a, s->side * s->side);
    frame->along = take_doubles(a, s->side * s->side);
}

static void lay_out_samples(arena *a, algsurf_i_picture *picture) {
    for (size_t l = 0; picture->shadows && l < picture->lighting.light_count; l++) {
        const size_t count = (size_t)(picture->lights[l].samples_u * picture->lights[l].samples_v);
        for (int k = 0; k < 2; k++) picture->samples[l][k] = take_doubles(a, count);
    }
}

static void lay_out_geometry(arena *a, const sizes *s, algsurf_i_geometry *geometry) {
    lay_out_frame(a, s, &geometry->frame);
    geometry->rays.basis = geometry->frame.basis;
    geometry->beams = s->places > 0 ? take_doubles(a, s->side * s->side * s->side) : NULL;
    if (s->taylor) lay_out_frame(a, s, &geometry->taylor.frame);
}

static void lay_out(arena *a, algsurf_i_picture *picture, int threads, algsurf_i_worker **workers) {
    const sizes s = sizes_of(picture);
    *workers = take(a, (size_t)threads, sizeof **workers);
    picture->curve = take_bytes(a, SRGB_STEPS);
    lay_out_samples(a, picture);
    if (picture->geometry) lay_out_geometry(a, &s, picture->geometry);
    for (int i = 0; i < threads; i++) {
        algsurf_i_worker nobody, *worker = a->base ? *workers + i : &nobody;
        lay_out_line(a, &s, &worker->line);
        if (picture->selective) lay_out_middles(a, &s, &worker->middles);
        if (s.lanes) lay_out_tiling(a, &s, &worker->tiling);
        worker->predictor.x = take_doubles(a, s.roots * s.width);
        worker->predictor.y = take_doubles(a, s.roots * s.width);
    }
}

void *algsurf_i_allocate(algsurf_i_picture *picture, int threads, algsurf_i_worker **workers) {
    arena a = {NULL, 0};
    lay_out(&a, picture, threads, workers);
    unsigned char *memory = calloc(a.used + ALIGNED, 1);
    if (!memory) return NULL;
    a = (arena){memory + (ALIGNED - (uintptr_t)memory % ALIGNED) % ALIGNED, 0};
    lay_out(&a, picture, threads, workers);
    return memory;
}
