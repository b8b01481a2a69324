/* fan.c - P in the axes of a rectangle, once a frame.
 *
 * Places.  A place of the rectangle that is off by m in each coordinate is one of the rectangle's plane, seen
 * from a point, that is off by m + |d_1 / d_3| m in x, and likewise in y, but for terms of the order of m^2.
 * As |d| <= SLANT |d_3|, half sizes larger by (SLANT + 2) m take that in.
 *
 * Errors.  Let S(x,y,z) = sum |q_ijk| x^i y^j z^k.  Take absolute values everywhere: what all q_ijk
 * contribute to a coefficient of one of the segments, however they are split up on their way, adds up to
 * S(|x_1| + |d_1| + h_1, |x_2| + |d_2| + h_2, |x_3| + |d_3|) at most, and to S(|x_1|, |x_2|, |x_3|) for the
 * first one, P at the point.  On that way q meets these roundings:
 * - 1 of q;
 * - 2n in the shift of z, a product and a sum each, and n + 1 for powers of d_3;
 * - 3n in that of y, a product and two sums each, 3n in that of x;
 * - 2n for powers of h_1 and h_2, or of where a place is, and products with them; n + 1 for the end of a
 *   segment;
 * - n + 2 in the basis: its entry, the product, n sums;
 * - 5 (5n + 1) in up to five cells within cells, 6n in a cell cut anew, 9 in the sums of the T.
 * Together less than 44 n + 19; and once more the cuts and sums, 31 n + 14, for sizes that become radii.  The
 * weight 96 (n + 1) takes that in.
 *     The axes are orthonormal to 2^-49, so that coordinates of points, below 1.25, and t d are within
 * NOISE = 2^-46 of exact ones, and places within `missed`.  A coordinate that is off by m moves a term by m
 * times its derivative at most, which is no more than what the term grows by when the coordinate grows by A,
 * over A: all derivatives grow.  Hence 3 m / A times S at (x + A, y + A, z + A).
 */
#include "../base/arithmetic.h"
#include "fan.h"

#include <math.h>

#include "../base/eft.h"
#include "../base/vec.h"

#define NOISE 0x1p-46
#define MOST_DISTANCE 0x1p200      /* of the rectangle, in the view's unit */
#define LOST_BY_UNDERFLOW 0x1p-500 /* far more than is lost by it */

/* Takes from v what is along an axis, twice, so that rounding leaves nothing of it; returns 0 if nothing
 * else is left. */
static int unit_across(const double v[3], const double axis[3], double unit[3]) {
    double rest[3] = {v[0], v[1], v[2]}, whole = algsurf_length(v);
    for (int round = 0; round < 2; round++) {
        double along = algsurf_dot(rest, axis);
        for (int i = 0; i < 3; i++) rest[i] -= along * axis[i];
    }
    return algsurf_length(rest) > 0x1p-20 * whole && algsurf_unit(rest, unit);
}

/* A unit vector across another. */
static void some_across(const double axis[3], double unit[3]) {
    int least = 0;
    double v[3] = {0, 0, 0};
    for (int i = 1; i < 3; i++)
        if (fabs(axis[i]) < fabs(axis[least])) least = i;
    v[least] = 1;
    (void)unit_across(v, axis, unit);
}

/* Two along the sides, the third across.  Where a rectangle has no sides, or one, its plane is that which
 * faces `towards`. */
static int set_axes(const double edge_u[3], const double edge_v[3], const double towards[3],
                    double axis[3][3]) {
    int u_is_longer = algsurf_length(edge_u) >= algsurf_length(edge_v);
    const double *longer = u_is_longer ? edge_u : edge_v, *other = u_is_longer ? edge_v : edge_u;
    if (!algsurf_unit(longer, axis[0])) {
        if (!algsurf_unit(towards, axis[2])) return 0;
        some_across(axis[2], axis[0]);
    }
    if (!(algsurf_length(other) > 0x1p-20 * algsurf_length(longer)) ||
        !unit_across(other, axis[0], axis[1])) {
        double plane[3];
        if (!unit_across(towards, axis[0], plane)) some_across(axis[0], plane);
        algsurf_cross(plane, axis[0], axis[1]);
        if (!unit_across(axis[1], axis[0], axis[1])) return 0;
    }
    algsurf_cross(axis[0], axis[1], axis[2]);
    return algsurf_unit(axis[2], axis[2]);
}

void algsurf_i_fan_expand(const algsurf_surface *s, const double position[3], const double edge_u[3],
                          const double edge_v[3], double places, algsurf_i_fan *fan, void *memory) {
    algsurf_i_view *view = &fan->frame.view;
    double towards[3], span = 0;
    fan->usable = 0;
    for (int i = 0; i < 3; i++) towards[i] = (position[i] - view->centre[i]) / view->size;
    if (s->error > 0 || !(algsurf_max_abs(towards) < MOST_DISTANCE) ||
        !set_axes(edge_u, edge_v, towards, view->axis) ||
        !algsurf_are_orthonormal(view->axis[0], view->axis[1], view->axis[2], 0x1p-49))
        return;
    for (int k = 0; k < 2; k++) {
        fan->half[k] = 0.5 *
                       (fabs(algsurf_dot(edge_u, view->axis[k])) + fabs(algsurf_dot(edge_v, view->axis[k]))) /
                       view->size;
        span += fan->half[k];
    }
    double missed = fan->missed = places / view->size + 0x1p-46 * (algsurf_length(towards) + span);
    for (int k = 0; k < 3; k++) fan->light[k] = algsurf_dot(towards, view->axis[k]);
    for (int k = 0; k < 2; k++) fan->half[k] += (ALGSURF_I_SLANT + 2) * missed;
    view->alpha = view->beta[0] = view->beta[1] = 0;
    view->noise = NOISE;
    fan->usable = algsurf_i_frame_expand(s, &fan->frame, memory);
    if (!fan->usable) return;
    fan->weight = 96 * (s->degree + 1) * ALGSURF_U + 3 * NOISE / ALGSURF_I_FAN_APART;
    fan->least_error = fan->frame.error + LOST_BY_UNDERFLOW;
    algsurf_i_inverse_binomials(s->degree, fan->inverse);
}
