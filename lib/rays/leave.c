/* leave.c - a point beside a hit, on one side of the surface.
 *
 * Along the normal, or along the ray where there is none, to where the value of P exceeds its own error bound
 * with the wanted sign.  By the gradient, the first step leads to a value of PLAIN such bounds: then doubles
 * know the sign on rays that start there, too, over whose whole length their errors are larger.  If the sign
 * is not as wanted there, steps double, then halve. */
#include "../base/arithmetic.h"
#include "algsurf/intersect.h"

#include <math.h>

#include "../base/fpenv.h"
#include "../base/vec.h"
#include "../surface/impl.h"
#include "region.h"

#define PLAIN 0x1p10
#define FARTHEST 0x1p-20 /* step, in sizes of the position or of the surface */
#define NEAREST 0x1p-53

/* Where P is sure to have the sign `side`, seen from the hit; 0: there is no direction. */
static int direction_of(const algsurf_ray *ray, const algsurf_hit *hit, int side, double direction[3]) {
    const double *d = algsurf_max_abs(hit->normal) > 0 ? hit->normal : ray->direction;
    const int sign = d == hit->normal ? side : side == hit->side ? -1 : 1;
    if (!algsurf_unit(d, direction)) return 0;
    for (int i = 0; i < 3; i++) direction[i] *= sign;
    return 1;
}

/* In sizes. */
static double first_step(const algsurf_surface *surface, const double position[3], double size) {
    double value, bound, gradient[3];
    algsurf_status status = algsurf_surface_gradient(surface, position, &value, gradient, &bound, NULL);
    double step = PLAIN * (bound + fabs(value)) / (algsurf_max_abs(gradient) * size);
    return status == ALGSURF_OK && step < FARTHEST ? fmax(step, NEAREST) : FARTHEST;
}

/* Is the sign at x `side`, or with side 0, is it sure? */
static int is_beside(const algsurf_surface *surface, const double x[3], int side) {
    double value, bound;
    return algsurf_surface_value(surface, x, &value, &bound) == ALGSURF_OK &&
           (side ? side * value : fabs(value)) > bound;
}

ALGSURF_I_ENTRY(algsurf_status, hit_leave,
                (const algsurf_surface *given, const algsurf_ray *ray, const algsurf_hit *hit, int side,
                 double start[3]),
                (given, ray, hit, side, start)) {
    double x[3], direction[3];
    if (!given || !hit || !start || (side != -1 && side != 1)) return ALGSURF_E_ARGUMENT;
    if (hit->state != ALGSURF_STATE_HIT) return ALGSURF_E_ARGUMENT;
    if (!algsurf_is_finite3(hit->position) || !algsurf_is_finite3(hit->normal)) return ALGSURF_E_NOT_FINITE;
    algsurf_status status = algsurf_i_ray_check(ray);
    if (status != ALGSURF_OK) return status;
    const algsurf_surface *surface = algsurf_i_surface_solved(given);
    const int front = algsurf_i_surface_front(given);
    if (front && side != front) return ALGSURF_NOT_VERIFIED;
    if (!direction_of(ray, hit, side, direction)) return ALGSURF_NOT_VERIFIED;
    const double size = fmax(algsurf_max_abs(hit->position), ldexp(1, surface->unit)),
                 first = first_step(surface, hit->position, size);
    double step = first, factor = 2;
    while (step >= NEAREST) {
        for (int i = 0; i < 3; i++) x[i] = hit->position[i] + step * size * direction[i];
        if (is_beside(surface, x, front ? 0 : side)) {
            for (int i = 0; i < 3; i++) start[i] = x[i];
            return ALGSURF_OK;
        }
        step *= factor;
        if (step > FARTHEST) step = 0.5 * first, factor = 0.5;
    }
    return ALGSURF_NOT_VERIFIED;
}
