/* expand.c - the public forms of the expansion along a ray. */
#include "../base/arithmetic.h"
#include "algsurf/expand.h"

#include <math.h>

#include "algsurf/poly.h"
#include "expand_impl.h"
#include "../base/fpenv.h"
#include "../base/vec.h"

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

static ALGSURF_NOINLINE algsurf_status power(const algsurf_surface *s, const algsurf_ray *ray, double *c,
                                             double *r) {
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

algsurf_status algsurf_expand_power(const algsurf_surface *surface, const algsurf_ray *ray, double *c,
                                    double *r) {
    algsurf_status status;
    ALGSURF_STANDARD(status = power(surface, ray, c, r));
    return status;
}

static ALGSURF_NOINLINE algsurf_status bernstein(const algsurf_surface *s, const algsurf_ray *ray, double *b,
                                                 double *r) {
    algsurf_status status = check_line(s, ray, b);
    if (status != ALGSURF_OK) return status;
    if (!(ray->t_min < ray->t_max) || isinf(ray->t_min) || isinf(ray->t_max)) return ALGSURF_E_ARGUMENT;
    double q[ALGSURF_MAX_DEGREE + 1], qr[ALGSURF_MAX_DEGREE + 1], size = 0;
    double value[ALGSURF_MAX_DEGREE + 1], radius[ALGSURF_MAX_DEGREE + 1];
    algsurf_i_frame f;
    int n = s->degree;
    algsurf_i_frame_of(s, ray, 1, &f);
    double X[3] = {f.X[0].hi, f.X[1].hi, f.X[2].hi};
    algsurf_i_expand_d(s, X, f.D, q, qr);
    if (f.lost || !all_finite(q, qr, n)) return ALGSURF_E_RANGE;
    if (algsurf_poly_to_bernstein(q, qr, n, f.lo.hi, f.hi.hi, value, radius) != ALGSURF_OK)
        return ALGSURF_E_RANGE;
    /* The ends were rounded: each factor of the blossom is off by a relative u, |ends| <= 1. */
    for (int i = 0; i <= n; i++) size += fabs(q[i]);
    for (int i = 0; i <= n; i++) radius[i] += 2 * n * ALGSURF_U * size;
    return give(s, value, radius, b, r);
}

algsurf_status algsurf_expand_bernstein(const algsurf_surface *surface, const algsurf_ray *ray, double *b,
                                        double *r) {
    algsurf_status status;
    ALGSURF_STANDARD(status = bernstein(surface, ray, b, r));
    return status;
}
