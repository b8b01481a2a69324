/* tighten.c - one Newton step with a residual in doubled precision, and a bound on |p| after it.
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
#include "../base/arithmetic.h"
#include <math.h>

#include "impl.h"
#include "../simd/pair.h"

/* Of two points at once. */
typedef struct value {
    algsurf_pair sr, si, er, ei; /* p(z) = (sr + er) + i (si + ei) */
    algsurf_pair dr, di;         /* p'(z) */
    algsurf_pair size, radius;   /* sum |c_k| |z|^k, sum radius_k |z|^k */
} value;

static value compensated(const algsurf_i_local *c, int n, algsurf_pair zr, algsurf_pair zi, algsurf_pair az) {
    const algsurf_pair zero = {0, 0};
    value v = {algsurf_both(c->cr[n]),   algsurf_both(c->ci[n]),    zero, zero, zero, zero,
               algsurf_both(c->size[n]), algsurf_both(c->radius[n])};
    for (int k = n - 1; k >= 0; k--) {
        algsurf_pair t = v.dr * zr - v.di * zi + v.sr;
        v.di = v.dr * zi + v.di * zr + v.si;
        v.dr = t;
        algsurf_pair_dd a = algsurf_pair_two_prod(v.sr, zr), b = algsurf_pair_two_prod(v.si, zi);
        algsurf_pair_dd f = algsurf_pair_two_prod(v.sr, zi), g = algsurf_pair_two_prod(v.si, zr);
        algsurf_pair_dd x = algsurf_pair_two_sum(a.hi, -b.hi), y = algsurf_pair_two_sum(f.hi, g.hi);
        algsurf_pair_dd re = algsurf_pair_two_sum(x.hi, algsurf_both(c->cr[k]));
        algsurf_pair_dd im = algsurf_pair_two_sum(y.hi, algsurf_both(c->ci[k]));
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

static algsurf_pair modulus(algsurf_pair a, algsurf_pair b) { return algsurf_pair_sqrt(a * a + b * b); }

/* Half h of x, a sum high + low in units of 1/scale, becomes coordinate i. */
static void keep(double *high, double *low, int i, algsurf_pair_dd x, int h, double scale) {
    high[i] = x.hi[h] / scale;
    low[i] = x.lo[h] / scale;
}

/* Roots i and j, which may be one. */
static void tighten(algsurf_i_roots *p, int i, int j) {
    algsurf_i_local c = algsurf_i_in_unit_of(p, p->x[i], p->y[i]);
    double n = p->n, scale = c.unit ? ldexp(1, -c.unit) : 1;
    algsurf_pair zr = (algsurf_pair){p->x[i], p->x[j]} * scale, zi = (algsurf_pair){p->y[i], p->y[j]} * scale;
    algsurf_pair az = modulus(zr, zi) * (1 + 4 * ALGSURF_U);
    value v = compensated(&c, p->n, zr, zi, az);
    algsurf_pair pr = v.sr + v.er, pi = v.si + v.ei, unit = 1 / v.size, ar = v.dr * unit, ai = v.di * unit;
    algsurf_pair a2 = ar * ar + ai * ai;
    algsurf_pair xr = -(pr * unit * ar + pi * unit * ai) / a2, xi = -(pi * unit * ar - pr * unit * ai) / a2;
    algsurf_pair h = modulus(xr, xi) / az * (1 + 16 * ALGSURF_U);
    algsurf_pair rest =
        algsurf_pair_abs(pr + (v.dr * xr - v.di * xi)) + algsurf_pair_abs(pi + (v.dr * xi + v.di * xr));
    algsurf_pair sum = algsurf_pair_abs(pr) + algsurf_pair_abs(pi) +
                       (algsurf_pair_abs(v.dr) + algsurf_pair_abs(v.di)) * h * az;
    algsurf_pair rounding = 8 * ALGSURF_U * sum;
    algsurf_pair lost = 32 * n * (n + 2) * ALGSURF_U * ALGSURF_U + 6 * n * n * ALGSURF_U * h + n * n * h * h;
    algsurf_pair growth = 1 + 2 * n * h; /* >= (1+h)^n */
    algsurf_pair residual =
        (rest + rounding + lost * v.size + growth * v.radius) * (1 + 8 * (n + 4) * ALGSURF_U) + 0x1p-1000;
    algsurf_pair_dd x = algsurf_pair_two_sum(zr, xr), y = algsurf_pair_two_sum(zi, xi);
    for (int half = 0; half < 1 + (i != j); half++) {
        int k = half ? j : i;
        if (!(n * h[half] <= 0.125) || !isfinite(residual[half])) continue;
        p->residual[k] = residual[half];
        p->exponent[k] = c.exponent;
        keep(p->x, p->xl, k, x, half, scale);
        keep(p->y, p->yl, k, y, half, scale);
    }
}

/* In a wide problem each root has a unit of its own, so it goes alone. */
void algsurf_i_roots_tighten(algsurf_i_roots *p) {
    int waiting = -1;
    for (int i = 0; i < p->n; i++) {
        if (p->residual[i] < HUGE_VAL) continue;
        if (!p->narrow) {
            tighten(p, i, i);
        } else if (waiting < 0) {
            waiting = i;
        } else {
            tighten(p, waiting, i);
            waiting = -1;
        }
    }
    if (waiting >= 0) tighten(p, waiting, waiting);
}
