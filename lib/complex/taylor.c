/* taylor.c - p(z) and its Taylor coefficients, by Horner's rule on integers that are cut to w limbs.
 *
 * The sum so far is (r + i s) 2^e.  A step multiplies by z, exactly, and adds a coefficient; where the result
 * has more than w limbs its exponent rises and what is below is cut: less than 1 from each of two terms in
 * each part, less than 3 units of 2^e together.  What was lost before is multiplied by |z|.  The bound is a
 * sum of products of sizes, each off by less than 8 u, n of them one after the other: 2^-40 in |z| covers
 * that. */
#include "../base/arithmetic.h"
#include "discs.h"

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

static int bits_of(const algsurf_limb *x, const algsurf_limb *y, int w) {
    int a = algsurf_z_bits(x, w), b = algsurf_z_bits(y, w);
    return a > b ? a : b;
}

algsurf_scaled algsurf_i_head(const algsurf_limb *x, const algsurf_limb *y, int w, int64_t exponent) {
    int bits = bits_of(x, y, w) + 1;
    return scaled_of((double)(int64_t)algsurf_i_limb_at(x, w, bits - 63),
                     (double)(int64_t)algsurf_i_limb_at(y, w, bits - 63), exponent + bits - 63);
}

/* Both parts have 53 bits, and the head's window of 63 begins below the last one. */
int algsurf_i_head_is_exact(const algsurf_limb *x, const algsurf_limb *y, int w) {
    const algsurf_limb *part[2] = {x, y};
    const int top = bits_of(x, y, w);
    for (int i = 0; i < 2; i++) {
        int last = algsurf_z_trailing(part[i], w);
        if (last == ALGSURF_Z_NO_BIT) continue;
        if (algsurf_z_bits(part[i], w) - last > 53 || top - last > 60) return 0;
    }
    return 1;
}

/* What a sum is multiplied by, and room for the product. */
typedef struct multiplier {
    algsurf_z_factor x, y;
    int64_t exponent;
    algsurf_scaled far; /* |z|, rounded up */
    algsurf_limb *re, *im;
    int wide;
} multiplier;

static int bits_or_none(const algsurf_limb *x, const algsurf_limb *y, int w) {
    if (algsurf_z_sign(x, w) == 0 && algsurf_z_sign(y, w) == 0) return -1;
    return bits_of(x, y, w);
}

/* The product of a sum that is not 0 with z; its bits. */
static int multiply(const algsurf_i_sum *a, const multiplier *z) {
    const int wide = z->wide;
    algsurf_z_zero(z->re, wide);
    algsurf_z_zero(z->im, wide);
    algsurf_z_add_times(z->re, wide, a->re, a->w, &z->x, 0);
    algsurf_z_add_times(z->im, wide, a->re, a->w, &z->y, 0);
    if (algsurf_z_sign(a->im, a->w) != 0) {
        algsurf_z_add_times(z->re, wide, a->im, a->w, &z->y, 1);
        algsurf_z_add_times(z->im, wide, a->im, a->w, &z->x, 0);
    }
    return bits_or_none(z->re, z->im, wide);
}

/* sum = sum z + t; t's im may be null: 0. */
static void step(algsurf_i_sum *a, const multiplier *z, const algsurf_i_sum *t) {
    int64_t top = INT64_MIN, low = INT64_MAX, exponent = a->exponent + z->exponent;
    const int bits = a->bits >= 0 ? multiply(a, z) : -1;
    if (bits >= 0) top = exponent + bits, low = exponent;
    if (t->bits >= 0) {
        top = top > t->exponent + t->bits ? top : t->exponent + t->bits;
        low = low < t->exponent ? low : t->exponent;
    }
    if (!is_zero(a->lost)) a->lost = times(a->lost, z->far);
    if (!is_zero(t->lost)) a->lost = sum(a->lost, t->lost);
    algsurf_z_zero(a->re, a->w);
    algsurf_z_zero(a->im, a->w);
    a->bits = -1;
    if (low == INT64_MAX) return;
    int64_t e = top + 2 - 64 * (int64_t)a->w;
    a->exponent = e = e < low ? low : e;
    if (bits >= 0) {
        algsurf_i_add_shifted(a->re, a->w, z->re, z->wide, exponent - e);
        algsurf_i_add_shifted(a->im, a->w, z->im, z->wide, exponent - e);
    }
    if (t->bits >= 0) {
        algsurf_i_add_shifted(a->re, a->w, t->re, t->w, t->exponent - e);
        if (t->im) algsurf_i_add_shifted(a->im, a->w, t->im, t->w, t->exponent - e);
    }
    a->bits = bits_or_none(a->re, a->im, a->w);
    if (e > low) a->lost = sum(a->lost, scaled_of(3, 0, e));
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

int algsurf_i_taylor(algsurf_i_sums *s, const algsurf_i_gaussian *p, const algsurf_i_point *z, int last,
                     int w) {
    const int wide = w + z->w;
    if (!make_room(s, last, 2 * ((size_t)(last + 1) * (size_t)w + (size_t)wide + (size_t)z->w))) return 0;
    algsurf_limb *room = s->room;
    multiplier by = {.exponent = z->exponent, .far = size_of(z->head), .wide = wide};
    by.x = algsurf_z_factor_of(z->x, z->w, room), room += z->w;
    by.y = algsurf_z_factor_of(z->y, z->w, room), room += z->w;
    by.re = room, by.im = room + wide, room += 2 * wide;
    by.far.re *= 1 + 0x1p-40;
    for (int j = 0; j <= last; j++, room += 2 * w)
        s->at[j] = (algsurf_i_sum){room, room + w, w, -1, 0, scaled_none()};
    for (int k = p->re.degree; k >= 0; k--) {
        for (int j = last; j > 0; j--) step(s->at + j, &by, s->at + j - 1);
        const algsurf_i_sum c = {.re = algsurf_zpoly_at(&p->re, k),
                                 .im = p->im.c ? algsurf_zpoly_at(&p->im, k) : NULL,
                                 .w = p->re.width,
                                 .bits = p->bits[k],
                                 .lost = scaled_none()};
        step(s->at, &by, &c);
    }
    return 1;
}
