/* own_ball.c - a surface that is the sphere of its own extent: P = a (|X - C|^2 - R^2)?  Compared coefficient
 * by coefficient, in integers: a (x^2 + y^2 + z^2) - 2 a C.X + a (|C|^2 - R^2). */
#include "../base/arithmetic.h"
#include "region.h"

#include <math.h>
#include <stdlib.h>

#include "../base/integer.h"
#include "../surface/impl.h"

/* Bits of a sum of products of three doubles: they reach from 2^-3222 to 2^3074. */
enum { LOW = 3 * 1074, WIDTH = (3 * 1074 + 3 * 1024 + 64) / 64 + 1 };

/* sum += factor a b c, exactly; factor is -2, -1, 1 or 2. */
static void add_product(algsurf_limb *sum, int factor, double a, double b, double c) {
    int ea, eb, ec;
    algsurf_limb product[3] = {algsurf_z_odd_part(a, &ea), 0, 0};
    algsurf_z_multiply(product, 3, algsurf_z_odd_part(b, &eb));
    algsurf_z_multiply(product, 3, algsurf_z_odd_part(c, &ec));
    int shift = ea + eb + ec + LOW + (abs(factor) == 2),
        negative = (a < 0) ^ (b < 0) ^ (c < 0) ^ (factor < 0);
    algsurf_z_join_product(sum, WIDTH, product, 3, (algsurf_limb)1 << shift % 64, shift / 64, negative);
}

/* Is coefficient -2 a c? */
static int is_linear(double coefficient, double a, double c) {
    algsurf_limb sum[WIDTH];
    algsurf_z_zero(sum, WIDTH);
    add_product(sum, 1, coefficient, 1, 1);
    add_product(sum, 2, a, c, 1);
    return algsurf_z_sign(sum, WIDTH) == 0;
}

/* Is coefficient a (|C|^2 - R^2)? */
static int is_constant(double coefficient, double a, const double centre[3], double radius) {
    algsurf_limb sum[WIDTH];
    algsurf_z_zero(sum, WIDTH);
    add_product(sum, -1, coefficient, 1, 1);
    for (int i = 0; i < 3; i++) add_product(sum, 1, a, centre[i], centre[i]);
    add_product(sum, -1, a, radius, radius);
    return algsurf_z_sign(sum, WIDTH) == 0;
}

/* Far from equal, in double?  Then there is no need of integers.  (NaN, of numbers too large, is not far.) */
static int is_far(double constant, double a, const double centre[3], double radius) {
    double sum = constant, size = fabs(constant) + fabs(a) * radius * radius;
    for (int i = 0; i < 3; i++) {
        sum -= a * centre[i] * centre[i];
        size += fabs(a) * centre[i] * centre[i];
    }
    return fabs(sum + a * radius * radius) > 0x1p-40 * size;
}

static int is_own_ball(const algsurf_surface *s, const algsurf_extent *extent) {
    double square[3] = {0, 0, 0}, linear[3] = {0, 0, 0}, constant = 0;
    if (!extent || extent->kind != ALGSURF_EXTENT_SPHERE || s->degree != 2 || s->error > 0) return 0;
    for (size_t m = 0; m < s->term_count; m++) {
        const algsurf_term *t = s->terms + m;
        const int e[3] = {t->i, t->j, t->k};
        int axis = e[0] ? 0 : e[1] ? 1 : 2, degree = e[0] + e[1] + e[2];
        if (degree > e[axis]) return 0;
        if (degree == 0) constant = t->a;
        if (degree == 1) linear[axis] = t->a;
        if (degree == 2) square[axis] = t->a;
    }
    if (square[0] != square[1] || square[0] != square[2]) return 0;
    if (is_far(constant, square[0], extent->centre, extent->size[0])) return 0;
    for (int i = 0; i < 3; i++)
        if (!is_linear(linear[i], square[0], extent->centre[i])) return 0;
    return is_constant(constant, square[0], extent->centre, extent->size[0]);
}

const algsurf_extent *algsurf_i_without_own_ball(const algsurf_surface *surface, const algsurf_extent *extent,
                                                 algsurf_extent *wider) {
    if (!is_own_ball(surface, extent)) return extent;
    *wider = *extent;
    wider->size[0] = 2 * extent->size[0];
    return wider;
}
