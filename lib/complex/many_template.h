/* many_template.h - one polynomial of any degree at many points side by side: steps to its roots, and values.
 *
 * Nothing depends on which points share a register: so all kernels give the same bits. */
#ifndef ALGSURF_COMPLEX_MANY_TEMPLATE_H
#define ALGSURF_COMPLEX_MANY_TEMPLATE_H
#include "boxes_template.h"

/* ---- steps ---- */

/* Up to LANES of `count` numbers, those that `who` names; the last one stands for what is missing. */
INLINE lanes gather(const double *a, const int *who, int count) {
    lanes some = all_lanes(0);
    for (int l = 0; l < LANES; l++) some[l] = a[who[l < count ? l : count - 1]];
    return some;
}

/* p(z), p'(z) and sum |c_k| |z|^k, or those of w^n p(1/w) at w. */
INLINE complex_lanes evaluate_many(const algsurf_i_flat *p, int reversed, complex_lanes z,
                                   complex_lanes *slope, lanes *size) {
    const int n = p->n, first = reversed ? 0 : n, way = reversed ? 1 : -1;
    lanes far = root(z.re * z.re + z.im * z.im), sum = all_lanes(p->noise[first]);
    complex_lanes v = {all_lanes(p->re[first]), all_lanes(p->im[first])}, d = {all_lanes(0), all_lanes(0)};
    for (int i = 1, k = first + way; i <= n; i++, k += way) {
        d = times(d, z);
        d.re += v.re, d.im += v.im;
        v = times(v, z);
        v.re += p->re[k], v.im += p->im[k];
        sum = sum * far + p->noise[k];
    }
    *slope = d, *size = sum;
    return v;
}

/* The steps of `count` points, at most LANES. */
INLINE void set_steps(const algsurf_i_approach *a, const int *who, int count, int reversed) {
    const int n = a->p->n;
    const lanes zero = all_lanes(0), one = all_lanes(1);
    complex_lanes z = {gather(a->x, who, count), gather(a->y, who, count)}, slope;
    lanes self = zero, size;
    for (int l = 0; l < LANES; l++) self[l] = who[l < count ? l : count - 1];
    complex_lanes w = reversed ? quotient((complex_lanes){one, zero}, z) : z;
    complex_lanes v = evaluate_many(a->p, reversed, w, &slope, &size);
    lanes unit = 1 / size;
    v.re *= unit, v.im *= unit, slope.re *= unit, slope.im *= unit;
    if (reversed) { /* p(z) = z^n q(w): p'(z) / p(z) = w (n q(w) - w q'(w)) / q(w) */
        slope = times(w, slope);
        slope = times(w, (complex_lanes){n * v.re - slope.re, n * v.im - slope.im});
    }
    pull b = pull_of(a->x, a->y, n, z, self);
    complex_lanes shared = times(v, b.sum), q = {slope.re - shared.re, slope.im - shared.im};
    lanes square = q.re * q.re + q.im * q.im;
    complex_lanes step = quotient_by(v, q, 1 / square);
    lanes length = step.re * step.re + step.im * step.im;
    mask there = at_most(v.re * v.re + v.im * v.im, all_lanes(4 * ROUNDING * ROUNDING));
    mask lost = ~(less(zero, square) & less(b.nearest, all_lanes(HUGE_VAL)));
    mask done = less(length * b.nearest, all_lanes(0x1p-40)) |
                at_most(length, 0x1p-102 * (z.re * z.re + z.im * z.im));
    lanes rests = choose(done, all_lanes(ALGSURF_I_RESTS), zero);
    lanes state = choose(lost, all_lanes(ALGSURF_I_LOST), rests);
    state = choose(there, choose(done, rests, all_lanes(ALGSURF_I_BLURRED)), state);
    lanes x = choose(there, zero, step.re), y = choose(there, zero, step.im);
    for (int l = 0; l < count; l++)
        a->step_x[who[l]] = x[l], a->step_y[who[l]] = y[l], a->state[who[l]] = (int)state[l];
}

static void approach(const algsurf_i_approach *a, const int *who, int count, int reversed) {
    for (int at = 0; at < count; at += LANES) {
        int many = count - at < LANES ? count - at : LANES;
        set_steps(a, who + at, many, reversed);
    }
}

/* ---- values ---- */

static void values(const algsurf_i_flat *p, const double *x, const double *y, int count, double *re,
                   double *im, double *sum) {
    for (int at = 0; at < count; at += LANES) {
        int many = count - at < LANES ? count - at : LANES;
        complex_lanes z = {load_some(x + at, many), load_some(y + at, many)};
        lanes far = root(z.re * z.re + z.im * z.im) * (1 + 8 * ROUNDING), size = all_lanes(p->size[p->n]);
        for (int k = p->n - 1; k >= 0; k--) size = size * far + p->size[k];
        compensation s = {{all_lanes(p->re[p->n]), all_lanes(p->im[p->n])}, {all_lanes(0), all_lanes(0)}};
        for (int k = p->n - 1; k >= 0; k--) step_by(&s, z, all_lanes(p->re[k]), all_lanes(p->im[k]), 0);
        lanes vr = s.v.re + s.e.re, vi = s.v.im + s.e.im;
        for (int l = 0; l < many; l++) re[at + l] = vr[l], im[at + l] = vi[l], sum[at + l] = size[l];
    }
}

#endif
