/* newton.c - Newton's method, guarded by a bracket.
 *
 * The first point is the zero of the chord.  From then on a Newton step from the newest point, which is
 * always an end of the bracket, is taken if it stays inside and is at most half as long as the one before;
 * otherwise the bracket is halved (after rtsafe in Numerical Recipes).  Two additions make the bracket, not
 * just the point, converge.  Newton closes in from one side and leaves the far end where it was: every step
 * is lengthened by half of the wanted half width, and of a unit in the last place, which costs nothing while
 * steps are long, and in the end carries the point to the double beyond the root.  And where steps shrink
 * slowly, as at a multiple root, one step takes the place of the geometric series that the last two begin
 * (Aitken).
 *
 * Termination: at most FREE_STEPS + 2 H steps for H halvings.  The first MEANS halvings take the
 * arithmetic mean, and so do those of ends that are near each other; the others, j of them, halve the number
 * of doubles in the bracket, which is below 2^64.  Near ends are within 2^61 units in the last place of the
 * smaller one, and within 2^8 such units for each double: at most min(61, 72 - j) halvings remain.  So
 * H <= 3 + 72, and no more than 246 points.
 */
#include "../base/arithmetic.h"
#include <stdint.h>
#include <string.h>

#include "refine_impl.h"

enum { FREE_STEPS = 20 }; /* with 8, one ray polynomial in a thousand ran out and was halved 50 times */
enum { MEANS = 3 };       /* before a root is taken for one far smaller than its bracket */
#define NEAR 0x1p-8       /* ratio of ends */
#define SURPLUS 0.5       /* landing at +1/2 and then at -1/2 leaves 1 half width, which is less than 2 */

/* The doubles in increasing order, numbered so that 0.0 has number 0. */
static int64_t number_of(double x) {
    int64_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits >= 0 ? bits : -(bits & INT64_MAX);
}

static double double_of(int64_t number) {
    int64_t bits = number >= 0 ? number : -number;
    double x;
    memcpy(&x, &bits, sizeof x);
    return number >= 0 ? x : -x;
}

/* The unit in the last place, roughly for the largest doubles. */
static double unit_of(double x) {
    double size = fmin(fabs(x), 0.5 * DBL_MAX);
    return double_of(number_of(size) + 1) - size;
}

static int is_near(double b, double c) {
    double least = fmin(fabs(b), fabs(c)), most = fmax(fabs(b), fabs(c));
    return (b < 0) == (c < 0) && most * NEAR <= least;
}

static double halfway(const algsurf_i_search *s, int halvings) {
    if (halvings < MEANS || is_near(s->b, s->c)) return s->b + algsurf_i_search_half(s);
    int64_t b = number_of(s->b), c = number_of(s->c);
    return double_of(b / 2 + c / 2 + (b % 2 + c % 2) / 2);
}

static double chord(const algsurf_i_search *s) {
    double ratio = s->fb / s->fc;
    return s->b + 2.0 * (ratio / (ratio - 1.0)) * algsurf_i_search_half(s);
}

void algsurf_i_refine_newton(algsurf_i_search *s, const double *newton) {
    int steps = 0, halvings = 0;
    double before = INFINITY; /* length of the last step */
    if (algsurf_i_search_running(s) && isfinite(s->fc)) (void)algsurf_i_search_step(s, chord(s));
    while (algsurf_i_search_running(s)) {
        double half = algsurf_i_search_half(s), inward = s->x == s->b ? half : -half;
        double surplus = SURPLUS * (s->tolerance + unit_of(s->x));
        double step = *newton, length = fabs(step);
        double x = s->x + (step + copysign(surplus, inward));
        int inside = s->b < s->c ? x > s->b && x < s->c : x > s->c && x < s->b;
        int good = inside && length <= 0.5 * before;
        if (inside && !good && length < before) {
            length /= 1 - length / before;
            x = s->x + copysign(length + surplus, inward);
            good = length < fabs(half);
        }
        if (good && steps < FREE_STEPS + 2 * halvings) {
            steps++;
            (void)algsurf_i_search_step(s, x);
            before = length;
        } else {
            (void)algsurf_i_search_step(s, halfway(s, halvings++));
            before = fabs(half);
        }
    }
}
