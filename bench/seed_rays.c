/* seed_rays.c - see seed.h.
 *
 * The root that methods are judged by is found by halving to the last digit, and then proved without regard
 * to how it was found: Descartes' rule, with bounds on all rounding, counts one root within so far of it; and
 * the bracket holds no other.
 */
#include "seed.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

#include "must.h"
#include "rays.h"

static const double FAR = 0x1p-34; /* a thousand times as far as any of the seven surfaces needs */

int seed_chord(const seed_view *view, int pixel, algsurf_ray *chord) {
    const algsurf_ray ray =
        rays_ray(&view->camera, view->width, view->height, pixel % view->width, pixel / view->width);
    return rays_clip(&ray, &view->entry->extent, chord) && chord->t_min < chord->t_max;
}

static void prove_root(seed_ray *ray, int degree, const char *name) {
    algsurf_refined_root found;
    must(seed_solve(&seed_methods[SEED_BISECTION], ray->c, degree, ray->lo, ray->hi, 0, 0, &found), name);
    ray->root = found.root;
    for (ray->radius = 0x1p-50; ray->radius <= FAR; ray->radius *= 4) {
        double lo = fmax(ray->lo, ray->root - ray->radius), hi = fmin(ray->hi, ray->root + ray->radius);
        int roots = 0;
        if (lo == ray->lo && hi == ray->hi) return; /* isolated as it is */
        if (algsurf_count_roots(ray->c, NULL, degree, lo, hi, &roots) == ALGSURF_OK && roots == 1) return;
    }
    cli_fail(CLI_BROKEN, "%s: no root is proved to be near %.17g", name, ray->root);
}

/* The bracket that the paper's halving finds, if it is proved to hold the first root and no other: the
 * library splits where it expects to gain most, and false position would not show what it is known for. */
static void take_half(seed_ray *ray, int degree) {
    double lo, hi;
    int before = 1, inside = 0;
    if (!seed_bare_isolate(ray->c, degree, &lo, &hi)) return;
    if (algsurf_count_roots(ray->c, NULL, degree, -1, lo, &before) != ALGSURF_OK || before > 0) return;
    if (algsurf_count_roots(ray->c, NULL, degree, lo, hi, &inside) != ALGSURF_OK || inside != 1) return;
    ray->lo = lo;
    ray->hi = hi;
}

static void isolate(seed_view *view, seed_ray *ray) {
    algsurf_bracket bracket;
    int found, degree = view->entry->degree;
    algsurf_status status = algsurf_isolate_first(ray->c, NULL, degree, -1, 1, NULL, &bracket, &found);
    must_answer(status, view->entry->name);
    view->undecided += status > 0;
    ray->bracketed = status == ALGSURF_OK && found && bracket.kind == ALGSURF_BRACKET_ISOLATED;
    if (!ray->bracketed) return;
    view->bracketed++;
    ray->lo = bracket.lo;
    ray->hi = bracket.hi;
    take_half(ray, degree);
    prove_root(ray, degree, view->entry->name);
}

void seed_open(seed_view *view, const char *name, int width, int height) {
    const catalogue_entry *entry = catalogue_find(name);
    *view = (seed_view){.entry = entry,
                        .width = width,
                        .height = height,
                        .surface = rays_surface(entry),
                        .camera = rays_catalogue_camera(entry)};
    view->rays = must_allocate((size_t)width * (size_t)height, sizeof *view->rays);
    for (int pixel = 0; pixel < width * height; pixel++) {
        algsurf_ray chord;
        if (!seed_chord(view, pixel, &chord)) continue;
        seed_ray *ray = &view->rays[view->count++];
        ray->pixel = pixel;
        rays_expand(view->surface, &chord, ray->c);
        isolate(view, ray);
    }
}

void seed_close(seed_view *view) {
    algsurf_surface_free(view->surface);
    free(view->rays);
}

/* Horner's rule: |error of p| <= 2 n u p~(|x|), p~ the polynomial of magnitudes. */
static double noise(const double *c, int degree, double x) {
    double magnitudes = 0, slope;
    for (int i = degree; i >= 0; i--) magnitudes = magnitudes * fabs(x) + fabs(c[i]);
    (void)seed_value(c, degree, x, &slope);
    return degree * DBL_EPSILON * magnitudes / fabs(slope);
}

double seed_allowed(const seed_view *view, const seed_ray *ray, double tolerance) {
    double width = 2 * (tolerance + 0x1p-51 * fabs(ray->root));
    return width + ray->radius + 2 * noise(ray->c, view->entry->degree, ray->root);
}
