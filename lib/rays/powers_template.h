/* powers_template.h - P along LANES rays as polynomials in v, by the nested Horner scheme of surface/eval.c
 * over polynomials: for degrees at which the way over nodes loses too much (surface/nodes.c).
 *
 * The points of a ray are M + v H, -1 <= v <= 1.  Where P has only even powers of a coordinate, the scheme
 * runs in its square M^2 + 2 M H v + H^2 v^2.
 *
 * Error.  M and H are rounded once, and M is off by 2^-63 (|M| + |H|) more at most (packet_template.h).  A
 * linear factor meets a rounding for its own coefficient, one for the product, one for the sum of two
 * products, one for the next coefficient, row or level to be added: 4 for each of at most n factors.  A
 * square stands for two factors: 3 for its coefficients, one product, two sums, one addition: 7.  Joining
 * rows and levels costs 2 more.  The change of basis: 3 for the matrix, one product, n/2 + 3 sums.  All of
 * these multiply magnitudes: so Bernstein coefficient j is off by at most (4.5 n + 12) u sum_k |basis_jk|
 * E_k, where E_k is coefficient k of the same scheme on magnitudes, with |M| + 2^-10 |H| for |M|, which takes
 * in M's 2^-63.  The bound (6 n + 20) u takes in the higher orders and the rounding of E. */
#ifndef ALGSURF_POWERS_TEMPLATE_H
#define ALGSURF_POWERS_TEMPLATE_H
#include "../poly/triangle_template.h"
#include "../roots/descartes_template.h"
#include "../simd/lanes.h"
#include "../surface/impl.h"
#include "chord_template.h"

/* c[0] + c[1] v + c[2] v^2. */
typedef struct coordinate {
    lanes c[3];
} coordinate;

typedef struct line_poly {
    int degree; /* -1: zero */
    lanes c[MOST_DEGREE + 3];
} line_poly;

INLINE coordinate coordinate_of(lanes middle, lanes half, int stride) {
    if (stride == 1) return (coordinate){{middle, half, all_lanes(0)}};
    return (coordinate){{middle * middle, 2 * middle * half, half * half}};
}

INLINE void times_coordinate(line_poly *p, const coordinate *x, int stride) {
    lanes *c = p->c, x0 = x->c[0], x1 = x->c[1], x2 = x->c[2];
    int n = p->degree;
    if (n < 0) return;
    p->degree = n + stride;
    c[n + 1] = c[n + 2] = all_lanes(0);
    if (stride == 1) {
        for (int i = n + 1; i >= 1; i--) c[i] = x0 * c[i] + x1 * c[i - 1];
    } else {
        for (int i = n + 2; i >= 2; i--) c[i] = x0 * c[i] + x1 * c[i - 1] + x2 * c[i - 2];
        c[1] = x0 * c[1] + x1 * c[0];
    }
    c[0] = x0 * c[0];
}

INLINE void add_line_poly(line_poly *p, const line_poly *q) {
    for (int i = p->degree + 1; i <= q->degree; i++) p->c[i] = all_lanes(0);
    for (int i = 0; i <= q->degree; i++) p->c[i] += q->c[i];
    if (q->degree > p->degree) p->degree = q->degree;
}

INLINE void row_along(const algsurf_surface *s, const algsurf_row *row, const coordinate *x, int sizes,
                      line_poly *p) {
    const double *c = s->coef + row->first;
    p->degree = -1;
    for (int i = row->length - 1; i >= 0; i -= s->stride[0]) {
        times_coordinate(p, x, s->stride[0]);
        if (c[i] == 0) continue;
        if (p->degree < 0) p->degree = 0, p->c[0] = all_lanes(0);
        p->c[0] += sizes ? fabs(c[i]) : c[i];
    }
}

/* P along x, or the scheme on magnitudes. */
INLINE void surface_along(const algsurf_surface *s, const coordinate x[3], int sizes, line_poly *p) {
    line_poly level, row;
    p->degree = -1;
    for (int k = s->level_count - 1; k >= 0; k -= s->stride[2]) {
        times_coordinate(p, x + 2, s->stride[2]);
        level.degree = -1;
        for (int j = s->levels[k].count - 1; j >= 0; j -= s->stride[1]) {
            times_coordinate(&level, x + 1, s->stride[1]);
            row_along(s, s->rows + s->levels[k].first + j, x, sizes, &row);
            add_line_poly(&level, &row);
        }
        add_line_poly(p, &level);
    }
}

/* Bernstein coefficients over [-1,1] of degree n, at least P's, and their radii. */
APART void coefficients_from_powers(const algsurf_surface *s, const chord_line *line, int n, lanes *b,
                                    lanes *e) {
    line_poly p, size;
    coordinate x[3], reach[3];
    for (int i = 0; i < 3; i++) {
        lanes far = absolute(line->half[i]), near = absolute(line->middle[i]) + 0x1p-10 * far;
        x[i] = coordinate_of(line->middle[i], line->half[i], s->stride[i]);
        reach[i] = coordinate_of(near, far, s->stride[i]);
    }
    surface_along(s, x, 0, &p);
    surface_along(s, reach, 1, &size);
    for (int k = p.degree + 1; k <= n; k++) p.c[k] = size.c[k] = all_lanes(0);
    double factor = (6 * n + 20) * 0x1p-53 + s->error;
    powers_to_bernstein(s->from_powers, n + 1, p.c, b, n);
    for (int j = 0; 2 * j <= n; j++) {
        const double *basis = s->from_powers + j * (n + 1);
        lanes sum = size.c[0];
        for (int k = 1; k <= n; k++) sum += fabs(basis[k]) * size.c[k];
        e[j] = e[n - j] = factor * sum + LOST_BY_UNDERFLOW;
    }
}

#endif
