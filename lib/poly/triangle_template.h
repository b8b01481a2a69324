/* triangle_template.h - the triangular schemes, on LANES polynomials at once: Taylor's shift, de Casteljau's
 * cut, and the change from powers to Bernstein's basis.
 *
 * A level replaces each number by a sum of it and its neighbour.  Where the compiler knows the degree, the
 * whole triangle is unrolled into registers. */
#ifndef ALGSURF_TRIANGLE_TEMPLATE_H
#define ALGSURF_TRIANGLE_TEMPLATE_H
#include "../simd/lanes.h"

/* The first `levels` of Taylor's shift by x: with all n, sum c_k z^k becomes the same about x. */
INLINE void shift_levels(lanes *c, int n, lanes x, int levels) {
    UNROLLED
    for (int i = 0; i < levels; i++) {
        UNROLLED
        for (int k = n - 1; k >= i; k--) c[k] += x * c[k + 1];
    }
}

/* About `middle`, in units of `half`. */
INLINE void shift_and_scale(lanes *c, int n, lanes middle, lanes half) {
    lanes power = all_lanes(1);
    shift_levels(c, n, middle, n);
    for (int k = 1; k <= n; k++) {
        power *= half;
        c[k] *= power;
    }
}

/* One step of de Casteljau's scheme, with a weight for its first number or without. */
INLINE lanes join(lanes a, lanes b, lanes rest, lanes ratio, int weighted) {
    return weighted ? rest * a + ratio * b : a + ratio * b;
}

/* Levels 1 .. last of the scheme of degree n on w, of which level i leaves n - i + 1 numbers; the first
 * number of level i goes to left[i], unless left is null. */
INLINE void casteljau_levels(lanes *w, lanes *left, int n, int last, lanes rest, lanes ratio, int weighted) {
    UNROLLED
    for (int i = 1; i <= last; i++) {
        UNROLLED
        for (int j = 0; j <= n - i; j++) w[j] = join(w[j], w[j + 1], rest, ratio, weighted);
        if (left) left[i] = w[0];
    }
}

APART void casteljau_plain(lanes *w, lanes *left, int n, int last, const lanes *ratio) {
    casteljau_levels(w, left, n, last, *ratio, *ratio, 0);
}

APART void casteljau_weighted(lanes *w, lanes *left, int n, int last, const lanes *rest, const lanes *ratio) {
    casteljau_levels(w, left, n, last, *rest, *ratio, 1);
}

/* The same, in a function of its own where the degree is not known to the compiler. */
INLINE void casteljau(lanes *w, lanes *left, int n, int last, lanes rest, lanes ratio, int weighted) {
    if (__builtin_constant_p(n))
        casteljau_levels(w, left, n, last, rest, ratio, weighted);
    else if (weighted)
        casteljau_weighted(w, left, n, last, &rest, &ratio);
    else
        casteljau_plain(w, left, n, last, &ratio);
}

/* w becomes the part behind, left the part before, of a polynomial cut between lengths `before` and `behind`,
 * with before <= 2^10 behind: at two thirds of the scheme's cost.  With share = behind / (before + behind),
 * level i is kept in units of share^i, so that each sum is one multiplication and one addition.  If the
 * lengths are exact, the quotient and the share have error u each: every level adds 3 u max|w|, its unit
 * 2 u. */
INLINE void split(lanes *w, lanes *left, int n, lanes before, lanes behind) {
    lanes share = behind / (before + behind), unit = all_lanes(1);
    left[0] = w[0];
    casteljau(w, left, n, n, unit, before / behind, 0);
    UNROLLED
    for (int i = 1; i <= n; i++) {
        w[n - i + 1] *= unit;
        unit *= share;
        left[i] *= unit;
    }
    w[0] = left[n];
}

/* The same for any lengths whose sum is exact. */
INLINE void split_shares(lanes *w, lanes *left, int n, lanes before, lanes behind) {
    left[0] = w[0];
    casteljau(w, left, n, n, behind / (before + behind), before / (before + behind), 1);
}

/* Powers of v, |v| <= 1, to Bernstein coefficients over [-1,1]: row j of the matrix (poly/basis.h) has `side`
 * entries.  Coefficient j is an even part plus an odd one, coefficient n - j their difference. */
INLINE void powers_to_bernstein(const double *matrix, int side, const lanes *c, lanes *b, int n) {
    for (int j = 0; 2 * j <= n; j++) {
        const double *row = matrix + j * side;
        lanes even = c[0], odd = all_lanes(row[1]) * c[1];
        for (int k = 2; k <= n; k += 2) even += all_lanes(row[k]) * c[k];
        for (int k = 3; k <= n; k += 2) odd += all_lanes(row[k]) * c[k];
        b[j] = even + odd;
        b[n - j] = even - odd;
    }
}

#endif
