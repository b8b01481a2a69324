/* shadow.c - which share of each light reaches a point of the surface.
 *
 * One shadow ray goes to each sample of each light (Cook, Porter, Carpenter 1984, with a regular grid
 * in place of a random one: the same picture every time).  It starts a little above the
 * tangent plane, on the viewer's side, so that the point does not shadow itself.
 *
 * Up to degree 7 the rays from a point to a light are first asked about all at once, as a fan: most points
 * see the whole light or nothing of it.  Where that is not known the fan tells of one place after the other.
 * Only what is in doubt then is shot as a ray.  The answers are those of the rays. */
#include "../base/arithmetic.h"
#include "shade_impl.h"
#include "shadow_rays.h"

#include <string.h>

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

/* Three roundings each, relative to what is added up. */
static double error_of_places(const double position[3], const double edge_u[3], const double edge_v[3]) {
    return 0x1p-50 * (algsurf_max_abs(position) + algsurf_max_abs(edge_u) + algsurf_max_abs(edge_v));
}

/* Where a light's samples are from its middle, in the fan's axes and unit. */
static void place_aside(const algsurf_i_samples *samples, int light, int unit, const double position[3],
                        const algsurf_i_view *view) {
    for (int i = samples->first[light]; i < samples->first[light + 1]; i++) {
        double place[3];
        for (int k = 0; k < 3; k++)
            place[k] = (ldexp(samples->place[k][i], -unit) - position[k]) / view->size;
        for (int k = 0; k < 2; k++) samples->aside[k][i] = algsurf_dot(place, view->axis[k]);
    }
}

void algsurf_i_make_fans(const algsurf_i_picture *picture, void *memory) {
    const algsurf_surface *surface = picture->scene->surface;
    const algsurf_i_view *shown = &picture->packets->frame.view;
    for (int l = 0; l < picture->light_count; l++) {
        const algsurf_light *light = &picture->lights[l];
        algsurf_i_fan *fan = &picture->packets->fans[l];
        double position[3], edge_u[3], edge_v[3];
        for (int k = 0; k < 3; k++) {
            position[k] = ldexp(light->position[k], -surface->unit);
            edge_u[k] = ldexp(light->edge_u[k], -surface->unit);
            edge_v[k] = ldexp(light->edge_v[k], -surface->unit);
            fan->frame.view.centre[k] = shown->centre[k];
        }
        fan->frame.view.size = shown->size;
        algsurf_i_fan_expand(surface, position, edge_u, edge_v, error_of_places(position, edge_u, edge_v),
                             fan, memory);
        if (fan->usable) place_aside(&picture->light_samples, l, surface->unit, position, &fan->frame.view);
    }
}

/* A group of points on their way to the lights. */
typedef struct group {
    int first, count; /* of the line's points */
    algsurf_i_start start[ALGSURF_I_FANS];
} group;

static void begin_group(const algsurf_i_picture *picture, const algsurf_i_points *points, group *g) {
    for (int i = 0; i < g->count; i++) {
        int from = g->first + i;
        algsurf_i_start *start = &g->start[i];
        double position[3], normal[3], direction[3];
        for (int k = 0; k < 3; k++) {
            position[k] = points->position[k][from];
            normal[k] = points->normal[k][from];
            direction[k] = points->direction[k][from];
        }
        double height = lift(picture, points->t[from], position);
        (void)algsurf_i_facing(normal, direction, start->facing);
        for (int k = 0; k < 3; k++) start->at[k] = position[k] + height * start->facing[k];
    }
}

/* How much of a light is above the tangent plane of a point? */
typedef enum above { NOTHING, SOME, ALL } above;

/* Shading ignores a light whose middle is not above that of the point itself. */
static above how_much_above(const algsurf_light *light, const algsurf_i_points *points, int from,
                            const algsurf_i_start *start) {
    double height = 0, lifted = 0, along_u = 0, along_v = 0, size = 0;
    for (int k = 0; k < 3; k++) {
        double facing = start->facing[k], position = points->position[k][from];
        height += (light->position[k] - position) * facing;
        lifted += (light->position[k] - start->at[k]) * facing;
        along_u += light->edge_u[k] * facing;
        along_v += light->edge_v[k] * facing;
        size = fmax(size, fabs(light->position[k]) + fabs(position) + fabs(light->edge_u[k]) +
                              fabs(light->edge_v[k]));
    }
    if (!(height > 0)) return NOTHING;
    return lifted > 0.5 * (fabs(along_u) + fabs(along_v)) + 0x1p-44 * size ? ALL : SOME;
}

static algsurf_i_places places_of(const algsurf_i_samples *samples, int light) {
    int first = samples->first[light];
    return (algsurf_i_places){
        {samples->place[0] + first, samples->place[1] + first, samples->place[2] + first},
        samples->first[light + 1] - first};
}

static algsurf_i_fan_job fan_job(const algsurf_i_picture *picture, int light) {
    const algsurf_i_fan *fan = &picture->packets->fans[light];
    const algsurf_i_view *view = &fan->frame.view;
    int unit = picture->scene->surface->unit;
    algsurf_i_fan_job job = {.fan = fan, .unit = ldexp(1, -unit), .extent_kind = picture->scene->extent.kind};
    for (int i = 0; i < 3; i++) {
        job.light[i] = (ldexp(picture->lights[light].position[i], -unit) - view->centre[i]) / view->size;
        job.extent_size[i] = picture->packets->extent_size[i];
    }
    return job;
}

/* How much of a light each point of a group sees; `unknown` receives the fans of those where that is open. */
static void ask_fans(const algsurf_i_picture *picture, const algsurf_i_fan_job *job, const group *g,
                     uint8_t *how, algsurf_i_fan_point *unknown) {
    double at[3][ALGSURF_I_FANS];
    const double *const start[3] = {at[0], at[1], at[2]};
    for (int i = 0; i < g->count; i++)
        for (int k = 0; k < 3; k++) at[k][i] = g->start[i].at[k];
    algsurf_i_picture_kernel_for(picture->kernel)->see_light(job, start, g->count, how, unknown);
}

static int count_above(const algsurf_i_places *places, const algsurf_i_start *start) {
    int count = 0;
    for (int i = 0; i < places->count; i++) count += algsurf_i_height(places, i, start) > 0;
    return count;
}

enum { CHUNK = 64 };          /* places asked about at once */
enum { WIDEST = 8, FEW = 2 }; /* so few more than fill the widest packets are shot */

/* Adds the places of a light that a fan's point sees; what is in doubt is shot. */
static algsurf_status ask_places(algsurf_i_shadow_rays *rays, const algsurf_i_fan_job *job, int light,
                                 const algsurf_i_fan_point *point, const algsurf_i_start *start,
                                 double *seen) {
    const algsurf_i_samples *samples = &rays->picture->light_samples;
    const algsurf_i_places places = places_of(samples, light);
    for (int first = 0, count; first < places.count; first += count) {
        const double *aside[2];
        uint8_t state[CHUNK] = {0};
        count = places.count - first < CHUNK ? places.count - first : CHUNK;
        int asked = count % WIDEST > FEW ? count : count / WIDEST * WIDEST;
        for (int k = 0; k < 2; k++) aside[k] = samples->aside[k] + samples->first[light] + first;
        algsurf_i_picture_kernel_for(rays->picture->kernel)->see_places(job, point, aside, asked, state);
        for (int i = 0; i < count; i++) {
            algsurf_i_places one = {{0}, 1};
            for (int k = 0; k < 3; k++) one.at[k] = places.at[k] + first + i;
            if (i < asked && state[i] == ALGSURF_LANE_MISS) *seen += algsurf_i_height(&one, 0, start) > 0;
            if (i < asked && state[i] != ALGSURF_LANE_DOUBTFUL) continue;
            algsurf_status status = algsurf_i_shoot(rays, &one, start, seen);
            if (status < 0) return status;
        }
    }
    return ALGSURF_OK;
}

/* How many samples of a light reach each point of a group. */
static algsurf_status see_light(algsurf_i_shadow_rays *rays, const algsurf_i_line *line, int light,
                                const group *g) {
    const algsurf_i_picture *picture = rays->picture;
    const algsurf_i_places places = places_of(&picture->light_samples, light);
    uint8_t how[ALGSURF_I_FANS];
    algsurf_i_fan_point unknown[ALGSURF_I_FANS], *next = unknown;
    algsurf_i_fan_job job = {.fan = NULL};
    if (picture->packets && picture->packets->fans && picture->packets->fans[light].usable) {
        for (int i = 0; i < ALGSURF_I_FANS; i++)
            unknown[i].r = line->solids + i * ALGSURF_I_FAN_SOLID(picture->scene->surface->degree);
        job = fan_job(picture, light);
        ask_fans(picture, &job, g, how, unknown);
    } else {
        memset(how, ALGSURF_I_ASIDE, sizeof how);
    }
    for (int i = 0; i < g->count; i++) {
        int from = g->first + i;
        double *seen = line->visible + from * picture->light_count + light;
        const algsurf_i_start *start = &g->start[i];
        const algsurf_i_fan_point *point = how[i] == ALGSURF_I_UNKNOWN ? next++ : NULL;
        above lit_from = how_much_above(&picture->lights[light], &line->points, from, start);
        algsurf_status status = ALGSURF_OK;
        *seen = 0;
        if (lit_from == NOTHING || how[i] == ALGSURF_I_DARK) continue;
        if (how[i] == ALGSURF_I_LIT)
            *seen = lit_from == ALL ? places.count : count_above(&places, start);
        else if (point)
            status = ask_places(rays, &job, light, point, start, seen);
        else
            status = algsurf_i_shoot(rays, &places, start, seen);
        if (status < 0) return status;
    }
    return ALGSURF_OK;
}

algsurf_status algsurf_i_render_shadows(const algsurf_i_picture *picture, algsurf_i_line *line,
                                        algsurf_i_tally *tally) {
    int lights = picture->light_count;
    algsurf_i_shadow_rays rays;
    algsurf_i_begin_shadow_rays(&rays, picture);
    for (group g = {.first = 0}; g.first < line->count; g.first += ALGSURF_I_FANS) {
        g.count = line->count - g.first < ALGSURF_I_FANS ? line->count - g.first : ALGSURF_I_FANS;
        begin_group(picture, &line->points, &g);
        for (int l = 0; l < lights; l++) {
            if (atomic_load_explicit(&picture->stop, memory_order_relaxed)) return ALGSURF_CANCELLED;
            algsurf_status status = see_light(&rays, line, l, &g);
            if (status < 0) return status;
        }
    }
    algsurf_status status = algsurf_i_send_shadow_rays(&rays);
    if (status < 0) return status;
    for (int i = 0; i < line->count * lights; i++) {
        const algsurf_light *light = &picture->lights[i % lights];
        line->visible[i] /= light->samples_u * light->samples_v;
    }
    tally->shadow_rays += rays.rays;
    tally->without_memory += rays.without_memory;
    return ALGSURF_OK;
}
