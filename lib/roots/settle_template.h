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
#define CLOSE 0x1p-36 /* of a root: Newton's method takes it from there */

/* Degrees 1 and 2 by the formula: of a x^2 + b x + c, the root where the slope 2 a x + b is that of the
 * sign's change, sqrt(b^2 - 4 a c) in size. */
INLINE lanes by_formula(const double *p, int n, words side) {
    lanes a = all_lanes(n == 2 ? p[2] : 0), b = all_lanes(p[1]), c = all_lanes(p[0]);
    lanes size = root(larger(b * b - 4 * a * c, all_lanes(0))), slope = (lanes)((words)-size ^ side);
    mask apart = negative((words)b ^ (words)slope); /* slope - b does not cancel */
    return choose(apart, slope - b, 2 * c) / choose(apart, 2 * a, -b - slope);
}

INLINE lanes value_at(const lanes *d, int n, lanes x) {
    lanes y = d[n];
    for (int k = n - 1; k >= 0; k--) y = y * x + d[k];
    return y;
}

/* Roots in (lo,hi), before which the sign is that of `side`, nearly, from where the chord has them. */
INLINE lanes approach_roots(const double *c, int n, words side, lanes lo, lanes hi) {
    lanes d[ALGSURF_MAX_DEGREE + 1];
    if (n <= 2) return by_formula(c, n, side);
    for (int k = 0; k <= n; k++) d[k] = (lanes)((words)all_lanes(c[k]) ^ side);
    lanes at_lo = value_at(d, n, lo), width = hi - lo,
          x = lo + width * (at_lo / (at_lo - value_at(d, n, hi)));
    x = choose(less(lo, x) & less(x, hi), x, lo + 0.5 * width);
    approach a = {x, lo, hi, width, width, ~no_lane(), no_lane()};
    for (int i = 0; i < MOST_STEPS && any(a.moving); i++)
        halley(&a, d, n, absolute(a.x), CLOSE, all_lanes(0), 0);
    return a.x;
}

APART void settle_roots(const algsurf_i_coefficients *p, algsurf_real_root *roots, int count) {
    double lo[LANES], hi[LANES], side[LANES], value[LANES];
    for (int at = 0; at < count; at += LANES) {
        int some = count - at < LANES ? count - at : LANES;
        enclosure e;
        for (int l = 0; l < LANES; l++) {
            const algsurf_real_root *one = roots + at + (l < some ? l : 0);
            lo[l] = one->lo, hi[l] = one->hi, side[l] = one->sign;
        }
        lanes from = load(lo), to = load(hi);
        words before = (words)load(side) & (words)all_lanes(-0.0);
        begin_enclosure(&e, from, to, approach_roots(p->c, p->degree, before, from, to), ~no_lane());
        for (int k = 0; k < MOST_POINTS && any(e.open); k++) newton(&e, (terms){p->c, NULL}, p->degree);
        store(lo, smaller(e.before, e.t)), store(hi, larger(e.before, e.t)), store(value, e.value);
        for (int l = 0; l < some; l++) {
            algsurf_real_root *one = roots + at + l;
            if (bits(e.found) >> l & 1)
                *one = (algsurf_real_root){value[l], lo[l], hi[l], 1, one->sign};
            else
                one->multiplicity = 0;
        }
    }
}

#endif
