/* shadow_rays.h - single rays of shadows, collected until they fill a packet call. */
#ifndef ALGSURF_SHADOW_RAYS_H
#define ALGSURF_SHADOW_RAYS_H
#include "impl.h"

enum { ALGSURF_I_SHADOW_RAYS = 96 }; /* enough to fill a call */

typedef struct algsurf_i_shadow_rays {
    algsurf_i_solids solids; /* about the points in the making: */
    algsurf_i_starts starts;
    const algsurf_i_picture *picture;
    algsurf_i_shadow_job jobs[ALGSURF_MAX_LIGHTS + 1]; /* of each light, and around */
    algsurf_i_undecided undecided;                     /* rays yet to be collected */
    double origin[3][ALGSURF_I_SHADOW_RAYS], direction[3][ALGSURF_I_SHADOW_RAYS],
        t_max[ALGSURF_I_SHADOW_RAYS];
    double *seen[ALGSURF_I_SHADOW_RAYS]; /* where each is added if it arrives */
    size_t count;
    uint64_t rays;           /* sent so far */
    uint64_t without_memory; /* packets of which some could not be decided for want of it */
} algsurf_i_shadow_rays;

void algsurf_i_begin_shadow_rays(algsurf_i_shadow_rays *rays, const algsurf_i_picture *picture);

/* Collects the rays undecided; once they are sent, those that arrive have been added to the
 * points' *seen.  OK, or what the packet call returned. */
algsurf_status algsurf_i_collect_undecided(algsurf_i_shadow_rays *rays);

/* Those that are left. */
algsurf_status algsurf_i_send_shadow_rays(algsurf_i_shadow_rays *rays);

#endif
