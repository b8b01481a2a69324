/* exact_winding.h - the oracle for complex roots: how many a polynomial has in a rectangle, over integers.
 *
 * By the argument principle it is how often p turns around 0 along the sides.  On a side, p = A(s) + i B(s),
 * s in [0,1], and its half turns are minus the Cauchy index of B / A, which is V(0) - V(1), V the sign
 * changes in the chain A, B, -rem(A, B), ... (Wilf 1978; Basu, Pollack, Roy, Algorithms in Real Algebraic
 * Geometry, section 2.2.2).  Nothing is rounded.  p is turned by a fixed angle so that A is not 0 at a
 * corner.
 */
#ifndef EXACT_WINDING_H
#define EXACT_WINDING_H
#include "algsurf/interval.h"
#include "exact_ray.h"

/* sum (re[k] + i im[k]) z^k for z in Gaussian integers over 2^shift. */
typedef struct exact_complex_poly {
    int n;
    mpz_t *re, *im;
} exact_complex_poly;

static inline exact_complex_poly exact_complex_of(const algsurf_complex *c, int n) {
    exact_complex_poly p = {n, exact_polynomials(1, n + 1), exact_polynomials(1, n + 1)};
    mpz_t *all = exact_polynomials(1, 2 * n + 2);
    (void)exact_integers(all, &c[0].re, 2 * n + 1);
    for (int k = 0; k <= n; k++) mpz_swap(p.re[k], all[2 * k]), mpz_swap(p.im[k], all[2 * k + 1]);
    exact_free(all, 2 * n + 2);
    return p;
}

static inline void exact_complex_clear(exact_complex_poly *p) {
    exact_free(p->re, p->n + 1), exact_free(p->im, p->n + 1);
}

/* a + i b, of degree `degree`, is multiplied by (x + i y) + (dx + i dy) s. */
static inline void exact_times_line(mpz_t *a, mpz_t *b, int degree, mpz_t from[2], mpz_t by[2]) {
    mpz_t u, v;
    mpz_inits(u, v, NULL);
    for (int k = degree + 1; k >= 0; k--) {
        mpz_set_ui(u, 0), mpz_set_ui(v, 0);
        if (k <= degree) {
            mpz_addmul(u, a[k], from[0]), mpz_submul(u, b[k], from[1]);
            mpz_addmul(v, a[k], from[1]), mpz_addmul(v, b[k], from[0]);
        }
        if (k > 0) {
            mpz_addmul(u, a[k - 1], by[0]), mpz_submul(u, b[k - 1], by[1]);
            mpz_addmul(v, a[k - 1], by[1]), mpz_addmul(v, b[k - 1], by[0]);
        }
        mpz_swap(a[k], u), mpz_swap(b[k], v);
    }
    mpz_clears(u, v, NULL);
}

/* The sign of p(s), s = 0 or 1. */
static inline int exact_sign_at_end(mpz_t *p, int n, int s) {
    if (n < 0 || s == 0) return n < 0 ? 0 : mpz_sgn(p[0]);
    mpz_t value;
    mpz_init(value);
    for (int k = 0; k <= n; k++) mpz_add(value, value, p[k]);
    int sign = mpz_sgn(value);
    mpz_clear(value);
    return sign;
}

/* The Cauchy index of b / a on [0,1]; a, b are used up.  0: a vanishes at an end, or both do somewhere. */
static inline int exact_cauchy_index(mpz_t *a, mpz_t *b, int n, int *index) {
    int degree = exact_degree(a, n), next = exact_degree(b, n), last[2] = {0, 0}, known = 1;
    *index = 0;
    if (!exact_sign_at_end(a, degree, 0) || !exact_sign_at_end(a, degree, 1)) return 0;
    for (;;) {
        for (int s = 0; s <= 1; s++) {
            int sign = exact_sign_at_end(a, degree, s);
            if (sign * last[s] < 0) *index += s ? -1 : 1;
            if (sign) last[s] = sign;
        }
        if (next < 0) break;
        exact_primitive(b, next);
        degree = exact_remainder(a, degree, b, next);
        for (int k = 0; k <= degree; k++) mpz_neg(a[k], a[k]);
        mpz_t *t = a;
        int d = degree;
        a = b, b = t, degree = next, next = d;
    }
    if (degree > 0) { /* the greatest common divisor: is p zero on the side? */
        exact_sturm s = exact_sturm_of(a, degree);
        known = exact_count_roots(&s, 0, 1) == 0;
        exact_sturm_clear(&s);
    }
    return known;
}

/* The roots in the rectangle [at[0], at[1]] x [at[2], at[3]] over 2^shift, counted with multiplicity; -1: one
 * is on a side, or p is so turned that A is 0 at a corner. */
static inline int exact_roots_turned(const exact_complex_poly *p, mpz_t at[4], unsigned long shift,
                                     const long turn[2]) {
    static const int corner[5][2] = {{0, 2}, {1, 2}, {1, 3}, {0, 3}, {0, 2}};
    int halves = 0, known = 1, n = p->n;
    mpz_t from[2], by[2], t;
    mpz_inits(from[0], from[1], by[0], by[1], t, NULL);
    for (int side = 0; side < 4 && known; side++) {
        mpz_t *a = exact_polynomials(1, n + 1), *b = exact_polynomials(1, n + 1);
        for (int i = 0; i < 2; i++) {
            mpz_set(from[i], at[corner[side][i]]);
            mpz_sub(by[i], at[corner[side + 1][i]], from[i]);
        }
        for (int k = n; k >= 0; k--) {
            if (k < n) exact_times_line(a, b, n - k - 1, from, by);
            mpz_mul_2exp(t, p->re[k], shift * (unsigned long)(n - k)), mpz_add(a[0], a[0], t);
            mpz_mul_2exp(t, p->im[k], shift * (unsigned long)(n - k)), mpz_add(b[0], b[0], t);
        }
        for (int k = 0; k <= n; k++) {
            mpz_mul_si(t, a[k], turn[1]);
            mpz_mul_si(a[k], a[k], turn[0]), mpz_mul_si(from[0], b[k], turn[1]);
            mpz_sub(a[k], a[k], from[0]);
            mpz_mul_si(b[k], b[k], turn[0]), mpz_add(b[k], b[k], t);
        }
        int index;
        known = exact_cauchy_index(a, b, n, &index);
        halves -= index;
        exact_free(a, n + 1), exact_free(b, n + 1);
    }
    mpz_clears(from[0], from[1], by[0], by[1], t, NULL);
    return known ? halves / 2 : -1;
}

/* The roots in a box that is widened by 2^margin on all sides; -1: cannot be told. */
static inline int exact_roots_in_box(const exact_complex_poly *p, algsurf_cinterval box, int margin) {
    static const long turns[3][2] = {{1, 0}, {13, 29}, {-71, 5}};
    const double ends[4] = {box.re.lo, box.re.hi, box.im.lo, box.im.hi};
    mpz_t *at = exact_polynomials(1, 4), by;
    int shift = exact_integers(at, ends, 3), finer = margin + shift < 0 ? -margin - shift : 0, roots = -1;
    mpz_init(by), mpz_setbit(by, (mp_bitcnt_t)(margin + shift + finer));
    for (int i = 0; i < 4; i++) {
        mpz_mul_2exp(at[i], at[i], (mp_bitcnt_t)finer);
        if (i % 2)
            mpz_add(at[i], at[i], by);
        else
            mpz_sub(at[i], at[i], by);
    }
    for (int i = 0; i < 3 && roots < 0; i++)
        roots = exact_roots_turned(p, at, (unsigned long)(shift + finer), turns[i]);
    exact_free(at, 4), mpz_clear(by);
    return roots;
}

#endif
