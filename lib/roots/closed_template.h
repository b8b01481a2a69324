/* closed_template.h - the first roots of LANES polynomials of degree 1 or 2. */
#ifndef ALGSURF_CLOSED_TEMPLATE_H
#define ALGSURF_CLOSED_TEMPLATE_H
#include "centred_template.h"

#define FLAT 0x1p-12 /* sqrt(D): below, the root is left to better than doubles */

/* The closed form for degrees 1 and 2.  Let s be the sign at the left end.  Where signs at the ends differ,
 * or both are s, the middle coefficient's is not, and the discriminant D is positive, then the first root is
 * the one where the slope d_1 + 2 d_2 v = -s sqrt(D).  Errors R of b are errors of at most R of d_0, d_1 and
 * 2 R of d_2; they change D by less than 16 R (|d_0| + |d_1| + |d_2| + R), which exceeds its roundings too.
 * The root is off by about u (|d_0| + |d_1| + |d_2|) / sqrt(D), so hits with a small D are undecided. */
INLINE lanes first_root_closed(const centred *p, int n, mask *hit, mask *undecided) {
    lanes a = n == 2 ? p->d[2] : all_lanes(0), b = p->d[1], c = p->d[0], radius = p->radius;
    lanes left = c - b + a, middle = c - a, right = c + b + a;
    words sign = (words)left & (words)all_lanes(-0.0);
    lanes size = absolute(a) + absolute(b) + absolute(c), discriminant = b * b - 4 * a * c;
    mask crosses = negative((words)left ^ (words)right), dips = negative((words)left ^ (words)middle);
    mask sure = less(radius, smaller(absolute(left), absolute(right)));
    mask around = ~crosses & (dips | ~less(radius, absolute(middle)));
    sure &= ~around | (dips & less(radius, absolute(middle)) &
                       less(16 * radius * (size + radius), absolute(discriminant)));
    sure &= p->sound;
    lanes slope = root(larger(discriminant, all_lanes(0)));
    *hit = sure & (crosses | (around & less(all_lanes(0), discriminant)));
    *undecided = ~sure | (*hit & less(slope, FLAT * size));
    *hit &= ~*undecided;
    mask same = ~negative((words)b ^ sign);
    lanes sum = b + (lanes)((words)slope | ((words)b & (words)all_lanes(-0.0)));
    return choose(same, -sum, -2 * c) / choose(same, 2 * a, sum);
}

#endif
