/* pixels.c - the points of a row, by what its tiles are.
 *
 * Pixels of empty tiles miss.  Those of sheets have a root in the sheet, found by Newton's method from the
 * tile's series and proved to be it (algsurf_i_tile).  Those of leaves, and all pixels where there are no
 * tiles, are solved side by side from the depth on that is known (pixels_template.h).  What is undecided
 * then goes ray by ray (undecided.c). */
#include "../base/arithmetic.h"
#include "impl.h"

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

/* A pixel without a root on its chord before a depth. */
static void add_pixel(algsurf_i_tiling *t, int x, double low) {
    t->pixel[t->pixels] = x;
    t->pixel_low[t->pixels++] = low;
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
            add_pixel(t, x, tile->low);
    }
}

/* The samples of the listed pixels that are in the pass. */
static void collect_listed(algsurf_i_worker *worker, int row) {
    const algsurf_i_line *line = &worker->line;
    algsurf_i_tiling *t = &worker->tiling;
    const algsurf_i_band *band = line->way ? algsurf_i_band_of(worker, row) : NULL;
    const int dense = line->dense, first = algsurf_i_first_cell(worker->picture, row);
    t->pixels = 0;
    for (int i = line->listed; i < line->listed + line->wanted_count; i++) {
        const int x = line->list[i], number = band ? band->cell[first + x / ALGSURF_I_LEAF] : 0;
        set_ways(line, x, x + 1, number > 0 ? (int)(2 / band->tiles[number - 1].inverse) : 0,
                 ALGSURF_WAY_ROW);
        for (int k = 0; k < dense; k++)
            if (algsurf_i_is_in_pass(line, line->sample + k)) add_pixel(t, dense * x + k, t->list_low[i]);
    }
}

/* The row's pixels, by what their tiles are. */
static void collect(algsurf_i_worker *worker, const algsurf_i_band *band, int row, double sx, double sy) {
    int width = worker->picture->width, places = algsurf_i_cells_across(worker->picture);
    const int *cell = band->cell + algsurf_i_first_cell(worker->picture, row);
    algsurf_i_begin_states(&worker->line, 1);
    for (int first = 0, end; first < places; first = end) {
        for (end = first + 1; end < places && cell[end] == cell[first];) end++;
        int x = first * ALGSURF_I_LEAF, x_end = end * ALGSURF_I_LEAF < width ? end * ALGSURF_I_LEAF : width;
        if (cell[first] < 0)
            set_ways(&worker->line, x, x_end, -cell[first], ALGSURF_WAY_EMPTY);
        else
            collect_tile(band->tiles + cell[first] - 1, x, x_end, row + sy, sx, &worker->line,
                         &worker->tiling);
    }
}

/* The row's pixels, all of them between the depths of what is shown; returns whether some are undecided:
 * those beyond the bounds of forms. */
static int collect_all(algsurf_i_worker *worker, double y) {
    algsurf_i_line *line = &worker->line;
    int begin, end, misses = algsurf_i_pixels_within_bounds(worker->picture, y, y, 1, &begin, &end);
    algsurf_i_begin_states(line, misses);
    for (int x = begin; x < end; x++)
        if (!line->wanted || line->wanted[x]) add_pixel(&worker->tiling, x, -1);
    return !misses;
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

void algsurf_i_drop_unsure(algsurf_i_line *line, int first) {
    int kept = first;
    for (int i = first; i < line->count; i++) {
        if (!line->sure[i]) {
            line->state[line->pixel[i]] = ALGSURF_LANE_UNDECIDED;
            continue;
        }
        if (kept < i) move_point(&line->points, i, kept);
        line->pixel[kept++] = line->pixel[i];
    }
    line->count = kept;
}

/* Shadows need to know places exactly. */
algsurf_i_points algsurf_i_points_to_find(const algsurf_i_worker *worker, int first) {
    const int shadows = worker->picture->shadows;
    const algsurf_i_points *p = &worker->line.points;
    algsurf_i_points found = {.t = p->t + first};
    for (int k = 0; k < 3; k++) {
        if (shadows) found.position[k] = p->position[k] + first;
        if (shadows) found.direction[k] = p->direction[k] + first;
        if (shadows || worker->picture->planes.normals) found.normal[k] = p->normal[k] + first;
        if (!worker->line.colours) continue;
        found.looks.place[k] = p->looks.place[k] + first;
        found.looks.normal[k] = p->looks.normal[k] + first;
        found.looks.direction[k] = p->looks.direction[k] + first;
    }
    return found;
}

/* The points of the line's entries from `first` on; returns whether some are undecided. */
static int find_points(algsurf_i_worker *worker, const algsurf_i_row_job *job, int first,
                       const algsurf_i_sheets *sheets) {
    const algsurf_i_picture *picture = worker->picture;
    algsurf_i_line *line = &worker->line;
    const algsurf_i_point_job points = {picture->scene->surface, job, &picture->colours.frame,
                                        algsurf_i_surface_front(picture->scene->given)};
    const algsurf_i_points found = algsurf_i_points_to_find(worker, first);
    int all = picture->code->points(&points, line->pixel + first, line->depth + first, line->count - first,
                                    sheets, line->sure + first, &found);
    if (!all) algsurf_i_drop_unsure(line, first);
    return !all;
}

/* Depths of the listed pixels that are hit, after the line's points; returns whether some are undecided. */
static int solve_pixels(algsurf_i_worker *worker, const algsurf_i_row_job *job) {
    const algsurf_i_picture *picture = worker->picture;
    algsurf_i_line *line = &worker->line;
    algsurf_i_tiling *t = &worker->tiling;
    const algsurf_i_pixels pixels = {t->pixels, t->pixel, t->pixel_low};
    int undecided = 0;
    picture->code->solve_pixels(job, &pixels, t->pixel_depth, t->pixel_state, line->thin ? &t->dips : NULL);
    for (int i = 0; i < t->pixels; i++) {
        int x = t->pixel[i];
        line->state[x] = t->pixel_state[i];
        undecided |= t->pixel_state[i] == ALGSURF_LANE_UNDECIDED;
        if (t->pixel_state[i] != ALGSURF_LANE_HIT) continue;
        line->pixel[line->count] = x;
        line->depth[line->count++] = t->pixel_depth[i];
    }
    return undecided;
}

/* The points of the listed pixels, after the line's; returns whether some are undecided. */
static int find_pixels(algsurf_i_worker *worker, const algsurf_i_row_job *job) {
    algsurf_render_stats *stats = &worker->tally->stats;
    const int before = worker->line.count;
    algsurf_i_row_expand(&worker->picture->geometry->frame, worker->form.v, &worker->form);
    algsurf_i_lap(worker, &stats->expand_s);
    int undecided = solve_pixels(worker, job);
    algsurf_i_lap(worker, &stats->solve_s);
    undecided |= find_points(worker, job, before, NULL);
    algsurf_i_lap(worker, &stats->point_s);
    return undecided;
}

int algsurf_i_solve_row(algsurf_i_worker *worker, int row, double sx, double sy) {
    algsurf_i_line *line = &worker->line;
    algsurf_i_tiling *t = &worker->tiling;
    algsurf_render_stats *stats = &worker->tally->stats;
    algsurf_i_row_job job;
    const algsurf_i_band *band = algsurf_i_band_of(worker, row);
    int undecided = 0;
    t->dips.count = t->pixels = 0;
    algsurf_i_make_row(worker->picture, row + sy, sx, 1, &worker->form, &job);
    if (band)
        collect(worker, band, row, sx, sy);
    else
        undecided = collect_all(worker, row + sy);
    if (band) stats->empty_rays += (uint64_t)(line->wanted_count - line->count - t->pixels);
    algsurf_i_lap(worker, &stats->solve_s);
    if (line->count > 0) {
        undecided |= find_points(worker, &job, 0, &(algsurf_i_sheets){t->low, t->high, t->enough});
        stats->sheet_rays += (uint64_t)line->count;
        algsurf_i_lap(worker, &stats->point_s);
    }
    if (t->pixels > 0) undecided |= find_pixels(worker, &job);
    stats->hits += (uint64_t)line->count;
    return undecided;
}

int algsurf_i_solve_listed(algsurf_i_worker *worker, int row, double sy) {
    algsurf_i_line *line = &worker->line;
    const int before = line->count;
    algsurf_i_row_job job;
    worker->tiling.dips.count = 0;
    algsurf_i_make_row(worker->picture, row + sy, 0.5, line->dense, &worker->form, &job);
    collect_listed(worker, row);
    int undecided = find_pixels(worker, &job);
    worker->tally->stats.rays += (uint64_t)worker->tiling.pixels;
    worker->tally->stats.hits += (uint64_t)(line->count - before);
    return undecided;
}
