/* boxes_template.h - narrow boxes about all complex roots, of LANES polynomials or of one.
 *
 * Layouts.  Either the lanes are polynomials, and group i of lanes has root i of each; or the lanes are the
 * roots of one polynomial, LANES of them in a group ("together").  The code is the same: only
 * number_of, root_at and the two folds over all roots differ, and sums over the other roots are added in
 * rising order in both.  So both give the same bits.
 *
 * Symmetry.  With real coefficients, a root that is nearer to its conjugate than all others are goes to the
 * axis, and the lower one of a pair becomes the conjugate of the upper one.  What follows is computed at the
 * upper one for both, with bits that are equal, and holds for the lower one by symmetry, since it is checked
 * that each is there exactly once.
 *
 * Discs.  W_i = p(z_i) / D_i, D_i = c_n prod_j (z_i - z_j): if the discs about z_i with radius n |W_i| are
 * apart, each holds one root (discs.c).  p(z_i) has doubled precision; with S = sum |c_k| |z_i|^k it is off
 * by at most 32 n (n + 2) u^2 S and u times itself (iteration_template.h); 2^-500 covers what underflows,
 * here and in squares.  D_i takes n - 1 differences, off by u, and products, off by sqrt(5) u (Brent,
 * Percival, Zimmermann 2007): 3.3 (n - 1) u in all.
 *
 * Boxes.  Root i is exactly z_i - p(z_i) / (c_n prod_j (z_i - root_j)), and root_j is off z_j by at most R,
 * the largest radius.  So with m_i the least distance of another z_j, q = R / m_i, (n - 1) q <= 1/2,
 *   |root_i - (z_i - W_i)| <= |W_i| ((1 - q)^-(n-1) - 1) <= 2 (n - 1) q |W_i|,
 * to which the error of W_i as computed is added: that of p(z_i) / |D_i|, and |W_i| times that of D_i, u for
 * p, 7 u for the quotient, below (4 n + 8) u.  Two boxes could meet only if their z are within
 * 2^(1/2) (4 R + 2^-50 |z|), as |W| and the bound are at most 2 R together: (2 n + 6) R + 2^-45 |z| < m_i
 * forbids it, and makes discs disjoint and (n - 1) q <= 1/2.  A box off the axis does not meet its
 * conjugate's box, hence not the axis.  A root on it is real: its disc is symmetric.  Where p is not real, no
 * box may meet the axis: integers tell whether a root is on it.
 *
 * Range.  |c_k| <= 2^300, |c_0| and |c_n| >= 2^-300, |z_i| <= 2^(200/n), 2^-400 <= |D_i| <= 2^400, compared
 * so that NaN fails: nothing overflows, and what underflows is below 2^-800 in Horner's rule
 * (lanes_template.h), and in D_i, whose partial products are at least 2^-400 / 2^(200 + n), below u of it.
 * With m_i the least distance, |D_i| <= 2^(500 + n) m_i, and R is at least n 2^-500 / |D_i|: so m_i > (2 n +
 * 6) R only where m_i^2 > 2^-1020, and what underflows in that is 2^-54 of it. */
#ifndef ALGSURF_COMPLEX_BOXES_TEMPLATE_H
#define ALGSURF_COMPLEX_BOXES_TEMPLATE_H
#include "algsurf/allroots.h"
#include "iteration_template.h"

#define BOX_STOP 0x1p-20 /* as NEAR_STOP; cubed steps are then about 2^-30, the next one squares that */
#define MOST_STEPS 3     /* two squarings suffice for what doubles can tell */

typedef struct layout {
    int n, together;
} layout;

INLINE int groups_of(layout s) { return s.together ? (s.n + LANES - 1) / LANES : s.n; }

INLINE lanes number_of(layout s, int group) {
    return s.together ? numbered() + group * LANES : all_lanes(group);
}

INLINE mask is_root(layout s, int group) { return less(number_of(s, group), all_lanes(s.n)); }

INLINE lanes root_at(layout s, const lanes *a, int j) {
    return s.together ? all_lanes(a[j / LANES][j % LANES]) : a[j];
}

/* The largest of the lanes, in all of them; NaN may be overlooked. */
INLINE lanes over_lanes(lanes a) {
    double most = a[0];
    for (int l = 1; l < LANES; l++) most = a[l] > most ? a[l] : most;
    return all_lanes(most);
}

/* Of all roots: where `a` is true for each. */
INLINE mask all_of(layout s, const mask *a) {
    mask all = ~no_lane();
    for (int g = 0; g < groups_of(s); g++) all &= a[g] | ~is_root(s, g);
    return s.together && any(~all) ? no_lane() : all;
}

INLINE lanes largest_of(layout s, const lanes *a) {
    lanes most = all_lanes(0);
    for (int g = 0; g < groups_of(s); g++) most = larger(choose(is_root(s, g), a[g], most), most);
    return s.together ? over_lanes(most) : most;
}

/* Approximations; a root on the axis is real. */
typedef struct points {
    lanes x[MOST_ROOTS], y[MOST_ROOTS];
} points;

/* Root i is within `radius` of x + xl + i (y + yl), |y| for y where p is real. */
typedef struct narrow {
    lanes x[MOST_ROOTS], xl[MOST_ROOTS], y[MOST_ROOTS], yl[MOST_ROOTS], radius[MOST_ROOTS];
} narrow;

/* ---- approximations ---- */

INLINE mask sweep_together(const polynomials *p, layout s, double stop, points *r) {
    points next;
    mask done[MOST_ROOTS];
    for (int g = 0; g < groups_of(s); g++) {
        complex_lanes z = {r->x[g], r->y[g]};
        pull b = pull_of((const double *)r->x, (const double *)r->y, s.n, z, number_of(s, g));
        complex_lanes step = correction(p, s.n, z, b.sum);
        next.x[g] = z.re - step.re, next.y[g] = z.im - step.im;
        done[g] = has_stopped(z, step, b.nearest, stop);
    }
    for (int g = 0; g < groups_of(s); g++) r->x[g] = next.x[g], r->y[g] = next.y[g];
    return all_of(s, done);
}

/* set_start, one root a lane. */
INLINE void start_together(const polynomials *p, layout s, points *r) {
    lanes x[MOST_ROOTS], y[MOST_ROOTS];
    for (int i = 0; i < s.n; i++) x[i] = y[i] = all_lanes(0);
    set_start(p, s.n, ~no_lane(), x, y);
    for (int g = 0; g < groups_of(s); g++) r->x[g] = r->y[g] = all_lanes(0x1p100); /* where no root is */
    for (int i = 0; i < s.n; i++) {
        r->x[i / LANES][i % LANES] = x[i][0];
        r->y[i / LANES][i % LANES] = y[i][0];
    }
}

INLINE void approximate(const polynomials *p, layout s, points *r) {
    if (s.together) {
        start_together(p, s, r);
        for (int k = 0; k < MOST_SWEEPS && !any(sweep_together(p, s, BOX_STOP, r)); k++) {
        }
    } else {
        for (int i = 0; i < s.n; i++) r->x[i] = r->y[i] = all_lanes(0);
        set_start(p, s.n, ~no_lane(), r->x, r->y);
        (void)iterate(p, s.n, ~no_lane(), BOX_STOP, r->x, r->y);
    }
}

INLINE void make_symmetric(layout s, points *r) {
    points next;
    for (int g = 0; g < groups_of(s); g++) {
        lanes x = r->x[g], y = r->y[g], best = absolute(y + y), mate_x = x, mate_y = all_lanes(0);
        for (int j = 0; j < s.n; j++) {
            lanes xj = root_at(s, r->x, j), yj = root_at(s, r->y, j);
            lanes d = absolute(x - xj) + absolute(y + yj);
            mask closer = less(d, best);
            best = choose(closer, d, best);
            mate_x = choose(closer, xj, mate_x);
            mate_y = choose(closer, yj, mate_y);
        }
        mask upper = less(all_lanes(0), y), mated = ~is_zero(mate_y);
        next.x[g] = choose(upper | ~mated, x, mate_x);
        next.y[g] = choose(mated, choose(upper, y, -mate_y), all_lanes(0));
    }
    for (int g = 0; g < groups_of(s); g++) r->x[g] = next.x[g], r->y[g] = next.y[g];
}

/* ---- the proof ---- */

INLINE mask coefficients_fit(const polynomials *p, int n, lanes *size) {
    mask fit = ~no_lane();
    for (int k = 0; k <= n; k++) {
        size[k] = size_of(p, k);
        fit &= at_most(size[k], all_lanes(0x1p300));
    }
    return fit & at_most(all_lanes(0x1p-300), smaller(size[0], size[n]));
}

/* What the other roots mean for one at z. */
typedef struct surroundings {
    complex_lanes product; /* D */
    lanes nearest;         /* square of the least distance */
    mask sound;            /* z is there once, and its conjugate if p is real */
} surroundings;

INLINE surroundings surroundings_of(const polynomials *p, layout s, const points *r, complex_lanes z) {
    surroundings a = {.product = {p->re[s.n], p->im[s.n]}, .nearest = all_lanes(HUGE_VAL)};
    const lanes zero = all_lanes(0), one = all_lanes(1);
    lanes same = zero, mirrors = zero;
    for (int j = 0; j < s.n; j++) {
        lanes yj = root_at(s, r->y, j);
        complex_lanes d = {z.re - root_at(s, r->x, j), z.im - yj};
        lanes square = d.re * d.re + d.im * d.im;
        mask self = is_zero(square);
        if (p->real) mirrors += choose(is_zero(d.re) & is_zero(z.im + yj), one, zero);
        same += choose(self, one, zero);
        complex_lanes product = times(a.product, d);
        a.product.re = choose(self, a.product.re, product.re);
        a.product.im = choose(self, a.product.im, product.im);
        a.nearest = smaller(choose(self, a.nearest, square), a.nearest);
    }
    a.sound = is_zero(same - 1);
    if (p->real) a.sound &= is_zero(mirrors - 1);
    return a;
}

/* W of one group, |W| rounded up, and the error of W. */
typedef struct step_of_root {
    complex_lanes step;
    lanes size, error, distance, far; /* distance: to the nearest other root, rounded down; far: |z| */
    mask sound;
} step_of_root;

INLINE step_of_root step_at(const polynomials *p, layout s, const lanes *size, const points *r,
                            complex_lanes z) {
    const int n = s.n;
    step_of_root a = {.far = modulus(z.re, z.im)};
    complex_lanes value = compensated(p, n, z);
    lanes sum = size[n];
    for (int k = n - 1; k >= 0; k--) sum = sum * a.far + size[k];
    surroundings b = surroundings_of(p, s, r, z);
    lanes square = b.product.re * b.product.re + b.product.im * b.product.im, inverse_square = 1 / square;
    lanes inverse = root(inverse_square) * (1 + (4 * n + 16) * ROUNDING);
    lanes lost = (33 * n * (n + 2) * ROUNDING * ROUNDING * sum + 0x1p-500) * inverse;
    a.step = quotient_by(value, b.product, inverse_square);
    a.size = (absolute(value.re) + absolute(value.im)) * (1 + 8 * ROUNDING) * inverse + lost;
    a.error = a.size * ((4 * n + 16) * ROUNDING) + lost;
    a.distance = root(b.nearest) * (1 - 8 * ROUNDING);
    a.sound = b.sound & at_most(a.far, all_lanes(ldexp(1, 200 / n))) & at_most(all_lanes(0x1p-800), square) &
              at_most(square, all_lanes(0x1p800));
    return a;
}

/* Where the box is one unit in the last place wide in each part off the axis (there is no double between the
 * ends high + low -+ radius), or the disc is so small that another step would not change that. */
INLINE mask is_narrow(const narrow *b, int g, mask axis) {
    lanes size = larger(absolute(b->x[g]), absolute(b->y[g]));
    mask parts = less(b->radius[g], absolute(b->xl[g])) & (axis | less(b->radius[g], absolute(b->yl[g])));
    return parts | at_most(b->radius[g], 0x1p-72 * size);
}

/* A step for all roots.  Sets *narrow_ones where all boxes are proved and narrow; moves the points. */
INLINE void take_step(const polynomials *p, layout s, const lanes *size, points *r, narrow *b,
                      mask *narrow_ones) {
    const int n = s.n;
    step_of_root a[MOST_ROOTS];
    lanes most[MOST_ROOTS];
    mask good[MOST_ROOTS];
    for (int g = 0; g < groups_of(s); g++) {
        complex_lanes z = {r->x[g], p->real ? absolute(r->y[g]) : r->y[g]};
        a[g] = step_at(p, s, size, r, z);
        most[g] = a[g].size;
    }
    lanes reach = largest_of(s, most) * (n * (1 + 4 * ROUNDING));
    for (int g = 0; g < groups_of(s); g++) {
        lanes x = r->x[g], y = r->y[g], up = p->real ? absolute(y) : y;
        lanes grown = 2 * (n - 1) * reach / a[g].distance;
        b->radius[g] = (a[g].size * grown + a[g].error) * (1 + 16 * ROUNDING) + 0x1p-1000;
        b->x[g] = exact_sum(x, -a[g].step.re, &b->xl[g]);
        b->y[g] = exact_sum(up, -a[g].step.im, &b->yl[g]);
        mask axis = p->real ? is_zero(y) : no_lane();
        b->y[g] = choose(axis, y, b->y[g]);
        b->yl[g] = choose(axis, y, b->yl[g]);
        good[g] = a[g].sound & less((2 * n + 6) * reach + 0x1p-45 * a[g].far, a[g].distance) &
                  is_narrow(b, g, axis) & less(most[g], all_lanes(0x1p300));
        if (!p->real) good[g] &= less(b->radius[g] + absolute(b->yl[g]), absolute(b->y[g]));
        r->x[g] = b->x[g];
        r->y[g] = p->real ? choose(less(y, all_lanes(0)), -b->y[g], b->y[g]) : b->y[g];
    }
    *narrow_ones = all_of(s, good);
}

/* ---- boxes in order ---- */

/* The neighbour of a towards -inf; a is not 0. */
INLINE lanes below(lanes a) { return (lanes)((words)a - 1 + (((words)a >> 63) << 1)); }

/* high + low - r, rounded down; at most high, since |low| <= u |high|, for which 2^-51 |low| is nothing. */
INLINE lanes lower_end(lanes high, lanes low, lanes r) {
    lanes rest, sum = exact_sum(high, low - (r * (1 + 8 * ROUNDING) + 0x1p-51 * absolute(low)), &rest);
    return choose(less(rest, all_lanes(0)), below(sum), sum);
}

/* Parts of the answer, and the place of each root in it. */
typedef struct answer {
    lanes re[3][MOST_ROOTS], im[3][MOST_ROOTS], place[MOST_ROOTS]; /* lower end, upper end, value */
} answer;

INLINE void set_answer(layout s, int real, const points *r, const narrow *b, answer *a) {
    const lanes zero = all_lanes(0);
    for (int g = 0; g < groups_of(s); g++) {
        lanes low = lower_end(b->y[g], b->yl[g], b->radius[g]);
        lanes high = -lower_end(-b->y[g], -b->yl[g], b->radius[g]);
        a->re[0][g] = lower_end(b->x[g], b->xl[g], b->radius[g]);
        a->re[1][g] = -lower_end(-b->x[g], -b->xl[g], b->radius[g]);
        a->re[2][g] = r->x[g];
        mask flip = real ? less(r->y[g], zero) : no_lane(), axis = real ? is_zero(r->y[g]) : no_lane();
        a->im[0][g] = choose(axis, zero, choose(flip, -high, low));
        a->im[1][g] = choose(axis, zero, choose(flip, -low, high));
        a->im[2][g] = r->y[g];
    }
    for (int g = 0; g < groups_of(s); g++) {
        a->place[g] = zero;
        for (int j = 0; j < s.n; j++) {
            lanes x = root_at(s, r->x, j), y = root_at(s, r->y, j);
            mask before = less(x, r->x[g]) | (at_most(x, r->x[g]) & less(y, r->y[g]));
            a->place[g] += choose(before, all_lanes(1), zero);
        }
    }
}

/* Roots of lane l, or all of them, in their order; + 0.0 makes +0 of -0. */
INLINE void write_answer(layout s, int real, const answer *a, int l, algsurf_complex_root *roots) {
    for (int i = 0; i < s.n; i++) {
        int g = s.together ? i / LANES : i, at = s.together ? i % LANES : l;
        algsurf_complex_root *e = roots + (int)a->place[g][at];
        e->box.re.lo = a->re[0][g][at] + 0.0, e->box.re.hi = a->re[1][g][at] + 0.0;
        e->box.im.lo = a->im[0][g][at] + 0.0, e->box.im.hi = a->im[1][g][at] + 0.0;
        e->root.re = a->re[2][g][at] + 0.0, e->root.im = a->im[2][g][at] + 0.0;
        e->multiplicity = 1;
        e->real = real && e->root.im == 0;
    }
}

/* All roots of the lanes' polynomials, to roots + l * stride for lane l, or to roots; which lanes were
 * solved. */
INLINE unsigned solve_boxes(const polynomials *p, layout s, unsigned wanted, algsurf_complex_root *roots,
                            size_t stride) {
    lanes size[MOST_ROOTS + 1];
    points r;
    narrow b;
    unsigned solved = 0, open = wanted & bits(coefficients_fit(p, s.n, size));
    if (!open) return 0;
    approximate(p, s, &r);
    if (p->real) make_symmetric(s, &r);
    for (int k = 0; k < MOST_STEPS && open; k++) {
        mask narrow_ones;
        answer a;
        take_step(p, s, size, &r, &b, &narrow_ones);
        unsigned now = open & bits(narrow_ones);
        if (!now) continue;
        set_answer(s, p->real, &r, &b, &a);
        for (int l = 0; l < LANES; l++)
            if (now >> l & 1 && !(s.together && l > 0))
                write_answer(s, p->real, &a, l, roots + (size_t)l * stride);
        solved |= now;
        open &= ~now;
    }
    return solved;
}

#endif
