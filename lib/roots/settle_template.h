/* settle_template.h - simple roots of one polynomial, side by side, from their brackets to between two
 * neighbouring doubles (enclose_template.h).
 *
 * Approach: Halley's method in doubles, kept to the bracket, whose ends follow the signs that doubles see;
 * this proves nothing.  The caller gives |c_k| <= 2^401 and ends with |t|^n <= 2^400. */
#ifndef ALGSURF_SETTLE_TEMPLATE_H
#define ALGSURF_SETTLE_TEMPLATE_H
#include "enclose_template.h"
#include "polys.h"

#define MOST_STEPS 40
#define CLOSE 0x1p-12 /* of a last step: it leaves its third power, and another one the ninth */
#define BLUR 0x1p-16  /* steps this short that do not shrink are rounding errors */

typedef struct settling {
    lanes lo, hi; /* the sign of the value at lo is that before the root, as far as is known */
    words side;   /* that sign */
    lanes x;
} settling;

/* p, p' and p''/2 by Horner's rule. */
INLINE lanes plain(const double *c, int n, lanes x, lanes *slope, lanes *bend) {
    lanes y = all_lanes(c[n]), d = all_lanes(0), e = d;
    for (int k = n - 1; k >= 0; k--) {
        e = e * x + d;
        d = d * x + y;
        y = y * x + c[k];
    }
    *slope = d, *bend = e;
    return y;
}

INLINE lanes halleys_step(lanes y, lanes slope, lanes bend) { return y * slope / (slope * slope - y * bend); }

/* Degrees 1 and 2 by the formula: of a x^2 + b x + c, the root where the slope 2 a x + b is that of the
 * sign's change, sqrt(b^2 - 4 a c) in size. */
INLINE lanes by_formula(const double *p, int n, words side) {
    lanes a = all_lanes(n == 2 ? p[2] : 0), b = all_lanes(p[1]), c = all_lanes(p[0]);
    lanes size = root(larger(b * b - 4 * a * c, all_lanes(0))), slope = (lanes)((words)-size ^ side);
    mask apart = negative((words)b ^ (words)slope); /* slope - b does not cancel */
    return choose(apart, slope - b, 2 * c) / choose(apart, 2 * a, -b - slope);
}

/* Halley's steps; where they do not shorten, halving. */
INLINE void approach_roots(const double *c, int n, settling *s) {
    if (n <= 2) {
        s->x = by_formula(c, n, s->side);
        return;
    }
    lanes slope, bend, at_lo = plain(c, n, s->lo, &slope, &bend), at_hi = plain(c, n, s->hi, &slope, &bend);
    lanes width = s->hi - s->lo, x = s->lo + width * (at_lo / (at_lo - at_hi)), before = width;
    mask moving = ~no_lane();
    s->x = choose(less(s->lo, x) & less(x, s->hi), x, s->lo + 0.5 * width);
    for (int i = 0; i < MOST_STEPS && any(moving); i++) {
        lanes y = plain(c, n, s->x, &slope, &bend), step = halleys_step(y, slope, bend);
        lanes length = absolute(step), next = s->x - step, scale = absolute(s->x);
        mask left = ~negative((words)y ^ s->side);
        s->lo = choose(moving & left, s->x, s->lo);
        s->hi = choose(moving & ~left, s->x, s->hi);
        mask good = less(s->lo, next) & less(next, s->hi) & at_most(length, 0.5 * before);
        lanes half = 0.5 * (s->hi - s->lo);
        s->x = choose(moving, choose(good, next, s->lo + half), s->x);
        moving &= ~(at_most(length, CLOSE * scale) | at_most(before, BLUR * scale));
        before = choose(good, length, half);
    }
}

static void settle_roots(const algsurf_i_coefficients *p, const algsurf_bracket *b, int count,
                         algsurf_real_root *roots) {
    double lo[LANES], hi[LANES], side[LANES], value[LANES];
    for (int at = 0; at < count; at += LANES) {
        int some = count - at < LANES ? count - at : LANES;
        settling s;
        enclosure e;
        for (int l = 0; l < LANES; l++) {
            const algsurf_bracket *one = b + at + (l < some ? l : 0);
            lo[l] = one->lo, hi[l] = one->hi, side[l] = one->sign;
        }
        s.lo = load(lo), s.hi = load(hi);
        s.side = (words)load(side) & (words)all_lanes(-0.0);
        approach_roots(p->c, p->degree, &s);
        begin_enclosure(&e, load(lo), load(hi), s.x, ~no_lane());
        for (int k = 0; k < MOST_POINTS && any(e.open); k++) newton(&e, (terms){p->c, NULL}, p->degree);
        store(lo, smaller(e.before, e.t)), store(hi, larger(e.before, e.t)), store(value, e.value);
        for (int l = 0; l < some; l++)
            roots[at + l] =
                (algsurf_real_root){value[l], lo[l], hi[l], bits(e.found) >> l & 1, b[at + l].sign};
    }
}

#endif
