/* antialias.c - which pixels get all their samples, and what the others show.
 *
 * Adaptive sampling (Whitted, An improved illumination model for shaded display, 1980): one ray goes
 * through the middle of every pixel, and only where that shows another colour than next to it, all rays.
 * Whether a pixel is wanted depends on four neighbours, so a worker keeps the middles of three rows and draws
 * those of the row below the one in the making; the rows above and below what it was given are drawn once
 * more by their own worker, and only there they count.  Colours are compared as the bytes a picture of the
 * middles alone would have, with alpha: what is chosen does not hang on which planes are asked for.  Where
 * there are tiles, a pixel through which no edge goes, by proof, is not chosen.  Nor is one that shows
 * something thin, which many samples would make pale.
 *
 * In complex space a row's middles and its first pass begin without roots of others: which ones there were
 * would depend on how rows are shared out.
 */
#include "../base/arithmetic.h"
#include <string.h>

#include "cells.h"
#include "impl.h"

static algsurf_status draw_middles(const algsurf_i_picture *picture, int row, algsurf_i_worker *worker) {
    algsurf_i_middles *middles = &worker->middles;
    algsurf_i_tally *counts = &middles->counts[row % 3];
    *counts = (algsurf_i_tally){0};
    worker->trail.row = -1;
    return algsurf_i_render_middles(picture, row, &middles->shown[row % 3], worker, counts);
}

/* The pixels with a channel, one of four bytes, that is far from that of a neighbour. */
static void compare(const algsurf_i_picture *picture, int row, algsurf_i_middles *middles) {
    const int count = 4 * picture->width, limit = (int)(255 * picture->scene->antialias_threshold);
    const uint8_t *own = middles->shown[row % 3].pixels;
    uint8_t *marks = middles->apart;
    void (*const mark)(const uint8_t *, const uint8_t *, int, int, uint8_t *) = picture->shader->mark_bytes;
    memset(marks, 0, (size_t)count);
    if (row > 0) mark(own, middles->shown[(row + 2) % 3].pixels, count, limit, marks);
    if (row + 1 < picture->height) mark(own, middles->shown[(row + 1) % 3].pixels, count, limit, marks);
    mark(own, own + 4, count - 4, limit, marks);
    mark(own + 4, own, count - 4, limit, marks + 4);
}

/* Lists the pixels that are marked and have an edge in them, as far as a proof does not tell otherwise:
 * pixels of empty tiles and of sheets do not, nor do those that are such tiles themselves. */
static int list_edges(const algsurf_i_picture *picture, int row, algsurf_i_worker *worker) {
    algsurf_i_tiling *t = &worker->tiling;
    const algsurf_i_band *band = picture->tiled ? algsurf_i_band_of(picture, row, 1, t) : NULL;
    const uint8_t *apart = worker->middles.apart, *state = worker->middles.shown[row % 3].state;
    int *list = worker->line.list, count = 0, places = (picture->width + ALGSURF_I_LEAF - 1) / ALGSURF_I_LEAF;
    const int first = row % ALGSURF_I_TILES / ALGSURF_I_LEAF * places; /* of the row's in the band's */
    for (int x = 0; x < picture->width; x++) {
        uint32_t four;
        memcpy(&four, apart + 4 * x, sizeof four);
        list[count] = x;
        count += four != 0 && state[x] != ALGSURF_THIN;
    }
    if (!algsurf_i_has_cells(picture, row + 0.5)) return count;
    int open = 0;
    for (int i = 0; i < count; i++) {
        int number = band ? band->cell[first + list[i] / ALGSURF_I_LEAF] : 0;
        if (band && (number <= 0 || band->tiles[number - 1].enough > 0)) continue;
        t->from[open] = band ? band->tiles[number - 1].low : -1;
        t->at[open++] = list[i];
    }
    if (open == 0) return 0;
    const algsurf_i_cells pixels = algsurf_i_cells_of(picture, 1, row, 0.5, 0.5);
    open = algsurf_i_search_cells(&pixels, 1, open, t);
    for (int i = 0; i < open; i++) list[i] = t->at[i];
    return open;
}

algsurf_status algsurf_i_choose_pixels(const algsurf_i_picture *picture, int row, algsurf_i_worker *worker,
                                       algsurf_i_tally *tally) {
    algsurf_i_middles *middles = &worker->middles;
    algsurf_i_line *line = &worker->line;
    if (middles->end < row - 1) middles->end = row - 1;
    for (; middles->end <= row + 1 && middles->end < picture->height; middles->end++) {
        algsurf_status status = draw_middles(picture, middles->end, worker);
        if (status != ALGSURF_OK) return status;
    }
    algsurf_i_tally_add(tally, &middles->counts[row % 3]);
    compare(picture, row, middles);
    line->wanted_count = list_edges(picture, row, worker);
    memset(middles->wanted, 0, (size_t)picture->width);
    for (int i = 0; i < line->wanted_count; i++) middles->wanted[line->list[i]] = 1;
    line->wanted = middles->wanted;
    worker->trail.row = -1;
    return ALGSURF_OK;
}

void algsurf_i_copy_middles(const algsurf_i_middles *middles, int row, int width,
                            const algsurf_i_row_planes *planes) {
    const algsurf_i_row_planes *own = &middles->shown[row % 3];
    size_t count = (size_t)width;
    if (planes->pixels && planes->channels == 4) memcpy(planes->pixels, own->pixels, 4 * count);
    for (size_t x = 0; planes->pixels && planes->channels == 3 && x + 1 < count; x++)
        memcpy(planes->pixels + 3 * x, own->pixels + 4 * x, 4); /* the fourth byte is overwritten next */
    if (planes->pixels && planes->channels == 3)
        memcpy(planes->pixels + 3 * (count - 1), own->pixels + 4 * (count - 1), 3);
    if (planes->t) memcpy(planes->t, own->t, count * sizeof *planes->t);
    if (planes->normals) memcpy(planes->normals, own->normals, 3 * count * sizeof *planes->normals);
    if (planes->state) memcpy(planes->state, own->state, count);
    if (planes->way) memcpy(planes->way, own->way, count);
}
