/* packet.c - first hits and occlusion of many rays: checked, solved by the packet code, and what that leaves
 * undecided one by one.
 *
 * The packet code (packet_template.h) reads the caller's arrays and writes the answers it is sure of; of the
 * others it writes ALGSURF_LANE_UNDECIDED as state.  Those rays go on to intersect.c, and so do all rays of
 * calls that the packet code is not made for.  No answer depends on what else is in a packet, so a ray has
 * the same bits alone as in company. */
#include "../base/arithmetic.h"
#include <math.h>

#include "../base/fpenv.h"
#include "intersect_impl.h"
#include "../base/options.h"
#include "../surface/impl.h"

const char *algsurf_kernel_name(int index) {
    const algsurf_i_kernel *kernel = algsurf_i_kernel_at(index);
    return kernel ? kernel->name : NULL;
}

static algsurf_ray ray_of(const algsurf_ray_packet *rays, size_t i) {
    algsurf_ray ray;
    for (int k = 0; k < 3; k++) {
        ray.origin[k] = rays->origin[k][i];
        ray.direction[k] = rays->direction[k][i];
    }
    ray.t_min = rays->t_min ? rays->t_min[i] : 0;
    ray.t_max = rays->t_max ? rays->t_max[i] : INFINITY;
    return ray;
}

/* Are all rays certainly good ones?  Without branches. */
static int all_good(const algsurf_ray_packet *rays) {
    int good = 1;
    for (size_t i = 0; i < rays->count; i++) {
        double size = 0, zero = 0;
        for (int k = 0; k < 3; k++) {
            zero += 0 * rays->origin[k][i] + 0 * rays->direction[k][i]; /* NaN unless both are finite */
            size += fabs(rays->direction[k][i]);
        }
        good &= (zero == 0) & (size > 0);
        if (rays->t_min) good &= rays->t_min[i] == rays->t_min[i];
        if (rays->t_max) good &= rays->t_max[i] == rays->t_max[i];
    }
    return good;
}

static algsurf_status check_rays(const algsurf_ray_packet *rays) {
    if (rays->count == 0) return ALGSURF_OK;
    for (int k = 0; k < 3; k++)
        if (!rays->origin[k] || !rays->direction[k]) return ALGSURF_E_ARGUMENT;
    if (!rays->active && all_good(rays)) return ALGSURF_OK;
    for (size_t i = 0; i < rays->count; i++) {
        if (rays->active && !rays->active[i]) continue;
        algsurf_ray ray = ray_of(rays, i);
        algsurf_status status = algsurf_i_ray_check(&ray);
        if (status != ALGSURF_OK) return status;
    }
    return ALGSURF_OK;
}

/* Reads and checks a caller's arguments. */
static algsurf_status prepare(algsurf_i_query *q, algsurf_ray_packet *rays, const algsurf_surface *surface,
                              const algsurf_extent *extent, const algsurf_ray_packet *given,
                              const algsurf_intersect_options *options) {
    if (!surface || !given || !algsurf_options_read(rays, sizeof *rays, given)) return ALGSURF_E_ARGUMENT;
    algsurf_status status = check_rays(rays);
    if (status == ALGSURF_OK) status = algsurf_i_query_read(q, surface, extent, options);
    return status == ALGSURF_OK && q->options.observer ? ALGSURF_E_ARGUMENT : status;
}

static const algsurf_i_rays_kernel *packet_code(const algsurf_i_query *q) {
    int narrow = q->kernel->index == ALGSURF_AVX512 && q->surface->degree > ALGSURF_MAX_WIDE_DEGREE;
    return algsurf_i_rays_kernel_for(narrow ? algsurf_i_kernel_at(1) : q->kernel);
}

/* The states of active rays; of certain hits everything. */
static void solve_together(const algsurf_i_query *q, const algsurf_ray_packet *rays, int any,
                           const algsurf_hit_packet *hits) {
    if (!q->fits_lanes || q->has_method) {
        for (size_t i = 0; i < rays->count; i++)
            if (!rays->active || rays->active[i]) hits->state[i] = ALGSURF_LANE_UNDECIDED;
        return;
    }
    algsurf_i_rays_job job = q->job;
    job.rays = rays;
    job.any = any;
    packet_code(q)->solve(&job, hits);
}

static int left_alone(const algsurf_ray_packet *rays, const unsigned char *state, size_t i) {
    return (!rays->active || rays->active[i]) && state[i] == ALGSURF_LANE_UNDECIDED;
}

static void store_hit(const algsurf_hit_packet *hits, size_t i, const algsurf_hit *hit) {
    hits->state[i] = (unsigned char)hit->state;
    if (hits->multiplicity) hits->multiplicity[i] = hit->multiplicity;
    if (hits->side) hits->side[i] = (signed char)hit->side;
    if (hits->t) hits->t[i] = hit->t;
    if (hits->t_lo) hits->t_lo[i] = hit->t_lo;
    if (hits->t_hi) hits->t_hi[i] = hit->t_hi;
    for (int k = 0; k < 3; k++) {
        if (hits->position[k]) hits->position[k][i] = hit->position[k];
        if (hits->normal[k]) hits->normal[k][i] = hit->normal[k];
    }
}

/* A ray that could not be decided for want of memory. */
static void set_no_memory(const algsurf_ray *ray, algsurf_hit *hit) {
    *hit = (algsurf_hit){.state = ALGSURF_UNDECIDED, .reason = ALGSURF_UNDECIDED_RANGE};
    hit->t = hit->t_lo = ray->t_min;
    hit->t_hi = ray->t_max;
}

/* The normal that packets leave open. */
static void set_normal(const algsurf_i_query *q, const algsurf_ray_packet *rays,
                       const algsurf_hit_packet *hits, size_t i) {
    int open = 0;
    for (int k = 0; k < 3; k++) open |= hits->normal[k] && isnan(hits->normal[k][i]);
    if (!open || hits->state[i] != ALGSURF_HIT || (rays->active && !rays->active[i])) return;
    algsurf_ray ray = ray_of(rays, i);
    algsurf_hit hit;
    uint64_t exact = 0;
    (void)algsurf_i_first_hit(q, &ray, 0, &hit, &exact);
    for (int k = 0; k < 3; k++)
        if (hits->normal[k]) hits->normal[k][i] = hit.normal[k];
}

/* The rays, and the normals, that packets leave undecided, one by one. */
static ALGSURF_NOINLINE algsurf_status finish(const algsurf_i_query *q, const algsurf_ray_packet *rays,
                                              const algsurf_hit_packet *hits, uint64_t *exact) {
    algsurf_status status = ALGSURF_OK;
    for (size_t i = 0; i < rays->count; i++) {
        if (!left_alone(rays, hits->state, i)) {
            set_normal(q, rays, hits, i);
            continue;
        }
        algsurf_ray ray = ray_of(rays, i);
        algsurf_hit hit;
        algsurf_status one = algsurf_i_first_hit(q, &ray, !q->has_method, &hit, exact);
        if (one != ALGSURF_OK) {
            set_no_memory(&ray, &hit);
            status = one;
        }
        store_hit(hits, i, &hit);
    }
    return status;
}

ALGSURF_NOINLINE algsurf_status algsurf_i_intersect_packet(const algsurf_surface *surface,
                                                           const algsurf_extent *extent,
                                                           const algsurf_ray_packet *rays,
                                                           const algsurf_intersect_options *options,
                                                           const algsurf_hit_packet *to, uint64_t *exact) {
    algsurf_i_query q;
    algsurf_ray_packet read;
    algsurf_hit_packet hits;
    if (!to || !algsurf_options_read(&hits, sizeof hits, to)) return ALGSURF_E_ARGUMENT;
    algsurf_status status = prepare(&q, &read, surface, extent, rays, options);
    if (status != ALGSURF_OK) return status;
    if (!hits.state) return read.count ? ALGSURF_E_ARGUMENT : ALGSURF_OK;
    solve_together(&q, &read, 0, &hits);
    return finish(&q, &read, &hits, exact);
}

static algsurf_status any(const algsurf_surface *surface, const algsurf_extent *extent,
                          const algsurf_ray_packet *given, const algsurf_intersect_options *options,
                          unsigned char *state) {
    algsurf_i_query q;
    algsurf_ray_packet rays;
    algsurf_status status = prepare(&q, &rays, surface, extent, given, options);
    if (status != ALGSURF_OK) return status;
    if (!state) return rays.count ? ALGSURF_E_ARGUMENT : ALGSURF_OK;
    solve_together(&q, &rays, 1, &(algsurf_hit_packet){.state = state});
    for (size_t i = 0; i < rays.count; i++) {
        if (!left_alone(&rays, state, i)) continue;
        algsurf_ray ray = ray_of(&rays, i);
        int one = ALGSURF_UNDECIDED;
        algsurf_status decided = algsurf_i_occluded(&q, &ray, 1, &one);
        if (decided != ALGSURF_OK) status = decided;
        state[i] = (unsigned char)one;
    }
    return status;
}

static algsurf_status packet(const algsurf_surface *surface, const algsurf_extent *extent,
                             const algsurf_ray_packet *rays, const algsurf_intersect_options *options,
                             const algsurf_hit_packet *hits) {
    uint64_t exact = 0;
    return algsurf_i_intersect_packet(surface, extent, rays, options, hits, &exact);
}

ALGSURF_I_PUBLIC(algsurf_status, intersect_packet, packet,
                 (const algsurf_surface *surface, const algsurf_extent *extent,
                  const algsurf_ray_packet *rays, const algsurf_intersect_options *options,
                  const algsurf_hit_packet *hits),
                 (surface, extent, rays, options, hits))
ALGSURF_I_PUBLIC(algsurf_status, occluded_packet, any,
                 (const algsurf_surface *surface, const algsurf_extent *extent,
                  const algsurf_ray_packet *rays, const algsurf_intersect_options *options,
                  unsigned char *state),
                 (surface, extent, rays, options, state))
