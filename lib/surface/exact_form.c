/* surface/exact_form.c - P along a ray by Horner's scheme in x, y, z over polynomials with integer
 * coefficients.
 *
 * Each coordinate is 2^unit (f0 + f1 v), f0 and f1 integers, with a unit of its own, the largest possible, so
 * that they nearly always fit one limb.  Where they do not, each is still two limbs at some place among
 * zeros, for it comes from one double.  A term a x^i y^j z^k counts with the power of two of its units;
 * `least`, the lowest bit of all, makes them integers.  Nested Horner needs no powers of the coordinates: one
 * step is a product in place by f0 + f1 v, 2 limbs of products for each limb of the polynomial, and widths
 * grow with the degree as they must.
 *
 * The parameter.  u = 2^shift v: v is chosen so that the bits of origins and directions lie over each other,
 * as far as one power of two can do that for three axes; then f0 and f1 have 53 to 56 bits, not 53 + |shift|.
 * The powers of 2^shift are put in at the end.
 *
 * Widths.  Every polynomial on the way is a sum of products of a term and some coordinates; with
 * |f0| + |f1| < 2^bits a product by a coordinate adds `bits` to the largest of the summands, and N summands
 * add log2 N.
 *
 * Products by a coordinate, in place.  Coefficient k becomes c_k f0 + c_(k-1) f1: from the highest k
 * downwards nothing is overwritten too early, and one pass makes both products, with a carry each.
 *
 * Signs.  f0 and f1 are magnitudes with a mask of sign.  a (-f) = (-a) f = (~a) f + f: the carry starts with
 * f. A negative integer a of w limbs is its limbs, read as a magnitude, minus 2^(64 w): the product's limb w,
 * the last carry, is to be reduced by f.  Limbs below are not touched by that, and none above exists, for the
 * width grows by one limb at most: f0 + f1 < 2^64 adds 64 bits.
 *
 * The loop over w limbs exists for each w of 1 .. 8 with that constant, which the compiler unrolls (7 to 9 %
 * of a form of degree 6 to 10), and once for the others. */
#include "../base/arithmetic.h"
#include "exact_form.h"

#include "impl.h"

/* (low + 2^64 high) 2^(64 at), negated when `sign` is all ones; sign is 0 otherwise. */
typedef struct exact_factor {
    algsurf_limb low, high, sign;
    int at;
} exact_factor;

typedef struct exact_axis {
    int unit;
    int bits;     /* |f[0]| + |f[1]| < 2^bits */
    int one_limb; /* bits <= 64, hence f[i].high and f[i].at are 0 */
    exact_factor f[2];
} exact_axis;

/* Where the bits of a double lie: x is an odd multiple of 2^low, and |x| < 2^top; 0: low = top = 0. */
typedef struct exact_span {
    int low, top;
} exact_span;

static exact_span span_of(double x) {
    int e;
    algsurf_limb odd = algsurf_z_odd_part(x, &e);
    return (exact_span){e, e + algsurf_limb_bits(odd)};
}

/* A polynomial in the making: a sum of `count` polynomials with coefficients below 2^bits in magnitude.  The
 * width follows from these two, never from the values: intermediate signs need no attention. */
typedef struct exact_sum {
    int degree; /* -1: zero, the other members except stride and c mean nothing */
    int bits, count, width;
    size_t stride;   /* limbs from one coefficient to the next, at least every width to come */
    algsurf_limb *c; /* room for every degree to come */
} exact_sum;

/* x 2^-unit, an integer. */
static exact_factor factor_of(double x, int unit) {
    int e;
    algsurf_limb odd = algsurf_z_odd_part(x, &e);
    exact_factor f = {0, 0, x < 0 ? ~(algsurf_limb)0 : 0, 0};
    if (odd == 0) return f;
    int shift = (e - unit) % 64;
    f.at = (e - unit) / 64;
    f.low = odd << shift;
    f.high = shift ? odd >> (64 - shift) : 0;
    return f;
}

static int is_zero(const exact_factor *f) { return f->low == 0 && f->high == 0; }
static int is_limb(const exact_factor *f) { return f->high == 0 && f->at == 0; }

/* In the largest unit that makes f0 and f1 integers. */
static void axis_make(exact_axis *x, double origin, double direction, int e) {
    exact_span o = span_of(origin), d = span_of(direction);
    d.low += e, d.top += e;
    if (direction == 0) d = o;
    if (origin == 0) o = d;
    x->unit = o.low < d.low ? o.low : d.low;
    x->bits = (o.top > d.top ? o.top : d.top) - x->unit + 1;
    x->f[0] = factor_of(origin, x->unit);
    x->f[1] = factor_of(direction, x->unit - e);
    algsurf_limb sum = x->f[0].low + x->f[1].low;
    x->one_limb = is_limb(&x->f[0]) && is_limb(&x->f[1]) && sum >= x->f[0].low;
    if (x->one_limb) x->bits = algsurf_limb_bits(sum);
}

static algsurf_limb *at(const exact_sum *p, int k) { return p->c + (size_t)k * p->stride; }

/* Limbs for a sum of `count` integers below 2^bits in magnitude. */
static int sum_width(int bits, int count) {
    return algsurf_z_width(bits + algsurf_limb_bits((algsurf_limb)count - 1));
}

/* Makes p ready for `count` more summands of at most that degree, below 2^bits: only its values stay. */
static void sum_expect(exact_sum *p, int degree, int bits, int count) {
    if (p->degree < 0) p->bits = 0, p->count = 0, p->width = 0;
    if (p->bits < bits) p->bits = bits;
    p->count += count;
    int width = sum_width(p->bits, p->count);
    for (int k = 0; k <= p->degree && width > p->width; k++)
        algsurf_z_copy(at(p, k), width, at(p, k), p->width);
    if (width > p->width) p->width = width;
    while (p->degree < degree) p->degree++, algsurf_z_zero(at(p, p->degree), p->width);
}

/* r += a, extended by its sign. */
static void add_integer(algsurf_limb *r, int width, const algsurf_limb *a, int w) {
    unsigned char carry = 0;
    algsurf_limb sign = 0 - (a[w - 1] >> 63);
    for (int i = 0; i < w; i++) r[i] = algsurf_limb_add(r[i], a[i], &carry);
    for (int i = w; i < width; i++) r[i] = algsurf_limb_add(r[i], sign, &carry);
}

/* p += q; q is used up (p may receive its room). */
static void sum_add(exact_sum *p, exact_sum *q) {
    if (q->degree < 0) return;
    if (p->degree < q->degree) { /* p is the longer one */
        exact_sum other = *p;
        *p = *q, *q = other;
    }
    if (q->degree < 0) return;
    sum_expect(p, 0, q->bits, q->count);
    for (int k = 0; k <= q->degree; k++) add_integer(at(p, k), p->width, at(q, k), q->width);
}

/* r = a f, of w limbs and one more if `grows`; r may be a. */
static inline __attribute__((always_inline)) void product(algsurf_limb *r, const algsurf_limb *a,
                                                          const exact_factor *f, int w, int grows) {
    algsurf_limb factor = f->low, sign = f->sign, carry = factor & sign;
    algsurf_limb above = (a[w - 1] ^ sign) >> 63 ? factor : 0;
    for (int i = 0; i < w; i++) r[i] = algsurf_limb_product(a[i] ^ sign, factor, carry, 0, &carry);
    if (grows) r[w] = carry - above;
}

/* r = a f[0] + b f[1] likewise; r may be a. */
static inline __attribute__((always_inline)) void two_products(algsurf_limb *r, const algsurf_limb *a,
                                                               const algsurf_limb *b, const exact_factor f[2],
                                                               int w, int grows) {
    algsurf_limb f0 = f[0].low, f1 = f[1].low, s0 = f[0].sign, s1 = f[1].sign, c0 = f0 & s0, c1 = f1 & s1;
    algsurf_limb above = ((a[w - 1] ^ s0) >> 63 ? f0 : 0) + ((b[w - 1] ^ s1) >> 63 ? f1 : 0);
    for (int i = 0; i < w; i++) {
        algsurf_limb low = algsurf_limb_product(a[i] ^ s0, f0, c0, 0, &c0);
        r[i] = algsurf_limb_product(b[i] ^ s1, f1, low, c1, &c1);
    }
    if (grows) r[w] = c0 + c1 - above;
}

/* c times f[0] + f[1] u, not both of them 0. */
static inline __attribute__((always_inline)) void any_terms(algsurf_limb *c, size_t stride, int degree,
                                                            const exact_factor f[2], int w, int grows) {
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
static void times_limbs(algsurf_limb *c, size_t stride, int degree, const exact_factor f[2], int w,
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
static void add_times(algsurf_limb *r, int width, const algsurf_limb *a, int w, const exact_factor *f) {
    algsurf_limb limb[2] = {f->low, f->high};
    for (int i = 0; i < 2; i++) {
        if (limb[i] == 0 || f->at + i >= width) continue;
        algsurf_z_join_product(r, width, a, w, limb[i], f->at + i, f->sign != 0);
    }
}

static void times_any(exact_sum *p, const exact_factor f[2], int width, algsurf_limb *spare) {
    for (int k = p->degree + !is_zero(&f[1]); k >= 0; k--) {
        algsurf_z_zero(spare, width);
        if (k <= p->degree) add_times(spare, width, at(p, k), p->width, &f[0]);
        if (k > 0) add_times(spare, width, at(p, k - 1), p->width, &f[1]);
        algsurf_z_copy(at(p, k), width, spare, width);
    }
}

/* p becomes p times f[0] + f[1] u; spare: `stride` limbs. */
static void sum_times(exact_sum *p, const exact_axis *x, algsurf_limb *spare) {
    if (p->degree < 0) return;
    if (is_zero(&x->f[0]) && is_zero(&x->f[1])) {
        p->degree = -1;
        return;
    }
    int bits = p->bits + x->bits, width = sum_width(bits, p->count);
    if (x->one_limb) {
        times_limbs(p->c, p->stride, p->degree, x->f, p->width, width > p->width);
    } else {
        times_any(p, x->f, width, spare);
    }
    p->degree += !is_zero(&x->f[1]);
    p->bits = bits;
    p->width = width;
}

/* ---- Horner's scheme ---- */

typedef struct scheme {
    const algsurf_term *next, *end; /* sorted by decreasing k, j, i */
    int least;                      /* a unit of the integers is 2^least */
    exact_axis axis[3];
    exact_sum sum[3]; /* of a row in x, of the rows in y, of all */
    algsurf_limb *spare;
} scheme;

static int exponent(const algsurf_term *t, int axis) { return axis == 0 ? t->i : axis == 1 ? t->j : t->k; }

/* The exponent of v: the sum of all bits of f0 and f1, in units of their lowest, is a convex function of it
 * with corners where two lowest or two highest bits meet. */
static int choose_exponent(const double origin[3], const double direction[3], int e) {
    exact_span o[3], d[3];
    int count = 0, best = e, best_bits = 0;
    for (int i = 0; i < 3; i++) {
        if (origin[i] == 0 || direction[i] == 0) continue;
        o[count] = span_of(origin[i]);
        d[count++] = span_of(direction[i]);
    }
    for (int corner = 0; corner < 2 * count; corner++) {
        int i = corner / 2, bits = 0, at = corner % 2 ? o[i].top - d[i].top : o[i].low - d[i].low;
        for (int j = 0; j < count; j++) {
            int low = d[j].low + at, top = d[j].top + at;
            bits += (o[j].top > top ? o[j].top : top) - (o[j].low < low ? o[j].low : low);
        }
        if (corner == 0 || bits < best_bits) best = at, best_bits = bits;
    }
    return best;
}

/* Where the unit of the coordinates' product is, in a term. */
static int unit_of(const scheme *h, const algsurf_term *t) {
    return t->i * h->axis[0].unit + t->j * h->axis[1].unit + t->k * h->axis[2].unit;
}

/* Sets least; returns the bits of the largest term's product. */
static int measure(scheme *h) {
    int low = 0, top = 0;
    const exact_axis *x = h->axis;
    for (const algsurf_term *t = h->next; t < h->end; t++) {
        exact_span a = span_of(t->a);
        int bits = t->i * x[0].bits + t->j * x[1].bits + t->k * x[2].bits;
        a.low += unit_of(h, t), a.top += unit_of(h, t) + bits;
        if (t == h->next || a.low < low) low = a.low;
        if (t == h->next || a.top > top) top = a.top;
    }
    h->least = low;
    return top - low;
}

static void add_term(scheme *h) {
    const algsurf_term *t = h->next++;
    exact_sum *p = &h->sum[0];
    int shift = unit_of(h, t) - h->least;
    sum_expect(p, 0, span_of(t->a).top + shift, 1);
    algsurf_z_add_double(p->c, p->width, t->a, shift);
}

/* Does the next term belong to the same power of the axes outside of this one? */
static int goes_on(const scheme *h, const algsurf_term *t, int axis) {
    if (h->next == h->end) return 0;
    return (axis > 1 || h->next->k == t->k) && (axis > 0 || h->next->j == t->j);
}

/* Horner's scheme in one coordinate, over sums in those inside of it. */
static void evaluate(scheme *h, int axis) {
    exact_sum *sum = &h->sum[axis];
    int more = 1;
    sum->degree = -1;
    while (more) {
        const algsurf_term *t = h->next;
        if (axis == 0) {
            add_term(h);
        } else {
            evaluate(h, axis - 1);
            sum_add(sum, &h->sum[axis - 1]);
        }
        more = goes_on(h, t, axis);
        int steps = exponent(t, axis) - (more ? exponent(h->next, axis) : 0);
        while (steps-- > 0) sum_times(sum, &h->axis[axis], h->spare);
    }
}

/* p's degree and width, when the lowest bit of all becomes bit 0; returns where that one is. */
static int measure_result(const exact_sum *sum, int shift, algsurf_zpoly *p) {
    int low = 0, top = 0;
    p->degree = -1;
    for (int k = 0; k <= sum->degree; k++) {
        const algsurf_limb *a = at(sum, k);
        int zeros = algsurf_z_trailing(a, sum->width);
        if (zeros == ALGSURF_Z_NO_BIT) continue;
        int bits = algsurf_z_bits(a, sum->width);
        if (p->degree < 0 || zeros + k * shift < low) low = zeros + k * shift;
        if (p->degree < 0 || bits + k * shift > top) top = bits + k * shift;
        p->degree = k;
    }
    p->width = algsurf_z_width(top - low);
    return low;
}

/* p(u) = 2^-low sum(v), v = 2^shift u, into the room that p has; the sum is changed.  Returns low, 0 if p is
 * zero. */
static int set_result(const exact_sum *sum, int shift, algsurf_zpoly *p) {
    int low = measure_result(sum, shift, p);
    for (int k = 0; k <= p->degree; k++) {
        algsurf_limb *a = at(sum, k);
        int up = k * shift - low;
        if (up < 0) algsurf_z_shift_down(a, sum->width, -up);
        algsurf_z_copy(algsurf_zpoly_at(p, k), p->width, a, sum->width);
        if (up > 0) algsurf_z_shift_up(algsurf_zpoly_at(p, k), p->width, up);
    }
    return low;
}

/* Room for three sums; the scheme's coordinates and terms are set. */
static int take_work(algsurf_memory *m, scheme *h, int degree, int bits) {
    size_t stride = (size_t)algsurf_z_width(bits), size = (size_t)(degree + 1) * stride;
    algsurf_limb *room = algsurf_memory_take(m, 3 * size + stride);
    if (!room) return 0;
    for (int i = 0; i < 3; i++) h->sum[i].stride = stride, h->sum[i].c = room + (size_t)i * size;
    h->spare = room + 3 * size;
    return 1;
}

int algsurf_i_exact_form(algsurf_memory *m, const algsurf_surface *s, const double origin[3],
                         const double direction[3], int e, algsurf_zpoly *p, int *scale) {
    scheme h = {.next = s->terms, .end = s->terms + s->term_count};
    int own = choose_exponent(origin, direction, e), n = s->degree;
    for (int i = 0; i < 3; i++) axis_make(&h.axis[i], origin[i], direction[i], own);
    int bits = measure(&h) + algsurf_limb_bits(s->term_count - 1);
    algsurf_memory_mark before = algsurf_memory_here(m);
    if (!algsurf_zpoly_new(m, n, algsurf_z_width(bits + n * (e < own ? own - e : e - own)), p)) return 0;
    algsurf_memory_mark kept = algsurf_memory_here(m);
    if (!take_work(m, &h, n, bits)) {
        algsurf_memory_release(m, before);
        return 0;
    }
    evaluate(&h, 2);
    int low = set_result(&h.sum[2], e - own, p);
    kept.at = p->c + (size_t)(p->degree + 1) * (size_t)p->width; /* what the result needs of its room */
    algsurf_memory_release(m, kept);
    if (scale) *scale = p->degree < 0 ? 0 : -(h.least + low);
    return 1;
}
