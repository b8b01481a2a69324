/* exact_roots.h - the oracle for real roots: a Sturm chain written from the definition, over integers.
 *
 * p, p' and the negated remainders of Euclid's algorithm; V(x) is the number of sign changes of their values
 * at x, and V(a) - V(b) the number of distinct roots of p in (a,b] (Sturm 1829; Basu, Pollack, Roy,
 * Algorithms in Real Algebraic Geometry, section 2.2).  Divided by its last element, the greatest common
 * divisor of p and p', the chain counts a multiple root once and may be asked at any point.
 */
#ifndef EXACT_ROOTS_H
#define EXACT_ROOTS_H
#include "exact.h"

typedef struct exact_sturm {
    int top;     /* room for degree 0..top in every polynomial */
    int count;   /* polynomials in the chain; 0: p is zero */
    int *degree; /* of each */
    mpz_t *c;    /* coefficient k of polynomial i is c[i (top+1) + k] */
} exact_sturm;

static inline mpz_t *exact_polynomials(int count, int width) {
    mpz_t *p = malloc((size_t)(count * width) * sizeof *p);
    for (int k = 0; k < count * width; k++) mpz_init(p[k]);
    return p;
}

static inline void exact_free(mpz_t *p, int count) {
    for (int k = 0; k < count; k++) mpz_clear(p[k]);
    free(p);
}

static inline int exact_degree(mpz_t *c, int n) {
    while (n >= 0 && mpz_sgn(c[n]) == 0) n--;
    return n;
}

/* Divides p by the greatest common divisor of its coefficients. */
static inline void exact_primitive(mpz_t *p, int n) {
    mpz_t content;
    mpz_init(content);
    for (int k = n; k >= 0 && mpz_cmp_ui(content, 1) != 0; k--) mpz_gcd(content, content, p[k]);
    for (int k = 0; k <= n && mpz_cmp_ui(content, 1) != 0; k++) mpz_divexact(p[k], p[k], content);
    mpz_clear(content);
}

/* r, of degree n, becomes a positive multiple of its remainder by g, of degree m; returns its degree. */
static inline int exact_remainder(mpz_t *r, int n, mpz_t *g, int m) {
    mpz_t lead;
    mpz_init(lead);
    while (n >= m) {
        mpz_set(lead, r[n]);
        if (mpz_sgn(g[m]) < 0) mpz_neg(lead, lead);
        for (int k = 0; k <= n; k++) {
            mpz_mul(r[k], r[k], g[m]);
            if (mpz_sgn(g[m]) < 0) mpz_neg(r[k], r[k]);
        }
        for (int k = 0; k <= m; k++) mpz_submul(r[n - m + k], lead, g[k]);
        n = exact_degree(r, n - 1);
    }
    mpz_clear(lead);
    return n;
}

/* Euclid's algorithm: g, with room for degree n, becomes the gcd of a and b, neither zero. */
static inline int exact_gcd(mpz_t *g, mpz_t *a, int n, mpz_t *b, int m) {
    int top = n > m ? n : m;
    mpz_t *r = exact_polynomials(1, top + 1), *swap, *x = exact_polynomials(1, top + 1), *y = r, *first = x;
    for (int k = 0; k <= n; k++) mpz_set(x[k], a[k]);
    for (int k = 0; k <= m; k++) mpz_set(y[k], b[k]);
    while (m >= 0) {
        exact_primitive(y, m);
        n = n >= m ? exact_remainder(x, n, y, m) : n;
        if (n >= 0) exact_primitive(x, n);
        swap = x, x = y, y = swap;
        int degree = n;
        n = m, m = degree;
    }
    for (int k = 0; k <= n; k++) mpz_set(g[k], x[k]);
    exact_free(first, top + 1), exact_free(r, top + 1);
    return n;
}

/* p, of degree n, becomes p / g, where g, of degree m, divides p; returns its degree. */
static inline int exact_divide(mpz_t *p, int n, mpz_t *g, int m) {
    for (int d = n - m; d >= 0; d--) { /* the quotient's coefficient d takes the place of p's d + m */
        mpz_divexact(p[d + m], p[d + m], g[m]);
        for (int k = 0; k < m; k++) mpz_submul(p[d + k], p[d + m], g[k]);
    }
    for (int d = 0; d <= n - m; d++) mpz_swap(p[d], p[d + m]);
    return n - m;
}

/* The chain of sum p[k] x^k; to be cleared. */
static inline exact_sturm exact_sturm_of(mpz_t *p, int n) {
    exact_sturm s = {n, 0, malloc((size_t)(n + 2) * sizeof(int)), NULL};
    size_t width = (size_t)n + 1, all = width * ((size_t)n + 2);
    s.c = malloc(all * sizeof *s.c);
    for (size_t k = 0; k < all; k++) mpz_init(s.c[k]);
    for (int k = 0; k <= n; k++) mpz_set(s.c[k], p[k]);
    int degree = exact_degree(s.c, n);
    for (mpz_t *q = s.c; degree >= 0; q += width) {
        exact_primitive(q, degree);
        s.degree[s.count++] = degree;
        mpz_t *next = q + width;
        if (s.count == 1) {
            for (int k = 1; k <= degree; k++) mpz_mul_ui(next[k - 1], q[k], (unsigned long)k);
            degree--;
        } else {
            int before = s.degree[s.count - 2];
            for (int k = 0; k <= before; k++) mpz_neg(next[k], (q - width)[k]);
            degree = exact_remainder(next, before, q, degree);
        }
    }
    mpz_t *g = s.c + width * (size_t)(s.count > 0 ? s.count - 1 : 0);
    int m = s.count > 0 ? s.degree[s.count - 1] : 0;
    for (int i = 0; m > 0 && i < s.count - 1; i++)
        s.degree[i] = exact_divide(s.c + width * (size_t)i, s.degree[i], g, m);
    if (m > 0) mpz_set_ui(g[0], 1), s.degree[s.count - 1] = 0;
    return s;
}

static inline void exact_sturm_clear(exact_sturm *s) {
    size_t all = ((size_t)s->top + 1) * ((size_t)s->top + 2);
    for (size_t k = 0; k < all; k++) mpz_clear(s->c[k]);
    free(s->c), free(s->degree);
}

/* integers[k] = p[k] 2^shift for one shift, which is returned. */
static inline int exact_integers(mpz_t *integers, const double *p, int n) {
    int shift = 0;
    for (int k = 0; k <= n; k++) {
        int e;
        (void)frexp(p[k], &e);
        if (p[k] != 0 && 53 - e > shift) shift = 53 - e;
    }
    for (int k = 0; k <= n; k++) {
        int e;
        double f = frexp(p[k], &e);
        mpz_set_d(integers[k], ldexp(f, 53));
        if (p[k] != 0) mpz_mul_2exp(integers[k], integers[k], (unsigned long)(e - 53 + shift));
    }
    return shift;
}

static inline exact_sturm exact_sturm_of_doubles(const double *p, int n) {
    mpz_t *c = exact_polynomials(1, n + 1);
    (void)exact_integers(c, p, n);
    exact_sturm s = exact_sturm_of(c, n);
    exact_free(c, n + 1);
    return s;
}

/* The sign at x, which may be infinite, of sum p[k] x^k, n its degree. */
static inline int exact_integers_sign(mpz_t *p, int n, double x) {
    if (isinf(x)) return x > 0 || n % 2 == 0 ? mpz_sgn(p[n]) : -mpz_sgn(p[n]);
    int e;
    double f = frexp(x, &e);
    mpz_t value, m, term;
    mpz_inits(value, m, term, NULL);
    mpz_set_d(m, ldexp(f, 53));
    e = x == 0 ? 0 : e - 53;
    if (e > 0) mpz_mul_2exp(m, m, (unsigned long)e), e = 0;
    for (int k = n; k >= 0; k--) { /* 2^(-e n) p(x) */
        mpz_mul(value, value, m);
        mpz_mul_2exp(term, p[k], (unsigned long)(-e) * (unsigned long)(n - k));
        mpz_add(value, value, term);
    }
    int sign = mpz_sgn(value);
    mpz_clears(value, m, term, NULL);
    return sign;
}

static inline int exact_variations(const exact_sturm *s, double x) {
    int variations = 0, last = 0;
    for (int i = 0; i < s->count; i++) {
        int sign = exact_integers_sign(s->c + (size_t)i * ((size_t)s->top + 1), s->degree[i], x);
        variations += sign * last < 0;
        if (sign != 0) last = sign;
    }
    return variations;
}

/* Is x, finite, a root? */
static inline int exact_is_root(const exact_sturm *s, double x) {
    return exact_integers_sign(s->c, s->degree[0], x) == 0;
}

/* The number of distinct roots in [lo,hi], lo <= hi, either may be infinite; p must not be zero. */
static inline int exact_count_roots(const exact_sturm *s, double lo, double hi) {
    int at_lo = isfinite(lo) && exact_is_root(s, lo);
    return lo == hi ? at_lo : at_lo + exact_variations(s, lo) - exact_variations(s, hi);
}

/* The k-th root (k = 0, 1, ..) in [lo,hi], which has more than k: the double at or just below it, by
 * bisection: by variations, and once it is alone in (lo,hi] by the sign.  lo and hi are finite. */
static inline double exact_root(const exact_sturm *s, double lo, double hi, int k) {
    if (exact_is_root(s, lo) && k-- == 0) return lo;
    const int before = exact_variations(s, lo);
    int left = before, right = exact_variations(s, hi), last = 0;
    for (;;) {
        const int alone = left - right == 1;
        if (alone && last == 0) last = exact_integers_sign(s->c, s->degree[0], hi);
        if (alone && last == 0) return hi;
        double middle = 0.5 * lo + 0.5 * hi;
        if (!(middle > lo && middle < hi)) return exact_is_root(s, hi) ? hi : lo;
        const int now = alone ? exact_integers_sign(s->c, s->degree[0], middle) : exact_variations(s, middle);
        if (alone && now == 0) return middle;
        const int below = alone ? now == last : before - now > k;
        *(below ? &hi : &lo) = middle;
        if (!alone) *(below ? &right : &left) = now;
    }
}

#endif
