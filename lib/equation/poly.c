/* poly.c - polynomials in x, y, z with double-double coefficients of unlimited range.
 *
 * Coefficients: hi lies in [2^-128, 2^128) between operations, so that products and their errors
 * stay far from both ends of the range of double; exponents differ in steps of 256, so that sums
 * need no shift as a rule.  Errors: double-double operations are right to 2^-102; the constants
 * below round that up for the rounding of the bounds themselves.  An operation on doubles without errors of
 * which the double-double result is exact adds none: whole coefficients stay exact.
 *
 * Products of polynomials are gathered in a box of all exponents up to the sums of the largest ones
 * in x, y and z: the place of a product is the sum of the places of its factors.
 */
#include "../base/arithmetic.h"
#include "poly.h"

#include <math.h>
#include <stdlib.h>

enum { RADIX_BITS = 256, EXPONENT_LIMIT = 1 << 20 };

static const double operation_error = 0x1p-101;
static const double quotient_error = 0x1p-99; /* of a quotient or a square root */

static algsurf_i_monomial scaled(algsurf_i_monomial m, double power_of_two) {
    m.v = algsurf_dd_scale(m.v, power_of_two);
    m.err *= power_of_two;
    return m;
}

static int is_zero(const algsurf_i_monomial *m) { return fabs(m->v.hi) <= m->err; }

static algsurf_i_monomial normalised(algsurf_i_monomial m) {
    for (; fabs(m.v.hi) >= 0x1p128; m.e++) m = scaled(m, 0x1p-256);
    for (; m.v.hi != 0 && fabs(m.v.hi) < 0x1p-128; m.e--) m = scaled(m, 0x1p256);
    return m;
}

algsurf_i_monomial algsurf_i_monomial_make(algsurf_dd v, double err, int exponent, int key) {
    int x;
    (void)frexp(v.hi, &x);
    int e = (x + exponent) / RADIX_BITS, rest = exponent - RADIX_BITS * e;
    algsurf_i_monomial m = {{ldexp(v.hi, rest), ldexp(v.lo, rest)}, ldexp(err, rest), e, key};
    return normalised(m);
}

/* An exact double? */
static int is_plain(const algsurf_i_monomial *m) { return m->v.lo == 0 && m->err == 0; }

static algsurf_i_monomial product(const algsurf_i_monomial *a, const algsurf_i_monomial *b) {
    algsurf_dd v = algsurf_dd_mul(a->v, b->v);
    double err = fabs(a->v.hi) * b->err + fabs(b->v.hi) * a->err + a->err * b->err;
    if (!is_plain(a) || !is_plain(b)) err += operation_error * fabs(v.hi);
    return (algsurf_i_monomial){v, err, a->e + b->e, a->key + b->key};
}

/* *sum += m; both need not be normalised, but within 2^+-256. */
static void accumulate(algsurf_i_monomial *sum, algsurf_i_monomial m) {
    if (sum->v.hi == 0 && sum->err == 0) {
        *sum = m;
        return;
    }
    int shift = m.e - sum->e, exact = shift == 0 && is_plain(sum) && is_plain(&m);
    if (shift > 0) {
        *sum = scaled(*sum, shift == 1 ? 0x1p-256 : shift == 2 ? 0x1p-512 : 0.0);
        sum->e = m.e;
    } else if (shift < 0) {
        m = scaled(m, shift == -1 ? 0x1p-256 : shift == -2 ? 0x1p-512 : 0.0);
    }
    sum->v = algsurf_dd_add(sum->v, m.v);
    sum->err += m.err + (exact ? 0 : operation_error * fabs(sum->v.hi));
}

/* Appends m unless it is zero; room must be there. */
static algsurf_status append(algsurf_i_tripoly *p, algsurf_i_monomial m) {
    if (is_zero(&m)) return ALGSURF_OK;
    m = normalised(m);
    if (abs(m.e) > EXPONENT_LIMIT) return ALGSURF_E_RANGE;
    p->m[p->count++] = m;
    return ALGSURF_OK;
}

double algsurf_i_monomial_round(const algsurf_i_monomial *m) {
    algsurf_i_monomial n = normalised(*m);
    if (abs(n.e) > 8) return n.e > 0 ? copysign(HUGE_VAL, n.v.hi) : 0.0;
    int shift = RADIX_BITS * n.e, x;
    (void)frexp(n.v.hi, &x);
    if (x + shift > -1022) return ldexp(n.v.hi, shift);
    if (x + shift < -1075) return 0.0; /* below half the least double, whose quantum may overflow here */
    /* A subnormal result: round hi to a multiple of 2^-1074, then mend what lo says of a tie. */
    double quantum = ldexp(1.0, -1074 - shift), anchor = copysign(0x1p52 * quantum, n.v.hi);
    double rounded = (n.v.hi + anchor) - anchor, rest = n.v.hi - rounded;
    if (rest == quantum / 2 && n.v.lo > 0) rounded += quantum;
    if (rest == -quantum / 2 && n.v.lo < 0) rounded -= quantum;
    return ldexp(rounded, shift);
}

/* Is p exactly a b, and are both of them doubles? */
static int is_product(double p, algsurf_dd a, algsurf_dd b) {
    algsurf_dd ab = algsurf_two_prod(a.hi, b.hi);
    return a.lo == 0 && b.lo == 0 && ab.hi == p && ab.lo == 0;
}

algsurf_i_monomial algsurf_i_monomial_sqrt(algsurf_i_monomial m) {
    if (m.e % 2 != 0) {
        m = scaled(m, 0x1p256);
        m.e--;
    }
    algsurf_dd root = algsurf_dd_sqrt(m.v);
    double err = root.hi > 0 ? m.err / root.hi + quotient_error * root.hi : 0.0;
    if (is_plain(&m) && is_product(m.v.hi, root, root)) err = 0;
    return normalised((algsurf_i_monomial){root, err, m.e / 2, 0});
}

void algsurf_i_tripoly_free(algsurf_i_tripoly *p) {
    free(p->m);
    *p = (algsurf_i_tripoly){NULL, 0};
}

static algsurf_status reserve(algsurf_i_tripoly *p, size_t capacity) {
    *p = (algsurf_i_tripoly){malloc((capacity ? capacity : 1) * sizeof *p->m), 0};
    return p->m ? ALGSURF_OK : ALGSURF_E_NO_MEMORY;
}

/* Hands the result over, or frees it. */
static algsurf_status deliver(algsurf_status status, algsurf_i_tripoly *result, algsurf_i_tripoly *out) {
    if (status == ALGSURF_OK) {
        *out = *result;
    } else {
        algsurf_i_tripoly_free(result);
    }
    return status;
}

algsurf_status algsurf_i_tripoly_make(algsurf_i_monomial m, algsurf_i_tripoly *out) {
    algsurf_i_tripoly p;
    algsurf_status status = reserve(&p, 1);
    if (status == ALGSURF_OK) status = append(&p, m);
    return deliver(status, &p, out);
}

void algsurf_i_tripoly_negate(algsurf_i_tripoly *p) {
    for (size_t t = 0; t < p->count; t++) p->m[t].v = algsurf_dd_neg(p->m[t].v);
}

int algsurf_i_tripoly_degree(const algsurf_i_tripoly *p) {
    int degree = 0;
    for (size_t t = 0; t < p->count; t++) {
        int d = algsurf_i_key_x(p->m[t].key) + algsurf_i_key_y(p->m[t].key) + algsurf_i_key_z(p->m[t].key);
        if (degree < d) degree = d;
    }
    return degree;
}

int algsurf_i_tripoly_is_constant(const algsurf_i_tripoly *p) {
    return p->count == 0 || (p->count == 1 && p->m[0].key == 0);
}

algsurf_status algsurf_i_tripoly_add(const algsurf_i_tripoly *a, const algsurf_i_tripoly *b,
                                     algsurf_i_tripoly *out) {
    algsurf_i_tripoly sum;
    algsurf_status status = reserve(&sum, a->count + b->count);
    for (size_t s = 0, t = 0; status == ALGSURF_OK && (s < a->count || t < b->count);) {
        int from_a = s < a->count && (t == b->count || a->m[s].key <= b->m[t].key);
        int from_b = t < b->count && (s == a->count || b->m[t].key <= a->m[s].key);
        algsurf_i_monomial m = from_a ? a->m[s] : b->m[t];
        if (from_a && from_b) accumulate(&m, b->m[t]);
        status = append(&sum, m);
        s += (size_t)from_a;
        t += (size_t)from_b;
    }
    return deliver(status, &sum, out);
}

/* One factor has a single monomial: the order of the other's stays. */
static algsurf_status multiply_by_monomial(const algsurf_i_tripoly *a, const algsurf_i_monomial *b,
                                           algsurf_i_tripoly *out) {
    algsurf_i_tripoly p;
    algsurf_status status = reserve(&p, a->count);
    for (size_t t = 0; status == ALGSURF_OK && t < a->count; t++) status = append(&p, product(&a->m[t], b));
    return deliver(status, &p, out);
}

/* The box of exponents a product fills: strides of y and z, number of places. */
typedef struct box {
    size_t stride_y, stride_z, places;
} box;

static box box_of_product(const algsurf_i_tripoly *a, const algsurf_i_tripoly *b) {
    int top[3] = {0, 0, 0};
    const algsurf_i_tripoly *factors[2] = {a, b};
    for (int f = 0; f < 2; f++) {
        int x = 0, y = 0, z = 0;
        for (size_t t = 0; t < factors[f]->count; t++) {
            int key = factors[f]->m[t].key;
            if (x < algsurf_i_key_x(key)) x = algsurf_i_key_x(key);
            if (y < algsurf_i_key_y(key)) y = algsurf_i_key_y(key);
            if (z < algsurf_i_key_z(key)) z = algsurf_i_key_z(key);
        }
        top[0] += x;
        top[1] += y;
        top[2] += z;
    }
    size_t row = (size_t)top[0] + 1, plane = row * ((size_t)top[1] + 1);
    return (box){row, plane, plane * ((size_t)top[2] + 1)};
}

static size_t place(const box *in, int key) {
    return (size_t)algsurf_i_key_x(key) + (size_t)algsurf_i_key_y(key) * in->stride_y +
           (size_t)algsurf_i_key_z(key) * in->stride_z;
}

static void gather(const algsurf_i_tripoly *a, const algsurf_i_tripoly *b, const box *in,
                   algsurf_i_monomial *cell) {
    for (size_t s = 0; s < a->count; s++) {
        algsurf_i_monomial *from = cell + place(in, a->m[s].key);
        for (size_t t = 0; t < b->count; t++) {
            accumulate(from + place(in, b->m[t].key), product(&a->m[s], &b->m[t]));
        }
    }
}

algsurf_status algsurf_i_tripoly_multiply(const algsurf_i_tripoly *a, const algsurf_i_tripoly *b,
                                          algsurf_i_tripoly *out) {
    if (b->count == 1) return multiply_by_monomial(a, b->m, out);
    if (a->count == 1) return multiply_by_monomial(b, a->m, out);
    box in = box_of_product(a, b);
    algsurf_i_monomial *cell = calloc(in.places, sizeof *cell);
    if (!cell) return ALGSURF_E_NO_MEMORY;
    gather(a, b, &in, cell);
    size_t count = 0;
    for (size_t c = 0; c < in.places; c++) count += !is_zero(&cell[c]);
    algsurf_i_tripoly p;
    algsurf_status status = reserve(&p, count);
    for (size_t c = 0; status == ALGSURF_OK && c < in.places; c++) status = append(&p, cell[c]);
    free(cell);
    return deliver(status, &p, out);
}

algsurf_status algsurf_i_tripoly_divide(algsurf_i_tripoly *a, const algsurf_i_monomial *b) {
    algsurf_i_tripoly kept = {a->m, 0};
    algsurf_status status = ALGSURF_OK;
    double least = fabs(b->v.hi) - b->err;
    for (size_t t = 0; status == ALGSURF_OK && t < a->count; t++) {
        const algsurf_i_monomial m = a->m[t];
        algsurf_dd v = algsurf_dd_div(m.v, b->v);
        double err = (m.err + fabs(v.hi) * b->err) / least + quotient_error * fabs(v.hi);
        if (is_plain(&m) && is_plain(b) && is_product(m.v.hi, v, b->v)) err = 0;
        status = append(&kept, (algsurf_i_monomial){v, err, m.e - b->e, m.key});
    }
    *a = kept;
    return status;
}

/* Replaces the last two parts by their sum. */
static algsurf_status fold(algsurf_i_sum *sum) {
    algsurf_i_tripoly *a = &sum->part[sum->parts - 2], *b = a + 1, total;
    algsurf_status status = algsurf_i_tripoly_add(a, b, &total);
    if (status != ALGSURF_OK) return status;
    algsurf_i_tripoly_free(a);
    algsurf_i_tripoly_free(b);
    *a = total;
    sum->parts--;
    return ALGSURF_OK;
}

algsurf_status algsurf_i_sum_add(algsurf_i_sum *sum, algsurf_i_tripoly p) {
    sum->part[sum->parts++] = p;
    algsurf_status status = ALGSURF_OK;
    while (status == ALGSURF_OK && sum->parts > 1 &&
           sum->part[sum->parts - 2].count <= 2 * sum->part[sum->parts - 1].count) {
        status = fold(sum);
    }
    return status;
}

algsurf_status algsurf_i_sum_total(algsurf_i_sum *sum, algsurf_i_tripoly *out) {
    algsurf_status status = ALGSURF_OK;
    while (status == ALGSURF_OK && sum->parts > 1) status = fold(sum);
    if (status == ALGSURF_OK) {
        *out = sum->part[0];
        sum->parts = 0;
    }
    algsurf_i_sum_free(sum);
    return status;
}

void algsurf_i_sum_free(algsurf_i_sum *sum) {
    while (sum->parts > 0) algsurf_i_tripoly_free(&sum->part[--sum->parts]);
}
