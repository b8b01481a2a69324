/* intersect_impl.h - the roots of one ray, between the walk that isolates them and the hits reported. */
#ifndef ALGSURF_INTERSECT_IMPL_H
#define ALGSURF_INTERSECT_IMPL_H
#include "algsurf/intersect.h"
#include "expand_impl.h"
#include "ray_impl.h"

/* A root along a ray, or a place where one may be.  Positions are offsets from the frame's centre in
 * its natural parameter s, kept apart so that a far origin costs nothing. */
typedef struct algsurf_i_ray_root {
    int state; /* ALGSURF_HIT or ALGSURF_UNCERTAIN */
    algsurf_status reason;
    int polish;        /* 1: found in double, worth a Newton step on P itself */
    algsurf_dd offset; /* s = centre + offset */
    double t_lo, t_hi; /* encloses, in the caller's t */
} algsurf_i_ray_root;

typedef enum algsurf_i_want { ALGSURF_WANT_FIRST, ALGSURF_WANT_ALL, ALGSURF_WANT_ANY } algsurf_i_want;

/* Roots of P along a checked, clipped ray with t_min <= t_max, in order, at most `capacity` >= 1 of them;
 * when there would be more, the last entry is undecided and covers the rest.  The frame they refer to
 * is returned too.  WANT_ANY: the first entry that is a hit, unrefined, or the first undecided one. */
int algsurf_i_ray_roots(const algsurf_surface *surface, const algsurf_ray *ray,
                        const algsurf_intersect_options *options, algsurf_i_want want, algsurf_i_frame *frame,
                        algsurf_i_ray_root *roots, int capacity);

/* The same with what the tier and the caller's choice make of doubt: the certified tier decides it by exact
 * arithmetic where that can be, and leaves out what is on the ray but not in the extent of the edges. */
int algsurf_i_decided_roots(const algsurf_surface *surface, const algsurf_ray *ray,
                            const algsurf_i_edges *edges, const algsurf_intersect_options *options,
                            algsurf_i_want want, algsurf_i_frame *frame, algsurf_i_ray_root *roots,
                            int capacity);

/* Reads and checks a caller's options (null: the defaults); a kernel's name becomes the library's own string.
 */
algsurf_status algsurf_i_intersect_read_options(const algsurf_intersect_options *given,
                                                algsurf_intersect_options *options);

/* Can the lanes square what is shown, in the surface's unit? */
int algsurf_i_rays_fit(const algsurf_surface *surface, const algsurf_extent *extent);

/* algsurf_intersect_first and algsurf_occluded in the standard floating-point environment. */
algsurf_status algsurf_i_intersect_first(const algsurf_surface *surface, const algsurf_extent *extent,
                                         const algsurf_ray *ray, const algsurf_intersect_options *options,
                                         algsurf_hit *hit);
algsurf_status algsurf_i_occluded(const algsurf_surface *surface, const algsurf_extent *extent,
                                  const algsurf_ray *ray, const algsurf_intersect_options *options,
                                  algsurf_hit_state *state);

/* algsurf_intersect_complex, and how many corrections of roots it took. */
algsurf_status algsurf_i_intersect_complex(const algsurf_surface *surface, const algsurf_extent *extent,
                                           const algsurf_ray *ray, const algsurf_complex_space *space,
                                           const algsurf_complex *start, algsurf_complex *roots,
                                           algsurf_hit *hit, algsurf_complex *root, int *iterations);

#endif
