/* shadow_rays.c - single rays of shadows, by packets. */
#include "../base/arithmetic.h"
#include "shadow_rays.h"

void algsurf_i_begin_shadow_rays(algsurf_i_shadow_rays *rays, const algsurf_i_picture *picture) {
    rays->picture = picture;
    rays->count = 0;
    rays->undecided.count = 0;
    rays->rays = rays->without_memory = 0;
    for (int i = 0; i < ALGSURF_I_SHADOW_RAYS; i++) rays->t_max[i] = 1;
}

algsurf_status algsurf_i_send_shadow_rays(algsurf_i_shadow_rays *b) {
    const algsurf_scene *scene = b->picture->scene;
    unsigned char state[ALGSURF_I_SHADOW_RAYS];
    const algsurf_ray_packet rays = {.size = sizeof rays,
                                     .count = b->count,
                                     .origin = {b->origin[0], b->origin[1], b->origin[2]},
                                     .direction = {b->direction[0], b->direction[1], b->direction[2]},
                                     .t_max = b->t_max};
    algsurf_status status =
        algsurf_occluded_packet(scene->surface, &scene->extent, &rays, &scene->intersect, state);
    if (status < 0 && status != ALGSURF_E_NO_MEMORY) return status;
    b->without_memory += status < 0;
    for (size_t i = 0; i < b->count; i++) *b->seen[i] += state[i] == ALGSURF_MISS;
    b->rays += b->count;
    b->count = 0;
    return ALGSURF_OK;
}

algsurf_status algsurf_i_collect_undecided(algsurf_i_shadow_rays *b) {
    const algsurf_i_starts *starts = &b->starts;
    for (int i = 0; i < b->undecided.count; i++) {
        int from = b->undecided.start[i];
        for (int k = 0; k < 3; k++) {
            b->origin[k][b->count] = starts->at[k][from];
            b->direction[k][b->count] = b->undecided.direction[k][i];
        }
        b->seen[b->count++] = starts->seen[from];
        if (b->count < ALGSURF_I_SHADOW_RAYS) continue;
        algsurf_status status = algsurf_i_send_shadow_rays(b);
        if (status < 0) return status;
    }
    b->undecided.count = 0;
    return ALGSURF_OK;
}
