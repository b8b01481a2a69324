/* centred_template.h - LANES polynomials of many about the middles of their intervals.
 *
 * About the middle m of the interval, in units of half its length h, the polynomial is sum d_k v^k, v in
 * [-1,1]: a Taylor shift.  A matrix makes Bernstein coefficients of d (poly/triangle_template.h).
 *
 * Error of the Bernstein coefficients.  Let M = max(|lo|, |hi|), S = sum |c_k| M^k.  The sizes of all that
 * is added to a coefficient are at most S together, for |m| + h = M.  The shift rounds 2n times at most, the
 * powers of h and their product n times, the matrix once (poly/basis.h), and n/2 + 2 roundings follow, one
 * product and the sums: together (3.5n + 3) u S.  m and h are rounded, which moves the ends by u M and a
 * coefficient by n u S.  The bound (6n + 10) u S takes in the higher orders and the rounding of S.
 *
 * Error of values.  About the rounded middle d alone is off by 3n u S; a value by Horner's rule rounds 2n
 * times more.  (5n + 1) u S takes in the higher orders.
 *
 * Range.  A lane whose M or S is far from 1 is first scaled by powers of two.  Then with h >= 2^-30 M,
 * degrees up to 20 and S >= 2^-300, what underflow changes is below 2^-600, hence below 2^-300 S.
 *
 * Bad numbers.  A coefficient that is not finite makes S infinite or NaN; NaN as an end, or lo >= hi, makes h
 * NaN, or not positive; an infinite end makes M infinite.  No such lane is sound, nor one with a radius that
 * is negative or NaN; an infinite radius leaves every sign unknown. */
#ifndef ALGSURF_CENTRED_TEMPLATE_H
#define ALGSURF_CENTRED_TEMPLATE_H
#include "../poly/table_template.h"
#include "../poly/triangle_template.h"
#include "../simd/lanes.h"
#include "polys.h"

#define LARGE_END 0x1p20
#define LARGE_SIZE 0x1p300
#define LARGEST 0x1p900  /* what can be scaled */
#define SHORTEST 0x1p-30 /* of h in units of M */

/* LANES polynomials about the middles of their intervals. */
typedef struct centred {
    lanes d[ALGSURF_MAX_POLYS_DEGREE + 1];
    lanes lo, hi, middle, half; /* of the interval, in the caller's unit */
    lanes radius;               /* bound on the error of the Bernstein coefficients */
    mask sound;
} centred;

/* What values are off by, as a part of the radius.  With radii of the caller's, it may be as much. */
INLINE double part_of_values(const algsurf_i_polys_job *job, int n) {
    return job->p.radii.at ? 1 : (5.0 * n + 1) / (6 * n + 10);
}

/* 2^-e where 2^e <= a < 2^(e+1), for a in (1/LARGEST, LARGEST). */
INLINE lanes power_of_two(lanes a) { return (lanes)(0x7fe0000000000000u - ((words)a & 0x7ff0000000000000u)); }

INLINE mask within(lanes a, double large) {
    return less(all_lanes(1 / large), a) & less(a, all_lanes(large));
}

/* sum |c_k| x^k. */
INLINE lanes magnitude(const lanes *c, int n, lanes x) {
    lanes sum = absolute(c[n]);
    for (int k = n - 1; k >= 0; k--) sum = sum * x + absolute(c[k]);
    return sum;
}

/* Brings M and S of the `extreme` lanes to about 1.  What overflows shows in S. */
INLINE void rescale(centred *p, int n, mask extreme, lanes *m, lanes *h, lanes *most, lanes *size) {
    lanes one = all_lanes(1), power = one;
    p->sound = ~extreme | (within(*most, LARGEST) & within(*size, LARGEST));
    lanes shrink = choose(extreme & p->sound, power_of_two(*most), one), unit = 1 / shrink;
    lanes scale = choose(extreme & p->sound, power_of_two(*size), one);
    for (int k = 0; k <= n; k++) {
        p->d[k] = p->d[k] * larger(scale, one) * power * smaller(scale, one);
        if (k < n) power *= unit;
    }
    *m *= shrink;
    *h *= shrink;
    *most *= shrink;
    *size = magnitude(p->d, n, *most);
    p->radius *= scale;
    p->sound &= within(power, LARGEST) & (~extreme | within(*size, 8));
}

INLINE void load_interval(const algsurf_i_polys_job *job, size_t at, int count, lanes *lo, lanes *hi) {
    ptrdiff_t first = (ptrdiff_t)at * job->p.interval_step;
    *lo = load_steps(job->p.lo + first, job->p.interval_step, count);
    *hi = load_steps(job->p.hi + first, job->p.interval_step, count);
}

INLINE void to_index(lanes id, int *index) {
    for (int l = 0; l < LANES; l++) index[l] = (int)id[l];
}

/* Entries id[0 .. LANES-1] of p, which are `step` doubles from one to the next. */
INLINE lanes gather(const double *p, ptrdiff_t step, const int *id) {
    lanes a = {0};
    for (int l = 0; l < LANES; l++) a[l] = p[id[l] * step];
    return a;
}

/* The coefficients of power k, and the intervals, of polynomials at + id. */
INLINE lanes gather_table(const algsurf_table *t, int k, size_t at, const int *id) {
    return gather(t->at + k * t->power + (ptrdiff_t)at * t->polynomial, t->polynomial, id);
}

INLINE void gather_interval(const algsurf_i_polys_job *job, size_t at, const int *id, lanes *lo, lanes *hi) {
    ptrdiff_t first = (ptrdiff_t)at * job->p.interval_step;
    *lo = gather(job->p.lo + first, job->p.interval_step, id);
    *hi = gather(job->p.hi + first, job->p.interval_step, id);
}

/* Polynomials at .. at+count-1. */
INLINE void centre(const algsurf_i_polys_job *job, size_t at, int count, centred *p, int n) {
    lanes *d = p->d;
    load_interval(job, at, count, &p->lo, &p->hi);
    for (int k = 0; k <= n; k++) d[k] = load_table(&job->p.coefficients, k, at, count);
    lanes m = p->middle = 0.5 * p->lo + 0.5 * p->hi, h = p->half = 0.5 * p->hi - 0.5 * p->lo;
    lanes most = larger(absolute(p->lo), absolute(p->hi)), size = magnitude(d, n, most);
    mask refused = no_lane();
    p->radius = all_lanes(0);
    for (int k = n; job->p.radii.at && k >= 0; k--) {
        lanes r = load_table(&job->p.radii, k, at, count);
        refused |= ~at_most(all_lanes(0), r);
        p->radius = p->radius * most + r;
    }
    mask extreme = ~(within(most, LARGE_END) & within(size, LARGE_SIZE));
    p->sound = ~no_lane();
    if (any(extreme)) rescale(p, n, extreme, &m, &h, &most, &size);
    p->sound &= less(SHORTEST * most, h) & ~refused;
    p->radius = p->radius * (1 + 0x1p-40) + (6 * n + 10) * 0x1p-53 * size;
    shift_and_scale(d, n, m, h);
}

#endif
