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

#define FAN_ROOM                                                                                             \
    1.0 /* of a fan's frame, in the picture's: segments leave the extent before they leave it                \
         */

/* A light in natural units. */
static void natural(const double v[3], int unit, double to[3]) {
    for (int i = 0; i < 3; i++) to[i] = ldexp(v[i], -unit);
}

void algsurf_i_make_fans(const algsurf_i_picture *picture, void *memory) {
    const algsurf_surface *surface = picture->scene->surface;
    const algsurf_i_view *shown = &picture->packets->frame.view;
    for (int l = 0; l < picture->light_count; l++) {
        const algsurf_light *light = &picture->lights[l];
        algsurf_i_fan *fan = &picture->packets->fans[l];
        double position[3], edge_u[3], edge_v[3];
        natural(light->position, surface->unit, position);
        natural(light->edge_u, surface->unit, edge_u);
        natural(light->edge_v, surface->unit, edge_v);
        for (int i = 0; i < 3; i++) fan->frame.view.centre[i] = shown->centre[i];
        fan->frame.view.size = FAN_ROOM * shown->size;
        /* three roundings each, relative to what is added up */
        double places =
            0x1p-50 * (algsurf_max_abs(position) + algsurf_max_abs(edge_u) + algsurf_max_abs(edge_v));
        algsurf_i_fan_expand(surface, position, edge_u, edge_v, places, fan, memory);
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

/* Places of a light. */
typedef struct places {
    const double *at[3];
    int count;
} places;

/* Appends rays from a point to those places that are above the tangent plane. */
static void add_rays(batch *b, const places *p, const double start[3], const double facing[3]) {
    double *x = b->direction[0] + b->count, *y = b->direction[1] + b->count, *z = b->direction[2] + b->count;
    int kept = 0;
    for (int i = 0; i < p->count; i++) {
        x[kept] = p->at[0][i] - start[0];
        y[kept] = p->at[1][i] - start[1];
        z[kept] = p->at[2][i] - start[2];
        kept += x[kept] * facing[0] + y[kept] * facing[1] + z[kept] * facing[2] > 0;
    }
    for (int k = 0; k < 3; k++)
        for (int i = 0; i < kept; i++) b->origin[k][b->count + (size_t)i] = start[k];
    b->count += (size_t)kept;
}

/* Sends rays from a point to places of a light; those that arrive are added to *seen. */
static algsurf_status shoot(batch *b, const places *all, const double start[3], const double facing[3],
                            double *seen) {
    for (int i = 0, count; i < all->count; i += count) {
        int room = BATCH - (int)b->count;
        count = all->count - i < room ? all->count - i : room;
        const places some = {{all->at[0] + i, all->at[1] + i, all->at[2] + i}, count};
        add_rays(b, &some, start, facing);
        b->share[b->groups] = seen;
        b->end[b->groups++] = b->count;
        if (b->count < BATCH && b->groups < BATCH) continue;
        algsurf_status status = send(b);
        if (status < 0) return status;
    }
    return ALGSURF_OK;
}

enum { BLOCK = 16 }; /* points on their way to the lights: their fans are kept */

/* Where their shadow rays start, and on which side of the surface. */
typedef struct block {
    int first, count; /* of the line's points */
    double start[3][BLOCK], facing[3][BLOCK];
} block;

static void begin_block(const algsurf_i_picture *picture, const algsurf_i_points *points, block *b) {
    for (int i = 0; i < b->count; i++) {
        double position[3], normal[3], direction[3], facing[3];
        for (int k = 0; k < 3; k++) {
            position[k] = points->position[k][b->first + i];
            normal[k] = points->normal[k][b->first + i];
            direction[k] = points->direction[k][b->first + i];
        }
        double height = lift(picture, points->t[b->first + i], position);
        (void)algsurf_i_facing(normal, direction, facing);
        for (int k = 0; k < 3; k++) {
            b->start[k][i] = position[k] + height * facing[k];
            b->facing[k][i] = facing[k];
        }
    }
}

static algsurf_i_fan_job fan_job(const algsurf_i_picture *picture, int light) {
    const algsurf_i_fan *fan = &picture->packets->fans[light];
    const algsurf_i_view *view = &fan->frame.view;
    int unit = picture->scene->surface->unit;
    algsurf_i_fan_job job = {.fan = fan, .unit = ldexp(1, -unit), .extent_kind = picture->scene->extent.kind};
    for (int i = 0; i < 3; i++) {
        job.light[i] = (ldexp(picture->lights[light].position[i], -unit) - view->centre[i]) / view->size;
        job.extent_size[i] =
            picture->packets->extent_size[i] * (picture->packets->frame.view.size / view->size);
    }
    return job;
}

/* Which of a light's samples are above the tangent plane of a point? */
typedef enum side { BEHIND, PARTLY, ABOVE } side;

/* Shading ignores a light whose middle is behind the point itself. */
static side side_of(const algsurf_light *light, const algsurf_i_points *points, const block *b, int i) {
    double height[2] = {0, 0}, half[2] = {0, 0}, size = 0;
    for (int k = 0; k < 3; k++) {
        double facing = b->facing[k][i], position = points->position[k][b->first + i];
        height[0] += (light->position[k] - position) * facing;
        height[1] += (light->position[k] - b->start[k][i]) * facing;
        half[0] += light->edge_u[k] * facing;
        half[1] += light->edge_v[k] * facing;
        size = fmax(size, fabs(light->position[k]) + fabs(position) + fabs(light->edge_u[k]) +
                              fabs(light->edge_v[k]));
    }
    if (!(height[0] > 0)) return BEHIND;
    return height[1] > 0.5 * (fabs(half[0]) + fabs(half[1])) + 0x1p-44 * size ? ABOVE : PARTLY;
}

static places places_of(const algsurf_i_picture *picture, int light) {
    const algsurf_i_samples *samples = &picture->light_samples;
    int first = samples->first[light];
    return (places){{samples->place[0] + first, samples->place[1] + first, samples->place[2] + first},
                    samples->first[light + 1] - first};
}

enum { CHUNK = 64 }; /* places that a fan is asked about at once */

/* The places of a light that the point of a fan sees; rays go to those that are in doubt. */
static algsurf_status see_places(batch *rays, const algsurf_i_fan_job *job, const algsurf_i_fan_point *point,
                                 const places *all, const double start[3], const double facing[3],
                                 double *seen) {
    for (int first = 0, count; first < all->count; first += count) {
        const double *at[3] = {all->at[0] + first, all->at[1] + first, all->at[2] + first};
        uint8_t state[CHUNK];
        count = all->count - first < CHUNK ? all->count - first : CHUNK;
        rays->picture->code->see_places(job, point, at, count, state);
        for (int i = 0; i < count; i++) {
            const places one = {{at[0] + i, at[1] + i, at[2] + i}, 1};
            double height = (at[0][i] - start[0]) * facing[0] + (at[1][i] - start[1]) * facing[1] +
                            (at[2][i] - start[2]) * facing[2];
            if (state[i] == ALGSURF_LANE_MISS) *seen += height > 0;
            if (state[i] != ALGSURF_LANE_DOUBTFUL) continue;
            algsurf_status status = shoot(rays, &one, start, facing, seen);
            if (status < 0) return status;
        }
    }
    return ALGSURF_OK;
}

/* How many samples of a light reach each point of a block. */
static algsurf_status light_block(batch *rays, const algsurf_i_line *line, int light, const block *b) {
    const algsurf_i_picture *picture = rays->picture;
    const places all = places_of(picture, light);
    const double *const starts[3] = {b->start[0], b->start[1], b->start[2]};
    uint8_t how[BLOCK];
    algsurf_i_fan_point unknown[BLOCK], *next = unknown;
    algsurf_i_fan_job job = {.fan = NULL};
    int n = picture->scene->surface->degree, solid = (n + 1) * (n + 2) * (n + 3) / 6;
    for (int i = 0; i < b->count; i++) {
        how[i] = ALGSURF_I_FAR;
        unknown[i].r = line->solids + i * solid;
    }
    if (picture->packets && picture->packets->fans && picture->packets->fans[light].usable) {
        job = fan_job(picture, light);
        picture->code->see_light(&job, starts, b->count, how, unknown);
    }
    for (int i = 0; i < b->count; i++) {
        double *seen = line->visible + (b->first + i) * picture->light_count + light;
        side at = side_of(&picture->lights[light], &line->points, b, i);
        const double start[3] = {b->start[0][i], b->start[1][i], b->start[2][i]};
        const double facing[3] = {b->facing[0][i], b->facing[1][i], b->facing[2][i]};
        algsurf_status status = ALGSURF_OK;
        const algsurf_i_fan_point *point = how[i] == ALGSURF_I_UNKNOWN ? next++ : NULL;
        *seen = at == ABOVE && how[i] == ALGSURF_I_LIT ? all.count : 0;
        if (at == BEHIND || how[i] == ALGSURF_I_DARK || *seen > 0) continue;
        if (point)
            status = see_places(rays, &job, point, &all, start, facing, seen);
        else
            status = shoot(rays, &all, start, facing, seen);
        if (status < 0) return status;
    }
    return ALGSURF_OK;
}

algsurf_status algsurf_i_render_shadows(const algsurf_i_picture *picture, algsurf_i_line *line,
                                        algsurf_i_tally *tally) {
    int lights = picture->light_count;
    batch rays;
    begin_batch(&rays, picture);
    for (block b = {.first = 0}; b.first < line->count; b.first += BLOCK) {
        b.count = line->count - b.first < BLOCK ? line->count - b.first : BLOCK;
        begin_block(picture, &line->points, &b);
        for (int l = 0; l < lights; l++) {
            if (atomic_load_explicit(&picture->stop, memory_order_relaxed)) return ALGSURF_CANCELLED;
            algsurf_status status = light_block(&rays, line, l, &b);
            if (status < 0) return status;
        }
    }
    algsurf_status status = send(&rays);
    if (status < 0) return status;
    for (int i = 0; i < line->count * lights; i++) {
        const algsurf_light *light = &picture->lights[i % lights];
        line->visible[i] /= light->samples_u * light->samples_v;
    }
    tally->shadow_rays += rays.rays;
    tally->without_memory += rays.without_memory;
    return ALGSURF_OK;
}
