/* exact_complex.h - complex roots without rounding, and random polynomials to be judged by them.
 *
 * The judge.  Numbers have so many bits here that sums and products are exact; magnitudes and quotients are
 * rounded to Z_BITS.  From an approximation Newton's method finds a point z; the disc about it of radius
 * n |p/p'|, with p and p' exact, holds a root (Laguerre).
 */
#ifndef EXACT_COMPLEX_H
#define EXACT_COMPLEX_H
#include <string.h>

#include "exact.h"

enum { BITS = 16384, Z_BITS = 256 };
#define FOUND 0x1p-60 /* of the claimed radius: where Newton's method has come near enough */

/* ---- numbers without rounding ---- */

typedef struct point {
    mpf_t re, im;
} point;

static inline void init(point *a) { mpf_init2(a->re, BITS), mpf_init2(a->im, BITS); }

static inline void clear(point *a) { mpf_clear(a->re), mpf_clear(a->im); }

static inline void multiply(point *a, const point *b) {
    mpf_t s, t;
    mpf_init2(s, BITS), mpf_init2(t, BITS);
    mpf_mul(s, a->re, b->re), mpf_mul(t, a->im, b->im), mpf_sub(t, s, t);
    mpf_mul(s, a->re, b->im), mpf_mul(a->im, a->im, b->re), mpf_add(a->im, a->im, s);
    mpf_set(a->re, t);
    mpf_clear(s), mpf_clear(t);
}

static inline void add(point *a, const point *b) {
    mpf_add(a->re, a->re, b->re), mpf_add(a->im, a->im, b->im);
}

static inline double magnitude(const point *a) {
    mpf_t s, t;
    mpf_init2(s, Z_BITS), mpf_init2(t, Z_BITS);
    mpf_mul(s, a->re, a->re), mpf_mul(t, a->im, a->im), mpf_add(s, s, t), mpf_sqrt(s, s);
    double d = mpf_get_d(s);
    mpf_clear(s), mpf_clear(t);
    return d;
}

static inline void shorten(mpf_t a) {
    mpf_t t;
    mpf_init2(t, Z_BITS), mpf_set(t, a), mpf_set(a, t), mpf_clear(t);
}

/* a / b, rounded to Z_BITS; b loses what is beyond them. */
static inline void divide(point *a, point *b) {
    mpf_t square, t;
    mpf_init2(square, Z_BITS), mpf_init2(t, Z_BITS);
    shorten(a->re), shorten(a->im), shorten(b->re), shorten(b->im);
    mpf_mul(square, b->re, b->re), mpf_mul(t, b->im, b->im), mpf_add(square, square, t);
    mpf_neg(b->im, b->im);
    multiply(a, b);
    mpf_div(t, a->re, square), mpf_set(a->re, t);
    mpf_div(t, a->im, square), mpf_set(a->im, t);
    mpf_clear(square), mpf_clear(t);
}

/* ---- polynomials ---- */

enum { MOST = 16 };

typedef struct problem {
    int n, real;
    double re[MOST + 1], im[MOST + 1], spread;
    double change; /* of coefficient `which`: the polynomial that is meant; at most spread */
    int which;
} problem;

/* p(z), p'(z). */
static inline void values(const problem *p, const point *z, point *v, point *d) {
    mpf_set_d(v->re, 0), mpf_set_d(v->im, 0), mpf_set_d(d->re, 0), mpf_set_d(d->im, 0);
    point c;
    init(&c);
    for (int k = p->n; k >= 0; k--) {
        multiply(d, z), add(d, v);
        multiply(v, z);
        mpf_set_d(c.re, p->re[k]), mpf_set_d(c.im, p->im[k]);
        add(v, &c);
        mpf_set_d(c.re, k == p->which ? p->change : 0), mpf_set_d(c.im, 0);
        add(v, &c);
    }
    clear(&c);
}

/* A root near x + iy; returns the radius of the disc that it is in, if it could be found, at most `enough`.
 */
static inline double find_root(const problem *p, double x, double y, double enough, point *z) {
    point v, d;
    double radius = HUGE_VAL;
    init(&v), init(&d);
    mpf_set_d(z->re, x), mpf_set_d(z->im, y);
    for (int k = 0; k < 200; k++) {
        values(p, z, &v, &d);
        if (magnitude(&d) == 0) break;
        divide(&v, &d);
        radius = 1.001 * p->n * magnitude(&v);
        if (radius <= enough) break;
        mpf_sub(z->re, z->re, v.re), mpf_sub(z->im, z->im, v.im);
        shorten(z->re), shorten(z->im);
    }
    clear(&v), clear(&d);
    return radius;
}

/* ---- cases ---- */

static uint64_t sequence = 1;

static inline double uniform(void) { return random_unit(&sequence); }

static inline int below(int n) { return random_int(&sequence, n); }

enum { PLAIN, INTEGERS, CLUSTERED, SPARSE, TINY_LEAD, WILD, DOUBLED, KINDS };

/* p times w - z, or for real p and y != 0 times (w - z)(w - conj z). */
static inline void times_root(problem *p, double x, double y) {
    double re[MOST + 3] = {0}, im[MOST + 3] = {0}; /* from p[-2] on */
    int pair = p->real && y != 0;
    for (int k = 0; k <= p->n; k++) re[k + 2] = p->re[k], im[k + 2] = p->im[k];
    p->n += 1 + pair;
    for (int k = 0; k <= p->n; k++) {
        double a = k <= p->n - 1 - pair ? re[k + 2] : 0, b = k <= p->n - 1 - pair ? im[k + 2] : 0;
        p->re[k] = pair ? re[k] - 2 * x * re[k + 1] + (x * x + y * y) * a : re[k + 1] - (x * a - y * b);
        p->im[k] = pair ? 0 : im[k + 1] - (x * b + y * a);
    }
}

static inline problem random_problem(int n, int kind, int real) {
    problem p = {.real = real, .re = {1}};
    if (kind == CLUSTERED || kind == DOUBLED) {
        double x = uniform(), y = uniform(), apart = kind == DOUBLED ? 0 : ldexp(1, -2 - below(24));
        while (p.n < n) {
            int close = p.n < 4;
            double a = close ? x + apart * uniform() : 2 * uniform(),
                   b = close ? y + apart * uniform() : uniform();
            if (kind == DOUBLED && close) a = x, b = 0;
            times_root(&p, a, real && (p.n + 2 > n || below(2)) ? 0 : b);
        }
        return p;
    }
    p.n = n;
    for (int k = 0; k <= n; k++) {
        int e = kind == WILD ? below(2040) - 1060 : 0;
        double big = kind == INTEGERS ? 100 : 1;
        p.re[k] = ldexp(kind == INTEGERS ? rint(big * uniform()) : uniform(), e);
        p.im[k] = real ? 0 : ldexp(kind == INTEGERS ? rint(big * uniform()) : uniform(), e);
        if (kind == SPARSE && below(2)) p.re[k] = p.im[k] = 0;
    }
    if (kind == TINY_LEAD) {
        double by = below(3) ? ldexp(1, -below(400)) : 0;
        p.re[n] *= by, p.im[n] *= by;
    }
    return p;
}

#endif
