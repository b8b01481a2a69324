/* intersect_impl.h - what a call of algsurf/intersect.h asks of all its rays, read, checked and prepared
 * once; and how one that lanes leave undecided is answered. */
#ifndef ALGSURF_INTERSECT_IMPL_H
#define ALGSURF_INTERSECT_IMPL_H
#include "../simd/kernel.h"
#include "algsurf/intersect.h"
#include "packets.h"
#include "region.h"

/* It holds pointers into itself: it is not to be copied. */
typedef struct algsurf_i_query {
    const algsurf_surface *surface; /* the caller's, or Q where P = c Q^power; 1 otherwise: */
    int power, power_sign;          /* the sign of c */
    int crossings;                  /* 1: a ray in the surface has no hit */
    algsurf_intersect_options options;
    size_t memory_limit;     /* of deciding one ray, in bytes */
    int has_method;          /* has the caller chosen how brackets are refined? */
    algsurf_i_region region; /* as given: what integers decide by */
    /* For lanes, in which surface, extent and planes have sizes that they can square. */
    int fits_lanes;                                /* 0: integers decide; the members below are not set */
    const algsurf_i_kernel *kernel;                /* the caller's choice, or the fastest */
    algsurf_i_rays_job job;                        /* but for the rays; its extent is the region's, or: */
    algsurf_extent wider;                          /* a wider one that shows no more */
    algsurf_plane planes[ALGSURF_MAX_CLIP_PLANES]; /* the region's, by algsurf_i_plane_in_unit */
} algsurf_i_query;

/* Reads and checks a caller's options (null: the defaults); a kernel's name becomes the library's own string.
 */
algsurf_status algsurf_i_intersect_read_options(const algsurf_intersect_options *given,
                                                algsurf_intersect_options *options);

/* How they refine a root. */
static inline algsurf_refine_options algsurf_i_refinement_of(const algsurf_intersect_options *o) {
    return (algsurf_refine_options){sizeof(algsurf_refine_options), o->method, o->max_iterations,
                                    o->absolute_tolerance, o->observer};
}

/* A query about a surface, from a caller's arguments.  Extent and planes are not copied: they must stay.
 * Returns OK, or the error of algsurf_intersect_first for extent or options. */
algsurf_status algsurf_i_query_read(algsurf_i_query *q, const algsurf_surface *surface,
                                    const algsurf_extent *extent, const algsurf_intersect_options *given);

/* Makes of Q's answer P's: multiplicity, side and normal. */
void algsurf_i_hit_of_power(const algsurf_i_query *q, algsurf_hit *hit);

/* What follows is in the standard floating-point environment. */

/* No point of the surface on the ray; side: the sign of P there, or 0. */
void algsurf_i_set_miss(algsurf_hit *hit, int side);

/* A place, lo <= t <= hi, where a hit may be. */
void algsurf_i_set_undecided(const algsurf_ray *ray, double lo, double hi, algsurf_status reason,
                             algsurf_hit *hit);

/* The unit normal at a point of the ray, in the caller's units, that is `off` from its root at most, beside
 * rounding of its coordinates; limit: bytes that may be allocated. */
void algsurf_i_set_normal(const algsurf_surface *surface, const algsurf_ray *ray, const double position[3],
                          double off, size_t limit, double normal[3]);

/* algsurf_intersect_packet, or for `any`, where only states are written, algsurf_occluded_packet.  exact:
 * here and below, rays that integers decide are counted there; or null. */
algsurf_status algsurf_i_intersect_packet(const algsurf_surface *surface, const algsurf_extent *extent,
                                          const algsurf_ray_packet *rays,
                                          const algsurf_intersect_options *options, int any,
                                          const algsurf_hit_packet *hits, uint64_t *exact);

/* algsurf_intersect_first and algsurf_occluded for a checked ray: OK or E_NO_MEMORY.  tried: lanes have left
 * it undecided. */
algsurf_status algsurf_i_first_hit(const algsurf_i_query *q, const algsurf_ray *ray, int tried,
                                   algsurf_hit *hit, uint64_t *exact);
algsurf_status algsurf_i_occluded(const algsurf_i_query *q, const algsurf_ray *ray, int tried, int *state);

/* The highest power of t, up to the surface's degree, that gets an imaginary part; -1: none does. */
static inline int algsurf_i_top_imaginary(const algsurf_complex_space *space, int degree) {
    int top = space->imaginary_count > (size_t)degree ? degree : (int)space->imaginary_count - 1;
    while (top >= 0 && space->imaginary[top] == 0) top--;
    return top;
}

/* algsurf_intersect_complex in a region, whose planes are good, and how many corrections of roots it took. */
algsurf_status algsurf_i_intersect_complex(const algsurf_surface *surface, const algsurf_i_region *region,
                                           const algsurf_ray *ray, const algsurf_complex_space *space,
                                           const algsurf_complex *start, algsurf_complex *roots,
                                           algsurf_hit *hit, algsurf_complex *root, int *iterations);

#endif
