/* render_rounding.c - see render_rounding.h.
 *
 * The bounded tier, with the error that the rounding may have made, leaves a ray undecided where it cannot
 * tell what all surfaces within that error have in common; its bounds hold for the whole ray, and are far too
 * large where P is small and elsewhere large.  So points of such a place are looked at: may P be 0 there, for
 * another surface?  If not, or if all of them cross the ray within a pixel, nothing changes.  Nothing is
 * proved. */
#include "render_rounding.h"

#include <math.h>

enum { COLUMNS = 48, ROWS = 36, POINTS = 8, ROUNDS = 16 };
static const double PIXEL = 1.0 / 500; /* of the picture's height */
static const double FEW = 8;           /* times the error of P: what a point near the place must exceed */

typedef struct surfaces {
    const algsurf_surface *exact, *with_error;
} surfaces;

/* P at a point of the ray, in units of what rounding may change it by: all surfaces within the error have the
 * same sign there if its magnitude is above 1.  0 if it cannot be told. */
static double certainty(const surfaces *s, const algsurf_ray *ray, double t) {
    double point[3], value, bound, own_bound;
    for (int i = 0; i < 3; i++) point[i] = ray->origin[i] + t * ray->direction[i];
    if (algsurf_surface_value(s->exact, point, &value, &own_bound) != ALGSURF_OK ||
        algsurf_surface_value(s->with_error, point, &value, &bound) != ALGSURF_OK)
        return 0;
    return value / fmax(FEW * (bound - own_bound), 0x1p-1000);
}

/* Do all surfaces within the error cross the ray, from side to side, between these points? */
static int is_crossed(const surfaces *s, const algsurf_ray *ray, double lo, double hi) {
    double before = certainty(s, ray, lo), behind = certainty(s, ray, hi);
    return fmin(before, behind) < -1 && fmax(before, behind) > 1;
}

/* May P be 0 in [lo,hi] for some surfaces, and for others not within a pixel?  Points are looked at, and then
 * closer ones about the least. */
static int may_vanish(const surfaces *s, const algsurf_ray *ray, double lo, double hi, double pixel) {
    for (int round = 0; round < ROUNDS; round++) {
        double least = HUGE_VAL, step = (hi - lo) / POINTS, at = lo;
        for (int i = 0; i < POINTS; i++) {
            double t = lo + (i + 0.5) * step, size = fabs(certainty(s, ray, t));
            if (size <= 1) return !is_crossed(s, ray, t - 0.5 * pixel, t + 0.5 * pixel);
            if (size < least) least = size, at = t;
        }
        lo = at - step, hi = at + step;
    }
    return 0;
}

/* Is something else seen at this place of the ray, by rounding? */
static int place_changes(const surfaces *s, const algsurf_ray *ray, const algsurf_hit *place, double pixel) {
    double lo = place->t_lo, hi = place->t_hi;
    if (place->state == ALGSURF_STATE_HIT && hi - lo < pixel) return 0;
    return may_vanish(s, ray, lo, hi, pixel);
}

static int is_changed(const surfaces *s, const view *shown) {
    const algsurf_intersect_options how = {.size = sizeof how, .tier = ALGSURF_TIER_BOUNDED};
    algsurf_camera camera;
    algsurf_ray ray;
    algsurf_hit hit;
    int seen = 0, changed = 0;
    if (view_make_camera(shown, 0, 1, &camera) != ALGSURF_OK) return 0;
    for (int y = 0; y < ROWS; y++)
        for (int x = 0; x < COLUMNS; x++) {
            if (algsurf_camera_ray(&camera, COLUMNS, ROWS, x + 0.5, y + 0.5, &ray) != ALGSURF_OK ||
                algsurf_intersect_first(s->with_error, &shown->extent, &ray, &how, &hit) != ALGSURF_OK)
                return 0;
            if (hit.state == ALGSURF_STATE_MISS) continue;
            double away = camera.kind == ALGSURF_CAMERA_PINHOLE ? hit.t : 1;
            changed += place_changes(s, &ray, &hit, 2 * camera.half_height * PIXEL * away);
            seen++;
        }
    return 20 * changed > seen;
}

void render_tell_of_rounding(const algsurf_surface *surface, const view *shown) {
    double error = algsurf_surface_rounding(surface);
    algsurf_surface *with_error = NULL;
    if (error > 0 && algsurf_surface_with_error(surface, error, &with_error) == ALGSURF_OK &&
        is_changed(&(surfaces){surface, with_error}, shown))
        cli_complain(
            "the coefficients are rounded to doubles, which visibly changes this surface: place it nearer to "
            "the origin");
    algsurf_surface_free(with_error);
}
