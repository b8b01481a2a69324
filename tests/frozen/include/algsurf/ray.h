#ifndef ALGSURF_RAY_H
#define ALGSURF_RAY_H
#include <stddef.h>
#include "algsurf/status.h"
#ifdef __cplusplus
extern "C" {
#endif
typedef struct algsurf_ray {
    double origin[3];
    double direction[3];
    double t_min, t_max;
} algsurf_ray;
typedef enum algsurf_extent_kind {
    ALGSURF_EXTENT_ALL = 0,
    ALGSURF_EXTENT_SPHERE = 1,
    ALGSURF_EXTENT_BOX = 2
} algsurf_extent_kind;
typedef struct algsurf_extent {
    int kind;
    double centre[3];
    double size[3];
} algsurf_extent;
#define ALGSURF_MAX_CLIP_PLANES 8
typedef struct algsurf_plane {
    double normal[3];
    double offset;
} algsurf_plane;
ALGSURF_API algsurf_status algsurf_ray_clip(const algsurf_ray *ray, const algsurf_extent *extent,
                                            const algsurf_plane *planes, size_t count, algsurf_ray *chord,
                                            int *meets);
#ifdef __cplusplus
}
#endif
#endif
