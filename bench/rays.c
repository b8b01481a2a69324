/* rays.c - see rays.h.
 *
 * A ray is re-centred before it is expanded: its origin becomes the middle of the chord, its direction half
 * the chord.  Solvers that count on a unit interval get one, and none is judged by what a far eye does to it.
 */
#include "rays.h"

#include <math.h>
#include <stdlib.h>

#include "measure.h"
#include "must.h"

enum { WIDTH = 1024, HEIGHT = 768 };

algsurf_surface *rays_surface(const catalogue_entry *entry) {
    algsurf_surface *surface;
    must(algsurf_surface_from_equation(entry->equation, NULL, 0, &surface, NULL), entry->name);
    return surface;
}

algsurf_term *rays_terms(const algsurf_surface *surface, size_t *count) {
    *count = algsurf_surface_term_count(surface);
    algsurf_term *terms = must_allocate(*count + 1, sizeof *terms);
    must(algsurf_surface_terms(surface, terms), "terms");
    return terms;
}

algsurf_camera rays_catalogue_camera(const catalogue_entry *entry) {
    algsurf_camera camera;
    must(algsurf_camera_pinhole(entry->eye, entry->look_at, entry->up, entry->fov, &camera), entry->name);
    return camera;
}

algsurf_camera rays_camera(const algsurf_extent *extent) {
    const double distance = 4, half_height = 1.1; /* in radii */
    const double towards[3] = {2, -3, 1.2}, up[3] = {0, 0, 1}, fov = 2 * atan(half_height / distance);
    double length = sqrt(towards[0] * towards[0] + towards[1] * towards[1] + towards[2] * towards[2]), eye[3];
    algsurf_camera camera;
    for (int i = 0; i < 3; i++) eye[i] = extent->centre[i] + distance * extent->size[0] * towards[i] / length;
    must(algsurf_camera_pinhole(eye, extent->centre, up, fov * (180 / acos(-1)), &camera), "camera");
    return camera;
}

algsurf_scene *rays_scene(const algsurf_surface *surface, const algsurf_extent *extent,
                          const algsurf_camera *camera) {
    algsurf_scene *scene;
    must(algsurf_scene_create(surface, &scene), "scene");
    must(algsurf_scene_set_extent(scene, extent), "extent");
    must(algsurf_scene_set_camera(scene, camera), "camera");
    return scene;
}

algsurf_ray rays_ray(const algsurf_camera *camera, int width, int height, int x, int y) {
    algsurf_ray ray;
    must(algsurf_camera_ray(camera, width, height, x + 0.5, y + 0.5, &ray), "ray");
    return ray;
}

int rays_clip(const algsurf_ray *ray, const algsurf_extent *extent, algsurf_ray *chord) {
    int meets;
    must(algsurf_ray_clip(ray, extent, NULL, 0, chord, &meets), "extent");
    return meets;
}

algsurf_ray_packet rays_packet(const algsurf_ray *rays, size_t count) {
    double *room = must_allocate(8 * count, sizeof *room), *t_min = room + 6 * count, *t_max = t_min + count;
    algsurf_ray_packet p = {.size = sizeof p, .count = count, .t_min = t_min, .t_max = t_max};
    for (size_t k = 0; k < 3; k++) {
        double *origin = room + k * count, *direction = room + (3 + k) * count;
        for (size_t i = 0; i < count; i++) origin[i] = rays[i].origin[k], direction[i] = rays[i].direction[k];
        p.origin[k] = origin;
        p.direction[k] = direction;
    }
    for (size_t i = 0; i < count; i++) t_min[i] = rays[i].t_min, t_max[i] = rays[i].t_max;
    return p;
}

void rays_packet_free(const algsurf_ray_packet *packet) { free((void *)packet->origin[0]); }

void rays_expand(const algsurf_surface *surface, const algsurf_ray *chord, double *c) {
    const double middle = 0.5 * (chord->t_min + chord->t_max), half = 0.5 * (chord->t_max - chord->t_min);
    algsurf_ray ray = {.t_min = -1, .t_max = 1};
    for (int i = 0; i < 3; i++) {
        ray.origin[i] = chord->origin[i] + middle * chord->direction[i];
        ray.direction[i] = half * chord->direction[i];
    }
    must(algsurf_expand_power(surface, &ray, c, NULL), "expansion");
}

void rays_polynomials(const catalogue_entry *entry, uint64_t seed, size_t count, double *c) {
    measure_random random = {seed};
    algsurf_surface *surface = rays_surface(entry);
    const algsurf_camera camera = rays_camera(&entry->extent);
    for (size_t done = 0, tries = 0; done < count; tries++) {
        int x = (int)(measure_bits(&random) % WIDTH), y = (int)(measure_bits(&random) % HEIGHT);
        algsurf_ray ray = rays_ray(&camera, WIDTH, HEIGHT, x, y);
        double *p = c + done * (size_t)(entry->degree + 1);
        if (tries > 100 * count + 1000) cli_fail(CLI_BROKEN, "%s: hardly a ray meets it", entry->name);
        if (!rays_clip(&ray, &entry->extent, &ray) || !(ray.t_min < ray.t_max)) continue;
        rays_expand(surface, &ray, p);
        done += p[entry->degree] != 0;
    }
    algsurf_surface_free(surface);
}
