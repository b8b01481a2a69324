/* shadow.c - which share of each light reaches a point of the surface, and which of the light from all
 * around.
 *
 * Shadow rays go to samples of each light (Cook, Porter, Carpenter 1984): of a regular grid, or, 32 for a
 * pixel, to others in each sample of each pixel, as lattice.h tells.  In the same way 16 rays for a pixel go
 * out around the normal, half a radius far: their ends lie evenly on a ball that touches the surface, and so
 * their directions are as dense as Lambert's cosine (Zhukov, Iones, Kronin 1998: ambient obscurance).  A ray
 * starts a little above the tangent plane, on the viewer's side, so that the point does not shadow itself.
 *
 * Up to degree 7 the rays from a point to a light are first asked about all at once, as a fan: most points
 * see the whole light or nothing of it.  Other rays are found side by side from P's Taylor expansion about
 * the points, up to degree 10.  Only what is undecided then is shot as a ray.  The answers are those of the
 * rays. */
#include "../base/arithmetic.h"
#include "shadow.h"

#include "lattice.h"
#include "shade_impl.h"
#include "shadow_rays.h"

#include "../base/vec.h"

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
            double place[2];
            algsurf_i_light_place(light, i % light->samples_u, i / light->samples_u, place);
            for (int k = 0; k < 2; k++) samples->place[k][samples->first[l] + i] = place[k];
        }
    }
}

/* Three roundings each, relative to what is added up. */
static double error_of_places(const double position[3], const double edge_u[3], const double edge_v[3]) {
    return 0x1p-50 * (algsurf_max_abs(position) + algsurf_max_abs(edge_u) + algsurf_max_abs(edge_v));
}

static void set_shown(const algsurf_i_picture *picture, algsurf_i_view *view) {
    const algsurf_i_view *shown = &picture->packets->frame.view;
    for (int k = 0; k < 3; k++) view->centre[k] = shown->centre[k];
    view->size = shown->size;
}

void algsurf_i_make_shadows(const algsurf_i_picture *picture, void *memory) {
    const algsurf_surface *surface = picture->scene->surface;
    const algsurf_i_packets *packets = picture->packets;
    if (packets->taylor) {
        set_shown(picture, &packets->taylor->frame.view);
        algsurf_i_taylor_expand(surface, packets->taylor, memory);
    }
    for (int l = 0; packets->fans && l < picture->light_count; l++) {
        const algsurf_light *light = &picture->lights[l];
        double position[3], edge_u[3], edge_v[3];
        for (int k = 0; k < 3; k++) {
            position[k] = ldexp(light->position[k], -surface->unit);
            edge_u[k] = ldexp(light->edge_u[k], -surface->unit);
            edge_v[k] = ldexp(light->edge_v[k], -surface->unit);
        }
        set_shown(picture, &packets->fans[l].frame.view);
        algsurf_i_fan_expand(surface, position, edge_u, edge_v, error_of_places(position, edge_u, edge_v),
                             &packets->fans[l], memory);
    }
}

enum { LIGHT_RAYS = ALGSURF_I_RAYS_OF_ONE, AMBIENT_RAYS = 16 }; /* for a pixel */
#define AMBIENT_REACH 0.5                                       /* of the radius of what is shown */

/* Of so many for a pixel, those of each of its n x n samples. */
static int each_of(int all, int across) { return (all + across * across - 1) / (across * across); }

/* Rays of a sample to a light, or, for light_count, around. */
static int count_rays(const algsurf_i_picture *picture, const algsurf_i_line *line, int light) {
    const algsurf_light *l = &picture->lights[light];
    if (light == picture->light_count) return each_of(AMBIENT_RAYS, line->across);
    return l->samples_u == 0 ? each_of(LIGHT_RAYS, line->across) : l->samples_u * l->samples_v;
}

enum { LEAST_FOR_FAN = 12 }; /* rays: fewer cost less than a fan */

/* The light's fan, if that pays. */
static const algsurf_i_fan *fan_of(const algsurf_i_picture *picture, int light, int rays) {
    const algsurf_i_fan *fans = picture->packets ? picture->packets->fans : NULL;
    return fans && fans[light].usable && rays >= LEAST_FOR_FAN ? fans + light : NULL;
}

static algsurf_i_shadow_job job_of(const algsurf_i_picture *picture, const algsurf_i_line *line, int light) {
    const algsurf_i_packets *packets = picture->packets;
    const int rays = count_rays(picture, line, light), around = light == picture->light_count,
              unit = picture->scene->surface->unit;
    algsurf_i_shadow_job job = {.ball = AMBIENT_REACH * picture->lighting.radius,
                                .lattice = ALGSURF_I_LATTICE_STEP * line->across * line->across * rays,
                                .extent_kind = picture->scene->extent.kind};
    if (!around) {
        const algsurf_i_samples *samples = &picture->light_samples;
        job.light = &picture->lights[light];
        job.fan = fan_of(picture, light, rays);
        for (int k = 0; k < 2 && job.light->samples_u > 0; k++)
            job.place[k] = samples->place[k] + samples->first[light];
    }
    if (!packets) return job;
    job.taylor = packets->taylor && packets->taylor->usable ? packets->taylor : NULL;
    job.unit = ldexp(1, -unit);
    job.planes = packets->planes;
    job.plane_count = packets->plane_count;
    const algsurf_i_view *view = &packets->frame.view;
    for (int i = 0; i < 3; i++) {
        if (!around) job.to_light[i] = (ldexp(job.light->position[i], -unit) - view->centre[i]) / view->size;
        job.extent_size[i] = packets->extent_size[i];
    }
    return job;
}

/* Where the lattices of the line's points from `first` on begin, for the rays to a light or around. */
static void set_lattices(const algsurf_i_picture *picture, const algsurf_i_line *line, int row, int light,
                         int first, algsurf_i_starts *starts) {
    const int across = line->across, rays = count_rays(picture, line, light),
              purpose = light < picture->light_count ? ALGSURF_I_FOR_LIGHT + light : ALGSURF_I_FOR_AMBIENT;
    for (int i = 0; i < starts->count; i++) {
        const int x = line->pixel[first + i], number = line->sample + x % line->dense;
        const algsurf_i_sample sample = {x / line->dense, row, number, across * across};
        const algsurf_i_lattice lattice = algsurf_i_lattice_of(&sample, purpose, rays);
        starts->number[i] = lattice.number;
        starts->across[i] = lattice.across;
        starts->up[i] = lattice.up;
    }
}

/* How many rays to a light, or around, arrive from each of the line's points from `first` on. */
static algsurf_status see_one(algsurf_i_shadow_rays *rays, const algsurf_i_line *line, int row, int light,
                              int first) {
    const algsurf_i_picture *picture = rays->picture;
    const algsurf_i_shadow_kernel *code = algsurf_i_shadow_kernel_for(picture->kernel);
    const algsurf_i_shadow_job *job = &rays->jobs[light];
    algsurf_i_starts *starts = &rays->starts;
    const int count = count_rays(picture, line, light);
    uint8_t how[ALGSURF_I_STARTS] = {0};
    if (job->light) code->see_light(job, starts, how);
    for (int i = 0; i < starts->count; i++) {
        starts->seen[i] = line->visible + (first + i) * (picture->light_count + 1) + light;
        *starts->seen[i] = how[i] == ALGSURF_I_LIT ? count : 0;
    }
    if (!job->place[0]) set_lattices(picture, line, row, light, first, starts);
    for (int from = 0; from < count; from += ALGSURF_I_RAYS_OF_ONE) {
        int more = count - from < ALGSURF_I_RAYS_OF_ONE ? count - from : ALGSURF_I_RAYS_OF_ONE;
        code->see_rays(job, starts, job->taylor ? &rays->solids : NULL, how, from, more, &rays->undecided);
        algsurf_status status = algsurf_i_collect_undecided(rays);
        if (status < 0) return status;
    }
    return ALGSURF_OK;
}

/* From counts to shares. */
static void make_shares(const algsurf_i_picture *picture, const algsurf_i_line *line) {
    int lights = picture->light_count;
    for (int l = 0; l <= lights; l++) {
        int all = count_rays(picture, line, l);
        for (int i = 0; i < line->count; i++) line->visible[i * (lights + 1) + l] /= all;
    }
}

algsurf_status algsurf_i_render_shadows(const algsurf_i_picture *picture, int row, algsurf_i_line *line,
                                        algsurf_i_tally *tally) {
    const algsurf_i_shadow_kernel *code = algsurf_i_shadow_kernel_for(picture->kernel);
    const double height = 1e-6 * picture->lighting.radius;
    algsurf_i_shadow_rays *rays = line->rays;
    algsurf_i_begin_shadow_rays(rays, picture);
    for (int l = 0; l <= picture->light_count; l++) rays->jobs[l] = job_of(picture, line, l);
    for (int first = 0; first < line->count; first += ALGSURF_I_STARTS) {
        int left = line->count - first, count = left < ALGSURF_I_STARTS ? left : ALGSURF_I_STARTS;
        if (atomic_load_explicit(&picture->stop, memory_order_relaxed)) return ALGSURF_CANCELLED;
        code->lift(&line->points, first, count, height, &rays->starts);
        if (rays->jobs[0].taylor) code->expand(&rays->jobs[0], &rays->starts, &rays->solids);
        for (int l = 0; l <= picture->light_count; l++) {
            algsurf_status status = see_one(rays, line, row, l, first);
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
