/* power.c - p(t) = q(t^k), as even polynomials are: q has 1/k of the degree.
 *
 * A root y of q in (A,B), taken positive, is a root x = y^(1/k) of p, and with k even -x is another one. Ends
 * for x are doubles a <= b with A <= a^k and b^k <= B: between them q(x^k) has no other root.  So if the
 * signs of p at a and b, which are computed with certainty, are those before and after the root, (a,b) is a
 * bracket.  If the sign at a is that after the root, this lies between A^(1/k) and a; with the least such a,
 * between a and the double before it.  The same holds at b.  Two doubles next to each other with no other
 * between A^(1/k) and B^(1/k) need no sign at all; only a root of even multiplicity that has one in between
 * is left to others.
 *
 * That A and B are neighbours does not make a and b neighbours: subnormal numbers are far apart for their
 * size, and between their roots are many doubles. */
#include "../base/arithmetic.h"
#include "line.h"

#include <math.h>
#include <stddef.h>

#include "../base/eft.h"
#include "../base/elementary.h"

static int greatest_divisor(int a, int b) { return b ? greatest_divisor(b, a % b) : a; }

int algsurf_i_power_of(const double *c, int degree, algsurf_i_power *w) {
    int step = 0;
    for (int k = 1; k <= degree && step != 1; k++)
        if (c[k] != 0) step = greatest_divisor(k, step);
    if (step == 1) return 0;
    w->step = step;
    w->degree = degree / step;
    for (int k = 0; k <= w->degree; k++) w->q[k] = c[k * step];
    return 1;
}

/* Not below (up) or not above x^k, x >= 0. */
static double power(double x, int k, int up) {
    double y = 1;
    for (; k > 0 && isfinite(x); k--) y = fmax(nextafter(y * x, up ? HUGE_VAL : 0), 0);
    return isfinite(x) ? y : x;
}

void algsurf_i_power_interval(const algsurf_i_power *w, double lo, double hi, double *from, double *to) {
    double near = lo > 0 ? lo : hi < 0 ? -hi : 0, far = fmax(-lo, hi);
    if (w->step % 2 == 0) {
        *from = power(near, w->step, 0);
        *to = power(far, w->step, 1);
    } else {
        *from = lo < 0 ? -power(-lo, w->step, 1) : power(lo, w->step, 0);
        *to = hi < 0 ? -power(-hi, w->step, 0) : power(hi, w->step, 1);
    }
}

/* The sign of x^k - y, both positive and finite.  A product in double-double is off by less than 2^-104 of
 * itself, hence k of them by k 2^-103; one without a low part is exact. */
static int compare_power(double x, int k, double y) {
    algsurf_dd product = algsurf_dd_from(x);
    int exact = 1;
    for (int i = 1; i < k; i++) {
        product = algsurf_dd_mul_d(product, x);
        exact = exact && product.lo == 0;
    }
    double difference = (product.hi - y) + product.lo, size = fmax(product.hi, y);
    if (fmin(product.hi, y) > 0x1p-900 && size < 0x1p900 && (exact || fabs(difference) > k * 0x1p-102 * size))
        return (difference > 0) - (difference < 0);
    double c[ALGSURF_MAX_POLY_DEGREE + 1] = {-y};
    c[k] = 1;
    const algsurf_i_coefficients power = {c, NULL, k};
    return algsurf_i_sign_at(&power, x);
}

/* The least double x with x^k >= y. */
static double root_above(double y, int k) {
    double x = algsurf_i_pow(y, 1.0 / k);
    while (compare_power(x, k, y) < 0) x = nextafter(x, HUGE_VAL);
    while (compare_power(nextafter(x, 0), k, y) >= 0) x = nextafter(x, 0);
    return x;
}

/* The greatest double x with x^k <= y. */
static double root_below(double y, int k) {
    double x = root_above(y, k);
    return compare_power(x, k, y) == 0 ? x : nextafter(x, 0);
}

/* Ends near those of q's bracket. */
static int take_roots_of_ends(const algsurf_i_power *w, const algsurf_i_coefficients *p, int side,
                              algsurf_real_root *r) {
    int k = w->step;
    double a = algsurf_i_pow(r->lo, 1.0 / k) * (1 + 0x1p-48),
           b = algsurf_i_pow(r->hi, 1.0 / k) * (1 - 0x1p-48);
    if (!(a < b) || compare_power(a, k, r->lo) < 0 || compare_power(b, k, r->hi) > 0) return 0;
    if (algsurf_i_sign_at(p, side * a) != r->sign || algsurf_i_sign_at(p, side * b) != -r->sign) return 0;
    r->lo = a;
    r->hi = b;
    return 1;
}

static int take_neighbours(const algsurf_i_power *w, const algsurf_i_coefficients *p, int side,
                           algsurf_real_root *r) {
    int k = w->step, exact = r->lo == r->hi;
    double a = root_above(r->lo, k), b = root_below(r->hi, k);
    r->lo = b;
    r->hi = a;
    if (a > b || exact) return 1;
    if (r->multiplicity % 2 == 0) return 0;
    int at_a = algsurf_i_sign_at(p, side * a), at_b = algsurf_i_sign_at(p, side * b);
    if (at_a == 0 || at_b == 0) return 0;
    r->lo = at_a != r->sign ? nextafter(a, 0) : at_b == r->sign ? b : a;
    r->hi = at_a != r->sign ? a : at_b == r->sign ? nextafter(b, HUGE_VAL) : b;
    return 1;
}

static algsurf_real_root mirrored(const algsurf_real_root *b) {
    algsurf_real_root m = *b;
    m.lo = -b->hi;
    m.hi = -b->lo;
    m.sign = b->multiplicity % 2 ? -b->sign : b->sign;
    return m;
}

/* q's root becomes p's on the same side of 0; 0: it cannot be told. */
static int take_root(const algsurf_i_power *w, const algsurf_i_coefficients *p, algsurf_real_root *root) {
    const algsurf_i_coefficients q = {w->q, NULL, w->degree};
    if (!algsurf_i_leave_zero(&q, root)) return 0;
    int side = root->hi <= 0 ? -1 : 1, simple = root->multiplicity % 2 && root->lo < root->hi;
    algsurf_real_root r = side < 0 ? mirrored(root) : *root;
    if (!(r.lo > 0 && isfinite(r.hi))) return 0;
    if (!(simple && take_roots_of_ends(w, p, side, &r)) && !take_neighbours(w, p, side, &r)) return 0;
    *root = side < 0 ? mirrored(&r) : r;
    return 1;
}

int algsurf_i_power_roots(const algsurf_i_power *w, const algsurf_i_coefficients *p, double lo, double hi,
                          algsurf_real_root *roots, int *count) {
    int n = *count, even = w->step % 2 == 0;
    for (int i = 0; i < n; i++)
        if (!take_root(w, p, roots + i)) return 0;
    for (int i = n - 1; even && i >= 0; i--) roots[i + n] = roots[i];
    for (int i = 0; even && i < n; i++) roots[i] = mirrored(roots + 2 * n - 1 - i);
    n = even ? 2 * n : n;
    *count = 0;
    for (int i = 0; i < n; i++)
        if (algsurf_i_is_inside(p, lo, hi, roots + i)) roots[(*count)++] = roots[i];
    return 1;
}
