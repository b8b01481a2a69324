/* host_renderer_surface.c - an algebraic surface as one more geometry of a renderer: the part to copy.
 *
 * Three callbacks.  bounds: the box about the extent.  intersect: the first hit on [tnear,tfar] of each
 * valid ray; t_max = tfar makes nearer hits of other geometries win.  occluded: is there any?  One ray
 * takes the single calls, several take the packet calls, with `valid` handed on as `active`.
 *
 * A ray that starts on the surface starts exactly at the position of a hit, without an epsilon: it counts
 * only hits before which P has the sign it started with (options.side).  A packet has one side, so rays of
 * both sides are two packets; rays that start elsewhere are a third.
 *
 * Every ray is decided, those that just touch the surface included: without options the tier is the
 * certified one.  A negative status (a ray with a NaN, say, spoils its packet) leaves the rays as they were:
 * nothing is hit.  The host's flush-to-zero and rounding mode do not matter; surfaces are shared by all
 * threads.
 */
#include <math.h>
#include <string.h>

#include "host_renderer_host.h"

static void bounds(const void *user, host_bounds *b) {
    const host_surface *s = user;
    for (int k = 0; k < 3; k++) {
        b->lower[k] = s->extent.centre[k] - s->extent.size[0];
        b->upper[k] = s->extent.centre[k] + s->extent.size[0];
    }
}

static algsurf_ray ray_of(const host_rays *r, int i) {
    return (algsurf_ray){{r->org[0][i], r->org[1][i], r->org[2][i]},
                         {r->dir[0][i], r->dir[1][i], r->dir[2][i]},
                         r->tnear[i],
                         r->tfar[i]};
}

/* The side of the surface that ray i starts on; 0: it starts elsewhere. */
static int side_of(const host_arguments *a, int i) {
    return a->rays->from[i] == a->geomID ? a->rays->from_side[i] : 0;
}

static algsurf_intersect_options options_of(int side) {
    return (algsurf_intersect_options){.size = sizeof(algsurf_intersect_options), .side = side};
}

/* How many of the rays start on that side: these are active. */
static int choose(const host_arguments *a, int side, unsigned char *active) {
    int count = 0;
    for (int i = 0; i < a->N; i++) count += active[i] = a->valid[i] && side_of(a, i) == side;
    return count;
}

static algsurf_ray_packet packet_of(const host_arguments *a, const unsigned char *active) {
    const host_rays *r = a->rays;
    return (algsurf_ray_packet){.size = sizeof(algsurf_ray_packet),
                                .count = (size_t)a->N,
                                .origin = {r->org[0], r->org[1], r->org[2]},
                                .direction = {r->dir[0], r->dir[1], r->dir[2]},
                                .t_min = r->tnear,
                                .t_max = r->tfar,
                                .active = active};
}

/* ---- the cut-away: what of all hits is left ---- */

static int is_removed(const host_surface *s, const double p[3]) {
    const host_bounds *box = &s->removed;
    if (!s->cut) return 0;
    for (int k = 0; k < 3; k++)
        if (!(p[k] > box->lower[k] && p[k] < box->upper[k])) return 0;
    return 1;
}

/* The first hit outside of the removed box; 0 when there is none.  The ray passes through what was removed:
 * behind it P has the other sign, unless the ray only touched it. */
static int first_left(const host_surface *s, const algsurf_ray *ray, int side, algsurf_hit *left) {
    algsurf_ray rest = *ray;
    for (int passed = 0; passed <= ALGSURF_MAX_DEGREE; passed++) {
        const algsurf_intersect_options how = options_of(side);
        if (algsurf_intersect_first(s->surface, &s->extent, &rest, &how, left) < 0) return 0;
        if (left->state == ALGSURF_STATE_MISS) return 0;
        if (!is_removed(s, left->position)) return 1;
        const int touches = left->multiplicity % 2 == 0;
        side = touches ? left->side : -left->side;
        rest.t_min = touches ? nextafter(left->t_hi, INFINITY) : left->t;
    }
    return 0;
}

/* ---- first hits ---- */

/* Ray i has met the surface first at `hit`, which may have been removed. */
static void take_hit(const host_arguments *a, int i, const algsurf_hit *hit) {
    const host_surface *s = a->user;
    host_rays *r = a->rays;
    algsurf_ray ray = ray_of(r, i);
    algsurf_hit left = *hit;
    if (is_removed(s, hit->position) && !first_left(s, &ray, side_of(a, i), &left)) return;
    r->tfar[i] = left.t;
    for (int k = 0; k < 3; k++) r->Ng[k][i] = left.normal[k];
    r->side[i] = left.side;
    r->geomID[i] = a->geomID;
}

/* The rays that start on that side. */
static void intersect_packet(const host_arguments *a, int side) {
    const host_surface *s = a->user;
    const algsurf_intersect_options how = options_of(side);
    unsigned char active[HOST_MAX_RAYS], state[HOST_MAX_RAYS] = {ALGSURF_STATE_MISS}; /* as is 0 */
    signed char from[HOST_MAX_RAYS];
    double t[HOST_MAX_RAYS], at[3][HOST_MAX_RAYS], normal[3][HOST_MAX_RAYS];
    if (choose(a, side, active) == 0) return;
    algsurf_ray_packet rays = packet_of(a, active);
    algsurf_hit_packet hits = {.size = sizeof hits,
                               .state = state,
                               .t = t,
                               .position = {at[0], at[1], at[2]},
                               .normal = {normal[0], normal[1], normal[2]},
                               .side = from};
    (void)algsurf_intersect_packet(s->surface, &s->extent, &rays, &how,
                                   &hits); /* a bad ray is refused alone */
    for (int i = 0; i < a->N; i++) {
        if (!active[i] || state[i] != ALGSURF_STATE_HIT) continue;
        algsurf_hit hit = {.side = from[i],
                           .t = t[i],
                           .position = {at[0][i], at[1][i], at[2][i]},
                           .normal = {normal[0][i], normal[1][i], normal[2][i]}};
        take_hit(a, i, &hit);
    }
}

static void intersect(const host_arguments *a) {
    const host_surface *s = a->user;
    if (a->N > 1) {
        for (int side = -1; side <= 1; side++) intersect_packet(a, side);
    } else if (a->valid[0]) {
        const algsurf_intersect_options how = options_of(side_of(a, 0));
        algsurf_ray ray = ray_of(a->rays, 0);
        algsurf_hit hit;
        if (algsurf_intersect_first(s->surface, &s->extent, &ray, &how, &hit) < 0) return;
        if (hit.state == ALGSURF_STATE_HIT) take_hit(a, 0, &hit);
    }
}

/* ---- is anything in the way? ---- */

static void take_occluder(const host_arguments *a, int i) {
    const host_surface *s = a->user;
    algsurf_ray ray = ray_of(a->rays, i);
    algsurf_hit left;
    if (!s->cut || first_left(s, &ray, side_of(a, i), &left)) a->rays->tfar[i] = -INFINITY;
}

static void occluded_packet(const host_arguments *a, int side) {
    const host_surface *s = a->user;
    const algsurf_intersect_options how = options_of(side);
    unsigned char active[HOST_MAX_RAYS], state[HOST_MAX_RAYS] = {ALGSURF_STATE_MISS}; /* as is 0 */
    if (choose(a, side, active) == 0) return;
    algsurf_ray_packet rays = packet_of(a, active);
    (void)algsurf_occluded_packet(s->surface, &s->extent, &rays, &how, state);
    for (int i = 0; i < a->N; i++)
        if (active[i] && state[i] == ALGSURF_STATE_HIT) take_occluder(a, i);
}

static void occluded(const host_arguments *a) {
    const host_surface *s = a->user;
    if (a->N > 1) {
        for (int side = -1; side <= 1; side++) occluded_packet(a, side);
    } else if (a->valid[0]) {
        const algsurf_intersect_options how = options_of(side_of(a, 0));
        algsurf_ray ray = ray_of(a->rays, 0);
        int state;
        if (algsurf_occluded(s->surface, &s->extent, &ray, &how, &state) < 0) return;
        if (state == ALGSURF_STATE_HIT) take_occluder(a, 0);
    }
}

host_geometry host_surface_geometry(const host_surface *surface, const host_material *material) {
    return (host_geometry){surface, bounds, intersect, occluded, *material, 0};
}
