/* enclose_template.h - LANES simple roots, each between two neighbouring doubles.
 *
 * Newton's method on the given coefficients, from where a root is about, until the last two points are
 * neighbouring doubles in its bracket with different signs, both certain (certain_template.h).  That pair is
 * unique, so the answer does not depend on how it was found. */
#ifndef ALGSURF_ENCLOSE_TEMPLATE_H
#define ALGSURF_ENCLOSE_TEMPLATE_H
#include "certain_template.h"

#define MOST_POINTS 8 /* of Newton's method; three are usual */
#define LEAST_ROOT 0x1p-500

/* Roots on their way to neighbouring doubles. */
typedef struct enclosure {
    lanes from, to;  /* the bracket: where points may be */
    lanes t, before; /* the next point, and the one before */
    lanes last;      /* its value there */
    lanes value; /* of a root found: that of `before` and t with less |p|; the lower one if they are equal */
    mask open, found;
} enclosure;

INLINE void begin_enclosure(enclosure *e, lanes from, lanes to, lanes t, mask open) {
    *e = (enclosure){from, to, t, all_lanes(0), all_lanes(0), all_lanes(0), open, no_lane()};
}

/* Evaluates at t, and goes on to where Newton's method leads, to a neighbour at least.  Lanes leave with a
 * root between `before` and t, or without one. */
INLINE void newton(enclosure *e, terms p, int n) {
    lanes slope, computed, value = certain_value(p, n, e->t, &computed, &slope);
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
