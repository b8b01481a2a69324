/* leave.c - a point beside a hit, on one side of the surface.
 *
 * Along the normal, or along the ray where there is none, in steps that double until the value of P there
 * exceeds its own error bound with the wanted sign.  The first step is what rounding of P and of the position
 * explains. */
#include "../base/arithmetic.h"
#include "algsurf/intersect.h"

#include <math.h>

#include "../base/fpenv.h"
#include "../base/vec.h"
#include "../surface/impl.h"
#include "region.h"

#define FARTHEST 0x1p-20 /* step, in sizes of the position or of the surface */

/* Where P is sure to have the sign `side`, seen from the hit; 0: there is no direction. */
static int direction_of(const algsurf_ray *ray, const algsurf_hit *hit, int side, double direction[3]) {
    const double *d = algsurf_max_abs(hit->normal) > 0 ? hit->normal : ray->direction;
    const int sign = d == hit->normal ? side : side == hit->side ? -1 : 1;
    if (!algsurf_unit(d, direction)) return 0;
    for (int i = 0; i < 3; i++) direction[i] *= sign;
    return 1;
}

static algsurf_status check(const algsurf_surface *surface, const algsurf_ray *ray, const algsurf_hit *hit,
                            int side, const double *start) {
    if (!surface || !hit || !start || (side != -1 && side != 1)) return ALGSURF_E_ARGUMENT;
    if (hit->state != ALGSURF_STATE_HIT) return ALGSURF_E_ARGUMENT;
    if (!algsurf_is_finite3(hit->position) || !algsurf_is_finite3(hit->normal)) return ALGSURF_E_NOT_FINITE;
    return algsurf_i_ray_check(ray);
}

static algsurf_status leave(const algsurf_surface *surface, const algsurf_ray *ray, const algsurf_hit *hit,
                            int side, double start[3]) {
    double value, bound, x[3], direction[3];
    algsurf_status status = check(surface, ray, hit, side, start);
    if (status != ALGSURF_OK) return status;
    if (!direction_of(ray, hit, side, direction)) return ALGSURF_NOT_VERIFIED;
    const double size = fmax(algsurf_max_abs(hit->position), ldexp(1, surface->unit));
    for (double step = 0x1p-53 * size; step <= FARTHEST * size; step *= 2) {
        for (int i = 0; i < 3; i++) x[i] = hit->position[i] + step * direction[i];
        if (algsurf_surface_value(surface, x, &value, &bound) != ALGSURF_OK || !(side * value > bound))
            continue;
        for (int i = 0; i < 3; i++) start[i] = x[i];
        return ALGSURF_OK;
    }
    return ALGSURF_NOT_VERIFIED;
}

ALGSURF_I_PUBLIC(algsurf_status, hit_leave, leave,
                 (const algsurf_surface *surface, const algsurf_ray *ray, const algsurf_hit *hit, int side,
                  double start[3]),
                 (surface, ray, hit, side, start))
