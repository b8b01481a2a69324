/* allroots_tighten.c - one Newton step with a residual in doubled precision, and a bound on |p| after it.
 *
 * p(z) at the double point z by the compensated Horner scheme (Graillat, Menissier-Morain 2012): every
 * product and sum is replaced by its rounded value and its exact error; the errors are the coefficients
 * of a second polynomial e, evaluated along.  So p(z) = s + e(z) exactly, and what is lost is the
 * rounding of e(z).
 *
 * Bounds, with S = sum |c_k| |z|^k, u = 2^-53, first order (the constants leave room for the rest):
 *   - each step of the scheme in s makes four products and four sums: its errors add up to at most
 *     8 u times the running size, so sum |e_k| |z|^k <= 8 n u S; evaluating e rounds by 4 u a step and
 *     4 u a coefficient: the error of p is at most 32 n (n + 2) u^2 S =: E;
 *   - p'(z) by Horner's rule is off by at most 6 n u sum k |c_k| |z|^(k-1) <= 6 n^2 u S / |z|;
 *   - after the step d = -p/p' (rounded), p(z + d) = p + p' d + sum_{k>=2} p^(k) d^k / k!, and the last sum
 * is at most S ((1+h)^n - 1 - n h) <= S (n h)^2 (for n h <= 1), h = |d| / |z|. Hence |p(z+d)| <= |p + p' d| +
 * E + 6 n^2 u S h + S (n h)^2 + sum radius_k |z + d|^k.
 */
#include <math.h>

#include "allroots_impl.h"

typedef struct value {
    double sr, si, er, ei; /* p(z) = (sr + er) + i (si + ei) */
    double dr, di;         /* p'(z) */
    double size, radius;   /* sum |c_k| |z|^k, sum radius_k |z|^k */
} value;

static value compensated(const algsurf_i_local *c, int n, double zr, double zi, double az) {
    value v = {c->cr[n], c->ci[n], 0, 0, 0, 0, c->size[n], c->radius[n]};
    for (int k = n - 1; k >= 0; k--) {
        double t = v.dr * zr - v.di * zi + v.sr;
        v.di = v.dr * zi + v.di * zr + v.si;
        v.dr = t;
        algsurf_dd a = algsurf_two_prod(v.sr, zr), b = algsurf_two_prod(v.si, zi);
        algsurf_dd f = algsurf_two_prod(v.sr, zi), g = algsurf_two_prod(v.si, zr);
        algsurf_dd x = algsurf_two_sum(a.hi, -b.hi), y = algsurf_two_sum(f.hi, g.hi);
        algsurf_dd re = algsurf_two_sum(x.hi, c->cr[k]), im = algsurf_two_sum(y.hi, c->ci[k]);
        t = v.er * zr - v.ei * zi + ((a.lo - b.lo) + (x.lo + re.lo));
        v.ei = v.er * zi + v.ei * zr + ((f.lo + g.lo) + (y.lo + im.lo));
        v.er = t;
        v.sr = re.hi;
        v.si = im.hi;
        v.size = v.size * az + c->size[k];
        v.radius = v.radius * az + c->radius[k];
    }
    return v;
}

static double modulus(double a, double b) { return sqrt(a * a + b * b); }

int algsurf_i_roots_tighten(algsurf_i_roots *p, int i) {
    algsurf_i_local c = algsurf_i_in_unit_of(p, p->x[i], p->y[i]);
    double n = p->n, scale = c.unit ? ldexp(1, -c.unit) : 1, zr = p->x[i] * scale, zi = p->y[i] * scale;
    double az = modulus(zr, zi) * (1 + 4 * ALGSURF_U);
    value v = compensated(&c, p->n, zr, zi, az);
    double pr = v.sr + v.er, pi = v.si + v.ei;
    double unit = 1 / v.size, ar = v.dr * unit, ai = v.di * unit, a2 = ar * ar + ai * ai;
    double xr = -(pr * unit * ar + pi * unit * ai) / a2, xi = -(pi * unit * ar - pr * unit * ai) / a2;
    double h = modulus(xr, xi) / az * (1 + 16 * ALGSURF_U);
    if (!(n * h <= 0.125)) return 0;
    double rest = fabs(pr + (v.dr * xr - v.di * xi)) + fabs(pi + (v.dr * xi + v.di * xr));
    double rounding = 8 * ALGSURF_U * (fabs(pr) + fabs(pi) + (fabs(v.dr) + fabs(v.di)) * h * az);
    double lost = 32 * n * (n + 2) * ALGSURF_U * ALGSURF_U + 6 * n * n * ALGSURF_U * h + n * n * h * h;
    double growth = 1 + 2 * n * h; /* >= (1+h)^n */
    algsurf_dd x = algsurf_two_sum(zr, xr), y = algsurf_two_sum(zi, xi);
    p->residual[i] =
        (rest + rounding + lost * v.size + growth * v.radius) * (1 + 8 * (n + 4) * ALGSURF_U) + 0x1p-1000;
    p->exponent[i] = c.exponent;
    p->x[i] = x.hi / scale;
    p->xl[i] = x.lo / scale;
    p->y[i] = y.hi / scale;
    p->yl[i] = y.lo / scale;
    return isfinite(p->residual[i]);
}
