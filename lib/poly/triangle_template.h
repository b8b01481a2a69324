/* triangle_template.h - the triangular schemes, on LANES polynomials at once: Taylor's shift, de Casteljau's
 * cut, and the change from powers to Bernstein's basis.
 *
 * A level replaces each number by a sum of it and its neighbour.  Where the compiler knows the degree, the
 * whole triangle is unrolled into registers; else four levels go in one pass over the array, which takes a
 * quarter of the loads and stores.  Both do the same operations on the same numbers. */
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
 * number of level i goes to left[i], unless left is null.  Four at a time: c is of the fourth level, a, b and
 * `before` of those above it, at the next place. */
INLINE void casteljau_in_passes(lanes *w, lanes *left, int n, int last, lanes rest, lanes ratio,
                                int weighted) {
    int i = 1;
    for (; i + 3 <= last; i += 4) {
        const int end = n - i + 1; /* of level i - 1 */
        lanes a0 = join(w[0], w[1], rest, ratio, weighted), a1 = join(w[1], w[2], rest, ratio, weighted),
              a = join(w[2], w[3], rest, ratio, weighted), b0 = join(a0, a1, rest, ratio, weighted),
              b = join(a1, a, rest, ratio, weighted), c = join(b0, b, rest, ratio, weighted), before = w[3];
        if (left) left[i] = a0, left[i + 1] = b0, left[i + 2] = c;
        for (int j = 0; j + 4 <= end; j++) {
            lanes next = w[j + 4], next_a = join(before, next, rest, ratio, weighted),
                  next_b = join(a, next_a, rest, ratio, weighted),
                  next_c = join(b, next_b, rest, ratio, weighted);
            w[j] = join(c, next_c, rest, ratio, weighted);
            before = next, a = next_a, b = next_b, c = next_c;
        }
        w[end] = before, w[end - 1] = a, w[end - 2] = b, w[end - 3] = c;
        if (left) left[i + 3] = w[0];
    }
    for (; i <= last; i++) {
        for (int j = 0; j <= n - i; j++) w[j] = join(w[j], w[j + 1], rest, ratio, weighted);
        if (left) left[i] = w[0];
    }
}

APART void casteljau_plain(lanes *w, lanes *left, int n, int last, const lanes *ratio) {
    casteljau_in_passes(w, left, n, last, *ratio, *ratio, 0);
}

APART void casteljau_weighted(lanes *w, lanes *left, int n, int last, const lanes *rest, const lanes *ratio) {
    casteljau_in_passes(w, left, n, last, *rest, *ratio, 1);
}

/* Levels 1 .. last. */
INLINE void casteljau(lanes *w, lanes *left, int n, int last, lanes rest, lanes ratio, int weighted) {
    if (!__builtin_constant_p(n)) {
        if (weighted)
            casteljau_weighted(w, left, n, last, &rest, &ratio);
        else
            casteljau_plain(w, left, n, last, &ratio);
        return;
    }
    UNROLLED
    for (int i = 1; i <= last; i++) {
        UNROLLED
        for (int j = 0; j <= n - i; j++) w[j] = join(w[j], w[j + 1], rest, ratio, weighted);
        if (left) left[i] = w[0];
    }
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
