/* thin.c - the pixels of a row beside whose rays there is something thin. */
#include "../base/arithmetic.h"
#include <math.h>

#include "../base/vec.h"
#include "camera_impl.h"
#include "impl.h"
#include "srgb.h"
#include "thin.h"

#define BEFORE 4 /* pixels' sides: what is less far in front of a hit belongs to it */

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

static double second_sizes(const algsurf_i_frame_form *frame) {
    int side = frame->degree + 1;
    double sum = 0;
    for (int i = 0; i < side; i++)
        for (int j = 0; i + j < side; j++)
            for (int k = 0; i + j + k < side; k++)
                sum += (i + j + k) * (i + j + k - 1) * fabs(frame->q[(i * side + j) * side + k]);
    return sum;
}

/* The pixels of leaves, or all where there are no tiles. */
static int collect(const algsurf_i_picture *picture, const algsurf_i_band *band, int row,
                   const algsurf_i_line *line, algsurf_i_tiling *t) {
    int places = (picture->width + ALGSURF_I_LEAF - 1) / ALGSURF_I_LEAF, count = 0, begin, end;
    const int first = row % ALGSURF_I_TILES / ALGSURF_I_LEAF * places;
    algsurf_i_range_within_bounds(picture, row + 0.5, row + 0.5, 1, &begin, &end);
    if (begin < line->begin) begin = line->begin;
    if (end > line->end) end = line->end;
    for (int x = begin; x < end; x++) {
        int number = band ? band->cell[first + x / ALGSURF_I_LEAF] : 0;
        if (band && (number <= 0 || band->tiles[number - 1].enough > 0)) continue;
        if (line->wanted && !line->wanted[x]) continue;
        t->leaf[count] = x;
        t->leaf_low[count] = band ? band->tiles[number - 1].low : -1;
        t->leaf_high[count++] = band ? band->tiles[number - 1].high : 1;
    }
    return count;
}

void algsurf_i_add_thin(const algsurf_i_picture *picture, int row, double sx, double sy,
                        algsurf_i_worker *worker, algsurf_i_tally *tally) {
    algsurf_i_line *line = &worker->line;
    algsurf_i_tiling *t = &worker->tiling;
    const algsurf_i_packets *p = picture->packets;
    const algsurf_i_band *band = picture->tiled ? algsurf_i_band_of(picture, row, 1, t) : NULL;
    int count = collect(picture, band, row, line, t);
    if (count == 0) return;
    algsurf_i_row_job job;
    algsurf_i_make_row(picture, row + sy, sx, &worker->form, &job);
    algsurf_i_row_expand(&p->frame, worker->form.v, &worker->form);
    job.pixel /= line->across;
    double side = fabs(job.du * job.pixel), bend = 2 * side * (1 + fabs(p->frame.view.alpha));
    (void)bend;
    job.pixel *= line->across;
    const algsurf_i_thin_job thin = {.side = side, .large = bend * bend * second_sizes(&p->frame)};
    for (int i = 0; i < line->count; i++) {
        algsurf_ray ray;
        if (line->state[line->pixel[i]] != ALGSURF_HIT) continue;
        algsurf_i_camera_ray(&picture->scene->camera, picture->width, picture->height, line->pixel[i] + sx,
                             row + sy, &ray);
        line->depth[line->pixel[i]] = p->near + line->points.t[i] * depth_per_t(picture, &ray) - BEFORE * side;
    }
    for (int i = 0; i < count; i++) {
        int x = t->leaf[i];
        if (line->state[x] == ALGSURF_HIT && t->leaf_high[i] > line->depth[x]) t->leaf_high[i] = line->depth[x];
    }
    const algsurf_i_point_job points = {picture->scene->surface, &job, NULL};
    const algsurf_i_leaves rays = {count, t->leaf, t->leaf_low, t->leaf_high};
    picture->code->find_thin(&points, &thin, &rays, t->leaf_depth);
    for (int i = 0; i < count; i++) {
        int x = t->leaf[i], point = -1;
        algsurf_ray ray;
        if (!(t->leaf_depth[i] < HUGE_VAL)) continue;
        for (int k = 0; k < line->count; k++)
            if (line->pixel[k] == x) point = k;
        algsurf_i_camera_ray(&picture->scene->camera, picture->width, picture->height, x + sx, row + sy, &ray);
        show(picture, x, (t->leaf_depth[i] - p->near) / depth_per_t(picture, &ray), &ray, line, point);
        tally->thin++;
    }
}
