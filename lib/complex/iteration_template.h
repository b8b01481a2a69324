/* iteration_template.h - approximations of all complex roots of LANES polynomials side by side.
 *
 * Start values by Bini's rule or from the caller, Ehrlich-Aberth in Jacobi's form (propose.c has the
 * sources).  A lane that is done is frozen: what its neighbours are does not show in its bits. */
#ifndef ALGSURF_COMPLEX_ITERATION_TEMPLATE_H
#define ALGSURF_COMPLEX_ITERATION_TEMPLATE_H
#include "../simd/lanes.h"
#include "boxes.h"

#define MOST_ROOTS ALGSURF_MOST_ROOTS_IN_LANES
#define ROUNDING 0x1p-53
#define MOST_SWEEPS 40 /* cold ones take five to eight, ill-conditioned ones none that help */

/* LANES polynomials of one degree. */
typedef struct polynomials {
    int real; /* all im are 0 */
    lanes re[MOST_ROOTS + 1], im[MOST_ROOTS + 1], spread;
} polynomials;

INLINE mask is_zero(lanes a) { return at_most(absolute(a), all_lanes(0)); }

/* |z| and |c_k|, rounded up. */
INLINE lanes modulus(lanes re, lanes im) { return root(re * re + im * im + 0x1p-1000) * (1 + 8 * ROUNDING); }
INLINE lanes size_of(const polynomials *p, int k) {
    return p->real ? absolute(p->re[k]) : modulus(p->re[k], p->im[k]);
}

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
 * the angles, 3.883 k + 0.35, were the best of those tried.  That slope is the least over i <= k of the
 * largest slope of a chord from i to any j > k. */
INLINE void set_start(const polynomials *p, int n, mask where, lanes *x, lanes *y) {
    static const double turn[MOST_ROOTS][2] = {
        {0.939373, 0.342898},   {-0.461237, -0.887277}, {-0.259031, 0.965869},  {0.843317, -0.537417},
        {-0.984894, -0.173160}, {0.609439, 0.792833},   {0.085949, -0.996300},  {-0.736216, 0.676746},
        {0.999998, -0.001927},  {-0.738819, -0.673904}, {0.089787, 0.995961},   {0.606379, -0.795176},
        {-0.984219, 0.176953},  {0.845381, 0.534163},   {-0.262750, -0.964864}, {-0.457815, 0.889048},
        {0.938045, -0.346515},  {-0.925836, -0.377925}, {0.427599, 0.903969},   {0.295112, -0.955463},
        {-0.862900, 0.505375},  {0.977698, 0.210016},   {-0.579242, -0.815156}, {-0.123295, 0.992370}};
    lanes height[MOST_ROOTS + 1], slope[MOST_ROOTS], limit = all_lanes(300);
    for (int k = 0; k <= n; k++) height[k] = rough_log(larger(absolute(p->re[k]), absolute(p->im[k])));
    for (int i = 0; i < n; i++) {
        lanes steepest = all_lanes(-HUGE_VAL);
        for (int j = n; j > i; j--) {
            steepest = larger((height[j] - height[i]) * (1.0 / (j - i)), steepest);
            slope[j - 1] = i == 0 ? steepest : smaller(steepest, slope[j - 1]);
        }
    }
    for (int k = 0; k < n; k++) {
        lanes radius = rough_power(larger(smaller(-slope[k], limit), -limit));
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

/* a / b; `inverse` is 1 / |b|^2. */
INLINE complex_lanes quotient_by(complex_lanes a, complex_lanes b, lanes inverse) {
    return (complex_lanes){(a.re * b.re + a.im * b.im) * inverse, (a.im * b.re - a.re * b.im) * inverse};
}

INLINE complex_lanes quotient(complex_lanes a, complex_lanes b) {
    return quotient_by(a, b, 1 / (b.re * b.re + b.im * b.im));
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

/* The correction of z, where sum = sum 1/(z - z_j) over the other roots. */
INLINE complex_lanes correction(const polynomials *p, int n, complex_lanes z, complex_lanes sum) {
    complex_lanes slope, v = p->real ? evaluate_real(p, n, z, &slope) : evaluate(p, n, z, &slope);
    complex_lanes shared = times(v, sum);
    return quotient(v, (complex_lanes){slope.re - shared.re, slope.im - shared.im});
}

/* nearest: the largest |1/(z - z_j)|^2. */
INLINE mask has_stopped(complex_lanes z, complex_lanes step, lanes nearest, double stop) {
    lanes square = step.re * step.re + step.im * step.im;
    return less(square * nearest, all_lanes(stop)) | at_most(square, 0x1p-96 * (z.re * z.re + z.im * z.im));
}

/* What the other roots do to one: sum 1/(z - z_j), and the largest square of a term. */
typedef struct pull {
    complex_lanes sum;
    lanes nearest;
} pull;

/* What n points, but the one with that number, do to one; each lane has its own. */
INLINE pull pull_of(const double *x, const double *y, int n, complex_lanes z, lanes number) {
    pull all = {{all_lanes(0), all_lanes(0)}, all_lanes(0)};
    for (int j = 0; j < n; j++) {
        lanes dx = z.re - x[j], dy = z.im - y[j], inverse = 1 / (dx * dx + dy * dy);
        inverse = choose(is_zero(number - j), all_lanes(0), inverse);
        all.sum.re += dx * inverse, all.sum.im -= dy * inverse;
        all.nearest = larger(inverse, all.nearest);
    }
    return all;
}

/* Adds a term to that of one of two roots, a - b apart, and its opposite to that of the other. */
INLINE void add_pull(lanes dx, lanes dy, pull *a, pull *b) {
    lanes inverse = 1 / (dx * dx + dy * dy);
    dx *= inverse, dy *= inverse;
    a->sum.re += dx, b->sum.re -= dx, a->sum.im -= dy, b->sum.im += dy;
    a->nearest = larger(inverse, a->nearest), b->nearest = larger(inverse, b->nearest);
}

/* One sweep of the lanes that are active; returns those of them whose roots have all stopped. */
INLINE mask sweep(const polynomials *p, int n, mask active, double stop, lanes *x, lanes *y) {
    pull pulls[MOST_ROOTS];
    mask done = active;
    for (int i = 0; i < n; i++) {
        pull own = {{all_lanes(0), all_lanes(0)}, all_lanes(0)};
        UNROLLED for (int j = 0; j < i; j++) {
            pull other = pulls[j];
            add_pull(x[i] - x[j], y[i] - y[j], &own, &other);
            pulls[j] = other;
        }
        pulls[i] = own;
    }
    for (int i = 0; i < n; i++) {
        complex_lanes z = {x[i], y[i]}, step = correction(p, n, z, pulls[i].sum);
        x[i] = choose(active, z.re - step.re, z.re);
        y[i] = choose(active, z.im - step.im, z.im);
        done &= has_stopped(z, step, pulls[i].nearest, stop);
    }
    return done;
}

/* Sweeps until all active lanes stop; returns how many roots were corrected. */
INLINE int iterate(const polynomials *p, int n, mask active, double stop, lanes *x, lanes *y) {
    int corrections = 0;
    for (int k = 0; k < MOST_SWEEPS && any(active); k++) {
        corrections += n * __builtin_popcount(bits(active));
        active &= ~sweep(p, n, active, stop, x, y);
    }
    return corrections;
}

/* ---- values in doubled precision ---- */

/* p(z) by Horner's rule, and what its roundings add up to (Graillat, Langlois, Louvet 2005; complex:
 * Graillat, Menissier-Morain 2008).  Let S = sum |c_k| |z|^k.  A step rounds four products and three sums,
 * together below 4 u of its size (lanes_template.h): e exactly would be below 4 n u S.  Computed, it is off
 * by 4 u of its size in each of its n steps, and by 6 u of what each adds: 16 n^2 u^2 S + 24 n u^2 S, and
 * what is left out is covered by | v + e - p(z) | <= 32 n (n + 2) u^2 S + u |p(z)|. */
typedef struct compensation {
    complex_lanes v, e;
} compensation;

INLINE void step_by(compensation *s, complex_lanes z, lanes re, lanes im, int real) {
    lanes a_low, b_low, c_low, d_low, x_low, y_low, re_low, im_low = all_lanes(0);
    lanes a = exact_product(s->v.re, z.re, &a_low), b = exact_product(s->v.im, z.im, &b_low);
    lanes c = exact_product(s->v.re, z.im, &c_low), d = exact_product(s->v.im, z.re, &d_low);
    lanes x = exact_sum(a, -b, &x_low), y = exact_sum(c, d, &y_low);
    s->v.re = exact_sum(x, re, &re_low);
    s->v.im = real ? y : exact_sum(y, im, &im_low);
    s->e = times(s->e, z);
    s->e.re += (a_low - b_low) + (x_low + re_low);
    s->e.im += (c_low + d_low) + (y_low + im_low);
}

INLINE complex_lanes compensated(const polynomials *p, int n, complex_lanes z) {
    compensation s = {{p->re[n], p->im[n]}, {all_lanes(0), all_lanes(0)}};
    for (int k = n - 1; k >= 0; k--) step_by(&s, z, p->re[k], p->im[k], p->real);
    return (complex_lanes){s.v.re + s.e.re, s.v.im + s.e.im};
}

#endif
