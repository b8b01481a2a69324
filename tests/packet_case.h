/* packet_case.h - rays side by side, what the calls for packets say of them, and whether single calls say it.
 */
#ifndef PACKET_CASE_H
#define PACKET_CASE_H
#include <string.h>

#include "algsurf/intersect.h"

#ifndef PACKET_MOST
#define PACKET_MOST 400
#endif

typedef struct packet_case {
    double origin[3][PACKET_MOST], direction[3][PACKET_MOST], t_min[PACKET_MOST], t_max[PACKET_MOST];
    unsigned char active[PACKET_MOST];
    int masked, sideless; /* 1: `active` counts; sides are not asked for */
    unsigned char state[PACKET_MOST], occluded[PACKET_MOST];
    double t[PACKET_MOST], t_lo[PACKET_MOST], t_hi[PACKET_MOST];
    double position[3][PACKET_MOST], normal[3][PACKET_MOST];
    int multiplicity[PACKET_MOST];
    signed char side[PACKET_MOST], reason[PACKET_MOST];
} packet_case;

static inline void packet_put(packet_case *p, int i, const algsurf_ray *ray) {
    for (int k = 0; k < 3; k++) p->origin[k][i] = ray->origin[k], p->direction[k][i] = ray->direction[k];
    p->t_min[i] = ray->t_min, p->t_max[i] = ray->t_max;
}

static inline algsurf_ray packet_ray(const packet_case *p, int i) {
    return (algsurf_ray){{p->origin[0][i], p->origin[1][i], p->origin[2][i]},
                         {p->direction[0][i], p->direction[1][i], p->direction[2][i]},
                         p->t_min[i],
                         p->t_max[i]};
}

/* Without the reason, of which single calls know more. */
static inline algsurf_hit packet_hit(const packet_case *p, int i) {
    return (algsurf_hit){p->state[i],
                         ALGSURF_OK,
                         p->multiplicity[i],
                         p->side[i],
                         p->t[i],
                         p->t_lo[i],
                         p->t_hi[i],
                         {p->position[0][i], p->position[1][i], p->position[2][i]},
                         {p->normal[0][i], p->normal[1][i], p->normal[2][i]}};
}

/* Both calls for rays first .. first+count-1; what they return, or a status of neither where they differ. */
static inline int packet_ask(packet_case *p, int first, int count, const algsurf_surface *surface,
                             const algsurf_extent *extent, const algsurf_intersect_options *options) {
    algsurf_ray_packet rays = {.size = sizeof rays, .count = (size_t)count};
    algsurf_hit_packet hits = {.size = sizeof hits, .state = p->state + first};
    rays.t_min = p->t_min + first, rays.t_max = p->t_max + first;
    if (p->masked) rays.active = p->active + first;
    hits.t = p->t + first, hits.t_lo = p->t_lo + first, hits.t_hi = p->t_hi + first;
    hits.multiplicity = p->multiplicity + first, hits.reason = p->reason + first;
    if (!p->sideless) hits.side = p->side + first;
    for (int k = 0; k < 3; k++) {
        rays.origin[k] = p->origin[k] + first;
        rays.direction[k] = p->direction[k] + first;
        hits.position[k] = p->position[k] + first;
        hits.normal[k] = p->normal[k] + first;
    }
    int status = algsurf_intersect_packet(surface, extent, &rays, options, &hits);
    int other = algsurf_occluded_packet(surface, extent, &rays, options, p->occluded + first);
    return status == other ? status : -1000;
}

/* What ray i's single calls say otherwise, to the bit; null: nothing.  *single: the hit that they tell. */
static inline const char *packet_wrong(const packet_case *p, int i, const algsurf_surface *surface,
                                       const algsurf_extent *extent, const algsurf_intersect_options *options,
                                       algsurf_hit *single) {
    algsurf_ray ray = packet_ray(p, i);
    algsurf_hit hit = packet_hit(p, i);
    int occluded;
    if (algsurf_intersect_first(surface, extent, &ray, options, single) != ALGSURF_OK ||
        algsurf_occluded(surface, extent, &ray, options, &occluded) != ALGSURF_OK)
        return "refused";
    if ((single->reason != ALGSURF_OK) != (single->state == ALGSURF_STATE_UNDECIDED))
        return "a reason to be undecided";
    single->reason = ALGSURF_OK;
    if (p->sideless) hit.side = single->side;
    return memcmp(&hit, single, sizeof hit) == 0 && p->occluded[i] == occluded
               ? NULL
               : "not what a single call says";
}

#endif
