/* thin_row.c - the pixels of a row beside whose rays there is something thin. */
#include "../base/arithmetic.h"
#include <math.h>

#include "camera_impl.h"
#include "impl.h"
#include "thin.h"
#include "../base/vec.h"

#define BEFORE 4 /* pixels' sides: what is less far in front of a hit belongs to it */

/* The cells about the samples of a pass are the pixels of a picture with as many times more pixels. */
typedef struct finer {
    const algsurf_i_picture *picture;
    int across, x, y; /* that picture's pixels for one of this; of each, the first sample's; the row */
    double pixel, offset;
    algsurf_i_row_job rays;
} finer;

static finer finer_row(const algsurf_i_picture *picture, int across, int row, double sx, double sy) {
    const algsurf_i_packets *p = picture->packets;
    finer f = {.picture = picture,
               .across = across,
               .x = (int)(sx * across),
               .y = row * across + (int)(sy * across),
               .pixel = p->pixel / across,
               .offset = -0.5 * picture->width * across};
    f.rays = (algsurf_i_row_job){.view = &p->frame.view,
                                 .pixel = f.pixel,
                                 .u0 = p->origin[0],
                                 .du = p->per_slope,
                                 .extent = &picture->scene->extent,
                                 .extent_size = {p->extent_size[0], p->extent_size[1], p->extent_size[2]},
                                 .near = p->near};
    return f;
}

/* The wanted pixels in leaves. */
static int collect(const algsurf_i_picture *picture, const algsurf_i_band *band, int row, const finer *f,
                   const algsurf_i_line *line, algsurf_i_tiling *t) {
    int places = (picture->width + ALGSURF_I_LEAF - 1) / ALGSURF_I_LEAF, count = 0;
    const int *cell = band->cell + (row - band->number * ALGSURF_I_TILES) / ALGSURF_I_LEAF * places;
    for (int x = band->begin; x < band->end; x++) {
        int number = cell[x / ALGSURF_I_LEAF];
        if (number <= 0 || band->tiles[number - 1].enough > 0 || (line->wanted && !line->wanted[x])) continue;
        t->at[count] = x * f->across + f->x;
        t->from[count++] = band->tiles[number - 1].low;
    }
    return count;
}

/* Tiles of that size about the cells of the list: those that are neither empty nor sheets are left in it. */
static int search(const finer *f, int size, int count, algsurf_i_tiling *t) {
    const algsurf_i_picture *picture = f->picture;
    const algsurf_i_packets *p = picture->packets;
    double h = -p->per_slope * (0.5 * size * f->pixel);
    double v = p->origin[1] + p->per_slope * ((0.5 * picture->height * f->across - (f->y + 0.5)) * f->pixel);
    algsurf_i_row_job rays = f->rays;
    for (int i = 0; i < count; i++) t->leaf_depth[i] = 1;
    rays.offset = f->offset + 0.5 - 0.5 * size;
    algsurf_i_tile_job job = {.row = &rays,
                              .beam = &t->beam,
                              .size = size,
                              .count = count,
                              .at = t->at,
                              .from = t->from,
                              .to = t->leaf_depth,
                              .within = t->leaf_low,
                              .noise = p->frame.value_error};
    algsurf_i_beam_row_expand(&p->frame, p->beams, v, h + copysign(ALGSURF_I_WIDER, h),
                              fabs(h) + ALGSURF_I_WIDER, t->square, &t->beam);
    algsurf_i_picture_kernel_for(picture->kernel)->search_tiles(&job);
    return job.count;
}

/* Where the line has a point of a pixel, or -1, in t->leaf. */
static void number_points(const algsurf_i_line *line, int width, algsurf_i_tiling *t) {
    for (int x = 0; x < width; x++) t->leaf[x] = -1;
    for (int i = 0; i < line->count; i++) t->leaf[line->pixel[i]] = i;
}

/* Of depth along the ray, for a t of 1. */
static double depth_per_t(const algsurf_i_picture *picture, const algsurf_ray *ray) {
    const algsurf_i_view *view = &picture->packets->frame.view;
    double forward = algsurf_dot(ray->direction, picture->scene->camera.forward);
    return ldexp(forward, -picture->scene->surface->unit) / view->size;
}

/* The pixel shows what is thin instead of what it shows. */
static void show(const algsurf_i_picture *picture, int x, double t, const algsurf_ray *ray,
                 algsurf_i_line *line, int point) {
    int i = point >= 0 ? point : line->count++;
    line->pixel[i] = x;
    line->state[x] = ALGSURF_THIN;
    line->points.t[i] = t;
    if (line->points.bytes) line->points.bytes[i] = algsurf_i_bytes_of(picture->scene->thin_colour);
    for (int k = 0; k < 3; k++) {
        line->points.position[k][i] = ray->origin[k] + t * ray->direction[k];
        line->points.normal[k][i] = 0;
        line->points.direction[k][i] = ray->direction[k];
        line->colour[3 * i + k] = picture->scene->thin_colour[k];
    }
}

void algsurf_i_add_thin(const algsurf_i_picture *picture, int row, double sx, double sy,
                        algsurf_i_worker *worker, algsurf_i_tally *tally) {
    algsurf_i_line *line = &worker->line;
    algsurf_i_tiling *t = &worker->tiling;
    const algsurf_i_packets *p = picture->packets;
    const algsurf_i_band *band = algsurf_i_band_of(picture, row, 0, t);
    if (!band) return;
    const finer f = finer_row(picture, line->across, row, sx, sy);
    int count = collect(picture, band, row, &f, line, t);
    if (count > 0) count = search(&f, 1, count, t);
    for (int i = 0; i < count; i++) t->from[i] = -1; /* there may be something beside the pixel */
    if (count > 0) count = search(&f, 2, count, t);
    if (count == 0) return;
    number_points(line, picture->width, t);
    double h = p->per_slope * f.pixel;
    for (int i = 0; i < count; i++) {
        int x = t->at[i] / f.across, point = t->leaf[x];
        algsurf_ray ray;
        algsurf_i_camera_ray(&picture->scene->camera, picture->width, picture->height, x + sx, row + sy,
                             &ray);
        double per_t = depth_per_t(picture, &ray), depth;
        algsurf_i_thin_box box = {.view = &p->frame.view,
                                  .beam = &t->beam,
                                  .u = p->origin[0] + p->per_slope * ((t->at[i] + 0.5 + f.offset) * f.pixel),
                                  .h = h + copysign(ALGSURF_I_WIDER, h),
                                  .from = t->from[i],
                                  .to = t->leaf_depth[i],
                                  .within = t->leaf_low[i]};
        if (point >= 0) {
            double limit = p->near + line->points.t[point] * per_t - BEFORE * fabs(h);
            if (limit < box.to) box.to = limit, box.ends_at_hit = 1;
        }
        if (!(box.from < box.to) || !algsurf_i_is_thin(&box, &depth)) continue;
        show(picture, x, (depth - p->near) / per_t, &ray, line, point);
        tally->thin++;
    }
}
