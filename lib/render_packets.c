/* render_packets.c - the hits of a row by packets; rays they leave in doubt go the exact way, one by one. */
#include <math.h>
#include <string.h>

#include "camera_impl.h"
#include "render_impl.h"

#define CLOSE 8 /* pixels: to begin anew costs as much as to go on for so many */

/* The row's job, and the pixels whose rays may meet what is shown; 0 when there are none. */
static int make_job(const algsurf_i_picture *picture, double y, double sx, algsurf_i_row_form *form,
                    algsurf_i_row_job *job, int *begin, int *end) {
    const algsurf_i_packets *p = picture->packets;
    const algsurf_i_view *view = &p->frame.view;
    form->v = p->origin[1] + p->per_slope * ((0.5 * picture->height - y) * p->pixel);
    *job = (algsurf_i_row_job){.view = view,
                               .basis = p->frame.basis,
                               .row = form,
                               .offset = sx - 0.5 * picture->width,
                               .pixel = p->pixel,
                               .u0 = p->origin[0],
                               .du = p->per_slope,
                               .slope = view->alpha * form->v + view->beta[1],
                               .extent = &picture->scene->extent,
                               .extent_size = {p->extent_size[0], p->extent_size[1], p->extent_size[2]},
                               .near = p->near,
                               .bounded = picture->scene->intersect.tier != ALGSURF_TIER_FAST,
                               .tolerance = p->tolerance};
    algsurf_i_packets_range(job, picture->width, begin, end);
    return *begin < *end;
}

/* The error bounds hold for rays that stay within 4 of the view's centre in x and y. */
static int within_bounds(const algsurf_i_row_job *job, int begin, int end) {
    const algsurf_i_view *view = job->view;
    double first = job->u0 + job->du * ((begin + job->offset) * job->pixel);
    double last = job->u0 + job->du * ((end + job->offset) * job->pixel);
    double u = fmax(fabs(first), fabs(last)), v = fabs(job->row->v);
    return u * (1 + fabs(view->alpha)) + fabs(view->beta[0]) < 4 && v + fabs(job->slope) < 4;
}

/* The wanted pixels, in runs: those with few others between are solved together. */
static void solve_wanted(const algsurf_i_picture *picture, const algsurf_i_row_job *job, int begin, int end,
                         algsurf_i_line *line) {
    for (int x = begin; x < end; x++) {
        int last = x;
        if (!line->wanted[x]) continue;
        for (int next = x + 1; next < end && next <= last + CLOSE; next++)
            if (line->wanted[next]) last = next;
        picture->kernel->solve_row(job, x, last + 1, line->depth, line->state);
        x = last;
    }
    for (int x = begin; x < end; x++)
        if (!line->wanted[x]) line->state[x] = ALGSURF_LANE_MISS;
}

/* The doubtful pixels, one by one. */
static algsurf_status solve_doubtful(const algsurf_i_picture *picture, double y, double sx, int begin,
                                     int end, algsurf_i_line *line, algsurf_i_tally *tally) {
    const algsurf_scene *scene = picture->scene;
    for (int x = begin; x < end; x++) {
        algsurf_ray ray;
        algsurf_hit hit;
        if (line->state[x] != ALGSURF_LANE_DOUBTFUL) continue;
        if (atomic_load_explicit(&picture->stop, memory_order_relaxed)) return ALGSURF_CANCELLED;
        algsurf_i_camera_ray(&scene->camera, picture->width, picture->height, x + sx, y, &ray);
        algsurf_status status =
            algsurf_intersect_first(scene->surface, &scene->extent, &ray, &scene->intersect, &hit);
        if (status < 0) return status;
        algsurf_i_line_add(line, x, &ray, &hit, tally);
        tally->single_rays++;
    }
    return ALGSURF_OK;
}

/* Hits move to the front of depth, their pixels to the line; returns whether there are doubtful ones. */
static int gather(algsurf_i_line *line, int begin, int end) {
    int doubtful = 0;
    for (int x = begin; x < end; x++) {
        uint64_t eight; /* most of a picture is empty */
        if (end - x >= 8 && (memcpy(&eight, line->state + x, 8), eight == 0)) {
            x += 7;
            continue;
        }
        line->depth[line->count] = line->depth[x];
        line->pixel[line->count] = x;
        line->count += line->state[x] == ALGSURF_LANE_HIT;
        doubtful |= line->state[x] == ALGSURF_LANE_DOUBTFUL;
    }
    return doubtful;
}

algsurf_status algsurf_i_render_packets(const algsurf_i_picture *picture, int row, double sx, double sy,
                                        algsurf_i_line *line, algsurf_i_tally *tally) {
    const algsurf_i_packets *p = picture->packets;
    algsurf_i_row_form form;
    algsurf_i_row_job job;
    int begin, end, doubtful = 1;
    double begun = algsurf_i_render_clock();
    tally->rays += (uint64_t)line->wanted_count;
    if (!make_job(picture, row + sy, sx, &form, &job, &begin, &end)) return ALGSURF_OK;
    if (within_bounds(&job, begin, end)) {
        algsurf_i_row_expand(&p->frame, form.v, &form);
        double expanded = algsurf_i_render_clock();
        tally->expand_s += expanded - begun;
        begun = expanded;
        if (line->wanted)
            solve_wanted(picture, &job, begin, end, line);
        else
            picture->kernel->solve_row(&job, begin, end, line->depth, line->state);
        doubtful = gather(line, begin, end);
        tally->hits += (uint64_t)line->count;
    } else {
        for (int x = begin; x < end; x++)
            line->state[x] = !line->wanted || line->wanted[x] ? ALGSURF_LANE_DOUBTFUL : ALGSURF_LANE_MISS;
    }
    int hits = line->count;
    algsurf_status status =
        doubtful ? solve_doubtful(picture, row + sy, sx, begin, end, line, tally) : ALGSURF_OK;
    double solved = algsurf_i_render_clock();
    tally->solve_s += solved - begun;
    const algsurf_i_point_job points = {.surface = picture->scene->surface, .row = &job};
    picture->kernel->points(&points, line->pixel, line->depth, hits, &line->points);
    tally->point_s += algsurf_i_render_clock() - solved;
    return status;
}
