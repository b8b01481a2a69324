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
#include "antialias.h"
#include "impl.h"
#include "line.h"
#include "solve.h"
#include "shadow.h"
#include "srgb.h"
#include "thin.h"
#include "tiling.h"

#include <math.h>
#include <string.h>
#include <time.h>

double algsurf_i_render_clock(const algsurf_i_picture *picture) {
    struct timespec now = {0, 0};
    if (!picture->timed) return 0;
    (void)clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static int stopped(const algsurf_i_picture *picture) {
    return atomic_load_explicit(&picture->stop, memory_order_relaxed);
}

/* Colours of the points. */
static algsurf_status shade_line(const algsurf_i_picture *picture, int row, algsurf_i_line *line,
                                 algsurf_i_tally *tally) {
    double begun = algsurf_i_render_clock(picture);
    if (picture->shadows) {
        algsurf_status status = algsurf_i_render_shadows(picture, row, line, tally);
        if (status != ALGSURF_OK) return status;
        double now = algsurf_i_render_clock(picture);
        tally->shadow_s += now - begun;
        begun = now;
    }
    picture->shader->colours(line->colours, &line->points.looks, line->count,
                             picture->shadows ? line->visible : NULL, line->as_bytes ? NULL : line->colour,
                             line->bytes);
    tally->shade_s += algsurf_i_render_clock(picture) - begun;
    return ALGSURF_OK;
}

/* Before a point is added to pixel x: the normal and state of the nearest one. */
static void keep_nearest(const algsurf_i_line *line, int i, int x, uint8_t kind) {
    const algsurf_i_points *points = &line->points;
    double *normal = line->shown.normal;
    uint8_t *state = line->shown.state;
    if (!algsurf_i_is_nearest(&line->shown, x, points->t[i])) return;
    if (state) state[x] = kind;
    for (int k = 0; normal && k < 3; k++) normal[3 * x + k] = points->normal[k][i];
}

static void raise_ways(const algsurf_i_line *line) {
    uint8_t *way = line->shown.way;
    for (int x = line->dense * line->begin; way && x < line->dense * line->end; x++)
        if (way[x / line->dense] < line->way[x]) way[x / line->dense] = line->way[x];
}

/* Adds the points to what the pixels show.  all_hit: 1, they are; 0, states tell. */
static void add_points(const algsurf_i_line *line, int all_hit) {
    const int keeps = line->shown.normal || line->shown.state;
    for (int i = 0; i < line->count; i++) {
        int at = line->pixel[i], x = line->dense > 1 ? at / line->dense : at;
        if (keeps) keep_nearest(line, i, x, all_hit ? ALGSURF_HIT : line->state[at]);
        algsurf_i_add_sample(&line->shown, x, line->points.t[i]);
        for (int k = 0; line->colours && k < 3; k++) line->shown.sum[3 * x + k] += line->colour[3 * i + k];
    }
}

/* What a row shows where it has no points. */
static void fill_background(const algsurf_i_picture *picture, int channels, uint8_t *bytes) {
    size_t length = (size_t)channels * (size_t)picture->width, done = (size_t)channels;
    for (int k = 0; k < 3; k++) bytes[k] = algsurf_i_byte_of(picture->curve, picture->scene->background[k]);
    if (channels == 4) bytes[3] = picture->scene->transparent ? 0 : 255;
    for (; done < length; done *= 2) memcpy(bytes + done, bytes, done < length - done ? done : length - done);
}

/* The average over all samples of pixel x; those without a point show the background.  Where there is none,
 * alpha is the share of the others, and the average is over them. */
static void store_average(const algsurf_i_picture *picture, const algsurf_i_shown *shown, int all, int x,
                          int channels, uint8_t *pixel) {
    const algsurf_scene *scene = picture->scene;
    int samples = shown->samples[x];
    const double *sum = shown->sum + 3 * x;
    double share = 1.0 / all, weight = scene->transparent && channels == 4 ? 1.0 / samples : share;
    for (int k = 0; k < 3; k++) {
        double light = (sum[k] + (all - samples) * scene->background[k]) * weight;
        pixel[k] = algsurf_i_byte_of(picture->curve, light < 1 ? light : 1);
    }
    if (channels == 4) pixel[3] = scene->transparent ? (uint8_t)(255 * (samples * share) + 0.5) : 255;
}

/* Row number `row` of the caller's planes. */
static algsurf_i_row_planes row_planes(const algsurf_i_picture *picture, int row) {
    const algsurf_picture *planes = &picture->planes;
    size_t index = (size_t)(row - picture->row_begin), first = index * (size_t)picture->width;
    return (algsurf_i_row_planes){.pixels = planes->pixels ? planes->pixels + index * planes->stride : NULL,
                                  .channels = picture->channels,
                                  .t = planes->t ? planes->t + first : NULL,
                                  .normals = planes->normals ? planes->normals + 3 * first : NULL,
                                  .state = planes->state ? planes->state + first : NULL,
                                  .way = planes->way ? planes->way + first : NULL};
}

/* A row that shows nothing. */
static void clear_row(const algsurf_i_picture *picture, const algsurf_i_row_planes *to) {
    size_t width = (size_t)picture->width;
    if (to->pixels) fill_background(picture, to->channels, to->pixels);
    for (size_t x = 0; to->t && x < width; x++) to->t[x] = INFINITY;
    if (to->state) memset(to->state, ALGSURF_MISS, width);
    if (to->normals) memset(to->normals, 0, 3 * width * sizeof *to->normals);
}

static void clear_pixel(const algsurf_i_picture *picture, int x, const algsurf_i_row_planes *to) {
    for (int k = 0; to->pixels && k < 3; k++)
        to->pixels[to->channels * x + k] = algsurf_i_byte_of(picture->curve, picture->scene->background[k]);
    if (to->pixels && to->channels == 4) to->pixels[4 * x + 3] = picture->scene->transparent ? 0 : 255;
    if (to->t) to->t[x] = INFINITY;
    if (to->state) to->state[x] = ALGSURF_MISS;
    for (int k = 0; to->normals && k < 3; k++) to->normals[3 * x + k] = 0;
}

/* What pixel x shows through all its samples, into a row that shows nothing there. */
static void store_pixel(const algsurf_i_picture *picture, const algsurf_i_shown *shown, int x,
                        const algsurf_i_row_planes *to) {
    int n = picture->scene->antialias, seen = shown->samples[x] > 0;
    if (to->way) to->way[x] = shown->way[x];
    if (!seen) return;
    if (to->pixels)
        store_average(picture, shown, n * n, x, to->channels, to->pixels + (size_t)to->channels * (size_t)x);
    if (to->t) to->t[x] = shown->nearest[x];
    if (to->state) to->state[x] = shown->state[x];
    for (int k = 0; to->normals && k < 3; k++) to->normals[3 * x + k] = (float)shown->normal[3 * x + k];
}

/* The line's points, seen through offset (sx,sy) in each wanted pixel, and their colours. */
static algsurf_status see(const algsurf_i_picture *picture, int row, double sx, double sy,
                          algsurf_i_worker *worker, algsurf_i_tally *tally) {
    algsurf_i_line *line = &worker->line;
    line->count = 0;
    if (stopped(picture)) return ALGSURF_CANCELLED;
    if (line->way)
        memset(line->way + line->dense * line->begin, ALGSURF_WAY_ROW,
               (size_t)(line->dense * (line->end - line->begin)));
    algsurf_status status = picture->scene->complex
                                ? algsurf_i_solve_complex_row(picture, row, sx, sy, worker, tally)
                            : picture->geometry ? algsurf_i_solve_row(picture, row, sx, sy, worker, tally)
                                                : algsurf_i_solve_rays(picture, row, sx, sy, line, tally);
    if (status == ALGSURF_OK && line->colours) status = shade_line(picture, row, line, tally);
    if (status == ALGSURF_OK && picture->thin && !(picture->selective && line->across > 1))
        algsurf_i_add_thin(picture, row, sx, sy, worker, tally);
    return status;
}

/* Adds the row's points seen through offset (sx,sy) in each wanted pixel to what the line shows. */
static algsurf_status render_pass(const algsurf_i_picture *picture, int row, double sx, double sy,
                                  algsurf_i_worker *worker, algsurf_i_tally *tally) {
    algsurf_status status = see(picture, row, sx, sy, worker, tally);
    if (status != ALGSURF_OK) return status;
    raise_ways(&worker->line);
    add_points(&worker->line, 0);
    return ALGSURF_OK;
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
static void store_points(const algsurf_i_picture *picture, const algsurf_i_line *line,
                         const algsurf_i_row_planes *to) {
    const algsurf_i_points *p = &line->points;
    clear_row(picture, to);
    if (to->way) memcpy(to->way, line->way, (size_t)picture->width);
    for (int i = 0, end; i < line->count; i = end) { /* pixels that follow each other */
        size_t x = (size_t)line->pixel[i];
        for (end = i + 1; end < line->count && line->pixel[end] == line->pixel[end - 1] + 1;) end++;
        size_t count = (size_t)(end - i);
        if (to->pixels)
            store_bytes(line->bytes + i, end - i, to->channels, to->pixels + (size_t)to->channels * x);
        if (to->t) memcpy(to->t + x, p->t + i, count * sizeof *p->t);
        if (to->state) memcpy(to->state + x, line->state + x, count);
    }
    for (int i = 0; to->normals && i < line->count; i++) {
        size_t x = (size_t)line->pixel[i];
        for (size_t k = 0; k < 3; k++) to->normals[3 * x + k] = (float)p->normal[k][i];
    }
}

algsurf_status algsurf_i_render_middles(const algsurf_i_picture *picture, int row,
                                        const algsurf_i_row_planes *planes, algsurf_i_worker *worker,
                                        algsurf_i_tally *tally) {
    algsurf_i_line *line = &worker->line;
    line->wanted = NULL;
    line->wanted_count = picture->width;
    line->colours = planes->pixels ? &picture->colours : NULL;
    line->across = line->dense = 1;
    line->sample = 0;
    line->as_bytes = 1;
    algsurf_status status = see(picture, row, 0.5, 0.5, worker, tally);
    if (status == ALGSURF_OK) store_points(picture, line, planes);
    return status;
}

/* All samples of the wanted pixels of a row, one pass for each. */
static algsurf_status render_passes(const algsurf_i_picture *picture, int row, algsurf_i_worker *worker,
                                    algsurf_i_tally *tally) {
    algsurf_i_line *line = &worker->line;
    algsurf_status status = ALGSURF_OK;
    int n = picture->scene->antialias;
    line->dense = 1;
    for (int k = 0; k < n * n && status == ALGSURF_OK; k++) {
        line->sample = k;
        status = render_pass(picture, row, (k % n + 0.5) / n, (k / n + 0.5) / n, worker, tally);
    }
    return status;
}

/* The line's points get their colours and are added to what the pixels show. */
static algsurf_status add_coloured(const algsurf_i_picture *picture, int row, int all_hit,
                                   algsurf_i_line *line, algsurf_i_tally *tally) {
    algsurf_status status = ALGSURF_OK;
    if (line->count == 0) return ALGSURF_OK;
    if (line->colours) status = shade_line(picture, row, line, tally);
    if (status == ALGSURF_OK) add_points(line, all_hit);
    line->count = 0;
    return status;
}

/* Row j of the listed pixels' samples.  Those not undecided wait, as long as there is room, to be coloured
 * with those of the rows that follow; in full quality colours depend on the row. */
static algsurf_status render_samples_row(const algsurf_i_picture *picture, int row, int j,
                                         algsurf_i_worker *worker, algsurf_i_tally *tally) {
    algsurf_i_line *line = &worker->line;
    const int n = line->dense;
    algsurf_status status = ALGSURF_OK;
    if (stopped(picture)) return ALGSURF_CANCELLED;
    if (picture->shadows || line->count + n * line->wanted_count > picture->width)
        status = add_coloured(picture, row, 1, line, tally);
    if (status != ALGSURF_OK) return status;
    line->sample = j * n;
    double y = row + (j + 0.5) / n;
    int undecided = algsurf_i_solve_listed(picture, row, (j + 0.5) / n, worker, tally);
    if (undecided) {
        status = add_coloured(picture, row, 1, line, tally);
        if (status == ALGSURF_OK)
            status = algsurf_i_solve_undecided(picture, y, 0.5, n * line->begin, n * line->end, line, tally);
        if (status == ALGSURF_OK) status = add_coloured(picture, row, 0, line, tally);
    }
    raise_ways(line);
    return status;
}

/* The same where few are wanted and rays have forms: a pass takes the samples of a row of them together. */
static algsurf_status render_dense(const algsurf_i_picture *picture, int row, algsurf_i_worker *worker,
                                   algsurf_i_tally *tally) {
    algsurf_i_line *line = &worker->line;
    algsurf_status status = ALGSURF_OK;
    const int n = picture->scene->antialias, all = line->wanted_count;
    const int most = picture->width > n ? picture->width / n : 1; /* pixels at once, as a line has room for */
    line->dense = n;
    line->count = 0;
    for (line->listed = 0; line->listed < all && status == ALGSURF_OK; line->listed += most) {
        line->wanted_count = all - line->listed < most ? all - line->listed : most;
        line->begin = line->list[line->listed];
        line->end = line->list[line->listed + line->wanted_count - 1] + 1;
        const size_t first = (size_t)(n * line->begin), count = (size_t)(n * line->end) - first;
        memset(line->state + first, ALGSURF_LANE_MISS, count);
        if (line->way) memset(line->way + first, ALGSURF_WAY_EMPTY, count);
        for (int j = 0; j < n && status == ALGSURF_OK; j++)
            status = render_samples_row(picture, row, j, worker, tally);
        if (status == ALGSURF_OK) status = add_coloured(picture, row, 1, line, tally);
    }
    line->begin = 0;
    line->end = picture->width;
    line->wanted_count = all;
    return status;
}

/* n x n samples a pixel. */
static algsurf_status render_samples(const algsurf_i_picture *picture, int row, algsurf_i_worker *worker,
                                     algsurf_i_tally *tally) {
    algsurf_i_line *line = &worker->line;
    const algsurf_i_row_planes to = row_planes(picture, row);
    algsurf_status status = ALGSURF_OK;
    if (picture->selective) status = algsurf_i_choose_pixels(picture, row, worker, tally);
    line->colours = picture->planes.pixels ? &picture->colours : NULL;
    line->across = picture->scene->antialias;
    line->as_bytes = 0;
    if (status == ALGSURF_OK && line->wanted_count > 0) {
        algsurf_i_begin_shown(&line->shown, picture->width);
        status = picture->selective && line->dense > 1 ? render_dense(picture, row, worker, tally)
                                                       : render_passes(picture, row, worker, tally);
    }
    if (status != ALGSURF_OK) return status;
    if (picture->selective)
        algsurf_i_copy_middles(&worker->middles, row, picture->width, &to);
    else
        clear_row(picture, &to);
    for (int i = 0; i < line->wanted_count; i++) {
        int x = picture->selective ? line->list[i] : i;
        if (picture->selective) clear_pixel(picture, x, &to);
        store_pixel(picture, &line->shown, x, &to);
    }
    return ALGSURF_OK;
}

algsurf_status algsurf_i_render_row(const algsurf_i_picture *picture, int row, algsurf_i_worker *worker,
                                    algsurf_i_tally *tally) {
    algsurf_i_line *line = &worker->line;
    const algsurf_i_row_planes to = row_planes(picture, row);
    line->wanted = NULL;
    line->wanted_count = picture->width;
    line->begin = 0;
    line->end = picture->width;
    algsurf_status status = picture->scene->antialias > 1
                                ? render_samples(picture, row, worker, tally)
                                : algsurf_i_render_middles(picture, row, &to, worker, tally);
    if (picture->tiled) algsurf_i_count_tiles(picture, row, &worker->tiling, tally);
    return status;
}
