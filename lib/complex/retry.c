/* retry.c - roots that double cannot tell apart: the Ehrlich-Aberth iteration in double-double.
 *
 * Clusters down to a relative distance of about 1e-15 come apart; the members of a multiple root of
 * order k close in on it to about (u^2 cond)^(1/k).  The other approximations stay fixed and serve as
 * they are.
 *
 * Bound on the error of p(z), running along Horner's rule s <- s z + c: with u^2 = 2^-106 a product of
 * double-doubles is off by 7 u^2, a sum by 3 u^2, so each part of s z by 10 u^2 |s| |z|, the number by
 * 15 u^2 |s| |z| (sqrt 2, higher orders); adding c costs 2 u^2 of each part.  Earlier errors are multiplied
 * by z along.  Where partial sums cancel this is far below the bound by sum |c_k| |z|^k. */
#include "../base/arithmetic.h"
#include <float.h>
#include <math.h>

#include "impl.h"
#include "../base/elementary.h"

#define MOVED 2                 /* done[i] of a root that was retried */
#define SWEEPS 40               /* linear convergence at a multiple root: a factor of (k-1)/(k+1) a sweep */
#define TURN 2.3999632297286535 /* the golden part of a full turn, in radians */

typedef struct complex_dd {
    algsurf_dd re, im;
} complex_dd;

static complex_dd times(complex_dd a, complex_dd b) {
    return (complex_dd){algsurf_dd_sub(algsurf_dd_mul(a.re, b.re), algsurf_dd_mul(a.im, b.im)),
                        algsurf_dd_add(algsurf_dd_mul(a.re, b.im), algsurf_dd_mul(a.im, b.re))};
}

static complex_dd plus(complex_dd a, double re, double im) {
    return (complex_dd){algsurf_dd_add_d(a.re, re), algsurf_dd_add_d(a.im, im)};
}

static complex_dd sum(complex_dd a, complex_dd b) {
    return (complex_dd){algsurf_dd_add(a.re, b.re), algsurf_dd_add(a.im, b.im)};
}

/* At least the modulus, at most sqrt 2 of it. */
static double extent(complex_dd a) { return fabs(a.re.hi) + fabs(a.im.hi); }

typedef struct value {
    complex_dd p, d; /* p(z), p'(z) */
    double error;    /* bound on that of p(z) */
    double size, radius;
    algsurf_i_local c;
    double scale;
    complex_dd z;
} value;

static value evaluate(algsurf_i_roots *p, int i) {
    value v;
    v.c = algsurf_i_in_unit_of(p, p->x[i], p->y[i]);
    v.scale = v.c.unit ? ldexp(1, -v.c.unit) : 1;
    v.z = (complex_dd){algsurf_dd_scale((algsurf_dd){p->x[i], p->xl[i]}, v.scale),
                       algsurf_dd_scale((algsurf_dd){p->y[i], p->yl[i]}, v.scale)};
    double az = sqrt(v.z.re.hi * v.z.re.hi + v.z.im.hi * v.z.im.hi) * (1 + 8 * ALGSURF_U);
    const algsurf_dd zero = {0, 0};
    v.p = (complex_dd){algsurf_dd_from(v.c.cr[p->n]), algsurf_dd_from(v.c.ci[p->n])};
    v.d = (complex_dd){zero, zero};
    v.error = 0;
    v.size = v.c.size[p->n];
    v.radius = v.c.radius[p->n];
    for (int k = p->n - 1; k >= 0; k--) {
        v.d = sum(times(v.d, v.z), v.p);
        v.error = (v.error + 15 * 0x1p-106 * extent(v.p)) * az;
        v.p = plus(times(v.p, v.z), v.c.cr[k], v.c.ci[k]);
        v.error += 3 * 0x1p-106 * extent(v.p);
        v.size = v.size * az + v.c.size[k];
        v.radius = v.radius * az + v.c.radius[k];
    }
    return v;
}

static void set_residual(algsurf_i_roots *p, int i) {
    value v = evaluate(p, i);
    p->residual[i] = (extent(v.p) + v.error + v.radius) * (1 + 16 * (p->n + 2) * ALGSURF_U) + 0x1p-1000;
    p->exponent[i] = v.c.exponent;
}

/* sum over j != i of 1/(z_i - z_j), in the unit of root i. */
static void attraction(const algsurf_i_roots *p, int i, double scale, double *sr, double *si) {
    *sr = *si = 0;
    for (int j = 0; j < p->n; j++) {
        if (j == i) continue;
        double dx = ((p->x[i] - p->x[j]) + (p->xl[i] - p->xl[j])) * scale;
        double dy = ((p->y[i] - p->y[j]) + (p->yl[i] - p->yl[j])) * scale;
        double d2 = dx * dx + dy * dy;
        if (!(d2 > 0 && d2 < HUGE_VAL)) continue;
        *sr += dx / d2;
        *si -= dy / d2;
    }
}

static int is_tiny(double x, double y) { return fmax(fabs(x), fabs(y)) < DBL_MIN; }

/* One correction; returns 1 when it was below what can be told. */
static int correct(algsurf_i_roots *p, int i) {
    value v = evaluate(p, i);
    double sr, si, pr = v.p.re.hi / v.size, pi = v.p.im.hi / v.size; /* squares are formed */
    attraction(p, i, v.scale, &sr, &si);
    double qr = v.d.re.hi / v.size - (pr * sr - pi * si), qi = v.d.im.hi / v.size - (pr * si + pi * sr);
    double q = qr * qr + qi * qi;
    if (extent(v.p) <= 2 * (v.error + v.radius) || !(q > 0)) return 1; /* closer would be into the noise */
    double xr = -(pr * qr + pi * qi) / q, xi = -(pi * qr - pr * qi) / q;
    if (!isfinite(xr) || !isfinite(xi)) return 1;
    algsurf_dd x = algsurf_dd_add_d(v.z.re, xr), y = algsurf_dd_add_d(v.z.im, xi);
    if (is_tiny(x.hi / v.scale, y.hi / v.scale)) return 1; /* out of reach */
    p->x[i] = x.hi / v.scale;
    p->xl[i] = x.lo / v.scale;
    p->y[i] = y.hi / v.scale;
    p->yl[i] = y.lo / v.scale;
    return xr * xr + xi * xi <= 0x1p-196 * (v.z.re.hi * v.z.re.hi + v.z.im.hi * v.z.im.hi);
}

/* Members of a group that lie on the real axis or on one another are moved apart: from symmetric
 * places the iteration would not leave the symmetry. */
static void disperse(algsurf_i_roots *p) {
    for (int i = 0; i < p->n; i++) {
        if (p->done[i]) continue;
        double size = fabs(p->x[i]) + fabs(p->y[i]), point[2];
        algsurf_i_circle(1 + TURN * i, point);
        for (int j = 0; j < i; j++) {
            if (fabs(p->x[i] - p->x[j]) + fabs(p->y[i] - p->y[j]) > 0x1p-40 * size) continue;
            p->x[i] += 0x1p-38 * size * point[0];
            p->y[i] += 0x1p-38 * size * point[1];
        }
        if (p->y[i] == 0) p->y[i] = 0x1p-40 * size * point[1];
        p->xl[i] = p->yl[i] = 0;
    }
}

/* Roots that are too small for this unit have no digits to iterate with, and as several approximations 0 they
 * would have no discs and take all others along.  From a small circle, each in its own direction, or from 0
 * if there is but one, discs enclose them. */
static void settle_tiny(algsurf_i_roots *p) {
    int tiny = 0;
    for (int i = 0; i < p->n; i++) tiny += !p->done[i] && is_tiny(p->x[i], p->y[i]);
    double radius = tiny > 1 ? 0x1p-1040 : 0; /* still with 34 bits */
    for (int i = 0; i < p->n; i++) {
        if (p->done[i] || !is_tiny(p->x[i], p->y[i])) continue;
        p->done[i] = MOVED;
        double point[2];
        algsurf_i_circle(TURN * i + 0.7, point);
        p->x[i] = radius * point[0];
        p->y[i] = radius * point[1];
        p->xl[i] = p->yl[i] = 0;
    }
}

void algsurf_i_roots_retry(algsurf_i_roots *p) {
    settle_tiny(p);
    disperse(p);
    for (int i = 0; i < p->n; i++) p->retries += !p->done[i];
    for (int sweep = 0, left = 1; sweep < SWEEPS && left; sweep++) {
        left = 0;
        for (int i = 0; i < p->n; i++) {
            if (p->done[i]) continue;
            if (correct(p, i))
                p->done[i] = MOVED;
            else
                left = 1;
        }
    }
    for (int i = 0; i < p->n; i++) /* of the point where it stopped */
        if (p->done[i] != 1) set_residual(p, i);
}

void algsurf_i_roots_sharpen(algsurf_i_roots *p, int i) {
    value v = evaluate(p, i);
    double pr = v.p.re.hi / v.size, pi = v.p.im.hi / v.size, dr = v.d.re.hi / v.size, di = v.d.im.hi / v.size;
    double d2 = dr * dr + di * di, xr = -(pr * dr + pi * di) / d2, xi = -(pi * dr - pr * di) / d2;
    if (isfinite(xr) && isfinite(xi)) {
        algsurf_dd x = algsurf_dd_add_d(v.z.re, xr), y = algsurf_dd_add_d(v.z.im, xi);
        p->x[i] = x.hi / v.scale;
        p->xl[i] = x.lo / v.scale;
        p->y[i] = y.hi / v.scale;
        p->yl[i] = y.lo / v.scale;
    }
    set_residual(p, i);
}
