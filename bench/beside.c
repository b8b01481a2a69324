/* beside.c - see beside.h: all that is compiled with the other edition's headers, and its name as
 * BESIDE_NAME. */
#include "beside.h"

static beside_answer first(const algsurf_surface *surface, const algsurf_extent *extent,
                           const algsurf_ray *ray, double *t) {
    const algsurf_intersect_options certified = {.size = sizeof certified, .tier = ALGSURF_TIER_CERTIFIED};
    algsurf_hit hit;
    if (algsurf_intersect_first(surface, extent, ray, &certified, &hit) != ALGSURF_OK) return BESIDE_REFUSED;
    *t = hit.t;
    if (hit.state == ALGSURF_STATE_UNDECIDED) return BESIDE_UNDECIDED;
    return hit.state == ALGSURF_STATE_HIT ? BESIDE_HIT : BESIDE_NO_HIT;
}

const beside_edition beside = {
    .name = BESIDE_NAME,
    .term_size = sizeof(algsurf_term),
    .extent_size = sizeof(algsurf_extent),
    .ray_size = sizeof(algsurf_ray),
    .surface_from_terms = algsurf_surface_from_terms,
    .surface_free = algsurf_surface_free,
    .first = first,
};
