/* line.c - an interval of the line, cut into a near piece about 0 and a far piece on either side. */
#include <math.h>

#include "isolate_impl.h"

/* The far variable v = -1/s of an end; infinity is 0.  Beyond 2^900, where products would overflow, in
 * steps: v is then so small that what underflow takes from it is below every bound. */
static algsurf_dd far_end(algsurf_dd s) {
    if (isinf(s.hi)) return algsurf_dd_from(0);
    if (fabs(s.hi) < 0x1p900) return algsurf_dd_div(algsurf_dd_from(-1), s);
    return algsurf_dd_scale(algsurf_dd_div(algsurf_dd_from(-1), algsurf_dd_scale(s, 0x1p-200)), 0x1p-200);
}

static algsurf_dd least(algsurf_dd a, algsurf_dd b) { return algsurf_dd_less(b, a) ? b : a; }
static algsurf_dd greatest(algsurf_dd a, algsurf_dd b) { return algsurf_dd_less(a, b) ? b : a; }

int algsurf_i_cut_line(algsurf_dd lo, algsurf_dd hi, algsurf_i_piece pieces[3]) {
    const algsurf_dd right = algsurf_dd_from(ALGSURF_CUT), left = algsurf_dd_from(-ALGSURF_CUT);
    algsurf_dd near_lo = greatest(lo, left), near_hi = least(hi, right);
    int count = 0;
    if (algsurf_dd_less(lo, left))
        pieces[count++] = (algsurf_i_piece){1, far_end(lo), far_end(least(hi, left)), 0, 0};
    if (algsurf_dd_less(near_lo, near_hi)) pieces[count++] = (algsurf_i_piece){0, near_lo, near_hi, 0, 0};
    if (algsurf_dd_less(right, hi))
        pieces[count++] = (algsurf_i_piece){1, far_end(greatest(lo, right)), far_end(hi), 0, 0};
    return count;
}
