/* chord.c - see chord.h. */
#include "chord.h"

#include <math.h>

algsurf_status chord_make(const algsurf_surface *surface, const algsurf_extent *extent,
                          const algsurf_plane *planes, size_t count, const algsurf_ray *ray, chord *result,
                          int *meets) {
    algsurf_ray inside, centred = {.t_min = -1, .t_max = 1};
    algsurf_status status = algsurf_ray_clip(ray, extent, planes, count, &inside, meets);
    if (status != ALGSURF_OK || !*meets) return status;
    chord c = {.t_in = inside.t_min, .t_out = inside.t_max, .degree = algsurf_surface_degree(surface)};
    c.half = 0.5 * (c.t_out - c.t_in);
    c.middle = c.t_in + c.half;
    *meets = 0;
    if (!(c.half > 0x1p-40 * fmax(fabs(c.t_in), fabs(c.t_out)))) return ALGSURF_OK; /* of rounding outward */
    for (int i = 0; i < 3; i++) {
        centred.origin[i] =
            fma(c.middle, ray->direction[i], ray->origin[i]); /* one rounding, of the result */
        centred.direction[i] = c.half * ray->direction[i];
        if (centred.direction[i] != 0) *meets = 1;
    }
    if (!*meets) return ALGSURF_OK;
    status = algsurf_expand_power(surface, &centred, c.c, c.r);
    if (status == ALGSURF_OK) *result = c;
    return status;
}

double chord_t(const chord *c, double s) {
    if (s == -1) return c->t_in;
    return s == 1 ? c->t_out : fma(c->half, s, c->middle);
}

double chord_s(const chord *c, double t) { return fmax(-1, fmin(1, (t - c->middle) / c->half)); }
