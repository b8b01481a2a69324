/* expand.c - where the parameter v of a ray has its origin, and what its unit is; P along the ray X + v D in
 * double: the nested Horner scheme over polynomials in v.
 *
 * Error bound.  Along the way of a monomial a x^i y^j z^k every factor X + v D costs a rounding for X
 * itself, one for the product, one for the sum of the two products, and the scheme one more for the
 * next coefficient: 4 (i+j+k); joining rows and levels costs at most 3 more.  The same scheme on
 * magnitudes, M_k, bounds what these roundings multiply, so |error of q_k| <= gamma M_k with
 * gamma = (4 n + 8) ALGSURF_U, which leaves room for higher orders and the rounding of M_k itself;
 * coefficients with an error of their own add it to gamma.
 */
#include "../base/arithmetic.h"
#include "algsurf/expand.h"

#include <math.h>

#include "../base/fpenv.h"
#include "../base/vec.h"
#include "algsurf/poly.h"
#include "expand_impl.h"
#include "region.h"

/* The least power of two that is not below x > 0; 1 for 0. */
static double power_above(double x) {
    int e;
    double m = frexp(x, &e);
    return m == 0 ? 1 : ldexp(1, m == 0.5 ? e - 1 : e);
}

/* x 2^e; what underflows becomes the least number of its sign, so that it is seen where underflow is
 * accounted for (the error is at most 2^-1074 either way). */
static double scaled(double x, int e) {
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
        O[i] = scaled(ray->origin[i], -surface->unit);
        f->V[i] = scaled(ray->direction[i], -e);
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
        f->step =
            power_above(fmax(half, ldexp(1, -900 / (surface->degree + 1)))); /* its powers do not vanish */
    } else {
        f->step = natural;
    }
    for (int i = 0; i < 3; i++) f->D[i] = scaled(f->V[i], ilogb(f->step));
    f->lost = is_lost(f, ray->direction);
}

void algsurf_i_set_position(const algsurf_i_frame *f, const double x[3], const algsurf_ray *ray, int unit,
                            double t, int lost, double position[3]) {
    for (int i = 0; i < 3; i++) lost |= !isfinite(ldexp(x[i], unit));
    for (int i = 0; i < 3; i++) {
        const double from_t = algsurf_i_coordinate_at(ray, i, t), part[2] = {from_t, ray->origin[i]};
        int faint = ray->direction[i] != 0 && fabs(f->V[i]) < 0x1p-900;
        for (int k = 0; k < 2; k++) faint |= part[k] != 0 && fabs(ldexp(part[k], -unit)) < 0x1p-900;
        position[i] = lost || faint ? from_t : ldexp(x[i], unit);
    }
}

/* ---- P along a line ---- */

typedef struct line_poly {
    int degree; /* -1: zero */
    double c[ALGSURF_MAX_DEGREE + 1];
} line_poly;

/* By the coordinate x + v d. */
static void times_coordinate(line_poly *p, double x, double d) {
    double *c = p->c;
    if (p->degree < 0) return;
    int n = p->degree++;
    c[n + 1] = d * c[n];
    for (int i = n; i > 0; i--) c[i] = x * c[i] + d * c[i - 1];
    c[0] *= x;
}

static void add(line_poly *p, const double *c, int degree) {
    while (p->degree < degree) p->c[++p->degree] = 0;
    for (int i = 0; i <= degree; i++) p->c[i] += c[i];
}

/* P along X + v D, or the scheme on magnitudes. */
static void horner(const algsurf_surface *s, const double X[3], const double D[3], int sizes, double *q) {
    line_poly total, level, row;
    total.degree = -1;
    for (int k = s->level_count - 1; k >= 0; k--) {
        times_coordinate(&total, X[2], D[2]);
        level.degree = -1;
        for (int j = s->levels[k].count - 1; j >= 0; j--) {
            const algsurf_row *r = s->rows + s->levels[k].first + j;
            times_coordinate(&level, X[1], D[1]);
            row.degree = -1;
            for (int i = r->length - 1; i >= 0; i--) {
                const double a = s->coef[r->first + (size_t)i], term = sizes ? fabs(a) : a;
                times_coordinate(&row, X[0], D[0]);
                if (a != 0) add(&row, &term, 0);
            }
            add(&level, row.c, row.degree);
        }
        add(&total, level.c, level.degree);
    }
    for (int i = 0; i <= s->degree; i++) q[i] = i <= total.degree ? total.c[i] : 0;
}

/* What underflow can add to a coefficient.  If even the product of the smallest factors stays above
 * 2^-900, an underflow (at most 2^-1074 each) is far below the relative bound.  Otherwise fewer than
 * 2^20 of them, each multiplied by at most max(1,|X|+|D|)^n, add less than the pad. */
static double underflow_pad(const algsurf_surface *s, const double x[3], const double d[3]) {
    double low = 1, high = 1, pad = 0x1p-1000;
    for (int i = 0; i < 3; i++) {
        if (x[i] > 0) low = fmin(low, x[i]);
        if (d[i] > 0) low = fmin(low, d[i]);
        high = fmax(high, x[i] + d[i]);
    }
    if (!s->inexact && ilogb(s->smallest) + s->degree * ilogb(low) > -900) return 0;
    for (int i = 0; i < s->degree; i++) pad *= high;
    return pad;
}

void algsurf_i_expand_d(const algsurf_surface *s, const double X[3], const double D[3], double *q,
                        double *r) {
    const double x[3] = {fabs(X[0]), fabs(X[1]), fabs(X[2])}, d[3] = {fabs(D[0]), fabs(D[1]), fabs(D[2])};
    const double gamma = (4 * s->degree + 8) * ALGSURF_U + s->error, pad = underflow_pad(s, x, d);
    horner(s, X, D, 0, q);
    horner(s, x, d, 1, r);
    for (int i = 0; i <= s->degree; i++) r[i] = gamma * r[i] + pad;
}

/* ---- the public forms ---- */

static algsurf_status check_line(const algsurf_surface *surface, const algsurf_ray *ray, const double *c) {
    if (!surface || !ray || !c) return ALGSURF_E_ARGUMENT;
    algsurf_ray line = *ray;
    line.t_min = line.t_max = 0;
    return algsurf_i_ray_check(&line);
}

static int all_finite(const double *c, const double *r, int n) {
    for (int i = 0; i <= n; i++)
        if (!isfinite(c[i]) || !isfinite(r[i])) return 0;
    return 1;
}

/* Undoes the surface's scale; a result under the normal range is off by at most 2^-1075 more. */
static algsurf_status give(const algsurf_surface *s, const double *q, const double *qr, double *c,
                           double *r) {
    double value[ALGSURF_MAX_DEGREE + 1] = {0}, radius[ALGSURF_MAX_DEGREE + 1] = {0};
    for (int i = 0; i <= s->degree; i++) {
        value[i] = ldexp(q[i], -s->scale);
        radius[i] = ldexp(qr[i], -s->scale);
        if (fabs(value[i]) < 0x1p-1022 && ldexp(value[i], s->scale) != q[i]) radius[i] += 0x1p-1074;
        if (radius[i] < 0x1p-1022 && qr[i] > 0) radius[i] += 0x1p-1074;
    }
    if (!all_finite(value, radius, s->degree)) return ALGSURF_E_RANGE;
    for (int i = 0; i <= s->degree; i++) {
        c[i] = value[i];
        if (r) r[i] = radius[i];
    }
    return ALGSURF_OK;
}

ALGSURF_I_ENTRY(algsurf_status, expand_power,
                (const algsurf_surface *s, const algsurf_ray *ray, double *c, double *r), (s, ray, c, r)) {
    algsurf_status status = check_line(s, ray, c);
    if (status != ALGSURF_OK) return status;
    double X[3], D[3], q[ALGSURF_MAX_DEGREE + 1], qr[ALGSURF_MAX_DEGREE + 1];
    for (int i = 0; i < 3; i++) {
        X[i] = scaled(ray->origin[i], -s->unit);
        D[i] = scaled(ray->direction[i], -s->unit);
    }
    algsurf_i_expand_d(s, X, D, q, qr);
    return give(s, q, qr, c, r);
}

ALGSURF_I_ENTRY(algsurf_status, expand_bernstein,
                (const algsurf_surface *s, const algsurf_ray *ray, double *b, double *r), (s, ray, b, r)) {
    algsurf_status status = check_line(s, ray, b);
    if (status != ALGSURF_OK) return status;
    if (!isfinite(ray->t_min) || !isfinite(ray->t_max)) return ALGSURF_E_NOT_FINITE;
    if (!(ray->t_min < ray->t_max)) return ALGSURF_E_ARGUMENT;
    double q[ALGSURF_MAX_DEGREE + 1], qr[ALGSURF_MAX_DEGREE + 1], size = 0;
    double value[ALGSURF_MAX_DEGREE + 1], radius[ALGSURF_MAX_DEGREE + 1];
    algsurf_i_frame f;
    int n = s->degree;
    algsurf_i_frame_of(s, ray, 1, &f);
    double X[3] = {f.X[0].hi, f.X[1].hi, f.X[2].hi};
    double lo = (ldexp(ray->t_min, f.exponent) - f.centre) / f.step,
           hi = (ldexp(ray->t_max, f.exponent) - f.centre) / f.step;
    algsurf_i_expand_d(s, X, f.D, q, qr);
    if (f.lost || !all_finite(q, qr, n)) return ALGSURF_E_RANGE;
    if (algsurf_poly_to_bernstein(q, qr, n, lo, hi, value, radius) != ALGSURF_OK) return ALGSURF_E_RANGE;
    /* The ends were rounded: each factor of the blossom is off by a relative u, |ends| <= 1. */
    for (int i = 0; i <= n; i++) size += fabs(q[i]);
    for (int i = 0; i <= n; i++) radius[i] += 2 * n * ALGSURF_U * size;
    return give(s, value, radius, b, r);
}
