/* shadow_rays.h - single rays of shadows, collected until they fill a packet call. */
#ifndef ALGSURF_SHADOW_RAYS_H
#define ALGSURF_SHADOW_RAYS_H
#include "impl.h"

enum { ALGSURF_I_SHADOW_RAYS = 96 }; /* enough to fill a call */

/* Points of a line whose rays are found together. */
typedef struct algsurf_i_group {
    algsurf_i_starts starts;
    int from[ALGSURF_I_STARTS]; /* of the line's points */
} algsurf_i_group;

typedef struct algsurf_i_shadow_rays {
    const algsurf_i_picture *picture;
    algsurf_i_group all, open;     /* the points in the making; those whose rays are asked about one by one */
    algsurf_i_undecided undecided; /* rays yet to be collected */
    double origin[3][ALGSURF_I_SHADOW_RAYS], direction[3][ALGSURF_I_SHADOW_RAYS],
        t_max[ALGSURF_I_SHADOW_RAYS];
    double *seen[ALGSURF_I_SHADOW_RAYS]; /* where each is added if it arrives */
    size_t count;
    uint64_t rays;           /* sent so far */
    uint64_t without_memory; /* packets of which some could not be decided for want of it */
} algsurf_i_shadow_rays;

void algsurf_i_begin_shadow_rays(algsurf_i_shadow_rays *rays, const algsurf_i_picture *picture);

/* Collects the rays undecided, of these points; once they are sent, those that arrive have been added to the
 * points' *seen.  OK, or what the packet call returned. */
algsurf_status algsurf_i_collect_doubts(algsurf_i_shadow_rays *rays, const algsurf_i_starts *starts);

/* Those that are left. */
algsurf_status algsurf_i_send_shadow_rays(algsurf_i_shadow_rays *rays);

#endif
