/* complex_rows.c - complex space: the roots of a row, started from those of the row above.
 *
 * Spatial coherence (Sanjuan-Estrada, Casado, Garcia, section 3): neighbouring rays have nearly the same
 * roots, and an iteration that starts there takes fewer steps.  It saves time and must not show.  Two things
 * see to it:
 * - the root that is seen is settled with doubled precision (complex/lanes_template.h), so that its bits do
 *   not tell where the iteration began;
 * - which pixels are left to the single ray may depend on the start.  So rows begin anew at multiples of
 *   ALGSURF_I_BAND, counted from the top of the picture, and whoever begins elsewhere solves the rows before,
 *   from there on.  Where a pixel has several samples, a row's middles and its first pass begin anew, and
 *   each other pass starts from the one before. */
#include "../base/arithmetic.h"
#include <math.h>
#include <string.h>

#include "impl.h"

static void forget(algsurf_i_predictor *predictor, int begin, int end) {
    for (int x = begin; x < end; x++) predictor->x[x] = NAN;
}

static algsurf_i_complex_job complex_job_of(algsurf_i_worker *worker, const algsurf_i_row_job *row) {
    const algsurf_i_geometry *p = worker->picture->geometry;
    return (algsurf_i_complex_job){.row = row,
                                   .sector = &p->sector,
                                   .imaginary = p->imaginary,
                                   .top = p->top,
                                   .looks = &worker->picture->colours.frame,
                                   .x = worker->predictor.x,
                                   .y = worker->predictor.y,
                                   .stride = worker->picture->width,
                                   .re = worker->line.depth,
                                   .im = worker->line.imaginary,
                                   .state = worker->line.state};
}

/* After it: the pixels from begin to end have been solved. */
static void end_row(algsurf_i_worker *worker, int row, int begin, int end) {
    forget(&worker->predictor, 0, begin);
    forget(&worker->predictor, end, worker->picture->width);
    worker->predictor.row = row;
}

/* The row's form and job, and the pixels begin <= x < end that are within the bounds of forms; *misses: do
 * all others surely miss? */
static int begin_row(algsurf_i_worker *worker, double y, double sx, algsurf_i_row_job *job, int *begin,
                     int *end) {
    const algsurf_i_picture *picture = worker->picture;
    algsurf_i_make_row(picture, y, sx, 1, &worker->form, job);
    int misses = algsurf_i_pixels_within_bounds(picture, y, y, 1, begin, end);
    if (*begin < *end) algsurf_i_row_expand(&picture->geometry->frame, worker->form.v, &worker->form);
    return misses;
}

/* The roots of a row whose samples are in the pixels' middles, from those of the row above. */
static void follow(algsurf_i_worker *worker, int row) {
    algsurf_i_row_job job;
    int begin, end;
    (void)begin_row(worker, row + 0.5, 0.5, &job, &begin, &end);
    const algsurf_i_complex_job complex = complex_job_of(worker, &job);
    if (begin < end) (void)worker->picture->code->solve_complex(&complex, begin, end);
    end_row(worker, row, begin, end);
}

/* Before a pass over a row: the predictor holds what it is to start from. */
static void start_row(algsurf_i_worker *worker, int row) {
    const algsurf_i_picture *picture = worker->picture;
    algsurf_i_predictor *predictor = &worker->predictor;
    int coherent = picture->scene->coherence == ALGSURF_COHERENCE_NEIGHBOURS;
    int before = coherent && picture->scene->antialias == 1 ? row % ALGSURF_I_BAND : 0;
    if (coherent && predictor->row == row) return;
    if (before == 0 || predictor->row != row - 1) forget(predictor, 0, picture->width);
    if (before == 0 || predictor->row == row - 1) return;
    for (int above = row - before; above < row; above++) follow(worker, above);
}

/* Depths and states of the wanted pixels, in runs. */
static void solve_wanted(algsurf_i_worker *worker, const algsurf_i_complex_job *job, int begin, int end) {
    const uint8_t *wanted = worker->line.wanted;
    for (int x = begin, last; x < end; x = last) {
        for (last = wanted ? x + 1 : end; last < end && wanted[last] == wanted[x];) last++;
        if (!wanted || wanted[x])
            worker->tally->stats.iterations += worker->picture->code->solve_complex(job, x, last);
    }
}

/* The line's entries are those hit, in the order of their pixels. */
static void gather(algsurf_i_line *line, int begin, int end) {
    for (int x = begin; x < end; x++) {
        line->depth[line->count] = line->depth[x];
        line->imaginary[line->count] = line->imaginary[x];
        line->pixel[line->count] = x;
        line->count += line->state[x] == ALGSURF_LANE_HIT;
    }
}

static void find_points(algsurf_i_worker *worker, const algsurf_i_complex_job *job) {
    const algsurf_i_picture *picture = worker->picture;
    algsurf_i_line *line = &worker->line;
    const algsurf_i_points found = algsurf_i_points_to_find(worker, 0);
    if (!picture->code->complex_points(job, picture->scene->surface, line->pixel, line->depth,
                                       line->imaginary, line->count, line->sure, &found))
        algsurf_i_drop_unsure(line, 0);
}

int algsurf_i_solve_complex_row(algsurf_i_worker *worker, int row, double sx, double sy) {
    algsurf_i_line *line = &worker->line;
    algsurf_render_stats *stats = &worker->tally->stats;
    algsurf_i_row_job job;
    int begin, end;
    start_row(worker, row);
    int misses = begin_row(worker, row + sy, sx, &job, &begin, &end);
    algsurf_i_lap(worker, &stats->expand_s);
    algsurf_i_begin_states(line, misses);
    const algsurf_i_complex_job complex = complex_job_of(worker, &job);
    if (begin < end) {
        memset(line->state + begin, ALGSURF_LANE_MISS, (size_t)(end - begin));
        solve_wanted(worker, &complex, begin, end);
        gather(line, begin, end);
    }
    end_row(worker, row, begin, end);
    algsurf_i_lap(worker, &stats->solve_s);
    if (line->count > 0) find_points(worker, &complex);
    stats->hits += (uint64_t)line->count;
    algsurf_i_lap(worker, &stats->point_s);
    return 1; /* as far as is known */
}
