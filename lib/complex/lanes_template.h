/* lanes_template.h - all complex roots of LANES polynomials side by side, and which of them is seen.
 *
 * Proposal: start values by Bini's rule or from the caller, Ehrlich-Aberth in Jacobi's form (propose.c has
 * the sources).  A lane that is done is frozen: what its neighbours are does not show in its bits.
 *
 * Proof: the discs of prove.c, from p as it is evaluated in double.  A polynomial is known to an error of at
 * most E max(1,|z|)^n for each complex z, E = spread; so is its leading coefficient to E (Cauchy).  For every
 * polynomial within that error:
 *   |p(z_i)| <= |Horner| + (4 n + 8) u S + E max(1,|z_i|)^n + 2^-600,   S = sum |c_k| |z_i|^k:
 * a step of Horner's rule makes a complex product, off by 2 u in each part, 2^(3/2) u in all, and a sum, off
 * by u: below 4 u of the running size.  The bound leaves 8 u S for higher orders; |z_i| is rounded up.
 *   radius_i = n |p(z_i)| / ((|c_n| (1 - 8 u) - E) prod_j |z_i - z_j|) (1 + 32 (n + 2) u) + 2^-1000:
 * a squared distance is off by 4 u, its product with the others by 5 n u, the root of it by half of that and
 * u; all else is a few u, and |Horner| 2 u.
 *
 * Range.  |c_k| <= 2^300, |c_n| >= 2^-300, |z_i| <= 2^(200/n), prod |z_i - z_j|^2 >= 2^-500; otherwise a lane
 * proves nothing, and comparisons are such that NaN fails.  With this
 *   - nothing overflows: S < 2^530, and a product of squared distances stays below 2^(400 + 3 n);
 *   - what underflows in Horner's rule adds up to 2^-800 at most, which 2^-600 covers.  2^-1000 below the
 * root of |z|^2, and of |c_k|^2, keeps the sizes from being rounded down to 0;
 *   - no product of distances underflows on the way: each was at least 2^-500 / 2^(400 + 3 n);
 *   - a radius may underflow, which 2^-1000 covers: squares of distances are above 2^-980.
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
#include "../simd/lanes.h"
#include "edges.h"

#define MOST_ROOTS 24
#define ROUNDING 0x1p-53
#define NEAR_STOP                                                                                            \
    0x1p-10 /* of squares, step to distance: discs are then 2^-10 of the distances, cubed steps */
#define FAR_STOP 0x1p-70
#define MOST_SWEEPS 40 /* cold ones take five to eight, ill-conditioned ones none that help */
#define LAST_STEP_OF_ROOT                                                                                    \
    0x1p-36 /* the error after it is below its square over the distance to the next root */

/* LANES polynomials of one degree. */
typedef struct polynomials {
    int real; /* all im are 0 */
    lanes re[MOST_ROOTS + 1], im[MOST_ROOTS + 1], spread;
} polynomials;

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

/* ---- start values ---- */

/* log2 a, piecewise linear between powers of two; about -1023 for 0. */
INLINE lanes rough_log(lanes a) {
    lanes exponent = (lanes)((words)a >> 52 | 0x4330000000000000) - 0x1p52;
    return exponent + ((lanes)(((words)a & 0xfffffffffffff) | 0x3ff0000000000000) - 1024);
}

/* The inverse, for |s| <= 1000. */
INLINE lanes rough_power(lanes s) {
    lanes whole = (s + 0x1.8p52) - 0x1.8p52;
    whole = choose(less(s, whole), whole - 1, whole);
    return (1 + (s - whole)) * (lanes)((words)(whole + (0x1p52 + 1023)) << 52);
}

/* Slot k gets a point on the circle whose radius is the slope of the hull of log2 |c_k| between k and k+1;
 * the angles, 3.883 k + 0.35, were the best of those tried. */
INLINE void set_start(const polynomials *p, int n, mask where, lanes *x, lanes *y) {
    static const double turn[MOST_ROOTS][2] = {
        {0.939373, 0.342898},   {-0.461237, -0.887277}, {-0.259031, 0.965869},  {0.843317, -0.537417},
        {-0.984894, -0.173160}, {0.609439, 0.792833},   {0.085949, -0.996300},  {-0.736216, 0.676746},
        {0.999998, -0.001927},  {-0.738819, -0.673904}, {0.089787, 0.995961},   {0.606379, -0.795176},
        {-0.984219, 0.176953},  {0.845381, 0.534163},   {-0.262750, -0.964864}, {-0.457815, 0.889048},
        {0.938045, -0.346515},  {-0.925836, -0.377925}, {0.427599, 0.903969},   {0.295112, -0.955463},
        {-0.862900, 0.505375},  {0.977698, 0.210016},   {-0.579242, -0.815156}, {-0.123295, 0.992370}};
    lanes height[MOST_ROOTS + 1], hull[MOST_ROOTS + 1], limit = all_lanes(300);
    for (int k = 0; k <= n; k++)
        hull[k] = height[k] = rough_log(larger(absolute(p->re[k]), absolute(p->im[k])));
    for (int i = 0; i < n - 1; i++)
        for (int j = i + 2; j <= n; j++) {
            lanes slope = (height[j] - height[i]) * (1.0 / (j - i)), at = height[i];
            for (int k = i + 1; k < j; k++) {
                at += slope;
                hull[k] = larger(hull[k], at);
            }
        }
    for (int k = 0; k < n; k++) {
        lanes radius = rough_power(larger(smaller(hull[k] - hull[k + 1], limit), -limit));
        x[k] = choose(where, radius * turn[k][0], x[k]);
        y[k] = choose(where, radius * turn[k][1], y[k]);
    }
}

/* ---- the iteration ---- */

typedef struct complex_lanes {
    lanes re, im;
} complex_lanes;

INLINE complex_lanes times(complex_lanes a, complex_lanes b) {
    return (complex_lanes){a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}

INLINE complex_lanes quotient(complex_lanes a, complex_lanes b) {
    lanes inverse = 1 / (b.re * b.re + b.im * b.im);
    return (complex_lanes){(a.re * b.re + a.im * b.im) * inverse, (a.im * b.re - a.re * b.im) * inverse};
}

/* p(z), p'(z) by Horner's rule. */
INLINE complex_lanes evaluate(const polynomials *p, int n, complex_lanes z, complex_lanes *slope) {
    complex_lanes v = {p->re[n], p->im[n]}, d = {all_lanes(0), all_lanes(0)};
    for (int k = n - 1; k >= 0; k--) {
        d = times(d, z);
        d.re += v.re, d.im += v.im;
        v = times(v, z);
        v.re += p->re[k];
        if (!p->real) v.im += p->im[k];
    }
    *slope = d;
    return v;
}

/* The same for real p, divided twice by w^2 - 2 x w + |z|^2: half the products; less exact near the axis. */
INLINE complex_lanes evaluate_real(const polynomials *p, int n, complex_lanes z, complex_lanes *slope) {
    const lanes zero = all_lanes(0);
    lanes r = z.re + z.re, s = z.re * z.re + z.im * z.im, b1 = zero, b2 = zero, e1 = zero, e2 = zero;
    for (int k = n; k >= 2; k--) {
        lanes b = p->re[k] + (r * b1 - s * b2), e = b + (r * e1 - s * e2);
        if (k > 2) e2 = e1, e1 = e;
        b2 = b1, b1 = b;
    }
    lanes b = p->re[1] + (r * b1 - s * b2), twice = z.im + z.im;
    *slope = (complex_lanes){b - twice * (z.im * e1), twice * (z.re * e1 + (b1 - s * e2))};
    return (complex_lanes){z.re * b + (p->re[0] - s * b1), z.im * b};
}

/* One sweep of the lanes that are active; returns those of them whose roots have all stopped. */
INLINE mask sweep(const polynomials *p, int n, mask active, double stop, lanes *x, lanes *y) {
    lanes sr[MOST_ROOTS], si[MOST_ROOTS], nearest[MOST_ROOTS];
    mask done = active;
    for (int i = 0; i < n; i++) sr[i] = si[i] = nearest[i] = all_lanes(0);
    for (int i = 1; i < n; i++) {
        UNROLLED for (int j = 0; j < i; j++) {
            lanes dx = x[i] - x[j], dy = y[i] - y[j], inverse = 1 / (dx * dx + dy * dy);
            dx *= inverse, dy *= inverse;
            sr[i] += dx, sr[j] -= dx, si[i] -= dy, si[j] += dy;
            nearest[i] = larger(inverse, nearest[i]), nearest[j] = larger(inverse, nearest[j]);
        }
    }
    for (int i = 0; i < n; i++) {
        complex_lanes z = {x[i], y[i]}, sum = {sr[i], si[i]}, slope;
        complex_lanes v = p->real ? evaluate_real(p, n, z, &slope) : evaluate(p, n, z, &slope);
        complex_lanes shared = times(v, sum);
        complex_lanes step = quotient(v, (complex_lanes){slope.re - shared.re, slope.im - shared.im});
        lanes square = step.re * step.re + step.im * step.im;
        x[i] = choose(active, z.re - step.re, z.re);
        y[i] = choose(active, z.im - step.im, z.im);
        done &= less(square * nearest[i], all_lanes(stop)) |
                at_most(square, 0x1p-96 * (z.re * z.re + z.im * z.im));
    }
    return done;
}

/* Sweeps until all active lanes stop; returns how many roots were corrected. */
INLINE int iterate(const polynomials *p, int n, mask active, double stop, roots *r) {
    int corrections = 0;
    for (int k = 0; k < MOST_SWEEPS && any(active); k++) {
        corrections += n * __builtin_popcount(bits(active));
        active &= ~sweep(p, n, active, stop, r->x, r->y);
    }
    return corrections;
}

/* ---- the proof ---- */

/* |c_k|, rounded up. */
INLINE lanes size_of(const polynomials *p, int k) {
    if (p->real) return absolute(p->re[k]);
    return root(p->re[k] * p->re[k] + p->im[k] * p->im[k] + 0x1p-1000) * (1 + 8 * ROUNDING);
}

/* |c_n| of all polynomials within the error, rounded down; below 2^-300 it is of no use. */
INLINE lanes least_lead(const polynomials *p, int n) {
    return size_of(p, n) * (1 - 16 * ROUNDING) - p->spread;
}

/* n |p(z_i)|. */
INLINE lanes residual(const polynomials *p, int n, const lanes *size, complex_lanes z, mask *fits) {
    complex_lanes v = {p->re[n], p->im[n]};
    lanes far = root(z.re * z.re + z.im * z.im + 0x1p-1000) * (1 + 8 * ROUNDING), sum = size[n],
          power = p->spread;
    lanes grown = larger(far, all_lanes(1));
    for (int k = n - 1; k >= 0; k--) {
        v = times(v, z);
        v.re += p->re[k];
        if (!p->real) v.im += p->im[k];
        sum = sum * far + size[k];
        power *= grown;
    }
    *fits &= at_most(far, all_lanes(ldexp(1, 200 / n)));
    return n * (root(v.re * v.re + v.im * v.im) + ((4 * n + 8) * ROUNDING * sum + power + 0x1p-600));
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
        r->radius[i] = value / (lead * root(product[i])) * (1 + 32 * (n + 2) * ROUNDING) + 0x1p-1000;
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
        mask self = at_most(absolute(index - i), all_lanes(0));
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

/* p(z) by the compensated scheme of tighten.c. */
INLINE complex_lanes compensated(const polynomials *p, int n, complex_lanes z) {
    complex_lanes v = {p->re[n], p->im[n]}, e = {all_lanes(0), all_lanes(0)};
    for (int k = n - 1; k >= 0; k--) {
        lanes a_low, b_low, c_low, d_low, x_low, y_low, re_low, im_low = all_lanes(0);
        lanes a = exact_product(v.re, z.re, &a_low), b = exact_product(v.im, z.im, &b_low);
        lanes c = exact_product(v.re, z.im, &c_low), d = exact_product(v.im, z.re, &d_low);
        lanes x = exact_sum(a, -b, &x_low), y = exact_sum(c, d, &y_low);
        v.re = exact_sum(x, p->re[k], &re_low);
        v.im = p->real ? y : exact_sum(y, p->im[k], &im_low);
        e = times(e, z);
        e.re += (a_low - b_low) + (x_low + re_low);
        e.im += (c_low + d_low) + (y_low + im_low);
    }
    return (complex_lanes){v.re + e.re, v.im + e.im};
}

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
