/* exact_zoom.c - a step to a cluster: from a cell that halving would take dozens of steps to narrow down.
 *
 * v roots that lie together are near a root of the (v-1)-th derivative.  Newton's method finds it, in double;
 * the other coefficients about it tell how far the cluster reaches.  Then the cell is cut at two places left
 * and right of it, at multiples of 2^-k, and if both outer parts are proved to have no root, only the middle
 * is made, in integers.
 *
 * The proof, in double.  Let M = max|b_j|.  Coefficients are off by 2^-52 M and 2^-900 M.  A step of
 * de Casteljau's scheme, a + x (b - a) with 0 <= x <= 1, keeps that error, for the exact step is a mean, and
 * adds at most 5u M: the difference rounds by 2u M, the product by 2u M, the sum by u M.  After n steps the
 * error is below (2.5 n + 1) 2^-52 M to first order; (3 n + 6) 2^-52 M takes in the rest.  Coefficients of
 * one sign, all larger than that, have no root between them. */
#include "../base/arithmetic.h"
#include <math.h>
#include <string.h>

#include "exact_walk.h"
#include "../base/elementary.h"

enum { MOST_BITS = 46 }; /* of v k: beyond, doubles do not tell the outer parts from 0 */

/* One round of the scheme at x for entries 0 .. m. */
static void mean_all(double *b, int m, double x) {
    for (int j = 0; j < m; j++) b[j] += x * (b[j + 1] - b[j]);
}

/* The place of a root of the (v-1)-th derivative in (0,1), and the v-th derivative there over v!; 0: none
 * found.  room: for 2 (n + 1) doubles, here and below. */
static double cluster_centre(const double *b, int n, int v, double *room, double *lead) {
    double *w = room, *t = room + n + 1, x = 0.5, slope = 0;
    int m = n - (v - 1);
    memcpy(w, b, sizeof *w * (size_t)(n + 1));
    for (int d = n; d > m; d--) /* differences: divided by d, as binomials are below */
        for (int j = 0; j < d; j++) w[j] = w[j + 1] - w[j];
    for (int round = 0; round < 6; round++) {
        memcpy(t, w, sizeof *t * (size_t)(m + 1));
        for (int i = m; i > 1; i--) mean_all(t, i, x);
        slope = m * (t[1] - t[0]);
        double next = x - (t[0] + x * (t[1] - t[0])) / slope, step = fabs(next - x);
        if (!(next > 0 && next < 1)) return 0;
        x = next;
        if (step < 0x1p-30) break;
    }
    *lead = fabs(slope) / m;
    return x;
}

/* How far from x the v roots nearest to it are, roughly: p about x is sum C(n,i) D_i (y - x)^i, with
 * differences D_i of the coefficients over [x, x + 1], and D_v = lead. */
static double cluster_radius(const double *b, int n, int v, double *room, double x, double lead) {
    double *t = room, *right = room + n + 1, binomial = 1, radius = 0;
    memcpy(t, b, sizeof *t * (size_t)(n + 1));
    for (int i = n; i >= 0; i--) {
        right[i] = t[i];
        mean_all(t, i, x);
    }
    double scale = 1; /* (1 - x)^i */
    for (int i = 1; i <= v; i++) binomial *= (double)(n - i + 1) / i;
    lead *= binomial;
    binomial = 1;
    for (int i = 0; i < v; i++) {
        radius = fmax(radius, algsurf_i_pow(fabs(right[0]) * binomial / scale / lead, 1.0 / (v - i)));
        for (int j = 0; j < n - i; j++) right[j] = right[j + 1] - right[j];
        binomial *= (double)(n - i) / (i + 1);
        scale *= 1 - x;
    }
    return radius;
}

/* Are all coefficients left of x (right of it) of the sign at that end, beyond the bound? */
static int outer_is_clear(const double *b, int n, double *t, double x, int at_right, double bound) {
    double sign = copysign(1, at_right ? b[n] : b[0]);
    memcpy(t, b, sizeof *t * (size_t)(n + 1));
    for (int i = n; i >= 0; i--) {
        if (!(sign * (at_right ? t[i] : t[0]) > bound)) return 0;
        mean_all(t, i, x);
    }
    return 1;
}

/* The new cell, last taken, to the place of the old one, with no more limbs than it needs; where a new block
 * of memory was begun, both stay. */
static int take_place(algsurf_memory *m, algsurf_exact_cell *cell, algsurf_exact_cell *part) {
    int n = part->b.degree;
    algsurf_exact_strip(part);
    part->variations = algsurf_exact_variations(part);
    if (cell->begin.last == m->last) {
        int width = algsurf_z_width(part->bits + n + 1);
        if (width > part->b.width) width = part->b.width;
        algsurf_memory_release(m, cell->begin);
        part->begin = cell->begin;
        if (!algsurf_exact_move_cell(m, part, width, part->position_width)) return 0;
    }
    *cell = *part;
    return 1;
}

/* The part [x, x+2] 2^-k of the cell.  With E the step from b_j to b_(j+1) and D = E - 1, the differences
 * over [x,y] are D'_j = (1 + x D)^(n-j) (y - x)^j D^j b_0; a factor 2^(k n) makes them integers. */
static int make_middle(algsurf_memory *m, algsurf_exact_cell *cell, int k, algsurf_limb x) {
    int n = cell->b.degree, width = algsurf_z_width(cell->bits + n * (k + 4) + 2);
    int position_width = algsurf_z_width(cell->depth + cell->fine + k + 66);
    algsurf_exact_cell part = *cell;
    part.begin = algsurf_memory_here(m);
    if (!algsurf_exact_move_cell(m, &part, width, position_width)) return 0;
    algsurf_zpoly_join_neighbours(&part.b, 1);
    for (int j = 0; j < n; j++) algsurf_z_shift_up(algsurf_zpoly_at(&part.b, j), width, k * (n - j));
    for (int i = 1; i <= n; i++)
        for (int j = 0; j <= n - i; j++)
            algsurf_z_add_product(algsurf_zpoly_at(&part.b, j), width, algsurf_zpoly_at(&part.b, j + 1),
                                  width, x, 0);
    for (int j = 1; j <= n; j++) algsurf_z_shift_up(algsurf_zpoly_at(&part.b, j), width, j);
    algsurf_zpoly_join_neighbours(&part.b, 0);
    algsurf_z_shift_up(part.position, position_width, k);
    algsurf_z_add_product(part.position, position_width, &x, 1, (algsurf_limb)1 << (cell->fine & 63),
                          cell->fine / 64);
    part.depth += k - 1;
    part.fine += 1;
    part.left_done = 0;
    return take_place(m, cell, &part);
}

int algsurf_exact_zoom(algsurf_memory *m, algsurf_exact_cell *cell, int v, int *done) {
    int n = cell->b.degree;
    algsurf_memory_mark mark = algsurf_memory_here(m);
    double *b = algsurf_i_take(m, 3 * (size_t)(n + 1) * sizeof *b);
    double lead = 0, x = 0, bound = (3 * n + 6) * 0x1p-52;
    *done = 0;
    if (!b) return 0;
    double *room = b + n + 1;
    algsurf_exact_cell_doubles(cell, b);
    double centre = cluster_centre(b, n, v, room, &lead);
    double radius = centre > 0 && lead > 0 ? cluster_radius(b, n, v, room, centre, lead) : 1;
    int most = MOST_BITS / v, k = radius < ldexp(1, -most - 2) ? most : -ilogb(radius) - 3;
    for (; k >= 4; k -= 3) {
        double where = ldexp(centre, k);
        if (!(where >= 1 && where < ldexp(1, k) - 2)) continue;
        x = floor(where - 0.5);
        *done = outer_is_clear(b, n, room, ldexp(x, -k), 0, bound) &&
                outer_is_clear(b, n, room, ldexp(x + 2, -k), 1, bound);
        if (*done) break;
    }
    algsurf_memory_release(m, mark);
    return !*done || make_middle(m, cell, k, (algsurf_limb)x);
}
