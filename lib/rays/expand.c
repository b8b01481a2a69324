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
}

/* ---- P along a line ---- */

typedef struct line_poly {
    int degree; /* -1: zero */
    double v[ALGSURF_MAX_DEGREE + 1];
    double m[ALGSURF_MAX_DEGREE + 1]; /* magnitudes */
} line_poly;

/* A coordinate along the line: x + v d. */
typedef struct line_coordinate {
    double x;
    double d, x_size, d_size;
} line_coordinate;

static void times_coordinate(line_poly *p, const line_coordinate *c) {
    int n = p->degree;
    if (n < 0) return;
    p->v[n + 1] = c->d * p->v[n];
    p->m[n + 1] = c->d_size * p->m[n];
    for (int i = n; i > 0; i--) p->v[i] = c->x * p->v[i] + c->d * p->v[i - 1];
    for (int i = n; i > 0; i--) p->m[i] = c->x_size * p->m[i] + c->d_size * p->m[i - 1];
    p->v[0] = c->x * p->v[0];
    p->m[0] *= c->x_size;
    p->degree = n + 1;
}

static void add_constant(line_poly *p, double a) {
    if (p->degree < 0) p->degree = 0, p->v[0] = p->m[0] = 0;
    p->v[0] += a;
    p->m[0] += fabs(a);
}

static void add_poly(line_poly *p, const line_poly *q) {
    for (; p->degree < q->degree; p->degree++) p->v[p->degree + 1] = p->m[p->degree + 1] = 0;
    for (int i = 0; i <= q->degree; i++) {
        p->v[i] += q->v[i];
        p->m[i] += q->m[i];
    }
}

static void horner(const algsurf_surface *s, const line_coordinate c[3], line_poly *total) {
    line_poly level, row;
    total->degree = -1;
    for (int k = s->level_count - 1; k >= 0; k--) {
        const algsurf_level *l = s->levels + k;
        times_coordinate(total, c + 2);
        level.degree = -1;
        for (int j = l->count - 1; j >= 0; j--) {
            const algsurf_row *r = s->rows + l->first + j;
            times_coordinate(&level, c + 1);
            row.degree = -1;
            for (int i = r->length - 1; i >= 0; i--) {
                times_coordinate(&row, c);
                if (s->coef[r->first + (size_t)i] != 0) add_constant(&row, s->coef[r->first + (size_t)i]);
            }
            add_poly(&level, &row);
        }
        add_poly(total, &level);
    }
}

/* What underflow can add to a coefficient.  If even the product of the smallest factors stays above
 * 2^-900, an underflow (at most 2^-1074 each) is far below the relative bound.  Otherwise fewer than
 * 2^20 of them, each multiplied by at most max(1,|X|+|D|)^n, add less than the pad. */
static double underflow_pad(const algsurf_surface *s, const line_coordinate c[3]) {
    double low = 1, high = 1;
    for (int i = 0; i < 3; i++) {
        if (c[i].x_size > 0 && c[i].x_size < low) low = c[i].x_size;
        if (c[i].d_size > 0 && c[i].d_size < low) low = c[i].d_size;
        high = fmax(high, c[i].x_size + c[i].d_size);
    }
    if (!s->inexact && ilogb(s->smallest) + s->degree * ilogb(low) > -900) return 0;
    double pad = 0x1p-1000;
    for (int i = 0; i < s->degree; i++) pad *= high;
    return pad;
}

void algsurf_i_expand_d(const algsurf_surface *s, const double X[3], const double D[3], double *q,
                        double *r) {
    line_coordinate c[3];
    line_poly p;
    int n = s->degree;
    for (int i = 0; i < 3; i++) c[i] = (line_coordinate){X[i], D[i], fabs(X[i]), fabs(D[i])};
    horner(s, c, &p);
    for (int i = p.degree + 1; i <= n; i++) p.v[i] = p.m[i] = 0;
    for (int i = 0; i <= n; i++) q[i] = p.v[i];
    double gamma = (4 * n + 8) * ALGSURF_U + s->error, pad = underflow_pad(s, c);
    for (int i = 0; i <= n; i++) r[i] = gamma * p.m[i] + pad;
}

/* ---- the public forms ---- */

static algsurf_status check_line(const algsurf_surface *surface, const algsurf_ray *ray, const double *c) {
    if (!surface || !ray || !c) return ALGSURF_E_ARGUMENT;
    if (!algsurf_is_finite3(ray->origin) || !algsurf_is_finite3(ray->direction)) return ALGSURF_E_NOT_FINITE;
    return algsurf_max_abs(ray->direction) > 0 ? ALGSURF_OK : ALGSURF_E_ARGUMENT;
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

static algsurf_status power(const algsurf_surface *s, const algsurf_ray *ray, double *c, double *r) {
    algsurf_status status = check_line(s, ray, c);
    if (status != ALGSURF_OK) return status;
    double X[3], D[3], q[ALGSURF_MAX_DEGREE + 1], qr[ALGSURF_MAX_DEGREE + 1];
    for (int i = 0; i < 3; i++) {
        X[i] = algsurf_i_scaled(ray->origin[i], -s->unit);
        D[i] = algsurf_i_scaled(ray->direction[i], -s->unit);
    }
    algsurf_i_expand_d(s, X, D, q, qr);
    return give(s, q, qr, c, r);
}

ALGSURF_I_PUBLIC(algsurf_status, expand_power, power,
                 (const algsurf_surface *surface, const algsurf_ray *ray, double *c, double *r),
                 (surface, ray, c, r))

static algsurf_status bernstein(const algsurf_surface *s, const algsurf_ray *ray, double *b, double *r) {
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

ALGSURF_I_PUBLIC(algsurf_status, expand_bernstein, bernstein,
                 (const algsurf_surface *surface, const algsurf_ray *ray, double *b, double *r),
                 (surface, ray, b, r))
