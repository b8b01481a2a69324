/* complex_rows.c - complex space: the roots of a row, started from those of the row above.
 *
 * Spatial coherence (Sanjuan-Estrada, Casado, Garcia, section 3): neighbouring rays have nearly the same
 * roots, and an iteration that starts there takes fewer steps.  It saves time and must not show.  Two things
 * see to it:
 * - the root that is seen is settled with doubled precision (complex/lanes_template.h), so that its bits do
 *   not tell where the iteration began;
 * - which pixels are left to the single ray may depend on the start.  So rows begin anew at multiples of
 *   ALGSURF_I_BAND, counted from the top of the picture, and whoever begins elsewhere solves the rows before,
 *   from there on.  Where a pixel has several samples, a row's first pass begins anew, and each other one
 *   starts from the pass before. */
#include "../base/arithmetic.h"
#include <math.h>
#include <string.h>

#include "camera_impl.h"
#include "complex_rows.h"
#include "impl.h"
#include "solve.h"
#include "../rays/intersect_impl.h"
#include "../rays/region.h"

void algsurf_i_complex_prepare(const algsurf_scene *scene, algsurf_i_geometry *geometry) {
    const algsurf_surface *s = scene->surface;
    geometry->top = s->degree;
    while (geometry->top >= 0 && scene->space.imaginary[geometry->top] == 0) geometry->top--;
    for (int k = 0; k <= geometry->top; k++)
        geometry->imaginary[k] = ldexp(scene->space.imaginary[k], s->scale + k * s->unit);
    geometry->frame.view.noise *= 4; /* complex_pixels_template.h */
}

static void forget(algsurf_i_predictor *predictor, int begin, int end) {
    for (int x = begin; x < end; x++) predictor->x[x] = NAN;
}

static algsurf_i_complex_job complex_job_of(const algsurf_i_picture *picture, const algsurf_i_row_job *row,
                                            algsurf_i_worker *worker) {
    return (algsurf_i_complex_job){.row = row,
                                   .sector = &picture->geometry->sector,
                                   .imaginary = picture->geometry->imaginary,
                                   .top = picture->geometry->top,
                                   .looks = &picture->colours.frame,
                                   .x = worker->predictor.x,
                                   .y = worker->predictor.y,
                                   .stride = picture->width,
                                   .re = worker->line.depth,
                                   .im = worker->line.imaginary,
                                   .state = worker->line.state};
}

/* After it: the pixels from begin to end have been solved. */
static void end_row(const algsurf_i_picture *picture, int row, int begin, int end, algsurf_i_worker *worker) {
    forget(&worker->predictor, 0, begin);
    forget(&worker->predictor, end, picture->width);
    worker->predictor.row = row;
}

/* The row's form and job, and the pixels begin <= x < end that are within the bounds of forms; *misses: do
 * all others surely miss? */
static int begin_row(const algsurf_i_picture *picture, double y, double sx, algsurf_i_worker *worker,
                     algsurf_i_row_job *job, int *begin, int *end) {
    algsurf_i_make_row(picture, y, sx, &worker->form, job);
    int misses = algsurf_i_pixels_within_bounds(picture, y, y, 1, begin, end);
    if (*begin < *end) algsurf_i_row_expand(&picture->geometry->frame, worker->form.v, &worker->form);
    return misses;
}

/* The roots of a row whose samples are in the pixels' middles, from those of the row above. */
static void follow(const algsurf_i_picture *picture, int row, algsurf_i_worker *worker) {
    algsurf_i_row_job job;
    int begin, end;
    (void)begin_row(picture, row + 0.5, 0.5, worker, &job, &begin, &end);
    if (begin < end) {
        const algsurf_i_complex_job complex = complex_job_of(picture, &job, worker);
        (void)picture->code->solve_complex(&complex, begin, end);
    }
    end_row(picture, row, begin, end, worker);
}

/* Before a pass over a row: the predictor holds what it is to start from. */
static void start_row(const algsurf_i_picture *picture, int row, algsurf_i_worker *worker) {
    algsurf_i_predictor *predictor = &worker->predictor;
    int coherent = picture->scene->coherence == ALGSURF_COHERENCE_NEIGHBOURS;
    int before = coherent && picture->scene->antialias == 1 ? row % ALGSURF_I_BAND : 0;
    if (coherent && predictor->row == row) return;
    if (before == 0 || predictor->row != row - 1) forget(predictor, 0, picture->width);
    if (before == 0 || predictor->row == row - 1) return;
    for (int above = row - before; above < row; above++) follow(picture, above, worker);
}

static algsurf_status solve_alone(const algsurf_i_picture *picture, int x, double sx, double y,
                                  algsurf_i_line *line, algsurf_i_tally *tally) {
    const algsurf_scene *scene = picture->scene;
    algsurf_ray ray;
    algsurf_hit hit;
    int iterations;
    algsurf_i_camera_ray(&scene->camera, picture->width, picture->height, x + sx, y, &ray);
    const algsurf_i_region region = {&scene->extent, scene->intersect.planes, scene->intersect.plane_count};
    algsurf_status status = algsurf_i_intersect_complex(scene->surface, &region, &ray, &scene->space, NULL,
                                                        NULL, &hit, NULL, &iterations);
    if (status < 0) return status;
    tally->iterations += (uint64_t)iterations;
    tally->single_rays++;
    algsurf_i_line_add(line, x, &ray, &hit, tally);
    return ALGSURF_OK;
}

static algsurf_status solve_undecided(const algsurf_i_picture *picture, double y, double sx,
                                      algsurf_i_line *line, algsurf_i_tally *tally) {
    algsurf_status status = ALGSURF_OK;
    for (int x = 0; x < picture->width && status == ALGSURF_OK; x++) {
        if (line->state[x] != ALGSURF_LANE_UNDECIDED) continue;
        if (atomic_load_explicit(&picture->stop, memory_order_relaxed)) return ALGSURF_CANCELLED;
        status = solve_alone(picture, x, sx, y, line, tally);
    }
    return status;
}

/* Depths and states of the wanted pixels, in runs. */
static void solve_wanted(const algsurf_i_picture *picture, const algsurf_i_complex_job *job, int begin,
                         int end, const uint8_t *wanted, algsurf_i_tally *tally) {
    for (int x = begin, last; x < end; x = last) {
        for (last = x + 1; last < end && wanted && wanted[last] == wanted[x];) last++;
        if (!wanted) last = end;
        if (!wanted || wanted[x]) tally->iterations += picture->code->solve_complex(job, x, last);
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

static void find_points(const algsurf_i_picture *picture, const algsurf_i_complex_job *job,
                        algsurf_i_line *line) {
    algsurf_i_points wanted = line->points;
    if (!line->colours) wanted.looks = (algsurf_i_looks){{NULL}, {NULL}, {NULL}};
    if (!picture->code->complex_points(job, picture->scene->surface, line->pixel, line->depth,
                                       line->imaginary, line->count, line->sure, &wanted))
        (void)algsurf_i_drop_unsure(line, 0);
}

/* Points of the row by forms; what is left is undecided. */
static void solve_forms(const algsurf_i_picture *picture, int row, double sx, double sy,
                        algsurf_i_worker *worker, algsurf_i_tally *tally) {
    algsurf_i_line *line = &worker->line;
    algsurf_i_row_job job;
    int begin, end;
    double begun = algsurf_i_render_clock(picture);
    start_row(picture, row, worker);
    int misses = begin_row(picture, row + sy, sx, worker, &job, &begin, &end);
    double solving = algsurf_i_render_clock(picture);
    algsurf_i_begin_states(line, misses);
    const algsurf_i_complex_job complex = complex_job_of(picture, &job, worker);
    if (begin < end) {
        memset(line->state + begin, ALGSURF_LANE_MISS, (size_t)(end - begin));
        solve_wanted(picture, &complex, begin, end, line->wanted, tally);
        gather(line, begin, end);
    }
    end_row(picture, row, begin, end, worker);
    double solved = algsurf_i_render_clock(picture);
    if (line->count > 0) find_points(picture, &complex, line);
    tally->hits += (uint64_t)line->count;
    tally->expand_s += solving - begun;
    tally->solve_s += solved - solving;
    tally->point_s += algsurf_i_render_clock(picture) - solved;
}

algsurf_status algsurf_i_solve_complex_row(const algsurf_i_picture *picture, int row, double sx, double sy,
                                           algsurf_i_worker *worker, algsurf_i_tally *tally) {
    tally->rays += (uint64_t)worker->line.wanted_count;
    if (picture->geometry)
        solve_forms(picture, row, sx, sy, worker, tally);
    else
        algsurf_i_begin_states(&worker->line, 0);
    double begun = algsurf_i_render_clock(picture);
    algsurf_status status = solve_undecided(picture, row + sy, sx, &worker->line, tally);
    tally->solve_s += algsurf_i_render_clock(picture) - begun;
    return status;
}
