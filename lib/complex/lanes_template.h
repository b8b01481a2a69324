/* lanes_template.h - discs about all complex roots of LANES polynomials, and which root is seen.
 *
 * Proof: the discs of discs.c, from p as it is evaluated in double.  A polynomial is known to an error of at
 * most E max(1,|z|)^n for each complex z, E = spread; so is its leading coefficient to E (Cauchy).  For every
 * polynomial within that error:
 *   |p(z_i)| <= |Horner| + (4 n + 8) u S + E max(1,|z_i|)^n + 2^-536,   S = sum |c_k| |z_i|^k:
 * a step of Horner's rule makes a complex product, off by 2 u in each part, 2^(3/2) u in all, and a sum, off
 * by u: below 4 u of the running size.  The bound leaves 8 u S for higher orders; |z_i| is rounded up.
 *   radius_i = n |p(z_i)| / ((|c_n| (1 - 8 u) - E) prod_j |z_i - z_j|) (1 + 32 (n + 2) u) + 2^-500:
 * a squared distance is off by 4 u, its product with the others by 5 n u, the root of it by half of that and
 * u; all else is a few u, and |Horner| 2 u.
 *
 * Range.  |c_k| <= 2^300, |c_n| >= 2^-300, |z_i| <= 2^(200/n), prod |z_i - z_j|^2 >= 2^-500; otherwise a lane
 * proves nothing, and comparisons are such that NaN fails.  With this
 *   - nothing overflows: S < 2^530, and a product of squared distances stays below 2^(400 + 3 n);
 *   - what underflows in Horner's rule adds up to 2^-800 at most, and in the squares of |Horner| to 2^-1074,
 * of whose root 2^-537 is: 2^-536 covers both.  2^-1000 below the root of |z|^2, and of |c_k|^2, keeps the
 * sizes from being rounded down to 0;
 *   - no product of distances underflows on the way: each was at least 2^-500 / 2^(400 + 3 n);
 *   - a radius may underflow, which 2^-1000 would cover: squares of distances are above 2^-980.  With 2^-500
 * it exceeds what underflows in a magnitude, 2^-537, and its own square and those compared with it are
 * normal.
 *
 * Discs are used only if all are apart, |z_i - z_j| > 3 (radius_i + radius_j): then each holds one root.  The
 * 3 gives reality: let p be real and |y_i| <= radius_i.  The mirror image of the disc is at most 2 radius_i
 * away, and if it met disc j, the centres would be within 3 radius_i + radius_j.  So the conjugate of the
 * root lies in the same disc: it is the root itself.
 *
 * What is seen: the root w = z - from of least magnitude in a sector and a range of magnitudes
 * (algsurf/select.h). It is decided if one disc holds a root that is surely in both, and each other root is
 * surely not in one of them, or farther away, or, for a real polynomial, the conjugate: that one is known if
 * one disc alone meets the mirror image of the chosen one's.  An edge of the sector is crossed where a cross
 * product with its direction changes its sign; with |y| for y this holds on the whole upper half plane, onto
 * which a disc is folded within itself.  A root proved real has an argument of 0 or pi. */
#ifndef ALGSURF_COMPLEX_LANES_TEMPLATE_H
#define ALGSURF_COMPLEX_LANES_TEMPLATE_H
#include "edges.h"
#include "iteration_template.h"

#define NEAR_STOP                                                                                            \
    0x1p-10 /* of squares, step to distance: discs are then 2^-10 of the distances, cubed steps */
#define FAR_STOP 0x1p-70
#define LAST_STEP_OF_ROOT                                                                                    \
    0x1p-36 /* the error after it is below its square over the distance to the next root */

typedef struct roots {
    lanes x[MOST_ROOTS], y[MOST_ROOTS];
    lanes radius[MOST_ROOTS];
    mask apart; /* each disc holds one root */
} roots;

/* Which roots count. */
typedef struct window {
    const algsurf_i_sector_edges *sector;
    double from;
    lanes lo, hi, edge; /* magnitudes are known to be in [lo,hi] where they are inside by more than edge */
} window;

/* The root that is seen. */
typedef struct seen {
    mask one, undecided, real; /* neither of the first two: there is none */
    lanes x, y, radius;
} seen;

/* ---- the proof ---- */

/* |c_n| of all polynomials within the error, rounded down; below 2^-300 it is of no use. */
INLINE lanes least_lead(const polynomials *p, int n) {
    return size_of(p, n) * (1 - 16 * ROUNDING) - p->spread;
}

/* n |p(z_i)|. */
INLINE lanes residual(const polynomials *p, int n, const lanes *size, complex_lanes z, mask *fits) {
    complex_lanes v = {p->re[n], p->im[n]};
    lanes far = modulus(z.re, z.im), sum = size[n], power = p->spread, grown = larger(far, all_lanes(1));
    for (int k = n - 1; k >= 0; k--) {
        v = times(v, z);
        v.re += p->re[k];
        if (!p->real) v.im += p->im[k];
        sum = sum * far + size[k];
        power *= grown;
    }
    *fits &= at_most(far, all_lanes(ldexp(1, 200 / n)));
    return n * (root(v.re * v.re + v.im * v.im) + ((4 * n + 8) * ROUNDING * sum + power + 0x1p-536));
}

INLINE void prove(const polynomials *p, int n, roots *r) {
    lanes size[MOST_ROOTS + 1], product[MOST_ROOTS], square[MOST_ROOTS * (MOST_ROOTS - 1) / 2];
    lanes lead = least_lead(p, n);
    r->apart = at_most(all_lanes(0x1p-300), lead);
    for (int k = 0; k <= n; k++) {
        size[k] = size_of(p, k);
        r->apart &= at_most(size[k], all_lanes(0x1p300));
    }
    for (int i = 0; i < n; i++) {
        product[i] = all_lanes(1);
        UNROLLED for (int j = 0; j < i; j++) {
            lanes dx = r->x[i] - r->x[j], dy = r->y[i] - r->y[j], d = dx * dx + dy * dy;
            square[i * (i - 1) / 2 + j] = d;
            product[i] *= d, product[j] *= d;
        }
    }
    for (int i = 0; i < n; i++) {
        lanes value = residual(p, n, size, (complex_lanes){r->x[i], r->y[i]}, &r->apart);
        r->apart &= at_most(all_lanes(0x1p-500), product[i]);
        r->radius[i] = value / (lead * root(product[i])) * (1 + 32 * (n + 2) * ROUNDING) + 0x1p-500;
    }
    for (int i = 1; i < n; i++) {
        UNROLLED for (int j = 0; j < i; j++) {
            lanes reach = 3 * (r->radius[i] + r->radius[j]);
            r->apart &= less(reach * reach, square[i * (i - 1) / 2 + j] * (1 - 32 * ROUNDING));
        }
    }
    if (n == 1) r->apart &= less(r->radius[0], all_lanes(HUGE_VAL));
}

/* ---- the root that is seen ---- */

/* Of one root: its magnitude and what its disc tells. */
typedef struct standing {
    lanes magnitude, radius;
    mask in, out; /* surely */
} standing;

INLINE standing standing_of(const polynomials *p, const roots *r, int i, const window *w) {
    lanes x = r->x[i] - w->from, y = absolute(r->y[i]), m = root(x * x + y * y);
    standing a = {.magnitude = m, .radius = r->radius[i] + 0x1p-46 * m};
    lanes least = m - a.radius, most = m + a.radius;
    mask sector = less(all_lanes(0), least);
    a.in = at_most(w->lo + w->edge, least) & at_most(most, w->hi - w->edge);
    a.out = less(most, w->lo - w->edge) | less(w->hi + w->edge, least);
    if (!w->sector->to_pi) {
        lanes inside = w->sector->end[1] * x - w->sector->end[0] * y;
        sector &= less(a.radius, inside);
        a.out |= less(inside, -a.radius);
    }
    if (!w->sector->from_zero) {
        lanes inside = w->sector->begin[0] * y - w->sector->begin[1] * x;
        sector &= less(a.radius, inside);
        a.out |= less(inside, -a.radius);
    }
    if (p->real) {
        mask real = at_most(y, r->radius[i]), front = real & less(a.radius, x),
             back = real & less(x, -a.radius);
        mask other = ~(front | back);
        sector = (sector & other) | (w->sector->from_zero ? front : back & front) |
                 (w->sector->to_pi ? back : back & front);
        a.out |= (w->sector->from_zero ? back & front : front) | (w->sector->to_pi ? back & front : back);
    }
    a.in &= sector & ~a.out;
    return a;
}

/* The least root of which it is sure that it counts, and whether any other may be less. */
INLINE seen find_seen(const polynomials *p, int n, const roots *r, const window *w) {
    standing at[MOST_ROOTS];
    lanes best = all_lanes(HUGE_VAL), index = all_lanes(-1), mirrors = all_lanes(0);
    seen s = {.x = best, .y = best, .radius = all_lanes(0)};
    mask rivals = no_lane(), others = no_lane();
    for (int i = 0; i < n; i++) {
        at[i] = standing_of(p, r, i, w);
        mask better = at[i].in & less(at[i].magnitude + at[i].radius, best);
        best = choose(better, at[i].magnitude + at[i].radius, best);
        index = choose(better, all_lanes(i), index);
        s.x = choose(better, r->x[i], s.x);
        s.y = choose(better, r->y[i], s.y);
        s.radius = choose(better, r->radius[i], s.radius);
    }
    for (int i = 0; i < n; i++) {
        mask self = is_zero(index - i);
        mask rival = ~(at[i].out | self) & at_most(at[i].magnitude - at[i].radius, best);
        rivals |= rival;
        if (!p->real) {
            others |= rival;
            continue;
        }
        lanes dx = r->x[i] - s.x, dy = r->y[i] + s.y, reach = r->radius[i] + s.radius;
        mask mirror = ~less(reach * reach, (dx * dx + dy * dy) * (1 - 32 * ROUNDING));
        mirrors += choose(mirror, all_lanes(1), all_lanes(0));
        others |= rival & ~mirror;
    }
    mask found = at_most(all_lanes(0), index), twin = at_most(mirrors, all_lanes(1));
    s.undecided = ~r->apart | others | (rivals & ~(found & twin));
    s.one = found & ~s.undecided;
    s.real = p->real ? s.one & at_most(absolute(s.y), s.radius) : no_lane();
    return s;
}

/* ---- its value ---- */

/* The root to a double by Newton's method, the last step with doubled precision: of what it was started from
 * nothing is left in its bits.  Undecided where it leaves its disc or does not come to rest. */
INLINE void settle(const polynomials *p, int n, seen *s) {
    complex_lanes z = {s->x, choose(s->real, all_lanes(0), s->y)}, slope, step;
    for (int k = 0; k < 3; k++) {
        complex_lanes value = evaluate(p, n, z, &slope);
        if (k == 2) value = compensated(p, n, z);
        step = quotient(value, slope);
        z.re -= step.re, z.im -= step.im;
    }
    lanes dx = z.re - s->x, dy = z.im - s->y, square = step.re * step.re + step.im * step.im;
    mask settled = at_most(dx * dx + dy * dy, s->radius * s->radius) &
                   at_most(square, LAST_STEP_OF_ROOT * LAST_STEP_OF_ROOT * (1 + z.re * z.re + z.im * z.im));
    s->undecided |= s->one & ~settled;
    s->one &= settled;
    s->x = z.re;
    s->y = z.im;
}

#endif
