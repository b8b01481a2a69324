/* undecided.c - the rays of pixels that forms leave undecided, and of pictures without a view: as packets, in
 * complex space one by one. */
#include "../base/arithmetic.h"
#include "../rays/intersect_impl.h"
#include "impl.h"

/* So line->state tells of every point what it is. */
_Static_assert((int)ALGSURF_LANE_HIT == (int)ALGSURF_STATE_HIT, "both are the state of a pixel");

enum { GROUP = 16 }; /* undecided pixels that are solved together */

/* Pixels that the row left undecided, and their rays as a packet. */
typedef struct undecided_pixels {
    size_t count;
    int pixel[GROUP];
    double origin[3][GROUP], direction[3][GROUP];
} undecided_pixels;

/* Appends a single ray's hit at pixel x to the line's points, if it is one, sets its state and way, and
 * counts it. */
static void add_point(algsurf_i_worker *worker, int x, const algsurf_ray *ray, const algsurf_hit *hit) {
    algsurf_i_line *line = &worker->line;
    algsurf_render_stats *stats = &worker->tally->stats;
    const algsurf_i_points *points = &line->points;
    int i = line->count;
    line->state[x] = (uint8_t)hit->state;
    if (line->way) line->way[x] |= ALGSURF_WAY_SINGLE;
    stats->single_rays++;
    stats->hits += hit->state == ALGSURF_STATE_HIT;
    stats->undecided += hit->state == ALGSURF_STATE_UNDECIDED;
    if (hit->state == ALGSURF_STATE_MISS) return;
    line->pixel[line->count++] = x;
    points->t[i] = hit->t;
    for (int k = 0; k < 3; k++) {
        points->position[k][i] = hit->position[k];
        points->normal[k][i] = hit->normal[k];
        points->direction[k][i] = ray->direction[k];
    }
    if (line->colours)
        algsurf_i_set_look(&line->colours->frame, hit->position, hit->normal, ray->direction, i,
                           &points->looks);
}

/* The rays themselves, without the noise that a row allows for: most of them are decided side by side.  They
 * are finite (render.c): nothing but memory may be missing. */
static void solve_group(algsurf_i_worker *worker, undecided_pixels *d) {
    const algsurf_scene *scene = worker->picture->scene;
    unsigned char state[GROUP];
    double t[GROUP], position[3][GROUP], normal[3][GROUP];
    const algsurf_ray_packet rays = {.size = sizeof rays,
                                     .count = d->count,
                                     .origin = {d->origin[0], d->origin[1], d->origin[2]},
                                     .direction = {d->direction[0], d->direction[1], d->direction[2]}};
    const algsurf_hit_packet hits = {.size = sizeof hits,
                                     .state = state,
                                     .t = t,
                                     .position = {position[0], position[1], position[2]},
                                     .normal = {normal[0], normal[1], normal[2]}};
    worker->tally->without_memory +=
        algsurf_i_intersect_packet(scene->given, &scene->extent, &rays, &scene->intersect, 0, &hits,
                                   &worker->tally->stats.exact_rays) < 0;
    for (size_t i = 0; i < d->count; i++) {
        algsurf_ray ray;
        algsurf_hit hit = {.state = state[i], .t = t[i]};
        for (int k = 0; k < 3; k++) {
            ray.direction[k] = d->direction[k][i];
            hit.position[k] = position[k][i];
            hit.normal[k] = normal[k][i];
        }
        add_point(worker, d->pixel[i], &ray, &hit);
    }
    d->count = 0;
}

static void solve_complex(algsurf_i_worker *worker, int x, const algsurf_ray *ray) {
    const algsurf_scene *scene = worker->picture->scene;
    const algsurf_i_region region = {&scene->extent, scene->intersect.planes, scene->intersect.plane_count};
    algsurf_hit hit;
    int iterations;
    worker->tally->without_memory += algsurf_i_intersect_complex(scene->surface, &region, ray, &scene->space,
                                                                 NULL, NULL, &hit, NULL, &iterations) < 0;
    worker->tally->stats.iterations += (uint64_t)iterations;
    add_point(worker, x, ray, &hit);
}

algsurf_status algsurf_i_solve_undecided(algsurf_i_worker *worker, double y, double sx, int begin, int end) {
    const algsurf_i_picture *picture = worker->picture;
    const algsurf_i_line *line = &worker->line;
    const algsurf_scene *scene = picture->scene;
    undecided_pixels d = {.count = 0};
    for (int x = begin; x < end; x++) {
        algsurf_ray ray;
        if (line->state[x] != ALGSURF_LANE_UNDECIDED) continue;
        if (algsurf_i_stopped(picture)) return ALGSURF_CANCELLED;
        algsurf_i_camera_ray(&scene->camera, picture->width, picture->height,
                             line->dense > 1 ? (x + 0.5) / line->dense : x + sx, y, &ray);
        if (scene->complex) {
            solve_complex(worker, x, &ray);
            continue;
        }
        d.pixel[d.count] = x;
        for (int k = 0; k < 3; k++) {
            d.origin[k][d.count] = ray.origin[k];
            d.direction[k][d.count] = ray.direction[k];
        }
        if (++d.count == GROUP) solve_group(worker, &d);
    }
    if (d.count > 0) solve_group(worker, &d);
    return ALGSURF_OK;
}
