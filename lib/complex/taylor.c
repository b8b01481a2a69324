/* taylor.c - p(z) and its Taylor coefficients, by Horner's rule on integers that are as long as they need be.
 *
 * The sum so far is (r + i s) 2^e; a step multiplies it by z and adds a coefficient.  After that of c_k the
 * sum is still to be multiplied by z^k, so that what is below 2^F |z|^-k in it is below 2^F in p(z): it is
 * cut, for F = log2 max_k |c_k| |z|^k - 64 w + SPARE.  Before that z is multiplied without its last limbs, as
 * many as change each part by less than half a unit of that size; the cuts change it by less than 1 for each
 * of two terms: 4 units a step in all.  A unit is a power of two, at most twice 2^F |z|^-k.  log2 |z| is off
 * by less than 2^-50, and 2^-53 of itself, and is below 2^31, so that n <= 1024 steps lose at most 9 n 2^F.
 *
 * Nothing else is cut in p(z): its sums are below 2 n times the largest term in each part, 2^(64 w + 6)
 * units, and w + 1 limbs hold them.  Other coefficients may have larger sums, of which the ends are cut, too;
 * nothing is said of their errors. */
#include "../base/arithmetic.h"
#include <math.h>

#include "../base/elementary.h"
#include "discs.h"

#define SPARE 6 /* bits in which largest terms may add up without another limb */

algsurf_limb algsurf_i_limb_at(const algsurf_limb *a, int w, int64_t from) {
    if (from >= 64 * (int64_t)w) return 0 - (a[w - 1] >> 63);
    if (from >= 0) return algsurf_z_window(a, w, (int)from);
    return from > -64 ? a[0] << -from : 0;
}

void algsurf_i_add_shifted(algsurf_limb *r, int w, const algsurf_limb *a, int wa, int64_t shift) {
    unsigned char carry = 0;
    const int64_t at = -shift >> 6; /* of r[0] in a, rounded down */
    const int rest = (int)(-shift & 63);
    const algsurf_limb sign = 0 - (a[wa - 1] >> 63);
    algsurf_limb low = at < 0 ? 0 : at < wa ? a[at] : sign;
    for (int i = 0; i < w; i++) {
        int64_t k = at + i + 1;
        algsurf_limb high = k < 0 ? 0 : k < wa ? a[k] : sign;
        algsurf_limb limb = rest ? low >> rest | high << (64 - rest) : low;
        r[i] = algsurf_limb_add(r[i], limb, &carry);
        low = high;
    }
}

void algsurf_i_add_double(algsurf_limb *r, int w, double x, int64_t shift) {
    algsurf_limb m = (algsurf_limb)(int64_t)(x * 0x1p60);
    algsurf_i_add_shifted(r, w, &m, 1, shift - 60);
}

int algsurf_i_bits(const algsurf_limb *x, const algsurf_limb *y, int w) {
    int a = algsurf_z_bits(x, w), b = y ? algsurf_z_bits(y, w) : 0;
    return a > b ? a : b;
}

algsurf_scaled algsurf_i_head(const algsurf_limb *x, const algsurf_limb *y, int w, int64_t exponent) {
    int bits = algsurf_i_bits(x, y, w) + 1;
    return scaled_of((double)(int64_t)algsurf_i_limb_at(x, w, bits - 63),
                     y ? (double)(int64_t)algsurf_i_limb_at(y, w, bits - 63) : 0, exponent + bits - 63);
}

/* Both parts have 53 bits, and the head's window of 63 begins below the last one. */
int algsurf_i_head_is_exact(const algsurf_limb *x, const algsurf_limb *y, int w) {
    const algsurf_limb *part[2] = {x, y};
    const int top = algsurf_i_bits(x, y, w);
    for (int i = 0; i < 2 && part[i]; i++) {
        int last = algsurf_z_trailing(part[i], w);
        if (last == ALGSURF_Z_NO_BIT) continue;
        if (algsurf_z_bits(part[i], w) - last > 53 || top - last > 60) return 0;
    }
    return 1;
}

/* What a sum is multiplied by, and room for the product. */
typedef struct multiplier {
    algsurf_z_factor x, y;
    int w, most; /* limbs of each part, and of a sum at most */
    int real;    /* all parts im are 0, and stay as they are */
    int64_t exponent;
    algsurf_limb *re, *im;
} multiplier;

/* -1: both are 0. */
static int bits_or_none(const algsurf_limb *x, const algsurf_limb *y, int w) {
    const int bits = algsurf_i_bits(x, y, w); /* of 0 and of -1 it is 0 */
    return bits == 0 && x[0] == 0 && (!y || y[0] == 0) ? -1 : bits;
}

/* What is left of a number without its last limbs. */
static algsurf_z_factor without(algsurf_z_factor f, int limbs) {
    f.limb += limbs, f.length = f.length > limbs ? f.length - limbs : 0;
    return f;
}

/* The product of a sum with z without its last limbs. */
static algsurf_i_sum multiply(const algsurf_i_sum *a, const multiplier *z, int cut) {
    algsurf_i_sum c = {z->re, z->im, a->w + z->w - cut, -1, a->exponent + z->exponent + 64 * cut};
    const algsurf_z_factor x = without(z->x, cut), y = without(z->y, cut);
    if (a->bits < 0) return c;
    algsurf_z_zero(c.re, c.w);
    algsurf_z_add_times(c.re, c.w, a->re, a->w, &x, 0);
    if (!z->real) {
        algsurf_z_zero(c.im, c.w);
        algsurf_z_add_times(c.im, c.w, a->re, a->w, &y, 0);
        algsurf_z_add_times(c.re, c.w, a->im, a->w, &y, 1);
        algsurf_z_add_times(c.im, c.w, a->im, a->w, &x, 0);
    }
    c.bits = bits_or_none(c.re, z->real ? NULL : c.im, c.w);
    return c;
}

/* sum = sum z + t, cut below 2^low; t's im may be null: 0.  Whether anything was cut. */
static int step(algsurf_i_sum *a, const multiplier *z, const algsurf_i_sum *t, int64_t low) {
    int64_t top = INT64_MIN, end = INT64_MAX;
    const int64_t idle = (low - a->exponent - z->exponent - a->bits - 2) / 64;
    const int cut = a->bits < 0 || idle < 0 ? 0 : idle < z->w ? (int)idle : z->w - 1;
    const algsurf_i_sum product = multiply(a, z, cut), *term[2] = {&product, t};
    for (int i = 0; i < 2; i++) {
        const algsurf_i_sum *b = term[i];
        if (b->bits < 0) continue;
        top = top > b->exponent + b->bits ? top : b->exponent + b->bits;
        end = end < b->exponent ? end : b->exponent;
    }
    if (end == INT64_MAX) {
        a->w = 1, a->bits = -1, *a->re = *a->im = 0;
        return cut > 0;
    }
    int64_t e = top + 2 - 64 * (int64_t)z->most;
    if (e < low) e = low;
    const int is_cut = cut > 0 || e > end;
    if (e < end) e = end;
    a->exponent = e;
    a->w = top + 2 > e ? (int)((top + 65 - e) / 64) : 1;
    algsurf_z_zero(a->re, a->w);
    if (!z->real) algsurf_z_zero(a->im, a->w);
    for (int i = 0; i < 2; i++) {
        const algsurf_i_sum *b = term[i];
        if (b->bits < 0) continue;
        algsurf_i_add_shifted(a->re, a->w, b->re, b->w, b->exponent - e);
        if (!z->real && b->im) algsurf_i_add_shifted(a->im, a->w, b->im, b->w, b->exponent - e);
    }
    a->bits = bits_or_none(a->re, z->real ? NULL : a->im, a->w);
    return is_cut;
}

/* Room for `last` + 1 sums; what is too small is left to the memory's end. */
static int make_room(algsurf_i_sums *s, int last, size_t limbs) {
    if (last > s->last) {
        s->at = algsurf_i_take(s->m, (size_t)(last + 1) * sizeof *s->at);
        if (!s->at) return 0;
        s->last = last;
    }
    if (limbs > s->limbs) {
        s->limbs = limbs + limbs / 2;
        s->room = algsurf_memory_take(s->m, s->limbs);
    }
    return s->room != NULL;
}

/* The largest |c_k| |z|^k up to k = n, as bits, for |z| = 2^far. */
static double largest_term(const algsurf_i_integers *p, int n, double far) {
    double most = p->bits[n] + n * far;
    for (int k = 0; k < n; k++)
        if (p->bits[k] >= 0) most = fmax(most, p->bits[k] + k * far);
    return most;
}

/* log2 |z|, 0 for 0. */
static double log2_of(const algsurf_i_point *z) {
    const algsurf_scaled size = size_of(z->head);
    return is_zero(size) ? 0 : algsurf_i_log2(size.re) + (double)size.exponent;
}

/* What is cut of the sum after c_k is below 2^F |z|^-k; its last bit is 2^(n-k) e or more for points with a
 * last bit of 2^e, e < 0, or 1: that is not less for F <= n e, or 0, as |z| >= 2^e. */
int algsurf_i_whole_width(const algsurf_i_integers *p, const algsurf_i_point *z) {
    const int n = p->re.degree;
    const double last = z->exponent < 0 ? n * (double)z->exponent : 0;
    return (int)((largest_term(p, n, log2_of(z)) + SPARE - last) / 64) + 1;
}

int algsurf_i_taylor(algsurf_i_sums *s, const algsurf_i_integers *p, const algsurf_i_point *z, int last,
                     int w) {
    const int most = w + 1, wide = most + z->w, real = !p->im.c && algsurf_z_sign(z->y, z->w) == 0;
    if (!make_room(s, last, 2 * ((size_t)(last + 1) * (size_t)most + (size_t)wide + (size_t)z->w))) return 0;
    algsurf_limb *room = s->room;
    multiplier by = {.exponent = z->exponent, .w = z->w, .most = most, .real = real};
    by.x = algsurf_z_factor_of(z->x, z->w, room), room += z->w;
    by.y = algsurf_z_factor_of(z->y, z->w, room), room += z->w;
    by.re = room, by.im = room + wide, room += 2 * wide;
    algsurf_z_zero(room, 2 * most * (last + 1));
    for (int j = 0; j <= last; j++, room += 2 * most) s->at[j] = (algsurf_i_sum){room, room + most, 1, -1, 0};
    const double far = log2_of(z);
    const int n = is_zero(z->head) && last < p->re.degree ? last : p->re.degree; /* at 0 no others count */
    const double F = largest_term(p, n, far) - 64.0 * w + SPARE;
    int cuts = 0;
    for (int k = n; k >= 0; k--) {
        const algsurf_i_sum c = {.re = algsurf_zpoly_at(&p->re, k),
                                 .im = p->im.c ? algsurf_zpoly_at(&p->im, k) : NULL,
                                 .w = p->re.width,
                                 .bits = p->bits[k]};
        for (int j = last; j > 0; j--) step(s->at + j, &by, s->at + j - 1, (int64_t)(F - (j + k) * far));
        cuts += step(s->at, &by, &c, (int64_t)(F - k * far));
    }
    s->lost = scaled_of(9.0 * cuts, 0, (int64_t)ceil(F));
    return 1;
}
