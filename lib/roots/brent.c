/* brent.c - Brent, Algorithms for Minimization without Derivatives, 1973, chapter 4 ("zero"),
 * which improves Dekker's method: inverse quadratic interpolation or the secant where they shrink the
 * steps, bisection otherwise; at most about the square of bisection's evaluations, usually far fewer.
 *
 * The swaps of a, b, c are in algsurf_i_search_step.  Differences from the book: the half width is
 * computed without overflow, and an end with an infinite value is never interpolated.
 */
#include "../base/arithmetic.h"
#include "refine_impl.h"

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

void algsurf_i_refine_brent(algsurf_i_search *s) {
    double d = s->b - s->a, e = d; /* the last step and the one before */
    while (algsurf_i_search_running(s)) {
        double tol = algsurf_i_search_tolerance(s), m = algsurf_i_search_half(s), last = d;
        int usable = isfinite(s->fa) && isfinite(s->fc) && fabs(e) >= tol && fabs(s->fa) > fabs(s->fb);
        if (usable && interpolate(s, m, tol, e, &d))
            e = last;
        else
            d = e = m;
        double from = s->b;
        if (algsurf_i_search_step(s, from + (fabs(d) > tol ? d : copysign(tol, m)))) d = e = s->x - from;
    }
}
