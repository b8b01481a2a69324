/* base/integer.h - signed integers of many 64-bit limbs.
 *
 * An integer is an array of w >= 1 limbs, least significant first, in two's complement: results are right
 * modulo 2^(64 w), so that intermediate signs need no attention, and the caller chooses w large enough for
 * the final ones.  A magnitude is an array of n >= 0 limbs without a sign, its last limb not 0. */
#ifndef ALGSURF_INTEGER_H
#define ALGSURF_INTEGER_H
#include <stdint.h>
#include <string.h>

#include "wide.h" /* algsurf_limb: uint64_t */

/* Limbs that hold every integer |a| < 2^bits, with its sign. */
static inline int algsurf_z_width(int bits) { return bits / 64 + 1; }

static inline void algsurf_z_zero(algsurf_limb *a, int w) { memset(a, 0, (size_t)w * sizeof *a); }
/* r = a, extended by its sign or cut; may overlap. */
void algsurf_z_copy(algsurf_limb *r, int w, const algsurf_limb *a, int wa);
void algsurf_z_set(algsurf_limb *r, int w, int64_t a);
/* 0, 1. */
static inline int algsurf_z_negative(const algsurf_limb *a, int w) { return (int)(a[w - 1] >> 63); }
/* -1, 0, 1; most integers show their sign in the last limb. */
static inline int algsurf_z_sign(const algsurf_limb *a, int w) {
    if (algsurf_z_negative(a, w)) return -1;
    for (int i = w - 1; i >= 0; i--)
        if (a[i]) return 1;
    return 0;
}
/* Bits of |a|, or of -1 - a when a is negative: a fits algsurf_z_width(bits) limbs.  0 for 0 and -1. */
static inline int algsurf_z_bits(const algsurf_limb *a, int w) {
    algsurf_limb sign = 0 - (a[w - 1] >> 63);
    for (int i = w - 1; i >= 0; i--)
        if (a[i] != sign) return 64 * i + algsurf_limb_bits(a[i] ^ sign);
    return 0;
}
/* floor(a / 2^from) modulo 2^64, from >= 0. */
static inline algsurf_limb algsurf_z_window(const algsurf_limb *a, int w, int from) {
    int i = from / 64, rest = from % 64;
    algsurf_limb sign = 0 - (a[w - 1] >> 63), low = i < w ? a[i] : sign, high = i + 1 < w ? a[i + 1] : sign;
    return rest ? low >> rest | high << (64 - rest) : low;
}
/* The exponent of the largest power of two that divides a; ALGSURF_Z_NO_BIT for 0. */
int algsurf_z_trailing(const algsurf_limb *a, int w);
#define ALGSURF_Z_NO_BIT (1 << 30)

/* r += a or, for `minus`, r -= a.  Four limbs at a time: a loop costs the flag that holds the carry. */
static inline __attribute__((always_inline)) void algsurf_z_join(algsurf_limb *r, const algsurf_limb *a,
                                                                 int w, int minus) {
    unsigned char carry = 0;
    int i = 0;
    for (; i + 4 <= w; i += 4) {
        carry = algsurf_limb_join(r + i, a[i], carry, minus);
        carry = algsurf_limb_join(r + i + 1, a[i + 1], carry, minus);
        carry = algsurf_limb_join(r + i + 2, a[i + 2], carry, minus);
        carry = algsurf_limb_join(r + i + 3, a[i + 3], carry, minus);
    }
    for (; i < w; i++) carry = algsurf_limb_join(r + i, a[i], carry, minus);
}
static inline void algsurf_z_add(algsurf_limb *r, const algsurf_limb *a, int w) {
    algsurf_z_join(r, a, w, 0);
}
static inline void algsurf_z_sub(algsurf_limb *r, const algsurf_limb *a, int w) {
    algsurf_z_join(r, a, w, 1);
}
void algsurf_z_negate(algsurf_limb *a, int w);
void algsurf_z_shift_up(algsurf_limb *a, int w, int bits);   /* a 2^bits, bits >= 0, any number */
void algsurf_z_shift_down(algsurf_limb *a, int w, int bits); /* floor(a / 2^bits) */

/* p = a f + carry for four limbs; the fifth is returned.  The four products do not wait for each other, and
 * one chain of carries joins them. */
static inline algsurf_limb algsurf_z_four_products(algsurf_limb p[4], const algsurf_limb *a, algsurf_limb f,
                                                   algsurf_limb carry) {
    algsurf_limb h0, h1, h2, h3;
    unsigned char c = 0;
    p[0] = algsurf_limb_product(a[0], f, 0, 0, &h0);
    p[1] = algsurf_limb_product(a[1], f, 0, 0, &h1);
    p[2] = algsurf_limb_product(a[2], f, 0, 0, &h2);
    p[3] = algsurf_limb_product(a[3], f, 0, 0, &h3);
    p[0] = algsurf_limb_add(p[0], carry, &c);
    p[1] = algsurf_limb_add(p[1], h0, &c);
    p[2] = algsurf_limb_add(p[2], h1, &c);
    p[3] = algsurf_limb_add(p[3], h2, &c);
    return h3 + c;
}
/* r += (or -=) a f for n limbs, without a sign; the limb that is carried (or borrowed) is returned. */
static inline __attribute__((always_inline)) algsurf_limb
algsurf_z_join_row(algsurf_limb *r, const algsurf_limb *a, int n, algsurf_limb f, int minus) {
    algsurf_limb carry = 0, p[4];
    int i = 0;
    for (; i + 4 <= n; i += 4) {
        carry = algsurf_z_four_products(p, a + i, f, carry);
        unsigned char c = algsurf_limb_join(r + i, p[0], 0, minus);
        c = algsurf_limb_join(r + i + 1, p[1], c, minus);
        c = algsurf_limb_join(r + i + 2, p[2], c, minus);
        c = algsurf_limb_join(r + i + 3, p[3], c, minus);
        carry += c;
    }
    for (; i < n; i++) {
        algsurf_limb product = algsurf_limb_product(a[i], f, minus ? 0 : r[i], carry, &carry), old = r[i];
        r[i] = minus ? old - product : product;
        if (minus) carry += old < product; /* a f + carry < 2^128 - 2^64: no overflow */
    }
    return carry;
}
static inline algsurf_limb algsurf_z_add_row(algsurf_limb *r, const algsurf_limb *a, int n, algsurf_limb f) {
    return algsurf_z_join_row(r, a, n, f, 0);
}
static inline algsurf_limb algsurf_z_sub_row(algsurf_limb *r, const algsurf_limb *a, int n, algsurf_limb f) {
    return algsurf_z_join_row(r, a, n, f, 1);
}
/* r += plus - minus. */
static inline void algsurf_z_add_limbs(algsurf_limb *r, int w, algsurf_limb plus, algsurf_limb minus) {
    if (w <= 0) return;
    algsurf_limb difference = plus - minus;
    r[0] += difference;
    int carry = (r[0] < difference) - (plus < minus); /* of r[0] + difference, which may be negative */
    if (carry > 0)
        for (int i = 1; i < w && ++r[i] == 0; i++) {
        }
    if (carry < 0)
        for (int i = 1; i < w && r[i]-- == 0; i++) {
        }
}
/* r += (or -=) a f 2^(64 at), at >= 0.  A negative a is its limbs without a sign less 2^(64 wa). */
static inline void algsurf_z_join_product(algsurf_limb *r, int w, const algsurf_limb *a, int wa,
                                          algsurf_limb f, int at, int minus) {
    int n = wa < w - at ? wa : w - at;
    if (n <= 0) return;
    algsurf_limb carry = minus ? algsurf_z_sub_row(r + at, a, n, f) : algsurf_z_add_row(r + at, a, n, f);
    algsurf_limb sign = algsurf_z_negative(a, wa) ? f : 0;
    algsurf_z_add_limbs(r + at + n, w - at - n, minus ? sign : carry, minus ? carry : sign);
}
static inline void algsurf_z_add_product(algsurf_limb *r, int w, const algsurf_limb *a, int wa,
                                         algsurf_limb f, int at) {
    algsurf_z_join_product(r, w, a, wa, f, at, 0);
}
/* a *= f for n limbs, without a sign (modulo 2^(64 n) with one); the limb that is carried is returned. */
static inline algsurf_limb algsurf_z_multiply(algsurf_limb *a, int n, algsurf_limb f) {
    algsurf_limb carry = 0;
    int i = 0;
    for (; i + 4 <= n; i += 4) carry = algsurf_z_four_products(a + i, a + i, f, carry);
    for (; i < n; i++) a[i] = algsurf_limb_product(a[i], f, carry, 0, &carry);
    return carry;
}

/* A magnitude a of n limbs, and room for one more: a = a f + digit; its new length is returned. */
static inline int algsurf_z_extend(algsurf_limb *a, int n, algsurf_limb f, algsurf_limb digit) {
    for (int i = 0; i < n; i++) a[i] = algsurf_limb_product(a[i], f, digit, 0, &digit);
    a[n] = digit;
    return n + (digit != 0);
}

/* A number as sign and magnitude, to multiply by. */
typedef struct algsurf_z_factor {
    int negative, length, bits; /* length 0: zero; the magnitude is below 2^bits and at least 2^(bits-1) */
    const algsurf_limb *limb;
} algsurf_z_factor;
/* The magnitude of a into room for w limbs, and the factor that refers to it. */
algsurf_z_factor algsurf_z_factor_of(const algsurf_limb *a, int w, algsurf_limb *room);
/* r += a f, or r -= a f if `negate`; r and a do not overlap. */
void algsurf_z_add_times(algsurf_limb *r, int w, const algsurf_limb *a, int wa, const algsurf_z_factor *f,
                         int negate);

/* |x| = m 2^e with m odd, for a finite x; m = 0 and e = 0 for 0. */
static inline algsurf_limb algsurf_z_odd_part(double x, int *e) {
    uint64_t image;
    memcpy(&image, &x, sizeof image);
    int exponent = (int)(image >> 52 & 0x7ff);
    algsurf_limb m = (image & (((algsurf_limb)1 << 52) - 1)) | (algsurf_limb)(exponent > 0) << 52;
    *e = 0;
    if (m == 0) return 0;
    int zeros = algsurf_limb_trailing(m);
    *e = exponent + !exponent - 1075 + zeros;
    return m >> zeros;
}
/* r += x 2^shift, which is an integer. */
void algsurf_z_add_double(algsurf_limb *r, int w, double x, int shift);
/* a = d 2^e up to a relative error of 2^-52, 1/2 <= |d| <= 1; d = 0 and e = 0 for 0. */
double algsurf_z_to_double(const algsurf_limb *a, int w, int *e);
/* The largest double <= a 2^e, and the least >= it; beyond the largest double +-DBL_MAX or +-infinity,
 * whichever keeps the order.  Rounding is done in integers; no rounding mode plays a part. */
double algsurf_z_round_down(const algsurf_limb *a, int w, int e);
double algsurf_z_round_up(const algsurf_limb *a, int w, int e);

/* Magnitudes. */
int algsurf_z_length(const algsurf_limb *a, int n); /* without leading zeros */
int algsurf_z_compare_magnitudes(const algsurf_limb *a, int na, const algsurf_limb *b, int nb);
/* Knuth's algorithm D.  u has nu + 1 limbs, the last one 0, and becomes the remainder (nv limbs, zeros
 * above); q receives nu - nv + 1 limbs; nu >= nv >= 1, v[nv-1] not 0; room: nv + 1 limbs of work space. */
void algsurf_z_divide(algsurf_limb *q, algsurf_limb *u, int nu, const algsurf_limb *v, int nv,
                      algsurf_limb *room);
#endif
