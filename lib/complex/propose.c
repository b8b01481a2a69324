/* propose.c - approximations of all roots at once, by the Ehrlich-Aberth iteration.
 *
 * Start values: the upper convex hull of (k, log2 |c_k|) has as many edges as there are magnitudes of
 * roots; an edge from k to k+m asks for m points on the circle whose radius is its slope (Bini 1996).
 * Angles are irrational parts of a turn, so that no start value lies on an axis of symmetry, which
 * the iteration could not leave.
 *
 * Iteration: z <- z - N / (1 - N sum_j 1/(z - z_j)), N = p(z)/p'(z): Newton's method on p divided by the
 * other approximations; of third order at simple roots (Aberth 1973).
 */
#include "../base/arithmetic.h"
#include <math.h>

#include "impl.h"
#include "../simd/pair.h"
#include "../poly/hull.h"
#include "../base/elementary.h"

#define LANES 4
#define PAIRS (LANES / 2)
#define TURN 2.3999632297286535 /* the golden part of a full turn, in radians */
#define SWEEPS 60 /* cubic convergence needs about ten; clusters converge linearly and end in retry */

algsurf_i_local algsurf_i_in_unit_of(algsurf_i_roots *p, double x, double y) {
    if (p->narrow) return (algsurf_i_local){p->cr, p->ci, p->size, p->radius, 0, 0};
    int unit = ilogb(fmin(fmax(fmax(fabs(x), fabs(y)), 0x1p-1010), 0x1p1010)), common = -0x7fffffff, n = p->n;
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
    return size > 0 ? algsurf_i_log2(size) + p->shift[k] : -HUGE_VAL;
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
        double rho = algsurf_i_exp2(fmin(fmax(slope, -1010), 1010));
        p->reach = fmax(p->reach, rho);
        for (int j = 0; j < m; j++, i++) {
            double point[2];
            algsurf_i_circle(turn * ((double)j / m + golden * e + 0.11), point);
            p->x[i] = rho * point[0];
            p->y[i] = rho * point[1];
        }
    }
    p->unit_of_reach = 1 / p->reach;
}

/* A point that has left the disc of all roots is put back, each in its own direction: out there values
 * overflow and the way home is long. */
static int recall(algsurf_i_roots *p, int i) {
    double x = p->x[i] * p->unit_of_reach, y = p->y[i] * p->unit_of_reach;
    if (x * x + y * y <= 4) return 0;
    double point[2];
    algsurf_i_circle(TURN * i + 0.7, point);
    p->x[i] = p->reach * point[0];
    p->y[i] = p->reach * point[1];
    return 1;
}

/* Roots are corrected four at a time, in two pairs: a single one would wait for each sum of its Horner
 * scheme. */
typedef struct batch {
    int who[LANES];
    algsurf_pair zr[PAIRS], zi[PAIRS];              /* in units of the coefficients */
    algsurf_pair pr[PAIRS], pi[PAIRS];              /* p(z) / sum |c_k| |z|^k: squares will be formed */
    algsurf_pair dr[PAIRS], di[PAIRS];              /* p'(z), likewise */
    algsurf_pair az2[PAIRS];                        /* |z|^2 */
    algsurf_pair sr[PAIRS], si[PAIRS], near[PAIRS]; /* sum 1/(z - z_j), largest |1/(z - z_j)|^2 */
} batch;

static ALGSURF_INLINE void evaluate(batch *b, const algsurf_i_local *c, int n, int pairs) {
    algsurf_pair zr[PAIRS], zi[PAIRS], az[PAIRS], pr[PAIRS], pi[PAIRS], dr[PAIRS], di[PAIRS], size[PAIRS];
    for (int l = 0; l < pairs; l++) {
        zr[l] = b->zr[l], zi[l] = b->zi[l], b->az2[l] = zr[l] * zr[l] + zi[l] * zi[l];
        az[l] = algsurf_pair_sqrt(b->az2[l]);
        pr[l] = algsurf_both(c->cr[n]), pi[l] = algsurf_both(c->ci[n]), dr[l] = di[l] = algsurf_both(0),
        size[l] = algsurf_both(c->size[n]);
    }
    for (int k = n - 1; k >= 0; k--)
        for (int l = 0; l < pairs; l++) {
            algsurf_pair t = dr[l] * zr[l] - di[l] * zi[l] + pr[l];
            di[l] = dr[l] * zi[l] + di[l] * zr[l] + pi[l];
            dr[l] = t;
            t = pr[l] * zr[l] - pi[l] * zi[l] + c->cr[k];
            pi[l] = pr[l] * zi[l] + pi[l] * zr[l] + c->ci[k];
            pr[l] = t;
            size[l] = size[l] * az[l] + c->size[k];
        }
    for (int l = 0; l < pairs; l++) {
        algsurf_pair unit = 1 / size[l];
        b->pr[l] = pr[l] * unit, b->pi[l] = pi[l] * unit, b->dr[l] = dr[l] * unit, b->di[l] = di[l] * unit;
    }
}

/* The sums over the other roots, in units of 1/scale; those so far away that their inverse is 0 do not
 * count. */
static ALGSURF_INLINE void attraction(batch *b, const algsurf_i_roots *p, double scale, int pairs) {
    algsurf_pair x[PAIRS], y[PAIRS], sr[PAIRS] = {{0}}, si[PAIRS] = {{0}}, near[PAIRS] = {{0}};
    const algsurf_pair none = {0, 0};
    algsurf_pair_mask who[PAIRS];
    for (int l = 0; l < pairs; l++) {
        int one = b->who[2 * l], two = b->who[2 * l + 1];
        x[l] = (algsurf_pair){p->x[one], p->x[two]}, y[l] = (algsurf_pair){p->y[one], p->y[two]};
        who[l] = (algsurf_pair_mask){one, two};
    }
    for (int j = 0; j < p->n; j++)
        for (int l = 0; l < pairs; l++) {
            algsurf_pair dx = (x[l] - p->x[j]) * scale, dy = (y[l] - p->y[j]) * scale;
            algsurf_pair inverse = algsurf_pair_select(who[l] != j, 1 / (dx * dx + dy * dy), none);
            algsurf_pair_mask counts = inverse > 0;
            sr[l] += algsurf_pair_select(counts, dx * inverse, none);
            si[l] -= algsurf_pair_select(counts, dy * inverse, none);
            near[l] = algsurf_pair_select(inverse > near[l], inverse, near[l]);
        }
    for (int l = 0; l < pairs; l++) b->sr[l] = sr[l], b->si[l] = si[l], b->near[l] = near[l];
}

/* Moves root i; returns 1 when it needs no further correction: it is then wrong by about the square of the
 * step, relative to its nearest neighbour, or its value is all rounding. */
static int step(algsurf_i_roots *p, const batch *b, int lane, double scale) {
    int i = b->who[lane], l = lane / 2, h = lane % 2;
    double pr = b->pr[l][h], pi = b->pi[l][h], sr = b->sr[l][h], si = b->si[l][h], az2 = b->az2[l][h];
    if (pr * pr + pi * pi <= 4 * ALGSURF_U * ALGSURF_U) return 1;
    /* step = p / (p' - p S) */
    double qr = b->dr[l][h] - (pr * sr - pi * si), qi = b->di[l][h] - (pr * si + pi * sr);
    double q = qr * qr + qi * qi, nearest = b->near[l][h];
    if (!(q > 0) || !(nearest < HUGE_VAL)) {
        /* on a stationary point or on another root: a little away, each in its own direction */
        double away = 0x1p-20 * (sqrt(az2) + 1) / scale, point[2];
        algsurf_i_circle(TURN * i + 0.7, point);
        p->x[i] += away * point[0];
        p->y[i] += away * point[1];
        return 0;
    }
    double xr = (pr * qr + pi * qi) / q, xi = (pi * qr - pr * qi) / q, length2 = xr * xr + xi * xi;
    p->x[i] = (b->zr[l][h] - xr) / scale;
    p->y[i] = (b->zi[l][h] - xi) / scale;
    return length2 * nearest < 0x1p-40 || length2 <= 0x1p-102 * az2;
}

/* One correction of each of the `count` roots in the batch; returns how many are done. */
static ALGSURF_INLINE int correct(algsurf_i_roots *p, batch *b, int count, int pairs) {
    int finished = 0;
    for (int l = count; l < 2 * pairs; l++) b->who[l] = b->who[0];
    algsurf_i_local c = algsurf_i_in_unit_of(p, p->x[b->who[0]], p->y[b->who[0]]);
    double scale = c.unit ? ldexp(1, -c.unit) : 1;
    for (int l = 0; l < pairs; l++) {
        int one = b->who[2 * l], two = b->who[2 * l + 1];
        b->zr[l] = (algsurf_pair){p->x[one], p->x[two]} * scale;
        b->zi[l] = (algsurf_pair){p->y[one], p->y[two]} * scale;
    }
    evaluate(b, &c, p->n, pairs);
    attraction(b, p, scale, pairs);
    for (int lane = 0; lane < count; lane++) {
        int i = b->who[lane];
        p->done[i] = step(p, b, lane, scale);
        finished += p->done[i];
    }
    p->iterations += count;
    return finished;
}

/* A correction of each root that is left, `lanes` at a time; returns how many are done. */
static ALGSURF_INLINE int sweep(algsurf_i_roots *p, int lanes) {
    int finished = 0, count = 0;
    batch b;
    for (int i = 0; i < p->n; i++) {
        if (p->done[i] || recall(p, i)) continue;
        b.who[count++] = i;
        if (count < lanes) continue;
        finished += correct(p, &b, count, (lanes + 1) / 2);
        count = 0;
    }
    return count > 0 ? finished + correct(p, &b, count, (lanes + 1) / 2) : finished;
}

/* In a wide problem each root has a unit of its own, so it goes alone. */
void algsurf_i_roots_propose(algsurf_i_roots *p) {
    int left = p->n;
    for (int i = 0; i < p->n; i++) p->done[i] = 0;
    for (int k = 0; k < SWEEPS && left > 0; k++) left -= p->narrow ? sweep(p, LANES) : sweep(p, 1);
}
