/* scenes.h - surfaces and scenes as tests make them, released when the test ends. */
#ifndef SCENES_H
#define SCENES_H
#include "algsurf/algsurf.h"
#include "exact.h"
#include "unit.h"

static inline void surface_release(void *surface) { algsurf_surface_free(surface); }

static inline void scene_release(void *scene) { algsurf_scene_free(scene); }

static inline algsurf_surface *surface_kept(algsurf_surface *surface) {
    assert_non_null(surface);
    return unit_keep(surface, surface_release);
}

static inline algsurf_surface *surface_of(const char *equation) {
    algsurf_surface *surface = NULL;
    assert_ok(algsurf_surface_from_equation(equation, NULL, 0, &surface, NULL));
    return surface_kept(surface);
}

static inline algsurf_surface *surface_of_terms(const algsurf_term *terms, size_t count) {
    algsurf_surface *surface = NULL;
    assert_ok(algsurf_surface_from_terms(terms, count, &surface));
    return surface_kept(surface);
}

static inline algsurf_surface *surface_with_error(const algsurf_surface *exact, double error) {
    algsurf_surface *surface = NULL;
    assert_ok(algsurf_surface_with_error(exact, error, &surface));
    return surface_kept(surface);
}

/* Up to 60 terms, some of them alike, of coefficients from 2^low to 2^high. */
static inline algsurf_surface *surface_of_random_terms(uint64_t *state, int degree, int low, int high) {
    algsurf_term terms[60];
    int count = 1 + random_int(state, 60);
    for (int t = 0; t < count; t++) {
        int d = random_int(state, degree + 1), i = random_int(state, d + 1);
        int j = random_int(state, d - i + 1);
        terms[t] = (algsurf_term){i, j, d - i - j, random_wide(state, low, high)};
    }
    return surface_of_terms(terms, (size_t)count);
}

static inline algsurf_camera pinhole_of(const double eye[3], const double at[3], const double up[3],
                                        double fov) {
    algsurf_camera camera;
    assert_ok(algsurf_camera_pinhole(eye, at, up, fov, &camera));
    return camera;
}

static inline algsurf_camera parallel_of(const double eye[3], const double at[3], const double up[3],
                                         double height) {
    algsurf_camera camera;
    assert_ok(algsurf_camera_orthographic(eye, at, up, height, &camera));
    return camera;
}

static inline algsurf_ray pixel_ray(const algsurf_camera *camera, int width, int height, double x, double y) {
    algsurf_ray ray;
    assert_ok(algsurf_camera_ray(camera, width, height, x, y, &ray));
    return ray;
}

static inline algsurf_hit first_hit_of(const algsurf_surface *surface, const algsurf_extent *extent,
                                       const algsurf_ray *ray, const algsurf_intersect_options *how) {
    algsurf_hit hit;
    assert_ok(algsurf_intersect_first(surface, extent, ray, how, &hit));
    return hit;
}

/* With this extent, camera and way to intersect; what is null stays as it is. */
static inline algsurf_scene *scene_of(const algsurf_surface *surface, const algsurf_extent *extent,
                                      const algsurf_camera *camera, const algsurf_intersect_options *how) {
    algsurf_scene *scene = NULL;
    assert_ok(algsurf_scene_create(surface, &scene));
    unit_keep(scene, scene_release);
    if (extent) assert_ok(algsurf_scene_set_extent(scene, extent));
    if (camera) assert_ok(algsurf_scene_set_camera(scene, camera));
    if (how) assert_ok(algsurf_scene_set_intersect_options(scene, how));
    return scene;
}

/* Is t a zero of P on the ray, as far as the rounding of the point and of P let one see? */
static inline int is_zero(const algsurf_surface *surface, const algsurf_ray *ray, double t) {
    double point[3], value, gradient[3], bound, gradient_bound[3], slack = 0;
    for (int i = 0; i < 3; i++) point[i] = ray->origin[i] + t * ray->direction[i];
    assert_ok(algsurf_surface_gradient(surface, point, &value, gradient, &bound, gradient_bound));
    for (int i = 0; i < 3; i++)
        slack += (fabs(gradient[i]) + gradient_bound[i]) * 0x1p-49 * (fabs(t) + fabs(ray->origin[i]));
    return fabs(value) <= 32 * bound + slack;
}

#endif
