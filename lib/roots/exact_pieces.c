/* exact_pieces.c - which parts of the line the exact walk looks at, and in which units.
 *
 * One piece serves an interval that is not much longer than the least of the roots is large.  Otherwise
 * halving would spend hundreds of cells on the way to small roots, and the interval is cut at 0 and at the
 * powers of two between which roots can be:
 *
 * Bounds.  With 2^(B_k - 1) <= |c_k| <= 2^(B_k), every root of p is |u| < 2^(1 + max over k < n of
 * (B_k - B_n + 1) / (n - k)) (Fujiwara 1916: twice the largest |c_k / c_n|^(1/(n-k))); and likewise its
 * inverse, from the coefficients in reverse.  No root is at the bound: with M = 2^m >= |c_k / c_n|^(1/(n-k)) for
 * all k and |u| = 2M the other terms are at most (1/2 + 1/4 + .. + 2^-n) |c_n u^n| together, less than that one.
 *
 * Annuli without roots.  If on 2^e <= |u| <= 2^(e+1), on one side of 0, a term is larger than all those of
 * the other sign together, there is none.  |c_k u^k| <= 2^(B_k - B_m + 1) |u|^(k-m) |c_m u^m|, where
 * |u|^(k-m) is largest at one end of the annulus, and the sum of the n others is below 2^bits(n) times the
 * largest.
 *
 * Sets of polynomials lie between two envelopes, for u below 0 and above (exact_radii.c).  Where both have
 * the same sign, no polynomial of the set has a root; where they have different ones, each point is a root of
 * some, and there is nothing to be found.  Both hold beyond the roots of the envelopes, and within them, too:
 * in `most` and `least - 1`, the outermost and the innermost pieces. */
#include "../base/arithmetic.h"
#include <float.h>
#include <math.h>

#include "exact.h"

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

int algsurf_exact_low_bit(double x) {
    int e;
    return algsurf_z_odd_part(x, &e) ? e : ALGSURF_Z_NO_BIT;
}

int algsurf_exact_from_doubles_above(algsurf_memory *m, const double *c, int degree, int unit, int least,
                                     algsurf_zpoly *p) {
    int most = least;
    for (int k = 0; k <= degree; k++)
        if (c[k] != 0 && ilogb(c[k]) + 1 + k * unit > most) most = ilogb(c[k]) + 1 + k * unit;
    if (!algsurf_zpoly_new(m, degree, algsurf_z_width(most - least), p)) return 0;
    for (int k = 0; k <= degree; k++)
        if (c[k] != 0) algsurf_z_add_double(algsurf_zpoly_at(p, k), p->width, c[k], k * unit - least);
    while (p->degree >= 0 && algsurf_z_sign(algsurf_zpoly_at(p, p->degree), p->width) == 0) p->degree--;
    return 1;
}

int algsurf_exact_from_doubles(algsurf_memory *m, const double *c, int degree, int unit, algsurf_zpoly *p) {
    int least = ALGSURF_Z_NO_BIT;
    for (int k = 0; k <= degree; k++) {
        int low = algsurf_exact_low_bit(c[k]);
        if (low != ALGSURF_Z_NO_BIT && low + k * unit < least) least = low + k * unit;
    }
    return algsurf_exact_from_doubles_above(m, c, degree, unit, least == ALGSURF_Z_NO_BIT ? 0 : least, p);
}

static int bits_of(const algsurf_zpoly *p, int k) { return algsurf_z_bits(algsurf_zpoly_at(p, k), p->width); }
static int is_zero(const algsurf_zpoly *p, int k) {
    return algsurf_z_sign(algsurf_zpoly_at(p, k), p->width) == 0;
}

static int ceiling_of_quotient(int a, int b) { return a > 0 ? (a + b - 1) / b : -(-a / b); }

/* The first coefficient, in steps from `from`, that is not 0; p is not the zero polynomial. */
static int first_nonzero(const algsurf_zpoly *p, int from, int step) {
    while (is_zero(p, from)) from += step;
    return from;
}

/* Widens to exponents e with 2^least < |t| < 2^most for all roots t of p but 0. */
static void add_root_bounds(const algsurf_zpoly *p, algsurf_exact_pieces *s) {
    int first = first_nonzero(p, 0, 1), n = first_nonzero(p, p->degree, -1);
    for (int k = first; k <= n; k++) {
        if (is_zero(p, k)) continue;
        int above =
            k < n ? ceiling_of_quotient(bits_of(p, k) - bits_of(p, n) + 1, n - k) + 1 + s->unit : s->most;
        int below = k > first
                        ? s->unit - 1 - ceiling_of_quotient(bits_of(p, k) - bits_of(p, first) + 1, k - first)
                        : s->least;
        s->most = above > s->most ? above : s->most;
        s->least = below < s->least ? below : s->least;
    }
}

static int sign_of_term(const algsurf_zpoly *p, int k, int side) {
    int sign = algsurf_z_sign(algsurf_zpoly_at(p, k), p->width);
    return side < 0 && k % 2 ? -sign : sign;
}

/* The sign of p for all 2^e <= |u| <= 2^(e+1) on this side, if one term shows it; else 0. */
static int sign_by_one_term(const algsurf_zpoly *p, int side, int e) {
    int best = -ALGSURF_Z_NO_BIT, m = 0, spare = algsurf_limb_bits((algsurf_limb)p->degree);
    for (int k = 0; k <= p->degree; k++) {
        if (is_zero(p, k) || bits_of(p, k) - 1 + e * k <= best) continue;
        best = bits_of(p, k) - 1 + e * k;
        m = k;
    }
    int sign = sign_of_term(p, m, side);
    for (int k = 0; k <= p->degree; k++)
        if (sign_of_term(p, k, side) == -sign && bits_of(p, k) + e * k + (k > m ? k - m : 0) + spare > best)
            return 0;
    return sign;
}

/* The same for the current piece, where it may be one that no root reaches. */
static int sign_in_piece(const algsurf_exact_pieces *s, const algsurf_zpoly *p, int side, int e) {
    if (e < s->least) return s->merged ? 0 : sign_of_term(p, first_nonzero(p, 0, 1), side);
    if (e >= s->most) return sign_of_term(p, first_nonzero(p, p->degree, -1), side);
    return sign_by_one_term(p, side, e - s->unit);
}

enum { NOT_FAR = 10 }; /* binary orders of magnitude between the interval and its least root, for one piece */

static double power_of_two(int e) { return ldexp(1, e < -1074 ? -1074 : e > 1023 ? 1023 : e); }

/* Where the roots are not far from each other, the interval is one piece, or one on either side of 0. */
static int fits_one_piece(algsurf_exact_pieces *s) {
    int bounded = isfinite(s->lo) && isfinite(s->hi);
    if (s->most - s->least > NOT_FAR) return 0;
    if (s->polynomials > 1) {
        s->least = s->most;
        s->merged = 1;
        return 0;
    }
    if (is_zero(s->above, 0)) return 0;
    if (s->most > 1023 || s->most < -1074) return s->most > 1023 && bounded;
    s->lo = fmax(s->lo, -power_of_two(s->most));
    s->hi = fmin(s->hi, power_of_two(s->most));
    s->done = s->lo > s->hi;
    return 1;
}

void algsurf_exact_pieces_begin(algsurf_exact_pieces *s, const algsurf_zpoly *below,
                                const algsurf_zpoly *above, int polynomials, int unit, double lo, double hi) {
    double nearest = fmin(fabs(lo), fabs(hi)), farthest = fmax(fabs(lo), fabs(hi));
    *s = (algsurf_exact_pieces){.below = below, .above = above, .polynomials = polynomials, .unit = unit};
    s->lo = lo, s->hi = hi;
    if (isfinite(farthest) && !(lo <= 0 && hi >= 0) && nearest > 0x1p-6 * farthest) return;
    s->least = ALGSURF_Z_NO_BIT, s->most = -ALGSURF_Z_NO_BIT;
    for (int i = 0; i < polynomials; i++) {
        add_root_bounds(below + i, s);
        add_root_bounds(above + i, s);
    }
    if (s->least > s->most) s->least = s->most = 0;                                   /* no roots but 0 */
    int beyond = isfinite(farthest) ? ilogb(fmax(farthest, 0x1p-1074)) + 1 : s->most; /* 2^beyond > all |t| */
    if (beyond < s->most) s->most = beyond > s->least ? beyond : s->least;
    s->scattered = !fits_one_piece(s);
    s->side = -1;
    s->exponent = s->most;
}

/* Sets the bounds of a piece; is nothing of it in [lo,hi]? */
static int is_outside(algsurf_exact_pieces *s, int side, int e) {
    double near = e < s->least || e < -1074 ? 0 : e > 1023 ? HUGE_VAL : power_of_two(e);
    s->near = fmin(near, DBL_MAX);
    s->far = e + 1 > 1023 || (e >= s->least && e >= s->most) ? HUGE_VAL : power_of_two(e + 1);
    return side > 0 ? s->far < s->lo || near > s->hi : -s->far > s->hi || -near < s->lo;
}

/* The next piece in units of powers of two. */
static int next_scattered(algsurf_exact_pieces *s, algsurf_exact_piece *piece) {
    for (;;) {
        if (s->side < 0 && s->exponent < s->least - 1) {
            s->side = 1;
            s->exponent = s->least - 1;
            if (sign_of_term(s->above, 0, 1) * sign_of_term(s->above + s->polynomials - 1, 0, 1) <= 0)
                return ALGSURF_EXACT_ZERO;
        }
        int side = s->side, e = s->exponent;
        if (side > 0 && e > s->most) return ALGSURF_EXACT_NO_PIECE;
        s->exponent += side;
        if (is_outside(s, side, e)) continue;
        const algsurf_zpoly *p = side > 0 ? s->above : s->below;
        int lower = sign_in_piece(s, p, side, e), upper = sign_in_piece(s, p + s->polynomials - 1, side, e);
        if (lower != 0 && lower == upper) continue;
        int inner = e < s->least; /* from 0 to 2^(e+1) */
        *piece = (algsurf_exact_piece){.unit = e + inner, .at = side > 0 ? 1 - inner : inner - 2};
        return lower * upper < 0 ? ALGSURF_EXACT_OPEN : ALGSURF_EXACT_PIECE;
    }
}

int algsurf_exact_pieces_next(algsurf_exact_pieces *s, algsurf_exact_piece *piece) {
    if (s->scattered) return next_scattered(s, piece);
    if (s->done) return ALGSURF_EXACT_NO_PIECE;
    s->done = 1;
    *piece = algsurf_exact_piece_of(s->lo, s->hi);
    return ALGSURF_EXACT_PIECE;
}
