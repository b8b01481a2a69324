/* algsurf/ray.h - a ray, an extent and planes that bound what is shown, and the chord in an extent. */
#ifndef ALGSURF_RAY_H
#define ALGSURF_RAY_H
#include "algsurf/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The points origin + t direction, t_min <= t <= t_max, both ends included.  The direction need not
 * have unit length, t is measured in multiples of it.  t_min may be negative, either may be
 * infinite; t_min > t_max is a ray without points: everything misses it. */
typedef struct algsurf_ray {
    double origin[3];    /* finite */
    double direction[3]; /* finite, not all zero */
    double t_min, t_max; /* not NaN */
} algsurf_ray;

/* The shapes of an extent. */
typedef enum algsurf_extent_kind {
    ALGSURF_EXTENT_ALL = 0,    /* all of space */
    ALGSURF_EXTENT_SPHERE = 1, /* |X - centre| <= size[0] */
    ALGSURF_EXTENT_BOX = 2     /* |X_i - centre_i| <= size[i], i = 0, 1, 2 */
} algsurf_extent_kind;

/* The part of space in which a surface is looked at. */
typedef struct algsurf_extent {
    int kind;         /* an algsurf_extent_kind; of all of space centre and size play no part */
    double centre[3]; /* finite */
    double size[3];   /* sphere: the radius, in size[0]; box: half edge lengths; > 0, finite */
} algsurf_extent;

/* How many planes may cut what is shown. */
#define ALGSURF_MAX_CLIP_PLANES 8

/* A cutting plane: of what is shown it keeps the closed half space normal . X <= offset, of the exact
 * doubles.  At most ALGSURF_MAX_CLIP_PLANES cut an extent (intersect.h, render.h). */
typedef struct algsurf_plane {
    double normal[3]; /* of any length; finite, not all zero */
    double offset;    /* finite */
} algsurf_plane;

/* The part of a ray inside an extent: a ray with the same origin and direction, t_min and t_max
 * narrowed.  extent null is all of space.
 *   chord  receives the narrowed ray; may be the same object as ray
 *   meets  1: the chord has points; 0: it has none (chord is then not written)
 * The ends are rounded to nearest after a computation about the ray's point nearest to the centre:
 * a far origin costs no digits.  Guarantee: approximate (within a few units in the last place of the
 * distance from the origin to the far side of the extent, also where the ray only grazes it); t_min
 * and t_max of the ray itself are kept exactly.
 * Errors: E_ARGUMENT (null, zero direction, NaN t, unknown kind, size not positive), E_NOT_FINITE (origin,
 * direction, centre, size).
 * Cost: constant.  Since 1.0. */
ALGSURF_API algsurf_status algsurf_extent_clip(const algsurf_extent *extent, const algsurf_ray *ray,
                                               algsurf_ray *chord, int *meets);

#ifdef __cplusplus
}
#endif
#endif
