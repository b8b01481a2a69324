/* planes.c - where a ray crosses a plane, between which doubles.
 *
 * The plane keeps n.X <= c.  Along the ray n.X - c = a + t b with a = n.o - c and b = n.d: it is crossed at
 * t = -a / b.  Normal, direction, and lengths are brought to about 1 by powers of two of their own.
 *
 * Roundings.  a has six summands' worth of them at most, b five: they are off by less than 2^-50 of the sizes
 * of their terms, and by LOST where components underflow on the way to their unit.  If b is more than four
 * times its error e_b, the exact b is at least 3/4 of it, and t is off by at most
 *     (e_a + |t| e_b) / |b| * 4/3, and two roundings of t:  2 (e_a + |t| e_b) / |b| + 2^-50 |t|  is more.
 * A ray along the plane has a sure sign where |a| exceeds e_a and what t b can be at its ends; else the plane
 * may be anywhere on it, and integers are asked.  Where each n_i d_i is 0, b is, too, whatever t.
 *
 * How far beyond the plane a cut ray may reach: let s = |c| + sum |n_i| (|o_i| + |t d_i|) for the largest |t|
 * before the cut.  An end that is moved is beyond the plane by at most twice the error of t above, so that
 *     n.X - c <= 5/4 |b| 2 (2 (e_a + |t| e_b) / |b| + 2^-50 |t|) <= 5 2^-50 s + 5/2 2^-50 |a| < 2^-47 s.
 * If the ray is along the plane and not cut, a is at most 2 (e_a + |t| (|b| + e_b)) and |b| at most 4 e_b;
 * with the errors of both, n.X - c < 3 e_a + 15 |t| e_b < 2^-46 s. */
#include "../base/arithmetic.h"
#include "region.h"

#include <float.h>
#include <math.h>

#include "../base/vec.h"

#define ROUNDED 0x1p-50
#define LOST 0x1p-1000

algsurf_status algsurf_i_planes_check(const algsurf_plane *planes, size_t count) {
    if (count > ALGSURF_MAX_CLIP_PLANES || (count > 0 && !planes)) return ALGSURF_E_ARGUMENT;
    for (size_t i = 0; i < count; i++) {
        if (!algsurf_is_finite3(planes[i].normal) || !isfinite(planes[i].offset)) return ALGSURF_E_NOT_FINITE;
        if (!(algsurf_max_abs(planes[i].normal) > 0)) return ALGSURF_E_ARGUMENT;
    }
    return ALGSURF_OK;
}

static int exponent_of(double x) {
    int e;
    (void)frexp(x, &e);
    return e;
}

algsurf_plane algsurf_i_plane_in_unit(const algsurf_plane *plane, int exponent) {
    int e = exponent_of(algsurf_max_abs(plane->normal));
    algsurf_plane scaled = {.offset = ldexp(plane->offset, -e - exponent)};
    for (int i = 0; i < 3; i++) scaled.normal[i] = ldexp(plane->normal[i], -e);
    return scaled;
}

/* A plane and a ray of size 1; t = 1 there is t = 2^exponent. */
typedef struct crossing {
    double above, rise, above_error, rise_error; /* n.X - c = above + t rise */
    int exponent;
} crossing;

static crossing crossing_of(const algsurf_plane *plane, const algsurf_ray *ray) {
    int on = exponent_of(algsurf_max_abs(plane->normal)), od = exponent_of(algsurf_max_abs(ray->direction));
    double far = algsurf_max_abs(ray->origin);
    int unit = far > 0 ? exponent_of(far) : -2000;
    if (plane->offset != 0 && exponent_of(plane->offset) - on > unit) unit = exponent_of(plane->offset) - on;
    if (unit == -2000) unit = 0;
    const algsurf_plane p = algsurf_i_plane_in_unit(plane, unit);
    double above[3], rise[3];
    crossing c = {.above_error = fabs(p.offset), .exponent = unit - od};
    int level = 1; /* all of the slope's terms are 0 */
    for (int i = 0; i < 3; i++) {
        above[i] = p.normal[i] * ldexp(ray->origin[i], -unit);
        rise[i] = p.normal[i] * ldexp(ray->direction[i], -od);
        c.above_error += fabs(above[i]);
        c.rise_error += fabs(rise[i]);
        level &= plane->normal[i] == 0 || ray->direction[i] == 0;
    }
    c.above = (above[0] + above[1] + above[2]) - p.offset;
    c.rise = rise[0] + rise[1] + rise[2];
    c.above_error = ROUNDED * c.above_error + LOST;
    c.rise_error = level ? 0 : ROUNDED * c.rise_error + LOST;
    return c;
}

static int is_steep(const crossing *c) { return fabs(c->rise) > 4 * c->rise_error; }

/* A ray along the plane: 1, it is kept between the chord's ends; -1: it is not; 0: not known. */
static int side_along(const crossing *c, const algsurf_i_chord *chord) {
    double far = ldexp(fmax(fabs(chord->lo), fabs(chord->hi)), -c->exponent);
    double tilt = fabs(c->rise) + c->rise_error, slack = 2 * (c->above_error + (tilt > 0 ? far * tilt : 0));
    return c->above < -slack ? 1 : c->above > slack ? -1 : 0;
}

/* What overflowed is between the largest double and infinity; what underflowed is off by 2^-1074. */
static void narrow(const crossing *c, algsurf_i_chord *chord) {
    double t = -c->above / c->rise;
    double off = 2 * (c->above_error + fabs(t) * c->rise_error) / fabs(c->rise) + ROUNDED * fabs(t);
    double lo = fmin(ldexp(t - off, c->exponent) - 0x1p-1073, DBL_MAX);
    double hi = fmax(ldexp(t + off, c->exponent) + 0x1p-1073, -DBL_MAX);
    if (c->rise > 0) {
        chord->hi = fmin(chord->hi, hi);
        chord->inner_hi = fmin(chord->inner_hi, lo);
    } else {
        chord->lo = fmax(chord->lo, lo);
        chord->inner_lo = fmax(chord->inner_lo, hi);
    }
}

int algsurf_i_planes_cut(const algsurf_plane *planes, size_t count, const algsurf_ray *ray,
                         algsurf_i_chord *chord) {
    for (size_t i = 0; i < count; i++) {
        const crossing c = crossing_of(planes + i, ray);
        if (is_steep(&c)) narrow(&c, chord);
    }
    for (size_t i = 0; i < count; i++) { /* then, as what is kept along a ray depends on how long that is: */
        const crossing c = crossing_of(planes + i, ray);
        int side = is_steep(&c) ? 1 : side_along(&c, chord);
        if (side < 0) return 0;
        if (side == 0) {
            chord->inner_lo = HUGE_VAL;
            chord->inner_hi = -HUGE_VAL;
        }
    }
    return algsurf_i_has_points(chord->lo, chord->hi);
}
