/* row.c - one row of a picture.
 *
 * A row is drawn in n x n passes, one for each sample of the pixels' grid: first all rays of the pass
 * meet the surface, then all hits are shaded, if colours are asked for.  So the buffer holds one row of one
 * sample, however many samples a pixel has, and solving and shading can be timed with two clock readings a
 * pass.  A single sample's points are written as they are; those of several are added up, the corners' first.
 * In a selective picture the passes are for the wanted pixels, and the others show their middles
 * (antialias.c).
 */
#define _POSIX_C_SOURCE 200809L /* clock_gettime */
#include "../base/arithmetic.h"
#include "impl.h"

#include <math.h>
#include <string.h>
#include <time.h>

double algsurf_i_render_clock(const algsurf_i_picture *picture) {
    struct timespec now = {0, 0};
    if (!picture->timed) return 0;
    (void)clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/* Colours of the points. */
static algsurf_status shade_line(algsurf_i_worker *worker, int row) {
    const algsurf_i_picture *picture = worker->picture;
    const algsurf_i_line *line = &worker->line;
    if (picture->shadows) {
        algsurf_status status = algsurf_i_render_shadows(worker, row);
        algsurf_i_lap(worker, &worker->tally->stats.shadow_s);
        if (status != ALGSURF_OK) return status;
    }
    picture->shader->colours(line->colours, &line->points.looks, line->count,
                             picture->shadows ? line->visible : NULL, line->across == 1 ? NULL : line->colour,
                             line->bytes);
    algsurf_i_lap(worker, &worker->tally->stats.shade_s);
    return ALGSURF_OK;
}

static void raise_ways(const algsurf_i_line *line) {
    uint8_t *way = line->shown.way;
    for (int x = line->dense * line->begin; way && x < line->dense * line->end; x++)
        if (way[x / line->dense] < line->way[x]) way[x / line->dense] = line->way[x];
}

/* Adds the points to what the pixels show.  all_hit: 1, they are; 0, states tell. */
static void add_points(const algsurf_i_line *line, int all_hit) {
    const algsurf_i_shown *shown = &line->shown;
    const algsurf_i_points *points = &line->points;
    for (int i = 0; i < line->count; i++) {
        const int at = line->pixel[i], x = line->dense > 1 ? at / line->dense : at;
        const int first = shown->samples[x]++ == 0;
        for (int k = 0; line->colours && k < 3; k++)
            shown->sum[3 * x + k] = (first ? 0 : shown->sum[3 * x + k]) + line->colour[3 * i + k];
        if (!first && !(points->t[i] < shown->nearest[x])) continue;
        shown->nearest[x] = points->t[i];
        if (shown->state) shown->state[x] = all_hit ? ALGSURF_STATE_HIT : line->state[at];
        for (int k = 0; shown->normal && k < 3; k++) shown->normal[3 * x + k] = points->normal[k][i];
    }
}

/* The average over all samples of pixel x; those without a point show the background.  Where there is none,
 * alpha is the share of the others, and the average is over them. */
static void store_average(const algsurf_i_picture *picture, const algsurf_i_shown *shown, int x, int channels,
                          uint8_t *pixel) {
    const algsurf_scene *scene = picture->scene;
    int all = scene->antialias * scene->antialias, samples = shown->samples[x];
    const double *sum = shown->sum + 3 * x;
    double share = 1.0 / all, weight = scene->transparent && channels == 4 ? 1.0 / samples : share;
    for (int k = 0; k < 3; k++) {
        double light = (sum[k] + (all - samples) * scene->background[k]) * weight;
        pixel[k] = algsurf_i_byte_of(picture->curve, light < 1 ? light : 1);
    }
    if (channels == 4) pixel[3] = scene->transparent ? (uint8_t)(255 * (samples * share) + 0.5) : 255;
}

/* Row number `row` of the caller's planes. */
static algsurf_picture row_planes(const algsurf_i_picture *picture, int row) {
    algsurf_picture to = picture->planes;
    size_t index = (size_t)(row - picture->row_begin), first = index * (size_t)picture->width;
    if (to.pixels) to.pixels += index * to.stride;
    if (to.t) to.t += first;
    if (to.normals) to.normals += 3 * first;
    if (to.state) to.state += first;
    if (to.way) to.way += first;
    return to;
}

/* So many pixels from x on show nothing: but for their ways. */
static void clear(const algsurf_i_picture *picture, int x, int count, const algsurf_picture *to) {
    const size_t n = (size_t)count, channels = (size_t)algsurf_i_channels(to), length = channels * n;
    uint8_t *bytes = to->pixels ? to->pixels + channels * (size_t)x : NULL;
    for (size_t k = 0; bytes && k < channels; k++)
        bytes[k] = k < 3 ? algsurf_i_byte_of(picture->curve, picture->scene->background[k])
                         : (picture->scene->transparent ? 0 : 255);
    for (size_t done = channels; bytes && done < length; done *= 2)
        memcpy(bytes + done, bytes, done < length - done ? done : length - done);
    for (size_t i = 0; to->t && i < n; i++) to->t[x + (int)i] = INFINITY;
    if (to->state) memset(to->state + x, ALGSURF_STATE_MISS, n);
    if (to->normals) memset(to->normals + 3 * x, 0, 3 * n * sizeof *to->normals);
}

/* What pixel x shows through all its samples. */
static void store_pixel(const algsurf_i_picture *picture, const algsurf_i_shown *shown, int x,
                        const algsurf_picture *to) {
    const int channels = algsurf_i_channels(to);
    if (to->way) to->way[x] = shown->way[x];
    if (shown->samples[x] == 0) {
        clear(picture, x, 1, to);
        return;
    }
    if (to->pixels) store_average(picture, shown, x, channels, to->pixels + channels * x);
    if (to->t) to->t[x] = shown->nearest[x];
    if (to->state) to->state[x] = shown->state[x];
    for (int k = 0; to->normals && k < 3; k++) to->normals[3 * x + k] = (float)shown->normal[3 * x + k];
}

/* The line's points are all there but for the undecided ones: these, then colours and what is thin. */
static algsurf_status complete(algsurf_i_worker *worker, int row, double sx, double sy, int undecided) {
    algsurf_i_line *line = &worker->line;
    const int n = line->dense;
    algsurf_status status = ALGSURF_OK;
    if (undecided) status = algsurf_i_solve_undecided(worker, row + sy, sx, n * line->begin, n * line->end);
    algsurf_i_lap(worker, &worker->tally->stats.solve_s);
    if (status == ALGSURF_OK && line->colours) status = shade_line(worker, row);
    if (status == ALGSURF_OK && line->thin) algsurf_i_add_thin(worker, row, sx, sy);
    return status;
}

/* The line's points, seen through offset (sx,sy) in each wanted pixel, and their colours. */
static algsurf_status see(algsurf_i_worker *worker, int row, double sx, double sy) {
    const algsurf_i_picture *picture = worker->picture;
    algsurf_i_line *line = &worker->line;
    int undecided = 1;
    if (algsurf_i_stopped(picture)) return ALGSURF_CANCELLED;
    worker->lap = algsurf_i_render_clock(picture);
    worker->tally->stats.rays += (uint64_t)line->wanted_count;
    line->count = 0;
    if (line->way)
        memset(line->way + line->dense * line->begin, ALGSURF_WAY_ROW,
               (size_t)(line->dense * (line->end - line->begin)));
    if (!picture->geometry)
        algsurf_i_begin_states(line, 0);
    else if (picture->scene->complex)
        undecided = algsurf_i_solve_complex_row(worker, row, sx, sy);
    else
        undecided = algsurf_i_solve_row(worker, row, sx, sy);
    return complete(worker, row, sx, sy, undecided);
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
                         const algsurf_picture *to) {
    const algsurf_i_points *p = &line->points;
    const int channels = algsurf_i_channels(to);
    clear(picture, 0, picture->width, to);
    if (to->way) memcpy(to->way, line->way, (size_t)picture->width);
    for (int i = 0, end; i < line->count; i = end) { /* pixels that follow each other */
        size_t x = (size_t)line->pixel[i];
        for (end = i + 1; end < line->count && line->pixel[end] == line->pixel[end - 1] + 1;) end++;
        size_t count = (size_t)(end - i);
        if (to->pixels) store_bytes(line->bytes + i, end - i, channels, to->pixels + (size_t)channels * x);
        if (to->t) memcpy(to->t + x, p->t + i, count * sizeof *p->t);
        if (to->state) memcpy(to->state + x, line->state + x, count);
    }
    for (int i = 0; to->normals && i < line->count; i++) {
        size_t x = (size_t)line->pixel[i];
        for (size_t k = 0; k < 3; k++) to->normals[3 * x + k] = (float)p->normal[k][i];
    }
}

algsurf_status algsurf_i_render_middles(algsurf_i_worker *worker, int row, const algsurf_picture *planes) {
    const algsurf_i_picture *picture = worker->picture;
    algsurf_i_line *line = &worker->line;
    line->wanted = NULL;
    line->wanted_count = picture->width;
    line->colours = planes->pixels ? &picture->colours : NULL;
    line->across = line->dense = 1;
    line->sample = 0;
    line->thin = picture->thin;
    algsurf_status status = see(worker, row, 0.5, 0.5);
    if (status == ALGSURF_OK) store_points(picture, line, planes);
    return status;
}

/* The corners, or the other samples, of the wanted pixels of a row, one pass for each. */
static algsurf_status render_passes(algsurf_i_worker *worker, int row) {
    algsurf_i_line *line = &worker->line;
    const int n = line->across;
    line->dense = 1;
    for (line->sample = 0; line->sample < n * n; line->sample++) {
        const int k = line->sample;
        if (!algsurf_i_is_in_pass(line, k)) continue;
        algsurf_status status = see(worker, row, (k % n + 0.5) / n, (k / n + 0.5) / n);
        if (status != ALGSURF_OK) return status;
        raise_ways(line);
        add_points(line, 0);
    }
    return ALGSURF_OK;
}

/* The line's points get their colours and are added to what the pixels show. */
static algsurf_status add_coloured(algsurf_i_worker *worker, int row, int all_hit) {
    algsurf_i_line *line = &worker->line;
    algsurf_status status = ALGSURF_OK;
    if (line->count == 0) return ALGSURF_OK;
    if (line->colours) status = shade_line(worker, row);
    if (status == ALGSURF_OK) add_points(line, all_hit);
    line->count = 0;
    return status;
}

/* What is in the pass of row j of the listed pixels' samples.  Those not undecided wait, as long as there is
 * room, to be coloured with those of the rows that follow; in full quality colours depend on the row. */
static algsurf_status render_samples_row(algsurf_i_worker *worker, int row, int j) {
    const algsurf_i_picture *picture = worker->picture;
    algsurf_i_line *line = &worker->line;
    const int n = line->dense;
    const double sy = (j + 0.5) / n;
    const size_t first = (size_t)(n * line->begin), count = (size_t)(n * line->end) - first;
    algsurf_status status = ALGSURF_OK;
    if (algsurf_i_stopped(picture)) return ALGSURF_CANCELLED;
    memset(line->state + first, ALGSURF_LANE_MISS, count);
    if (line->way) memset(line->way + first, ALGSURF_WAY_EMPTY, count);
    worker->lap = algsurf_i_render_clock(picture);
    if (picture->shadows || line->count + n * line->wanted_count > picture->width)
        status = add_coloured(worker, row, 1);
    if (status != ALGSURF_OK) return status;
    line->sample = j * n;
    const int undecided = algsurf_i_solve_listed(worker, row, sy);
    if (line->thin || undecided) {
        if (!line->thin) status = add_coloured(worker, row, 1);
        if (status == ALGSURF_OK) status = complete(worker, row, 0.5, sy, undecided);
        if (status == ALGSURF_OK) add_points(line, 0);
        line->count = 0;
    }
    raise_ways(line);
    return status;
}

/* The same where few are wanted and rays have forms: a pass takes the samples of a row of them together. */
static algsurf_status render_dense(algsurf_i_worker *worker, int row) {
    algsurf_i_line *line = &worker->line;
    algsurf_status status = ALGSURF_OK;
    const int width = worker->picture->width, n = line->dense, all = line->wanted_count;
    const int most = width > n ? width / n : 1; /* pixels at once, as a line has room for */
    line->count = 0;
    for (line->listed = 0; line->listed < all && status == ALGSURF_OK; line->listed += most) {
        line->wanted_count = all - line->listed < most ? all - line->listed : most;
        line->begin = line->list[line->listed];
        line->end = line->list[line->listed + line->wanted_count - 1] + 1;
        for (int j = 0; j < n && status == ALGSURF_OK; j += line->corners ? n - 1 : 1)
            status = render_samples_row(worker, row, j);
        if (status == ALGSURF_OK) status = add_coloured(worker, row, 1);
    }
    line->begin = 0;
    line->end = width;
    line->wanted_count = all;
    return status;
}

/* The row as the middles of its pixels show it. */
static void copy_middles(const algsurf_i_middles *middles, int row, int width,
                         const algsurf_picture *planes) {
    const algsurf_picture *own = &middles->shown[row % 3];
    size_t count = (size_t)width, channels = (size_t)algsurf_i_channels(own);
    if (planes->pixels && own->format == planes->format)
        memcpy(planes->pixels, own->pixels, channels * count);
    else if (planes->pixels)
        for (size_t x = 0; x < count; x++) memcpy(planes->pixels + 3 * x, own->pixels + 4 * x, 3);
    if (planes->t) memcpy(planes->t, own->t, count * sizeof *planes->t);
    if (planes->normals) memcpy(planes->normals, own->normals, 3 * count * sizeof *planes->normals);
    if (planes->state) memcpy(planes->state, own->state, count);
    if (planes->way) memcpy(planes->way, own->way, count);
}

/* n x n samples a pixel. */
static algsurf_status render_samples(algsurf_i_worker *worker, int row, const algsurf_picture *to) {
    const algsurf_i_picture *picture = worker->picture;
    algsurf_i_line *line = &worker->line;
    algsurf_status status = ALGSURF_OK;
    if (picture->selective) status = algsurf_i_choose_pixels(worker, row);
    line->colours = picture->selective || picture->planes.pixels ? &picture->colours : NULL;
    line->across = picture->scene->antialias;
    memset(line->shown.samples, 0, (size_t)picture->width * sizeof *line->shown.samples);
    if (line->shown.way) memset(line->shown.way, 0, (size_t)picture->width);
    const int last = line->across > 2 ? 0 : 1; /* of 2 x 2 all are corners */
    for (line->corners = 1; line->corners >= last && line->wanted_count > 0; line->corners--) {
        if (status == ALGSURF_OK)
            status = picture->selective && line->dense > 1 ? render_dense(worker, row)
                                                           : render_passes(worker, row);
        if (line->corners && picture->selective) algsurf_i_keep_apart(worker, row);
    }
    if (status != ALGSURF_OK) return status;
    if (picture->selective) copy_middles(&worker->middles, row, picture->width, to);
    for (int i = 0; i < line->wanted_count; i++)
        store_pixel(picture, &line->shown, picture->selective ? line->list[i] : i, to);
    return ALGSURF_OK;
}

algsurf_status algsurf_i_render_row(algsurf_i_worker *worker, int row) {
    const algsurf_i_picture *picture = worker->picture;
    algsurf_i_line *line = &worker->line;
    const algsurf_picture to = row_planes(picture, row);
    line->wanted = NULL;
    line->wanted_count = picture->width;
    line->thin = picture->thin;
    algsurf_status status = picture->scene->antialias > 1 ? render_samples(worker, row, &to)
                                                          : algsurf_i_render_middles(worker, row, &to);
    if (picture->tiled) algsurf_i_count_tiles(worker, row);
    return status;
}
