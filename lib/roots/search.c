/* search.c - the bracket shared by all methods, and the methods.
 *
 * Bisection and plain false position, as in the textbooks, are to be compared with.
 *
 * Brent (Algorithms for Minimization without Derivatives, 1973, chapter 4, "zero") improves Dekker's method:
 * inverse quadratic interpolation or the secant where they shrink the steps, bisection otherwise; at most
 * about the square of bisection's evaluations, usually far fewer.  The swaps of a, b, c are in step_to().
 * Differences from the book: the half width is computed without overflow, and an end with an infinite value
 * is never interpolated.
 *
 * Newton, guarded by the bracket.  The first point is the zero of the chord.  From then on a Newton step from
 * the newest point, which is always an end of the bracket, is taken if it stays inside and is at most half as
 * long as the one before; otherwise the bracket is halved (after rtsafe in Numerical Recipes).  Two additions
 * make the bracket, not just the point, converge.  Newton closes in from one side and leaves the far end
 * where it was: every step is lengthened by half of the wanted half width, and of a unit in the last place,
 * which costs nothing while steps are long, and in the end carries the point to the double beyond the root.
 * And where steps shrink slowly, as at a multiple root, one step takes the place of the geometric series that
 * the last two begin (Aitken).  It ends after FREE_STEPS + 2 H steps for H halvings at most.  The first MEANS
 * halvings take the arithmetic mean, and so do those of ends that are near each other; the others, j of them,
 * halve the number of doubles in the bracket, which is below 2^64.  Near ends are within 2^61 units in the
 * last place of the smaller one, and within 2^8 such units for each double: at most min(61, 72 - j) halvings
 * remain.  So H <= 3 + 72, and no more than 246 points.
 */
#include "../base/arithmetic.h"
#include "refine_impl.h"

#include <float.h>
#include <math.h>
#include <stdint.h>
#include <string.h>

/* ---- the bracket ---- */

static double value_at(algsurf_i_search *s, double x) {
    double y = s->f(x, s->data);
    s->evaluations++;
    s->nan |= isnan(y) != 0;
    return y;
}

/* Brent's second rule: b is the better end. */
static void order(algsurf_i_search *s) {
    if (!(fabs(s->fc) < fabs(s->fb))) return;
    s->a = s->b, s->fa = s->fb;
    s->b = s->c, s->fb = s->fc;
    s->c = s->a, s->fc = s->fa;
}

/* Evaluates f at x and makes x an end of the bracket.  Returns 1 when x took the place of c, that is when the
 * root lies between x and the old b; 0 otherwise.  Brent's first rule: c stays on the other side. */
static int step_to(algsurf_i_search *s, double x) {
    double y = value_at(s, x);
    s->iterations++;
    s->x = x;
    s->a = s->b, s->fa = s->fb;
    s->b = x, s->fb = y;
    int crossed = (y > 0 && s->fc > 0) || (y < 0 && s->fc < 0);
    if (crossed) s->c = s->a, s->fc = s->fa;
    order(s);
    return crossed;
}

/* The half width at which the bracket is narrow enough: tolerance + rounding * max(|b|, smallest normal),
 * and at least the smallest double. */
static double wanted_half(const algsurf_i_search *s) {
    double size = fabs(s->b);
    return s->tolerance + fmax(s->rounding * (size > DBL_MIN ? size : DBL_MIN), DBL_TRUE_MIN);
}

/* (c - b)/2 without overflow. */
static double half_width(const algsurf_i_search *s) {
    double width = s->c - s->b;
    return isfinite(width) ? 0.5 * width : 0.5 * s->c - 0.5 * s->b;
}

static int converged(const algsurf_i_search *s) {
    return s->fb == 0 || s->settled || fabs(s->c - s->b) <= 2.0 * wanted_half(s);
}

/* Neither a zero, nor narrow enough, nor stopped, nor at the limit of iterations? */
static int running(const algsurf_i_search *s) {
    return !s->nan && !converged(s) && s->iterations < s->max_iterations;
}

int algsurf_i_search_begin(algsurf_i_search *s, double lo, double hi) {
    s->a = s->c = lo, s->b = s->x = hi;
    s->fa = s->fc = value_at(s, lo);
    s->fb = value_at(s, hi);
    int opposite = (s->fc <= 0 && s->fb >= 0) || (s->fc >= 0 && s->fb <= 0);
    order(s);
    return opposite;
}

algsurf_status algsurf_i_search_finish(const algsurf_i_search *s, algsurf_refined_root *result) {
    if (s->nan) return ALGSURF_E_NOT_FINITE;
    *result = (algsurf_refined_root){.root = s->b,
                                     .lo = fmin(s->b, s->c),
                                     .hi = fmax(s->b, s->c),
                                     .residual = s->fb,
                                     .evaluations = s->evaluations,
                                     .iterations = s->iterations,
                                     .converged = converged(s)};
    return result->converged ? ALGSURF_OK : ALGSURF_NOT_CONVERGED;
}

/* ---- the textbooks' methods ---- */

static void bisection(algsurf_i_search *s) {
    while (running(s)) (void)step_to(s, s->b + half_width(s));
}

/* The zero of the chord through (b, f(b)) and (c, f(c)). */
static double chord(const algsurf_i_search *s) {
    double ratio = s->fb / s->fc;
    return s->b + 2.0 * (ratio / (ratio - 1.0)) * half_width(s);
}

/* One end of the bracket usually stays for ever, so the width says little: the method also stops when it
 * hardly moves.  An infinite value has no chord. */
static void regula_falsi(algsurf_i_search *s) {
    double before = INFINITY;
    while (running(s)) {
        double x = isfinite(s->fc) ? chord(s) : s->b + half_width(s);
        (void)step_to(s, x);
        s->settled = fabs(x - before) <= 2.0 * wanted_half(s);
        before = x;
    }
}

/* ---- Brent's ---- */

/* The step P/Q from b by interpolation through a, b, c.  Accepted only if it stays within three quarters
 * of the way to c, less a margin, and is below half the step before last, e; NaN and inf fail. */
static int interpolate(const algsurf_i_search *s, double m, double tol, double e, double *step) {
    double P, Q, w = s->fb / s->fa;
    if (s->a == s->c) {
        P = 2.0 * m * w;
        Q = 1.0 - w;
    } else {
        double q = s->fa / s->fc, r = s->fb / s->fc;
        P = w * (2.0 * m * q * (q - r) - (s->b - s->a) * (r - 1.0));
        Q = (q - 1.0) * (r - 1.0) * (w - 1.0);
    }
    if (P > 0.0)
        Q = -Q;
    else
        P = -P;
    if (!(2.0 * P < 3.0 * m * Q - fabs(tol * Q) && P < fabs(0.5 * e * Q))) return 0;
    *step = P / Q;
    return 1;
}

static void brent(algsurf_i_search *s) {
    double d = s->b - s->a, e = d; /* the last step and the one before */
    while (running(s)) {
        double tol = wanted_half(s), m = half_width(s), last = d;
        int usable = isfinite(s->fa) && isfinite(s->fc) && fabs(e) >= tol && fabs(s->fa) > fabs(s->fb);
        if (usable && interpolate(s, m, tol, e, &d))
            e = last;
        else
            d = e = m;
        double from = s->b;
        if (step_to(s, from + (fabs(d) > tol ? d : copysign(tol, m)))) d = e = s->x - from;
    }
}

/* ---- Newton's ---- */

enum { FREE_STEPS = 20 }; /* with 8, one ray polynomial in a thousand ran out and was halved 50 times */
enum { MEANS = 3 };       /* before a root is taken for one far smaller than its bracket */
#define NEAR 0x1p-8       /* ratio of ends */
#define SURPLUS 0.5       /* landing at +1/2 and then at -1/2 leaves 1 half width, which is less than 2 */

/* The unit in the last place, roughly for the largest doubles. */
static double ulp_of(double x) {
    double size = fmin(fabs(x), 0.5 * DBL_MAX);
    return algsurf_i_double_of(algsurf_i_number_of(size) + 1) - size;
}

static int is_near(double b, double c) {
    double least = fmin(fabs(b), fabs(c)), most = fmax(fabs(b), fabs(c));
    return (b < 0) == (c < 0) && most * NEAR <= least;
}

static double halfway(const algsurf_i_search *s, int halvings) {
    if (halvings < MEANS || is_near(s->b, s->c)) return s->b + half_width(s);
    int64_t b = algsurf_i_number_of(s->b), c = algsurf_i_number_of(s->c);
    return algsurf_i_double_of(b / 2 + c / 2 + (b % 2 + c % 2) / 2);
}

static void guarded_newton(algsurf_i_search *s, const double *newton) {
    int steps = 0, halvings = 0;
    double before = INFINITY; /* length of the last step */
    if (running(s) && isfinite(s->fc)) (void)step_to(s, chord(s));
    while (running(s)) {
        double half = half_width(s), inward = s->x == s->b ? half : -half;
        double surplus = SURPLUS * (s->tolerance + ulp_of(s->x));
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
            (void)step_to(s, x);
            before = length;
        } else {
            (void)step_to(s, halfway(s, halvings++));
            before = fabs(half);
        }
    }
}

void algsurf_i_search_run(algsurf_i_search *s, int method, const double *newton) {
    if (method == ALGSURF_METHOD_BISECTION)
        bisection(s);
    else if (method == ALGSURF_METHOD_REGULA_FALSI)
        regula_falsi(s);
    else if (method == ALGSURF_METHOD_DEFAULT && newton)
        guarded_newton(s, newton);
    else
        brent(s);
}
