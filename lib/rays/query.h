/* query.h - what a call of algsurf/intersect.h asks of all its rays: read, checked and prepared once, and
 * handed on from lanes to integers. */
#ifndef ALGSURF_QUERY_H
#define ALGSURF_QUERY_H
#include "../simd/kernel.h"
#include "algsurf/intersect.h"
#include "packets.h"
#include "region.h"

/* It holds pointers into itself: it is not to be copied. */
typedef struct algsurf_i_query {
    const algsurf_surface *surface;
    algsurf_intersect_options options;
    size_t memory_limit;     /* of deciding one ray, in bytes */
    int has_method;          /* has the caller chosen how brackets are refined? */
    algsurf_i_region region; /* as given: what integers decide by */
    /* For lanes, in which surface, extent and planes have sizes that they can square. */
    int fits_lanes;                                /* 0: integers decide; the members below are not set */
    const algsurf_i_kernel *kernel;                /* the caller's choice, or the fastest */
    const algsurf_extent *extent;                  /* the region's, or a wider one that shows no more */
    algsurf_extent wider;                          /* room for that */
    algsurf_plane planes[ALGSURF_MAX_CLIP_PLANES]; /* the region's, by algsurf_i_plane_in_unit */
} algsurf_i_query;

/* Reads and checks a caller's options (null: the defaults); a kernel's name becomes the library's own string.
 */
algsurf_status algsurf_i_intersect_read_options(const algsurf_intersect_options *given,
                                                algsurf_intersect_options *options);

/* A query about a surface, from a caller's arguments.  Extent and planes are not copied: they must stay.
 * Returns OK, or the error of algsurf_intersect_first for extent or options. */
algsurf_status algsurf_i_query_read(algsurf_i_query *q, const algsurf_surface *surface,
                                    const algsurf_extent *extent, const algsurf_intersect_options *given);

/* Work for lanes, whose rays are still to be set, from a query that fits them. */
static inline algsurf_i_rays_job algsurf_i_query_job(const algsurf_i_query *q) {
    return (algsurf_i_rays_job){.surface = q->surface,
                                .extent = q->extent,
                                .planes = q->planes,
                                .plane_count = (int)q->region.plane_count,
                                .observer = q->options.observer};
}

#endif
