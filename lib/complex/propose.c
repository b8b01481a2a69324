/* propose.c - approximations of all roots at once, by the Ehrlich-Aberth iteration in double.
 *
 * Start values: the upper convex hull of (k, log2 |c_k|) has as many edges as there are magnitudes of
 * roots; an edge from k to k+m asks for m points on the circle whose radius is its slope (Bini 1996).
 * Angles are irrational parts of a turn, so that no start value lies on an axis of symmetry, which
 * the iteration could not leave.
 *
 * Iteration (many_template.h): z <- z - N / (1 - N sum_j 1/(z - z_j)), N = p(z)/p'(z): Newton's method on p
 * divided by the other approximations; of third order at simple roots (Aberth 1973).  The variable is in a
 * unit in which the first and the last coefficient are of one size; beyond the unit circle the polynomial of
 * the inverse roots is used, so that no value overflows.  Where coefficients differ so much that they
 * underflow, the start values are the answer.
 */
#include "../base/arithmetic.h"
#include <math.h>
#include <string.h>

#include "discs.h"
#include "../base/elementary.h"

#define SWEEPS 60          /* cubic convergence needs about ten; clusters converge linearly */
#define FLAT 900           /* log2 of what corners of the hull may differ by, */
#define STEEP 400          /* and slopes of its edges */
#define LEAST_END 0x1p-700 /* of the first and the last coefficient, for values in doubles */

/* Corners of the upper convex hull of the points (k, height[k]), k = 0 .. n, of which some may be at -inf, by
 * Andrew's monotone chain (1979); returns how many. */
static int upper_hull(const double *height, int n, int *corner) {
    int count = 0;
    for (int k = 0; k <= n; k++) {
        if (isinf(height[k])) continue;
        for (; count >= 2; count--) { /* drop corners that lie on or under the line to the new point */
            int a = corner[count - 2], b = corner[count - 1];
            if ((height[b] - height[a]) * (k - a) > (height[k] - height[a]) * (b - a)) break;
        }
        corner[count++] = k;
    }
    return count;
}

int algsurf_i_start(algsurf_memory *memory, const algsurf_scaled *size, int n, algsurf_scaled *z, int *fit) {
    const double turn = 6.283185307179586, golden = 0.6180339887498949;
    double top = -HUGE_VAL, low = HUGE_VAL, steep = 0;
    int i = 0;
    algsurf_memory_mark mark = algsurf_memory_here(memory);
    double *height = algsurf_i_take(memory, (size_t)(n + 1) * sizeof *height);
    int *corner = algsurf_i_take(memory, (size_t)(n + 1) * sizeof *corner);
    if (!height || !corner) return 0;
    for (int k = 0; k <= n; k++)
        height[k] = size[k].re > 0 ? algsurf_i_log2(size[k].re) + (double)size[k].exponent : -HUGE_VAL;
    int count = upper_hull(height, n, corner);
    const double mean = (height[0] - height[n]) / n;
    for (int e = 1; e < count; e++) {
        int from = corner[e - 1], m = corner[e] - from;
        double slope = (height[from] - height[corner[e]]) / m, whole = floor(slope);
        double rho = algsurf_i_exp2(slope - whole);
        steep = fmax(steep, fabs(slope - mean));
        for (int j = 0; j < m; j++, i++) {
            double point[2];
            algsurf_i_circle(turn * ((double)j / m + golden * e + 0.11), point);
            z[i] = scaled_of(rho * point[0], rho * point[1], (int64_t)whole);
        }
    }
    for (int e = 0; e < count; e++) {
        double h = height[corner[e]] + corner[e] * mean;
        top = fmax(top, h), low = fmin(low, h);
    }
    *fit = low - top > -FLAT && steep < STEEP;
    algsurf_memory_release(memory, mark);
    return 1;
}

/* x 2^k, 0 far below. */
static double scaled_down(double x, int64_t k) { return k < -1000 ? 0 : ldexp(x, (int)k); }

/* p in doubles, in z->flat. */
static int make_flat(algsurf_memory *m, algsurf_i_integers *z) {
    const int n = z->re.degree;
    algsurf_i_flat *p = &z->flat;
    double *room = algsurf_i_take(m, 4 * (size_t)(n + 1) * sizeof *room);
    if (!room) return 0;
    double *re = room, *im = re + n + 1, *size = im + n + 1, *noise = size + n + 1;
    *p = (algsurf_i_flat){.n = n, .exact = 1, .re = re, .im = im, .size = size, .noise = noise};
    p->unit = (z->size[0].exponent - z->size[n].exponent) / n, p->top = INT64_MIN;
    for (int k = 0; k <= n; k++)
        if (z->size[k].re > 0 && z->size[k].exponent + k * p->unit > p->top)
            p->top = z->size[k].exponent + k * p->unit;
    for (int k = 0; k <= n; k++) {
        const int64_t by = k * p->unit - p->top;
        re[k] = scaled_down(z->head[k].re, z->head[k].exponent + by);
        im[k] = scaled_down(z->head[k].im, z->head[k].exponent + by);
        size[k] = scaled_down(z->size[k].re, z->size[k].exponent + by) * (1 + 0x1p-50);
        noise[k] = size[k];
        if (z->radius) noise[k] += scaled_down(z->radius[k].re, z->radius[k].exponent + by + 52);
        p->exact = p->exact && z->exact[k];
    }
    p->exact = p->exact && size[0] >= LEAST_END && size[n] >= LEAST_END;
    return 1;
}

/* ---- the iteration ---- */

typedef struct proposal {
    algsurf_i_approach a;
    double reach, unit_of_reach; /* the largest start radius, its inverse; all roots lie within twice that
                                    (Fujiwara 1916) */
    int *who, blurred;
    unsigned char *done;
} proposal;

void algsurf_i_aside(int i, double way[2]) {
    const double turn = 2.3999632297286535; /* the golden part of a full turn, in radians */
    algsurf_i_circle(turn * i + 0.7, way);
}

static void move_to(proposal *p, int i, double x, double y, double length) {
    double way[2];
    algsurf_i_aside(i, way);
    p->a.x[i] = x + length * way[0];
    p->a.y[i] = y + length * way[1];
}

/* Which points need a step, inside of the unit circle or beyond it.  One that has left the disc of all roots
 * is put back: the way home is long. */
static int list(proposal *p, int beyond, int *who) {
    int count = 0;
    for (int i = 0; i < p->a.p->n; i++) {
        if (p->done[i]) continue;
        double x = p->a.x[i], y = p->a.y[i], u = x * p->unit_of_reach, v = y * p->unit_of_reach;
        if (!(u * u + v * v <= 4)) move_to(p, i, 0, 0, p->reach);
        if ((x * x + y * y > 1) == beyond) who[count++] = i;
    }
    return count;
}

/* A step of each root that is left; returns how many are left then. */
static int sweep(proposal *p, const algsurf_i_allroots_kernel *kernel) {
    int near = list(p, 0, p->who), far = list(p, 1, p->who + near), left = 0;
    kernel->approach(&p->a, p->who, near, 0);
    kernel->approach(&p->a, p->who + near, far, 1);
    for (int k = 0; k < near + far; k++) {
        int i = p->who[k];
        double x = p->a.x[i], y = p->a.y[i];
        if (p->a.state[i] == ALGSURF_I_LOST)
            move_to(p, i, x, y, 0x1p-20 * (sqrt(x * x + y * y) + 1));
        else
            p->a.x[i] = x - p->a.step_x[i], p->a.y[i] = y - p->a.step_y[i];
        p->done[i] = p->a.state[i] == ALGSURF_I_RESTS || p->a.state[i] == ALGSURF_I_BLURRED;
        p->blurred += p->a.state[i] == ALGSURF_I_BLURRED;
        left += !p->done[i];
    }
    return left;
}

static int begin(proposal *p, algsurf_memory *m, const algsurf_i_flat *flat) {
    const size_t n = (size_t)flat->n;
    double *room = algsurf_i_take(m, 4 * n * sizeof *room);
    int *numbers = algsurf_i_take(m, 2 * n * sizeof *numbers);
    *p = (proposal){.done = algsurf_i_take(m, n)};
    if (!room || !numbers || !p->done) return 0;
    memset(p->done, 0, n);
    p->a = (algsurf_i_approach){flat, room, room + n, room + 2 * n, room + 3 * n, numbers};
    p->who = numbers + n;
    return 1;
}

int algsurf_i_propose(algsurf_memory *m, algsurf_i_integers *poly, const algsurf_scaled *given,
                      algsurf_scaled *z, int *corrections, int *settled) {
    proposal p;
    int fit, n = poly->re.degree;
    *settled = 0;
    if (!algsurf_i_start(m, poly->size, n, z, &fit)) return 0;
    const int64_t least = z[0].exponent - 12,
                  most = z[n - 1].exponent + 12; /* roots are within 2n times that */
    for (int i = 0; given && i < n; i++)
        if (given[i].exponent > least && given[i].exponent < most) z[i] = given[i];
    if (!fit) return 1;
    if (!make_flat(m, poly)) return 0;
    algsurf_memory_mark mark = algsurf_memory_here(m);
    if (!begin(&p, m, &poly->flat)) return 0;
    const int64_t unit = poly->flat.unit;
    for (int i = 0; i < n; i++) {
        p.a.x[i] = scaled_down(z[i].re, z[i].exponent - unit);
        p.a.y[i] = scaled_down(z[i].im, z[i].exponent - unit);
        p.reach = fmax(p.reach, sqrt(p.a.x[i] * p.a.x[i] + p.a.y[i] * p.a.y[i]));
    }
    p.unit_of_reach = 1 / p.reach;
    const algsurf_i_allroots_kernel *kernel = algsurf_i_allroots_kernel_for(algsurf_i_kernel_find(NULL));
    int left = n;
    for (int k = 0; corrections && k < SWEEPS && left > 0; k++)
        *corrections += left, left = sweep(&p, kernel);
    *settled = left == 0 && p.blurred == 0;
    for (int i = 0; i < n; i++) z[i] = scaled_of(p.a.x[i], p.a.y[i], unit);
    algsurf_memory_release(m, mark);
    return 1;
}
