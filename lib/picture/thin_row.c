/* thin_row.c - the pixels of a row beside whose rays there is something thin. */
#include "../base/arithmetic.h"
#include <math.h>

#include "camera_impl.h"
#include "cells.h"
#include "impl.h"
#include "srgb.h"
#include "thin_row.h"
#include "thin.h"
#include "../rays/intersect_impl.h"
#include "../base/vec.h"

#define BEFORE 4 /* pixels' sides: what is less far in front of a hit belongs to it */

/* The cells of the pass in wanted pixels that are in leaves; and those that have no tiles, which would
 * reach beyond the bounds of forms, as in pictures of few rows. */
static int collect(const algsurf_i_picture *picture, const algsurf_i_band *band, int row,
                   const algsurf_i_cells *f, const algsurf_i_line *line, algsurf_i_tiling *t) {
    int places = (picture->width + ALGSURF_I_LEAF - 1) / ALGSURF_I_LEAF, count = 0, begin, end;
    const int first = row % ALGSURF_I_TILES / ALGSURF_I_LEAF * places;
    (void)algsurf_i_pixels_within_bounds(picture, row, row + 1, 1, &begin, &end);
    if (begin < line->begin) begin = line->begin;
    if (end > line->end) end = line->end;
    for (int x = begin; x < end; x++) {
        int tiled = band && x >= band->begin && x < band->end;
        int number = tiled ? band->cell[first + x / ALGSURF_I_LEAF] : 0;
        if (tiled && (number <= 0 || band->tiles[number - 1].enough > 0)) continue;
        if (line->wanted && !line->wanted[x]) continue;
        for (int i = 0; i < line->dense; i++) {
            t->at[count] = x * f->across + f->x + i;
            t->from[count++] = tiled ? band->tiles[number - 1].low : -1;
        }
    }
    return count;
}

/* Where the line has a point of a sample, or -1, in t->pixel. */
static void number_points(const algsurf_i_line *line, algsurf_i_tiling *t) {
    for (int x = line->dense * line->begin; x < line->dense * line->end; x++) t->pixel[x] = -1;
    for (int i = 0; i < line->count; i++) t->pixel[line->pixel[i]] = i;
}

/* Of depth along the ray, for a t of 1. */
static double depth_per_t(const algsurf_i_picture *picture, const algsurf_ray *ray) {
    const algsurf_i_view *view = &picture->packets->frame.view;
    double forward = algsurf_dot(ray->direction, picture->scene->camera.forward);
    return ldexp(forward, -picture->scene->surface->unit) / view->size;
}

/* Sample x shows what is thin instead of what it shows. */
static void show(const algsurf_i_picture *picture, int x, double t, const algsurf_ray *ray,
                 algsurf_i_line *line, int point) {
    int i = point >= 0 ? point : line->count++;
    line->pixel[i] = x;
    line->state[x] = ALGSURF_THIN;
    line->points.t[i] = t;
    line->bytes[i] = 0;
    for (int k = 0; k < 3; k++) {
        double light = picture->scene->thin_colour[k];
        line->bytes[i] |= (uint32_t)algsurf_i_byte_of(picture->curve, light) << 8 * k;
        line->points.position[k][i] = ray->origin[k] + t * ray->direction[k];
        line->points.normal[k][i] = 0;
        line->points.direction[k][i] = ray->direction[k];
        line->colour[3 * i + k] = (float)light;
    }
}

/* A sample, about which rays are asked what they hit. */
typedef struct sample {
    const algsurf_i_picture *picture;
    double x, y, side; /* in the picture; of its cell */
    algsurf_i_tally *tally;
} sample;

/* Those rays as a packet. */
typedef struct asked_rays {
    size_t count;
    double origin[3][ALGSURF_I_NEIGHBOURS], direction[3][ALGSURF_I_NEIGHBOURS];
    double t_min[ALGSURF_I_NEIGHBOURS], t_max[ALGSURF_I_NEIGHBOURS];
    double per_t[ALGSURF_I_NEIGHBOURS], depth[ALGSURF_I_NEIGHBOURS]; /* depth: HUGE_VAL without a hit */
} asked_rays;

/* The ray that many cells' sides to the right, and below. */
static void ask(const sample *s, int right, int below, asked_rays *a) {
    const algsurf_i_picture *picture = s->picture;
    algsurf_ray ray;
    size_t i = a->count++;
    algsurf_i_camera_ray(&picture->scene->camera, picture->width, picture->height, s->x + right * s->side,
                         s->y + below * s->side, &ray);
    a->t_min[i] = ray.t_min;
    a->t_max[i] = ray.t_max;
    a->per_t[i] = depth_per_t(picture, &ray);
    for (int k = 0; k < 3; k++) {
        a->origin[k][i] = ray.origin[k];
        a->direction[k][i] = ray.direction[k];
    }
}

/* Where they first hit the surface.  What is undecided is no hit here, whatever it is drawn as, nor is what
 * memory does not suffice for. */
static void answer(const sample *s, asked_rays *a) {
    const algsurf_scene *scene = s->picture->scene;
    algsurf_intersect_options options = scene->intersect;
    unsigned char state[ALGSURF_I_NEIGHBOURS] = {ALGSURF_MISS};
    const algsurf_ray_packet rays = {
        .size = sizeof rays,
        .count = a->count,
        .origin = {a->origin[0], a->origin[1], a->origin[2]},
        .direction = {a->direction[0], a->direction[1], a->direction[2]},
        .t_min = a->t_min,
        .t_max = a->t_max,
    };
    const algsurf_hit_packet hits = {.size = sizeof hits, .state = state, .t = a->depth};
    options.undecided_as = ALGSURF_AS_UNDECIDED;
    algsurf_status status = algsurf_i_intersect_packet(scene->surface, &scene->extent, &rays, &options, &hits,
                                                       &s->tally->exact_rays);
    s->tally->without_memory += status < 0;
    for (size_t i = 0; i < a->count; i++)
        a->depth[i] =
            state[i] == ALGSURF_HIT ? s->picture->packets->near + a->depth[i] * a->per_t[i] : HUGE_VAL;
}

static void look_beside(void *looker, double depth[ALGSURF_I_NEIGHBOURS]) {
    enum { MIDDLE = ALGSURF_I_NEIGHBOURS / 2 };
    const sample *s = looker;
    asked_rays a = {.count = 0};
    for (int k = 0; k < ALGSURF_I_NEIGHBOURS; k++)
        if (k != MIDDLE) ask(s, k % 3 - 1, k / 3 - 1, &a);
    answer(s, &a);
    for (int k = 0, i = 0; k < ALGSURF_I_NEIGHBOURS; k++) depth[k] = k != MIDDLE ? a.depth[i++] : HUGE_VAL;
}

/* Is that shown point surely one that the sample's ray hits?  An undecided one is not, and may be drawn as a
 * hit. */
static int is_hit(const sample *s, int state) {
    asked_rays a = {.count = 0};
    if (state != ALGSURF_HIT || s->picture->scene->intersect.undecided_as != ALGSURF_AS_HIT)
        return state == ALGSURF_HIT;
    ask(s, 0, 0, &a);
    answer(s, &a);
    return a.depth[0] < HUGE_VAL;
}

void algsurf_i_add_thin(const algsurf_i_picture *picture, int row, double sx, double sy,
                        algsurf_i_worker *worker, algsurf_i_tally *tally) {
    algsurf_i_line *line = &worker->line;
    algsurf_i_tiling *t = &worker->tiling;
    const algsurf_i_packets *p = picture->packets;
    const algsurf_i_band *band = algsurf_i_band_of(picture, row, 0, t);
    const algsurf_i_cells f = algsurf_i_cells_of(picture, line->across, row, line->dense > 1 ? 0 : sx, sy);
    int count = collect(picture, band, row, &f, line, t);
    if (count > 0) count = algsurf_i_search_cells(&f, 1, count, 1, t);
    for (int i = 0; i < count; i++) { /* there may be something beside the pixel */
        t->from[i] = -1;
    }
    if (count > 0) count = algsurf_i_search_cells(&f, 2, count, 1, t);
    if (count == 0) return;
    number_points(line, t);
    double h = p->per_slope * f.pixel;
    for (int i = 0; i < count; i++) {
        int x = line->dense > 1 ? t->at[i] : t->at[i] / f.across, point = t->pixel[x];
        algsurf_ray ray;
        sample at = {picture, algsurf_i_place_of(line, x, sx), row + sy, 1.0 / f.across, tally};
        algsurf_i_camera_ray(&picture->scene->camera, picture->width, picture->height, at.x, at.y, &ray);
        double per_t = depth_per_t(picture, &ray), depth;
        algsurf_i_thin_box box = {.view = &p->frame.view,
                                  .beam = &t->beam,
                                  .u = p->origin[0] + p->per_slope * ((t->at[i] + 0.5 + f.offset) * f.pixel),
                                  .h = h + copysign(ALGSURF_I_WIDER, h),
                                  .from = t->from[i],
                                  .to = 1,
                                  .within = t->pixel_low[i],
                                  .look_beside = look_beside,
                                  .looker = &at};
        if (point >= 0 && is_hit(&at, line->state[x])) {
            double limit = p->near + line->points.t[point] * per_t - BEFORE * fabs(h);
            if (limit < box.to) box.to = limit, box.ends_at_hit = 1;
        }
        if (!(box.from < box.to) || !algsurf_i_is_thin(&box, t->thin, &depth)) continue;
        show(picture, x, (depth - p->near) / per_t, &ray, line, point);
        tally->thin++;
    }
}
