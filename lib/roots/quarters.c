/* quarters.c - four shifts by one in place of a walk.
 *
 * In units of s, p(u+1) has as many variations of sign as p has roots u > 1, or more by an even number
 * (Budan); of p's coefficients in reverse the same is true for u < 1, and of p(-u) for the negative sides.  A
 * shift takes n^2/2 sums of numbers that are n bits longer than p's: a fraction of what Bernstein
 * coefficients and one halving do.  Roots of polynomials made at random are near the unit circle, few of them
 * real: often this is all. */
#include "../base/arithmetic.h"
#include "quarters.h"

#include <math.h>

#include "decide.h"
#include "exact.h"

static void reverse(algsurf_zpoly *p) {
    for (int i = 0, j = p->degree; i < j; i++, j--)
        for (int k = 0; k < p->width; k++) {
            algsurf_limb *a = algsurf_zpoly_at(p, i) + k, *b = algsurf_zpoly_at(p, j) + k, limb = *a;
            *a = *b;
            *b = limb;
        }
}

/* Beyond 1 on this side, and the sign there. */
static int variations_beyond(algsurf_memory *m, const algsurf_zpoly *p, int side, int *v, int *sign) {
    algsurf_zpoly q;
    algsurf_memory_mark mark = algsurf_memory_here(m);
    int last = 0;
    if (!algsurf_zpoly_shift_by_one(m, p, side, &q)) return 0;
    *v = 0;
    for (int k = 0; k <= q.degree; k++) {
        int s = algsurf_z_sign(algsurf_zpoly_at(&q, k), q.width);
        if (k == 0) *sign = s;
        *v += s * last < 0;
        last = s ? s : last;
    }
    algsurf_memory_release(m, mark);
    return 1;
}

/* The variations v[0..3] in (-inf,-s), (-s,0), (0,s), (s,inf), s = 2^unit, and the signs at the ends between
 * them. */
static int count_quarters(const algsurf_i_coefficients *c, int unit, int *v, int *sign) {
    algsurf_limb block[1024];
    algsurf_memory m;
    algsurf_zpoly p;
    algsurf_memory_begin(&m, block, sizeof block / sizeof *block, ALGSURF_I_DECIDE_MEMORY);
    algsurf_memory_mark begin = algsurf_memory_here(&m);
    int unused, done = algsurf_exact_from_doubles(&m, c->c, c->degree, unit, &p) &&
                       variations_beyond(&m, &p, -1, v, sign) &&
                       variations_beyond(&m, &p, 1, v + 3, sign + 2);
    if (done) reverse(&p);
    done =
        done && variations_beyond(&m, &p, -1, v + 1, &unused) && variations_beyond(&m, &p, 1, v + 2, &unused);
    algsurf_memory_release(&m, begin);
    sign[1] = c->c[0] > 0 ? 1 : -1;
    return done;
}

int algsurf_i_parts_of(const algsurf_i_coefficients *p, double lo, double hi, algsurf_i_part *parts) {
    int n = p->degree, v[4], sign[3], bound, count = 0;
    parts[0] = (algsurf_i_part){lo, hi, 0};
    if (n < ALGSURF_I_PARTS_DEGREE || p->c[0] == 0 || (bound = algsurf_i_root_bound(p)) > 1023) return 1;
    int mean = (ilogb(p->c[0]) - ilogb(p->c[n])) / n; /* of the roots' exponents */
    double s = ldexp(1, mean), far = ldexp(1, bound), ends[5] = {-far, -s, 0, s, far};
    if (!(s > 0x1p-900 && s < far) || !count_quarters(p, mean, v, sign) || !sign[0] || !sign[2]) return 1;
    for (int i = 0; i < 4; i++) {
        double from = fmax(ends[i], lo), to = fmin(ends[i + 1], hi);
        if (from > to || v[i] == 0) continue;
        int whole = from == ends[i] && to == ends[i + 1], before = i > 0 ? sign[i - 1] : -sign[0];
        parts[count++] = (algsurf_i_part){from, to, whole && v[i] == 1 ? before : 0};
    }
    return count;
}
