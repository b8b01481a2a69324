/* power.c - p(t) = t^m q(t^k), as even and odd polynomials are: q has 1/k of the degree.
 *
 * A root y of q in (A,B), taken positive, is a root x = y^(1/k) of p, and with k even -x is another one. Ends
 * for x are doubles a <= b with A <= a^k and b^k <= B: between them q(x^k) has no other root.  So if the
 * signs of p at a and b, which are computed with certainty, are those before and after the root, (a,b) is a
 * bracket.  If the sign at a is that after the root, this lies between A^(1/k) and a; with the least such a,
 * between a and the double before it.  The same holds at b.  Two doubles next to each other with no other
 * between A^(1/k) and B^(1/k) need no sign at all; only a root of even multiplicity that has one in between
 * is left to others. */
#include "../base/arithmetic.h"
#include "power.h"

#include <math.h>
#include <stddef.h>

#include "../base/eft.h"
#include "coefficients.h"
#include "../base/elementary.h"

/* A root of q by its size, and of p: 0 <= lo < root < hi, or lo = root = hi.  side: -1 below 0. */
typedef struct place {
    double lo, hi;
    int side, before, odd; /* the sign of q nearer to 0; is the multiplicity odd? */
} place;

static int greatest_divisor(int a, int b) { return b ? greatest_divisor(b, a % b) : a; }

int algsurf_i_power_of(const double *c, int degree, algsurf_i_power *w) {
    int zeros = 0, step = 0;
    while (c[zeros] == 0) zeros++;
    for (int k = zeros + 1; k <= degree && step != 1; k++)
        if (c[k] != 0) step = greatest_divisor(k - zeros, step);
    if (step == 0) step = 1;
    w->zeros = zeros;
    w->step = step;
    w->degree = (degree - zeros) / step;
    if (zeros == 0 && (step == 1 || degree == 2)) return 0;
    for (int k = 0; k <= w->degree; k++) w->q[k] = c[zeros + k * step];
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
    if (w->step == 1) {
        *from = lo;
        *to = hi;
    } else if (w->step % 2 == 0) {
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

/* The sign of q at side x^k. */
static int sign_at(const algsurf_i_power *w, const double *c, const place *r, double x) {
    const algsurf_i_coefficients p = {c, NULL, w->zeros + w->step * w->degree};
    int sign = algsurf_i_sign_at(&p, r->side * x);
    return r->side < 0 && w->zeros % 2 ? -sign : sign;
}

/* 2^e below the size of every root of q: Fujiwara's bound (isolate.c) for 1/y. */
static double least_root(const algsurf_i_power *w) {
    int least = ilogb(w->q[0]), bound = -3000;
    for (int k = 1; k <= w->degree; k++) {
        int e = w->q[k] != 0 ? ilogb(w->q[k]) + 1 - least : k * bound;
        if (e > k * bound) bound = e > 0 ? (e + k - 1) / k : -(-e / k);
    }
    return ldexp(1, -bound - 1);
}

/* A bracket about 0 keeps the side that has the root, and none ends at 0. */
static int leave_zero(const algsurf_i_power *w, const algsurf_bracket *b, place *r) {
    int after = b->multiplicity % 2 ? -b->sign : b->sign, at_zero = w->q[0] > 0 ? 1 : -1;
    r->odd = b->multiplicity % 2;
    r->side = b->hi <= 0 || (b->lo < 0 && at_zero != b->sign) ? -1 : 1;
    r->before = r->side > 0 ? b->sign : after;
    r->lo = r->side > 0 ? b->lo : -b->hi;
    r->hi = r->side > 0 ? b->hi : -b->lo;
    if (r->lo <= 0) r->lo = least_root(w);
    return r->lo > 0 && r->lo <= r->hi && isfinite(r->hi);
}

/* Ends near those of q's bracket. */
static int take_roots_of_ends(const algsurf_i_power *w, const double *c, place *r) {
    int k = w->step;
    double a = algsurf_i_pow(r->lo, 1.0 / k) * (1 + 0x1p-48),
           b = algsurf_i_pow(r->hi, 1.0 / k) * (1 - 0x1p-48);
    if (!(a < b) || compare_power(a, k, r->lo) < 0 || compare_power(b, k, r->hi) > 0) return 0;
    if (sign_at(w, c, r, a) != r->before || sign_at(w, c, r, b) != -r->before) return 0;
    r->lo = a;
    r->hi = b;
    return 1;
}

static int take_neighbours(const algsurf_i_power *w, const double *c, place *r) {
    int k = w->step, exact = r->lo == r->hi;
    double a = root_above(r->lo, k), b = root_below(r->hi, k);
    r->lo = b;
    r->hi = a;
    if (a > b || exact) return 1;
    if (!r->odd) return 0;
    int at_a = sign_at(w, c, r, a), at_b = sign_at(w, c, r, b);
    if (at_a == 0 || at_b == 0) return 0;
    r->lo = at_a != r->before ? nextafter(a, 0) : at_b == r->before ? b : a;
    r->hi = at_a != r->before ? a : at_b == r->before ? nextafter(b, HUGE_VAL) : b;
    return 1;
}

static algsurf_bracket bracket_of(const algsurf_i_power *w, const place *r, int side, int multiplicity) {
    int exact = r->lo == r->hi, after = r->odd ? -r->before : r->before;
    int sign = side > 0 ? r->before : w->zeros % 2 ? -after : after;
    return (algsurf_bracket){side > 0 ? r->lo : -r->hi,
                             side > 0 ? r->hi : -r->lo,
                             exact ? ALGSURF_BRACKET_EXACT : ALGSURF_BRACKET_ISOLATED,
                             sign,
                             multiplicity,
                             ALGSURF_OK};
}

/* The bracket of p's root on the side where q's is, or above 0; 0: it cannot be told. */
static int take_root(const algsurf_i_power *w, const double *c, algsurf_bracket *b) {
    place r;
    if (!leave_zero(w, b, &r)) return 0;
    if (w->step > 1 && !(r.odd && r.lo < r.hi && take_roots_of_ends(w, c, &r)) && !take_neighbours(w, c, &r))
        return 0;
    *b = bracket_of(w, &r, r.side, b->multiplicity);
    return 1;
}

static algsurf_bracket mirrored(const algsurf_i_power *w, const algsurf_bracket *b) {
    int after = b->multiplicity % 2 ? -b->sign : b->sign;
    algsurf_bracket m = *b;
    m.lo = -b->hi;
    m.hi = -b->lo;
    m.sign = w->zeros % 2 ? -after : after;
    return m;
}

static algsurf_bracket zero_root(const algsurf_i_power *w) {
    int sign = (w->q[0] > 0) == (w->zeros % 2 == 0) ? 1 : -1;
    return (algsurf_bracket){0, 0, ALGSURF_BRACKET_EXACT, sign, w->zeros, ALGSURF_OK};
}

/* Is the root in [lo,hi]?  A bracket that an end lies inside is cut there: two neighbours are not. */
static int is_inside(const algsurf_i_coefficients *p, double lo, double hi, algsurf_bracket *b) {
    const double ends[2] = {lo, hi};
    for (int i = 0; i < 2; i++) {
        if (!(b->lo < ends[i] && ends[i] < b->hi)) continue;
        int sign = algsurf_i_sign_at(p, ends[i]);
        if (sign != -b->sign) b->lo = ends[i];
        if (sign != b->sign) b->hi = ends[i];
        if (sign == 0) b->kind = ALGSURF_BRACKET_EXACT;
    }
    if (b->lo == b->hi) return b->lo >= lo && b->lo <= hi;
    return b->lo >= lo && b->hi <= hi;
}

/* Room for more at the front, of as many as there are with k even, and for 0 in between. */
static int take_all(const algsurf_i_power *w, const double *c, int zero, algsurf_bracket *b, int n) {
    int even = w->step % 2 == 0, below = 0;
    for (int i = 0; i < n; i++)
        if (!take_root(w, c, b + i)) return 0;
    while (!even && below < n && b[below].hi < 0) below++;
    int kept = even ? n : below, shift = (even ? n : 0) + zero;
    for (int i = n - 1; i >= (even ? 0 : below); i--) b[i + shift] = b[i];
    for (int i = 0; even && i < n; i++) b[i] = mirrored(w, b + 2 * n - 1 + zero - i);
    if (zero) b[kept] = zero_root(w);
    return 1;
}

int algsurf_i_power_roots(const algsurf_i_power *w, const double *c, double lo, double hi, algsurf_bracket *b,
                          int *count) {
    const algsurf_i_coefficients p = {c, NULL, w->zeros + w->step * w->degree};
    int n = *count, zero = w->zeros > 0;
    if (!take_all(w, c, zero, b, n)) return 0;
    n = (w->step % 2 == 0 ? 2 * n : n) + zero;
    *count = 0;
    for (int i = 0; i < n; i++)
        if (is_inside(&p, lo, hi, b + i)) b[(*count)++] = b[i];
    return 1;
}
