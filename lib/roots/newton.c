/* newton.c - Newton's method on a polynomial, guarded by its bracket.
 *
 * The first point is the zero of the chord.  From then on a Newton step from the newest point, which is
 * always an end of the bracket, is taken if it stays inside and is at most half as long as the one before;
 * otherwise the bracket is halved (after rtsafe in Numerical Recipes).  Two additions make the bracket, not
 * just the point, converge.  Newton closes in from one side and leaves the far end where it was: every step
 * is lengthened by a part of the wanted half width, which costs nothing while steps are long, and in the end
 * carries the point across the root.  And where steps stop shrinking although they are short, at a multiple
 * root or in the rounding noise of p, halving would start all over from afar: a leap a few times as long as
 * the last step takes its place, growing until the root is crossed.
 *
 * Termination: at most FREE_STEPS + 2 H steps and leaps for H halvings.  The first MEANS halvings take the
 * arithmetic mean; if they do not suffice (a root near 0 in a wide bracket), the following ones halve the
 * number of doubles in the bracket, which is below 2^64.  So H <= 124, and no more than 393 points.
 */
#include <stdint.h>
#include <string.h>

#include "refine_impl.h"

#define FREE_STEPS 20 /* with 8, one ray polynomial in a thousand ran out and was halved 50 times */
#define MEANS 60      /* more than the 53 that reach full precision from a bracket as wide as its root */
#define SURPLUS 0.5   /* of the half width: landing at +1/2 and then at -1/2 leaves a width of 1 < 2 */
#define LEAP 4.0      /* at an m-fold root, m - 1 more steps like the last remain: crossed for m < 5 */

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

static double halfway(const algsurf_i_search *s, int halvings) {
    if (halvings < MEANS) return s->b + algsurf_i_search_half(s);
    int64_t b = number_of(s->b), c = number_of(s->c);
    return double_of(b / 2 + c / 2 + (b % 2 + c % 2) / 2);
}

static double chord(const algsurf_i_search *s) {
    double ratio = s->fb / s->fc;
    return s->b + 2.0 * (ratio / (ratio - 1.0)) * algsurf_i_search_half(s);
}

void algsurf_i_refine_newton(algsurf_i_search *s, const double *derivative) {
    int steps = 0, halvings = 0;
    double before = INFINITY, leap = 0.0; /* lengths of the last step, and of the last leap, 0: none */
    if (algsurf_i_search_running(s) && isfinite(s->fc)) (void)algsurf_i_search_step(s, chord(s));
    while (algsurf_i_search_running(s)) {
        double half = algsurf_i_search_half(s), inward = s->x == s->b ? half : -half;
        double surplus = SURPLUS * algsurf_i_search_tolerance(s);
        double step = -s->fx / *derivative, length = fabs(step);
        double x = s->x + (step + copysign(surplus, inward));
        int inside = s->b < s->c ? x > s->b && x < s->c : x > s->c && x < s->b;
        int shrinks = inside && length <= 0.5 * before;
        if (!shrinks) {
            leap = fmax(LEAP * leap, fmax(LEAP * before, surplus));
            length = leap;
            x = s->x + copysign(leap, inward);
        }
        if ((shrinks || leap < fabs(half)) && steps < FREE_STEPS + 2 * halvings) {
            steps++;
            int crossed = algsurf_i_search_step(s, x);
            if (shrinks || crossed) before = length;
            if (crossed) leap = 0.0;
        } else {
            (void)algsurf_i_search_step(s, halfway(s, halvings++));
            before = fabs(half);
            leap = 0.0;
        }
    }
}
