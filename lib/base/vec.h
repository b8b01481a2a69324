/* vec.h - vectors of three doubles: the few operations that the geometric rooms share.
 *
 * A length may be any double, and its square out of range; so a vector is first scaled by a power of two to
 * about 1, which is exact.
 */
#ifndef ALGSURF_VEC_H
#define ALGSURF_VEC_H
#include <math.h>

#include "eft.h"

static inline double algsurf_dot(const double a[3], const double b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static inline double algsurf_max_abs(const double v[3]) {
    return fmax(fabs(v[0]), fmax(fabs(v[1]), fabs(v[2])));
}

static inline int algsurf_is_finite3(const double v[3]) {
    return isfinite(v[0]) && isfinite(v[1]) && isfinite(v[2]);
}

/* Are all `count` numbers at x 0? */
static inline int algsurf_are_zero(const double *x, int count) {
    for (int i = 0; i < count; i++)
        if (!(x[i] == 0)) return 0;
    return 1;
}

/* The exponent e of x = f 2^e, 1/2 <= |f| < 1, kept within +-1000 so that 2^-e and the square of
 * x 2^-e neither overflow nor underflow.  x = 0 gives 0. */
static inline int algsurf_scale_exponent(double x) {
    int e;
    (void)frexp(x, &e);
    return e > 1000 ? 1000 : e < -1000 ? -1000 : e;
}

/* |v|; overflows only when the length itself does. */
static inline double algsurf_length(const double v[3]) {
    int e = algsurf_scale_exponent(algsurf_max_abs(v));
    double scale = ldexp(1.0, -e), w[3] = {v[0] * scale, v[1] * scale, v[2] * scale};
    return ldexp(sqrt(algsurf_dot(w, w)), e);
}

/* unit = v / |v|; returns 0 and leaves unit alone when v is zero. */
static inline int algsurf_unit(const double v[3], double unit[3]) {
    double m = algsurf_max_abs(v);
    if (!(m > 0)) return 0;
    double scale = ldexp(1.0, -algsurf_scale_exponent(m));
    double w[3] = {v[0] * scale, v[1] * scale, v[2] * scale}, length = sqrt(algsurf_dot(w, w));
    for (int i = 0; i < 3; i++) unit[i] = w[i] / length;
    return 1;
}

/* out = a x b, each component right to about a unit in its last place (Kahan's difference of products). */
static inline void algsurf_cross(const double a[3], const double b[3], double out[3]) {
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        algsurf_dd p = algsurf_two_prod(a[j], b[k]), q = algsurf_two_prod(a[k], b[j]);
        out[i] = (p.hi - q.hi) + (p.lo - q.lo);
    }
}

/* Are three vectors orthonormal, each product of two of them but for `slack`? */
static inline int algsurf_are_orthonormal(const double a[3], const double b[3], const double c[3],
                                          double slack) {
    return fabs(algsurf_dot(a, a) - 1) <= slack && fabs(algsurf_dot(b, b) - 1) <= slack &&
           fabs(algsurf_dot(c, c) - 1) <= slack && fabs(algsurf_dot(a, b)) <= slack &&
           fabs(algsurf_dot(b, c)) <= slack && fabs(algsurf_dot(c, a)) <= slack;
}

#endif
