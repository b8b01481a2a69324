/* camera.c - pinhole and orthographic cameras.
 *
 * The frame is built from v = look_at - eye, one rounded subtraction: a far eye costs nothing.
 * right = forward x up is computed with error-free products, so that it is orthogonal to both even when
 * they are nearly parallel, and the frame's up is right x forward.
 */
#include "../base/arithmetic.h"
#include "scene_impl.h"

#include "../base/eft.h"
#include "../base/fpenv.h"
#include "../base/vec.h"
#include "../base/elementary.h"

#define PI 3.14159265358979323846

/* Sets eye and axes.  up counts as parallel when its angle to the view is below the rounding of v. */
static algsurf_status set_frame(algsurf_camera *camera, const double eye[3], const double look_at[3],
                                const double up[3]) {
    double v[3], w[3], side[3];
    if (!algsurf_is_finite3(eye) || !algsurf_is_finite3(look_at) || !algsurf_is_finite3(up))
        return ALGSURF_E_NOT_FINITE;
    double largest = fmax(algsurf_max_abs(eye), algsurf_max_abs(look_at));
    double scale = largest > 0x1p1000 ? 0.5 : 1.0; /* the difference must not overflow */
    for (int i = 0; i < 3; i++) v[i] = scale * look_at[i] - scale * eye[i];
    if (!algsurf_unit(v, camera->forward) || !algsurf_unit(up, w)) return ALGSURF_E_ARGUMENT;
    algsurf_cross(camera->forward, w, side);
    if (algsurf_max_abs(side) <= 8 * ALGSURF_U) return ALGSURF_E_ARGUMENT;
    (void)algsurf_unit(side, camera->right);
    algsurf_cross(camera->right, camera->forward, side);
    (void)algsurf_unit(side, camera->up);
    for (int i = 0; i < 3; i++) camera->eye[i] = eye[i];
    return ALGSURF_OK;
}

static double tangent(double angle) {
    double point[2];
    algsurf_i_circle(angle, point);
    return point[1] / point[0];
}

static ALGSURF_NOINLINE algsurf_status make_camera(algsurf_camera *camera, const double eye[3],
                                                   const double look_at[3], const double up[3],
                                                   double aperture, algsurf_camera_kind kind) {
    const int orthographic = kind == ALGSURF_CAMERA_ORTHOGRAPHIC;
    algsurf_camera made = {.kind = (int)kind};
    if (!camera || !eye || !look_at || !up) return ALGSURF_E_ARGUMENT;
    if (!isfinite(aperture)) return ALGSURF_E_NOT_FINITE;
    if (!(aperture > 0) || (!orthographic && !(aperture < 180))) return ALGSURF_E_ARGUMENT;
    made.half_height = orthographic ? 0.5 * aperture : tangent(aperture * (PI / 360));
    if (!(made.half_height > 0)) return ALGSURF_E_ARGUMENT; /* it underflowed */
    algsurf_status status = set_frame(&made, eye, look_at, up);
    if (status == ALGSURF_OK) *camera = made;
    return status;
}

algsurf_status algsurf_camera_pinhole(const double eye[3], const double look_at[3], const double up[3],
                                      double fov, algsurf_camera *camera) {
    algsurf_status status;
    ALGSURF_STANDARD(status = make_camera(camera, eye, look_at, up, fov, ALGSURF_CAMERA_PINHOLE));
    return status;
}

algsurf_status algsurf_camera_orthographic(const double eye[3], const double look_at[3], const double up[3],
                                           double height, algsurf_camera *camera) {
    algsurf_status status;
    ALGSURF_STANDARD(status = make_camera(camera, eye, look_at, up, height, ALGSURF_CAMERA_ORTHOGRAPHIC));
    return status;
}

algsurf_status algsurf_i_camera_check(const algsurf_camera *camera) {
    const double tolerance = 1e-9; /* far above the rounding of a frame, far below any mistake */
    if (!camera) return ALGSURF_E_ARGUMENT;
    if (!algsurf_is_finite3(camera->eye) || !isfinite(camera->half_height) ||
        !algsurf_is_finite3(camera->right) || !algsurf_is_finite3(camera->up) ||
        !algsurf_is_finite3(camera->forward))
        return ALGSURF_E_NOT_FINITE;
    int good = algsurf_are_orthonormal(camera->right, camera->up, camera->forward, tolerance) &&
               (camera->kind == ALGSURF_CAMERA_PINHOLE || camera->kind == ALGSURF_CAMERA_ORTHOGRAPHIC) &&
               camera->half_height > 0 && algsurf_are_zero(camera->reserved, 8);
    return good ? ALGSURF_OK : ALGSURF_E_ARGUMENT;
}

void algsurf_i_camera_ray(const algsurf_camera *camera, int width, int height, double x, double y,
                          algsurf_ray *ray) {
    double unit = camera->half_height / (0.5 * height); /* a pixel's edge on the image plane */
    const int orthographic = algsurf_i_is_orthographic(camera);
    double u = (x - 0.5 * width) * unit, v = (0.5 * height - y) * unit, offset[3];
    for (int i = 0; i < 3; i++) offset[i] = u * camera->right[i] + v * camera->up[i];
    for (int i = 0; i < 3; i++) {
        ray->origin[i] = orthographic ? camera->eye[i] + offset[i] : camera->eye[i];
        ray->direction[i] = orthographic ? camera->forward[i] : camera->forward[i] + offset[i];
    }
    if (!orthographic) (void)algsurf_unit(ray->direction, ray->direction);
    ray->t_min = 0;
    ray->t_max = INFINITY;
}

ALGSURF_I_ENTRY(algsurf_status, camera_ray,
                (const algsurf_camera *camera, int width, int height, double x, double y, algsurf_ray *ray),
                (camera, width, height, x, y, ray)) {
    algsurf_ray made;
    if (!ray || width < 1 || height < 1) return ALGSURF_E_ARGUMENT;
    algsurf_status status = algsurf_i_camera_check(camera);
    if (status != ALGSURF_OK) return status;
    if (!isfinite(x) || !isfinite(y)) return ALGSURF_E_NOT_FINITE;
    algsurf_i_camera_ray(camera, width, height, x, y, &made);
    if (!algsurf_is_finite3(made.origin) || !algsurf_is_finite3(made.direction)) return ALGSURF_E_NOT_FINITE;
    *ray = made;
    return ALGSURF_OK;
}
