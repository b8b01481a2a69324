/* surface/exact_axis.c - products of a polynomial and a coordinate of a ray, in place.
 *
 * Coefficient k becomes c_k f0 + c_(k-1) f1: from the highest k downwards nothing is overwritten too early,
 * and one pass makes both products, with a carry each.
 *
 * Signs.  f0 and f1 are magnitudes with a mask of sign.  a (-f) = (-a) f = (~a) f + f: the carry starts with
 * f. A negative integer a of w limbs is its limbs, read as a magnitude, minus 2^(64 w): the product's limb w,
 * the last carry, is to be reduced by f.  Limbs below are not touched by that, and none above exists, for the
 * width grows by one limb at most: f0 + f1 < 2^64 adds 64 bits.
 *
 * The loop over w limbs exists for each w of 1 .. 8 with that constant, which the compiler unrolls (7 to 9 %
 * of a form of degree 6 to 10), and once for the others. */
#include "../base/arithmetic.h"
#include "exact_axis.h"

/* x 2^-unit, an integer. */
static algsurf_i_exact_factor factor_of(double x, int unit) {
    int e;
    algsurf_limb odd = algsurf_z_odd_part(x, &e);
    algsurf_i_exact_factor f = {0, 0, x < 0 ? ~(algsurf_limb)0 : 0, 0};
    if (odd == 0) return f;
    int shift = (e - unit) % 64;
    f.at = (e - unit) / 64;
    f.low = odd << shift;
    f.high = shift ? odd >> (64 - shift) : 0;
    return f;
}

static int is_zero(const algsurf_i_exact_factor *f) { return f->low == 0 && f->high == 0; }
static int is_limb(const algsurf_i_exact_factor *f) { return f->high == 0 && f->at == 0; }

/* In a given unit, which makes f0 and f1 integers. */
static void make_in_unit(algsurf_i_exact_axis *x, double origin, double direction, int e, int unit) {
    algsurf_i_exact_span o = algsurf_i_exact_span_of(origin), d = algsurf_i_exact_span_of(direction);
    d.top += e;
    if (origin == 0) o = d;
    if (direction == 0) d = o;
    x->unit = unit;
    x->bits = (o.top > d.top ? o.top : d.top) - unit + 1;
    x->f[0] = factor_of(origin, unit);
    x->f[1] = factor_of(direction, unit - e);
    x->one_limb = is_limb(&x->f[0]) && is_limb(&x->f[1]);
    if (!x->one_limb) return;
    algsurf_limb sum = x->f[0].low + x->f[1].low;
    x->one_limb = sum >= x->f[0].low;
    if (x->one_limb) x->bits = algsurf_limb_bits(sum);
}

void algsurf_i_exact_axis_make(algsurf_i_exact_axis *x, double origin, double direction, int e) {
    int o = algsurf_i_exact_span_of(origin).low, d = algsurf_i_exact_span_of(direction).low + e;
    int unit = direction == 0 || (origin != 0 && o < d) ? o : d;
    make_in_unit(x, origin, direction, e, unit);
}

static algsurf_limb *at(const algsurf_i_exact_sum *p, int k) { return p->c + (size_t)k * p->stride; }

int algsurf_i_exact_sum_width(int bits, int count) {
    return algsurf_z_width(bits + algsurf_limb_bits((algsurf_limb)count - 1));
}

/* The limbs above the old width repeat the sign. */
static void widen(algsurf_i_exact_sum *p, int width) {
    for (int k = 0; k <= p->degree; k++) {
        algsurf_limb *a = at(p, k), sign = 0 - (a[p->width - 1] >> 63);
        for (int i = p->width; i < width; i++) a[i] = sign;
    }
    p->width = width;
}

void algsurf_i_exact_sum_expect(algsurf_i_exact_sum *p, int degree, int bits, int count) {
    if (p->degree < 0) p->bits = 0, p->count = 0, p->width = 0;
    if (p->bits < bits) p->bits = bits;
    p->count += count;
    int width = algsurf_i_exact_sum_width(p->bits, p->count);
    if (width > p->width) widen(p, width);
    while (p->degree < degree) p->degree++, algsurf_z_zero(at(p, p->degree), p->width);
}

/* r += a, extended by its sign. */
static void add_integer(algsurf_limb *r, int width, const algsurf_limb *a, int w) {
    unsigned char carry = 0;
    algsurf_limb sign = 0 - (a[w - 1] >> 63);
    for (int i = 0; i < w; i++) r[i] = algsurf_limb_add(r[i], a[i], &carry);
    for (int i = w; i < width; i++) r[i] = algsurf_limb_add(r[i], sign, &carry);
}

void algsurf_i_exact_sum_add_double(algsurf_i_exact_sum *p, double x, int shift) {
    int e;
    algsurf_limb odd = algsurf_z_odd_part(x, &e), sign = x < 0 ? ~(algsurf_limb)0 : 0;
    e += shift;
    int bits = e + algsurf_limb_bits(odd), first = e / 64, rest = e % 64;
    algsurf_i_exact_sum_expect(p, 0, bits, 1);
    if (odd == 0) return;
    algsurf_limb part[2] = {odd << rest, rest ? odd >> (64 - rest) : 0};
    unsigned char carry = sign != 0; /* -x = ~x + 1 */
    for (int i = first; i < p->width; i++) {
        algsurf_limb add = i < first + 2 ? part[i - first] : 0;
        p->c[i] = algsurf_limb_add(p->c[i], add ^ sign, &carry);
    }
}

void algsurf_i_exact_sum_add(algsurf_i_exact_sum *p, algsurf_i_exact_sum *q) {
    if (q->degree < 0) return;
    if (p->degree < q->degree) { /* p is the longer one */
        algsurf_i_exact_sum other = *p;
        *p = *q, *q = other;
    }
    if (q->degree < 0) return;
    algsurf_i_exact_sum_expect(p, 0, q->bits, q->count);
    for (int k = 0; k <= q->degree; k++) add_integer(at(p, k), p->width, at(q, k), q->width);
}

/* r = a f, of w limbs and one more if `grows`; r may be a. */
static inline __attribute__((always_inline)) void product(algsurf_limb *r, const algsurf_limb *a,
                                                          const algsurf_i_exact_factor *f, int w, int grows) {
    algsurf_limb factor = f->low, sign = f->sign, carry = factor & sign;
    algsurf_limb above = (a[w - 1] ^ sign) >> 63 ? factor : 0;
    for (int i = 0; i < w; i++) r[i] = algsurf_limb_product(a[i] ^ sign, factor, carry, 0, &carry);
    if (grows) r[w] = carry - above;
}

/* r = a f[0] + b f[1] likewise; r may be a. */
static inline __attribute__((always_inline)) void two_products(algsurf_limb *r, const algsurf_limb *a,
                                                               const algsurf_limb *b,
                                                               const algsurf_i_exact_factor f[2], int w,
                                                               int grows) {
    algsurf_limb f0 = f[0].low, f1 = f[1].low, s0 = f[0].sign, s1 = f[1].sign, c0 = f0 & s0, c1 = f1 & s1;
    algsurf_limb above = ((a[w - 1] ^ s0) >> 63 ? f0 : 0) + ((b[w - 1] ^ s1) >> 63 ? f1 : 0);
    for (int i = 0; i < w; i++) {
        algsurf_limb low = algsurf_limb_product(a[i] ^ s0, f0, c0, 0, &c0);
        r[i] = algsurf_limb_product(b[i] ^ s1, f1, low, c1, &c1);
    }
    if (grows) r[w] = c0 + c1 - above;
}

/* c times f[0] + f[1] u, not both of them 0. */
static inline __attribute__((always_inline)) void
any_terms(algsurf_limb *c, size_t stride, int degree, const algsurf_i_exact_factor f[2], int w, int grows) {
    algsurf_limb *first = c;
    if (is_zero(&f[1])) {
        for (int k = 0; k <= degree; k++, c += stride) product(c, c, &f[0], w, grows);
        return;
    }
    c += (size_t)degree * stride;
    product(c + stride, c, &f[1], w, grows);
    if (is_zero(&f[0])) {
        for (int k = degree; k > 0; k--, c -= stride) product(c, c - stride, &f[1], w, grows);
        algsurf_z_zero(first, w + grows);
        return;
    }
    for (int k = degree; k > 0; k--, c -= stride) two_products(c, c, c - stride, f, w, grows);
    product(c, c, &f[0], w, grows);
}

/* The same; each of the least widths, known to the compiler, has its own loops. */
static void times_limbs(algsurf_limb *c, size_t stride, int degree, const algsurf_i_exact_factor f[2], int w,
                        int grows) {
    w == 1   ? any_terms(c, stride, degree, f, 1, grows)
    : w == 2 ? any_terms(c, stride, degree, f, 2, grows)
    : w == 3 ? any_terms(c, stride, degree, f, 3, grows)
    : w == 4 ? any_terms(c, stride, degree, f, 4, grows)
    : w == 5 ? any_terms(c, stride, degree, f, 5, grows)
    : w == 6 ? any_terms(c, stride, degree, f, 6, grows)
    : w == 7 ? any_terms(c, stride, degree, f, 7, grows)
    : w == 8 ? any_terms(c, stride, degree, f, 8, grows)
             : any_terms(c, stride, degree, f, w, grows);
}

/* r += a f */
static void add_times(algsurf_limb *r, int width, const algsurf_limb *a, int w,
                      const algsurf_i_exact_factor *f) {
    algsurf_limb limb[2] = {f->low, f->high};
    for (int i = 0; i < 2; i++) {
        if (limb[i] == 0 || f->at + i >= width) continue;
        algsurf_z_join_product(r, width, a, w, limb[i], f->at + i, f->sign != 0);
    }
}

static void times_any(algsurf_i_exact_sum *p, const algsurf_i_exact_factor f[2], int width,
                      algsurf_limb *spare) {
    for (int k = p->degree + !is_zero(&f[1]); k >= 0; k--) {
        algsurf_z_zero(spare, width);
        if (k <= p->degree) add_times(spare, width, at(p, k), p->width, &f[0]);
        if (k > 0) add_times(spare, width, at(p, k - 1), p->width, &f[1]);
        algsurf_z_copy(at(p, k), width, spare, width);
    }
}

void algsurf_i_exact_sum_times(algsurf_i_exact_sum *p, const algsurf_i_exact_axis *x, algsurf_limb *spare) {
    if (p->degree < 0) return;
    if (is_zero(&x->f[0]) && is_zero(&x->f[1])) {
        p->degree = -1;
        return;
    }
    int bits = p->bits + x->bits, width = algsurf_i_exact_sum_width(bits, p->count);
    if (x->one_limb) {
        times_limbs(p->c, p->stride, p->degree, x->f, p->width, width > p->width);
    } else {
        times_any(p, x->f, width, spare);
    }
    p->degree += !is_zero(&x->f[1]);
    p->bits = bits;
    p->width = width;
}
