/* row.c - one row of a picture.
 *
 * A row is drawn in n x n passes, one for each sample of the pixels' grid: first all rays of the pass
 * meet the surface, then all hits are shaded, if colours are asked for.  So the buffer holds one row of one
 * sample, however many samples a pixel has, and solving and shading can be timed with two clock readings a
 * pass.  A single sample's points are written as they are; those of several are added up.  In a selective
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

/* So line->state tells of every point what it is. */
_Static_assert((int)ALGSURF_LANE_HIT == (int)ALGSURF_HIT, "both are the state of a pixel");

void algsurf_i_line_add(algsurf_i_line *line, int x, const algsurf_ray *ray, const algsurf_hit *hit,
                        algsurf_i_tally *tally) {
    const algsurf_i_points *points = &line->points;
    int i = line->count;
    line->state[x] = (uint8_t)hit->state;
    if (line->way) line->way[x] |= ALGSURF_WAY_SINGLE;
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

static double clamped(double colour) { return colour < 0 ? 0 : colour > 1 ? 1 : colour; }

static uint8_t byte_of(double colour) { return (uint8_t)(255 * colour + 0.5); }

uint32_t algsurf_i_bytes_of(const double colour[3]) {
    uint32_t bytes = 0;
    for (int k = 2; k >= 0; k--) bytes = bytes << 8 | byte_of(clamped(colour[k]));
    return bytes;
}

static algsurf_i_points points_from(const algsurf_i_points *p, int first) {
    algsurf_i_points rest = {.t = p->t + first, .bytes = p->bytes ? p->bytes + first : NULL};
    for (int k = 0; k < 3; k++) {
        rest.position[k] = p->position[k] + first;
        rest.normal[k] = p->normal[k] + first;
        rest.direction[k] = p->direction[k] + first;
    }
    return rest;
}

algsurf_i_points algsurf_i_points_to_find(const algsurf_i_picture *picture, const algsurf_i_line *line,
                                          int first) {
    algsurf_i_points points = points_from(&line->points, first);
    if (!picture->at_once) {
        points.bytes = NULL;
        return points;
    }
    if (!points.bytes) points.colour = line->colour + 3 * first;
    for (int k = 0; k < 3; k++) {
        points.position[k] = points.direction[k] = NULL;
        if (!picture->planes.normals) points.normal[k] = NULL;
    }
    return points;
}

/* Colours of the points. */
static algsurf_status shade_line(const algsurf_i_picture *picture, algsurf_i_line *line,
                                 algsurf_i_tally *tally) {
    const algsurf_scene *scene = picture->scene;
    uint32_t *bytes = line->points.bytes;
    if (line->done == line->count) return ALGSURF_OK;
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
        for (int i = 0; bytes && i < line->count; i++) bytes[i] = algsurf_i_bytes_of(line->colour + 3 * i);
    } else {
        const algsurf_i_points rest = points_from(&line->points, line->done);
        picture->code->colours(&picture->colours, &rest, line->count - line->done,
                               picture->shadows ? line->visible : NULL,
                               rest.bytes ? NULL : line->colour + 3 * line->done);
    }
    tally->shade_s += algsurf_i_render_clock() - begun;
    return ALGSURF_OK;
}

/* Before a pass's points are added: the normals and states of those that are nearest. */
static void keep_nearest(const algsurf_i_line *line) {
    const algsurf_i_points *points = &line->points;
    double *normal = line->shown.normal;
    uint8_t *state = line->shown.state;
    if (!normal && !state) return;
    for (int i = 0; i < line->count; i++) {
        int x = line->pixel[i];
        if (!algsurf_i_is_nearest(&line->shown, x, points->t[i])) continue;
        if (state) state[x] = line->state[x];
        for (int k = 0; normal && k < 3; k++) normal[3 * x + k] = points->normal[k][i];
    }
}

static void raise_ways(uint8_t *way, const uint8_t *other, int width) {
    for (int x = 0; way && x < width; x++)
        if (way[x] < other[x]) way[x] = other[x];
}

/* Adds a pass's points to what the pixels show. */
static void add_pass(const algsurf_i_line *line) {
    for (int i = 0; i < line->count; i++) {
        const double *colour = line->colour + 3 * i;
        const double shown[3] = {clamped(colour[0]), clamped(colour[1]), clamped(colour[2])};
        algsurf_i_add_sample(&line->shown, line->pixel[i], shown, line->points.t[i]);
    }
}

/* What a row shows where it has no points. */
static void fill_background(const algsurf_i_picture *picture, int channels, uint8_t *bytes) {
    size_t length = (size_t)channels * (size_t)picture->width, done = (size_t)channels;
    for (int k = 0; k < 3; k++) bytes[k] = byte_of(clamped(picture->scene->background[k]));
    if (channels == 4) bytes[3] = picture->scene->transparent ? 0 : 255;
    for (; done < length; done *= 2) memcpy(bytes + done, bytes, done < length - done ? done : length - done);
}

/* Averages over all samples; those without a point show the background.  Where there is none, alpha is the
 * share of the others, and the average is over them.  With a known number of channels it is faster. */
static inline void store_averages(const algsurf_i_shown *shown, int all, const double sky[3], int transparent,
                                  int channels, int width, uint8_t *bytes) {
    const uint16_t *counts = shown->samples;
    const double *sums = shown->sum, share = 1.0 / all;
    for (int x = 0; x < width; x++) {
        int samples = counts[x];
        const double *sum = sums + 3 * x;
        uint8_t *pixel = bytes + channels * x;
        if (samples == 0) continue;
        double weight = transparent && channels == 4 ? 1.0 / samples : share;
        for (int k = 0; k < 3; k++) pixel[k] = byte_of((sum[k] + (all - samples) * sky[k]) * weight);
        if (channels == 4) pixel[3] = transparent ? byte_of(samples * share) : 255;
    }
}

void algsurf_i_store_colours(const algsurf_i_picture *picture, const algsurf_i_shown *shown, int all,
                             int channels, uint8_t *bytes) {
    int transparent = picture->scene->transparent, width = picture->width;
    double sky[3];
    for (int k = 0; k < 3; k++) sky[k] = clamped(picture->scene->background[k]);
    fill_background(picture, channels, bytes);
    if (channels == 4)
        store_averages(shown, all, sky, transparent, 4, width, bytes);
    else
        store_averages(shown, all, sky, transparent, 3, width, bytes);
}

/* The planes besides the pixels, from entry `first` on. */
static void store_geometry(const algsurf_picture *planes, const algsurf_i_shown *shown, size_t first,
                           int width) {
    const uint16_t *samples = shown->samples;
    for (int x = 0; planes->t && x < width; x++)
        planes->t[first + (size_t)x] = samples[x] > 0 ? shown->nearest[x] : INFINITY;
    for (int x = 0; planes->state && x < width; x++)
        planes->state[first + (size_t)x] = samples[x] > 0 ? shown->state[x] : ALGSURF_MISS;
    if (planes->way) memcpy(planes->way + first, shown->way, (size_t)width);
    for (int x = 0; planes->normals && x < width; x++) {
        float *normal = planes->normals + 3 * (first + (size_t)x);
        for (int k = 0; k < 3; k++) normal[k] = samples[x] > 0 ? (float)shown->normal[3 * x + k] : 0;
    }
}

/* The line's points, seen through offset (sx,sy) in each wanted pixel, and their colours. */
static algsurf_status see(const algsurf_i_picture *picture, int row, double sx, double sy,
                          algsurf_i_worker *worker, algsurf_i_tally *tally) {
    algsurf_i_line *line = &worker->line;
    line->count = line->done = 0;
    if (stopped(picture)) return ALGSURF_CANCELLED;
    if (line->way) memset(line->way, ALGSURF_WAY_ROW, (size_t)picture->width);
    algsurf_status status = picture->packets ? algsurf_i_render_packets(picture, row, sx, sy, worker, tally)
                                             : algsurf_i_render_rays(picture, row, sx, sy, line, tally);
    if (status == ALGSURF_OK && line->coloured) status = shade_line(picture, line, tally);
    if (status == ALGSURF_OK && picture->thin && picture->packets)
        algsurf_i_add_thin(picture, row, sx, sy, worker, tally);
    return status;
}

algsurf_status algsurf_i_render_pass(const algsurf_i_picture *picture, int row, double sx, double sy,
                                     algsurf_i_worker *worker, algsurf_i_tally *tally) {
    algsurf_status status = see(picture, row, sx, sy, worker, tally);
    if (status == ALGSURF_OK) {
        keep_nearest(&worker->line);
        raise_ways(worker->line.shown.way, worker->line.way, picture->width);
        add_pass(&worker->line);
    }
    return status;
}

static void store_word(uint32_t word, uint8_t *bytes) {
    for (int k = 0; k < 4; k++) bytes[k] = (uint8_t)(word >> 8 * k);
}

/* Colours, with alpha or four at a time. */
static void store_bytes(const uint32_t *colours, int count, int channels, uint8_t *bytes) {
    int i = 0;
    for (; channels == 4 && i < count; i++) store_word(colours[i] | 0xff000000u, bytes + 4 * i);
    for (; i + 4 <= count; i += 4) {
        const uint32_t *c = colours + i;
        store_word(c[0] | c[1] << 24, bytes + 3 * i);
        store_word(c[1] >> 8 | c[2] << 16, bytes + 3 * i + 4);
        store_word(c[2] >> 16 | c[3] << 8, bytes + 3 * i + 8);
    }
    for (; i < count; i++)
        for (int k = 0; k < 3; k++) bytes[3 * i + k] = (uint8_t)(colours[i] >> 8 * k);
}

/* One sample a pixel: the row's points as they are, with the bytes that their average would have. */
static void store_points(const algsurf_i_picture *picture, const algsurf_i_line *line, size_t index) {
    const algsurf_picture *planes = &picture->planes;
    const algsurf_i_points *p = &line->points;
    int channels = picture->channels, width = picture->width;
    size_t first = index * (size_t)width;
    uint8_t *bytes = planes->pixels ? planes->pixels + index * planes->stride : NULL;
    if (bytes) fill_background(picture, channels, bytes);
    for (int x = 0; planes->t && x < width; x++) planes->t[first + (size_t)x] = INFINITY;
    if (planes->state) memset(planes->state + first, ALGSURF_MISS, (size_t)width);
    if (planes->way) memcpy(planes->way + first, line->way, (size_t)width);
    if (planes->normals) memset(planes->normals + 3 * first, 0, 3 * (size_t)width * sizeof *planes->normals);
    for (int i = 0, end; i < line->count; i = end) { /* pixels that follow each other */
        size_t x = (size_t)line->pixel[i];
        for (end = i + 1; end < line->count && line->pixel[end] == line->pixel[end - 1] + 1;) end++;
        size_t count = (size_t)(end - i);
        if (bytes) store_bytes(p->bytes + i, end - i, channels, bytes + (size_t)channels * x);
        if (planes->t) memcpy(planes->t + first + x, p->t + i, count * sizeof *p->t);
        if (planes->state) memcpy(planes->state + first + x, line->state + x, count);
    }
    for (int i = 0; planes->normals && i < line->count; i++) {
        size_t x = (size_t)line->pixel[i];
        for (int k = 0; k < 3; k++) planes->normals[3 * (first + x) + (size_t)k] = (float)p->normal[k][i];
    }
}

static void store_row(const algsurf_i_picture *picture, int row, algsurf_i_worker *worker) {
    const algsurf_picture *planes = &picture->planes;
    const algsurf_i_shown *shown = &worker->line.shown;
    size_t index = (size_t)(row - picture->row_begin);
    int n = picture->scene->antialias;
    if (planes->pixels) {
        uint8_t *bytes = planes->pixels + index * planes->stride;
        algsurf_i_store_colours(picture, shown, n * n, picture->channels, bytes);
        if (picture->selective) algsurf_i_store_middles(picture, row, worker, bytes);
    }
    if (picture->selective) {
        algsurf_i_add_middles(picture, row, 0, worker);
        raise_ways(shown->way, worker->middles.shown[row % 3].way, picture->width);
    }
    store_geometry(planes, shown, index * (size_t)picture->width, picture->width);
}

/* n x n samples a pixel. */
static algsurf_status render_samples(const algsurf_i_picture *picture, int row, algsurf_i_worker *worker,
                                     algsurf_i_tally *tally) {
    algsurf_i_line *line = &worker->line;
    algsurf_status status = ALGSURF_OK;
    int n = picture->scene->antialias;
    if (picture->selective) status = algsurf_i_choose_pixels(picture, row, worker, tally);
    line->coloured = picture->planes.pixels != NULL;
    algsurf_i_begin_shown(&line->shown, picture->width);
    line->across = n;
    for (int k = 0; k < n * n && line->wanted_count > 0 && status == ALGSURF_OK; k++) {
        if (picture->selective && 2 * k + 1 == n * n)
            algsurf_i_add_middles(picture, row, 1, worker);
        else
            status = algsurf_i_render_pass(picture, row, (k % n + 0.5) / n, (k / n + 0.5) / n, worker, tally);
    }
    if (status == ALGSURF_OK) store_row(picture, row, worker);
    return status;
}

/* One sample a pixel. */
static algsurf_status render_points(const algsurf_i_picture *picture, int row, algsurf_i_worker *worker,
                                    algsurf_i_tally *tally) {
    worker->line.coloured = picture->planes.pixels != NULL;
    worker->line.across = 1;
    algsurf_status status = see(picture, row, 0.5, 0.5, worker, tally);
    if (status == ALGSURF_OK) store_points(picture, &worker->line, (size_t)(row - picture->row_begin));
    return status;
}

algsurf_status algsurf_i_render_row(const algsurf_i_picture *picture, int row, algsurf_i_worker *worker,
                                    algsurf_i_tally *tally) {
    algsurf_i_line *line = &worker->line;
    line->wanted = NULL;
    line->wanted_count = picture->width;
    algsurf_status status = picture->scene->antialias > 1 ? render_samples(picture, row, worker, tally)
                                                          : render_points(picture, row, worker, tally);
    if (picture->tiled) algsurf_i_count_tiles(picture, row, &worker->tiling, tally);
    return status;
}
