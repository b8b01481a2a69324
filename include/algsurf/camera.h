/* algsurf/camera.h - from a point of the picture to a ray.
 *
 * A picture of width x height pixels has its origin in the upper left corner, x to the right, y down;
 * pixel (i,j) covers [i,i+1) x [j,j+1), its centre is (i+1/2, j+1/2).  Pixels are square.
 */
#ifndef ALGSURF_CAMERA_H
#define ALGSURF_CAMERA_H
#include "algsurf/ray.h"

#ifdef __cplusplus
extern "C" {
#endif

/* How space is projected. */
typedef enum algsurf_camera_kind {
    ALGSURF_CAMERA_PINHOLE = 0,     /* rays start at the eye */
    ALGSURF_CAMERA_ORTHOGRAPHIC = 1 /* rays are parallel and start on a plane */
} algsurf_camera_kind;

/* A plain value; make it with one of the two functions below.  right, up, forward are orthonormal, and
 * forward = up x right: right x up points to the viewer. */
typedef struct algsurf_camera {
    double eye[3];                      /* where the rays start; orthographic: a point of their plane */
    double right[3], up[3], forward[3]; /* in the picture to the right and upwards, and along the view */
    double half_height; /* of what the picture shows: at distance 1 from the eye (pinhole), everywhere
                           (orthographic) */
    int kind;           /* an algsurf_camera_kind */
    double reserved[8]; /* 0: numbers that later kinds may need */
} algsurf_camera;

/* A pinhole camera at eye that looks at a point; fov is the vertical field of view in degrees,
 * 0 < fov < 180; up need not be orthogonal to the view, only not parallel to it.
 * Errors: E_ARGUMENT (null, eye = look_at, up parallel or zero, fov outside), E_NOT_FINITE.  Since 1.0. */
ALGSURF_API algsurf_status algsurf_camera_pinhole(const double eye[3], const double look_at[3],
                                                  const double up[3], double fov, algsurf_camera *camera);

/* A parallel projection; height > 0 is the height of the picture in space.  Rays start on the plane
 * through the eye, and nothing behind it is seen.  Errors: as above.  Since 1.0. */
ALGSURF_API algsurf_status algsurf_camera_orthographic(const double eye[3], const double look_at[3],
                                                       const double up[3], double height,
                                                       algsurf_camera *camera);

/* The ray through the point (x,y) of a width x height picture, or of its plane outside the picture: t_min =
 * 0, t_max = +inf, direction of unit length up to rounding, so that t is the distance from the eye (pinhole)
 * or from the plane (orthographic).
 * Errors: E_ARGUMENT (null, width or height < 1, a camera of an unknown kind, whose axes are not
 * orthonormal to 1e-9, or whose other members are out of range), E_NOT_FINITE.  Cost: constant.  Since
 * 1.0. */
ALGSURF_API algsurf_status algsurf_camera_ray(const algsurf_camera *camera, int width, int height, double x,
                                              double y, algsurf_ray *ray);

#ifdef __cplusplus
}
#endif
#endif
