/* refine_dd.c - Newton's method in double-double, guarded by its bracket.
 *
 * The correction f/f' needs f in double-double but f' only in double: a relative error of 1e-10 in f'
 * costs nothing but speed of convergence.  A step that leaves the bracket, or does not at least halve
 * the step before it, is replaced by a halving. */
#include "refine_dd.h"

#include <math.h>

static algsurf_dd evaluate(const algsurf_dd *c, int n, algsurf_dd v, double *derivative) {
    algsurf_dd f = c[n];
    double d = 0;
    for (int k = n - 1; k >= 0; k--) {
        d = d * v.hi + f.hi;
        f = algsurf_dd_add(algsurf_dd_mul(f, v), c[k]);
    }
    *derivative = d;
    return f;
}

algsurf_dd algsurf_i_refine_dd(const algsurf_dd *c, int n, algsurf_dd a, algsurf_dd b, int sign) {
    algsurf_dd v = algsurf_dd_scale(algsurf_dd_add(a, b), 0.5);
    double last = b.hi - a.hi;
    for (int i = 0; i < 400; i++) {
        double derivative;
        algsurf_dd f = evaluate(c, n, v, &derivative);
        int s = algsurf_dd_sign(f);
        if (s == 0) return v;
        if (s == sign) a = v;
        else b = v;
        double step = -f.hi / derivative;
        algsurf_dd next = algsurf_dd_add_d(v, step);
        if (!(fabs(step) < 0.5 * fabs(last)) || !algsurf_dd_less(a, next) || !algsurf_dd_less(next, b)) {
            next = algsurf_dd_scale(algsurf_dd_add(a, b), 0.5);
            step = algsurf_dd_sub(next, v).hi;
        }
        if (fabs(step) <= 0x1p-100 * fabs(next.hi)) return next;
        last = step;
        v = next;
    }
    return v;
}

int algsurf_i_sign_dd(const algsurf_dd *c, int n, algsurf_dd v) {
    double derivative;
    return algsurf_dd_sign(evaluate(c, n, v, &derivative));
}
