/* antialias.c - which pixels get all their samples, and what the others show.
 *
 * Adaptive sampling (Whitted, An improved illumination model for shaded display, 1980): one ray goes
 * through the middle of every pixel, and only where that shows another colour than next to it, all rays.
 * Whether a pixel is wanted depends on four neighbours, so a worker keeps the middles of three rows and draws
 * those of the row below the one in the making; the rows above and below what it was given are drawn once
 * more by their own worker, and only there they count.  Colours are compared as the bytes a picture of the
 * middles alone would have, with alpha: what is chosen does not hang on the last bits of a double, nor on
 * which planes are asked for.
 *
 * In complex space a row's middles and its first pass begin without roots of others: which ones there were
 * would depend on how rows are shared out.
 */
#include "../base/arithmetic.h"
#include <stdlib.h>
#include <string.h>

#include "impl.h"

/* Their colours are needed to choose pixels, whatever is asked for. */
static algsurf_status draw_middles(const algsurf_i_picture *picture, int row, algsurf_i_worker *worker) {
    algsurf_i_line *line = &worker->line;
    algsurf_i_middles *middles = &worker->middles;
    const algsurf_i_shown own = line->shown, *shown = &middles->shown[row % 3];
    algsurf_i_tally *counts = &middles->counts[row % 3];
    *counts = (algsurf_i_tally){0};
    algsurf_i_begin_shown(shown, picture->width);
    worker->trail.row = -1;
    line->colours = &picture->colours;
    line->across = 1;
    line->sample = 0;
    line->shown = *shown;
    algsurf_status status = algsurf_i_render_pass(picture, row, 0.5, 0.5, worker, counts);
    line->shown = own;
    if (status == ALGSURF_OK) algsurf_i_store_colours(picture, shown, 1, 4, middles->bytes[row % 3]);
    return status;
}

/* Marks the pixels that have a channel further than the limit from that of the other at their place. */
static void mark(const uint8_t *pixels, const uint8_t *others, int count, int limit, uint8_t *marks) {
    for (int x = 0; x < count; x++)
        for (int k = 0; k < 4; k++) marks[x] |= abs(pixels[4 * x + k] - others[4 * x + k]) > limit;
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
    mark(own, own + 4, width - 1, limit, middles->wanted);
    mark(own + 4, own, width - 1, limit, middles->wanted + 1);
    worker->line.wanted = middles->wanted;
    worker->line.wanted_count = count_marks(middles->wanted, width);
    worker->trail.row = -1;
    return ALGSURF_OK;
}

void algsurf_i_add_middles(const algsurf_i_picture *picture, int row, int wanted, algsurf_i_worker *worker) {
    const algsurf_i_line *line = &worker->line;
    const algsurf_i_shown *middle = &worker->middles.shown[row % 3], *shown = &line->shown;
    for (int x = 0; x < picture->width; x++) {
        if (line->wanted[x] != wanted || middle->samples[x] == 0) continue;
        double t = middle->nearest[x];
        int nearest = algsurf_i_is_nearest(shown, x, t);
        if (nearest && shown->state) shown->state[x] = middle->state[x];
        for (int k = 0; nearest && shown->normal && k < 3; k++)
            shown->normal[3 * x + k] = middle->normal[3 * x + k];
        algsurf_i_add_sample(shown, x, t);
        for (int k = 0; k < 3; k++) shown->sum[3 * x + k] += middle->sum[3 * x + k];
    }
}

void algsurf_i_store_middles(const algsurf_i_picture *picture, int row, const algsurf_i_worker *worker,
                             uint8_t *bytes) {
    const uint8_t *middle = worker->middles.bytes[row % 3];
    int channels = picture->channels;
    for (int x = 0; x < picture->width; x++)
        if (!worker->line.wanted[x]) memcpy(bytes + channels * x, middle + 4 * x, (size_t)channels);
}
