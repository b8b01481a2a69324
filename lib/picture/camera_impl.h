/* camera_impl.h - checks of a camera, and its rays without checks, for other files of this room. */
#ifndef ALGSURF_CAMERA_IMPL_H
#define ALGSURF_CAMERA_IMPL_H
#include "algsurf/camera.h"

/* OK; E_ARGUMENT (null, axes not orthonormal to 1e-9, half height not positive, orthographic not 0 or
 * 1) or E_NOT_FINITE. */
algsurf_status algsurf_i_camera_check(const algsurf_camera *camera);

/* algsurf_camera_ray for checked arguments, in the standard floating-point environment; the ray is
 * not finite when the picture reaches beyond the range of double. */
void algsurf_i_camera_ray(const algsurf_camera *camera, int width, int height, double x, double y,
                          algsurf_ray *ray);

#endif
