/* beyond_template.h - what Bernstein coefficients over [0,1] tell of roots outside of it.
 *
 * By Taylor, p(x + y) = sum p^(k)(x) y^k / k!: if all derivatives at x have one sign, p has no root from x
 * on, and if those of (-1)^k p^(k) have, none up to x.  p^(k)(0) and p^(k)(1) are positive multiples of the
 * first and the last k-th difference of the coefficients.  (They have one sign as soon as the real parts of
 * all complex roots are in [0,1]: then p is a product of factors with positive coefficients in y.)
 *
 * Errors.  Coefficients known to e, at most b in size, have k-th differences off by 2^k (e + k u b) to first
 * order, as each subtraction doubles what there is and adds a rounding of a number below 2^k b; the code has
 * 2 n for k.  Where each has its own radius, the radii add up as the coefficients do.  Differences beyond a
 * degree that p is known to have at most are 0 and left out. */
#ifndef ALGSURF_ROOTS_BEYOND_TEMPLATE_H
#define ALGSURF_ROOTS_BEYOND_TEMPLATE_H
#include "first_walk_template.h"

#define LITTLE_MORE (1 + 0x1p-44) /* for the rounding of radii */
#define SIGN_BIT 0x8000000000000000u

/* Lanes whose polynomials have no root before 0, none behind 1; and those whose degree is not shown. */
typedef struct beyond {
    mask none_before, none_behind, lost;
} beyond;

/* Of n+1 coefficients with a radius for all, or each its own. */
INLINE beyond look_beyond(const lanes *b, const lanes *radius, int n, int own, lanes degree) {
    lanes d[MOST_DEGREE + 1], e[MOST_DEGREE + 1], largest = all_lanes(0);
    beyond is = {~no_lane(), ~no_lane(), no_lane()};
    words minus = {0}, before = (words)b[0] & SIGN_BIT, behind = (words)b[n] & SIGN_BIT;
    for (int j = 0; j <= n; j++) d[j] = b[j];
    for (int j = 0; j <= (own ? n : 0); j++) e[j] = radius[j];
    for (int j = 0; j <= n; j++) largest = larger(largest, absolute(b[j]) + radius[own ? j : 0]);
    lanes rounding = all_lanes(2 * n * 0x1p-53) * largest;
    for (int i = 0; i <= n; i++) {
        lanes begin_error = LITTLE_MORE * e[0] + rounding;
        lanes end_error = LITTLE_MORE * e[own ? n - i : 0] + rounding;
        mask no_more = less(degree, all_lanes(i)), highest = at_most(degree, all_lanes(i)) & ~no_more;
        is.none_before &= no_more | less(begin_error, (lanes)((words)d[0] ^ before ^ minus));
        is.none_behind &= no_more | less(end_error, (lanes)((words)d[n - i] ^ behind));
        is.lost |= highest & ~less(begin_error, absolute(d[0]));
        for (int j = 0; j < n - i; j++) d[j] = d[j + 1] - d[j];
        for (int j = 0; j < (own ? n - i : 1); j++) e[j] += e[own ? j + 1 : j];
        rounding += rounding;
        minus ^= SIGN_BIT;
    }
    return is;
}

#endif
