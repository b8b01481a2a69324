/* scene_impl.h - what a scene holds, for render; rays of its camera. */
#ifndef ALGSURF_SCENE_IMPL_H
#define ALGSURF_SCENE_IMPL_H
#include "algsurf/render.h"

struct algsurf_scene {
    const algsurf_surface *given;   /* borrowed */
    const algsurf_surface *surface; /* what rays ask: the given one, or in real space that of a root */
    algsurf_extent extent;
    algsurf_camera camera;
    algsurf_material material;
    algsurf_light lights[ALGSURF_MAX_LIGHTS];
    int light_count;      /* -1: the default lights, which depend on camera and extent */
    double background[3]; /* 0 where there is none, */
    int transparent;      /* which this tells: 1 */
    algsurf_quality quality;
    int antialias;
    double antialias_threshold;          /* 0: every pixel gets all its samples */
    algsurf_intersect_options intersect; /* with the scene's planes: */
    algsurf_plane planes[ALGSURF_MAX_CLIP_PLANES];
    int thin;                    /* 1: what is thin is shown, */
    double thin_colour[3];       /* in this colour */
    int complex;                 /* 1: complex space, what of it is in space; 0: real space */
    algsurf_complex_space space; /* with the scene's imaginary parts: */
    double imaginary[ALGSURF_MAX_DEGREE + 1];
    algsurf_coherence coherence;
};

/* algsurf_scene_get_lighting for checked arguments, in the standard floating-point environment. */
void algsurf_i_scene_lighting(const algsurf_scene *scene, algsurf_light lights[ALGSURF_MAX_LIGHTS],
                              algsurf_lighting *lighting);

/* OK; E_ARGUMENT (null, axes not orthonormal to 1e-9, half height not positive, an unknown kind, a reserved
 * number that is not 0) or E_NOT_FINITE. */
algsurf_status algsurf_i_camera_check(const algsurf_camera *camera);

/* Of a checked camera. */
static inline int algsurf_i_is_orthographic(const algsurf_camera *camera) {
    return camera->kind == ALGSURF_CAMERA_ORTHOGRAPHIC;
}

/* algsurf_camera_ray for checked arguments, in the standard floating-point environment; the ray is
 * not finite when the picture reaches beyond the range of double. */
void algsurf_i_camera_ray(const algsurf_camera *camera, int width, int height, double x, double y,
                          algsurf_ray *ray);

#endif
