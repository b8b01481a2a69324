/* shadow_rays.c - rays to places of lights, by packets. */
#include "../base/arithmetic.h"
#include "shadow_rays.h"

void algsurf_i_begin_shadow_rays(algsurf_i_shadow_rays *rays, const algsurf_i_picture *picture) {
    rays->picture = picture;
    rays->count = 0;
    rays->groups = 0;
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
    size_t i = 0;
    for (int g = 0; g < b->groups; g++) {
        int seen = 0;
        for (; i < b->end[g]; i++) seen += state[i] == ALGSURF_MISS;
        *b->share[g] += seen;
    }
    b->rays += b->count;
    b->count = 0;
    b->groups = 0;
    return ALGSURF_OK;
}

/* Returns how many of them there is no ray to. */
static int add_rays(algsurf_i_shadow_rays *b, const algsurf_i_places *places, int first, int count,
                    const algsurf_i_start *start) {
    size_t before = b->count;
    for (int i = first; i < first + count; i++) {
        for (int k = 0; k < 3; k++) {
            b->origin[k][b->count] = start->at[k];
            b->direction[k][b->count] = places->at[k][i] - start->at[k];
        }
        b->count += algsurf_i_height(places, i, start) > 0;
    }
    return count - (int)(b->count - before);
}

algsurf_status algsurf_i_shoot(algsurf_i_shadow_rays *b, const algsurf_i_places *places,
                               const algsurf_i_start *start, double *seen) {
    for (int first = 0, count; first < places->count; first += count) {
        int room = ALGSURF_I_SHADOW_RAYS - (int)b->count;
        count = places->count - first < room ? places->count - first : room;
        *seen += add_rays(b, places, first, count, start);
        b->share[b->groups] = seen;
        b->end[b->groups++] = b->count;
        if (b->count < ALGSURF_I_SHADOW_RAYS && b->groups < ALGSURF_I_SHADOW_RAYS) continue;
        algsurf_status status = algsurf_i_send_shadow_rays(b);
        if (status < 0) return status;
    }
    return ALGSURF_OK;
}
