/* accuracy_truth.c - see accuracy.h.
 *
 * The certified tier tells which rays hit, and an interval that isolates the first root.  What judges t to
 * its last digit is made here, with no more of the library than the gradient, and proved: P is evaluated
 * from its terms in double-double, t is polished by Newton's method, and P has certain, opposite signs at
 * t - error and t + error.  That no root comes before is looked at too, though not proved: P has no certain
 * sign other than the first at a few places from the beginning of the chord to the root, or to its end.
 */
#include "accuracy.h"

#include <math.h>
#include <stdlib.h>

#include "must.h"
#include "rays.h"
#include "twofold.h"

enum { SAMPLES = 24, NEWTON_STEPS = 8 };

/* ---- P ---- */

typedef struct evaluation {
    twofold p;
    double bound; /* |p - exact| <= bound */
} evaluation;

/* P at origin + t direction.  Every monomial goes through at most degree + 4 products, the sum through
 * term_count additions, each off by at most 7 u^2; a coordinate x is off by less than 9 u^2 far, far =
 * |origin| + |t direction|, hence by 9 u^2 2^10 X, X = |x| + 2^-10 far, which counts degree times.  All of it
 * is relative to the sum of |a| X^i Y^j Z^k, and doubled for what is of higher order. */
static evaluation value_at(const view *v, const algsurf_ray *ray, twofold t) {
    twofold power[3][ALGSURF_MAX_DEGREE + 1];
    double size[3][ALGSURF_MAX_DEGREE + 1], total = 0;
    int degree = algsurf_surface_degree(v->surface);
    for (int k = 0; k < 3; k++) {
        twofold x = add(twice(ray->origin[k]), multiply(t, twice(ray->direction[k])));
        double far = fabs(ray->origin[k]) + fabs(t.hi * ray->direction[k]),
               large = fabs(x.hi) + 0x1p-10 * far;
        power[k][0] = twice(1);
        size[k][0] = 1;
        for (int n = 1; n <= degree; n++) {
            power[k][n] = multiply(power[k][n - 1], x);
            size[k][n] = size[k][n - 1] * large;
        }
    }
    twofold p = {0, 0};
    for (const algsurf_term *a = v->terms; a < v->terms + v->term_count; a++) {
        twofold term = multiply(multiply(power[0][a->i], power[1][a->j]), power[2][a->k]);
        p = add(p, multiply(twice(a->a), term));
        total += fabs(a->a) * size[0][a->i] * size[1][a->j] * size[2][a->k];
    }
    return (evaluation){p,
                        (7 * ((double)v->term_count + degree + 4) + 9 * 0x1p10 * degree) * 0x1p-105 * total};
}

/* -1 or 1; 0: not certain. */
static int sign_at(const view *v, const algsurf_ray *ray, twofold t) {
    evaluation at = value_at(v, ray, t);
    return at.p.hi > at.bound ? 1 : at.p.hi < -at.bound ? -1 : 0;
}

double view_noise(const view *v, size_t i, double t) {
    const algsurf_ray *ray = &v->ray[i];
    double size[3], total = 0;
    for (int k = 0; k < 3; k++) size[k] = fabs(fma(t, ray->direction[k], ray->origin[k]));
    for (const algsurf_term *a = v->terms; a < v->terms + v->term_count; a++)
        total += fabs(a->a) * pow(size[0], a->i) * pow(size[1], a->j) * pow(size[2], a->k);
    return fabs(value_at(v, ray, twice(t)).p.hi) / (0x1p-53 * total);
}

/* ---- the truth about a ray ---- */

/* P' along the ray, approximately. */
static double slope_at(const view *v, const algsurf_ray *ray, double t) {
    double point[3], gradient[3], value, slope = 0;
    for (int k = 0; k < 3; k++) point[k] = fma(t, ray->direction[k], ray->origin[k]);
    must(algsurf_surface_gradient(v->surface, point, &value, gradient, NULL, NULL), v->entry->name);
    for (int k = 0; k < 3; k++) slope += gradient[k] * ray->direction[k];
    return slope;
}

static twofold polish(const view *v, const algsurf_ray *ray, twofold t) {
    for (int i = 0; i < NEWTON_STEPS; i++) {
        double step = value_at(v, ray, t).p.hi / slope_at(v, ray, t.hi);
        if (!isfinite(step)) break;
        t = add(t, twice(-step));
    }
    return t;
}

/* Widens an interval about the polished root until its ends prove that there is one. */
static void prove(const view *v, const algsurf_ray *ray, truth *known) {
    twofold t = polish(v, ray, twice(known->t));
    double most = 0x1p-56 * fabs(known->t), error = 0x1p-90 * fabs(known->t);
    for (; error <= most; error *= 4) {
        int below = sign_at(v, ray, add(t, twice(-error))), above = sign_at(v, ray, add(t, twice(error)));
        if (below * above >= 0) continue;
        known->t = t.hi;
        known->rest = t.lo;
        known->error = error;
        return;
    }
    known->error = INFINITY;
}

/* Does P change its sign before the root? */
static int changes_before(const view *v, const algsurf_ray *chord, const truth *known) {
    double end = known->state == ALGSURF_STATE_MISS ? chord->t_max : known->lo;
    int first = 0;
    for (int i = 0; i <= SAMPLES; i++) {
        double t = chord->t_min + (end - chord->t_min) * i / SAMPLES;
        int sign = sign_at(v, chord, twice(t));
        if (sign * first < 0) return 1;
        if (first == 0) first = sign;
    }
    return 0;
}

static void find_truth(view *v, const algsurf_ray *ray, const algsurf_ray *chord, truth *known) {
    const char *name = v->entry->name;
    algsurf_intersect_options bounded = {.size = sizeof bounded, .tier = ALGSURF_TIER_BOUNDED};
    algsurf_hit hit, by_doubles;
    must(algsurf_intersect_first(v->surface, &v->entry->extent, ray, NULL, &hit), name);
    must(algsurf_intersect_first(v->surface, &v->entry->extent, ray, &bounded, &by_doubles), name);
    *known = (truth){.state = hit.state,
                     .left_open = by_doubles.state == ALGSURF_STATE_UNDECIDED,
                     .lo = hit.t_lo,
                     .hi = hit.t_hi,
                     .t = hit.t,
                     .error = INFINITY};
    v->open += hit.state == ALGSURF_STATE_UNDECIDED;
    if (changes_before(v, chord, known)) cli_fail(CLI_BROKEN, "%s: a root before the first hit", name);
    if (hit.state != ALGSURF_STATE_HIT) return;
    prove(v, ray, known);
    v->hits++;
    if (isinf(known->error)) {
        v->unproved++;
        return;
    }
    v->worst = fmax(v->worst, known->error);
    if (!(known->t + known->error >= known->lo && known->t - known->error <= known->hi))
        cli_fail(CLI_BROKEN, "%s: the root at %.17g is outside of [%.17g, %.17g]", name, known->t, known->lo,
                 known->hi);
}

/* ---- the rays ---- */

static void add_ray(view *v, int x, int y, int taken) {
    const algsurf_ray ray = rays_ray(&v->camera, v->width, v->height, x, y);
    algsurf_ray chord;
    if (!rays_clip(&ray, &v->entry->extent, &chord)) return;
    v->all_rays++;
    if (!taken) return;
    v->pixel[v->count] = (size_t)y * (size_t)v->width + (size_t)x;
    v->ray[v->count] = ray;
    v->chord[v->count] = chord;
    find_truth(v, &ray, &chord, &v->truth[v->count]);
    v->count++;
}

/* Whether the row is the middle one of as many strips as rows are wanted. */
static int is_taken(int y, int rows, int height) {
    long strip = (long)y * rows / height, middle = ((2 * strip + 1) * height) / (2L * rows);
    return y == middle;
}

view *view_open(const catalogue_entry *entry, int width, int height, int rows) {
    view *v = must_allocate(1, sizeof *v);
    size_t room = (size_t)width * (size_t)rows;
    if (entry->extent.kind != ALGSURF_EXTENT_SPHERE)
        cli_fail(CLI_BROKEN, "%s: not inside a sphere", entry->name);
    *v = (view){.entry = entry, .surface = rays_surface(entry), .width = width, .height = height};
    v->terms = rays_terms(v->surface, &v->term_count);
    v->camera = rays_catalogue_camera(entry);
    v->pixel = must_allocate(room, sizeof *v->pixel);
    v->ray = must_allocate(room, sizeof *v->ray);
    v->chord = must_allocate(room, sizeof *v->chord);
    v->truth = must_allocate(room, sizeof *v->truth);
    for (int y = 0; y < height; y++)
        for (int x = 0; x < width; x++) add_ray(v, x, y, is_taken(y, rows, height));
    if (v->hits == 0) cli_fail(CLI_BROKEN, "%s: no ray hits it", entry->name);
    if (v->unproved > v->hits / 100) cli_fail(CLI_BROKEN, "%s: hits that cannot be proved", entry->name);
    return v;
}

void view_close(view *v) {
    algsurf_surface_free(v->surface);
    free(v->terms);
    free(v->pixel);
    free(v->ray);
    free(v->chord);
    free(v->truth);
    free(v);
}
