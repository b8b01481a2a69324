/* shadow.c - which share of each light reaches a point of the surface.
 *
 * One shadow ray goes to each sample of each light (Cook, Porter, Carpenter 1984, with a regular grid
 * in place of a random one: the same picture every time).  It starts a little above the
 * tangent plane, on the viewer's side, so that the point does not shadow itself.
 */
#include "../base/arithmetic.h"
#include "impl.h"
#include "shade_impl.h"
#include "../base/vec.h"

/* The height above the surface: a millionth of what is shown is invisible, and well above the error of
 * a hit's position, which the second term bounds for far eyes and far extents: position and t are
 * rounded to 2^-53, and 2^-48 leaves room for the root's own error. */
static double lift(const algsurf_i_picture *picture, double t, const double position[3]) {
    return 1e-6 * picture->radius + 0x1p-48 * (fabs(t) + algsurf_max_abs(position));
}

void algsurf_i_count_samples(algsurf_i_picture *picture) {
    int *first = picture->light_samples.first;
    first[0] = 0;
    for (int l = 0; l < picture->light_count; l++)
        first[l + 1] = first[l] + picture->lights[l].samples_u * picture->lights[l].samples_v;
}

void algsurf_i_place_samples(algsurf_i_picture *picture) {
    const algsurf_i_samples *samples = &picture->light_samples;
    for (int l = 0; l < picture->light_count; l++) {
        const algsurf_light *light = &picture->lights[l];
        for (int i = 0; i < light->samples_u * light->samples_v; i++) {
            double place[3];
            algsurf_i_light_sample(light, i % light->samples_u, i / light->samples_u, place);
            for (int k = 0; k < 3; k++) samples->place[k][samples->first[l] + i] = place[k];
        }
    }
}

enum { BATCH = 128 }; /* rays on their way to the packet call: enough to fill it, few enough for the stack */

/* Rays in groups: those of one group add to one light's share of one point. */
typedef struct batch {
    const algsurf_i_picture *picture;
    double origin[3][BATCH], direction[3][BATCH], t_max[BATCH];
    size_t count;
    double *share[BATCH]; /* of each group */
    size_t end[BATCH];    /* where its rays end */
    int groups;
    uint64_t rays;           /* sent so far */
    uint64_t without_memory; /* packets of which some could not be decided for want of it */
} batch;

static void begin_batch(batch *b, const algsurf_i_picture *picture) {
    b->picture = picture;
    b->count = 0;
    b->groups = 0;
    b->rays = b->without_memory = 0;
    for (int i = 0; i < BATCH; i++) b->t_max[i] = 1;
}

static algsurf_status send(batch *b) {
    const algsurf_scene *scene = b->picture->scene;
    unsigned char state[BATCH];
    const algsurf_ray_packet rays = {.size = sizeof rays,
                                     .count = b->count,
                                     .origin = {b->origin[0], b->origin[1], b->origin[2]},
                                     .direction = {b->direction[0], b->direction[1], b->direction[2]},
                                     .t_max = b->t_max};
    algsurf_status status =
        algsurf_occluded_packet(scene->surface, &scene->extent, &rays, &scene->intersect, state);
    if (status < 0 && status != ALGSURF_E_NO_MEMORY) return status;
    b->without_memory += status < 0;
    size_t i = 0;
    for (int g = 0; g < b->groups; g++) {
        int seen = 0;
        for (; i < b->end[g]; i++) seen += state[i] == ALGSURF_MISS;
        *b->share[g] += seen;
    }
    b->rays += b->count;
    b->count = 0;
    b->groups = 0;
    return ALGSURF_OK;
}

/* Appends rays from a point to those of `count` samples that are above the tangent plane. */
static void add_rays(batch *b, const double *const sample[3], int count, const double start[3],
                     const double facing[3]) {
    double *x = b->direction[0] + b->count, *y = b->direction[1] + b->count, *z = b->direction[2] + b->count;
    unsigned char above[BATCH];
    int kept = 0;
    for (int i = 0; i < count; i++) {
        x[i] = sample[0][i] - start[0];
        y[i] = sample[1][i] - start[1];
        z[i] = sample[2][i] - start[2];
        above[i] = x[i] * facing[0] + y[i] * facing[1] + z[i] * facing[2] > 0;
        kept += above[i];
    }
    if (kept < count) {
        kept = 0;
        for (int i = 0; i < count; i++) {
            x[kept] = x[i];
            y[kept] = y[i];
            z[kept] = z[i];
            kept += above[i];
        }
    }
    for (int k = 0; k < 3; k++)
        for (int i = 0; i < kept; i++) b->origin[k][b->count + (size_t)i] = start[k];
    b->count += (size_t)kept;
}

/* Sends rays from a point to the samples of a light. */
static algsurf_status add_light(batch *b, int light, const double start[3], const double facing[3],
                                double *share) {
    const algsurf_i_samples *samples = &b->picture->light_samples;
    int end = samples->first[light + 1];
    for (int i = samples->first[light], count; i < end; i += count) {
        int room = BATCH - (int)b->count;
        const double *const from[3] = {samples->place[0] + i, samples->place[1] + i, samples->place[2] + i};
        count = end - i < room ? end - i : room;
        add_rays(b, from, count, start, facing);
        b->share[b->groups] = share;
        b->end[b->groups++] = b->count;
        if (b->count < BATCH && b->groups < BATCH) continue;
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
        algsurf_status status = add_light(b, l, start, facing, &visible[l]);
        if (status < 0) return status;
    }
    return ALGSURF_OK;
}

algsurf_status algsurf_i_render_shadows(const algsurf_i_picture *picture, algsurf_i_line *line,
                                        algsurf_i_tally *tally) {
    int lights = picture->light_count;
    batch b;
    begin_batch(&b, picture);
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
    tally->shadow_rays += b.rays;
    tally->without_memory += b.without_memory;
    return ALGSURF_OK;
}
