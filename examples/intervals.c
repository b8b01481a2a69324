/* intervals.c - the three roots of p = x^3 - 2 x - 5 (Wallis 1685), proved by interval arithmetic alone.
 *
 * Newton's operator N(X) = m - p(m) / p'(X), m the middle of X, holds each root that X holds, real or
 * complex: p(x) - p(m) is x - m times a mean of p' between them.  If N(X) lies in X, then there is a root in
 * it, and no other in X.  Epsilon inflation (Rump 1980) finds such an X: what N gave last, made a little
 * wider.
 */
#include <stdio.h>

#include "algsurf/algsurf.h"

typedef algsurf_interval interval;
typedef algsurf_cinterval box;

static const interval p[] = {{-5, -5}, {-2, -2}, {0, 0}, {1, 1}}, slope[] = {{-2, -2}, {0, 0}, {3, 3}};
static const box complex_p[] = {{{-5, -5}, {0, 0}}, {{-2, -2}, {0, 0}}, {{0, 0}, {0, 0}}, {{1, 1}, {0, 0}}},
                 complex_slope[] = {{{-2, -2}, {0, 0}}, {{0, 0}, {0, 0}}, {{3, 3}, {0, 0}}};

/* Without the pieces over which p is not 0, what is left of [-6,6], which holds all roots (Cauchy's bound).
 */
static interval where_zero(void) {
    interval left = {0, 0}, piece, range;
    for (int i = 0, found = 0; i < 64; i++) {
        algsurf_interval_make(-6 + 0.1875 * i, -6 + 0.1875 * (i + 1), &piece);
        algsurf_interval_poly(p, 3, piece, &range);
        if (algsurf_interval_contains(range, 0)) left = found++ ? algsurf_interval_hull(left, piece) : piece;
    }
    return left;
}

static int newton(interval x, interval *result) {
    const interval m = {algsurf_interval_mid(x), algsurf_interval_mid(x)};
    interval value, slopes, step;
    algsurf_interval_poly(p, 3, m, &value);
    algsurf_interval_poly(slope, 2, x, &slopes);
    if (algsurf_interval_div(value, slopes, &step) != ALGSURF_OK) return 0; /* p' may be 0 */
    *result = algsurf_interval_sub(m, step);
    return 1;
}

/* The root near x, in an interval as narrow as Newton's operator makes it; 0: 20 steps prove none. */
static int real_root(interval x, interval *root) {
    for (int k = 0; k < 20; k++) {
        const double room = 0.1 * algsurf_interval_width(x) + 0x1p-51 * algsurf_interval_abs(x).hi;
        const interval wide = algsurf_interval_add(x, (interval){-room, room});
        if (!newton(wide, &x)) return 0;
        if (!algsurf_interval_interior(x, wide)) continue;
        do *root = x;
        while (newton(x, &x) && algsurf_interval_intersect(x, *root, &x) == ALGSURF_OK &&
               algsurf_interval_width(x) < algsurf_interval_width(*root));
        return 1;
    }
    return 0;
}

/* The same for a complex one. */
static int complex_root(box z, box *root) {
    for (int k = 0; k < 20; k++) {
        const double room = 0.1 * algsurf_cinterval_width(z) + 0x1p-51 * algsurf_cinterval_abs(z).hi;
        const box wide = algsurf_cinterval_add(z, (box){{-room, room}, {-room, room}});
        const algsurf_complex middle = algsurf_cinterval_mid(wide);
        const box m = {{middle.re, middle.re}, {middle.im, middle.im}};
        box value, slopes, step;
        algsurf_cinterval_poly(complex_p, 3, m, &value);
        algsurf_cinterval_poly(complex_slope, 2, wide, &slopes);
        if (algsurf_cinterval_div(value, slopes, &step) != ALGSURF_OK) return 0;
        *root = z = algsurf_cinterval_sub(m, step);
        if (algsurf_cinterval_interior(z, wide)) return 1;
    }
    return 0;
}

/* By the formula for x^2 + r x + r^2 - 2, which is p divided by x - r. */
static int by_formula(interval r, box *root) {
    interval square, part;
    algsurf_interval_pow(r, 2, &square);
    square = algsurf_interval_sub(algsurf_interval_mul((interval){3, 3}, square), (interval){8, 8});
    if (algsurf_interval_sqrt(square, &part) != ALGSURF_OK) return 0;
    *root = (box){algsurf_interval_mul((interval){-0.5, -0.5}, r),
                  algsurf_interval_mul((interval){0.5, 0.5}, part)};
    return 1;
}

static void print(const char *what, interval x) {
    printf("%-10s [%a, %a], about %.15g\n", what, x.lo, x.hi, algsurf_interval_mid(x));
}

int main(int argc, char **argv) {
    if (argc > 1) {
        fprintf(stderr, "%s: takes no arguments\n", argv[0]);
        return 2;
    }
    interval x, argument;
    box z, other;
    print("all real", where_zero());
    if (!real_root(where_zero(), &x) || !complex_root((box){{-1, -1}, {1, 1}}, &z) ||
        !by_formula(x, &other) ||
        algsurf_cinterval_intersect(z, other, &z) != ALGSURF_OK || /* both hold the root */
        algsurf_cinterval_arg(z, &argument) != ALGSURF_OK) {
        printf("not proved\n");
        return 1;
    }
    print("real root", x);
    print("real part", z.re), print("imaginary", z.im);
    print("modulus", algsurf_cinterval_abs(z)), print("argument", argument);

    const box real = {x, {0, 0}}, conjugate = {z.re, {-z.im.hi, -z.im.lo}};
    const box all = algsurf_cinterval_hull(real, algsurf_cinterval_hull(z, conjugate));
    const box product = algsurf_cinterval_mul(real, algsurf_cinterval_mul(z, conjugate));
    printf("all three in about [%.3f, %.3f] + i [%.3f, %.3f]; their product %s 5\n", all.re.lo, all.re.hi,
           all.im.lo, all.im.hi,
           algsurf_cinterval_contains(product, (algsurf_complex){5, 0}) ? "encloses" : "excludes");
    return 0;
}
