/* integer.c - what of integer.h is not inline: copies, shifts, products, doubles, division.
 *
 * Two's complement needs no cases for signs: a limb beyond the last one is 0 or 2^64 - 1, the sign extended.
 * Division is Knuth's algorithm D (The Art of Computer Programming 2, 4.3.1) with
 * the trial quotients of Moller and Granlund (wide.h) in place of a division each. */
#include "arithmetic.h"
#include "integer.h"

#include <float.h>
#include <math.h>

#define LIMB_BITS 64

static algsurf_limb sign_limb(const algsurf_limb *a, int w) { return 0 - (a[w - 1] >> 63); }

void algsurf_z_copy(algsurf_limb *r, int w, const algsurf_limb *a, int wa) {
    algsurf_limb sign = sign_limb(a, wa);
    int common = w < wa ? w : wa;
    if (r != a) memmove(r, a, (size_t)common * sizeof *r);
    for (int i = wa; i < w; i++) r[i] = sign;
}

void algsurf_z_set(algsurf_limb *r, int w, int64_t a) {
    algsurf_limb limb = (algsurf_limb)a;
    algsurf_z_copy(r, w, &limb, 1);
}

int algsurf_z_trailing(const algsurf_limb *a, int w) {
    for (int i = 0; i < w; i++)
        if (a[i]) return LIMB_BITS * i + algsurf_limb_trailing(a[i]);
    return ALGSURF_Z_NO_BIT;
}

void algsurf_z_negate(algsurf_limb *a, int w) {
    int i = 0;
    while (i < w && a[i] == 0) i++; /* -a = ~a + 1: the 1 is carried through the zeros */
    if (i < w) a[i] = 0 - a[i];
    for (i++; i < w; i++) a[i] = ~a[i];
}

void algsurf_z_shift_up(algsurf_limb *a, int w, int bits) {
    int limbs = bits / LIMB_BITS, rest = bits % LIMB_BITS;
    if (limbs >= w) {
        algsurf_z_zero(a, w);
        return;
    }
    if (rest == 0 && limbs) memmove(a + limbs, a, (size_t)(w - limbs) * sizeof *a);
    if (rest) {
        for (int i = w - 1; i > limbs; i--)
            a[i] = a[i - limbs] << rest | a[i - limbs - 1] >> (LIMB_BITS - rest);
        a[limbs] = a[0] << rest;
    }
    algsurf_z_zero(a, limbs);
}

void algsurf_z_shift_down(algsurf_limb *a, int w, int bits) {
    int limbs = bits / LIMB_BITS, rest = bits % LIMB_BITS;
    algsurf_limb sign = sign_limb(a, w);
    if (limbs > w) limbs = w;
    if (rest == 0 && limbs) memmove(a, a + limbs, (size_t)(w - limbs) * sizeof *a);
    if (rest && limbs < w) {
        for (int i = limbs; i < w - 1; i++) a[i - limbs] = a[i] >> rest | a[i + 1] << (LIMB_BITS - rest);
        a[w - 1 - limbs] = a[w - 1] >> rest | sign << (LIMB_BITS - rest);
    }
    for (int i = w - limbs; i < w; i++) a[i] = sign;
}

algsurf_z_factor algsurf_z_factor_of(const algsurf_limb *a, int w, algsurf_limb *room) {
    algsurf_z_factor f = {algsurf_z_negative(a, w), 0, 0, room};
    memmove(room, a, (size_t)w * sizeof *a);
    if (f.negative) algsurf_z_negate(room, w);
    f.length = algsurf_z_length(room, w);
    if (f.length) f.bits = LIMB_BITS * (f.length - 1) + algsurf_limb_bits(room[f.length - 1]);
    return f;
}

void algsurf_z_add_times(algsurf_limb *r, int w, const algsurf_limb *a, int wa, const algsurf_z_factor *f,
                         int negate) {
    int minus = f->negative != (negate != 0);
    for (int i = 0; i < f->length && i < w; i++)
        if (f->limb[i]) algsurf_z_join_product(r, w, a, wa, f->limb[i], i, minus);
}

/* ---- doubles ---- */

void algsurf_z_add_double(algsurf_limb *r, int w, double x, int shift) {
    int e;
    algsurf_limb m = algsurf_z_odd_part(x, &e), sign = x < 0 ? ~(algsurf_limb)0 : 0;
    if (m == 0) return;
    e += shift;
    int at = e / LIMB_BITS, rest = e % LIMB_BITS;
    algsurf_limb part[2] = {m << rest, rest ? m >> (LIMB_BITS - rest) : 0};
    unsigned char carry = sign != 0; /* -x = ~x + 1 */
    for (int i = at; i < w; i++)
        r[i] = algsurf_limb_add(r[i], (i < at + 2 ? part[i - at] : 0) ^ sign, &carry);
}

/* The 63 leading bits are cut off with a relative error below 2^-62, their conversion rounds to nearest. */
double algsurf_z_to_double(const algsurf_limb *a, int w, int *e) {
    int bits = algsurf_z_bits(a, w);
    *e = 0;
    if (bits == 0 && a[0] == 0) return 0;
    *e = bits;
    algsurf_limb top = bits >= 63 ? algsurf_z_window(a, w, bits - 63) : a[0] << (63 - bits);
    return (double)(int64_t)top * 0x1p-63;
}

/* m 2^e, |m| <= 2^53, e >= -1074; the overflow on the side of `up`. */
static double scaled(int64_t m, int e, int up) {
    int bits = algsurf_limb_bits((algsurf_limb)(m < 0 ? -m : m));
    if (m == 0) return 0;
    if (bits + e > DBL_MAX_EXP) {
        if (m > 0) return up ? HUGE_VAL : DBL_MAX;
        return up ? -DBL_MAX : -HUGE_VAL;
    }
    return ldexp((double)m, e);
}

/* The last bit of a double: 53 bits below the first one, but not below 2^-1074. */
static double rounded(const algsurf_limb *a, int w, int e, int up) {
    int drop = algsurf_z_bits(a, w) - DBL_MANT_DIG, least = -1074 - e;
    if (drop < least) drop = least;
    if (drop <= 0) return scaled((int64_t)a[0], e, up);
    int64_t m = (int64_t)algsurf_z_window(a, w, drop);
    if (up && algsurf_z_trailing(a, w) < drop) m++;
    return scaled(m, e + drop, up);
}

double algsurf_z_round_down(const algsurf_limb *a, int w, int e) { return rounded(a, w, e, 0); }
double algsurf_z_round_up(const algsurf_limb *a, int w, int e) { return rounded(a, w, e, 1); }

/* ---- magnitudes ---- */

int algsurf_z_length(const algsurf_limb *a, int n) {
    while (n > 0 && a[n - 1] == 0) n--;
    return n;
}

int algsurf_z_compare_magnitudes(const algsurf_limb *a, int na, const algsurf_limb *b, int nb) {
    if (na != nb) return na < nb ? -1 : 1;
    for (int i = na - 1; i >= 0; i--)
        if (a[i] != b[i]) return a[i] < b[i] ? -1 : 1;
    return 0;
}

/* One limb of the quotient, and u (nv + 1 limbs) less its multiple of v.  The trial quotient of the leading
 * two limbs by one, corrected by the third, is right or 1 too large (Knuth, theorem B and exercise 19). */
static algsurf_limb divide_step(algsurf_limb *u, const algsurf_limb *v, int nv, algsurf_limb inverse) {
    algsurf_limb lead = v[nv - 1], q = ~(algsurf_limb)0, rest;
    int known = u[nv] < lead; /* else equal, and the quotient about 2^64 - 1 */
    if (known) q = algsurf_limb_divide(u[nv], u[nv - 1], lead, inverse, &rest);
    if (known && nv > 1) {
        algsurf_limb high, low = algsurf_limb_product(q, v[nv - 2], 0, 0, &high);
        while (high > rest || (high == rest && low > u[nv - 2])) {
            q--, rest += lead;
            if (rest < lead) break;
            high -= low < v[nv - 2], low -= v[nv - 2];
        }
    }
    algsurf_limb borrow = algsurf_z_sub_row(u, v, nv, q), top = u[nv];
    u[nv] = top - borrow;
    while (top < borrow) { /* too large: v is added back until the borrow is made good */
        unsigned char carry = 0;
        for (int i = 0; i < nv; i++) u[i] = algsurf_limb_add(u[i], v[i], &carry);
        q--, borrow -= carry;
        u[nv] = top - borrow;
    }
    return q;
}

void algsurf_z_divide(algsurf_limb *q, algsurf_limb *u, int nu, const algsurf_limb *v, int nv,
                      algsurf_limb *room) {
    int shift = algsurf_limb_leading(v[nv - 1]);
    memcpy(room, v, (size_t)nv * sizeof *v);
    algsurf_z_shift_up(room, nv, shift);
    algsurf_z_shift_up(u, nu + 1, shift);
    algsurf_limb inverse = algsurf_limb_inverse(room[nv - 1]);
    for (int j = nu - nv; j >= 0; j--) q[j] = divide_step(u + j, room, nv, inverse);
    if (shift == 0) return;
    for (int i = 0; i < nv; i++) u[i] = u[i] >> shift | u[i + 1] << (LIMB_BITS - shift);
}
