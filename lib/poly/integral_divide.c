/* integral_divide.c - exact division of polynomials, and of a polynomial by its content.
 *
 * Gauss: when b is primitive and divides a over the rationals, the quotient has integer coefficients.  So a
 * division in integers that ends with remainder 0 proves divisibility, and one that does not disproves it. */
#include "../base/arithmetic.h"
#include "integral_impl.h"

#include <stddef.h>
#include <string.h>

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

algsurf_z_factor *algsurf_zpoly_factors(algsurf_memory *m, const algsurf_zpoly *b) {
    algsurf_z_factor *f = algsurf_i_take(m, (size_t)(b->degree + 1) * sizeof *f);
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
    const algsurf_z_factor *factor = algsurf_zpoly_factors(m, b);
    algsurf_limb *r = take(m, w);
    if (!divider_new(m, w, &space) || !factor || !r) return 0;
    *divides = factor[b->degree].length && long_division(a, factor, b->degree, qbits, &space, r, q);
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
    if (!algsurf_zpoly_new(m, e, algsurf_z_width(qbits), &quotient)) return 0;
    algsurf_memory_mark mark = algsurf_memory_here(m);
    int done = try_division(m, a, b, w, qbits, divides, &quotient);
    algsurf_memory_release(m, done && *divides ? mark : start);
    if (done && *divides) {
        algsurf_zpoly_cut(&quotient, 0);
        *q = quotient;
    }
    return done;
}

/* ---- content ---- */

static int is_one(const algsurf_limb *a, int n) { return n == 1 && a[0] == 1; }

static algsurf_limb gcd_of_limbs(algsurf_limb a, algsurf_limb b) {
    while (b) {
        algsurf_limb rest = a % b;
        a = b, b = rest;
    }
    return a;
}

/* Euclid: gcd(x, y) of magnitudes of nx and ny limbs, both overwritten (with room for one limb more each);
 * returns which of the two it is in. */
static algsurf_limb *gcd(algsurf_limb *x, int nx, algsurf_limb *y, int ny, divider *d, int *length) {
    while (ny && !(nx == 1 && ny == 1)) {
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
    if (ny) x[0] = gcd_of_limbs(x[0], y[0]);
    *length = nx;
    return x;
}

/* The shortest coefficient but 0: a first bound of the content. */
static int shortest(const algsurf_zpoly *p) {
    int found = 0, least = ALGSURF_Z_NO_BIT;
    for (int k = 0; k <= p->degree; k++) {
        const algsurf_limb *a = algsurf_zpoly_at(p, k);
        int bits = algsurf_z_bits(a, p->width);
        if (bits >= least || algsurf_z_sign(a, p->width) == 0) continue;
        found = k, least = bits;
    }
    return found;
}

/* The content (>= 0) of p into x or y, w + 1 limbs each; returns which. */
static algsurf_limb *content_of(const algsurf_zpoly *p, algsurf_limb *x, algsurf_limb *y, divider *d,
                                int *length) {
    int w = p->width, first = shortest(p);
    *length = algsurf_z_factor_of(algsurf_zpoly_at(p, first), w, x).length;
    for (int k = p->degree; k >= 0 && !is_one(x, *length); k--) {
        if (k == first) continue;
        int ny = algsurf_z_factor_of(algsurf_zpoly_at(p, k), w, y).length;
        algsurf_limb *g = gcd(x, *length, y, ny, d, length);
        if (g == y) y = x, x = g;
    }
    return x;
}

int algsurf_zpoly_primitive(algsurf_memory *m, const algsurf_zpoly *p, algsurf_zpoly *primitive) {
    int w = p->width, n;
    if (!algsurf_zpoly_copy(m, p, w, primitive)) return 0;
    if (primitive->degree < 0) return 1;
    algsurf_memory_mark mark = algsurf_memory_here(m);
    divider d;
    algsurf_limb *x = take(m, w + 1), *y = take(m, w + 1);
    int done = divider_new(m, w, &d) && x && y;
    if (done) {
        const algsurf_limb *g = content_of(primitive, x, y, &d, &n);
        algsurf_z_factor content = {0, n, 0, g};
        for (int k = 0; k <= primitive->degree && n && !is_one(g, n); k++)
            (void)exact_quotient(&d, algsurf_zpoly_at(primitive, k), w, &content);
        algsurf_zpoly_cut(primitive, 0);
    }
    algsurf_memory_release(m, mark);
    return done;
}
