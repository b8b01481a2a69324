/* render_shadow.c - which share of each light reaches a point of the surface.
 *
 * One shadow ray goes to each sample of each light (Cook, Porter, Carpenter 1984, with a regular grid
 * in place of a random one: the same picture every time).  It starts a little above the
 * tangent plane, on the viewer's side, so that the point does not shadow itself.
 */
#include "render_impl.h"
#include "shade_impl.h"
#include "vec.h"

/* The height above the surface: a millionth of what is shown is invisible, and well above the error of
 * a hit's position, which the second term bounds for far eyes and far extents: position and t are
 * rounded to 2^-53, and 2^-48 leaves room for the root's own error. */
static double lift(const algsurf_i_picture *picture, double t, const double position[3]) {
    return 1e-6 * picture->radius + 0x1p-48 * (fabs(t) + algsurf_max_abs(position));
}

enum { BATCH = 256 }; /* rays on their way to the packet call: enough to fill it, few enough for the stack */

/* Rays, and which light's share of which point each may add to. */
typedef struct batch {
    const algsurf_i_picture *picture;
    double origin[3][BATCH], direction[3][BATCH], t_max[BATCH];
    double *share[BATCH];
    size_t count;
    uint64_t rays; /* sent so far */
} batch;

static algsurf_status send(batch *b) {
    static const double from_start[BATCH] = {0};
    const algsurf_scene *scene = b->picture->scene;
    unsigned char state[BATCH];
    const algsurf_ray_packet rays = {.size = sizeof rays,
                                     .count = b->count,
                                     .origin = {b->origin[0], b->origin[1], b->origin[2]},
                                     .direction = {b->direction[0], b->direction[1], b->direction[2]},
                                     .t_min = from_start,
                                     .t_max = b->t_max};
    algsurf_status status =
        algsurf_occluded_packet(scene->surface, &scene->extent, &rays, &scene->intersect, state);
    if (status < 0) return status;
    for (size_t i = 0; i < b->count; i++) *b->share[i] += state[i] == ALGSURF_MISS;
    b->rays += b->count;
    b->count = 0;
    return ALGSURF_OK;
}

/* Sends rays from a point to those samples of a light that are above the tangent plane. */
static algsurf_status add_light(batch *b, const algsurf_light *light, const double start[3],
                                const double facing[3], double *share) {
    for (int v = 0; v < light->samples_v; v++)
        for (int u = 0; u < light->samples_u; u++) {
            double sample[3], direction[3];
            size_t i = b->count;
            algsurf_i_light_sample(light, u, v, sample);
            for (int k = 0; k < 3; k++) direction[k] = sample[k] - start[k];
            if (!(algsurf_dot(direction, facing) > 0)) continue;
            for (int k = 0; k < 3; k++) {
                b->origin[k][i] = start[k];
                b->direction[k][i] = direction[k];
            }
            b->t_max[i] = 1;
            b->share[i] = share;
            if (++b->count < BATCH) continue;
            algsurf_status status = send(b);
            if (status < 0) return status;
        }
    return ALGSURF_OK;
}

/* Rays from point i to all lights; visible counts the samples that are seen. */
static algsurf_status add_point(batch *b, const algsurf_i_points *points, int i, double *visible) {
    const algsurf_i_picture *picture = b->picture;
    double position[3], normal[3], direction[3], facing[3], start[3], to_light[3];
    for (int k = 0; k < 3; k++) {
        position[k] = points->position[k][i];
        normal[k] = points->normal[k][i];
        direction[k] = points->direction[k][i];
    }
    double height = lift(picture, points->t[i], position);
    (void)algsurf_i_facing(normal, direction, facing);
    for (int k = 0; k < 3; k++) start[k] = position[k] + height * facing[k];
    for (int l = 0; l < picture->light_count; l++) {
        const algsurf_light *light = &picture->lights[l];
        for (int k = 0; k < 3; k++) to_light[k] = light->position[k] - position[k];
        visible[l] = 0;
        if (!(algsurf_dot(to_light, facing) > 0)) continue; /* shading ignores a light behind */
        algsurf_status status = add_light(b, light, start, facing, &visible[l]);
        if (status < 0) return status;
    }
    return ALGSURF_OK;
}

algsurf_status algsurf_i_render_shadows(const algsurf_i_picture *picture, algsurf_i_line *line,
                                        uint64_t *shadow_rays) {
    int lights = picture->light_count;
    batch b;
    b.picture = picture;
    b.count = 0;
    b.rays = 0;
    for (int i = 0; i < line->count; i++) {
        if (atomic_load_explicit(&picture->stop, memory_order_relaxed)) return ALGSURF_CANCELLED;
        algsurf_status status = add_point(&b, &line->points, i, line->visible + i * lights);
        if (status < 0) return status;
    }
    algsurf_status status = send(&b);
    if (status < 0) return status;
    for (int i = 0; i < line->count * lights; i++) {
        const algsurf_light *light = &picture->lights[i % lights];
        line->visible[i] /= light->samples_u * light->samples_v;
    }
    *shadow_rays += b.rays;
    return ALGSURF_OK;
}
