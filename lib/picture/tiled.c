/* tiled.c - the points of a row whose tiles are known.
 *
 * Pixels of empty tiles miss.  Those of sheets have a root in the sheet, found by Newton's method from the
 * tile's series and proved to be it (algsurf_i_tile); the few where that fails, and the pixels of leaves, are
 * solved as rays of a row, from the depth on before which their tile has nothing.  What is undecided then
 * goes the way of all rows. */
#include "../base/arithmetic.h"
#include "impl.h"
#include "packets.h"
#include "thin.h"
#include "tiling.h"

#include <string.h>

/* Pixels on their way to points of a sheet, seen at eta from its middle. */
static void add_sheet(const algsurf_i_tile *tile, int first, int end, double eta, double sx,
                      algsurf_i_line *line, algsurf_i_tiling *t) {
    const double *c = tile->depth;
    double at_zero = c[0] + eta * (c[2] + eta * (c[5] + eta * c[9]));
    double slope = c[1] + eta * (c[4] + eta * c[8]), bend = c[3] + eta * c[7], third = c[6];
    double middle = tile->x, inverse = tile->inverse;
    int *restrict pixel = line->pixel + line->count;
    double *restrict depth = line->depth + line->count, *restrict low = t->low + line->count;
    double *restrict high = t->high + line->count, *restrict enough = t->enough + line->count;
    for (int i = 0; i < end - first; i++) {
        double xi = (first + i + sx - middle) * inverse;
        pixel[i] = first + i;
        depth[i] = at_zero + xi * (slope + xi * (bend + xi * third));
        low[i] = tile->low;
        high[i] = tile->high;
        enough[i] = tile->enough;
    }
    line->count += end - first;
    memset(line->state + first, ALGSURF_LANE_HIT, (size_t)(end - first));
}

static void add_leaf(algsurf_i_tiling *t, int x, double low, double high) {
    t->leaf[t->leaves] = x;
    t->leaf_low[t->leaves] = low;
    t->leaf_high[t->leaves++] = high;
}

static void set_ways(const algsurf_i_line *line, int first, int end, int side, algsurf_way way) {
    if (line->way)
        memset(line->way + line->dense * first, side + (int)way, (size_t)(line->dense * (end - first)));
}

/* The pixels from first to end - 1 of one tile. */
static void collect_tile(const algsurf_i_tile *tile, int first, int end, double y, double sx,
                         algsurf_i_line *line, algsurf_i_tiling *t) {
    double eta = (y - tile->y) * tile->inverse;
    int is_sheet = tile->enough > 0;
    set_ways(line, first, end, (int)(2 / tile->inverse), is_sheet ? ALGSURF_WAY_SHEET : ALGSURF_WAY_ROW);
    if (is_sheet && !line->wanted) {
        add_sheet(tile, first, end, eta, sx, line, t);
        return;
    }
    for (int x = first; x < end; x++) {
        if (line->wanted && !line->wanted[x]) continue;
        if (is_sheet)
            add_sheet(tile, x, x + 1, eta, sx, line, t);
        else
            add_leaf(t, x, tile->low, tile->high);
    }
}

/* The samples of the listed pixels: their depths are known to be between two. */
static void collect_listed(const algsurf_i_picture *picture, int row, algsurf_i_worker *worker) {
    const algsurf_i_line *line = &worker->line;
    algsurf_i_tiling *t = &worker->tiling;
    const algsurf_i_band *band = picture->tiled && line->way ? algsurf_i_band_of(picture, row, 1, t) : NULL;
    const int dense = line->dense, places = (picture->width + ALGSURF_I_LEAF - 1) / ALGSURF_I_LEAF;
    const int first = row % ALGSURF_I_TILES / ALGSURF_I_LEAF * places;
    t->leaves = 0;
    for (int i = line->listed; i < line->listed + line->wanted_count; i++) {
        const int x = line->list[i], number = band ? band->cell[first + x / ALGSURF_I_LEAF] : 0;
        set_ways(line, x, x + 1, number > 0 ? (int)(2 / band->tiles[number - 1].inverse) : 0,
                 ALGSURF_WAY_ROW);
        for (int k = dense * x; k < dense * (x + 1); k++) add_leaf(t, k, t->pixel_low[i], t->pixel_high[i]);
    }
}

/* The row's pixels, by what their tiles are. */
static void collect(const algsurf_i_picture *picture, const algsurf_i_band *band, double y, double sx,
                    algsurf_i_worker *worker) {
    int width = picture->width, places = (width + ALGSURF_I_LEAF - 1) / ALGSURF_I_LEAF;
    const int *cell = band->cell + ((int)y - band->number * ALGSURF_I_TILES) / ALGSURF_I_LEAF * places;
    worker->tiling.leaves = 0;
    for (int first = 0, end; first < places; first = end) {
        for (end = first + 1; end < places && cell[end] == cell[first];) end++;
        int x = first * ALGSURF_I_LEAF, x_end = end * ALGSURF_I_LEAF < width ? end * ALGSURF_I_LEAF : width;
        if (cell[first] < 0)
            set_ways(&worker->line, x, x_end, -cell[first], ALGSURF_WAY_EMPTY);
        else
            collect_tile(band->tiles + cell[first] - 1, x, x_end, y, sx, &worker->line, &worker->tiling);
    }
}

static void move_point(const algsurf_i_points *p, int from, int to) {
    p->t[to] = p->t[from];
    for (int k = 0; k < 3; k++) {
        p->position[k][to] = p->position[k][from];
        p->normal[k][to] = p->normal[k][from];
        p->direction[k][to] = p->direction[k][from];
        p->looks.place[k][to] = p->looks.place[k][from];
        p->looks.normal[k][to] = p->looks.normal[k][from];
        p->looks.direction[k][to] = p->looks.direction[k][from];
    }
}

/* Pixels whose root was not found become leaves. */
static void keep_sure(algsurf_i_line *line, algsurf_i_tiling *t) {
    int kept = 0;
    for (int i = 0; i < line->count; i++) {
        int x = line->pixel[i];
        if (!t->sure[i]) {
            add_leaf(t, x, t->low[i], t->high[i]);
            if (line->way) line->way[x] += ALGSURF_WAY_ROW - ALGSURF_WAY_SHEET;
            continue;
        }
        if (kept < i) move_point(&line->points, i, kept);
        line->pixel[kept++] = x;
    }
    line->count = kept;
}

static void find_sheets(const algsurf_i_picture *picture, const algsurf_i_point_job *job,
                        algsurf_i_worker *worker) {
    algsurf_i_line *line = &worker->line;
    algsurf_i_tiling *t = &worker->tiling;
    const algsurf_i_sheets sheets = {t->low, t->high, t->enough, t->sure};
    const algsurf_i_points points = algsurf_i_points_to_find(picture, line, 0);
    if (!picture->code->sheet_points(job, line->pixel, line->depth, line->count, &sheets, &points))
        keep_sure(line, t);
}

/* Depths of the leaves' pixels that are hit, after the line's points; returns whether some are undecided. */
static int solve_leaves(const algsurf_i_picture *picture, const algsurf_i_row_job *job,
                        algsurf_i_worker *worker) {
    algsurf_i_line *line = &worker->line;
    algsurf_i_tiling *t = &worker->tiling;
    const algsurf_i_leaves leaves = {t->leaves, t->leaf, t->leaf_low, t->leaf_high, t->leaf_thin};
    int undecided = 0;
    algsurf_i_row_expand(&picture->packets->frame, worker->form.v, &worker->form);
    picture->code->solve_leaves(job, &leaves, t->leaf_depth, t->leaf_state);
    for (int i = 0; i < t->leaves; i++) {
        int x = t->leaf[i];
        line->state[x] = t->leaf_state[i];
        undecided |= t->leaf_state[i] == ALGSURF_LANE_UNDECIDED;
        if (t->leaf_state[i] != ALGSURF_LANE_HIT) continue;
        line->pixel[line->count] = x;
        line->depth[line->count++] = t->leaf_depth[i];
    }
    algsurf_i_list_thin(job, t);
    return undecided;
}

/* The points of leaves, after the line's. */
static algsurf_status find_leaves(const algsurf_i_picture *picture, double y, double sx,
                                  const algsurf_i_point_job *job, algsurf_i_worker *worker,
                                  algsurf_i_tally *tally) {
    algsurf_i_line *line = &worker->line;
    double begun = algsurf_i_render_clock(picture);
    int sheets = line->count, undecided = solve_leaves(picture, job->row, worker);
    double solved = algsurf_i_render_clock(picture);
    const algsurf_i_points points = algsurf_i_points_to_find(picture, line, sheets);
    picture->code->points(job, line->pixel + sheets, line->depth + sheets, line->count - sheets, &points);
    tally->hits += (uint64_t)(line->count - sheets);
    double pointed = algsurf_i_render_clock(picture);
    algsurf_status status = ALGSURF_OK;
    if (undecided) status = algsurf_i_solve_undecided(picture, y, sx, line->begin, line->end, line, tally);
    tally->point_s += pointed - solved;
    tally->solve_s += (solved - begun) + (algsurf_i_render_clock(picture) - pointed);
    return status;
}

algsurf_status algsurf_i_render_tiled(const algsurf_i_picture *picture, const algsurf_i_band *band, int row,
                                      double sx, double sy, algsurf_i_worker *worker,
                                      algsurf_i_tally *tally) {
    algsurf_i_line *line = &worker->line;
    algsurf_i_row_job job;
    const algsurf_i_point_job points = {picture->scene->surface, &job, line->colours};
    double begun = algsurf_i_render_clock(picture);
    tally->rays += (uint64_t)line->wanted_count;
    memset(line->state + line->begin, ALGSURF_LANE_MISS, (size_t)(line->end - line->begin));
    algsurf_i_make_row(picture, row + sy, sx, &worker->form, &job);
    collect(picture, band, row + sy, sx, worker);
    tally->empty_rays += (uint64_t)(line->wanted_count - line->count - worker->tiling.leaves);
    double collected = algsurf_i_render_clock(picture);
    tally->solve_s += collected - begun;
    if (line->count > 0) {
        find_sheets(picture, &points, worker);
        tally->point_s += algsurf_i_render_clock(picture) - collected;
    }
    tally->sheet_rays += (uint64_t)line->count;
    tally->hits += (uint64_t)line->count;
    return worker->tiling.leaves > 0 ? find_leaves(picture, row + sy, sx, &points, worker, tally)
                                     : ALGSURF_OK;
}

int algsurf_i_render_listed(const algsurf_i_picture *picture, int row, double sy, algsurf_i_worker *worker,
                            algsurf_i_tally *tally) {
    algsurf_i_line *line = &worker->line;
    const int before = line->count, dense = line->dense;
    algsurf_i_row_job job;
    const algsurf_i_point_job points = {picture->scene->surface, &job, line->colours};
    double begun = algsurf_i_render_clock(picture);
    tally->rays += (uint64_t)(dense * line->wanted_count);
    algsurf_i_make_row(picture, row + sy, 0.5, &worker->form, &job);
    job.offset = 0.5 - 0.5 * picture->width * dense;
    job.pixel /= dense;
    job.thin_large = 0;
    collect_listed(picture, row, worker);
    int undecided = solve_leaves(picture, &job, worker);
    double solved = algsurf_i_render_clock(picture);
    const algsurf_i_points found = algsurf_i_points_to_find(picture, line, before);
    picture->code->points(&points, line->pixel + before, line->depth + before, line->count - before, &found);
    tally->hits += (uint64_t)(line->count - before);
    tally->solve_s += solved - begun;
    tally->point_s += algsurf_i_render_clock(picture) - solved;
    return undecided;
}
