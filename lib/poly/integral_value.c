/* integral_value.c - the sign of a polynomial at x = N 2^-r, and its value as a double.
 *
 * First with three limbs and a bound of the error, which decides nearly always, also a few units in the last
 * place from a root: 0.1 us at degree 6, and hardly more for longer coefficients.  Else exactly:
 * 2^(r n) p(x) = sum c_k N^k 2^(r (n-k)) by Horner, a = a N + c_k 2^(r (n-k)).  Such an a begins as short as
 * c_n and gains r bits a step. */
#include "../base/arithmetic.h"
#include "integral_impl.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

/* ---- with three limbs ----
 *
 * x = +-y 2^X, y = m / 2^64 in [1/2, 1).  Horner's sum is h 2^up: in each step up is chosen so that neither
 * floor(h y) nor D_k = floor(c_k 2^(X k - up)) has more than 189 bits, and the larger one not many fewer. The
 * error, in units of 2^up, is multiplied by y < 1 and gains less than 1 for each floor, of which there is a
 * third one where h is shifted down.  It is kept as a double; its own roundings, below 4 (n+1) 2^-53 of it,
 * are taken in by a factor 1 + 2^-40. */

#define SHORT_LIMBS 3
enum { MOST_SHORT_BITS = 189, FEW_SHORT_BITS = 150 };

typedef struct short_point {
    algsurf_limb m; /* y 2^64 */
    int X, negative;
} short_point;

/* 0: N is 0 or has more than 63 significant bits. */
static int short_point_of(const algsurf_limb *N, int w, int r, short_point *x) {
    int zeros = algsurf_z_trailing(N, w);
    x->negative = algsurf_z_negative(N, w);
    if (zeros == ALGSURF_Z_NO_BIT || algsurf_z_bits(N, w) - zeros > 63) return 0;
    algsurf_limb odd = algsurf_z_window(N, w, zeros);
    if (x->negative) odd = 0 - odd;
    int bits = algsurf_limb_bits(odd);
    x->m = odd << (LIMB_BITS - bits);
    x->X = bits + zeros - r;
    return 1;
}

/* D = floor(c / 2^from), from of any sign, modulo 2^192. */
static void short_window(algsurf_limb D[SHORT_LIMBS], const algsurf_limb *c, int w, int from) {
    int i = from >= 0 ? from / LIMB_BITS : -((LIMB_BITS - 1 - from) / LIMB_BITS), rest = from - LIMB_BITS * i;
    algsurf_limb v[SHORT_LIMBS + 1], sign = 0 - (c[w - 1] >> 63);
    if (i >= 0 && i + SHORT_LIMBS < w)
        memcpy(v, c + i, sizeof v);
    else
        for (int j = 0; j <= SHORT_LIMBS; j++) v[j] = i + j < 0 ? 0 : i + j < w ? c[i + j] : sign;
    for (int j = 0; j < SHORT_LIMBS; j++) D[j] = v[j] >> rest | v[j + 1] << 1 << (LIMB_BITS - 1 - rest);
}

/* h = floor(h m / 2^64) */
static void short_multiply(algsurf_limb h[SHORT_LIMBS], algsurf_limb m) {
    algsurf_limb c0, c1, c2, minus = algsurf_z_negative(h, SHORT_LIMBS) ? m : 0;
    (void)algsurf_limb_product(h[0], m, 0, 0, &c0);
    h[0] = algsurf_limb_product(h[1], m, c0, 0, &c1);
    h[1] = algsurf_limb_product(h[2], m, c1, 0, &c2);
    h[2] = c2 - minus;
}

/* h gains `by` bits, 2^up as many fewer. */
static void short_scale(algsurf_limb h[SHORT_LIMBS], int by, int *up, double *error) {
    if (by < 0)
        algsurf_z_shift_down(h, SHORT_LIMBS, -by);
    else
        algsurf_z_shift_up(h, SHORT_LIMBS, by);
    *error = ldexp(*error, by) + (by < 0);
    *up -= by;
}

/* 1: sign (and value) found.  The sign needs |h| above the error, the value 2^54 times that: this leaves room
 * for its rounding to double, 2^-53 + 2^-62. */
static int short_value(const algsurf_zpoly *p, const algsurf_limb *N, int w, int r, int *sign, double *value,
                       int *exponent) {
    short_point x;
    int n = p->degree;
    if (n < 0 || !short_point_of(N, w, r, &x)) return 0;
    int up = algsurf_z_bits(algsurf_zpoly_at(p, n), p->width) + x.X * n - MOST_SHORT_BITS;
    algsurf_limb h[SHORT_LIMBS] = {0}, D[SHORT_LIMBS];
    double error = 0, y = 0x1p-64 * (double)x.m;
    for (int k = n; k >= 0; k--) {
        const algsurf_limb *c = algsurf_zpoly_at(p, k);
        int bits = algsurf_z_bits(c, p->width);
        short_multiply(h, x.m);
        error = error * y + 1;
        int most = larger(algsurf_z_bits(h, SHORT_LIMBS), bits || c[0] ? bits + x.X * k - up : 0);
        if (most > MOST_SHORT_BITS || (most < FEW_SHORT_BITS && error < 0x1p60))
            short_scale(h, MOST_SHORT_BITS - most, &up, &error);
        short_window(D, c, p->width, up - x.X * k);
        if (x.negative && k % 2)
            algsurf_z_sub(h, D, SHORT_LIMBS);
        else
            algsurf_z_add(h, D, SHORT_LIMBS);
        error += 1;
    }
    if (error > 0x1p60) return 0;
    int least = algsurf_limb_bits((algsurf_limb)(error * (1 + 0x1p-40)) + 1); /* the error is below 2^least */
    if (algsurf_z_bits(h, SHORT_LIMBS) < least + (value ? 55 : 1)) return 0;
    *sign = algsurf_z_sign(h, SHORT_LIMBS);
    if (value) {
        *value = algsurf_z_to_double(h, SHORT_LIMBS, exponent);
        *exponent += up;
    }
    return 1;
}

/* ---- with all limbs ---- */

/* Horner's sum: an integer of w limbs, and room for it to grow and to be multiplied. */
typedef struct sum {
    algsurf_limb *a, *other;
    int w;
} sum;

/* a = a f, a of the given width afterwards. */
static void sum_multiply(sum *s, const algsurf_z_factor *f, int w) {
    algsurf_limb *a = s->a;
    algsurf_z_zero(s->other, w);
    algsurf_z_add_times(s->other, w, a, smaller(s->w, w), f, 0);
    *s = (sum){s->other, a, w};
}

/* a += c 2^shift. */
static void sum_add(sum *s, const algsurf_limb *c, int w, int shift) {
    algsurf_z_add_product(s->a, s->w, c, w, (algsurf_limb)1 << shift % LIMB_BITS, shift / LIMB_BITS);
}

/* x = N 2^-r with N odd or r = 0, N as a factor; 0: no memory. */
static int point(algsurf_memory *m, const algsurf_limb *N, int w, int *r, algsurf_z_factor *x) {
    int zeros = algsurf_z_trailing(N, w), up = *r < 0 ? -*r : 0, width = w + up / LIMB_BITS + 1;
    algsurf_limb *room = take(m, 2 * width);
    if (!room) return 0;
    algsurf_z_copy(room, width, N, w);
    algsurf_z_shift_up(room, width, up);
    if (*r > 0) {
        int down = smaller(*r, zeros);
        algsurf_z_shift_down(room, width, down);
        *r -= down;
    } else
        *r = 0;
    *x = algsurf_z_factor_of(room, width, room + width);
    return 1;
}

static void horner(const algsurf_zpoly *p, const algsurf_z_factor *x, int r, sum *s) {
    int n = p->degree, pb = algsurf_zpoly_bits(p);
    s->w = algsurf_z_width(pb);
    algsurf_z_copy(s->a, s->w, algsurf_zpoly_at(p, n), p->width);
    for (int k = n - 1; k >= 0; k--) {
        int bits = larger(algsurf_z_bits(s->a, s->w) + x->bits, pb + r * (n - k)) + 1;
        sum_multiply(s, x, algsurf_z_width(bits));
        sum_add(s, algsurf_zpoly_at(p, k), p->width, r * (n - k));
    }
}

/* All of it; |sum| < 2^(bits of p + n (bits of N or r, and 1 for the sum)). */
static int exact_value(algsurf_memory *m, const algsurf_zpoly *p, const algsurf_limb *N, int w, int r, sum *s,
                       int *scale) {
    algsurf_z_factor x;
    if (!point(m, N, w, &r, &x)) return 0;
    int n = larger(p->degree, 0);
    int width = algsurf_z_width(algsurf_zpoly_bits(p) + n * (larger(x.bits, r) + 1)) + 1;
    *s = (sum){take(m, width), take(m, width), 1};
    if (!s->a || !s->other) return 0;
    if (p->degree < 0)
        s->a[0] = 0;
    else
        horner(p, &x, r, s);
    *scale = r * n;
    return 1;
}

int algsurf_zpoly_sign_at(algsurf_memory *m, const algsurf_zpoly *p, const algsurf_limb *N, int w, int r,
                          int *sign, double *value, int *exponent) {
    if (short_value(p, N, w, r, sign, value, exponent)) return 1;
    algsurf_memory_mark mark = algsurf_memory_here(m);
    sum s;
    int scale, done = exact_value(m, p, N, w, r, &s, &scale);
    if (done) *sign = algsurf_z_sign(s.a, s.w);
    if (done && value) {
        *value = algsurf_z_to_double(s.a, s.w, exponent);
        if (*sign) *exponent -= scale;
    }
    algsurf_memory_release(m, mark);
    return done;
}
