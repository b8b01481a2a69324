/* nodes.c - the two ways of packets of rays to Bernstein coefficients: from the values of P at nodes, and
 * from powers.
 *
 * A polynomial of degree n on [-1,1] is known by its values at n+1 nodes: p = sum p(v_i) L_i, with Lagrange's
 * polynomials L_i(v) = prod (v - v_m) / prod (v_i - v_m), m != i.  With x = (1+v)/2 each factor is
 * x - a = (1-a) x - a (1-x), and the product over m of these, expanded by powers of x and 1-x, has the
 * coefficients C(n,j) b_j.  They alternate in sign, and so do the two terms each step adds up: nothing
 * cancels, and entries come out with a relative error below (3n+4) u: 2 roundings a factor above, 1 below.
 *
 * The nodes are the extrema of Chebyshev's polynomial, at which the sums of |entries| in a row are the least
 * that values bounded by 1 allow: C(2n,2j)/C(n,j), 46 for degree 6, 733 for 10, 46704 for 16.  Rounded to
 * multiples of 2^-20 they make every difference above exact.
 *
 * Their matrix therefore amplifies rounding more and more.  Powers of v need no values: the Bernstein
 * coefficients of v^k are means of numbers +1 and -1, at most 1 in magnitude (poly/basis.c).
 *
 * A polynomial of degree n also is one of degree n+1.  The packet code is faster for the degrees it was
 * compiled for one by one, so that 5, 7 and 9 are treated as 6, 8 and 10. */
#include "../base/arithmetic.h"
#include <math.h>
#include <stdlib.h>

#include "impl.h"
#include "../base/elementary.h"
#include "../poly/basis.h"

static void set_nodes(double *node, int n) {
    for (int i = 0; 2 * i <= n; i++) {
        double point[2];
        algsurf_i_circle(3.14159265358979323846 * i / n, point);
        double v = ldexp(round(ldexp(point[0], 20)), -20);
        node[i] = 2 * i == n ? 0 : -v;
        node[n - i] = -node[i];
    }
}

/* The Bernstein coefficients of L_i. */
static void set_column(const double *node, double *column, int n, int i) {
    double c[ALGSURF_MAX_NODE_DEGREE + 1] = {1}, below = 1, binomial = 1;
    for (int m = 0, degree = 0; m <= n; m++) {
        if (m == i) continue;
        double a = 0.5 * (1 + node[m]);
        c[++degree] = 0;
        for (int j = degree; j > 0; j--) c[j] = (1 - a) * c[j - 1] - a * c[j];
        c[0] *= -a;
        below *= 0.5 * (node[i] - node[m]);
    }
    for (int j = 0; j <= n; j++) {
        column[j] = c[j] / (binomial * below);
        binomial = binomial * (n - j) / (j + 1);
    }
}

static void set_nodes_and_matrix(algsurf_surface *s) {
    int n = s->node_degree;
    set_nodes(s->nodes, n);
    for (int i = 0; i <= n; i++) set_column(s->nodes, s->to_bernstein + i * ALGSURF_NODE_STRIDE, n, i);
    for (int j = 0; j <= n; j++) {
        double sum = 0;
        for (int i = 0; i <= n; i++) sum += fabs(s->to_bernstein[i * ALGSURF_NODE_STRIDE + j]);
        s->amplification = fmax(s->amplification, sum);
    }
}

/* P along the line through the origin in a direction of components -1, 0 and 1. */
static void set_line(const algsurf_surface *s, const int direction[3], double *c) {
    double length = sqrt(abs(direction[0]) + abs(direction[1]) + abs(direction[2]));
    for (int k = 0; k <= s->degree; k++) c[k] = 0;
    for (size_t m = 0; m < s->term_count; m++) {
        const algsurf_term *t = s->terms + m;
        const int e[3] = {t->i, t->j, t->k};
        double value = ldexp(t->a, s->unit * (t->i + t->j + t->k) + s->scale);
        for (int i = 0; i < 3; i++)
            value *= e[i] == 0 ? 1 : direction[i] < 0 && e[i] % 2 ? -1 : abs(direction[i]);
        c[e[0] + e[1] + e[2]] += value;
    }
    double power = 1;
    for (int k = 1; k <= s->degree; k++) c[k] *= power /= length;
}

/* Have all derivatives of c at t one sign, but for factors of side < 0? */
static int is_beyond(const double *c, int n, double t, int side) {
    double d[ALGSURF_MAX_DEGREE + 1];
    for (int k = 0; k <= n; k++) d[k] = c[k];
    for (int i = 0; i < n; i++)
        for (int k = n - 1; k >= i; k--) d[k] += side * t * d[k + 1];
    int sign = d[0] > 0 ? 1 : -1;
    for (int k = 0; k <= n; k++)
        if ((k % 2 ? side : 1) * sign * d[k] < 0) return 0;
    return 1;
}

/* See impl.h.  Where P's highest terms have both signs the surface goes to infinity, and lines have roots at
 * all distances; where they are 0 in some directions, complex ones: then it is worth to look further, as long
 * as doubles allow it. */
static double spread_of(algsurf_surface *s) {
    double c[ALGSURF_MAX_DEGREE + 1], size = 0x1p-4;
    int signs = 0;
    for (int number = 0; number < 13; number++) { /* of 27 directions, 0 and the opposite ones left out */
        const int direction[3] = {number / 9 % 3 - 1, number / 3 % 3 - 1, number % 3 - 1};
        int n = s->degree;
        double reach = size;
        set_line(s, direction, c);
        signs |= c[n] > 0x1p-40 ? 1 : c[n] < -0x1p-40 ? 2 : 4;
        while (n > 0 && fabs(c[n]) < 0x1p-40) n--;
        while (reach < 16 && !(is_beyond(c, n, reach, 1) && is_beyond(c, n, reach, -1))) reach *= 1.25;
        if (reach < 16) size = reach;
    }
    s->goes_far = (signs & 3) == 3 || signs & 4;
    double more = (signs & 3) == 3 ? 4 : signs & 4 ? 2 : 1;
    return fmax(size, fmin(more * size, algsurf_i_exp2(24.0 / s->degree)));
}

static void set_degrees_in(algsurf_surface *s) {
    for (size_t m = 0; m < s->term_count; m++) {
        const algsurf_term *t = s->terms + m;
        for (int which = 0; which < 8; which++) {
            int degree = (which & 1 ? t->i : 0) + (which & 2 ? t->j : 0) + (which & 4 ? t->k : 0);
            if (degree > s->degree_in[which]) s->degree_in[which] = (unsigned char)degree;
        }
    }
}

int algsurf_i_surface_set_tables(algsurf_surface *s) {
    if (s->degree < 1) return 1;
    int n = s->degree == 1 || (s->degree > 3 && s->degree < 10) ? s->degree + s->degree % 2 : s->degree;
    size_t side = (size_t)n + 1,
           with_nodes = n <= ALGSURF_MAX_NODE_DEGREE ? (side + 1) * ALGSURF_NODE_STRIDE : 0;
    s->tables = calloc(side * side + with_nodes, sizeof *s->tables);
    if (!s->tables) return 0;
    s->node_degree = n;
    s->from_powers = s->tables;
    algsurf_i_power_basis(s->from_powers, n);
    s->most_reach = algsurf_i_exp2(280.0 / n);
    s->spread = spread_of(s);
    set_degrees_in(s);
    if (with_nodes) {
        s->to_bernstein = s->tables + side * side;
        s->nodes = s->to_bernstein + side * ALGSURF_NODE_STRIDE;
        set_nodes_and_matrix(s);
    }
    return 1;
}
