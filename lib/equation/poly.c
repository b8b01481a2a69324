/* poly.c - polynomials in x, y, z with double-double coefficients of unlimited range.
 *
 * Coefficients: hi lies in [2^-128, 2^128) between operations, so that products and their errors
 * stay far from both ends of the range of double; exponents differ in steps of 256, so that sums
 * need no shift as a rule.  Errors: double-double operations are right to 2^-102; the constants
 * below round that up for the rounding of the bounds themselves.  An operation on doubles without errors of
 * which the double-double result is exact adds none: whole coefficients stay exact.
 *
 * A product of polynomials merges its rows, the multiples of the larger factor by the monomials of the
 * smaller one, with a heap (Johnson, Sparse polynomial arithmetic, SIGSAM Bulletin 8, 1974): products come by
 * increasing keys, and those of one key by the places of their parts in the first factor.
 */
#include "../base/arithmetic.h"
#include "poly.h"

#include <limits.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>

enum { RADIX_BITS = 256, EXPONENT_LIMIT = 1 << 20, MOST_POWERS = 65, ROWS = 8 };

static const double operation_error = 0x1p-101;
static const double quotient_error = 0x1p-99; /* of a quotient or a square root */

static monomial scaled(monomial m, double power_of_two) {
    m.v = algsurf_dd_scale(m.v, power_of_two);
    m.err *= power_of_two;
    return m;
}

static int is_zero(const monomial *m) { return fabs(m->v.hi) <= m->err; }

static monomial normalised(monomial m) {
    for (; fabs(m.v.hi) >= 0x1p128; m.e++) m = scaled(m, 0x1p-256);
    for (; m.v.hi != 0 && fabs(m.v.hi) < 0x1p-128; m.e--) m = scaled(m, 0x1p256);
    return m;
}

monomial algsurf_i_monomial_make(algsurf_dd v, double err, int exponent, int key) {
    int x;
    (void)frexp(v.hi, &x);
    int e = (x + exponent) / RADIX_BITS, rest = exponent - RADIX_BITS * e;
    monomial m = {{ldexp(v.hi, rest), ldexp(v.lo, rest)}, ldexp(err, rest), e, key};
    return normalised(m);
}

/* An exact double? */
static int is_plain(const monomial *m) { return m->v.lo == 0 && m->err == 0; }

static inline monomial product(const monomial *a, const monomial *b) {
    algsurf_dd v = algsurf_dd_mul(a->v, b->v);
    double err = fabs(a->v.hi) * b->err + fabs(b->v.hi) * a->err + a->err * b->err;
    if (!is_plain(a) || !is_plain(b)) err += operation_error * fabs(v.hi);
    return (monomial){v, err, a->e + b->e, a->key + b->key};
}

void algsurf_i_monomial_multiply(monomial *m, const monomial *by) { *m = normalised(product(m, by)); }

/* *sum += *m; both need not be normalised, but within 2^+-256. */
static inline void accumulate(monomial *sum, const monomial *m) {
    if (sum->v.hi == 0 && sum->err == 0) {
        *sum = *m;
        return;
    }
    int shift = m->e - sum->e, exact = abs(shift) <= 2 && is_plain(sum) && is_plain(m);
    double down = shift == 0 ? 1 : abs(shift) == 1 ? 0x1p-256 : abs(shift) == 2 ? 0x1p-512 : 0.0;
    if (shift > 0) *sum = scaled(*sum, down), sum->e = m->e;
    monomial term = shift < 0 ? scaled(*m, down) : *m;
    sum->v = algsurf_dd_add(sum->v, term.v);
    sum->err += term.err + (exact ? 0 : operation_error * fabs(sum->v.hi));
}

/* Appends m unless it is zero; room must be there. */
static algsurf_status append(tripoly *p, monomial m) {
    if (is_zero(&m)) return ALGSURF_OK;
    m = normalised(m);
    if (abs(m.e) > EXPONENT_LIMIT) return ALGSURF_E_RANGE;
    p->m[p->count++] = m;
    return ALGSURF_OK;
}

double algsurf_i_monomial_round(const monomial *m) {
    monomial n = normalised(*m);
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

monomial algsurf_i_monomial_sqrt(monomial m) {
    if (m.e % 2 != 0) {
        m = scaled(m, 0x1p256);
        m.e--;
    }
    algsurf_dd root = algsurf_dd_sqrt(m.v);
    double err = root.hi > 0 ? m.err / root.hi + quotient_error * root.hi : 0.0;
    if (is_plain(&m) && is_product(m.v.hi, root, root)) err = 0;
    return normalised((monomial){root, err, m.e / 2, 0});
}

void algsurf_i_tripoly_free(tripoly *p) {
    free(p->m);
    *p = (tripoly){NULL, 0};
}

static algsurf_status reserve(tripoly *p, size_t capacity) {
    *p = (tripoly){malloc((capacity ? capacity : 1) * sizeof *p->m), 0};
    return p->m ? ALGSURF_OK : ALGSURF_E_NO_MEMORY;
}

/* Hands the result over, or frees it. */
static algsurf_status deliver(algsurf_status status, tripoly *result, tripoly *out) {
    if (status == ALGSURF_OK) {
        *out = *result;
    } else {
        algsurf_i_tripoly_free(result);
    }
    return status;
}

algsurf_status algsurf_i_tripoly_make(monomial m, tripoly *out) {
    tripoly p;
    algsurf_status status = reserve(&p, 1);
    if (status == ALGSURF_OK) status = append(&p, m);
    return deliver(status, &p, out);
}

int algsurf_i_tripoly_degree(const tripoly *p) {
    int degree = 0;
    for (size_t t = 0; t < p->count; t++) {
        int key = p->m[t].key;
        int d = algsurf_i_exponent(key, 0) + algsurf_i_exponent(key, 1) + algsurf_i_exponent(key, 2);
        if (degree < d) degree = d;
    }
    return degree;
}

size_t algsurf_i_tripoly_most_terms(int degree) {
    size_t n = (size_t)degree;
    return (n + 1) * (n + 2) * (n + 3) / 6;
}

int algsurf_i_tripoly_is_constant(const tripoly *p) {
    return p->count == 0 || (p->count == 1 && p->m[0].key == 0);
}

algsurf_status algsurf_i_tripoly_add(const tripoly *a, const tripoly *b, tripoly *out) {
    tripoly sum;
    algsurf_status status = reserve(&sum, a->count + b->count);
    for (size_t s = 0, t = 0; status == ALGSURF_OK && (s < a->count || t < b->count);) {
        int from_a = s < a->count && (t == b->count || a->m[s].key <= b->m[t].key);
        int from_b = t < b->count && (s == a->count || b->m[t].key <= a->m[s].key);
        monomial m = from_a ? a->m[s] : b->m[t];
        if (from_a && from_b) accumulate(&m, &b->m[t]);
        status = append(&sum, m);
        s += (size_t)from_a;
        t += (size_t)from_b;
    }
    return deliver(status, &sum, out);
}

algsurf_status algsurf_i_tripoly_divide(tripoly *a, const monomial *b) {
    tripoly kept = {a->m, 0};
    algsurf_status status = ALGSURF_OK;
    double least = fabs(b->v.hi) - b->err;
    for (size_t t = 0; status == ALGSURF_OK && t < a->count; t++) {
        const monomial m = a->m[t];
        algsurf_dd v = algsurf_dd_div(m.v, b->v);
        double err = (m.err + fabs(v.hi) * b->err) / least + quotient_error * fabs(v.hi);
        if (is_plain(&m) && is_plain(b) && is_product(m.v.hi, v, b->v)) err = 0;
        status = append(&kept, (monomial){v, err, m.e - b->e, m.key});
    }
    *a = kept;
    return status;
}

/* Replaces the last two parts by their sum. */
static algsurf_status fold(algsurf_i_sum *sum) {
    tripoly *a = &sum->part[sum->parts - 2], *b = a + 1, total;
    algsurf_status status = algsurf_i_tripoly_add(a, b, &total);
    if (status != ALGSURF_OK) return status;
    algsurf_i_tripoly_free(a);
    algsurf_i_tripoly_free(b);
    *a = total;
    sum->parts--;
    return ALGSURF_OK;
}

algsurf_status algsurf_i_sum_add(algsurf_i_sum *sum, tripoly p) {
    sum->part[sum->parts++] = p;
    algsurf_status status = ALGSURF_OK;
    while (status == ALGSURF_OK && sum->parts > 1 &&
           sum->part[sum->parts - 2].count <= 2 * sum->part[sum->parts - 1].count) {
        status = fold(sum);
    }
    return status;
}

algsurf_status algsurf_i_sum_finish(algsurf_i_sum *sum, algsurf_status status, tripoly *out) {
    while (status == ALGSURF_OK && sum->parts > 1) status = fold(sum);
    if (status == ALGSURF_OK && sum->parts == 0) status = reserve(&sum->part[sum->parts++], 0);
    if (status == ALGSURF_OK) *out = sum->part[--sum->parts];
    while (sum->parts > 0) algsurf_i_tripoly_free(&sum->part[--sum->parts]);
    return status;
}

/* The sum of `count` rows, by increasing keys; at each key by the order of the rows, or against it. */
static algsurf_status add_rows(const monomial *m, int count, const tripoly *large, int backwards, size_t most,
                               tripoly *out) {
    const monomial *at[ROWS], *end = large->m + large->count;
    int key[ROWS]; /* of the next product of each row */
    tripoly p;
    algsurf_status status =
        reserve(&p, (size_t)count * large->count < most ? (size_t)count * large->count : most);
    for (int row = 0; row < count; row++) {
        at[row] = large->m;
        key[row] = large->count ? m[row].key + large->m->key : INT_MAX;
    }
    while (status == ALGSURF_OK) {
        monomial sum = {{0.0, 0.0}, 0.0, 0, 0};
        int least = INT_MAX;
        for (int row = 0; row < count; row++) least = key[row] < least ? key[row] : least;
        if (least == INT_MAX) break;
        for (int k = 0; k < count; k++) {
            int row = backwards ? count - 1 - k : k;
            if (key[row] != least) continue;
            monomial n = product(&m[row], at[row]++);
            accumulate(&sum, &n);
            key[row] = at[row] < end ? m[row].key + at[row]->key : INT_MAX;
        }
        status = append(&p, sum);
    }
    return deliver(status, &p, out);
}

algsurf_status algsurf_i_tripoly_multiply(const tripoly *a, const tripoly *b, tripoly *out) {
    const tripoly *small = a->count < b->count ? a : b, *large = small == a ? b : a;
    size_t most = algsurf_i_tripoly_most_terms(algsurf_i_tripoly_degree(a) + algsurf_i_tripoly_degree(b));
    if (small->count <= ROWS) return add_rows(small->m, (int)small->count, large, large == a, most, out);
    algsurf_i_sum sum = {.parts = 0};
    algsurf_status status = ALGSURF_OK;
    for (size_t row = 0; status == ALGSURF_OK && row < small->count; row += ROWS) {
        tripoly part;
        int rows = small->count - row < ROWS ? (int)(small->count - row) : ROWS;
        status = add_rows(small->m + row, rows, large, large == a, most, &part);
        if (status == ALGSURF_OK) status = algsurf_i_sum_add(&sum, part);
    }
    return algsurf_i_sum_finish(&sum, status, out);
}

/* *term = r^k c m^(n-k) joins the sum, and *of_r, r^k, becomes r^(k+1). */
static algsurf_status binomial_term(const monomial *of_m, uint64_t c, const tripoly *r, tripoly *of_r,
                                    algsurf_i_sum *sum) {
    algsurf_dd v = algsurf_two_sum((double)(c >> 32) * 0x1p32, (double)(c & UINT32_MAX));
    monomial factor = algsurf_i_monomial_make(v, 0, 0, 0);
    tripoly term, next;
    factor = normalised(product(of_m, &factor));
    algsurf_status status = add_rows(&factor, 1, of_r, 0, of_r->count, &term);
    if (status == ALGSURF_OK) status = algsurf_i_sum_add(sum, term);
    if (status == ALGSURF_OK) status = algsurf_i_tripoly_multiply(of_r, r, &next);
    if (status != ALGSURF_OK) return status;
    algsurf_i_tripoly_free(of_r);
    *of_r = next;
    return ALGSURF_OK;
}

algsurf_status algsurf_i_tripoly_raise(const tripoly *base, int n, tripoly *out) {
    size_t has_first = base->count > 0;
    monomial of_m[MOST_POWERS] = {algsurf_i_monomial_make(algsurf_dd_from(1), 0, 0, 0)};
    tripoly r = {base->m + has_first, base->count - has_first}, of_r;
    algsurf_i_sum sum = {.parts = 0};
    uint64_t c[MOST_POWERS] = {1}; /* n over k: at most 61 bits */
    for (int k = 0; k < n; k++) {
        of_m[k + 1] = has_first ? normalised(product(&of_m[k], base->m)) : (monomial){.key = 0};
        for (int i = k + 1; i > 0; i--) c[i] += c[i - 1];
    }
    algsurf_status status = algsurf_i_tripoly_make(of_m[0], &of_r);
    if (status != ALGSURF_OK) return status;
    for (int k = 0; status == ALGSURF_OK && k <= n && of_r.count > 0; k++)
        status = binomial_term(&of_m[n - k], c[k], &r, &of_r, &sum);
    algsurf_i_tripoly_free(&of_r);
    return algsurf_i_sum_finish(&sum, status, out);
}
