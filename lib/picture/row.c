/* row.c - one row of a picture.
 *
 * A row is drawn in n x n passes, one for each sample of the pixels' grid: first all rays of the pass
 * meet the surface, then all hits are shaded.  So the buffer holds one row of one sample, however many
 * samples a pixel has, and solving and shading can be timed with two clock readings a pass.  In a selective
 * picture the passes are for the wanted pixels, and the others show their middles (antialias.c).
 */
#define _POSIX_C_SOURCE 200809L /* clock_gettime */
#include "../base/arithmetic.h"
#include "impl.h"

#include <string.h>
#include <time.h>

#include "camera_impl.h"
#include "shade_impl.h"
#include "../base/vec.h"

double algsurf_i_render_clock(void) {
    struct timespec now = {0, 0};
    (void)clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static int stopped(const algsurf_i_picture *picture) {
    return atomic_load_explicit(&picture->stop, memory_order_relaxed);
}

void algsurf_i_line_add(algsurf_i_line *line, int x, const algsurf_ray *ray, const algsurf_hit *hit,
                        algsurf_i_tally *tally) {
    const algsurf_i_points *points = &line->points;
    int i = line->count;
    tally->hits += hit->state == ALGSURF_HIT;
    tally->undecided += hit->state == ALGSURF_UNDECIDED;
    if (hit->state == ALGSURF_MISS) return;
    line->pixel[line->count++] = x;
    points->t[i] = hit->t;
    for (int k = 0; k < 3; k++) {
        points->position[k][i] = hit->position[k];
        points->normal[k][i] = hit->normal[k];
        points->direction[k][i] = ray->direction[k];
    }
}

/* Depth of a point along the view: 0 at the near end of what is shown, 1 at its far end.  Measured from
 * its centre, so that a far eye costs no digits. */
static double depth_of(const algsurf_i_picture *picture, const double point[3]) {
    double from_centre[3];
    for (int i = 0; i < 3; i++) from_centre[i] = point[i] - picture->centre[i];
    double along = algsurf_dot(from_centre, picture->scene->camera.forward) / picture->reach;
    return fmin(1, fmax(0, 0.5 + 0.5 * along));
}

static void shade_preview(const algsurf_i_picture *picture, algsurf_i_line *line) {
    const algsurf_i_points *p = &line->points;
    for (int i = 0; i < line->count; i++) {
        double position[3], normal[3], direction[3];
        for (int k = 0; k < 3; k++) {
            position[k] = p->position[k][i];
            normal[k] = p->normal[k][i];
            direction[k] = p->direction[k][i];
        }
        algsurf_i_shade_preview(&picture->scene->material, normal, direction, depth_of(picture, position),
                                line->colour + 3 * i);
    }
}

/* Colours of the points. */
static algsurf_status shade_line(const algsurf_i_picture *picture, algsurf_i_line *line,
                                 algsurf_i_tally *tally) {
    const algsurf_scene *scene = picture->scene;
    double begun = algsurf_i_render_clock();
    if (picture->shadows) {
        algsurf_status status = algsurf_i_render_shadows(picture, line, tally);
        if (status != ALGSURF_OK) return status;
        double now = algsurf_i_render_clock();
        tally->shadow_s += now - begun;
        begun = now;
    }
    if (scene->quality == ALGSURF_QUALITY_PREVIEW) {
        shade_preview(picture, line);
    } else {
        const algsurf_i_colour_job job = {&scene->material, picture->lights, picture->light_count};
        picture->code->colours(&job, &line->points, line->count, picture->shadows ? line->visible : NULL,
                               line->colour);
    }
    tally->shade_s += algsurf_i_render_clock() - begun;
    return ALGSURF_OK;
}

static double clamped(double colour) { return colour < 0 ? 0 : colour > 1 ? 1 : colour; }

/* Adds a pass's colours to the pixels' sums. */
static void add_pass(algsurf_i_line *line) {
    for (int i = 0; i < line->count; i++) {
        int x = line->pixel[i], first = line->samples[x]++ == 0;
        double t = line->points.t[i];
        for (int k = 0; k < 3; k++)
            line->sum[3 * x + k] = clamped(line->colour[3 * i + k]) + (first ? 0 : line->sum[3 * x + k]);
        line->nearest[x] = first || t < line->nearest[x] ? t : line->nearest[x];
    }
}

static uint8_t byte_of(double colour) { return (uint8_t)(255 * colour + 0.5); }

/* The averages over all samples as bytes; samples without a point show the background. */
static void store_colours(const algsurf_i_picture *picture, const algsurf_i_line *line, int all,
                          uint8_t *bytes) {
    double share = 1.0 / all;
    size_t length = 3 * (size_t)picture->width, done = 3;
    double sky[3];
    for (int k = 0; k < 3; k++) {
        sky[k] = clamped(picture->scene->background[k]);
        bytes[k] = byte_of(sky[k]);
    }
    for (; done < length; done *= 2) memcpy(bytes + done, bytes, done < length - done ? done : length - done);
    for (int x = 0; x < picture->width; x++) {
        int samples = line->samples[x];
        const double *sum = line->sum + 3 * x;
        if (samples == 0) continue;
        for (int k = 0; k < 3; k++) bytes[3 * x + k] = byte_of((sum[k] + (all - samples) * sky[k]) * share);
    }
}

void algsurf_i_store_line(const algsurf_i_picture *picture, const algsurf_i_line *line, int samples,
                          uint8_t *bytes, double *hits) {
    store_colours(picture, line, samples, bytes);
    for (int x = 0; hits && x < picture->width; x++) hits[x] = line->samples[x] > 0 ? line->nearest[x] : NAN;
}

algsurf_status algsurf_i_render_pass(const algsurf_i_picture *picture, int row, double sx, double sy,
                                     algsurf_i_worker *worker, algsurf_i_tally *tally) {
    algsurf_i_line *line = &worker->line;
    line->count = 0;
    if (stopped(picture)) return ALGSURF_CANCELLED;
    algsurf_status status = picture->packets ? algsurf_i_render_packets(picture, row, sx, sy, worker, tally)
                                             : algsurf_i_render_rays(picture, row, sx, sy, line, tally);
    if (status == ALGSURF_OK) status = shade_line(picture, line, tally);
    if (status == ALGSURF_OK) add_pass(line);
    return status;
}

static void store_row(const algsurf_i_picture *picture, int row, const algsurf_i_worker *worker) {
    size_t index = (size_t)(row - picture->row_begin);
    uint8_t *bytes = picture->pixels + index * picture->stride;
    double *hits = picture->hits ? picture->hits + index * (size_t)picture->width : NULL;
    int n = picture->scene->antialias;
    algsurf_i_store_line(picture, &worker->line, n * n, bytes, hits);
    if (picture->selective) algsurf_i_store_middles(picture, row, worker, bytes, hits);
}

algsurf_status algsurf_i_render_row(const algsurf_i_picture *picture, int row, algsurf_i_worker *worker,
                                    algsurf_i_tally *tally) {
    algsurf_i_line *line = &worker->line;
    algsurf_status status = ALGSURF_OK;
    int n = picture->scene->antialias;
    line->wanted = NULL;
    line->wanted_count = picture->width;
    if (picture->selective) status = algsurf_i_choose_pixels(picture, row, worker, tally);
    memset(line->samples, 0, (size_t)picture->width * sizeof *line->samples);
    for (int k = 0; k < n * n && line->wanted_count > 0 && status == ALGSURF_OK; k++) {
        if (picture->selective && 2 * k + 1 == n * n)
            algsurf_i_add_middles(picture, row, worker);
        else
            status = algsurf_i_render_pass(picture, row, (k % n + 0.5) / n, (k / n + 0.5) / n, worker, tally);
    }
    if (status == ALGSURF_OK) store_row(picture, row, worker);
    return status;
}
