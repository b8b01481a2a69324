/* thin_box.c - P over a box of rays, and over its parts.
 *
 * A box is a beam (surface/beam.h) with all its terms.  A column of it, xi = x + h xi', eta = y + h eta',
 * |x| + h, |y| + h <= 1, has terms up to the second order and a radius R for the others: h^3 times the sizes
 * of those of the third order; and what xi^i eta^j, i + j = m, adds to higher ones is at most sum over l >= 4
 * of C(m,l) h^l (1 - h)^(m-l) <= C(m,4) h^4, with `fourth` the sum of C(m,4) |T_k,ij|, its largest for any k.
 *
 * Sign.  As for tiles (tiles_template.h), with xi'^2 = 1/2 +- 1/2,
 *     |b_k - (T_00 + T_20/2 + T_02/2)| <= |T_10| + |T_01| + |T_20|/2 + |T_02|/2 + |T_11| + R.
 * P has no zero where all b_k have one sign.
 *
 * Growth across.  In the direction (c,s), of length 1, a coefficient's derivative by (xi',eta') is
 *     c T_10 + s T_01 + (2 c T_20 + s T_11) xi' + (c T_11 + 2 s T_02) eta'
 * and what R contributes.  Of xi'^i eta'^j that is at most |c| i + |s| j <= i + j times its size: 3 times
 * that of the third order, and since l C(m,l) = m C(m-1,l-1), at most m C(m-1,3) h^4 = 4 C(m,4) h^4 of the
 * others.  An error of P is a polynomial in xi and eta: its derivative is at most n h times its bound.
 *
 * Growth along.  A polynomial grows where all differences b_(k+1) - b_k are positive.  Those of the terms up
 * to the second order are known, of the third order the sum of both sizes bounds them, of the others
 * 2 s times their bound does, in a part of a share s of the box's depths (tiles_template.h).
 *
 * Sign by squares.  Beside an empty double sheet, as x^2 + 10^-6 = 0, P is small, but a sum of squares:
 * ranges of its terms do not tell.  In a part, with zeta in [-1,1] along it, P is a quadratic in
 * (xi',eta',zeta) and a rest: the terms 1; xi', eta'; and those of the second order are taken as polynomials
 * of degree 2, 1 and 0 in zeta, and the rest is at most the largest difference in a Bernstein coefficient.  A
 * variable x with a x^2 + l x, a > 0, l linear in the others, is at least -l^2 / (4a); or, where |l| may be
 * 2a or more, at least a - max |l|.  What these say of one variable after the other, the better at each step,
 * bounds the quadratic from below. Its roundings are less than 2^-44 of the sum of its coefficients: what is
 * subtracted from one of them is larger than that only where the bound is below zero.
 *
 * Roundings.  To those of a tile's coefficients (surface/beam.c: 1, 4n, 2n, n + 2, 3n, 2n) come 5 cuts of 6n,
 * of the box to its depths, three more as it is narrowed, and of a part from its column; 4n + 12 for a
 * column; 9 in sums: 46n + 24.  With the 31n + 14 and 24n that are counted there too it is less than 112
 * (n + 1). */
#include "../base/arithmetic.h"
#include "thin_box.h"

#include <math.h>

enum { SIDE = ALGSURF_MAX_BEAM_DEGREE + 1, HALF_TURN = ALGSURF_I_DIRECTIONS / 2 };
enum { T00, T10, T01, T20, T11, T02, LOW_TERMS, THIRD = LOW_TERMS };

/* Of the first half turn of directions. */
#define COS_22 0.92387953251128674
#define SIN_22 0.38268343236508977
#define COS_45 0.70710678118654752
static const double cosine[HALF_TURN] = {1, COS_22, COS_45, SIN_22, 0, -SIN_22, -COS_45, -COS_22};
static const double sine[HALF_TURN] = {0, SIN_22, COS_45, COS_22, 1, COS_22, COS_45, SIN_22};

static double choose_4(int m) { return m < 4 ? 0 : m * (m - 1) * (m - 2) * (m - 3) / 24; }

void algsurf_i_solid_expand(const algsurf_i_thin_box *box, algsurf_i_solid *s) {
    const algsurf_i_beam_row *row = box->beam;
    const algsurf_i_view *view = box->view;
    int n = row->degree;
    double reach = fabs(box->u) + fabs(box->h), radius = 0;
    double x = reach + fabs(view->alpha) * reach + (fabs(view->beta[0]) + view->noise);
    s->degree = n, s->from = -1, s->to = 1, s->fourth = 0;
    for (int k = 0; k <= n; k++) {
        double sum = 0, *t = s->t[k];
        for (int j = 0; j <= n; t += n + 1 - j, j++) {
            const double *c = row->c + (k * (n + 1) + j) * (n + 1);
            double power = 1;
            for (int i = 0; i + j <= n; i++) t[i] = c[i];
            for (int m = 0; m + j < n; m++)
                for (int i = n - j - 1; i >= m; i--) t[i] += box->u * t[i + 1];
            for (int i = 0; i + j <= n; i++, power *= box->h) {
                t[i] *= power;
                sum += choose_4(i + j) * fabs(t[i]);
            }
        }
        s->fourth = fmax(s->fourth, sum * (1 + 0x1p-20));
    }
    for (int i = n; i >= 0; i--) radius = radius * x + row->radius[i];
    s->rounding = radius * (1 + 0x1p-20);
}

/* Polynomials of degree n in Bernstein's basis, `count` side by side, `apart` from one coefficient to the
 * next, cut to the part [from,to] of [0,1]. */
static inline void cut_part(double *t, int apart, int count, int n, double from, double to) {
    double share = from / to;
    if (to < 1)
        for (int r = 1; r <= n; r++)
            for (int k = n; k >= r; k--)
                for (int i = 0; i < count; i++)
                    t[k * apart + i] = (1 - to) * t[(k - 1) * apart + i] + to * t[k * apart + i];
    if (from > 0)
        for (int r = 1; r <= n; r++)
            for (int k = 0; k <= n - r; k++)
                for (int i = 0; i < count; i++)
                    t[k * apart + i] = (1 - share) * t[k * apart + i] + share * t[(k + 1) * apart + i];
}

double algsurf_i_solid_middle(const algsurf_i_solid *s, double place) {
    double b[SIDE];
    for (int k = 0; k <= s->degree; k++) b[k] = s->t[k][0];
    cut_part(b, 1, 1, s->degree, 0, place);
    return b[s->degree];
}

void algsurf_i_solid_narrow(algsurf_i_solid *s, double from, double to) {
    double length = s->to - s->from;
    cut_part(s->t[0], ALGSURF_I_BOX_TERMS, (s->degree + 1) * (s->degree + 2) / 2, s->degree, from, to);
    s->to = s->from + to * length;
    s->from += from * length;
}

/* Taylor's coefficients about x, up to the third order. */
static inline void expand_in_x(const double *c, int n, double x, double p[4]) {
    p[0] = p[1] = p[2] = p[3] = 0;
    for (int i = n; i >= 0; i--) {
        p[3] = p[3] * x + p[2];
        p[2] = p[2] * x + p[1];
        p[1] = p[1] * x + p[0];
        p[0] = p[0] * x + c[i];
    }
}

/* One coefficient of the column. */
static inline void expand_about(const double *t, int n, double x, double y, double h, double *to) {
    double a[4][4] = {{0}}, row[4]; /* of xi'^i eta'^j, but for h, at [j][i] */
    const double *end = t + (n + 1) * (n + 2) / 2;
    for (int j = n; j >= 0; j--) {
        end -= n + 1 - j;
        expand_in_x(end, n - j, x, row);
        for (int m = 3; m >= 0; m--)
            for (int i = 0; i + m <= 3; i++) a[m][i] = a[m][i] * y + (m > 0 ? a[m - 1][i] : row[i]);
    }
    to[T00] = a[0][0];
    to[T10] = h * a[0][1];
    to[T01] = h * a[1][0];
    to[T20] = h * h * a[0][2];
    to[T11] = h * h * a[1][1];
    to[T02] = h * h * a[2][0];
    to[THIRD] = h * h * h * (fabs(a[0][3]) + fabs(a[1][2]) + fabs(a[2][1]) + fabs(a[3][0]));
    to[THIRD + 1] = 0;
}

void algsurf_i_solid_column(const algsurf_i_solid *s, double x, double y, double half, algsurf_i_column *c) {
    c->half = half;
    for (int k = 0; k <= s->degree; k++) expand_about(s->t[k], s->degree, x, y, half, c->t[k]);
}

/* Of terms up to the second order: the middle of their range, and half its length. */
static inline double middle_of(const double *t) { return t[T00] + 0.5 * (t[T20] + t[T02]); }

static inline double radius_of(const double *t) {
    return fabs(t[T10]) + fabs(t[T01]) + 0.5 * (fabs(t[T20]) + fabs(t[T02])) + fabs(t[T11]);
}

static unsigned sign_of(const algsurf_i_column *c, int n, double error) {
    unsigned sign = ALGSURF_I_POSITIVE | ALGSURF_I_NEGATIVE;
    for (int k = 0; k <= n && sign; k++) {
        const double *t = c->t[k];
        double middle = middle_of(t), radius = radius_of(t) + t[THIRD] + error;
        if (!(middle > radius)) sign &= ~ALGSURF_I_POSITIVE;
        if (!(-middle > radius)) sign &= ~ALGSURF_I_NEGATIVE;
    }
    return sign;
}

static unsigned growth_across(const algsurf_i_column *c, int n, double error) {
    unsigned grows = ALGSURF_I_ACROSS;
    for (int k = 0; k <= n; k++) {
        const double *t = c->t[k];
        for (int m = 0; m < HALF_TURN; m++) {
            double x = cosine[m], y = sine[m], slope = x * t[T10] + y * t[T01];
            double radius =
                fabs(2 * x * t[T20] + y * t[T11]) + fabs(x * t[T11] + 2 * y * t[T02]) + 3 * t[THIRD] + error;
            if (!(slope > radius)) grows &= ~(1u << m);
            if (!(-slope > radius)) grows &= ~(1u << (m + HALF_TURN));
        }
    }
    return grows;
}

static unsigned growth_along(const algsurf_i_column *c, int n, double error) {
    unsigned deeper = 1u << ALGSURF_I_DIRECTIONS, shallower = 2u << ALGSURF_I_DIRECTIONS;
    for (int k = 0; k < n; k++) {
        const double *t = c->t[k], *next = c->t[k + 1];
        double d[LOW_TERMS];
        for (int i = 0; i < LOW_TERMS; i++) d[i] = next[i] - t[i];
        double middle = middle_of(d), radius = radius_of(d) + t[THIRD] + next[THIRD] + error;
        if (!(middle > radius)) deeper = 0;
        if (!(-middle > radius)) shallower = 0;
    }
    return deeper | shallower;
}

static double fourth_of(const algsurf_i_solid *s, double half) {
    return half * half * half * half * s->fourth;
}

unsigned algsurf_i_column_cut(const algsurf_i_solid *s, const algsurf_i_column *c, double from, double to,
                              algsurf_i_column *part) {
    *part = *c;
    cut_part(part->t[0], ALGSURF_I_COLUMN_TERMS, ALGSURF_I_COLUMN_TERMS, s->degree, from, to);
    return sign_of(part, s->degree, fourth_of(s, c->half) + s->rounding);
}

/* ---- sign by squares ---- */

/* constant + sum linear_i x_i + sum over i <= j of square_ij x_i x_j */
typedef struct quadratic {
    double constant, linear[3], square[3][3];
} quadratic;

static double *entry(quadratic *q, int i, int j) { return i < j ? &q->square[i][j] : &q->square[j][i]; }

/* A term along the part as p[0] + p[1] zeta + p[2] zeta^2, of that order; returns the size of the rest. */
static double follow(const algsurf_i_column *c, int term, int n, int order, double p[3]) {
    double first = c->t[0][term], last = c->t[n][term], rest = 0;
    int bends = order == 2 && n > 1;
    p[2] = bends ? 0.125 * n * ((last - c->t[n - 1][term]) - (c->t[1][term] - first)) : 0;
    p[1] = order > 0 ? 0.5 * (last - first) : 0;
    p[0] = 0.5 * (first + last) - p[2];
    double step = n > 0 ? 2.0 / n : 0, bend = bends ? step / (n - 1) : 0;
    for (int k = 0; k <= n; k++) { /* Bernstein coefficients of zeta and zeta^2 */
        double zeta = k * step - 1, square = 2 * (k * (k - 1) * bend - k * step) + 1;
        double off = fabs(c->t[k][term] - (p[0] + p[1] * zeta + p[2] * square));
        rest = off > rest ? off : rest;
    }
    return rest;
}

/* Over a part; returns a bound on the rest but for what is not known of the terms. */
static double quadratic_of(const algsurf_i_column *c, int n, quadratic *q) {
    double p[LOW_TERMS][3], rest = 0, third = 0, sum = 0;
    for (int i = 0; i < LOW_TERMS; i++) rest += follow(c, i, n, i == T00 ? 2 : i <= T01 ? 1 : 0, p[i]);
    for (int k = 0; k <= n; k++) third = c->t[k][THIRD] > third ? c->t[k][THIRD] : third;
    *q = (quadratic){p[T00][0],
                     {p[T10][0], p[T01][0], p[T00][1]},
                     {{p[T20][0], p[T11][0], p[T10][1]}, {0, p[T02][0], p[T01][1]}, {0, 0, p[T00][2]}}};
    for (int i = 0; i < LOW_TERMS; i++) sum += fabs(p[i][0]) + fabs(p[i][1]) + fabs(p[i][2]);
    return rest + third + 0x1p-44 * sum;
}

/* A bound from below, for all |x_i| <= 1; left: the variables that there are, a bit each. */
static double least_value(const quadratic *q, unsigned left) {
    int x = -1;
    for (int i = 0; i < 3; i++)
        if (left >> i & 1 && (x < 0 || q->square[i][i] > q->square[x][x])) x = i;
    if (x < 0) return q->constant;
    quadratic rest = *q, squares = *q;
    double a = q->square[x][x], largest = fabs(q->linear[x]), best = -HUGE_VAL;
    left &= ~(1u << x);
    for (int i = 0; i < 3; i++)
        if (left >> i & 1) largest += fabs(*entry(&rest, x, i));
    if (!(largest < 2 * a)) { /* else squares say more */
        rest.constant += a - largest;
        best = least_value(&rest, left);
        if (!(a > 0)) return best;
    }
    squares.constant -= 0.25 * q->linear[x] * q->linear[x] / a;
    for (int i = 0; i < 3; i++) {
        if (!(left >> i & 1)) continue;
        double by = 0.5 * *entry(&rest, x, i) / a;
        squares.linear[i] -= by * q->linear[x];
        for (int j = i; j < 3; j++)
            if (left >> j & 1) squares.square[i][j] -= (i == j ? 0.5 : 1) * by * *entry(&rest, x, j);
    }
    return fmax(best, least_value(&squares, left));
}

unsigned algsurf_i_column_square_sign(const algsurf_i_solid *s, const algsurf_i_column *part) {
    quadratic q;
    unsigned sign = ALGSURF_I_POSITIVE;
    double rest = quadratic_of(part, s->degree, &q) + fourth_of(s, part->half) + s->rounding;
    if (q.constant < 0) {
        sign = ALGSURF_I_NEGATIVE;
        q.constant = -q.constant;
        for (int i = 0; i < 3; i++) {
            q.linear[i] = -q.linear[i];
            for (int j = i; j < 3; j++) q.square[i][j] = -q.square[i][j];
        }
    }
    for (int i = 0; i < 3; i++) /* at the ends of the axes */
        if (!(q.constant + q.square[i][i] - fabs(q.linear[i]) > rest)) return 0;
    return q.constant > rest && least_value(&q, 7) > rest ? sign : 0;
}

unsigned algsurf_i_column_growth(const algsurf_i_solid *s, const algsurf_i_column *part, double share) {
    int n = s->degree;
    double fourth = fourth_of(s, part->half);
    return growth_across(part, n, 4 * fourth + n * part->half * s->rounding) |
           growth_along(part, n, 2 * (share * fourth + s->rounding));
}
