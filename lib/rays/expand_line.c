/* expand_line.c - P along X + v D in double: the nested Horner scheme over polynomials in v.
 *
 * Error bound.  Along the way of a monomial a x^i y^j z^k every factor X + v D costs a rounding for X
 * itself, one for the product, one for the sum of the two products, and the scheme one more for the
 * next coefficient: 4 (i+j+k); joining rows and levels costs at most 3 more.  The same scheme on
 * magnitudes, M_k, bounds what these roundings multiply, so |error of q_k| <= gamma M_k with
 * gamma = (4 n + 8) ALGSURF_U, which leaves room for higher orders and the rounding of M_k itself;
 * coefficients with an error of their own add it to gamma.
 */
#include "../base/arithmetic.h"
#include <math.h>

#include "expand_impl.h"

typedef struct line_poly {
    int degree; /* -1: zero */
    double v[ALGSURF_MAX_DEGREE + 1];
    double m[ALGSURF_MAX_DEGREE + 1]; /* magnitudes */
} line_poly;

/* A coordinate along the line: x + v d. */
typedef struct line_coordinate {
    double x;
    double d, x_size, d_size;
} line_coordinate;

static void times_coordinate(line_poly *p, const line_coordinate *c, int sizes) {
    int n = p->degree;
    if (n < 0) return;
    p->v[n + 1] = c->d * p->v[n];
    for (int i = n; i > 0; i--) p->v[i] = c->x * p->v[i] + c->d * p->v[i - 1];
    p->v[0] = c->x * p->v[0];
    if (sizes) {
        p->m[n + 1] = c->d_size * p->m[n];
        for (int i = n; i > 0; i--) p->m[i] = c->x_size * p->m[i] + c->d_size * p->m[i - 1];
        p->m[0] *= c->x_size;
    }
    p->degree = n + 1;
}

static void add_constant(line_poly *p, double a) {
    if (p->degree < 0) {
        p->degree = 0;
        p->v[0] = a;
        p->m[0] = fabs(a);
    } else {
        p->v[0] += a;
        p->m[0] += fabs(a);
    }
}

static void add_poly(line_poly *p, const line_poly *q, int sizes) {
    for (int i = p->degree + 1; i <= q->degree; i++) {
        p->v[i] = 0;
        p->m[i] = 0;
    }
    if (q->degree > p->degree) p->degree = q->degree;
    for (int i = 0; i <= q->degree; i++) p->v[i] += q->v[i];
    if (sizes)
        for (int i = 0; i <= q->degree; i++) p->m[i] += q->m[i];
}

static void horner(const algsurf_surface *s, const line_coordinate c[3], int sizes, line_poly *total) {
    line_poly level, row;
    total->degree = -1;
    for (int k = s->level_count - 1; k >= 0; k--) {
        const algsurf_level *l = s->levels + k;
        times_coordinate(total, c + 2, sizes);
        level.degree = -1;
        for (int j = l->count - 1; j >= 0; j--) {
            const algsurf_row *r = s->rows + l->first + j;
            times_coordinate(&level, c + 1, sizes);
            row.degree = -1;
            for (int i = r->length - 1; i >= 0; i--) {
                times_coordinate(&row, c, sizes);
                if (s->coef[r->first + (size_t)i] != 0) add_constant(&row, s->coef[r->first + (size_t)i]);
            }
            add_poly(&level, &row, sizes);
        }
        add_poly(total, &level, sizes);
    }
}

/* What underflow can add to a coefficient.  If even the product of the smallest factors stays above
 * 2^-900, an underflow (at most 2^-1074 each) is far below the relative bound.  Otherwise fewer than
 * 2^20 of them, each multiplied by at most max(1,|X|+|D|)^n, add less than the pad. */
static double underflow_pad(const algsurf_surface *s, const line_coordinate c[3]) {
    double low = 1, high = 1;
    for (int i = 0; i < 3; i++) {
        if (c[i].x_size > 0 && c[i].x_size < low) low = c[i].x_size;
        if (c[i].d_size > 0 && c[i].d_size < low) low = c[i].d_size;
        high = fmax(high, c[i].x_size + c[i].d_size);
    }
    if (!s->inexact && ilogb(s->smallest) + s->degree * ilogb(low) > -900) return 0;
    double pad = 0x1p-1000;
    for (int i = 0; i < s->degree; i++) pad *= high;
    return pad;
}

void algsurf_i_expand_d(const algsurf_surface *s, const double X[3], const double D[3], double *q,
                        double *r) {
    line_coordinate c[3];
    line_poly p;
    int n = s->degree;
    for (int i = 0; i < 3; i++) c[i] = (line_coordinate){X[i], D[i], fabs(X[i]), fabs(D[i])};
    horner(s, c, r != NULL, &p);
    for (int i = p.degree + 1; i <= n; i++) p.v[i] = p.m[i] = 0;
    for (int i = 0; i <= n; i++) q[i] = p.v[i];
    if (!r) return;
    double gamma = (4 * n + 8) * ALGSURF_U + s->error, pad = underflow_pad(s, c);
    for (int i = 0; i <= n; i++) r[i] = gamma * p.m[i] + pad;
}
