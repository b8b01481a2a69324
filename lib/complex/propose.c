/* propose.c - approximations of all roots at once, by the Ehrlich-Aberth iteration in double.
 *
 * Start values: the upper convex hull of (k, log2 |c_k|) has as many edges as there are magnitudes of
 * roots; an edge from k to k+m asks for m points on the circle whose radius is its slope (Bini 1996).
 * Angles are irrational parts of a turn, so that no start value lies on an axis of symmetry, which
 * the iteration could not leave.
 *
 * Iteration: z <- z - N / (1 - N sum_j 1/(z - z_j)), N = p(z)/p'(z): Newton's method on p divided by the
 * other approximations; of third order at simple roots (Aberth 1973).  Where slopes are so steep that values
 * would leave the range of double, the start values are the answer.
 */
#include "../base/arithmetic.h"
#include <math.h>
#include <string.h>

#include "discs.h"
#include "../simd/pair.h"
#include "../poly/hull.h"
#include "../base/elementary.h"
#include "algsurf/poly.h"

#define LANES 4
#define PAIRS (LANES / 2)
#define TURN 2.3999632297286535 /* the golden part of a full turn, in radians */
#define SWEEPS 60               /* cubic convergence needs about ten; clusters converge linearly */

/* In units of 2^unit of the variable; coefficients are at most about 1. */
typedef struct proposal {
    int n, corrections;
    double reach, unit_of_reach; /* the largest start radius, its inverse; all roots lie within twice that
                                    (Fujiwara 1916) */
    double *cr, *ci, *size;      /* degree + 1 */
    double *x, *y;               /* degree */
    unsigned char *done;
} proposal;

int algsurf_i_start(algsurf_memory *memory, const algsurf_scaled *size, int n, algsurf_scaled *z, int *fit) {
    const double turn = 6.283185307179586, golden = 0.6180339887498949;
    double most = -HUGE_VAL, top = -HUGE_VAL, low = HUGE_VAL;
    int i = 0;
    algsurf_memory_mark mark = algsurf_memory_here(memory);
    double *height = algsurf_i_take(memory, (size_t)(n + 1) * sizeof *height);
    int *corner = algsurf_i_take(memory, (size_t)(n + 1) * sizeof *corner);
    if (!height || !corner) return 0;
    for (int k = 0; k <= n; k++)
        height[k] = size[k].re > 0 ? algsurf_i_log2(size[k].re) + (double)size[k].exponent : -HUGE_VAL;
    int count = algsurf_i_upper_hull(height, 0, n, corner);
    for (int e = 1; e < count; e++) {
        int from = corner[e - 1], m = corner[e] - from;
        double slope = (height[from] - height[corner[e]]) / m, whole = floor(slope);
        double rho = algsurf_i_exp2(slope - whole);
        most = fmax(most, slope);
        for (int j = 0; j < m; j++, i++) {
            double point[2];
            algsurf_i_circle(turn * ((double)j / m + golden * e + 0.11), point);
            z[i] = algsurf_i_scaled_of(rho * point[0], rho * point[1], (int64_t)whole);
        }
    }
    for (int e = 0; e < count; e++) { /* in units of the largest root */
        double h = height[corner[e]] + corner[e] * most;
        top = fmax(top, h), low = fmin(low, h);
    }
    *fit = low - top > -900;
    algsurf_memory_release(memory, mark);
    return 1;
}

/* A point that has left the disc of all roots is put back, each in its own direction: out there values
 * overflow and the way home is long. */
static int recall(proposal *p, int i) {
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

static ALGSURF_INLINE void evaluate(batch *b, const proposal *c, int pairs) {
    algsurf_pair zr[PAIRS], zi[PAIRS], az[PAIRS], pr[PAIRS], pi[PAIRS], dr[PAIRS], di[PAIRS], size[PAIRS];
    for (int l = 0; l < pairs; l++) {
        zr[l] = b->zr[l], zi[l] = b->zi[l], b->az2[l] = zr[l] * zr[l] + zi[l] * zi[l];
        az[l] = algsurf_pair_sqrt(b->az2[l]);
        pr[l] = algsurf_both(c->cr[c->n]), pi[l] = algsurf_both(c->ci[c->n]), dr[l] = di[l] = algsurf_both(0),
        size[l] = algsurf_both(c->size[c->n]);
    }
    for (int k = c->n - 1; k >= 0; k--)
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

/* The sums over the other roots; those so far away that their inverse is 0 do not
 * count. */
static ALGSURF_INLINE void attraction(batch *b, const proposal *p, int pairs) {
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
            algsurf_pair dx = (x[l] - p->x[j]), dy = (y[l] - p->y[j]);
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
static int step(proposal *p, const batch *b, int lane) {
    int i = b->who[lane], l = lane / 2, h = lane % 2;
    double pr = b->pr[l][h], pi = b->pi[l][h], sr = b->sr[l][h], si = b->si[l][h], az2 = b->az2[l][h];
    if (pr * pr + pi * pi <= 4 * ALGSURF_U * ALGSURF_U) return 1;
    /* step = p / (p' - p S) */
    double qr = b->dr[l][h] - (pr * sr - pi * si), qi = b->di[l][h] - (pr * si + pi * sr);
    double q = qr * qr + qi * qi, nearest = b->near[l][h];
    if (!(q > 0) || !(nearest < HUGE_VAL)) {
        /* on a stationary point or on another root: a little away, each in its own direction */
        double away = 0x1p-20 * (sqrt(az2) + 1), point[2];
        algsurf_i_circle(TURN * i + 0.7, point);
        p->x[i] += away * point[0];
        p->y[i] += away * point[1];
        return 0;
    }
    double xr = (pr * qr + pi * qi) / q, xi = (pi * qr - pr * qi) / q, length2 = xr * xr + xi * xi;
    p->x[i] = (b->zr[l][h] - xr);
    p->y[i] = (b->zi[l][h] - xi);
    return length2 * nearest < 0x1p-40 || length2 <= 0x1p-102 * az2;
}

/* One correction of each of the `count` roots in the batch; returns how many are done. */
static int correct(proposal *p, batch *b, int count) {
    int finished = 0;
    for (int l = count; l < LANES; l++) b->who[l] = b->who[0];
    for (int l = 0; l < PAIRS; l++) {
        int one = b->who[2 * l], two = b->who[2 * l + 1];
        b->zr[l] = (algsurf_pair){p->x[one], p->x[two]};
        b->zi[l] = (algsurf_pair){p->y[one], p->y[two]};
    }
    evaluate(b, p, PAIRS);
    attraction(b, p, PAIRS);
    for (int lane = 0; lane < count; lane++) {
        int i = b->who[lane];
        p->done[i] = (unsigned char)step(p, b, lane);
        finished += p->done[i];
    }
    p->corrections += count;
    return finished;
}

/* A correction of each root that is left; returns how many are done. */
static int sweep(proposal *p) {
    int finished = 0, count = 0;
    batch b;
    for (int i = 0; i < p->n; i++) {
        if (p->done[i] || recall(p, i)) continue;
        b.who[count++] = i;
        if (count < LANES) continue;
        finished += correct(p, &b, count);
        count = 0;
    }
    return count > 0 ? finished + correct(p, &b, count) : finished;
}

static int begin(proposal *p, algsurf_memory *m, int n) {
    size_t terms = (size_t)n + 1;
    double *room = algsurf_i_take(m, 6 * terms * sizeof *room);
    if (!room) return 0;
    *p = (proposal){.n = n,
                    .cr = room,
                    .ci = room + terms,
                    .size = room + 2 * terms,
                    .x = room + 3 * terms,
                    .y = room + 4 * terms,
                    .done = (unsigned char *)(room + 5 * terms)};
    memset(p->done, 0, terms);
    return 1;
}

/* x 2^k, 0 far below. */
static double scaled_down(double x, int64_t k) { return k < -1000 ? 0 : ldexp(x, (int)k); }

int algsurf_i_propose(algsurf_memory *m, const algsurf_scaled *c, const algsurf_scaled *size,
                      const algsurf_scaled *radius, int n, const algsurf_scaled *given, algsurf_scaled *z,
                      int *corrections) {
    proposal p;
    int fit;
    if (!algsurf_i_start(m, size, n, z, &fit)) return 0;
    const int64_t unit = z[n - 1].exponent;
    const int64_t least = z[0].exponent - 12, most = unit + 12; /* roots are within 2n times that */
    for (int i = 0; given && i < n; i++)
        if (given[i].exponent > least && given[i].exponent < most) z[i] = given[i];
    if (!fit) return 1;
    algsurf_memory_mark mark = algsurf_memory_here(m);
    if (!begin(&p, m, n)) return 0;
    int64_t top = INT64_MIN;
    for (int k = 0; k <= n; k++)
        if (size[k].re > 0 && size[k].exponent + k * unit > top) top = size[k].exponent + k * unit;
    for (int k = 0; k <= n; k++) {
        p.cr[k] = scaled_down(c[k].re, c[k].exponent + k * unit - top);
        p.ci[k] = scaled_down(c[k].im, c[k].exponent + k * unit - top);
        p.size[k] = scaled_down(size[k].re, size[k].exponent + k * unit - top);
        if (radius) p.size[k] += scaled_down(radius[k].re, radius[k].exponent + k * unit - top + 52);
    }
    for (int i = 0; i < n; i++) {
        p.x[i] = scaled_down(z[i].re, z[i].exponent - unit),
        p.y[i] = scaled_down(z[i].im, z[i].exponent - unit);
        p.reach = fmax(p.reach, sqrt(p.x[i] * p.x[i] + p.y[i] * p.y[i]));
    }
    p.unit_of_reach = 1 / p.reach;
    for (int k = 0, left = n; k < SWEEPS && left > 0; k++) left -= sweep(&p);
    for (int i = 0; i < n; i++) z[i] = algsurf_i_scaled_of(p.x[i], p.y[i], unit);
    *corrections += p.corrections;
    algsurf_memory_release(m, mark);
    return 1;
}
