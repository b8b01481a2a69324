#ifndef ALGSURF_CAMERA_H
#define ALGSURF_CAMERA_H
#include "algsurf/ray.h"
#ifdef __cplusplus
extern "C" {
#endif
typedef enum algsurf_camera_kind {
    ALGSURF_CAMERA_PINHOLE = 0,
    ALGSURF_CAMERA_ORTHOGRAPHIC = 1
} algsurf_camera_kind;
typedef struct algsurf_camera {
    double eye[3];
    double right[3], up[3], forward[3];
    double half_height;
    int kind;
    double reserved[8];
} algsurf_camera;
ALGSURF_API algsurf_status algsurf_camera_pinhole(const double eye[3], const double look_at[3],
                                                  const double up[3], double fov, algsurf_camera *camera);
ALGSURF_API algsurf_status algsurf_camera_orthographic(const double eye[3], const double look_at[3],
                                                       const double up[3], double height,
                                                       algsurf_camera *camera);
ALGSURF_API algsurf_status algsurf_camera_ray(const algsurf_camera *camera, int width, int height, double x,
                                              double y, algsurf_ray *ray);
#ifdef __cplusplus
}
#endif
#endif
