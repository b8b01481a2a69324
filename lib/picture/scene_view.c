/* scene_view.c - a scene's camera and extent as a view (surface/view.h), so that whole rows can be solved
 * side by side.
 *
 * The plane of u and v goes through the extent's centre; the eye is at (e_x, e_y, -D) in the view's unit.
 * A pinhole's ray with slopes (p, q) is at u = e_x + D p, v = e_y + D q, with alpha = 1/D, beta = -e/D.
 *
 * Noise.  A pixel's ray is, by definition, that of algsurf_camera_ray, rounded.  Noise bounds how far that
 * ray is, in each of x, y, z, from the one that is computed with, and how far u, v and the slopes of the
 * latter are from exact ones.  Let s be the largest |p| + |q| of the picture and o = |e_x| + |e_y|.
 * - The rounded ray: x + sx, or (x + 1/2) / n of n samples side by side, rounds to 2 u s, as x may be twice
 * as large as the distance from the picture's centre; two more roundings give p.  The direction, of length L
 *   before it is made a unit, is off by u (2 |p| + 2 |q| + 2 L) more, L <= 1 + |p| + |q|.  That is
 *   u (2 + 8 s) in all, and at the far end of the extent D + 1 times as much.
 * - Computing with it: D p takes eight roundings (the pixel's place two, a third where samples are side by
 *   side, two factors, D two, the sum), which with those of e_x come to 8 u s D + 3 u o.  The slope alpha u +
 *   beta inherits that, divided by D; alpha takes three roundings, beta five, the slope itself two:
 *   u (5 s + 11 o / D).  Together, at the far end, u (8 s (D + 1) + 5 s) + u o (3 + 14 / D).
 * - A parallel ray's direction is exact.  Its origin is off by u (|eye| + 7 s), its u by u (7 s + 3 o); s and
 *   the eye in the view's unit.
 * noise_of rounds these up.  All else is what is left when the eye is put together again from its rounded
 * coordinates, measured. */
#include "../base/arithmetic.h"
#include <stdlib.h>

#include "../base/eft.h"
#include "../base/elementary.h"
#include "../rays/intersect_impl.h"
#include "../rays/region.h"
#include "impl.h"
#include "../base/vec.h"

/* A centre of the extent and a distance of the eye in natural units: 1 if both are exact. */
static int natural(const algsurf_surface *s, const double from[3], double to[3]) {
    for (int i = 0; i < 3; i++) {
        to[i] = ldexp(from[i], -s->unit);
        if (ldexp(to[i], s->unit) != from[i]) return 0;
    }
    return 1;
}

/* Coordinates of `point` in the view's axes; returns a bound on each component of what they miss. */
static double in_axes(const algsurf_i_view *view, const algsurf_dd point[3], double place[3]) {
    double missed = 0;
    for (int k = 0; k < 3; k++) place[k] = 0;
    for (int round = 0; round < 3; round++) {
        algsurf_dd rest[3];
        for (int i = 0; i < 3; i++) {
            rest[i] = point[i];
            for (int k = 0; k < 3; k++)
                rest[i] = algsurf_dd_sub(rest[i], algsurf_two_prod(place[k], view->axis[k][i]));
        }
        double left[3] = {rest[0].hi, rest[1].hi, rest[2].hi};
        missed = 2 * algsurf_length(left);
        for (int k = 0; k < 3 && round < 2; k++) place[k] += algsurf_dot(left, view->axis[k]);
    }
    return missed;
}

static double noise_of(const algsurf_i_geometry *p, const double eye[3], const double place[3],
                       double slopes) {
    double offset = fabs(place[0]) + fabs(place[1]), distance = fabs(place[2]);
    if (!p->orthographic)
        return ALGSURF_U * ((4 + 24 * slopes) * (distance + 1) + offset * (8 + 16 / distance));
    return ALGSURF_U *
           (8 * (algsurf_max_abs(eye) / p->frame.view.size + offset + 2 * p->rays.du * slopes + 2));
}

#define WHOLE 1.5 /* of the surface's size: see size_of_space */
#define MORE 12   /* so many bits of P's terms may that cost */

static void place_eye(algsurf_i_geometry *p, const algsurf_i_picture *picture, const double eye[3]) {
    const algsurf_camera *camera = &picture->scene->camera;
    algsurf_i_view *view = &p->frame.view;
    algsurf_dd away[3];
    double place[3], pixel = camera->half_height / (0.5 * picture->height);
    for (int i = 0; i < 3; i++) away[i] = algsurf_two_sum(eye[i], -view->centre[i]);
    double missed = in_axes(view, away, place) / view->size;
    for (int k = 0; k < 3; k++) place[k] /= view->size;
    p->rays.near = place[2];
    p->rays.u0 = place[0];
    p->v0 = place[1];
    p->rays.du = p->orthographic ? ldexp(1, -picture->scene->surface->unit) / view->size : -place[2];
    for (int k = 0; k < 2; k++) view->beta[k] = p->orthographic ? 0 : place[k] / place[2];
    view->alpha = p->orthographic ? 0 : -1 / place[2];
    p->rays.pixel = pixel;
    view->noise = noise_of(p, eye, place, 0.5 * pixel * (picture->width + picture->height)) + missed;
}

/* Is the scene one for views: the default method, axes of length 1, in all of space real roots? */
static int suits_views(const algsurf_scene *scene) {
    const algsurf_camera *camera = &scene->camera;
    return !(scene->complex && scene->extent.kind == ALGSURF_EXTENT_ALL) &&
           abs(scene->surface->unit) <= 1000 && scene->surface->degree >= 1 &&
           scene->surface->degree <= ALGSURF_MAX_VIEW_DEGREE &&
           (scene->complex ||
            (scene->intersect.method == ALGSURF_METHOD_DEFAULT && scene->intersect.max_iterations == 0)) &&
           algsurf_are_orthonormal(camera->right, camera->up, camera->forward, 0x1p-48);
}

/* All of space: the view holds what is near the origin, where lines have their roots; and all of the
 * picture's rays, and the eye of a surface that goes on behind it, if that costs few digits.  What is beyond
 * is looked at by proofs (pixels_template.h): so this is a choice about time. */
static double size_of_space(const algsurf_i_picture *picture, const double eye[3]) {
    const algsurf_camera *camera = &picture->scene->camera;
    const algsurf_surface *s = picture->scene->surface;
    double slope = camera->half_height * fmax(1, (double)picture->width / picture->height);
    double aside = fmax(fabs(algsurf_dot(eye, camera->right)), fabs(algsurf_dot(eye, camera->up)));
    double away = fabs(algsurf_dot(eye, camera->forward)), more = algsurf_i_exp2(MORE / s->degree);
    double size = s->spread * (s->goes_far ? more : WHOLE);
    double across = algsurf_i_is_orthographic(camera) ? ldexp(slope, -s->unit) : away * slope;
    double most = algsurf_i_is_orthographic(camera) ? 4 : 4 - slope - 2 * aside / away;
    double all = most > 0 ? 1.1 * (aside + across) / most : HUGE_VAL;
    if (s->goes_far && !(1.02 * away < all)) all = 1.02 * away;
    return all > size && all < more * size ? all : size;
}

/* P's degree along the picture's rays, at most. */
static int degree_along(const algsurf_surface *s, const algsurf_camera *camera) {
    const double *d = camera->forward;
    return algsurf_i_is_orthographic(camera) ? s->degree_in[(d[0] != 0) + 2 * (d[1] != 0) + 4 * (d[2] != 0)]
                                             : s->degree;
}

/* Planes that keep all of what is shown are left out.  Returns 0 where the distance of one
 * from the centre is not known well enough.
 *   Errors: the distance has a few roundings of its terms; a normal of length 1 is off by some 2^-51 in each
 * component, which points of size 4 or less take along, and their sum with it: 2^-46 in all. */
static int place_planes(const algsurf_scene *scene, algsurf_i_geometry *p) {
    const algsurf_i_view *view = &p->frame.view;
    int count = 0;
    for (size_t i = 0; i < scene->intersect.plane_count; i++) {
        const algsurf_plane plane =
            algsurf_i_plane_in_unit(scene->intersect.planes + i, scene->surface->unit);
        algsurf_i_cut_plane *world = &p->planes[count], *in_view = &p->view_planes[count];
        const double *n = plane.normal, *c = view->centre;
        double unit = algsurf_length(n) * view->size;
        double size = fabs(plane.offset) + (fabs(n[0] * c[0]) + fabs(n[1] * c[1]) + fabs(n[2] * c[2]));
        world->offset = (plane.offset - algsurf_dot(n, c)) / unit;
        world->error = 0x1p-50 * size / unit + 0x1p-46;
        if (world->offset > 6 && world->error <= 0.5 * world->offset) continue;
        if (!(world->error < 0x1p-30)) return 0;
        (void)algsurf_unit(n, world->normal);
        *in_view = *world;
        for (int k = 0; k < 3; k++) in_view->normal[k] = algsurf_dot(view->axis[k], world->normal);
        count++;
    }
    p->rays.planes = p->view_planes;
    p->rays.plane_count = count;
    return 1;
}

/* What kernels need to know of complex space; 0: the sector is not one for them. */
static int place_complex_space(const algsurf_scene *scene, algsurf_i_geometry *p) {
    const algsurf_surface *s = scene->surface;
    p->top = algsurf_i_top_imaginary(&scene->space, s->degree);
    for (int k = 0; k <= p->top; k++)
        p->imaginary[k] = ldexp(scene->space.imaginary[k], s->scale + k * s->unit);
    p->frame.view.noise *= 4; /* complex_pixels_template.h */
    return algsurf_i_sector_edges_of(&scene->space.sector, &p->sector);
}

int algsurf_i_find_geometry(const algsurf_i_picture *picture, algsurf_i_geometry *p) {
    const algsurf_scene *scene = picture->scene;
    const algsurf_camera *camera = &scene->camera;
    algsurf_i_view *view = &p->frame.view;
    const int endless = scene->extent.kind == ALGSURF_EXTENT_ALL;
    const double origin[3] = {0, 0, 0};
    algsurf_extent wider = scene->extent;
    const algsurf_extent *extent =
        scene->complex ? &scene->extent : algsurf_i_without_own_ball(scene->surface, &scene->extent, &wider);
    double eye[3], radius = extent == &wider ? wider.size[0] : picture->lighting.radius;
    if (!suits_views(scene) || !natural(scene->surface, camera->eye, eye) ||
        !natural(scene->surface, endless ? origin : scene->extent.centre, view->centre))
        return 0;
    for (int i = 0; i < 3; i++) {
        view->axis[0][i] = camera->right[i];
        view->axis[1][i] = camera->up[i];
        view->axis[2][i] = camera->forward[i];
    }
    view->size = endless ? size_of_space(picture, eye) : ldexp(radius * (1 + 0x1p-20), -scene->surface->unit);
    p->rays = (algsurf_i_row_job){.view = view,
                                  .offset = -0.5 * picture->width,
                                  .extent = &scene->extent,
                                  .degree = degree_along(scene->surface, camera),
                                  .thin_bends = p->thin_bends};
    p->orthographic = algsurf_i_is_orthographic(camera);
    p->taylor = (algsurf_i_taylor){.usable = 0};
    place_eye(p, picture, eye);
    for (int i = 0; i < 3; i++)
        p->rays.extent_size[i] = endless ? 1 : ldexp(extent->size[i], -scene->surface->unit) / view->size;
    if (scene->complex && !place_complex_space(scene, p)) return 0;
    /* a depth of 1 is at most this much of t */
    p->rays.tolerance = scene->intersect.absolute_tolerance / ldexp(view->size, scene->surface->unit);
    return place_planes(scene, p) && view->size > 0x1p-500 && view->size < 0x1p500 &&
           fabs(p->rays.near) > 0x1p-10 && !(endless && p->rays.near > 0.5) &&
           view->noise * scene->surface->degree < 0x1p-22;
}
