/* shadow.c - which share of each light reaches a point of the surface, and which of the light from all
 * around.
 *
 * Shadow rays go to samples of each light (Cook, Porter, Carpenter 1984): of a regular grid, or, 32 for a
 * pixel, to others in each sample of each pixel, as lattice.c tells.  In the same way 16 rays for a pixel go
 * out around the normal, half a radius far: their ends lie evenly on a ball that touches the surface, and so
 * their directions are as dense as Lambert's cosine (Zhukov, Iones, Kronin 1998: ambient obscurance).  A ray
 * starts a little above the tangent plane, on the viewer's side, so that the point does not shadow itself.
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
    return 1e-6 * picture->lighting.radius + 0x1p-48 * (fabs(t) + algsurf_max_abs(position));
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

/* Where places of a light are from its middle, in the fan's axes and unit. */
static void place_aside(const algsurf_i_places *places, int unit, const double position[3],
                        const algsurf_i_view *view, double *const aside[2]) {
    for (int i = 0; i < places->count; i++) {
        double place[3];
        for (int k = 0; k < 3; k++)
            place[k] = (ldexp(places->at[k][i], -unit) - ldexp(position[k], -unit)) / view->size;
        for (int k = 0; k < 2; k++) aside[k][i] = algsurf_dot(place, view->axis[k]);
    }
}

static algsurf_i_places places_of(const algsurf_i_samples *samples, int light) {
    int first = samples->first[light];
    return (algsurf_i_places){
        {samples->place[0] + first, samples->place[1] + first, samples->place[2] + first},
        samples->first[light + 1] - first};
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
        if (!fan->usable) continue;
        const algsurf_i_samples *samples = &picture->light_samples;
        const algsurf_i_places places = places_of(samples, l);
        double *const aside[2] = {samples->aside[0] + samples->first[l],
                                  samples->aside[1] + samples->first[l]};
        place_aside(&places, surface->unit, light->position, &fan->frame.view, aside);
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
        algsurf_i_facing(normal, direction, start->facing);
        for (int k = 0; k < 3; k++) start->at[k] = position[k] + height * start->facing[k];
    }
}

enum { LIGHT_RAYS = 32, AMBIENT_RAYS = 16 }; /* for a pixel */

/* Of so many for a pixel, those of each of its n x n samples. */
static int each_of(int all, int across) { return (all + across * across - 1) / (across * across); }

/* The places of a light that one sample looks at, in their own memory if they are not those of all. */
typedef struct spots {
    double at[3][LIGHT_RAYS], from_middle[2][LIGHT_RAYS];
    algsurf_i_places places;
    const double *aside[2];
} spots;

static void spread_spots(const algsurf_i_picture *picture, int light, const algsurf_i_sample *sample,
                         int each, spots *s) {
    const algsurf_light *l = &picture->lights[light];
    double p[LIGHT_RAYS], q[LIGHT_RAYS];
    algsurf_i_lattice(sample, ALGSURF_I_FOR_LIGHT + light, each, p, q);
    for (int k = 0; k < 3; k++) {
        for (int i = 0; i < each; i++)
            s->at[k][i] = l->position[k] + (p[i] - 0.5) * l->edge_u[k] + (q[i] - 0.5) * l->edge_v[k];
        s->places.at[k] = s->at[k];
    }
    s->places.count = each;
}

static int is_spread(const algsurf_light *light) { return light->samples_u == 0; }

/* Places of a light that a sample looks at. */
static int count_places(const algsurf_i_picture *picture, const algsurf_i_line *line, int light) {
    const algsurf_light *l = &picture->lights[light];
    return is_spread(l) ? each_of(LIGHT_RAYS, line->across) : l->samples_u * l->samples_v;
}

/* Of a light that the sample of a pixel looks at. */
static void find_spots(const algsurf_i_picture *picture, const algsurf_i_line *line, int light,
                       const algsurf_i_sample *sample, spots *s) {
    const algsurf_i_samples *samples = &picture->light_samples;
    if (is_spread(&picture->lights[light])) {
        spread_spots(picture, light, sample, count_places(picture, line, light), s);
        return;
    }
    s->places = places_of(samples, light);
    for (int k = 0; k < 2; k++) s->aside[k] = samples->aside[k] + samples->first[light];
}

/* How much of a light is above the tangent plane of a point? */
typedef enum above { NOTHING, SOME, ALL } above;

#define DIMMEST -0.25 /* cosine at a light's middle: of what is below it, nothing arrives */

static above how_much_above(const algsurf_light *light, const algsurf_i_start *start) {
    double height = 0, square = 0, along_u = 0, along_v = 0, size = 0;
    for (int k = 0; k < 3; k++) {
        double facing = start->facing[k], way = light->position[k] - start->at[k];
        height += way * facing;
        square += way * way;
        along_u += light->edge_u[k] * facing;
        along_v += light->edge_v[k] * facing;
        size = fmax(size, fabs(light->position[k]) + fabs(start->at[k]) + fabs(light->edge_u[k]) +
                              fabs(light->edge_v[k]));
    }
    double half = 0.5 * (fabs(along_u) + fabs(along_v)), slack = 0x1p-44 * size;
    if (height < DIMMEST * 1.001 * sqrt(square) || height < -half - slack) return NOTHING;
    return height > half + slack ? ALL : SOME;
}

static algsurf_i_fan_job fan_job(const algsurf_i_picture *picture, int light) {
    const algsurf_i_fan *fan = &picture->packets->fans[light];
    const algsurf_i_view *view = &fan->frame.view;
    int unit = picture->scene->surface->unit;
    algsurf_i_fan_job job = {.fan = fan,
                             .unit = ldexp(1, -unit),
                             .extent_kind = picture->scene->extent.kind,
                             .planes = picture->packets->planes,
                             .plane_count = picture->packets->plane_count};
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

static int count_below(const algsurf_i_places *places, const algsurf_i_start *start) {
    int count = 0;
    for (int i = 0; i < places->count; i++) count += !(algsurf_i_height(places, i, start) > 0);
    return count;
}

enum { CHUNK = 64 };          /* places asked about at once */
enum { WIDEST = 8, FEW = 2 }; /* so few more than fill the widest packets are shot */

/* Adds the places of a light that a fan's point sees; what is in doubt is shot. */
static algsurf_status ask_places(algsurf_i_shadow_rays *rays, const algsurf_i_fan_job *job, const spots *s,
                                 const algsurf_i_fan_point *point, const algsurf_i_start *start,
                                 double *seen) {
    const algsurf_i_places *places = &s->places;
    for (int first = 0, count; first < places->count; first += count) {
        const double *const aside[2] = {s->aside[0] + first, s->aside[1] + first};
        uint8_t state[CHUNK] = {0};
        count = places->count - first < CHUNK ? places->count - first : CHUNK;
        int asked = count % WIDEST > FEW ? count : count / WIDEST * WIDEST;
        algsurf_i_picture_kernel_for(rays->picture->kernel)->see_places(job, point, aside, asked, state);
        for (int i = 0; i < count; i++) {
            algsurf_i_places one = {{0}, 1};
            for (int k = 0; k < 3; k++) one.at[k] = places->at[k] + first + i;
            if (i < asked && state[i] == ALGSURF_LANE_MISS) *seen += 1;
            if (i < asked && state[i] == ALGSURF_LANE_HIT) *seen += !(algsurf_i_height(&one, 0, start) > 0);
            if (i < asked && state[i] != ALGSURF_LANE_DOUBTFUL) continue;
            algsurf_status status = algsurf_i_shoot(rays, &one, start, seen);
            if (status < 0) return status;
        }
    }
    return ALGSURF_OK;
}

enum { LEAST_FOR_FAN = 12 }; /* places: fewer rays cost less than a fan */

/* The light's fan, if that pays. */
static int has_fan(const algsurf_i_picture *picture, const algsurf_i_line *line, int light) {
    return picture->packets && picture->packets->fans && picture->packets->fans[light].usable &&
           count_places(picture, line, light) >= LEAST_FOR_FAN;
}

/* The sample of a line's point. */
static algsurf_i_sample sample_of(const algsurf_i_line *line, int row, int point) {
    int x = line->pixel[point], number = line->sample + x % line->dense;
    return (algsurf_i_sample){x / line->dense, row, number, line->across * line->across};
}

/* Adds the places of a light that reach a point, of which some may be hidden; `how` as its fan tells. */
static algsurf_status see_places(algsurf_i_shadow_rays *rays, const algsurf_i_line *line, int light,
                                 const algsurf_i_sample *sample, const algsurf_i_fan_job *job, uint8_t how,
                                 const algsurf_i_fan_point *point, const algsurf_i_start *start,
                                 double *seen) {
    const algsurf_i_picture *picture = rays->picture;
    spots s;
    find_spots(picture, line, light, sample, &s);
    if (how == ALGSURF_I_DARK) *seen += count_below(&s.places, start);
    if (how == ALGSURF_I_DARK) return ALGSURF_OK;
    if (!point) return algsurf_i_shoot(rays, &s.places, start, seen);
    if (is_spread(&picture->lights[light])) {
        double *const aside[2] = {s.from_middle[0], s.from_middle[1]};
        place_aside(&s.places, picture->scene->surface->unit, picture->lights[light].position,
                    &job->fan->frame.view, aside);
        for (int k = 0; k < 2; k++) s.aside[k] = aside[k];
    }
    return ask_places(rays, job, &s, point, start, seen);
}

/* How many places of a light reach each point of a group. */
static algsurf_status see_light(algsurf_i_shadow_rays *rays, const algsurf_i_line *line, int row, int light,
                                const group *g) {
    const algsurf_i_picture *picture = rays->picture;
    const int places = count_places(picture, line, light);
    uint8_t how[ALGSURF_I_FANS];
    algsurf_i_fan_point unknown[ALGSURF_I_FANS], *next = unknown;
    algsurf_i_fan_job job = {.fan = NULL};
    algsurf_status status = ALGSURF_OK;
    if (has_fan(picture, line, light)) {
        for (int i = 0; i < ALGSURF_I_FANS; i++)
            unknown[i].r = line->solids + i * ALGSURF_I_FAN_SOLID(picture->scene->surface->degree);
        job = fan_job(picture, light);
        ask_fans(picture, &job, g, how, unknown);
    } else {
        memset(how, ALGSURF_I_ASIDE, sizeof how);
    }
    for (int i = 0; i < g->count && status >= 0; i++) {
        const int from = g->first + i;
        const algsurf_i_sample sample = sample_of(line, row, from);
        const algsurf_i_start *start = &g->start[i];
        const algsurf_i_fan_point *point = how[i] == ALGSURF_I_UNKNOWN ? next++ : NULL;
        double *seen = line->visible + from * (picture->light_count + 1) + light;
        above lit_from = how_much_above(&picture->lights[light], start);
        *seen = lit_from == NOTHING || how[i] == ALGSURF_I_LIT ? places : 0;
        if (*seen > 0 || (how[i] == ALGSURF_I_DARK && lit_from == ALL)) continue;
        status = see_places(rays, line, light, &sample, &job, how[i], point, start, seen);
    }
    return status < 0 ? status : ALGSURF_OK;
}

/* A point of the unit circle at a share of its way round from -45 degrees, within 2e-5: with t about the
 * tangent of half the angle from the middle of its quarter, which is at 0, 90, 180 or 270 degrees. */
static void point_of_circle(double share, double point[2]) {
    int quarter = (int)(4 * share);
    double f = 2 * (4 * share - quarter) - 1, square = f * f;
    double t = f * (0.3926991 + square * (0.0201862 + 0.0013285 * square)), d = 1 / (1 + t * t);
    double across = (1 - t * t) * d, up = 2 * t * d;
    point[0] = quarter == 0 ? across : quarter == 1 ? -up : quarter == 2 ? -across : up;
    point[1] = quarter == 0 ? up : quarter == 1 ? across : quarter == 2 ? -up : -across;
}

#define AMBIENT_REACH 0.5 /* of the radius of what is shown */

/* How many of the directions around each point of a group are free. */
static algsurf_status see_around(algsurf_i_shadow_rays *rays, const algsurf_i_line *line, int row,
                                 const group *g) {
    const algsurf_i_picture *picture = rays->picture;
    const int lights = picture->light_count, each = each_of(AMBIENT_RAYS, line->across);
    for (int i = 0; i < g->count; i++) {
        const int from = g->first + i;
        const algsurf_i_sample sample = sample_of(line, row, from);
        const algsurf_i_start *start = &g->start[i];
        double p[AMBIENT_RAYS], q[AMBIENT_RAYS], at[3][AMBIENT_RAYS];
        double reach = AMBIENT_REACH * picture->lighting.radius;
        algsurf_i_lattice(&sample, ALGSURF_I_FOR_AMBIENT, each, p, q);
        for (int j = 0; j < each; j++) {
            double z = 1 - 2 * p[j], circle[2], wide = sqrt(1 - z * z);
            point_of_circle(q[j], circle);
            const double on_ball[3] = {wide * circle[0], wide * circle[1], z};
            for (int k = 0; k < 3; k++) at[k][j] = start->at[k] + reach * (start->facing[k] + on_ball[k]);
        }
        const algsurf_i_places ends = {{at[0], at[1], at[2]}, each};
        double *seen = line->visible + from * (lights + 1) + lights;
        *seen = 0;
        algsurf_status status = algsurf_i_shoot(rays, &ends, start, seen);
        if (status < 0) return status;
    }
    return ALGSURF_OK;
}

/* From counts to shares. */
static void make_shares(const algsurf_i_picture *picture, const algsurf_i_line *line) {
    int lights = picture->light_count;
    for (int l = 0; l <= lights; l++) {
        int all = l < lights ? count_places(picture, line, l) : each_of(AMBIENT_RAYS, line->across);
        for (int i = 0; i < line->count; i++) line->visible[i * (lights + 1) + l] /= all;
    }
}

algsurf_status algsurf_i_render_shadows(const algsurf_i_picture *picture, int row, algsurf_i_line *line,
                                        algsurf_i_tally *tally) {
    algsurf_i_shadow_rays *rays = line->rays;
    algsurf_i_begin_shadow_rays(rays, picture);
    for (group g = {.first = 0}; g.first < line->count; g.first += ALGSURF_I_FANS) {
        g.count = line->count - g.first < ALGSURF_I_FANS ? line->count - g.first : ALGSURF_I_FANS;
        begin_group(picture, &line->points, &g);
        for (int l = 0; l <= picture->light_count; l++) {
            if (atomic_load_explicit(&picture->stop, memory_order_relaxed)) return ALGSURF_CANCELLED;
            algsurf_status status = l < picture->light_count ? see_light(rays, line, row, l, &g)
                                                             : see_around(rays, line, row, &g);
            if (status < 0) return status;
        }
    }
    algsurf_status status = algsurf_i_send_shadow_rays(rays);
    if (status < 0) return status;
    make_shares(picture, line);
    tally->shadow_rays += rays->rays;
    tally->without_memory += rays->without_memory;
    return ALGSURF_OK;
}
