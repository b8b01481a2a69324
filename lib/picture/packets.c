/* packets.c - the hits of a row at once; what that leaves undecided, and pictures without a frame, as packets
 * of rays. */
#include "../base/arithmetic.h"
#include <math.h>
#include <string.h>

#include "camera_impl.h"
#include "complex_impl.h"
#include "impl.h"
#include "packets.h"
#include "tiling.h"
#include "../rays/intersect_impl.h"

enum { GROUP = 16 }; /* undecided pixels that are solved together */

#define CLOSE 8 /* pixels: to begin anew costs as much as to go on for so many */

algsurf_i_row_job algsurf_i_any_row(const algsurf_i_picture *picture) {
    const algsurf_i_packets *p = picture->packets;
    return (algsurf_i_row_job){.view = &p->frame.view,
                               .basis = p->frame.basis,
                               .offset = -0.5 * picture->width,
                               .pixel = p->pixel,
                               .u0 = p->origin[0],
                               .du = p->per_slope,
                               .extent = &picture->scene->extent,
                               .extent_size = {p->extent_size[0], p->extent_size[1], p->extent_size[2]},
                               .planes = p->view_planes,
                               .plane_count = p->plane_count,
                               .near = p->near,
                               .tolerance = p->tolerance,
                               .thin_side = p->thin_side,
                               .thin_before = 4 * p->thin_side,
                               .thin_large = p->thin_large};
}

void algsurf_i_make_row(const algsurf_i_picture *picture, double y, double sx, algsurf_i_row_form *form,
                        algsurf_i_row_job *job) {
    const algsurf_i_packets *p = picture->packets;
    const algsurf_i_view *view = &p->frame.view;
    form->v = p->origin[1] + p->per_slope * ((0.5 * picture->height - y) * p->pixel);
    *job = algsurf_i_any_row(picture);
    job->row = form;
    job->offset += sx;
    job->slope = view->alpha * form->v + view->beta[1];
}

/* The error bounds of forms hold for rays that stay within this of the view's centre in x and y, over the
 * depths of what is shown, |z| <= 1 (row_template.h). */
#define BOUND 4

static int within_bounds(const algsurf_i_row_job *job, int begin, int end) {
    const algsurf_i_view *view = job->view;
    double first = job->u0 + job->du * ((begin + job->offset) * job->pixel);
    double last = job->u0 + job->du * ((end + job->offset) * job->pixel);
    double u = fmax(fabs(first), fabs(last)), v = fabs(job->row->v);
    return u * (1 + fabs(view->alpha)) + fabs(view->beta[0]) < BOUND && v + fabs(job->slope) < BOUND;
}

int algsurf_i_has_cells(const algsurf_i_picture *picture, double y) {
    algsurf_i_row_form form;
    algsurf_i_row_job job;
    if (!picture->packets || !picture->packets->beams) return 0;
    algsurf_i_make_row(picture, y, 0.5, &form, &job);
    return within_bounds(&job, 0, picture->width);
}

void algsurf_i_range_within_bounds(const algsurf_i_picture *picture, double top, double bottom, int margin,
                                   int *begin, int *end) {
    const algsurf_i_packets *p = picture->packets;
    const algsurf_i_view *view = &p->frame.view;
    double side = fabs(p->per_slope) * p->pixel, spread = 1 + fabs(view->alpha), half = 0.5 * picture->width;
    double from_middle = fmax(fabs(0.5 * picture->height - top), fabs(0.5 * picture->height - bottom));
    double v = fabs(p->origin[1]) + side * (from_middle + 1);
    /* pixels so far from the middle are within them */
    double room = ((BOUND - fabs(view->beta[0])) / spread - fabs(p->origin[0])) / side - margin;
    *begin = *end = 0;
    if (!(v * spread + fabs(view->beta[1]) < BOUND) || !(room > 0)) return;
    *begin = room < half ? (int)ceil(half - room) : 0;
    *end = room < half ? (int)floor(half + room) : picture->width;
}

int algsurf_i_begin_row(const algsurf_i_picture *picture, double y, double sx, algsurf_i_row_form *form,
                        algsurf_i_row_job *job, int *begin, int *end) {
    algsurf_i_make_row(picture, y, sx, form, job);
    algsurf_i_packets_range(job, picture->width, begin, end);
    if (*begin >= *end || !within_bounds(job, *begin, *end)) return 0;
    algsurf_i_row_expand(&picture->packets->frame, form->v, form);
    return 1;
}

/* Depths and states of pixels that follow each other. */
static void solve_run(const algsurf_i_picture *picture, const algsurf_i_row_job *job, int begin, int end,
                      algsurf_i_worker *worker, algsurf_i_tally *tally) {
    if (!picture->scene->complex) {
        const algsurf_i_pixels pixels = {.first = begin, .count = end - begin};
        picture->code->solve_row(job, &pixels, worker->line.depth + begin, worker->line.state + begin);
        return;
    }
    const algsurf_i_complex_job complex = algsurf_i_complex_job_of(picture, job, worker);
    tally->iterations += picture->code->solve_complex(&complex, begin, end);
}

/* The wanted pixels, in runs: those with few others between are solved together. */
static void solve_wanted(const algsurf_i_picture *picture, const algsurf_i_row_job *job, int begin, int end,
                         algsurf_i_worker *worker, algsurf_i_tally *tally) {
    const algsurf_i_line *line = &worker->line;
    for (int x = begin; x < end; x++) {
        int last = x;
        if (!line->wanted[x]) continue;
        for (int next = x + 1; next < end && next <= last + CLOSE; next++)
            if (line->wanted[next]) last = next;
        solve_run(picture, job, x, last + 1, worker, tally);
        x = last;
    }
    for (int x = begin; x < end; x++)
        if (!line->wanted[x]) line->state[x] = ALGSURF_LANE_MISS;
}

/* Pixels that the row left undecided, and their rays as a packet. */
typedef struct undecided_pixels {
    size_t count;
    int pixel[GROUP];
    double origin[3][GROUP], direction[3][GROUP], t_min[GROUP], t_max[GROUP];
} undecided_pixels;

static void add_pixel(undecided_pixels *d, int x, const algsurf_ray *ray) {
    size_t i = d->count++;
    d->pixel[i] = x;
    d->t_min[i] = ray->t_min;
    d->t_max[i] = ray->t_max;
    for (int k = 0; k < 3; k++) {
        d->origin[k][i] = ray->origin[k];
        d->direction[k][i] = ray->direction[k];
    }
}

/* The rays themselves, without the noise that a row allows for: most of them are decided side by side. */
static algsurf_status solve_group(const algsurf_scene *scene, const undecided_pixels *d, algsurf_i_line *line,
                                  algsurf_i_tally *tally) {
    unsigned char state[GROUP];
    double t[GROUP], position[3][GROUP], normal[3][GROUP];
    const algsurf_ray_packet rays = {
        .size = sizeof rays,
        .count = d->count,
        .origin = {d->origin[0], d->origin[1], d->origin[2]},
        .direction = {d->direction[0], d->direction[1], d->direction[2]},
        .t_min = d->t_min,
        .t_max = d->t_max,
    };
    const algsurf_hit_packet hits = {
        .size = sizeof hits,
        .state = state,
        .t = t,
        .position = {position[0], position[1], position[2]},
        .normal = {normal[0], normal[1], normal[2]},
    };
    algsurf_status status = algsurf_i_intersect_packet(scene->surface, &scene->extent, &rays,
                                                       &scene->intersect, &hits, &tally->exact_rays);
    if (status < 0 && status != ALGSURF_E_NO_MEMORY) return status;
    tally->without_memory += status < 0;
    for (size_t i = 0; i < d->count; i++) {
        algsurf_ray ray;
        algsurf_hit hit = {.state = state[i], .t = t[i]};
        for (int k = 0; k < 3; k++) {
            ray.direction[k] = d->direction[k][i];
            hit.position[k] = position[k][i];
            hit.normal[k] = normal[k][i];
        }
        algsurf_i_line_add(line, d->pixel[i], &ray, &hit, tally);
    }
    tally->single_rays += d->count;
    return ALGSURF_OK;
}

algsurf_status algsurf_i_solve_undecided(const algsurf_i_picture *picture, double y, double sx, int begin,
                                         int end, algsurf_i_line *line, algsurf_i_tally *tally) {
    const algsurf_scene *scene = picture->scene;
    undecided_pixels d = {.count = 0};
    algsurf_status status = ALGSURF_OK;
    if (scene->complex) return algsurf_i_complex_solve_undecided(picture, y, sx, begin, end, line, tally);
    for (int x = begin; x < end && status == ALGSURF_OK; x++) {
        algsurf_ray ray;
        if (line->state[x] == ALGSURF_LANE_UNDECIDED) {
            algsurf_i_camera_ray(&scene->camera, picture->width, picture->height,
                                 algsurf_i_place_of(line, x, sx), y, &ray);
            add_pixel(&d, x, &ray);
        }
        if (d.count < GROUP && (x + 1 < end || d.count == 0)) continue;
        if (atomic_load_explicit(&picture->stop, memory_order_relaxed)) return ALGSURF_CANCELLED;
        status = solve_group(scene, &d, line, tally);
        d.count = 0;
    }
    return status;
}

/* Hits move to the front of depth, their pixels to the line; returns whether there are undecided ones. */
static int gather(algsurf_i_line *line, int begin, int end) {
    int undecided = 0;
    for (int x = begin; x < end; x++) {
        uint64_t eight; /* most of a picture is empty */
        if (end - x >= 8 && (memcpy(&eight, line->state + x, 8), eight == 0)) {
            x += 7;
            continue;
        }
        line->depth[line->count] = line->depth[x];
        if (line->imaginary) line->imaginary[line->count] = line->imaginary[x];
        line->pixel[line->count] = x;
        line->count += line->state[x] == ALGSURF_LANE_HIT;
        undecided |= line->state[x] == ALGSURF_LANE_UNDECIDED;
    }
    return undecided;
}

/* Positions and normals of the line's points, which are hits. */
static void find_points(const algsurf_i_picture *picture, const algsurf_i_row_job *job, int hits,
                        algsurf_i_worker *worker) {
    algsurf_i_line *line = &worker->line;
    const algsurf_surface *surface = picture->scene->surface;
    if (!picture->scene->complex) {
        const algsurf_i_point_job points = {surface, job, line->colours};
        const algsurf_i_points wanted = algsurf_i_points_to_find(picture, line, 0);
        picture->code->points(&points, line->pixel, line->depth, hits, &wanted);
        return;
    }
    const algsurf_i_complex_job complex = algsurf_i_complex_job_of(picture, job, worker);
    algsurf_i_points wanted = line->points;
    if (!line->colours) wanted.looks = (algsurf_i_looks){{NULL}, {NULL}, {NULL}};
    picture->code->complex_points(&complex, surface, line->pixel, line->depth, line->imaginary, hits,
                                  &wanted);
}

algsurf_status algsurf_i_render_packets(const algsurf_i_picture *picture, int row, double sx, double sy,
                                        algsurf_i_worker *worker, algsurf_i_tally *tally) {
    algsurf_i_line *line = &worker->line;
    algsurf_i_row_job job;
    int begin, end, undecided = 1, complex = picture->scene->complex;
    double begun = algsurf_i_render_clock(picture);
    const algsurf_i_band *band = picture->tiled ? algsurf_i_band_of(picture, row, 1, &worker->tiling) : NULL;
    if (band) {
        tally->solve_s += algsurf_i_render_clock(picture) - begun;
        return algsurf_i_render_tiled(picture, band, row, sx, sy, worker, tally);
    }
    tally->rays += (uint64_t)line->wanted_count;
    if (complex) algsurf_i_complex_begin_row(picture, row, worker);
    int expanded = algsurf_i_begin_row(picture, row + sy, sx, &worker->form, &job, &begin, &end);
    double solving = algsurf_i_render_clock(picture);
    tally->expand_s += solving - begun;
    if (expanded) {
        if (line->wanted)
            solve_wanted(picture, &job, begin, end, worker, tally);
        else
            solve_run(picture, &job, begin, end, worker, tally);
        undecided = gather(line, begin, end);
        tally->hits += (uint64_t)line->count;
    } else {
        for (int x = begin; x < end; x++)
            line->state[x] = !line->wanted || line->wanted[x] ? ALGSURF_LANE_UNDECIDED : ALGSURF_LANE_MISS;
    }
    if (complex) algsurf_i_complex_end_row(picture, row, expanded ? begin : 0, expanded ? end : 0, worker);
    int hits = line->count;
    algsurf_status status =
        undecided ? algsurf_i_solve_undecided(picture, row + sy, sx, begin, end, line, tally) : ALGSURF_OK;
    double solved = algsurf_i_render_clock(picture);
    tally->solve_s += solved - solving;
    if (hits > 0) find_points(picture, &job, hits, worker);
    tally->point_s += algsurf_i_render_clock(picture) - solved;
    return status;
}

algsurf_status algsurf_i_render_rays(const algsurf_i_picture *picture, int row, double sx, double sy,
                                     algsurf_i_line *line, algsurf_i_tally *tally) {
    double begun = algsurf_i_render_clock(picture);
    int width = picture->width;
    for (int x = 0; x < width; x++)
        line->state[x] = !line->wanted || line->wanted[x] ? ALGSURF_LANE_UNDECIDED : ALGSURF_LANE_MISS;
    tally->rays += (uint64_t)line->wanted_count;
    algsurf_status status = algsurf_i_solve_undecided(picture, row + sy, sx, 0, width, line, tally);
    tally->solve_s += algsurf_i_render_clock(picture) - begun;
    return status;
}
