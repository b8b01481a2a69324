/* undecided.c - the rays of pixels that forms leave undecided, and of pictures without a view, as packets of
 * rays. */
#include "../base/arithmetic.h"
#include "camera_impl.h"
#include "impl.h"
#include "solve.h"
#include "../rays/intersect_impl.h"

enum { GROUP = 16 }; /* undecided pixels that are solved together */

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

algsurf_status algsurf_i_solve_rays(const algsurf_i_picture *picture, int row, double sx, double sy,
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
