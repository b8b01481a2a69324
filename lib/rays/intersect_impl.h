/* intersect_impl.h - the roots of one ray, between the walk that isolates them and the hits reported. */
#ifndef ALGSURF_INTERSECT_IMPL_H
#define ALGSURF_INTERSECT_IMPL_H
#include "algsurf/intersect.h"
#include "expand_impl.h"
#include "query.h"
#include "region.h"

/* A root along a ray. */
typedef struct algsurf_i_ray_root {
    int multiplicity;     /* 0: the ray lies in the surface */
    int side;             /* the sign of P just before it, 0 for a ray in the surface */
    double t, t_lo, t_hi; /* as in algsurf_hit */
} algsurf_i_ray_root;

typedef enum algsurf_i_want { ALGSURF_WANT_FIRST, ALGSURF_WANT_ALL, ALGSURF_WANT_ANY } algsurf_i_want;

/* No point of the surface on the ray. */
void algsurf_i_set_miss(algsurf_hit *hit);

/* algsurf_intersect_packet, in the standard floating-point environment; exact: the rays that integers decided
 * are added to it. */
algsurf_status algsurf_i_intersect_packet(const algsurf_surface *surface, const algsurf_extent *extent,
                                          const algsurf_ray_packet *rays,
                                          const algsurf_intersect_options *options,
                                          const algsurf_hit_packet *hits, uint64_t *exact);

/* algsurf_intersect_first and algsurf_occluded for a checked ray that packets left undecided, in the standard
 * floating-point environment: OK or E_NO_MEMORY.  exact: 1 is
 * added where integers decide. */
algsurf_status algsurf_i_intersect_first(const algsurf_i_query *q, const algsurf_ray *ray, algsurf_hit *hit,
                                         uint64_t *exact);
algsurf_status algsurf_i_occluded(const algsurf_i_query *q, const algsurf_ray *ray, int *state);

/* algsurf_intersect_complex in a region, whose planes are good, and how many corrections of roots it took. */
algsurf_status algsurf_i_intersect_complex(const algsurf_surface *surface, const algsurf_i_region *region,
                                           const algsurf_ray *ray, const algsurf_complex_space *space,
                                           const algsurf_complex *start, algsurf_complex *roots,
                                           algsurf_hit *hit, algsurf_complex *root, int *iterations);

#endif
