/* halley_template.h - a step of Halley's method (Traub, Iterative Methods for the Solution of Equations,
 * 1964) for LANES roots, each in its bracket. */
#ifndef ALGSURF_HALLEY_TEMPLATE_H
#define ALGSURF_HALLEY_TEMPLATE_H
#include "../simd/lanes.h"

/* Longer ones do not tell what the next will be; the interval has length 2. */
#define SHORT_ROOT_STEP 0x1p-10

/* A polynomial between its bracket and its root. */
typedef struct approach {
    lanes x, begin, end, last, slope;
    mask moving, stuck;
} approach;

/* Halley's step, kept to the bracket and to at least half of Newton's; moving lanes are those that need
 * another one.  The errors shrink with the third power, by a factor that the last two steps tell, or by the
 * square of bend / slope if that is more: so is known how long it would be.  After many, values below `noise`
 * end it. */
INLINE void halley(approach *a, const lanes *d, int n, lanes noise, double tolerance, int many) {
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
    mask close = sound & at_most(step, all_lanes(SHORT_ROOT_STEP)) & at_most(4 * step, last) &
                 at_most(cube * step, tolerance * last * last * last) &
                 at_most(4 * cube * bend * bend, tolerance * newton);
    a->slope = choose(a->moving, slope, a->slope);
    a->moving &= ~close;
    if (many) {
        a->stuck |= a->moving & at_most(absolute(f), noise);
        a->moving &= ~a->stuck;
    }
}

#endif
