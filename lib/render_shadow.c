/* render_shadow.c - which share of each light reaches a point of the surface.
 *
 * One shadow ray goes to each sample of each light (Cook, Porter, Carpenter 1984, with a regular grid
 * in place of a random one: the same picture every time).  It starts a little above the
 * tangent plane, on the viewer's side, so that the point does not shadow itself.
 */
#include "render_impl.h"
#include "shade_impl.h"
#include "vec.h"

/* The height above the surface: a millionth of what is shown is invisible, and well above the error of
 * a hit's position, which the second term bounds for far eyes and far extents: position and t are
 * rounded to 2^-53, and 2^-48 leaves room for the root's own error. */
static double lift(const algsurf_i_picture *picture, const algsurf_hit *hit) {
    return 1e-6 * picture->radius + 0x1p-48 * (fabs(hit->t) + algsurf_max_abs(hit->position));
}

/* *seen = 1 when nothing of the surface lies between the point and the light's sample (a,b). */
static algsurf_status see_sample(const algsurf_i_picture *picture, const algsurf_light *light, int a, int b,
                                 const double point[3], const double facing[3], int *seen, uint64_t *rays) {
    algsurf_ray ray = {.t_min = 0, .t_max = 1};
    algsurf_hit_state state = ALGSURF_HIT;
    double sample[3];
    algsurf_i_light_sample(light, a, b, sample);
    for (int i = 0; i < 3; i++) {
        ray.origin[i] = point[i];
        ray.direction[i] = sample[i] - point[i];
    }
    *seen = 0;
    if (!(algsurf_dot(ray.direction, facing) > 0)) return ALGSURF_OK; /* behind the tangent plane */
    ++*rays;
    const algsurf_scene *scene = picture->scene;
    algsurf_status status = algsurf_occluded(scene->surface, &scene->extent, &ray, &scene->intersect, &state);
    *seen = state == ALGSURF_MISS;
    return status;
}

static algsurf_status see_light(const algsurf_i_picture *picture, const algsurf_light *light,
                                const double point[3], const double facing[3], double *share,
                                uint64_t *rays) {
    int count = 0, seen;
    for (int b = 0; b < light->samples_v; b++)
        for (int a = 0; a < light->samples_u; a++) {
            algsurf_status status = see_sample(picture, light, a, b, point, facing, &seen, rays);
            if (status < 0) return status;
            count += seen;
        }
    *share = (double)count / (light->samples_u * light->samples_v);
    return ALGSURF_OK;
}

algsurf_status algsurf_i_render_shadows(const algsurf_i_picture *picture, const algsurf_i_pixel *pixel,
                                        double *visible, uint64_t *shadow_rays) {
    double facing[3], point[3], to_light[3], height = lift(picture, &pixel->hit);
    (void)algsurf_i_facing(pixel->hit.normal, pixel->ray.direction, facing);
    for (int i = 0; i < 3; i++) point[i] = pixel->hit.position[i] + height * facing[i];
    for (int l = 0; l < picture->light_count; l++) {
        const algsurf_light *light = &picture->lights[l];
        for (int i = 0; i < 3; i++) to_light[i] = light->position[i] - pixel->hit.position[i];
        visible[l] = 0;
        if (!(algsurf_dot(to_light, facing) > 0)) continue; /* shading ignores a light behind */
        algsurf_status status = see_light(picture, light, point, facing, &visible[l], shadow_rays);
        if (status < 0) return status;
    }
    return ALGSURF_OK;
}
