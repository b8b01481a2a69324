/* enclose_template.h - LANES simple roots, each between two neighbouring doubles.
 *
 * Newton's method on the given coefficients, from where Halley's method (Traub, Iterative
 * Methods for the Solution of Equations, 1964) found it to be about, until the last two points are
 * neighbouring doubles in its bracket with different signs, both certain.  That pair is unique, so the answer
 * does not depend on how it was found.
 *
 * Values.  The compensated Horner scheme (Graillat, Langlois, Louvet, Compensated Horner Scheme, 2005) is off
 * by u |p(t)| + g^2 S at most,   g = 2 n u / (1 - 2 n u),   S = sum |c_k| |t|^k,   u = 2^-53: a value above
 * g^2 S has p's sign.  8 n^2 u^2 takes in the roundings of S, of the value, and of the bound. Callers see to
 * it that nothing overflows and |t|^n is at most 2^400: what underflow loses, below 2^-1070 in each of n
 * steps, is then less than 2^-600, which is added. */
#ifndef ALGSURF_ENCLOSE_TEMPLATE_H
#define ALGSURF_ENCLOSE_TEMPLATE_H
#include "../simd/lanes.h"

/* In units of x; longer ones do not tell what the next will be. */
#define SHORT_ROOT_STEP 0x1p-10

/* A polynomial between its bracket and its root. */
typedef struct approach {
    lanes x, begin, end, last, slope;
    mask moving, stuck;
} approach;

/* Halley's step, kept to the bracket and to at least half of Newton's; moving lanes are those that need
 * another one.  The errors shrink with the third power, by a factor that the last two steps tell, or by the
 * square of bend / slope if that is more: so is known how long it would be, in this unit.  After many, values
 * below `noise` end it. */
INLINE void halley(approach *a, const lanes *d, int n, lanes unit, double least, lanes noise, int many) {
    lanes tolerance = least * unit;
    lanes f = d[n], slope = all_lanes(0), bend = slope;
    for (int i = n - 1; i >= 0; i--) {
        bend = bend * a->x + slope;
        slope = slope * a->x + f;
        f = f * a->x + d[i];
    }
    mask before = ~negative((words)f); /* the root is further right */
    a->begin = choose(before, a->x, a->begin);
    a->end = choose(before, a->end, a->x);
    lanes newton = slope * slope, below = newton - f * bend, next = a->x - f * slope / below;
    mask sound = at_most(absolute(below), 2 * newton); /* not so where p' is 0 */
    sound &= at_most(a->begin, next) & at_most(next, a->end);
    next = choose(sound, next, 0.5 * (a->begin + a->end));
    lanes step = absolute(next - a->x), cube = step * step * step, last = a->last;
    a->x = choose(a->moving, next, a->x);
    a->last = step;
    mask close = sound & at_most(step, SHORT_ROOT_STEP * unit) & at_most(4 * step, last) &
                 at_most(cube * step, tolerance * last * last * last) &
                 at_most(4 * cube * bend * bend, tolerance * newton);
    a->slope = choose(a->moving, slope, a->slope);
    a->moving &= ~close;
    if (many) {
        a->stuck |= a->moving & at_most(absolute(f), noise);
        a->moving &= ~a->stuck;
    }
}

/* Of one polynomial for all lanes, or of one for each. */
typedef struct terms {
    const double *shared;
    const lanes *each; /* or null */
} terms;

INLINE lanes term_at(terms c, int k) { return c.each ? c.each[k] : all_lanes(c.shared[k]); }

/* p(t) where its sign is certain, else 0; as computed; and its slope, roughly. */
INLINE lanes certain_value(terms c, int n, lanes t, lanes *value, lanes *slope) {
    lanes y = term_at(c, n), error = all_lanes(0), size = absolute(y), far = absolute(t);
    *slope = error;
    for (int k = n - 1; k >= 0; k--) {
        lanes product_low, sum_low, product = exact_product(y, t, &product_low), term = term_at(c, k);
        *slope = *slope * t + y;
        y = exact_sum(product, term, &sum_low);
        error = error * t + (product_low + sum_low);
        size = size * far + absolute(term);
    }
    *value = y + error;
    lanes bound = (8.0 * n * n * 0x1p-106) * size + 0x1p-600;
    return choose(less(bound, absolute(*value)), *value, all_lanes(0));
}

/* The neighbouring double in the direction of `step`, which is not NaN; a is not 0. */
INLINE lanes next_double(lanes a, lanes step) {
    mask shrinks = negative((words)a ^ (words)step);
    return choose(shrinks, (lanes)((words)a - 1), (lanes)((words)a + 1));
}

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
