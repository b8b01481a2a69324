/* shadow_rays.h - rays to places of lights, collected until they fill a packet call. */
#ifndef ALGSURF_SHADOW_RAYS_H
#define ALGSURF_SHADOW_RAYS_H
#include "impl.h"

enum { ALGSURF_I_SHADOW_RAYS = 96 }; /* enough to fill a call */

/* Rays in groups: those of one group add to one light's share of one point. */
typedef struct algsurf_i_shadow_rays {
    const algsurf_i_picture *picture;
    double origin[3][ALGSURF_I_SHADOW_RAYS], direction[3][ALGSURF_I_SHADOW_RAYS],
        t_max[ALGSURF_I_SHADOW_RAYS];
    size_t count;
    double *share[ALGSURF_I_SHADOW_RAYS]; /* of each group */
    size_t end[ALGSURF_I_SHADOW_RAYS];    /* where its rays end */
    int groups;
    uint64_t rays;           /* sent so far */
    uint64_t without_memory; /* packets of which some could not be decided for want of it */
} algsurf_i_shadow_rays;

/* Places of a light. */
typedef struct algsurf_i_places {
    const double *at[3];
    int count;
} algsurf_i_places;

/* A point, lifted off the surface, and the side of it that the viewer is on. */
typedef struct algsurf_i_start {
    double at[3], facing[3];
} algsurf_i_start;

/* How high above a point's tangent plane place i is. */
static inline double algsurf_i_height(const algsurf_i_places *places, int i, const algsurf_i_start *start) {
    return (places->at[0][i] - start->at[0]) * start->facing[0] +
           (places->at[1][i] - start->at[1]) * start->facing[1] +
           (places->at[2][i] - start->at[2]) * start->facing[2];
}

void algsurf_i_begin_shadow_rays(algsurf_i_shadow_rays *rays, const algsurf_i_picture *picture);

/* Rays from a point to places; once they are sent, those that arrive have been added to *seen.  What is below
 * the point's tangent plane counts as seen: shading knows how the point lies.  OK, or what the packet call
 * returned. */
algsurf_status algsurf_i_shoot(algsurf_i_shadow_rays *rays, const algsurf_i_places *places,
                               const algsurf_i_start *start, double *seen);

/* Those that are left. */
algsurf_status algsurf_i_send_shadow_rays(algsurf_i_shadow_rays *rays);

#endif
