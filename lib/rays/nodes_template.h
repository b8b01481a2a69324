/* nodes_template.h - P along LANES chords, from its values at the surface's nodes v_i: a matrix
 * makes Bernstein coefficients of them (surface/nodes.c), which share one error radius.
 *
 * Error.  Take all magnitudes at reach = |M| + |h d| and let S be P's scheme on them.  M, h d, v_i h d and
 * the sum are rounded: 3 roundings to each of at most n coordinates in a term, beside the 3n + 3 of
 * surface/eval.c for a coordinate with one, so a value is off by (5n+3) u S.  The matrix has relative errors
 * (3n+4) u, the product with it n + 2 roundings; its row sums are at most the surface's amplification A.
 * Together (9n+9) u A S; the bound used is (10n+20) u A S, for higher orders and the rounding of S;
 * coefficients with an error e of their own add e A S. */
#ifndef ALGSURF_NODES_TEMPLATE_H
#define ALGSURF_NODES_TEMPLATE_H
#include "../roots/first_walk_template.h"
#include "../surface/impl.h"
#include "chord_template.h"

#define BLOCK_OF_NODES 7 /* evaluated together, in degrees without code of their own */
#define MOST_NODES 14    /* a multiple of it, above ALGSURF_MAX_NODE_DEGREE */

/* P, or with `sizes` the same scheme on magnitudes, at `block` points at once: x[0], x[1], x[2] and their
 * coordinates, or the squares of these. */
INLINE void surface_scheme(const algsurf_surface *s, int block, int sizes, const lanes *const x[3],
                           lanes *p) {
    lanes level[MOST_NODES], row[MOST_NODES];
    for (int m = 0; m < block; m++) p[m] = all_lanes(0);
    for (int k = s->level_count - 1; k >= 0; k -= s->stride[2]) {
        const algsurf_row *rows = s->rows + s->levels[k].first;
        for (int m = 0; m < block; m++) level[m] = all_lanes(0);
        for (int j = s->levels[k].count - 1; j >= 0; j -= s->stride[1]) {
            const double *c = s->coef + rows[j].first;
            int i = rows[j].length - 1;
            for (int m = 0; m < block; m++) row[m] = all_lanes(i < 0 ? 0 : sizes ? fabs(c[i]) : c[i]);
            for (i -= s->stride[0]; i >= 0; i -= s->stride[0])
                for (int m = 0; m < block; m++) row[m] = row[m] * x[0][m] + (sizes ? fabs(c[i]) : c[i]);
            for (int m = 0; m < block; m++) level[m] = level[m] * x[1][m] + row[m];
        }
        for (int m = 0; m < block; m++) p[m] = p[m] * x[2][m] + level[m];
    }
}

INLINE void surface_values(const algsurf_surface *s, int block, const lanes *const x[3], lanes *p) {
    surface_scheme(s, block, 0, x, p);
}

/* From sizes of coordinates. */
INLINE lanes surface_magnitude(const algsurf_surface *s, const lanes size[3]) {
    lanes x[3], p;
    for (int i = 0; i < 3; i++) x[i] = s->stride[i] == 2 ? size[i] * size[i] : size[i];
    surface_scheme(s, 1, 1, (const lanes *const[]){x, x + 1, x + 2}, &p);
    return p;
}

/* b, from the chord's middle and half of it as a vector. */
INLINE void coefficients_from_nodes(const algsurf_surface *s, const lanes middle[3], const lanes half[3],
                                    lanes *b, int n) {
    const int block = __builtin_constant_p(n) ? n + 1 : BLOCK_OF_NODES;
    lanes x[3][MOST_NODES], p[MOST_NODES];
    for (int i = 0; i < 3; i++) {
        for (int m = 0; m <= n; m++) {
            x[i][m] = middle[i] + s->nodes[m] * half[i];
            if (s->stride[i] == 2) x[i][m] *= x[i][m];
        }
        for (int m = n + 1; m % block; m++) x[i][m] = x[i][n];
    }
    for (int m = 0; m <= n; m += block)
        surface_values(s, block, (const lanes *const[]){x[0] + m, x[1] + m, x[2] + m}, p + m);
    for (int j = 0; j <= n; j++) {
        const double *w = s->to_bernstein + j;
        lanes sum = w[0] * p[0];
        for (int m = 1; m <= n; m++) sum += w[m * ALGSURF_NODE_STRIDE] * p[m];
        b[j] = sum;
    }
}

/* The same bits for one chord, the first lane's: nodes, then coefficients, side by side. */
INLINE void coefficients_of_one(const algsurf_surface *s, const lanes middle[3], const lanes half[3],
                                lanes *b, int n) {
    const int block = n / LANES + 1;
    lanes x[3][MOST_NODES], p[MOST_NODES];
    for (int i = 0; i < 3; i++)
        for (int m = 0; m < block; m++) {
            x[i][m] = middle[i][0] + load(s->nodes + m * LANES) * half[i][0];
            if (s->stride[i] == 2) x[i][m] *= x[i][m];
        }
    surface_values(s, block, (const lanes *const[]){x[0], x[1], x[2]}, p);
    for (int j = 0; j <= n; j += LANES) {
        const double *w = s->to_bernstein + j;
        lanes sum = load(w) * p[0][0];
        for (int m = 1; m <= n; m++) sum += load(w + m * ALGSURF_NODE_STRIDE) * p[m / LANES][m % LANES];
        for (int k = 0; k < LANES && j + k <= n; k++) b[j + k] = all_lanes(sum[k]);
    }
}

#endif
