/* query.c - a query is read, checked and prepared; the tables of kernels for rays. */
#include "../base/arithmetic.h"
#include "intersect_impl.h"

#include <math.h>

#include "../base/options.h"
#include "../roots/refine_impl.h"
#include "../surface/impl.h"

ALGSURF_KERNEL_CHOICE(rays)
ALGSURF_KERNEL_CHOICE(ray)

algsurf_status algsurf_i_intersect_read_options(const algsurf_intersect_options *given,
                                                algsurf_intersect_options *options) {
    static const algsurf_intersect_options defaults = {.size = sizeof defaults};
    algsurf_status status = algsurf_options_read(options, sizeof *options, given ? given : &defaults);
    if (status != ALGSURF_OK) return status;
    if ((unsigned)options->tier > ALGSURF_TIER_BOUNDED || (unsigned)options->undecided_as > ALGSURF_AS_MISS)
        return ALGSURF_E_ARGUMENT;
    if (options->side < -1 || options->side > 1) return ALGSURF_E_ARGUMENT;
    const algsurf_refine_options how = algsurf_i_refinement_of(options);
    if ((status = algsurf_i_refine_check(&how)) != ALGSURF_OK) return status;
    if (options->kernel) {
        const algsurf_i_kernel *kernel = algsurf_i_kernel_find(options->kernel);
        if (!kernel) return ALGSURF_E_ARGUMENT;
        options->kernel = kernel->name; /* the caller's string need not live on */
    }
    return algsurf_i_planes_check(options->planes, options->plane_count);
}

/* Can lanes square the extent's sizes, in the surface's unit? */
static int extent_fits(const algsurf_extent *extent, int unit) {
    double scale = ldexp(1, -unit); /* what under- or overflows stays below or above the bounds */
    if (!extent || extent->kind == ALGSURF_EXTENT_ALL) return 1;
    for (int i = 0; i < 3; i++) {
        double size = scale * extent->size[extent->kind == ALGSURF_EXTENT_BOX ? i : 0];
        if (!(size > 0x1p-100 && size < 0x1p100 && fabs(scale * extent->centre[i]) < 0x1p100)) return 0;
    }
    return 1;
}

/* The planes in the surface's unit; 0: one is too far away for lanes, or loses a component. */
static int scale_planes(algsurf_i_query *q) {
    for (size_t i = 0; i < q->region.plane_count; i++) {
        q->planes[i] = algsurf_i_plane_in_unit(q->region.planes + i, q->surface->unit);
        if (!(fabs(q->planes[i].offset) < 0x1p100)) return 0;
        for (int k = 0; k < 3; k++)
            if ((q->planes[i].normal[k] == 0) != (q->region.planes[i].normal[k] == 0)) return 0;
    }
    return 1;
}

/* P's roots are Q's where P = c Q^k, unless somebody watches P's, or asks for hits before which c Q^k has the
 * sign that it has nowhere. */
static const algsurf_surface *choose_root(algsurf_i_query *q, const algsurf_surface *surface) {
    const int front = algsurf_i_surface_front(surface), opposite = front && q->options.side == -front;
    q->power = 1, q->crossings = 0;
    if (!surface->root || q->options.observer || opposite) return surface;
    q->power = surface->power, q->power_sign = surface->power_sign;
    if (front) q->crossings = q->options.side != 0, q->options.side = 0;
    return surface->root;
}

void algsurf_i_hit_of_power(const algsurf_i_query *q, algsurf_hit *hit) {
    if (q->power == 1) return;
    hit->multiplicity *= q->power;
    if (q->power % 2) return;
    /* shortly before the hit the gradient is a positive multiple of c Q^(k-1) grad Q */
    for (int i = 0; i < 3; i++) hit->normal[i] *= hit->side * q->power_sign;
    hit->side = hit->side ? q->power_sign : 0;
}

algsurf_status algsurf_i_query_read(algsurf_i_query *q, const algsurf_surface *surface,
                                    const algsurf_extent *extent, const algsurf_intersect_options *given) {
    const algsurf_intersect_options *options = &q->options;
    algsurf_status status = algsurf_i_extent_check(extent);
    if (status == ALGSURF_OK) status = algsurf_i_intersect_read_options(given, &q->options);
    if (status != ALGSURF_OK) return status;
    q->surface = surface = choose_root(q, surface);
    q->memory_limit = options->max_memory ? options->max_memory : ALGSURF_DEFAULT_MEMORY;
    q->has_method = options->method != ALGSURF_METHOD_DEFAULT || options->max_iterations > 0;
    q->region = (algsurf_i_region){extent, options->planes, options->plane_count};
    q->job = (algsurf_i_rays_job){.surface = surface,
                                  .extent = algsurf_i_without_own_ball(surface, extent, &q->wider),
                                  .planes = q->planes,
                                  .plane_count = (int)options->plane_count,
                                  .side = options->side,
                                  .observer = options->observer};
    q->fits_lanes = surface->tables && surface->unit >= -800 && surface->unit <= 800 &&
                    extent_fits(q->job.extent, surface->unit) && scale_planes(q);
    if (q->fits_lanes) q->kernel = algsurf_i_kernel_find(options->kernel);
    return ALGSURF_OK;
}
