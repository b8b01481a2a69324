/* antialias.c - which pixels get all their samples, and what the others show.
 *
 * Adaptive sampling (Whitted, An improved illumination model for shaded display, 1980): one ray goes
 * through the middle of every pixel, and only where that shows another colour than next to it, all rays.
 * Whether a pixel is wanted depends on four neighbours, so a worker keeps the middles of three rows and draws
 * those of the row below the one in the making; the rows above and below what it was given are drawn once
 * more by their own worker, and only there they count.  Colours are compared as the bytes a picture of the
 * middles alone would have, with alpha, whether a byte of it is asked for or not: what is chosen does not
 * hang on which planes are.  Where there are tiles only pixels of leaves are compared: through the
 * others, by proof, no edge goes.
 *
 * Of two pixels on either side of an edge at most one is crossed by it as a rule.  So of a wanted pixel the
 * four samples in its corners come first.  A straight edge that has samples on both sides has corners on
 * both, since a half-plane that holds a point of the grid holds a corner.  If the corners are on the average
 * as the middle is, to a quarter of the threshold (one of four differs by the threshold), the pixel shows its
 * middle.
 */
#include "../base/arithmetic.h"
#include <stdlib.h>
#include <string.h>

#include "impl.h"

/* They count when their row is the one in the making. */
static algsurf_status draw_middles(algsurf_i_worker *worker, int row) {
    algsurf_i_middles *middles = &worker->middles;
    middles->counts[row % 3] = (algsurf_i_tally){.without_memory = 0};
    worker->predictor.row = -1;
    worker->tally = &middles->counts[row % 3];
    algsurf_status status = algsurf_i_render_middles(worker, row, &middles->shown[row % 3]);
    worker->tally = &worker->all;
    return status;
}

/* Marks the bytes of pixels x .. end-1 that are far from those of a neighbour. */
static void compare(const algsurf_i_picture *picture, int row, int x, int end, algsurf_i_middles *middles) {
    const int channels = algsurf_i_channels(&middles->shown[0]), first = channels * x,
              count = channels * (end - x);
    const int limit = (int)(255 * picture->scene->antialias_threshold);
    const uint8_t *own = middles->shown[row % 3].pixels + first;
    uint8_t *marks = middles->apart + first;
    void (*const mark)(const uint8_t *, const uint8_t *, int, int, uint8_t *) = picture->shader->mark_bytes;
    memset(marks, 0, (size_t)count);
    if (row > 0) mark(own, middles->shown[(row + 2) % 3].pixels + first, count, limit, marks);
    if (row + 1 < picture->height)
        mark(own, middles->shown[(row + 1) % 3].pixels + first, count, limit, marks);
    const int left = x > 0 ? 0 : channels, right = end < picture->width ? 0 : channels;
    mark(own + left, own + left - channels, count - left, limit, marks + left);
    mark(own, own + channels, count - right, limit, marks);
}

/* Does the row, or one beside it, show something thin? */
static int is_near_thin(const algsurf_i_picture *picture, const algsurf_i_middles *middles, int row) {
    for (int r = row > 0 ? row - 1 : 0; picture->thin && r <= row + 1 && r < picture->height; r++)
        if (memchr(middles->shown[r % 3].state, ALGSURF_STATE_THIN, (size_t)picture->width)) return 1;
    return 0;
}

/* Does the pixel, or one of the four beside it, show something thin? */
static int is_beside_thin(const algsurf_i_picture *picture, const algsurf_i_middles *middles, int row,
                          int x) {
    const uint8_t *own = middles->shown[row % 3].state, thin = ALGSURF_STATE_THIN;
    return own[x] == thin || (x > 0 && own[x - 1] == thin) ||
           (x + 1 < picture->width && own[x + 1] == thin) ||
           (row > 0 && middles->shown[(row + 2) % 3].state[x] == thin) ||
           (row + 1 < picture->height && middles->shown[(row + 1) % 3].state[x] == thin);
}

/* Lists which of the pixels x .. end-1 are wanted: they show another colour than a neighbour, or are beside
 * something thin. */
static int list_apart(algsurf_i_worker *worker, int row, int x, int end, int *list) {
    const algsurf_i_picture *picture = worker->picture;
    algsurf_i_middles *middles = &worker->middles;
    const int channels = algsurf_i_channels(&middles->shown[0]);
    int count = 0;
    compare(picture, row, x, end, middles);
    for (; x < end; x++) {
        const uint8_t *mark = middles->apart + channels * x;
        const int apart = mark[0] | mark[1] | mark[2] | (channels == 4 ? mark[3] : 0);
        const int thin = worker->line.thin && is_beside_thin(picture, middles, row, x);
        if (!apart && !thin) continue;
        list[count++] = x;
        middles->wanted[x] = thin ? 2 : 1;
    }
    return count;
}

/* The same of the pixels in leaves alone, neither empty tiles nor sheets, run by run. */
static int list_in_leaves(algsurf_i_worker *worker, const algsurf_i_band *band, int row) {
    const algsurf_i_picture *picture = worker->picture;
    const int *cell = band->cell + algsurf_i_first_cell(picture, row);
    const int cells = algsurf_i_cells_across(picture), width = picture->width;
    double *low = worker->tiling.list_low;
    int *list = worker->line.list, count = 0;
    for (int first = 0, end; first < cells; first = end + 1) {
        for (end = first; end < cells && cell[end] > 0 && !(band->tiles[cell[end] - 1].enough > 0);) end++;
        const int x = first * ALGSURF_I_LEAF, x_end = end * ALGSURF_I_LEAF;
        if (end > first) count += list_apart(worker, row, x, x_end < width ? x_end : width, list + count);
    }
    for (int i = 0; i < count; i++) low[i] = band->tiles[cell[list[i] / ALGSURF_I_LEAF] - 1].low;
    return count;
}

/* Lists the pixels that show another colour than a neighbour, where edges may go; line->dense tells how many
 * samples of them may be solved side by side: where rays have forms within their bounds, a row of them. */
static void list_edges(algsurf_i_worker *worker, int row) {
    const algsurf_i_picture *picture = worker->picture;
    algsurf_i_line *line = &worker->line;
    const algsurf_i_band *band = algsurf_i_band_of(worker, row);
    int begin, end;
    const int within = picture->geometry && !picture->scene->complex &&
                       algsurf_i_pixels_within_bounds(picture, row, row + 1, 1, &begin, &end);
    line->thin = is_near_thin(picture, &worker->middles, row);
    line->dense = within ? picture->scene->antialias : 1;
    if (band && within) {
        line->wanted_count = list_in_leaves(worker, band, row);
        return;
    }
    if (!within) begin = 0, end = picture->width;
    line->wanted_count = list_apart(worker, row, begin, end, line->list);
    for (int i = 0; within && i < line->wanted_count; i++) worker->tiling.list_low[i] = -1;
}

algsurf_status algsurf_i_choose_pixels(algsurf_i_worker *worker, int row) {
    algsurf_i_middles *middles = &worker->middles;
    if (middles->end < row - 1) middles->end = row - 1;
    for (; middles->end <= row + 1 && middles->end < worker->picture->height; middles->end++) {
        algsurf_status status = draw_middles(worker, middles->end);
        if (status != ALGSURF_OK) return status;
    }
    algsurf_i_tally_add(worker->tally, &middles->counts[row % 3]);
    memset(middles->wanted, 0, (size_t)worker->picture->width);
    list_edges(worker, row);
    worker->line.wanted = middles->wanted;
    worker->predictor.row = -1;
    return ALGSURF_OK;
}

/* The corners of pixel x, which are what it shows so far, are not as its middle is. */
static int has_edge(const algsurf_i_picture *picture, const algsurf_i_shown *corners,
                    const algsurf_picture *middle, int x) {
    const int channels = algsurf_i_channels(middle), hit = middle->state[x] != ALGSURF_STATE_MISS;
    const int limit = (int)(255 * picture->scene->antialias_threshold / 4);
    if (corners->samples[x] != (hit ? 4 : 0)) return 1;
    for (int k = 0; hit && k < 3; k++) {
        const double light = corners->sum[3 * x + k] / 4;
        const int byte = algsurf_i_byte_of(picture->curve, light < 1 ? light : 1);
        if (abs(byte - middle->pixels[channels * x + k]) > limit) return 1;
    }
    return 0;
}

void algsurf_i_keep_apart(algsurf_i_worker *worker, int row) {
    algsurf_i_middles *middles = &worker->middles;
    algsurf_i_line *line = &worker->line;
    double *low = worker->tiling.list_low;
    int kept = 0;
    for (int i = 0; i < line->wanted_count; i++) {
        const int x = line->list[i];
        if (!has_edge(worker->picture, &line->shown, &middles->shown[row % 3], x)) {
            middles->wanted[x] = 0;
            continue;
        }
        if (low) low[kept] = low[i];
        line->list[kept++] = x;
    }
    line->wanted_count = kept;
}
