/* interval_arg.c - the argument of a rectangle, by an arctangent with a proved error.
 *
 * Over a rectangle without 0 the argument takes its extremes at corners; each corner's angle is
 *     a multiple of pi/2 +- atan t,  t = n / d <= 1 the smaller component over the larger.
 * With c = i/16 nearest to t, by the addition theorem,
 *     atan t = atan c + atan r,  r = (t - c) / (1 + t c) = (n - c d) / (d + c n),  |r| <= 1/32,
 * where atan c comes from a table, r is a double-double, and with z = r^2 <= 2^-10
 *     atan r = r - r P,  P = z (1/3 - z/5 + z^2/7 - z^3/9 + z^4/11) - R,  0 < R < z^6/13 < 2^-63.
 *
 * The error, u = 2^-53, is bounded in two parts.
 *   Relative to r.  P in double has 1 rounding from z, less than 2.1 from the factor in brackets (1/3,
 * and the last subtraction; the inner ones come times z), 1 from their product, 1 from the product with
 * r.hi; then r.hi P, being added to the low parts, takes part in 7 additions up to the end:
 * 12.1 u |r| P < 2^-7.9 u |r|.  |r.lo| < u c + 4u |r| < 2u, and the slope of atan there is taken as 1 - z:
 * z^2 |r.lo| < 2^-14 u |r|.  R adds 2^-10 u |r|.  Together less than 2^-7 u |r| = 2^-60 |r|.
 *   Relative to the angle.  The other low parts are at most u times the high ones, together less than
 * 20 u, or 10 u |angle| in the first octant, where c < 3 |angle|; each of the 7 additions errs by u times
 * that, r.lo itself by 5 u |r.lo|, and the constants are good to 106 bits: less than 200 u^2 < 2^-98 in
 * all, or 2^-98 |angle| there.  The rest of the circle is above pi/4: 2^-96 |angle| covers both.
 * So the ends are mostly the two doubles around the angle, else 2 units in the last place apart.
 */
#include "../base/arithmetic.h"
#include "interval_impl.h"

/* i pi/2 */
static const algsurf_dd quarter_turns[4] = {
    {0.0, 0.0},
    {0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54},
    {0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53},
    {0x1.2d97c7f3321d2p+2, 0x1.a79394c9e8a0ap-53},
};

/* atan(i/16) */
static const algsurf_dd arctangents[17] = {
    {0.0, 0.0},
    {0x1.ff55bb72cfdeap-5, -0x1.c934d86d23f1dp-60},
    {0x1.fd5ba9aac2f6ep-4, -0x1.cd37686760c17p-59},
    {0x1.7b97b4bce5b02p-3, 0x1.347b0b4f881cap-58},
    {0x1.f5b75f92c80ddp-3, 0x1.8ab6e3cf7afbdp-57},
    {0x1.362773707ebccp-2, -0x1.963a544b672d8p-57},
    {0x1.6f61941e4def1p-2, -0x1.c63aae6f6e918p-56},
    {0x1.a64eec3cc23fdp-2, -0x1.24dec1b50b7ffp-56},
    {0x1.dac670561bb4fp-2, 0x1.a2b7f222f65e2p-56},
    {0x1.0657e94db30d0p-1, -0x1.d5b495f6349e6p-56},
    {0x1.1e00babdefeb4p-1, -0x1.928df287a668fp-58},
    {0x1.345f01cce37bbp-1, 0x1.1021137c71102p-55},
    {0x1.4978fa3269ee1p-1, 0x1.2419a87f2a458p-56},
    {0x1.5d58987169b18p-1, 0x1.0028e4bc5e7cap-57},
    {0x1.700a7c5784634p-1, -0x1.8c34d25aadef6p-56},
    {0x1.819d0b7158a4dp-1, -0x1.bf76229d3b917p-56},
    {0x1.921fb54442d18p-1, 0x1.1a62633145c07p-55},
};

/* The exact sum of both high parts and, rounded, of both low ones. */
static algsurf_dd sum(algsurf_dd a, algsurf_dd b) {
    algsurf_dd s = algsurf_two_sum(a.hi, b.hi);
    return (algsurf_dd){s.hi, s.lo + (a.lo + b.lo)};
}

/* (n - c d) / (d + c n): the quotient of the high parts, and what its remainder and the low parts add. */
static algsurf_dd reduced(double n, double d, double c) {
    algsurf_dd cd = algsurf_two_prod(c, d), cn = algsurf_two_prod(c, n);
    algsurf_dd above = sum((algsurf_dd){n, 0}, algsurf_dd_neg(cd)), below = sum((algsurf_dd){d, 0}, cn);
    double q = above.hi / below.hi, rest = algsurf_i_remainder(above.hi, q, below.hi);
    return (algsurf_dd){q, (rest + (above.lo - q * below.lo)) / below.hi};
}

/* atan(n/d), 2^-100 < n/d <= 1, 1/2 <= d < 1; the part of the error that is relative to r in *error. */
static algsurf_dd arctangent(double n, double d, double *error) {
    int i = (int)(16 * (n / d) + 0.5);
    algsurf_dd r = reduced(n, d, 0.0625 * i);
    double z = r.hi * r.hi;
    double p = z * (1.0 / 3 - z * (1.0 / 5 - z * (1.0 / 7 - z * (1.0 / 9 - z * (1.0 / 11)))));
    *error = 0x1p-60 * fabs(r.hi);
    return sum(arctangents[i], (algsurf_dd){r.hi, r.lo - (r.hi * p + r.lo * z)});
}

static algsurf_interval around(algsurf_dd angle, double error) {
    error += 0x1p-96 * fabs(angle.hi);
    return (algsurf_interval){algsurf_i_add_down(angle.hi, angle.lo - error),
                              algsurf_i_add_up(angle.hi, angle.lo + error)};
}

/* atan(n/d), 0 < n/d < 2^-54, is less than n/d by a relative 2^-109 at most, but a quotient of doubles that
 * is no double differs from each by a relative 2^-106 at least: it stays between the same two. */
static algsurf_interval small_arctangent(double n, double d) {
    double lo = algsurf_i_div_down(n, d), hi = algsurf_i_div_up(n, d);
    return (algsurf_interval){lo < hi ? lo : 0.0 - algsurf_i_step_up(-lo, 1), hi};
}

/* The angle of x + iy from the positive real axis counterclockwise, at most 3 pi/2; not for x > 0 > y.
 * A component may be infinite: the limit. */
static algsurf_interval turn(double x, double y) {
    double a = fabs(x), b = fabs(y);
    int steep = b > a;
    double n = steep ? a : b, d = steep ? b : a;
    int quarter = steep ? (y > 0 ? 1 : 3) : (x > 0 ? 0 : 2);
    int minus = steep == ((x > 0) == (y > 0)); /* the arctangent counts against the angle */
    if (n == 0 || isinf(d)) return around(quarter_turns[quarter], 0.0);
    if (quarter == 0 && n < 0x1p-54 * d) return small_arctangent(n, d);
    int k;
    d = frexp(d, &k), n = ldexp(n, -k);
    double error = 0x1p-99; /* what leaving out n <= 2^-100 costs */
    algsurf_dd t = {0.0, 0.0};
    if (n > 0x1p-100) t = arctangent(n, d, &error);
    return around(sum(quarter_turns[quarter], minus ? algsurf_dd_neg(t) : t), error);
}

/* y >= 0: the argument falls with x; it rises with y where x > 0 and falls where x < 0. */
static algsurf_interval upper_half(algsurf_interval x, algsurf_interval y) {
    return (algsurf_interval){turn(x.hi, x.hi > 0 ? y.lo : y.hi).lo, turn(x.lo, x.lo < 0 ? y.lo : y.hi).hi};
}

/* A rectangle that touches the negative real axis from below or crosses it is taken from above and followed
 * beyond pi; without 0 it lies in x < 0. */
algsurf_interval algsurf_i_cinterval_arg(algsurf_cinterval a) {
    algsurf_interval x = a.re, y = a.im;
    if (y.lo >= 0) return upper_half(x, y);
    if (y.hi < 0) return algsurf_i_interval_neg(upper_half(x, algsurf_i_interval_neg(y)));
    if (x.lo > 0) return (algsurf_interval){0.0 - turn(x.lo, -y.lo).hi, turn(x.lo, y.hi).hi};
    return (algsurf_interval){turn(x.hi, y.hi).lo, turn(x.hi, y.lo).hi};
}
