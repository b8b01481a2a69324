/* algsurf/ray.h - a ray, an extent and planes that bound what is shown, and the part of a ray in them. */
#ifndef ALGSURF_RAY_H
#define ALGSURF_RAY_H
#include <stddef.h>

#include "algsurf/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The points origin + t direction, t_min <= t <= t_max, both ends included.  The direction need not
 * have unit length, t is measured in multiples of it.  t_min may be negative, and either end infinite.  With
 * t_min > t_max the ray has no points, and misses everything. */
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
    int kind;         /* an algsurf_extent_kind; for all of space, centre and size play no part */
    double centre[3]; /* finite */
    double size[3];   /* sphere: the radius, in size[0]; box: half of each edge; > 0, finite */
} algsurf_extent;

/* How many planes may cut what is shown. */
#define ALGSURF_MAX_CLIP_PLANES 8

/* A cutting plane: of what is shown only the part in the closed half space normal . X <= offset is kept.  The
 * doubles are taken as exact. */
typedef struct algsurf_plane {
    double normal[3]; /* of any length; finite, not all zero */
    double offset;    /* finite */
} algsurf_plane;

/* The part of a ray that is inside an extent and kept by all planes: a ray with the same origin and
 * direction, t_min and t_max narrowed.
 *   extent          null: all of space
 *   planes, count   at most ALGSURF_MAX_CLIP_PLANES; null with count 0: no planes
 *   chord           receives the narrowed ray; may be the same object as ray
 *   meets           1: the chord has points; 0: it has none, and chord is not written
 * Guarantee: encloses: every point of the ray that is in the extent and kept by all planes has its t in
 * [chord->t_min, chord->t_max], all doubles taken as exact; if there is such a point, meets is 1.  So the
 * hits on the ray are those on the chord, with the same extent and planes.  The chord is hardly longer than
 * that part of the ray.  Ends of the ray that are inside stay as they are.  No point of the chord is outside
 * a box, along axis i, by more than
 *     e_i = 2^-42 (|origin_i| + |centre_i| + size_i),
 * outside a ball by more than the largest e_i, each size_i being the radius, or beyond a plane, measured by
 * normal . X - offset, by more than
 *     2^-46 (|offset| + sum_i |normal_i| (|origin_i| + T |direction_i|)),   T the largest |t| in the extent.
 * (These bounds hold where no number is 2^900 times as large as another, nor near the limits of double.)
 * Errors: E_ARGUMENT (null, zero direction, unknown kind, size not positive, more than
 * ALGSURF_MAX_CLIP_PLANES, normal 0), E_NOT_FINITE (origin, direction, NaN t, centre, size, planes).
 * Cost: constant.  Since 1.0. */
ALGSURF_API algsurf_status algsurf_ray_clip(const algsurf_ray *ray, const algsurf_extent *extent,
                                            const algsurf_plane *planes, size_t count, algsurf_ray *chord,
                                            int *meets);

#ifdef __cplusplus
}
#endif
#endif
