/* exact_pieces.c - which parts of the line the exact walk looks at, and in which units.
 *
 * One piece serves an interval that is not much longer than the least of the roots is large.  Otherwise
 * halving would spend hundreds of cells on the way to small roots, and the interval is cut at 0 and at the
 * powers of two between which roots can be:
 *
 * Bounds.  With 2^(B_k - 1) <= |c_k| <= 2^(B_k), every root of p is |u| < 2^(1 + max over k < n of
 * (B_k - B_n + 1) / (n - k)) (Fujiwara 1916: twice the largest |c_k / c_n|^(1/(n-k))); and likewise its
 * inverse, from the coefficients in reverse.
 *
 * Annuli without roots.  If on 2^e <= |u| <= 2^(e+1) one term is larger than all others together, there is
 * none: |c_m u^m| >= 2^(B_m - 1 + e m), and the n others are below n 2^(max B_k + (e+1) k). */
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
        if (b - a > 16) continue;
        piece.at = (int64_t)a;
        while (b - a > (double)(1 << piece.length)) piece.length++;
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

/* f(2^shift u), up to a power of two. */
static int scaled(algsurf_memory *m, const algsurf_zpoly *f, int shift, algsurf_zpoly *g) {
    int n = f->degree, up = shift > 0 ? shift : -shift, least = ALGSURF_Z_NO_BIT, most = 0;
    for (int k = 0; k <= n; k++) {
        const algsurf_limb *c = algsurf_zpoly_at(f, k);
        int by = up * (shift > 0 ? k : n - k), low = algsurf_z_trailing(c, f->width);
        if (low == ALGSURF_Z_NO_BIT) continue;
        least = low + by < least ? low + by : least;
        most = algsurf_z_bits(c, f->width) + by > most ? algsurf_z_bits(c, f->width) + by : most;
    }
    int width = algsurf_z_width(most - least + 1);
    if (!algsurf_zpoly_new(m, n, width > f->width ? width : f->width, g)) return 0;
    for (int k = 0; k <= n; k++) {
        algsurf_limb *c = algsurf_zpoly_at(g, k);
        int by = up * (shift > 0 ? k : n - k) - least;
        algsurf_z_copy(c, g->width, algsurf_zpoly_at(f, k), f->width);
        if (by > 0) algsurf_z_shift_up(c, g->width, by);
        if (by < 0) algsurf_z_shift_down(c, g->width, -by);
    }
    return 1;
}

static int bits_of(const algsurf_zpoly *p, int k) { return algsurf_z_bits(algsurf_zpoly_at(p, k), p->width); }
static int is_zero(const algsurf_zpoly *p, int k) {
    return algsurf_z_sign(algsurf_zpoly_at(p, k), p->width) == 0;
}

static int ceiling_of_quotient(int a, int b) { return a > 0 ? (a + b - 1) / b : -(-a / b); }

/* Exponents e with 2^least < |u| < 2^most for all roots u but 0; first: the least power of u. */
static void root_bounds(const algsurf_zpoly *p, int first, int *least, int *most) {
    int n = p->degree, above = -ALGSURF_Z_NO_BIT, below = -ALGSURF_Z_NO_BIT;
    for (int k = first; k <= n; k++) {
        if (is_zero(p, k)) continue;
        int top = k < n ? ceiling_of_quotient(bits_of(p, k) - bits_of(p, n) + 1, n - k) : above;
        int bottom =
            k > first ? ceiling_of_quotient(bits_of(p, k) - bits_of(p, first) + 1, k - first) : below;
        above = top > above ? top : above;
        below = bottom > below ? bottom : below;
    }
    *most = above + 1;
    *least = -(below + 1);
}

/* Has p no root with 2^e <= |u| <= 2^(e+1)? */
static int is_bare(const algsurf_zpoly *p, int first, int e) {
    int best = -ALGSURF_Z_NO_BIT, dominant = -1, spare = algsurf_limb_bits((algsurf_limb)p->degree);
    for (int k = first; k <= p->degree; k++) {
        if (is_zero(p, k) || bits_of(p, k) - 1 + e * k <= best) continue;
        best = bits_of(p, k) - 1 + e * k;
        dominant = k;
    }
    for (int k = first; k <= p->degree; k++)
        if (k != dominant && !is_zero(p, k) && bits_of(p, k) + (e + 1) * k + spare >= best) return 0;
    return 1;
}

enum { NOT_FAR = 10 }; /* binary orders of magnitude between the interval and its least root, for one piece */

static double power_of_two(int e) { return ldexp(1, e < -1074 ? -1074 : e > 1023 ? 1023 : e); }

void algsurf_exact_pieces_begin(algsurf_exact_walk *walk) {
    algsurf_exact_pieces *s = &walk->pieces;
    const double lo = walk->lo, hi = walk->hi;
    int least = 0, most = 0;
    walk->zeros = 0;
    while (is_zero(&walk->p, walk->zeros)) walk->zeros++;
    *s = (algsurf_exact_pieces){.lo = lo, .hi = hi};
    int bounded = isfinite(lo) && isfinite(hi);
    if (bounded && !(lo <= 0 && hi >= 0) && fmin(fabs(lo), fabs(hi)) > 0x1p-6 * fmax(fabs(lo), fabs(hi)))
        return;
    if (walk->zeros < walk->p.degree) {
        root_bounds(&walk->p, walk->zeros, &least, &most);
        s->least = least + walk->unit;
        s->most = most + walk->unit;
        double farthest = bounded ? fmax(fmax(fabs(lo), fabs(hi)), 0x1p-1074) : DBL_MAX;
        if (ilogb(farthest) + 1 < s->most && bounded) s->most = ilogb(farthest) + 1; /* 2^most > all t */
        int near = walk->zeros == 0 && s->most - s->least <= NOT_FAR;
        if (near && s->most <= 1023 && s->most >= -1074) {
            double reach = power_of_two(s->most);
            s->lo = fmax(lo, -reach);
            s->hi = fmin(hi, reach);
            s->done = s->lo > s->hi;
            return;
        }
        if (near && s->most > 1023 && bounded) return;
    }
    s->scattered = 1;
    s->side = -1;
    s->exponent = s->most - 1;
}

/* Is nothing of side 2^e <= |t| <= side 2^(e+1) in [lo,hi]? */
static int is_outside(const algsurf_exact_pieces *s, int side, int e) {
    double near = e < -1074 ? 0 : power_of_two(e), far = e + 1 > 1023 ? HUGE_VAL : power_of_two(e + 1);
    return side > 0 ? far < s->lo || near > s->hi : -far > s->hi || -near < s->lo;
}

/* The next piece in units of powers of two: 1; 2 for the root at 0; 0 at the end. */
static int next_scattered(algsurf_exact_walk *walk, algsurf_exact_piece *piece) {
    algsurf_exact_pieces *s = &walk->pieces;
    for (;;) {
        if (s->side < 0 && s->exponent < s->least) {
            s->side = 0;
            s->exponent = s->least;
            if (walk->zeros > 0 && s->lo <= 0 && s->hi >= 0) return 2;
        }
        if (s->side == 0) s->side = 1;
        int side = s->side, e = s->exponent;
        if (side > 0 && e >= s->most) return 0;
        s->exponent += side;
        if (is_outside(s, side, e) || is_bare(&walk->p, walk->zeros, e - walk->unit)) continue;
        *piece = (algsurf_exact_piece){.unit = e, .at = side > 0 ? 1 : -2, .length = 0};
        return 1;
    }
}

int algsurf_exact_pieces_next(algsurf_exact_walk *walk, const algsurf_zpoly *f) {
    algsurf_exact_pieces *s = &walk->pieces;
    if (s->scattered) {
        int found = next_scattered(walk, &walk->piece);
        if (found != 1) return found;
    } else {
        if (s->done) return 0;
        s->done = 1;
        walk->piece = algsurf_exact_piece_of(s->lo, s->hi);
    }
    walk->local = *f;
    if (walk->piece.unit == walk->unit) return 1;
    return scaled(walk->memory, f, walk->piece.unit - walk->unit, &walk->local) ? 1 : -1;
}
