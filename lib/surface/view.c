/* view.c - P in the axes of a view, once a frame, and as polynomials in u, once a row.
 *
 * Frame.  Horner's scheme over polynomials in (x,y,z), in double-double.  With M the same scheme on
 * magnitudes at |x| = |y| = |z| = 4, fewer than 2^12 roundings of 2^-102 each leave less than 2^-90 M
 * anywhere in that cube; then each coefficient is rounded to double.
 *
 * Row.  Take absolute values everywhere: what q_ijk x^i y^j z^k contributes to b_j(u), however it is split
 * up on its way, is at most |q_ijk| x^i y^j for |z| <= 1.  On that way it meets at most 5 roundings for each
 * factor y = v + z slope (the slope's own 2, a product, two sums), 5 for each factor x = u + z (alpha u +
 * beta) (two products and two sums; powers of u meet a product and a sum of the last Horner scheme instead),
 * 4 n + 5 in the change to a part of the depths and its basis (2 n in Taylor's shift, n + 1 for powers of
 * half its length, n / 2 + 4 in the basis: its entry, the product, the sums of even and of odd powers), one in
 * q: w = 5 (i + j) + 4 n + 8 takes in the higher orders.  So the error is at most u sum w |q_ijk| x^i y^j.
 *
 * A surface's coefficients with a relative error e: q_ijk moves by at most e times what the frame's scheme
 * makes of magnitudes, which takes the place of |q_ijk| then.
 *
 * Noise.  With each coordinate off by d, a term is off by at most d (i / x + j / y + k / z) of its size at
 * (x + d, y + d, z + d), by the mean value theorem.  So x and y are taken larger by d; with z = 1, 2^-20 of
 * it covers the rest for n d < 2^-22.
 */
#include "../base/arithmetic.h"
#include "view.h"

#include <math.h>
#include <string.h>

#include "../base/eft.h"
#include "../poly/basis.h"

enum { MOST = ALGSURF_MAX_VIEW_DEGREE + 1 };

/* A polynomial in (x,y,z) of a total degree, -1 for zero; laid out like a frame's q. */
typedef struct solid {
    int degree;
    algsurf_dd *q;
} solid;

/* p *= l[0] + l[1] x + l[2] y + l[3] z. */
static void times_linear(solid *p, const algsurf_dd l[4], int side) {
    if (p->degree < 0) return;
    const algsurf_dd zero = {0, 0};
    int d = ++p->degree;
    for (int i = d; i >= 0; i--)
        for (int j = d - i; j >= 0; j--)
            for (int k = d - i - j; k >= 0; k--) {
                algsurf_dd *q = p->q + (i * side + j) * side + k;
                algsurf_dd sum = i + j + k < d ? algsurf_dd_mul(l[0], *q) : zero;
                if (i > 0) sum = algsurf_dd_add(sum, algsurf_dd_mul(l[1], q[-side * side]));
                if (j > 0) sum = algsurf_dd_add(sum, algsurf_dd_mul(l[2], q[-side]));
                if (k > 0) sum = algsurf_dd_add(sum, algsurf_dd_mul(l[3], q[-1]));
                *q = sum;
            }
}

/* p += r. */
static void add_solid(solid *p, const solid *r, int side) {
    for (int i = 0; i <= r->degree; i++)
        for (int j = 0; i + j <= r->degree; j++)
            for (int k = 0; i + j + k <= r->degree; k++) {
                int at = (i * side + j) * side + k;
                p->q[at] = i + j + k <= p->degree ? algsurf_dd_add(p->q[at], r->q[at]) : r->q[at];
            }
    if (r->degree > p->degree) p->degree = r->degree;
}

static void add_constant(solid *p, double a) {
    p->q[0] = p->degree < 0 ? algsurf_dd_from(a) : algsurf_dd_add_d(p->q[0], a);
    if (p->degree < 0) p->degree = 0;
}

static size_t cube(int degree) {
    size_t side = (size_t)degree + 1;
    return side * side * side;
}

size_t algsurf_i_frame_memory(int degree) { return 3 * cube(degree) * sizeof(algsurf_dd); }

/* The surface's rows and levels, or their `sizes`, in world coordinates that are linear in (x,y,z). */
static solid in_view_axes(const algsurf_surface *s, int sizes, algsurf_dd world[3][4], algsurf_dd *memory) {
    int side = s->degree + 1;
    solid total = {-1, memory}, level = {-1, memory + cube(s->degree)}, row = {-1, level.q + cube(s->degree)};
    for (int k = s->level_count - 1; k >= 0; k--) {
        times_linear(&total, world[2], side);
        level.degree = -1;
        for (int j = s->levels[k].count - 1; j >= 0; j--) {
            const algsurf_row *r = s->rows + s->levels[k].first + j;
            times_linear(&level, world[1], side);
            row.degree = -1;
            for (int i = r->length - 1; i >= 0; i--) {
                times_linear(&row, world[0], side);
                double c = s->coef[r->first + (size_t)i];
                add_constant(&row, sizes ? fabs(c) : c);
            }
            add_solid(&level, &row, side);
        }
        add_solid(&total, &level, side);
    }
    return total;
}

/* Returns the sum of all sizes. */
static double set_sizes(algsurf_i_frame_form *frame, const solid *p) {
    double whole = 0;
    int n = frame->degree, side = n + 1;
    for (int i = 0; i <= n; i++)
        for (int j = 0; j <= n; j++) {
            double sum = 0, along = 0;
            for (int k = 0; i + j + k <= p->degree; k++) {
                double size = fabs(p->q[(i * side + j) * side + k].hi);
                sum += size;
                along += k * size;
            }
            frame->sizes[i * side + j] = sum;
            frame->along[i * side + j] = along;
            whole += sum;
        }
    return whole;
}

int algsurf_i_frame_expand(const algsurf_surface *s, algsurf_i_frame_form *frame, void *memory) {
    const algsurf_i_view *view = &frame->view;
    int n = s->degree, side = n + 1;
    double reach[3], shown[3];
    algsurf_dd world[3][4]; /* the world's coordinates, linear in x, y, z */
    for (int axis = 0; axis < 3; axis++) {
        world[axis][0] = algsurf_dd_from(view->centre[axis]);
        reach[axis] = shown[axis] = fabs(view->centre[axis]);
        for (int k = 0; k < 3; k++) {
            world[axis][k + 1] = algsurf_two_prod(view->size, view->axis[k][axis]);
            reach[axis] += 4 * fabs(world[axis][k + 1].hi);
            shown[axis] += fabs(world[axis][k + 1].hi) * (1 + 0x1p-20);
        }
    }
    solid p = in_view_axes(s, 0, world, memory);
    frame->degree = n;
    memset(frame->q, 0, cube(n) * sizeof *frame->q);
    for (int i = 0; i <= p.degree; i++)
        for (int j = 0; i + j <= p.degree; j++)
            for (int k = 0; i + j + k <= p.degree; k++) {
                int at = (i * side + j) * side + k;
                if (!isfinite(p.q[at].hi)) return 0;
                frame->q[at] = p.q[at].hi;
            }
    frame->value_error = (16 * (n + 1) * ALGSURF_U + s->error) * algsurf_i_surface_magnitude(s, shown);
    frame->error = 0x1p-90 * algsurf_i_surface_magnitude(s, reach) + 0x1p-900;
    algsurf_i_power_basis(frame->basis, n);
    frame->spread = s->error;
    if (s->error > 0) {
        for (int axis = 0; axis < 3; axis++)
            for (int k = 0; k < 4; k++)
                if (world[axis][k].hi < 0) world[axis][k] = algsurf_dd_neg(world[axis][k]);
        p = in_view_axes(s, 1, world, memory);
    }
    /* so that no sum overflows on the way to a value, |x|, |y| <= 4, nor between the units of a split */
    return set_sizes(frame, &p) < 0x1p700 && frame->error < 0x1p900;
}

/* c_km: the coefficient of z^k u^m for this v. */
static void fix_v(const algsurf_i_frame_form *frame, double v, int stride, double *c) {
    int n = frame->degree, side = n + 1;
    double alpha = frame->view.alpha, beta = frame->view.beta[0], slope = alpha * v + frame->view.beta[1];
    for (int i = 0; i < side * stride; i++) c[i] = 0;
    for (int i = n; i >= 0; i--) {
        double g[MOST] = {0}; /* sum_j (v + slope z)^j sum_k q_ijk z^k */
        for (int j = n - i; j >= 0; j--) {
            const double *q = frame->q + (i * side + j) * side;
            for (int k = n - i; k > 0; k--) g[k] = v * g[k] + slope * g[k - 1] + q[k];
            g[0] = v * g[0] + q[0];
        }
        for (int k = n; k >= 0; k--) { /* times u + z (alpha u + beta), plus g */
            double *row = c + k * stride, *below = row - stride;
            for (int m = n - i; m > 0; m--)
                row[m] = row[m - 1] + (k > 0 ? alpha * below[m - 1] + beta * below[m] : 0);
            row[0] = (k > 0 ? beta * below[0] : 0) + g[k];
        }
    }
}

void algsurf_i_view_radius(const algsurf_i_frame_form *frame, double y, int each, int all, double *radius) {
    int n = frame->degree, side = n + 1;
    double noise = frame->view.noise * (1 + 0x1p-20), across = 0; /* sum of |q_ijk| y^j for i + 1 */
    for (int i = n; i >= 0; i--) {
        double total = 0, size = 0, power = 1, below = 0; /* y^j, y^(j-1) */
        for (int j = 0; j <= n - i; j++) {
            double q = frame->sizes[i * side + j],
                   weight = (each * (i + j) + all) * ALGSURF_U + frame->spread;
            total += power * (weight * q + noise * frame->along[i * side + j]) + noise * j * below * q;
            size += power * q;
            below = power;
            power *= y;
        }
        radius[i] = (total + noise * (i + 1) * across) * (1 + 0x1p-20);
        across = size;
    }
    radius[0] += frame->error;
}

void algsurf_i_row_expand(const algsurf_i_frame_form *frame, double v, algsurf_i_row_form *row) {
    const algsurf_i_view *view = &frame->view;
    row->degree = frame->degree;
    row->v = v;
    row->stride = (frame->degree + 8) / 8 * 8;
    fix_v(frame, v, row->stride, row->c);
    algsurf_i_view_radius(frame, fabs(v) + fabs(view->alpha * v) + fabs(view->beta[1]) + view->noise, 5,
                          4 * frame->degree + 8, row->radius);
}
