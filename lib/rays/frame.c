/* frame.c - where the ray's parameter has its origin, and what its unit is. */
#include "../base/arithmetic.h"
#include <math.h>

#include "expand_impl.h"
#include "../base/vec.h"

/* The least power of two that is not below x > 0; 1 for 0. */
static double power_above(double x) {
    int e;
    double m = frexp(x, &e);
    return m == 0 ? 1 : ldexp(1, m == 0.5 ? e - 1 : e);
}

double algsurf_i_scaled(double x, int e) {
    double y = ldexp(x, e);
    return y == 0 && x != 0 ? copysign(0x1p-1074, x) : y;
}

/* May the direction have lost bits to underflow, and does it show?  V is then off by at most 2^-1074, a point
 * by |s| times that; up to |s| = 2^60 this is among what the expansion allows for underflow, since D has a
 * component below 2^-960. */
static int is_lost(const algsurf_i_frame *f, const double direction[3]) {
    if (!(fabs(f->centre) > 0x1p59 || f->step > 0x1p59)) return 0;
    for (int i = 0; i < 3; i++)
        if (direction[i] != 0 && fabs(f->V[i]) < 0x1p-1022) return 1;
    return 0;
}

/* (s - centre) / step, the difference exact. */
static algsurf_dd local(double s, const algsurf_i_frame *f) {
    if (isinf(s)) return algsurf_dd_from(s);
    return algsurf_dd_scale(algsurf_two_sum(s, -f->centre), 1 / f->step);
}

static void place(algsurf_i_frame *f, const double O[3], double centre) {
    f->centre = centre;
    for (int i = 0; i < 3; i++) f->X[i] = algsurf_dd_add_d(algsurf_two_prod(centre, f->V[i]), O[i]);
}

void algsurf_i_frame_of(const algsurf_surface *surface, const algsurf_ray *ray, int chord,
                        algsurf_i_frame *f) {
    double O[3];
    int e;
    (void)frexp(algsurf_max_abs(ray->direction), &e);
    for (int i = 0; i < 3; i++) {
        O[i] = algsurf_i_scaled(ray->origin[i], -surface->unit);
        f->V[i] = algsurf_i_scaled(ray->direction[i], -e);
    }
    f->exponent = e - surface->unit;
    double lo = ldexp(ray->t_min, f->exponent), hi = ldexp(ray->t_max, f->exponent);
    double half = 0.5 * hi - 0.5 * lo;
    place(f, O, -algsurf_dot(O, f->V) / algsurf_dot(f->V, f->V));
    double point[3] = {f->X[0].hi, f->X[1].hi, f->X[2].hi};
    double natural = power_above(fmax(1, algsurf_max_abs(point)));
    f->one_piece = chord || half <= 2 * natural;
    if (f->one_piece) {
        place(f, O, 0.5 * lo + 0.5 * hi);
        f->step = power_above(fmax(half, 0x1p-900));
    } else {
        f->step = natural;
    }
    for (int i = 0; i < 3; i++) f->D[i] = algsurf_i_scaled(f->V[i], ilogb(f->step));
    f->lost = is_lost(f, ray->direction);
    f->lo = local(lo, f);
    f->hi = local(hi, f);
}
