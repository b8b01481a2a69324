/* closed_template.h - the first roots of LANES polynomials of degree 1 or 2.
 *
 * Let d be the polynomial about the middle as computed, R the bound on its error in [-1,1]
 * (centred_template.h has it for the Bernstein coefficients: it is the same), s the sign at the left end.
 * Where signs at the ends differ, or both are s, the middle coefficient's is not, and the discriminant D is
 * positive, the first root is the one where the slope d_1 + 2 d_2 v = -s q, q = sqrt(D).
 *
 * Which case it is.  Errors R of b are errors of at most R of d_0, d_1 and 2 R of d_2; they change D by less
 * than 16 R (size + R), size = |d_0| + |d_1| + |d_2|.  That is more than D's roundings, 3 u size^2, too, as R
 * is at least 16 u S, S >= size.
 *
 * Where the root is.  Hits have q >= 2^40 R and q >= 2^-10 size, so D changes by less than 2^-25 of itself on
 * the way from d to the polynomial: that moves the root by R / q, 2^-40 at most.  Roundings change q by 1.5 u
 * size^2 / q + u q, below 2^-42 size; and the root v by that over max(|d_1| + q, 2 |d_2|), which is size / 3
 * at least, as |d_0| <= |d_1| + |d_2| where |v| <= 1.  Together with the roundings of the quotient that is
 * below 2^-39, 0.91e-12 of the interval's length.  All others are left to the walk. */
#ifndef ALGSURF_CLOSED_TEMPLATE_H
#define ALGSURF_CLOSED_TEMPLATE_H
#include "centred_template.h"

#define FLAT 0x1p-10
#define STEEP 0x1p40

INLINE lanes first_root_closed(const centred *p, int n, mask *hit, mask *undecided) {
    lanes a = n == 2 ? p->d[2] : all_lanes(0), b = p->d[1], c = p->d[0], radius = p->radius;
    lanes left = c - b + a, middle = c - a, right = c + b + a;
    words sign = (words)left & (words)all_lanes(-0.0);
    lanes size = absolute(a) + absolute(b) + absolute(c), discriminant = b * b - 4 * a * c;
    mask crosses = negative((words)left ^ (words)right), dips = negative((words)left ^ (words)middle);
    mask sure = p->sound & less(radius, smaller(absolute(left), absolute(right)));
    mask around = ~crosses & (dips | ~less(radius, absolute(middle)));
    sure &= ~around | (dips & less(radius, absolute(middle)) &
                       less(16 * radius * (size + radius), absolute(discriminant)));
    lanes slope = root(larger(discriminant, all_lanes(0)));
    *hit = sure & (crosses | (around & less(all_lanes(0), discriminant)));
    *undecided = ~sure | (*hit & less(slope, larger(FLAT * size, STEEP * radius)));
    *hit &= ~*undecided;
    mask same = ~negative((words)b ^ sign);
    lanes sum = b + (lanes)((words)slope | ((words)b & (words)all_lanes(-0.0)));
    return choose(same, -sum, -2 * c) / choose(same, 2 * a, sum);
}

#endif
