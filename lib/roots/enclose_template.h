/* enclose_template.h - LANES roots, each between neighbouring doubles.
 *
 * Newton's method on the caller's coefficients, from where a root is about, until the last two points are
 * neighbouring doubles with different signs, both certain.
 *
 * Value.  certain_template.h.  Only lanes with |t| <= M, M in 2^+-20 and sum |c_k| M^k in 2^+-300 count: so
 * |c_k| < 2^700, |t|^n <= 2^400, and nothing overflows.
 *
 * Bracket.  A cell holds one root.  Its ends as doubles, middle + half v, are off by 4 u M; points nearer to
 * them than 2^-50 M are not used, but where the end is the interval's, which is a double. */
#ifndef ALGSURF_ENCLOSE_TEMPLATE_H
#define ALGSURF_ENCLOSE_TEMPLATE_H
#include "centred_template.h"
#include "certain_template.h"

#define MOST_POINTS 8 /* of Newton's method; three are usual */
#define LEAST_ROOT 0x1p-500

/* Roots on their way to neighbouring doubles. */
typedef struct enclosure {
    lanes c[ALGSURF_MAX_POLYS_DEGREE + 1];
    lanes from, to;  /* where points may be */
    lanes t, before; /* the next point, and the one before */
    lanes last;      /* its value there */
    lanes value;     /* of a root found: that of `before` and t with less |p| */
    mask open, found;
} enclosure;

/* Root x in [begin,end] of [-1,1] of each `open` lane's polynomial. */
INLINE void begin_enclosure(const algsurf_i_polys_job *job, size_t at, const int *id, lanes begin, lanes end,
                            lanes x, mask open, enclosure *e, int n) {
    lanes lo, hi;
    gather_interval(job, at, id, &lo, &hi);
    lanes most = larger(absolute(lo), absolute(hi));
    lanes middle = 0.5 * lo + 0.5 * hi, half = 0.5 * hi - 0.5 * lo, margin = 0x1p-50 * most;
    for (int k = 0; k <= n; k++) e->c[k] = gather_table(&job->c, k, at, id);
    e->from = choose(at_most(begin, all_lanes(-1)), lo, middle + begin * half + margin);
    e->to = choose(at_most(all_lanes(1), end), hi, middle + end * half - margin);
    e->t = middle + x * half;
    e->before = e->last = e->value = all_lanes(0);
    e->open = open & within(most, LARGE_END) & within(magnitude(e->c, n, most), LARGE_SIZE);
    e->found = no_lane();
}

/* Evaluates at t, and goes on to where Newton's method leads, to a neighbour at least.  Lanes leave with a
 * root between `before` and t, or without one. */
INLINE void newton(enclosure *e, int n) {
    lanes slope, computed, value = certain_value((terms){NULL, e->c}, n, e->t, &computed, &slope);
    lanes step = -value / slope;
    mask differ = negative((words)value ^ (words)e->last) & less(all_lanes(0), absolute(e->last));
    e->open &= at_most(e->from, e->t) & at_most(e->t, e->to) & less(all_lanes(0), absolute(value));
    e->open &= less(all_lanes(LEAST_ROOT), absolute(e->t));
    lanes back = next_double(e->t, e->before - e->t);
    mask found = e->open & differ & at_most(absolute(back - e->before), all_lanes(0));
    lanes a = absolute(e->last), b = absolute(value), least = smaller(e->before, e->t);
    lanes nearer = choose(less(a, b), e->before, choose(less(b, a), e->t, least));
    e->value = choose(found, nearer, e->value);
    e->found |= found;
    e->open &= ~found;
    lanes beside = next_double(e->t, step), next = e->t + step;
    next = choose(less(absolute(next - e->t), absolute(beside - e->t)), beside, next);
    e->before = choose(e->open, e->t, e->before);
    e->last = choose(e->open, value, e->last);
    e->t = choose(e->open, next, e->t);
}

#endif
