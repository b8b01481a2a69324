/* shadow.c - which share of each light reaches a point of the surface, and which of the light from all
 * around.
 *
 * Shadow rays go to samples of each light (Cook, Porter, Carpenter 1984): of a regular grid, or, 32 for a
 * pixel, to others in each sample of each pixel, as lattice.h tells.  In the same way 16 rays for a pixel go
 * out around the normal, half a radius far: their ends lie evenly on a ball that touches the surface, and so
 * their directions are as dense as Lambert's cosine (Zhukov, Iones, Kronin 1998: ambient obscurance).  A ray
 * starts a little above the tangent plane, on the viewer's side, so that the point does not shadow itself.
 *
 * Rays are found side by side from P's Taylor expansion about the points, up to degree 10.  Only what is
 * undecided then is shot as a ray, collected until rays fill a packet call.  The answers are those of the
 * rays. */
#include "../base/arithmetic.h"
#include "../beams/lattice.h"
#include "impl.h"

#include <math.h>

enum { SHADOW_RAYS = 96 }; /* enough to fill a call */

typedef struct algsurf_i_shadow_rays {
    algsurf_i_solids solids; /* about the points in the making: */
    algsurf_i_starts starts;
    algsurf_i_shadow_job jobs[ALGSURF_MAX_LIGHTS + 1]; /* of each light, and around */
    algsurf_i_undecided undecided;                     /* rays yet to be collected */
    double origin[3][SHADOW_RAYS], direction[3][SHADOW_RAYS], t_max[SHADOW_RAYS];
    double *seen[SHADOW_RAYS]; /* where each is added if it arrives */
    size_t count;
} algsurf_i_shadow_rays;

size_t algsurf_i_shadow_memory(void) { return sizeof(algsurf_i_shadow_rays); }

void algsurf_i_place_samples(algsurf_i_picture *picture) {
    for (size_t l = 0; l < picture->lighting.light_count; l++) {
        const algsurf_light *light = &picture->lights[l];
        for (int i = 0; i < light->samples_u * light->samples_v; i++) {
            double place[2];
            algsurf_i_light_place(light, i % light->samples_u, i / light->samples_u, place);
            for (int k = 0; k < 2; k++) picture->samples[l][k][i] = place[k];
        }
    }
}

void algsurf_i_make_shadows(const algsurf_i_picture *picture, void *memory) {
    algsurf_i_taylor *taylor = &picture->geometry->taylor;
    const algsurf_i_view *shown = &picture->geometry->frame.view;
    if (!taylor->frame.q) return; /* there is no room for it */
    for (int k = 0; k < 3; k++) taylor->frame.view.centre[k] = shown->centre[k];
    taylor->frame.view.size = shown->size;
    algsurf_i_taylor_expand(picture->scene->surface, taylor, memory);
}

enum { LIGHT_RAYS = ALGSURF_I_RAYS_OF_ONE, AMBIENT_RAYS = 16 }; /* for a pixel */
#define AMBIENT_REACH 0.5                                       /* of the radius of what is shown */

static int count_lights(const algsurf_i_picture *picture) { return (int)picture->lighting.light_count; }

/* Of so many for a pixel, those of each of its n x n samples. */
static int each_of(int all, int across) { return (all + across * across - 1) / (across * across); }

/* Rays of a sample to a light, or, for light_count, around. */
static int count_rays(const algsurf_i_picture *picture, const algsurf_i_line *line, int light) {
    const algsurf_light *l = &picture->lights[light];
    if (light == count_lights(picture)) return each_of(AMBIENT_RAYS, line->across);
    return l->samples_u == 0 ? each_of(LIGHT_RAYS, line->across) : l->samples_u * l->samples_v;
}

static algsurf_i_shadow_job job_of(const algsurf_i_picture *picture, const algsurf_i_line *line, int light) {
    const algsurf_i_geometry *geometry = picture->geometry;
    const int rays = count_rays(picture, line, light), around = light == count_lights(picture);
    algsurf_i_shadow_job job = {.ball = AMBIENT_REACH * picture->lighting.radius,
                                .lattice = ALGSURF_I_LATTICE_STEP * line->across * line->across * rays,
                                .extent_kind = picture->scene->extent.kind};
    if (!around) {
        const algsurf_light *l = &picture->lights[light];
        job.light[0] = l->position, job.light[1] = l->edge_u, job.light[2] = l->edge_v;
        for (int k = 0; k < 2 && l->samples_u > 0; k++) job.place[k] = picture->samples[light][k];
    }
    if (!geometry) return job;
    job.taylor = geometry->taylor.usable ? &geometry->taylor : NULL;
    job.unit = ldexp(1, -picture->scene->surface->unit);
    job.planes = geometry->planes;
    job.plane_count = geometry->rays.plane_count;
    for (int i = 0; i < 3; i++) job.extent_size[i] = geometry->rays.extent_size[i];
    return job;
}

/* Where the lattices of the line's points from `first` on begin, for the rays to a light or around. */
static void set_lattices(const algsurf_i_picture *picture, const algsurf_i_line *line, int row, int light,
                         int first, algsurf_i_starts *starts) {
    const int across = line->across, rays = count_rays(picture, line, light),
              purpose = light < count_lights(picture) ? ALGSURF_I_FOR_LIGHT + light : ALGSURF_I_FOR_AMBIENT;
    for (int i = 0; i < starts->count; i++) {
        const int x = line->pixel[first + i], number = line->sample + x % line->dense;
        const algsurf_i_sample sample = {x / line->dense, row, number, across * across};
        const algsurf_i_lattice lattice = algsurf_i_lattice_of(&sample, purpose, rays);
        starts->number[i] = lattice.number;
        starts->across[i] = lattice.across;
        starts->up[i] = lattice.up;
    }
}

/* Sends the rays that have been collected: those that arrive are added to the points' *seen. */
static algsurf_status send_rays(algsurf_i_worker *worker) {
    const algsurf_scene *scene = worker->picture->scene;
    algsurf_i_shadow_rays *b = worker->line.rays;
    unsigned char state[SHADOW_RAYS];
    const algsurf_ray_packet rays = {.size = sizeof rays,
                                     .count = b->count,
                                     .origin = {b->origin[0], b->origin[1], b->origin[2]},
                                     .direction = {b->direction[0], b->direction[1], b->direction[2]},
                                     .t_max = b->t_max};
    algsurf_status status =
        algsurf_occluded_packet(scene->surface, &scene->extent, &rays, &scene->intersect, state);
    if (status < 0 && status != ALGSURF_E_NO_MEMORY) return status;
    worker->tally->without_memory += status < 0;
    worker->tally->stats.shadow_rays += b->count;
    for (size_t i = 0; i < b->count; i++) *b->seen[i] += state[i] == ALGSURF_STATE_MISS;
    b->count = 0;
    return ALGSURF_OK;
}

static algsurf_status collect_undecided(algsurf_i_worker *worker) {
    algsurf_i_shadow_rays *b = worker->line.rays;
    const algsurf_i_starts *starts = &b->starts;
    for (int i = 0; i < b->undecided.count; i++) {
        int from = b->undecided.start[i];
        for (int k = 0; k < 3; k++) {
            b->origin[k][b->count] = starts->at[k][from];
            b->direction[k][b->count] = b->undecided.direction[k][i];
        }
        b->seen[b->count++] = starts->seen[from];
        if (b->count < SHADOW_RAYS) continue;
        algsurf_status status = send_rays(worker);
        if (status < 0) return status;
    }
    b->undecided.count = 0;
    return ALGSURF_OK;
}

/* How many rays to a light, or around, arrive from each of the line's points from `first` on. */
static algsurf_status see_one(algsurf_i_worker *worker, int row, int light, int first) {
    const algsurf_i_picture *picture = worker->picture;
    const algsurf_i_line *line = &worker->line;
    algsurf_i_shadow_rays *rays = line->rays;
    const algsurf_i_shadow_job *job = &rays->jobs[light];
    algsurf_i_starts *starts = &rays->starts;
    const int count = count_rays(picture, line, light);
    for (int i = 0; i < starts->count; i++) {
        starts->seen[i] = line->visible + (first + i) * (count_lights(picture) + 1) + light;
        *starts->seen[i] = 0;
    }
    if (!job->place[0]) set_lattices(picture, line, row, light, first, starts);
    for (int from = 0; from < count; from += ALGSURF_I_RAYS_OF_ONE) {
        int more = count - from < ALGSURF_I_RAYS_OF_ONE ? count - from : ALGSURF_I_RAYS_OF_ONE;
        picture->code->see_rays(job, starts, job->taylor ? &rays->solids : NULL, from, more,
                                &rays->undecided);
        algsurf_status status = collect_undecided(worker);
        if (status < 0) return status;
    }
    return ALGSURF_OK;
}

/* From counts to shares. */
static void make_shares(const algsurf_i_picture *picture, const algsurf_i_line *line) {
    const int lights = count_lights(picture);
    for (int l = 0; l <= lights; l++) {
        int all = count_rays(picture, line, l);
        for (int i = 0; i < line->count; i++) line->visible[i * (lights + 1) + l] /= all;
    }
}

algsurf_status algsurf_i_render_shadows(algsurf_i_worker *worker, int row) {
    const algsurf_i_picture *picture = worker->picture;
    const algsurf_i_line *line = &worker->line;
    const double height = 1e-6 * picture->lighting.radius;
    algsurf_i_shadow_rays *rays = line->rays;
    rays->count = 0;
    rays->undecided.count = 0;
    for (int i = 0; i < SHADOW_RAYS; i++) rays->t_max[i] = 1;
    for (int l = 0; l <= count_lights(picture); l++) rays->jobs[l] = job_of(picture, line, l);
    for (int first = 0; first < line->count; first += ALGSURF_I_STARTS) {
        int left = line->count - first, count = left < ALGSURF_I_STARTS ? left : ALGSURF_I_STARTS;
        if (algsurf_i_stopped(picture)) return ALGSURF_CANCELLED;
        picture->code->lift(&line->points, first, count, height, &rays->starts);
        if (rays->jobs[0].taylor) picture->code->expand(&rays->jobs[0], &rays->starts, &rays->solids);
        for (int l = 0; l <= count_lights(picture); l++) {
            algsurf_status status = see_one(worker, row, l, first);
            if (status < 0) return status;
        }
    }
    algsurf_status status = send_rays(worker);
    if (status < 0) return status;
    make_shares(picture, line);
    return ALGSURF_OK;
}
