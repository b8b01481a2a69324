/* allroots_propose.c - approximations of all roots at once, by the Ehrlich-Aberth iteration.
 *
 * Start values: the upper convex hull of (k, log2 |c_k|) has as many edges as there are magnitudes of
 * roots; an edge from k to k+m asks for m points on the circle whose radius is its slope (Bini 1996).
 * Angles are irrational parts of a turn, so that no start value lies on an axis of symmetry, which
 * the iteration could not leave.
 *
 * Iteration: z <- z - N / (1 - N sum_j 1/(z - z_j)), N = p(z)/p'(z): Newton's method on p divided by the
 * other approximations; of third order at simple roots (Aberth 1973).
 */
#include <math.h>

#include "allroots_impl.h"
#include "poly_hull.h"

#define SWEEPS 60 /* cubic convergence needs about ten; clusters converge linearly and end in retry */

algsurf_i_local algsurf_i_in_unit_of(algsurf_i_roots *p, double x, double y) {
    if (p->narrow) return (algsurf_i_local){p->cr, p->ci, p->size, p->radius, 0, 0};
    int unit = ilogb(fmin(fmax(fmax(fabs(x), fabs(y)), 0x1p-1000), 0x1p1000)), common = -0x7fffffff, n = p->n;
    for (int k = 0; k <= n; k++)
        if (p->size[k] > 0 && ilogb(p->size[k]) + p->shift[k] + k * unit > common)
            common = ilogb(p->size[k]) + p->shift[k] + k * unit;
    for (int k = 0; k <= n; k++) {
        int shift = p->shift[k] + k * unit - common;
        p->lr[k] = ldexp(p->cr[k], shift);
        p->li[k] = ldexp(p->ci[k], shift);
        p->ls[k] = ldexp(p->size[k], shift);
        p->le[k] = ldexp(p->radius[k], shift) + 0x1p-1073; /* what the scaling may lose */
    }
    return (algsurf_i_local){p->lr, p->li, p->ls, p->le, unit, common};
}

static double log_size(const algsurf_i_roots *p, int k) {
    double size = p->size[k] > 0 ? p->size[k] : p->radius[k];
    return size > 0 ? log2(size) + p->shift[k] : -HUGE_VAL;
}

void algsurf_i_roots_start(algsurf_i_roots *p) {
    const double turn = 6.283185307179586, golden = 0.6180339887498949;
    double height[ALGSURF_MAX_POLY_DEGREE + 1];
    int corner[ALGSURF_MAX_POLY_DEGREE + 1], i = 0;
    for (int k = 0; k <= p->n; k++) height[k] = log_size(p, k);
    int count = algsurf_i_upper_hull(height, 0, p->n, corner);
    double limit = 400.0 / p->n; /* values within twice that radius stay within the range of double */
    p->reach = 0;
    for (int e = 1; e < count; e++) {
        int from = corner[e - 1], m = corner[e] - from;
        double slope = (height[from] - height[corner[e]]) / m;
        if (!(fabs(slope) < limit)) p->narrow = 0;
        double rho = exp2(fmin(fmax(slope, -1000), 1000));
        p->reach = fmax(p->reach, rho);
        for (int j = 0; j < m; j++, i++) {
            double angle = turn * ((double)j / m + golden * e + 0.11);
            p->x[i] = rho * cos(angle);
            p->y[i] = rho * sin(angle);
        }
    }
    p->unit_of_reach = 1 / p->reach;
}

/* sum over j != i of 1/(z_i - z_j), in units of 1/scale, and the largest of |1/(z_i - z_j)|^2. */
static double attraction(const algsurf_i_roots *p, int i, double scale, double *sr, double *si) {
    double a = 0, b = 0, nearest = 0;
    for (int j = 0; j < p->n; j++) {
        if (j == i) continue;
        double dx = (p->x[i] - p->x[j]) * scale, dy = (p->y[i] - p->y[j]) * scale;
        double inverse = 1 / (dx * dx + dy * dy);
        if (inverse == 0) continue; /* far away: dx may be infinite */
        a += dx * inverse;
        b -= dy * inverse;
        nearest = inverse > nearest ? inverse : nearest;
    }
    *sr = a;
    *si = b;
    return nearest;
}

/* A point that has left the disc of all roots is put back, each in its own direction: out there values
 * overflow and the way home is long. */
static int recall(algsurf_i_roots *p, int i) {
    double x = p->x[i] * p->unit_of_reach, y = p->y[i] * p->unit_of_reach;
    if (x * x + y * y <= 4) return 0;
    p->x[i] = p->reach * cos(2.3999632297286535 * i + 0.7);
    p->y[i] = p->reach * sin(2.3999632297286535 * i + 0.7);
    return 1;
}

/* One correction; returns 1 when the root needs no further one: it is then wrong by about the square of
 * the step, relative to its nearest neighbour, or its value is all rounding. */
static int correct(algsurf_i_roots *p, int i) {
    if (recall(p, i)) return 0;
    algsurf_i_local c = algsurf_i_in_unit_of(p, p->x[i], p->y[i]);
    double scale = c.unit ? ldexp(1, -c.unit) : 1, zr = p->x[i] * scale, zi = p->y[i] * scale;
    double pr = c.cr[p->n], pi = c.ci[p->n], dr = 0, di = 0, size = c.size[p->n],
           az = sqrt(zr * zr + zi * zi);
    for (int k = p->n - 1; k >= 0; k--) {
        double t = dr * zr - di * zi + pr;
        di = dr * zi + di * zr + pi;
        dr = t;
        t = pr * zr - pi * zi + c.cr[k];
        pi = pr * zi + pi * zr + c.ci[k];
        pr = t;
        size = size * az + c.size[k];
    }
    double unit = 1 / size; /* squares are formed */
    pr *= unit, pi *= unit, dr *= unit, di *= unit;
    if (pr * pr + pi * pi <= 4 * ALGSURF_U * ALGSURF_U) return 1;
    double sr, si, nearest = attraction(p, i, scale, &sr, &si);
    /* step = p / (p' - p S) */
    double qr = dr - (pr * sr - pi * si), qi = di - (pr * si + pi * sr), q = qr * qr + qi * qi;
    if (!(q > 0) || !(nearest < HUGE_VAL)) { /* on a stationary point or on another root: move a little */
        p->x[i] += (az + 1) / scale * 0x1p-20;
        p->y[i] += (az + 1) / scale * 0x1.8p-21;
        return 0;
    }
    double xr = (pr * qr + pi * qi) / q, xi = (pi * qr - pr * qi) / q, step = xr * xr + xi * xi;
    p->x[i] = (zr - xr) / scale;
    p->y[i] = (zi - xi) / scale;
    return step * nearest < 0x1p-40 || step <= 0x1p-102 * az * az;
}

void algsurf_i_roots_propose(algsurf_i_roots *p) {
    int left = p->n;
    for (int i = 0; i < p->n; i++) p->done[i] = 0;
    for (int sweep = 0; sweep < SWEEPS && left > 0; sweep++)
        for (int i = 0; i < p->n; i++) {
            if (p->done[i]) continue;
            p->iterations++;
            if (correct(p, i)) {
                p->done[i] = 1;
                left--;
            }
        }
}
