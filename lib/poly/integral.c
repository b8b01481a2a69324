/* integral.c - polynomials with integer coefficients: values, Bernstein coefficients, division.
 *
 * Widths come first.  Two's complement is arithmetic modulo 2^(64 w): intermediate results may overflow, as
 * long as the final ones fit, so each function bounds its results, and chooses w from that.
 *
 * Value at x = N 2^-r: 2^(r n) p(x) = sum c_k N^k 2^(r (n-k)), by Horner a = a N + c_k 2^(r (n-k)).  Such an
 * a begins as short as c_n and gains r bits a step. */
#include "integral.h"

#include <limits.h>
#include <stddef.h>
#include <string.h>

#define LIMB_BITS 64

static int larger(int a, int b) { return a > b ? a : b; }
static int smaller(int a, int b) { return a < b ? a : b; }
static int bits_of_int(int a) { return algsurf_limb_bits((algsurf_limb)a); }

static algsurf_limb *take(algsurf_memory *m, int limbs) { return algsurf_memory_take(m, (size_t)limbs); }

static int new_unset(algsurf_memory *m, int degree, int width, algsurf_zpoly *p) {
    size_t words = (size_t)(degree + 1) * (size_t)width;
    *p = (algsurf_zpoly){degree, width, algsurf_memory_take(m, words)};
    return p->c != NULL;
}

int algsurf_zpoly_new(algsurf_memory *m, int degree, int width, algsurf_zpoly *p) {
    if (!new_unset(m, degree, width, p)) return 0;
    memset(p->c, 0, (size_t)(degree + 1) * (size_t)width * sizeof *p->c);
    return 1;
}

int algsurf_zpoly_copy(algsurf_memory *m, const algsurf_zpoly *a, int width, algsurf_zpoly *p) {
    algsurf_zpoly from = *a; /* p may be a */
    if (!new_unset(m, from.degree, width, p)) return 0;
    for (int k = 0; k <= from.degree; k++)
        algsurf_z_copy(algsurf_zpoly_at(p, k), width, algsurf_zpoly_at(&from, k), from.width);
    return 1;
}

/* One limb of all coefficients at a time, from above: mostly the last one decides. */
int algsurf_zpoly_bits(const algsurf_zpoly *p) {
    for (int i = p->width - 1; i >= 0; i--) {
        algsurf_limb any = 0;
        for (int k = 0; k <= p->degree; k++) {
            const algsurf_limb *a = algsurf_zpoly_at(p, k);
            any |= a[i] ^ (0 - (a[p->width - 1] >> 63));
        }
        if (any) return LIMB_BITS * i + algsurf_limb_bits(any);
    }
    return 0;
}

int algsurf_zpoly_trailing(const algsurf_zpoly *p) {
    for (int i = 0; i < p->width; i++) {
        algsurf_limb any = 0;
        for (int k = 0; k <= p->degree; k++) any |= algsurf_zpoly_at(p, k)[i];
        if (any) return LIMB_BITS * i + algsurf_limb_trailing(any);
    }
    return ALGSURF_Z_NO_BIT;
}

/* r = floor(a / 2^bits) in w limbs, w + bits / 64 <= wa; r does not begin after a. */
static void move_down(algsurf_limb *r, int w, const algsurf_limb *a, int wa, int bits) {
    int limbs = bits / LIMB_BITS, rest = bits % LIMB_BITS;
    algsurf_limb beyond = limbs + w < wa ? a[limbs + w] : 0 - (a[wa - 1] >> 63);
    a += limbs;
    if (rest == 0) {
        memmove(r, a, (size_t)w * sizeof *a);
        return;
    }
    for (int i = 0; i < w - 1; i++) r[i] = a[i] >> rest | a[i + 1] << (LIMB_BITS - rest);
    r[w - 1] = a[w - 1] >> rest | beyond << (LIMB_BITS - rest);
}

/* Without `zeros` trailing bits, and without limbs too many. */
static void tighten(algsurf_zpoly *p, int zeros) {
    int bits = algsurf_zpoly_bits(p) - zeros, from = p->width, w = smaller(algsurf_z_width(bits), from);
    if (w == from && zeros == 0) return;
    for (int k = 0; k <= p->degree; k++)
        move_down(p->c + (size_t)k * (size_t)w, w, algsurf_zpoly_at(p, k), from, zeros);
    p->width = w;
}

static int common_zeros(const algsurf_zpoly *p) {
    int zeros = algsurf_zpoly_trailing(p);
    return zeros == ALGSURF_Z_NO_BIT ? 0 : zeros;
}

void algsurf_zpoly_compact(algsurf_zpoly *p) {
    while (p->degree >= 0 && algsurf_z_sign(algsurf_zpoly_at(p, p->degree), p->width) == 0) p->degree--;
    tighten(p, common_zeros(p));
}

int algsurf_zpoly_derivative(algsurf_memory *m, const algsurf_zpoly *p, algsurf_zpoly *d) {
    algsurf_zpoly from = *p;
    int n = p->degree, w = algsurf_z_width(algsurf_zpoly_bits(p) + bits_of_int(larger(n, 0)));
    if (!new_unset(m, larger(n - 1, -1), w, d)) return 0;
    for (int k = 1; k <= n; k++) {
        algsurf_z_copy(algsurf_zpoly_at(d, k - 1), w, algsurf_zpoly_at(&from, k), from.width);
        algsurf_z_multiply(algsurf_zpoly_at(d, k - 1), w, (algsurf_limb)k);
    }
    return 1;
}

/* ---- values with three limbs ----
 *
 * x = +-y 2^X, y = m / 2^64 in [1/2, 1).  With |c_k| 2^(X k) <= 2^e for all k and n + 1 < 2^B, the integers
 * D_k = floor(c_k 2^(X k) 2^(190 - e - B)) have sum |D_k| < 2^190.  Horner's h = floor(h y) +- D_k is off by
 * less than 1 for each of the two floors, times y < 1 in the next step: after all of them by less than 2
 * (n+1) < 2^(B+1). */

#define SHORT_LIMBS 3
#define SHORT_BITS 190

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

/* e: |c_k| 2^(X k) <= 2^e. */
static int largest_term(const algsurf_zpoly *p, int X) {
    int e = INT_MIN;
    for (int k = 0; k <= p->degree; k++) {
        const algsurf_limb *c = algsurf_zpoly_at(p, k);
        int bits = algsurf_z_bits(c, p->width);
        if (bits || c[0]) e = larger(e, bits + X * k);
    }
    return e;
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

/* 1: sign (and value) found.  The sign needs |h| > 2^(B+1); the value 2^(B+55): then the error is 2^-54 of
 * it, which leaves room for its rounding to double, 2^-53 + 2^-62. */
static int short_value(const algsurf_zpoly *p, const algsurf_limb *N, int w, int r, int *sign, double *value,
                       int *exponent) {
    short_point x;
    int n = p->degree;
    if (n < 0 || !short_point_of(N, w, r, &x)) return 0;
    int largest = largest_term(p, x.X), B = bits_of_int(n + 1), up = largest + B - SHORT_BITS;
    if (largest == INT_MIN) return 0;
    algsurf_limb h[SHORT_LIMBS] = {0}, D[SHORT_LIMBS];
    for (int k = n; k >= 0; k--) {
        short_multiply(h, x.m);
        short_window(D, algsurf_zpoly_at(p, k), p->width, up - x.X * k);
        if (x.negative && k % 2)
            algsurf_z_sub(h, D, SHORT_LIMBS);
        else
            algsurf_z_add(h, D, SHORT_LIMBS);
    }
    if (algsurf_z_bits(h, SHORT_LIMBS) < B + (value ? 56 : 2)) return 0;
    *sign = algsurf_z_sign(h, SHORT_LIMBS);
    if (value) {
        *value = algsurf_z_to_double(h, SHORT_LIMBS, exponent);
        *exponent += up;
    }
    return 1;
}

/* ---- values ---- */

/* Horner's sum: an integer of w limbs, and room for it to grow and to be multiplied. */
typedef struct sum {
    algsurf_limb *a, *other;
    int w;
} sum;

/* a = a f, a of the given width afterwards. */
static void sum_multiply(sum *s, const algsurf_z_factor *f, int w) {
    if (f->length == 1) {
        algsurf_z_copy(s->a, w, s->a, smaller(s->w, w));
        algsurf_z_multiply(s->a, w, f->limb[0]);
        if (f->negative) algsurf_z_negate(s->a, w);
    } else {
        algsurf_z_zero(s->other, w);
        algsurf_z_add_times(s->other, w, s->a, smaller(s->w, w), f, 0);
        algsurf_limb *t = s->a;
        s->a = s->other, s->other = t;
    }
    s->w = w;
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

int algsurf_zpoly_sign_at(algsurf_memory *m, const algsurf_zpoly *p, const algsurf_limb *N, int w, int r,
                          int *sign, double *value, int *exponent) {
    if (short_value(p, N, w, r, sign, value, exponent)) return 1;
    algsurf_memory_mark mark = algsurf_memory_here(m);
    algsurf_z_factor x;
    int n = larger(p->degree, 0), done = point(m, N, w, &r, &x);
    if (done) { /* |sum| < 2^bits: each of the n steps adds a bit at most */
        int width = algsurf_z_width(algsurf_zpoly_bits(p) + n * (larger(x.bits, r) + 1)) + 1;
        sum s = {take(m, width), take(m, width), 1};
        done = s.a && s.other;
        if (done) {
            if (p->degree < 0)
                s.a[0] = 0;
            else
                horner(p, &x, r, &s);
            *sign = algsurf_z_sign(s.a, s.w);
            if (value) {
                *value = algsurf_z_to_double(s.a, s.w, exponent);
                if (*sign) *exponent -= r * n;
            }
        }
    }
    algsurf_memory_release(m, mark);
    return done;
}

/* ---- Bernstein coefficients ----
 *
 * p(m + 2^q s) = sum a_k s^k,  b_j = sum_k C(j,k)/C(n,k) a_k.  Taylor's shift by m, the powers of two, the
 * factors L/C(n,k) with L = lcm C(n,k) = lcm(1..n+1)/(n+1), and then sums in place of C(j,k). */

/* The least prime that divides i >= 2. */
static int least_prime(int i) {
    for (int d = 2; d * d <= i; d++)
        if (i % d == 0) return d;
    return i;
}

/* a = a / d for a magnitude of w limbs that d divides. */
static void divide_by_int(algsurf_limb *a, int w, int d) {
    int shift = algsurf_limb_leading((algsurf_limb)d);
    algsurf_limb lead = (algsurf_limb)d << shift, inverse = algsurf_limb_inverse(lead), rest = 0;
    for (int i = w - 1; i >= 0;
         i--) { /* (rest 2^64 + a_i) / d, both shifted; rest < lead is shifted already */
        algsurf_limb high = rest | (shift ? a[i] >> (LIMB_BITS - shift) : 0);
        a[i] = algsurf_limb_divide(high, a[i] << shift, lead, inverse, &rest);
    }
}

/* factor[k] = lcm C(n,k) / C(n,k), k <= n / 2, w limbs each. */
static void binomial_factors(algsurf_limb *factor, int n, int w) {
    algsurf_z_set(factor, w, 1);
    for (int i = 2; i <= n + 1; i++) { /* lcm(1..n+1): a prime for each of its powers */
        int p = least_prime(i), power = i;
        while (power % p == 0) power /= p;
        if (power == 1) algsurf_z_multiply(factor, w, (algsurf_limb)p);
    }
    divide_by_int(factor, w, n + 1);
    for (int k = 0; k < n / 2; k++) {
        algsurf_limb *next = factor + (size_t)(k + 1) * (size_t)w;
        algsurf_z_copy(next, w, factor + (size_t)k * (size_t)w, w);
        algsurf_z_multiply(next, w, (algsurf_limb)(k + 1));
        divide_by_int(next, w, n - k);
    }
}

/* An upper bound of 8 log2 M, M = a + b >= 1. */
static int eighths(algsurf_limb a, algsurf_limb b) {
    unsigned char carry = 0;
    algsurf_limb M = algsurf_limb_add(a, b, &carry);
    if (carry) return 8 * 65;
    int drop = larger(algsurf_limb_bits(M) - 7, 0);
    algsurf_limb t = ((M - 1) >> drop) + 1, power = t * t; /* M <= t 2^drop, t <= 2^7 */
    power *= power, power *= power;
    return algsurf_limb_bits(power - 1) + 8 * drop;
}

/* Bounds: sum |c_k| M^k < 2^bits.  With M = |m| + 1 it bounds each |a_k|, a sum of c_j C(j,k) m^(j-k); with
 * M = |m| + 2^q each |b_j|, since C(j,k) <= C(n,k). */
static int value_bits(const algsurf_zpoly *p, int eighths_of_M) {
    int bits = 0;
    for (int k = 0; k <= p->degree; k++)
        bits = larger(bits, algsurf_z_bits(algsurf_zpoly_at(p, k), p->width) + (k * eighths_of_M + 7) / 8);
    return bits + bits_of_int(p->degree + 1);
}

/* p(x + at) in w limbs.  In this order (the transpose of the sums of algsurf_zpoly_bernstein) a pass reads
 * what the passes before wrote, and its steps do not wait for each other. */
static void taylor_shift(const algsurf_zpoly *b, int w, int64_t at) {
    algsurf_limb size = at < 0 ? 0 - (algsurf_limb)at : (algsurf_limb)at;
    for (int i = b->degree - 1; i >= 0 && at; i--)
        for (int k = i; k < b->degree; k++) {
            algsurf_limb *r = algsurf_zpoly_at(b, k), *a = algsurf_zpoly_at(b, k + 1);
            if (at == 1)
                algsurf_z_add(r, a, w);
            else if (at == -1)
                algsurf_z_sub(r, a, w);
            else if (at > 0)
                (void)algsurf_z_add_row(r, a, w, size);
            else
                (void)algsurf_z_sub_row(r, a, w, size);
        }
}

/* lcm C(n,k), k = 0 .. n, as far as it is below 2^53. */
#define MOST_SHORT 41
static const algsurf_limb lcm_of_binomials[MOST_SHORT + 1] = {1,
                                                              1,
                                                              2,
                                                              3,
                                                              12,
                                                              10,
                                                              60,
                                                              105,
                                                              280,
                                                              252,
                                                              2520,
                                                              2310,
                                                              27720,
                                                              25740,
                                                              24024,
                                                              45045,
                                                              720720,
                                                              680680,
                                                              12252240,
                                                              11639628,
                                                              11085360,
                                                              10581480,
                                                              232792560,
                                                              223092870,
                                                              1070845776,
                                                              1029659400,
                                                              2974571600,
                                                              2868336900,
                                                              80313433200,
                                                              77636318760,
                                                              2329089562800,
                                                              4512611027925,
                                                              4375865239200,
                                                              4247163320400,
                                                              4125815796960,
                                                              4011209802600,
                                                              144403552893600,
                                                              140603459396400,
                                                              136998242488800,
                                                              133573286426580,
                                                              5342931457063200,
                                                              5215718803323600};

/* bits(lcm C(n,k)): lcm(1..n) < 3^n (Hanson 1972), log2(3) < 8/5. */
static int lcm_bits(int n) {
    return n <= MOST_SHORT ? algsurf_limb_bits(lcm_of_binomials[n]) : 8 * (n + 1) / 5 + 1;
}

/* Coefficient k times 2^(k q) (or 2^((k-n) q) for q < 0) and lcm C(n,k) / C(n,k); `used` limbs are valid
 * before. Here for factors of one limb; the binomials and quotients are exact in double, which divides
 * faster. */
static void scale_short(const algsurf_zpoly *b, int used, int q) {
    int n = b->degree;
    double lcm = (double)lcm_of_binomials[n], binomial = 1;
    for (int k = 0; k <= n; k++) {
        algsurf_limb *a = algsurf_zpoly_at(b, k), f = (algsurf_limb)(lcm / binomial);
        int shift = q >= 0 ? k * q : (k - n) * q, rest = shift % LIMB_BITS;
        algsurf_z_copy(a, b->width, a, used);
        int joined = algsurf_limb_bits(f) + rest <= LIMB_BITS;
        (void)algsurf_z_multiply(a, b->width, joined ? f << rest : f);
        algsurf_z_shift_up(a, b->width, joined ? shift - rest : shift);
        binomial = binomial * (n - k) / (k + 1);
    }
}

static int scale_long(algsurf_memory *m, const algsurf_zpoly *b, int used, int q) {
    int n = b->degree, w = b->width, wf = algsurf_z_width(lcm_bits(n) + bits_of_int(n + 1));
    algsurf_memory_mark mark = algsurf_memory_here(m);
    algsurf_limb *factor = take(m, (n / 2 + 1) * wf), *copy = take(m, w);
    if (factor && copy) {
        binomial_factors(factor, n, wf);
        for (int k = 0; k <= n; k++) {
            algsurf_limb *a = algsurf_zpoly_at(b, k);
            algsurf_z_factor f = {0, wf, 0, factor + (size_t)smaller(k, n - k) * (size_t)wf};
            algsurf_z_copy(copy, w, a, used);
            algsurf_z_zero(a, w);
            algsurf_z_add_times(a, w, copy, w, &f, 0);
            algsurf_z_shift_up(a, w, q >= 0 ? k * q : (k - n) * q);
        }
    }
    algsurf_memory_release(m, mark);
    return factor && copy;
}

int algsurf_zpoly_bernstein(algsurf_memory *m, const algsurf_zpoly *p, int64_t at, int length_bits,
                            algsurf_zpoly *b) {
    int n = p->degree, q = length_bits;
    if (n < 0) return algsurf_zpoly_new(m, -1, 1, b);
    algsurf_limb size = at < 0 ? 0 - (algsurf_limb)at : (algsurf_limb)at;
    int reach =
        q > 63 ? larger(8 * q, eighths(size, 1)) + 8 : eighths(size, q > 0 ? (algsurf_limb)1 << q : 1);
    int w = algsurf_z_width(value_bits(p, reach) + lcm_bits(n) + (q < 0 ? -q * n : 0));
    int used = smaller(w, algsurf_z_width(value_bits(p, eighths(size, 1))));
    if (!algsurf_zpoly_copy(m, p, w, b)) return 0;
    taylor_shift(b, used, at);
    if (n <= MOST_SHORT)
        scale_short(b, used, q);
    else if (!scale_long(m, b, used, q))
        return 0;
    for (int i = 0; i < n; i++)
        for (int j = n; j > i; j--) algsurf_z_add(algsurf_zpoly_at(b, j), algsurf_zpoly_at(b, j - 1), w);
    tighten(b, common_zeros(b)); /* and keep leading zeros: roots at the right end */
    return 1;
}

/* ---- division ---- */

/* Work space of a division: integers as magnitudes. */
typedef struct divider {
    algsurf_limb *u, *q, *room;
    int w;
} divider;

static int divider_new(algsurf_memory *m, int w, divider *d) {
    *d = (divider){take(m, w + 1), take(m, w + 1), take(m, w + 1), w};
    return d->u && d->q && d->room;
}

/* a / f (w limbs, overwritten by the quotient), f not 0: 1 if the remainder is 0. */
static int exact_quotient(divider *d, algsurf_limb *a, int w, const algsurf_z_factor *f) {
    int negative = algsurf_z_negative(a, w);
    algsurf_z_copy(d->u, w, a, w);
    if (negative) algsurf_z_negate(d->u, w);
    int length = algsurf_z_length(d->u, w);
    algsurf_z_zero(a, w);
    if (length < f->length) return length == 0;
    d->u[length] = 0;
    algsurf_z_divide(d->q, d->u, length, f->limb, f->length, d->room);
    memcpy(a, d->q, (size_t)(length - f->length + 1) * sizeof *a);
    if (negative != f->negative) algsurf_z_negate(a, w);
    return algsurf_z_length(d->u, f->length) == 0;
}

/* The coefficients of b as factors; null without memory. */
static algsurf_z_factor *factors_of(algsurf_memory *m, const algsurf_zpoly *b) {
    size_t size = ((size_t)(b->degree + 1) * sizeof(algsurf_z_factor) + 7) / 8;
    algsurf_z_factor *f = (algsurf_z_factor *)(void *)algsurf_memory_take(m, size);
    algsurf_limb *room = algsurf_memory_take(m, (size_t)(b->degree + 1) * (size_t)b->width);
    if (!f || !room) return NULL;
    for (int k = 0; k <= b->degree; k++)
        f[k] = algsurf_z_factor_of(algsurf_zpoly_at(b, k), b->width, room + (size_t)k * (size_t)b->width);
    return f;
}

/* r = coefficient k + deg b of a, less that of the quotient's part above k times b. */
static void what_remains(algsurf_limb *r, int w, const algsurf_zpoly *a, const algsurf_z_factor *b, int d,
                         int k, const algsurf_zpoly *q) {
    algsurf_z_copy(r, w, algsurf_zpoly_at(a, k + d), a->width);
    for (int j = larger(k + 1, 0); j <= q->degree && j <= k + d; j++)
        algsurf_z_add_times(r, w, algsurf_zpoly_at(q, j), q->width, b + k + d - j, 1);
}

/* Do b's ends divide those of a?  Mostly this finds out that b does not. */
static int ends_divide(const algsurf_zpoly *a, const algsurf_zpoly *b, const algsurf_z_factor *factor,
                       divider *space, algsurf_limb *r) {
    int n = a->degree, d = b->degree;
    if (factor[d].length == 0) return 0;
    algsurf_z_copy(r, space->w, algsurf_zpoly_at(a, n), a->width);
    if (!exact_quotient(space, r, space->w, factor + d)) return 0;
    if (factor[0].length == 0) return algsurf_z_sign(a->c, a->width) == 0;
    algsurf_z_copy(r, space->w, a->c, a->width);
    return exact_quotient(space, r, space->w, factor);
}

/* Long division from the leading coefficient down; the first remainder that is not 0 ends it.  As |q_k| stays
 * below 2^qbits nothing overflows w limbs, and a remainder 0 throughout is the proof. */
static int long_division(const algsurf_zpoly *a, const algsurf_z_factor *b, int d, int qbits, divider *space,
                         algsurf_limb *r, const algsurf_zpoly *q) {
    int w = space->w;
    for (int k = a->degree - d; k >= -d; k--) {
        what_remains(r, w, a, b, d, k, q);
        if (k < 0) {
            if (algsurf_z_sign(r, w)) return 0;
            continue;
        }
        if (!exact_quotient(space, r, w, b + d) || algsurf_z_bits(r, w) > qbits) return 0;
        algsurf_z_copy(algsurf_zpoly_at(q, k), q->width, r, w);
    }
    return 1;
}

/* Work space for dividing by b, and the division; 0: no memory. */
static int try_division(algsurf_memory *m, const algsurf_zpoly *a, const algsurf_zpoly *b, int w, int qbits,
                        int *divides, const algsurf_zpoly *q) {
    divider space;
    const algsurf_z_factor *factor = factors_of(m, b);
    algsurf_limb *r = take(m, w);
    if (!divider_new(m, w, &space) || !factor || !r) return 0;
    *divides =
        ends_divide(a, b, factor, &space, r) && long_division(a, factor, b->degree, qbits, &space, r, q);
    return 1;
}

/* Mignotte: |q_k| <= C(e,k) M(q), e = deg q, and Mahler's measure has M(q) M(b) = M(a) <= |a|_2, M(b) >= 1;
 * hence |q_k| < 2^(e + bits(a)) sqrt(n + 1).  What remains of a coefficient of a is a sum of at most n + 2
 * terms. */
int algsurf_zpoly_divide(algsurf_memory *m, const algsurf_zpoly *a, const algsurf_zpoly *b, int *divides,
                         algsurf_zpoly *q) {
    int e = a->degree - b->degree;
    *divides = a->degree < 0 && b->degree >= 0;
    if (a->degree < 0 || b->degree < 0 || e < 0) return algsurf_zpoly_new(m, -1, 1, q);
    int abits = algsurf_zpoly_bits(a), terms = bits_of_int(a->degree + 1),
        qbits = e + abits + (terms + 1) / 2;
    int w = algsurf_z_width(larger(abits, qbits + algsurf_zpoly_bits(b) + terms) + 1);
    algsurf_zpoly quotient;
    algsurf_memory_mark start = algsurf_memory_here(m);
    if (!new_unset(m, e, algsurf_z_width(qbits), &quotient)) return 0;
    algsurf_memory_mark mark = algsurf_memory_here(m);
    int done = try_division(m, a, b, w, qbits, divides, &quotient);
    algsurf_memory_release(m, done && *divides ? mark : start);
    if (done && *divides) {
        tighten(&quotient, 0);
        *q = quotient;
    }
    return done;
}

/* ---- content ---- */

/* a = gcd(a, b) for magnitudes of na and nb limbs in x and y (both overwritten, w + 1 limbs); returns where
 * the gcd is. */
static algsurf_limb *gcd(algsurf_limb *x, int nx, algsurf_limb *y, int ny, divider *d, int *length) {
    while (ny) {
        if (nx >= ny) {
            x[nx] = 0;
            algsurf_z_divide(d->q, x, nx, y, ny, d->room);
            nx = algsurf_z_length(x, ny);
        }
        algsurf_limb *t = x;
        int n = nx;
        x = y, nx = ny;
        y = t, ny = n;
    }
    *length = nx;
    return x;
}

int algsurf_zpoly_primitive(algsurf_memory *m, const algsurf_zpoly *p, algsurf_zpoly *primitive) {
    int w = p->width, n = 0;
    if (!algsurf_zpoly_copy(m, p, w, primitive)) return 0;
    algsurf_memory_mark mark = algsurf_memory_here(m);
    divider d;
    algsurf_limb *x = take(m, w + 1), *y = take(m, w + 1);
    int done = divider_new(m, w, &d) && x && y;
    for (int k = primitive->degree; k >= 0 && done && !(n == 1 && x[0] == 1); k--) {
        algsurf_z_factor c = algsurf_z_factor_of(algsurf_zpoly_at(primitive, k), w, y);
        algsurf_limb *g = gcd(x, n, y, c.length, &d, &n);
        if (g != x) y = x, x = g;
    }
    if (done && n && !(n == 1 && x[0] == 1)) {
        algsurf_z_factor content = {0, n, 0, x};
        for (int k = 0; k <= primitive->degree; k++)
            (void)exact_quotient(&d, algsurf_zpoly_at(primitive, k), w, &content);
    }
    algsurf_memory_release(m, mark);
    if (done) tighten(primitive, 0);
    return done;
}
