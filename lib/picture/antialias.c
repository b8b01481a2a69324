/* antialias.c - which pixels get all their samples, and what the others show.
 *
 * Adaptive sampling (Whitted, An improved illumination model for shaded display, 1980): one ray goes
 * through the middle of every pixel, and only where that shows another colour than next to it, all rays.
 * Whether a pixel is wanted depends on four neighbours, so a worker keeps the middles of three rows and draws
 * those of the row below the one in the making; the rows above and below what it was given are drawn once
 * more by their own worker, and only there they count.  Colours are compared as the bytes a picture of the
 * middles alone would have: what is chosen does not hang on the last bits of a double.
 *
 * In complex space a row's middles and its first pass begin without roots of others: which ones there were
 * would depend on how rows are shared out.
 */
#include "../base/arithmetic.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "impl.h"

/* The line's sums, of one sample a pixel. */
static void keep_line(const algsurf_i_picture *picture, const algsurf_i_line *line,
                      const algsurf_i_middles *middles, int slot) {
    memcpy(middles->colour[slot], line->sum, 3 * (size_t)picture->width * sizeof *line->sum);
    algsurf_i_store_line(picture, line, 1, middles->bytes[slot], middles->t[slot]);
}

static algsurf_status draw_middles(const algsurf_i_picture *picture, int row, algsurf_i_worker *worker) {
    algsurf_i_line *line = &worker->line;
    algsurf_i_tally *counts = &worker->middles.counts[row % 3];
    *counts = (algsurf_i_tally){0};
    memset(line->samples, 0, (size_t)picture->width * sizeof *line->samples);
    worker->trail.row = -1;
    algsurf_status status = algsurf_i_render_pass(picture, row, 0.5, 0.5, worker, counts);
    if (status == ALGSURF_OK) keep_line(picture, line, &worker->middles, row % 3);
    return status;
}

/* Marks the pixels that have a channel further than the limit from that of the other at their place. */
static void mark(const uint8_t *pixels, const uint8_t *others, int count, int limit, uint8_t *marks) {
    for (int x = 0; x < count; x++)
        for (int k = 0; k < 3; k++) marks[x] |= abs(pixels[3 * x + k] - others[3 * x + k]) > limit;
}

static int count_marks(const uint8_t *marks, int width) {
    int count = 0;
    for (int x = 0; x < width; x++) count += marks[x];
    return count;
}

algsurf_status algsurf_i_choose_pixels(const algsurf_i_picture *picture, int row, algsurf_i_worker *worker,
                                       algsurf_i_tally *tally) {
    algsurf_i_middles *middles = &worker->middles;
    int width = picture->width, limit = (int)(255 * picture->scene->antialias_threshold);
    if (middles->end < row - 1) middles->end = row - 1;
    for (; middles->end <= row + 1 && middles->end < picture->height; middles->end++) {
        algsurf_status status = draw_middles(picture, middles->end, worker);
        if (status != ALGSURF_OK) return status;
    }
    algsurf_i_tally_add(tally, &middles->counts[row % 3]);
    const uint8_t *own = middles->bytes[row % 3];
    memset(middles->wanted, 0, (size_t)width);
    if (row > 0) mark(own, middles->bytes[(row - 1) % 3], width, limit, middles->wanted);
    if (row + 1 < picture->height) mark(own, middles->bytes[(row + 1) % 3], width, limit, middles->wanted);
    mark(own, own + 3, width - 1, limit, middles->wanted);
    mark(own + 3, own, width - 1, limit, middles->wanted + 1);
    worker->line.wanted = middles->wanted;
    worker->line.wanted_count = count_marks(middles->wanted, width);
    worker->trail.row = -1;
    return ALGSURF_OK;
}

void algsurf_i_add_middles(const algsurf_i_picture *picture, int row, algsurf_i_worker *worker) {
    const algsurf_i_middles *middles = &worker->middles;
    algsurf_i_line *line = &worker->line;
    const double *colour = middles->colour[row % 3], *t = middles->t[row % 3];
    for (int x = 0; x < picture->width; x++) {
        if (!line->wanted[x] || isnan(t[x])) continue;
        int first = line->samples[x]++ == 0;
        for (int k = 0; k < 3; k++)
            line->sum[3 * x + k] = colour[3 * x + k] + (first ? 0 : line->sum[3 * x + k]);
        line->nearest[x] = first ? t[x] : fmin(line->nearest[x], t[x]);
    }
}

void algsurf_i_store_middles(const algsurf_i_picture *picture, int row, const algsurf_i_worker *worker,
                             uint8_t *bytes, double *hits) {
    const algsurf_i_middles *middles = &worker->middles;
    for (int x = 0; x < picture->width; x++) {
        if (worker->line.wanted[x]) continue;
        memcpy(bytes + 3 * x, middles->bytes[row % 3] + 3 * x, 3);
        if (hits) hits[x] = middles->t[row % 3][x];
    }
}
