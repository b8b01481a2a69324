/* algsurf/intersect.h - where a ray meets a surface: first hit, all hits, occluded or not. */
#ifndef ALGSURF_INTERSECT_H
#define ALGSURF_INTERSECT_H
#include "algsurf/ray.h"
#include "algsurf/refine.h"
#include "algsurf/surface.h"

#ifdef __cplusplus
extern "C" {
#endif

/* How much is known about an answer, and what it may cost. */
typedef enum algsurf_tier {
    ALGSURF_TIER_STANDARD = 0, /* signs are used only beyond their error bounds; a doubtful ray is done
                                  again in double-double; what is still in doubt is told: uncertain */
    ALGSURF_TIER_FAST = 1      /* no bounds: signs as computed; never uncertain, may be wrong within
                                  rounding of a tangency */
} algsurf_tier;

typedef enum algsurf_hit_state {
    ALGSURF_MISS = 0,     /* no point of the surface on the ray; standard tier: verified */
    ALGSURF_HIT = 1,      /* a point of the surface, and the first; standard tier: verified */
    ALGSURF_UNCERTAIN = 2 /* a tangency, or a root at an end of the ray, beyond double-double */
} algsurf_hit_state;

typedef struct algsurf_hit {
    int state;             /* an algsurf_hit_state */
    algsurf_status reason; /* ALGSURF_OK, or why it is uncertain (a positive status) */
    double t;              /* approximate, along the ray as given; uncertain: where it is in doubt */
    double t_lo, t_hi;     /* encloses the first hit: the interval that isolates it, not a tight one;
                              uncertain: no hit is before t_lo, it is open whether one is in
                              [t_lo, t_hi]; fast tier: both are t */
    double position[3];    /* origin + t direction */
    double normal[3];      /* the gradient of P there, unit length; all 0 at a singular point */
} algsurf_hit;             /* a miss: t = t_lo = t_hi = +inf, the vectors are 0 */

typedef struct algsurf_intersect_options {
    size_t size;           /* sizeof(algsurf_intersect_options) */
    algsurf_tier tier;
    algsurf_method method; /* how brackets are refined */
    int max_iterations;    /* of the refinement, 0: 1000; at the limit the best point so far counts */
    double tolerance;      /* wanted error of t, absolute; 0: all a double can tell, with the final
                              Newton step on P at the point itself */
} algsurf_intersect_options;

/* The first hit on the ray inside the extent, t in [t_min, t_max], both ends included.
 *   extent   null: all of space
 *   options  null: standard tier, default method, full accuracy
 * Guarantee: see algsurf_tier.  |t - exact| in the standard tier with default method and tolerance is
 * within a few u S(X)/|p'(t)|, u = 2^-53, S(X) the size that rounding the inputs can give P at the hit.
 * Returns OK also for a miss and for uncertain: the state is in hit.
 * Errors: E_ARGUMENT (null, zero direction, NaN, bad extent or options), E_NOT_FINITE (origin, direction).
 * Cost: 0.3 to 3 microseconds for degrees 2 to 10; a doubtful ray some 30 times that; no allocation.
 * Since 1.0. */
ALGSURF_API algsurf_status algsurf_intersect_first(const algsurf_surface *surface,
                                                   const algsurf_extent *extent, const algsurf_ray *ray,
                                                   const algsurf_intersect_options *options,
                                                   algsurf_hit *hit);

/* All hits, in increasing t.
 *   hits, capacity  room for the answer; the surface's degree, at least 1, always suffices
 *   count           how many were written, uncertain ones included
 * Errors: as above; E_ARGUMENT when the capacity is too small (nothing written).  Since 1.0. */
ALGSURF_API algsurf_status algsurf_intersect_all(const algsurf_surface *surface, const algsurf_extent *extent,
                                                 const algsurf_ray *ray,
                                                 const algsurf_intersect_options *options,
                                                 algsurf_hit *hits, int capacity, int *count);

/* Is there any hit?  Cheaper than the first hit: nothing is refined, and an odd number of roots is
 * known from the ends alone.
 *   state  ALGSURF_HIT: occluded; ALGSURF_MISS: free; ALGSURF_UNCERTAIN
 * Errors: as above.  Since 1.0. */
ALGSURF_API algsurf_status algsurf_occluded(const algsurf_surface *surface, const algsurf_extent *extent,
                                            const algsurf_ray *ray, const algsurf_intersect_options *options,
                                            algsurf_hit_state *state);

#ifdef __cplusplus
}
#endif
#endif
