/* divide.c - long division of forms with integer coefficients.
 *
 * In u = s / (1-s) a form is a polynomial, with n choose k times its Bernstein coefficients.  To divide r by
 * d, d_m not 0, without fractions, r is multiplied by d_m before r_k u^(k-m) d is taken away, for k = n .. m;
 * that changes no root.  If d_m is 0, d having a root at s = 1, both are read from the other end. */
#include <stdlib.h>
#include <string.h>

#include "form.h"

enum { MOST_WORK = 100000000 }; /* products of words: some 0.1 s */

uint64_t algsurf_i_binomial(int n, int k) {
    uint64_t b = 1;
    for (int i = 1; i <= k; i++) /* C(64,32) 64 would overflow: b (n-k+i) / i by parts */
        b = b / (uint64_t)i * (uint64_t)(n - k + i) + b % (uint64_t)i * (uint64_t)(n - k + i) / (uint64_t)i;
    return b;
}

/* Words that hold a; more are copies of its sign. */
static int length_of(const uint32_t *a, int size) {
    uint32_t fill = a[size - 1] >> 31 ? UINT32_MAX : 0;
    while (size > 1 && a[size - 1] == fill && a[size - 2] >> 31 == fill >> 31) size--;
    return size;
}

/* Room for a dividend: degree + 1 integers, and two more. */
typedef struct dividend {
    uint32_t *r, *wide, *product;
    int degree, words;
} dividend;

static uint32_t *entry(const dividend *p, int k) { return p->r + (size_t)k * (size_t)p->words; }

static void set_dividend(const dividend *p, const algsurf_i_ray_form *f, int backwards) {
    for (int k = 0; k <= p->degree; k++) {
        const uint32_t *from = algsurf_i_form_entry(f, f->p, backwards ? p->degree - k : k);
        uint64_t b = algsurf_i_binomial(p->degree, k);
        const algsurf_i_factor factor = {0, 2, {(uint32_t)b, (uint32_t)(b >> 32)}};
        memcpy(p->wide, from, (size_t)f->size * sizeof *from);
        for (int i = f->size; i < p->words; i++) p->wide[i] = from[f->size - 1] >> 31 ? UINT32_MAX : 0;
        algsurf_i_integer_zero(entry(p, k), p->words);
        algsurf_i_integer_add_product(entry(p, k), p->wide, &factor, p->words);
    }
}

static void set_divisor(const algsurf_i_ray_form *f, uint32_t *form, int backwards, algsurf_i_factor *d) {
    int m = f->face_degree;
    for (int k = 0; k <= m; k++) {
        uint32_t *a = algsurf_i_form_entry(f, f->part, 0);
        memcpy(a, algsurf_i_form_entry(f, form, backwards ? m - k : k), (size_t)f->size * sizeof *a);
        if (m == 2 && k == 1) algsurf_i_integer_shift(a, f->size, 1);
        algsurf_i_factor_from(d + k, a, length_of(a, f->size));
    }
}

/* What is left is below d's degree m; is it 0? */
static int divides(const dividend *p, const algsurf_i_factor *d, int m) {
    for (int k = p->degree; k >= m; k--) {
        if (algsurf_i_integer_sign(entry(p, k), p->words) == 0) continue;
        for (int j = 0; j < k; j++) {
            algsurf_i_integer_zero(p->product, p->words);
            algsurf_i_integer_add_product(p->product, entry(p, j), d + m, p->words);
            if (j >= k - m) {
                algsurf_i_factor minus = d[j - (k - m)];
                minus.negative = !minus.negative;
                algsurf_i_integer_add_product(p->product, entry(p, k), &minus, p->words);
            }
            memcpy(entry(p, j), p->product, (size_t)p->words * sizeof *p->product);
        }
    }
    for (int j = 0; j < m; j++)
        if (algsurf_i_integer_sign(entry(p, j), p->words) != 0) return 0;
    return 1;
}

int algsurf_i_face_divides(const algsurf_i_ray_form *f, int face) {
    algsurf_i_factor d[3];
    uint32_t *form = algsurf_i_form_face(f, face);
    int n = f->n, m = f->face_degree, longest = 0;
    for (int k = 0; k <= m; k++) {
        int length = length_of(algsurf_i_form_entry(f, form, k), f->size);
        longest = length > longest ? length : longest;
    }
    int backwards = algsurf_i_integer_sign(algsurf_i_form_entry(f, form, m), f->size) == 0;
    if (backwards && algsurf_i_integer_sign(algsurf_i_form_entry(f, form, 0), f->size) == 0) return 0;
    dividend p = {.degree = n, .words = f->size + 2 + n * (longest + 1)};
    if (n < m || longest >= ALGSURF_FACTOR_WORDS || (double)p.words * longest * n * n > MOST_WORK) return 0;
    p.r = malloc((size_t)(n + 3) * (size_t)p.words * sizeof *p.r);
    if (!p.r) return 0;
    p.wide = entry(&p, n + 1);
    p.product = entry(&p, n + 2);
    set_dividend(&p, f, backwards);
    set_divisor(f, form, backwards, d);
    int divided = divides(&p, d, m);
    free(p.r);
    return divided;
}
