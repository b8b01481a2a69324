/* simple.c - bisection and plain false position, as in the textbooks: to be compared with. */
#include "../base/arithmetic.h"
#include "refine_impl.h"

void algsurf_i_refine_bisection(algsurf_i_search *s) {
    while (algsurf_i_search_running(s)) (void)algsurf_i_search_step(s, s->b + algsurf_i_search_half(s));
}

/* The zero of the chord through (b, f(b)) and (c, f(c)).  One end of the bracket usually stays for ever,
 * so the width says little: the method also stops when it hardly moves.  An infinite value has no chord. */
void algsurf_i_refine_regula_falsi(algsurf_i_search *s) {
    double before = INFINITY;
    while (algsurf_i_search_running(s)) {
        double ratio = s->fb / s->fc, part = isfinite(s->fc) ? ratio / (ratio - 1.0) : 0.5;
        double x = s->b + 2.0 * part * algsurf_i_search_half(s);
        (void)algsurf_i_search_step(s, x);
        s->settled = fabs(x - before) <= 2.0 * algsurf_i_search_tolerance(s);
        before = x;
    }
}
