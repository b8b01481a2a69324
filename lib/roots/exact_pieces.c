/* exact_pieces.c - which parts of the line the exact walk looks at, and in which units.
 *
 * One piece serves an interval that is not much longer than the least of the roots is large.  Otherwise
 * halving would spend hundreds of cells on the way to small roots, and the interval is cut at 0 and at the
 * powers of two between which roots can be:
 *
 * Bounds.  With 2^(B_k - 1) <= |c_k| <= 2^(B_k), every root of p is |u| < 2^(1 + max over k < n of
 * (B_k - B_n + 1) / (n - k)) (Fujiwara 1916: twice the largest |c_k / c_n|^(1/(n-k))); and likewise its
 * inverse, from the coefficients in reverse.  No root is at the bound: with M = 2^m >= |c_k / c_n|^(1/(n-k))
 * for all k and |u| = 2M the other terms are at most (1/2 + 1/4 + .. + 2^-n) |c_n u^n| together, less than
 * that one.
 *
 * Annuli without roots.  If for all 2^e <= |u| <= 2^(e+1), on one side of 0, a term is larger than all those
 * of the other sign together, there is none.  |c_k u^k| <= 2^(B_k - B_m + 1) |u|^(k-m) |c_m u^m|, where
 * |u|^(k-m) is largest at one end of the annulus, and the sum of the n others is below 2^bits(n) times the
 * largest.  What that asks of e is linear, a least e from each k < m and a largest one from each k > m: so
 * one term m leaves out all annuli up to where it no longer serves, however many there are.  There the sum
 * itself is tried, in doubles, whose relative errors are below 2^-40; what underflows in it is less. */
#include "../base/arithmetic.h"
#include <math.h>

#include "exact_walk.h"

algsurf_exact_piece algsurf_exact_piece_of(double lo, double hi) {
    algsurf_exact_piece piece = {0, 0, 0};
    double largest = fmax(fabs(lo), fabs(hi)), length = fmax(hi - lo, 0x1p-40 * largest);
    if (isinf(length)) length = 0x1p1023;
    piece.unit = length > 0 ? ilogb(length) - 3 : -1074;
    for (;; piece.unit++) {
        double a = floor(ldexp(lo, -piece.unit)), b = floor(ldexp(hi, -piece.unit)) + 1;
        if (lo < 0 && a == 0) a = -1; /* ldexp has underflown to -0 */
        if (hi < 0 && b == 1) b = 0;
        if (b - a > 16) continue;
        while (b - a > (double)(1 << piece.length)) piece.length++;
        piece.at = (int64_t)(b <= 0 ? b - (double)(1 << piece.length) : a);
        return piece;
    }
}

static int ceiling_of_quotient(int a, int b) { return a > 0 ? (a + b - 1) / b : -(-a / b); }

/* Widens to exponents e with 2^least < |t| < 2^most for all roots t of p but 0. */
static void find_root_bounds(algsurf_exact_pieces *s) {
    int first = 0, n = s->degree;
    const algsurf_exact_size *c = s->size;
    while (c[first].sign == 0) first++;
    s->least = ALGSURF_Z_NO_BIT, s->most = -ALGSURF_Z_NO_BIT;
    for (int k = first; k <= n; k++) {
        if (c[k].sign == 0) continue;
        int above = k < n ? ceiling_of_quotient(c[k].bits - c[n].bits + 1, n - k) + 1 + s->unit : s->most;
        int below = k > first ? s->unit - 1 - ceiling_of_quotient(c[k].bits - c[first].bits + 1, k - first)
                              : s->least;
        s->most = above > s->most ? above : s->most;
        s->least = below < s->least ? below : s->least;
    }
    if (s->least > s->most) s->least = s->most = 0; /* no roots but 0 */
}

/* NOT_FAR: binary orders of magnitude between the interval and its least root, for one piece.  CUT_FROM: from
 * this degree on halving costs more than another piece. */
enum { NOT_FAR = 10, CUT_FROM = 32 };

static double power_of_two(int e) { return ldexp(1, e < -1074 ? -1074 : e > 1023 ? 1023 : e); }

/* Where the roots are not far from each other, the interval is one piece, or there is one about 0 on either
 * side, to the size that the roots have in the mean. */
static int fits_one_piece(algsurf_exact_pieces *s) {
    int n = s->degree, bounded = isfinite(s->lo) && isfinite(s->hi);
    if (s->most - s->least > NOT_FAR || s->size[0].sign == 0) return 0;
    if (n >= CUT_FROM) {
        int mean = s->unit + ceiling_of_quotient(s->size[0].bits - s->size[n].bits, n);
        s->inner = mean < s->least ? s->least : mean > s->most ? s->most : mean;
        return 0;
    }
    if (s->most > 1023 || s->most < -1074) return s->most > 1023 && bounded;
    s->lo = fmax(s->lo, -power_of_two(s->most));
    s->hi = fmin(s->hi, power_of_two(s->most));
    return 1;
}

void algsurf_exact_pieces_again(algsurf_exact_pieces *s) {
    s->done = s->lo > s->hi;
    s->side = -1;
    s->exponent = s->most - 1;
}

int algsurf_exact_pieces_begin(algsurf_exact_pieces *s, algsurf_memory *m, const algsurf_zpoly *p, int unit,
                               double lo, double hi) {
    double nearest = fmin(fabs(lo), fabs(hi)), farthest = fmax(fabs(lo), fabs(hi));
    *s = (algsurf_exact_pieces){.degree = p->degree, .unit = unit, .lo = lo, .hi = hi};
    if (isfinite(farthest) && !(lo <= 0 && hi >= 0) && nearest > 0x1p-6 * farthest) return 1;
    s->size = algsurf_i_take(m, ((size_t)p->degree + 1) * sizeof *s->size);
    if (!s->size) return 0;
    for (int k = 0; k <= p->degree; k++) {
        const algsurf_limb *c = algsurf_zpoly_at(p, k);
        algsurf_exact_size *size = s->size + k;
        *size =
            (algsurf_exact_size){.bits = algsurf_z_bits(c, p->width), .sign = algsurf_z_sign(c, p->width)};
        size->part = fabs(algsurf_z_to_double(c, p->width, &size->exponent));
    }
    find_root_bounds(s);
    int beyond = isfinite(farthest) ? ilogb(fmax(farthest, 0x1p-1074)) + 1 : s->most; /* 2^beyond > all |t| */
    if (beyond < s->most) s->most = beyond > s->least ? beyond : s->least;
    s->inner = s->least;
    s->scattered = !fits_one_piece(s);
    algsurf_exact_pieces_again(s);
    return 1;
}

/* Is [2^e, 2^(e+1)], or the innermost piece, on this side of 0, outside of [lo,hi]? */
static int is_outside(const algsurf_exact_pieces *s, int side, int e) {
    double near = e < s->inner || e < -1074 ? 0 : e > 1023 ? HUGE_VAL : power_of_two(e);
    double far = e + 1 > 1023 ? HUGE_VAL : power_of_two(e + 1);
    return side > 0 ? far < s->lo || near > s->hi
                    : -far > s->hi || -near < s->lo || (-near == s->lo && isfinite(near));
}

static int sign_of_term(const algsurf_exact_pieces *s, int k, int side) {
    return side < 0 && k % 2 ? -s->size[k].sign : s->size[k].sign;
}

/* The exponent after e, in the order of this side, that the term which is largest at e leaves; e if that does
 * not leave out e. */
static int leave_out(const algsurf_exact_pieces *s, int side, int e) {
    const algsurf_exact_size *c = s->size;
    int m = -1, spare = algsurf_limb_bits((algsurf_limb)s->degree) + 1, at = e - s->unit;
    int least = s->inner - s->unit, most = s->most - 1 - s->unit; /* where the term m serves */
    for (int k = 0; k <= s->degree; k++)
        if (c[k].sign && (m < 0 || c[k].bits + at * k > c[m].bits + at * m)) m = k;
    for (int k = 0; k <= s->degree; k++) {
        if (sign_of_term(s, k, side) != -sign_of_term(s, m, side)) continue;
        int excess = c[k].bits - c[m].bits + spare, bound;
        if (k < m && (bound = ceiling_of_quotient(excess, m - k)) > least) least = bound;
        if (k > m && (bound = -ceiling_of_quotient(excess, k - m) - 1) < most) most = bound;
    }
    if (at >= least && at <= most) return s->unit + (side > 0 ? most + 1 : least - 1);
    double sum = 0;
    for (int k = 0; k <= s->degree; k++)
        if (sign_of_term(s, k, side) == -sign_of_term(s, m, side))
            sum +=
                ldexp(c[k].part / c[m].part, c[k].exponent - c[m].exponent + (k > m ? at + 1 : at) * (k - m));
    return sum < 1 - 0x1p-30 ? e + side : e;
}

/* The next piece in units of powers of two. */
static int next_scattered(algsurf_exact_pieces *s, algsurf_exact_piece *piece) {
    for (;;) {
        int innermost = s->inner - (s->inner > s->least);
        if (s->side < 0 && s->exponent < innermost) {
            s->side = 1;
            s->exponent = innermost;
            if (s->size[0].sign == 0) return ALGSURF_EXACT_ZERO;
        }
        int side = s->side, e = s->exponent, about = e < s->inner; /* about 0 */
        if (side > 0 && e >= s->most) return ALGSURF_EXACT_NO_PIECE;
        if (!about && (s->exponent = leave_out(s, side, e)) != e) continue;
        s->exponent += side;
        if (is_outside(s, side, e)) continue;
        *piece = (algsurf_exact_piece){.unit = e + about, .at = side > 0 ? 1 - about : about - 2};
        return ALGSURF_EXACT_PIECE;
    }
}

int algsurf_exact_pieces_next(algsurf_exact_pieces *s, algsurf_exact_piece *piece) {
    if (s->scattered) return next_scattered(s, piece);
    if (s->done) return ALGSURF_EXACT_NO_PIECE;
    s->done = 1;
    *piece = algsurf_exact_piece_of(s->lo, s->hi);
    return ALGSURF_EXACT_PIECE;
}
