/* rays.c - see rays.h.
 *
 * A ray is re-centred before it is expanded: its origin becomes the middle of the chord, its direction half
 * the chord.  Solvers that count on a unit interval get one, and none is judged by what a far eye does to it.
 */
#include "rays.h"

#include <math.h>

#include "cli.h"
#include "measure.h"
#include "must.h"

enum { WIDTH = 1024, HEIGHT = 768 };

void rays_camera(const algsurf_extent *extent, algsurf_camera *camera) {
    const double distance = 4, half_height = 1.1; /* in radii */
    const double towards[3] = {2, -3, 1.2}, up[3] = {0, 0, 1};
    double length = sqrt(towards[0] * towards[0] + towards[1] * towards[1] + towards[2] * towards[2]), eye[3];
    for (int i = 0; i < 3; i++) eye[i] = extent->centre[i] + distance * extent->size[0] * towards[i] / length;
    must(algsurf_camera_pinhole(eye, extent->centre, up, 2 * atan(half_height / distance) * (180 / acos(-1)),
                                camera),
         "camera");
}

/* 0 when the ray of that pixel has no chord, or a polynomial of a lower degree. */
static int expand(const algsurf_surface *surface, const algsurf_extent *extent, const algsurf_camera *camera,
                  int x, int y, double *c) {
    algsurf_ray ray;
    int meets;
    must(algsurf_camera_ray(camera, WIDTH, HEIGHT, x + 0.5, y + 0.5, &ray), "ray");
    must(algsurf_ray_clip(&ray, extent, NULL, 0, &ray, &meets), "extent");
    if (!meets || !(ray.t_min < ray.t_max)) return 0;
    for (int i = 0; i < 3; i++) {
        ray.origin[i] += 0.5 * (ray.t_min + ray.t_max) * ray.direction[i];
        ray.direction[i] *= 0.5 * (ray.t_max - ray.t_min);
    }
    must(algsurf_expand_power(surface, &ray, c, NULL), "expansion");
    return c[algsurf_surface_degree(surface)] != 0;
}

void rays_polynomials(const catalogue_entry *entry, uint64_t seed, size_t count, double *c) {
    measure_random random = {seed};
    algsurf_surface *surface;
    algsurf_camera camera;
    must(algsurf_surface_from_equation(entry->equation, NULL, 0, &surface, NULL), entry->name);
    rays_camera(&entry->extent, &camera);
    for (size_t done = 0, tries = 0; done < count; tries++) {
        int x = (int)(measure_bits(&random) % WIDTH), y = (int)(measure_bits(&random) % HEIGHT);
        if (tries > 100 * count + 1000) cli_fail(CLI_BROKEN, "%s: hardly a ray meets it", entry->name);
        done +=
            (size_t)expand(surface, &entry->extent, &camera, x, y, c + done * (size_t)(entry->degree + 1));
    }
    algsurf_surface_free(surface);
}
