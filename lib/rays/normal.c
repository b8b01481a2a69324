/* normal.c - the unit normal of a hit: the direction of P's gradient.
 *
 * Doubles do where rounding leaves enough of the gradient (algsurf_i_surface_clear_gradient).  Elsewhere, as
 * far from the origin of space or where a high power cancels, it is exact, and rounded once: along the three
 * axes through the point P is a polynomial with integer coefficients (surface/exact_form.h), whose linear
 * ones are the derivatives.
 *
 * A singular point has no gradient, and rounding of the point makes up one.  So the gradient must be about
 * the same a few roundings before the point.  If it is not, that of a point farther before it on the ray
 * counts: where two sheets meet, or one is there twice, it is the normal seen beside. */
#include "../base/arithmetic.h"
#include "intersect_impl.h"

#include <limits.h>
#include <math.h>

#include "../base/fpenv.h"
#include "../base/memory.h"
#include "../base/vec.h"
#include "../surface/exact_form.h"
#include "../surface/impl.h"

enum { FORM_WORDS = 512 }; /* before any memory is allocated */

#define FEW_ROUNDINGS 0x1p-50 /* of a length */

/* The derivative by a coordinate at x is m 2^exponent; 0: there is no memory. */
static int exact_derivative(algsurf_memory *memory, const algsurf_surface *s, const double x[3], int axis,
                            double *m, int *exponent) {
    const double along[3] = {axis == 0, axis == 1, axis == 2};
    const int unit = x[axis] != 0 ? ilogb(x[axis]) : s->unit;
    algsurf_memory_mark begin = algsurf_memory_here(memory);
    algsurf_zpoly p;
    int scale, made = algsurf_i_exact_form(memory, s, x, along, unit, &p, &scale);
    *m = *exponent = 0;
    if (made && p.degree > 0) {
        *m = algsurf_z_to_double(algsurf_zpoly_at(&p, 1), p.width, exponent);
        *exponent -= scale + unit;
    }
    algsurf_memory_release(memory, begin);
    return made;
}

/* A multiple of the gradient at x; 0 where it is 0, or there is no memory. */
static ALGSURF_NOINLINE int exact_gradient(const algsurf_surface *s, const double x[3], size_t limit,
                                           double gradient[3]) {
    algsurf_limb block[FORM_WORDS];
    algsurf_memory memory;
    int exponent[3], top = INT_MIN;
    algsurf_memory_begin(&memory, block, FORM_WORDS, limit);
    for (int i = 0; i < 3; i++) {
        if (!exact_derivative(&memory, s, x, i, &gradient[i], &exponent[i])) return 0;
        if (gradient[i] != 0 && exponent[i] > top) top = exponent[i];
    }
    for (int i = 0; i < 3; i++) gradient[i] = gradient[i] != 0 ? ldexp(gradient[i], exponent[i] - top) : 0;
    return top > INT_MIN;
}

/* A multiple of the gradient at a point of the ray, `back` before x; 0 where there is none. */
static int gradient_before(const algsurf_surface *s, const algsurf_ray *ray, const double x[3], double back,
                           size_t limit, double gradient[3]) {
    double before[3];
    int e = algsurf_scale_exponent(algsurf_max_abs(ray->direction));
    for (int i = 0; i < 3; i++) before[i] = x[i] - back * ldexp(ray->direction[i], -e);
    if (!algsurf_is_finite3(before)) return 0;
    return algsurf_i_surface_clear_gradient(s, before, gradient) ||
           exact_gradient(s, before, limit, gradient);
}

/* Do the two have about the same direction? */
static int agree(const double a[3], const double b[3]) {
    double u[3], v[3], away = 0;
    if (!algsurf_unit(a, u) || !algsurf_unit(b, v)) return 0;
    for (int i = 0; i < 3; i++) away = fmax(away, fabs(u[i] - v[i]));
    return away <= 0x1p-8;
}

void algsurf_i_set_normal(const algsurf_surface *surface, const algsurf_ray *ray, const double position[3],
                          double off, size_t limit, double normal[3]) {
    double gradient[3], near[3], size = fmax(ldexp(1, surface->unit), algsurf_max_abs(position));
    int found = gradient_before(surface, ray, position, 0, limit, gradient);
    if (found && gradient_before(surface, ray, position, FEW_ROUNDINGS * size + off, limit, near))
        found = agree(gradient, near);
    for (double back = 0x1p-36; !found && back <= 0x1p-8; back *= 16)
        found = gradient_before(surface, ray, position, back * size + 0x1p14 * off, limit, gradient);
    if (!found || !algsurf_unit(gradient, normal)) normal[0] = normal[1] = normal[2] = 0;
}
