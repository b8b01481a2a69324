/* multiple.c - exactly multiple roots of a real polynomial with exact coefficients, each in a box of its own.
 *
 * Idea: doubles cannot tell a root of multiplicity k from k roots within about (u^2 cond)^(1/k), so the
 * solver returns a cluster.  Integers can: p = constant * prod f_k^k, where the squarefree f_k holds the
 * roots of multiplicity exactly k, once each (Yun 1976, poly/multiplicity.c).  The roots of f_k are simple,
 * and the solver isolates them to a few units in the last place.
 *
 * Proof.  A coefficient is m 2^e with integers m, e: a power of two times p(2^unit y) is in Z[y] without any
 * rounding, and the f_k are exact.  The solver is given f_k with its coefficients rounded and radii that hold
 * them, so each of its boxes holds as many roots of f_k as it says, and k times as many of p, counted with
 * multiplicities.  A root of p is a root of exactly one f_k: the boxes of all factors together hold all roots
 * of p.  Boxes that meet become one (algsurf_i_roots_join); when they are disjoint, each holds the roots that
 * were counted in it, and no others.
 *
 * The answer with the cluster is as true as this one: it stays where memory does not suffice, or a factor has
 * no boxes within the range of double, or its roots are no easier to tell apart. */
#include "../base/arithmetic.h"
#include <float.h>
#include <limits.h>
#include <math.h>
#include <string.h>

#include "../base/fpenv.h"
#include "../poly/integral.h"
#include "impl.h"

#define OWN_WORDS ((size_t)(16 << 10) / sizeof(uint64_t)) /* on the stack: enough for short coefficients */
#define MEMORY_LIMIT ((size_t)1 << 30)

typedef struct separation {
    algsurf_i_roots *p;           /* the solver, to be used again */
    const algsurf_i_input *whole; /* the polynomial */
    int unit;                     /* x = 2^unit y; factors are polynomials in y */
    algsurf_memory *m;
    algsurf_zpoly *share;       /* share[i]: the roots of multiplicity above i */
    algsurf_complex *c;         /* a factor's coefficients, */
    double *r;                  /* their radii */
    algsurf_complex_root *work; /* the solver's */
    algsurf_complex_root *found;
    int count;
} separation;

static void *take(algsurf_memory *m, size_t bytes) {
    return algsurf_memory_take(m, (bytes + sizeof(uint64_t) - 1) / sizeof(uint64_t));
}

static int take_all(separation *s, int n) {
    size_t terms = (size_t)n + 1;
    s->share = take(s->m, terms * sizeof *s->share);
    s->c = take(s->m, terms * sizeof *s->c);
    s->r = take(s->m, terms * sizeof *s->r);
    s->found = take(s->m, terms * sizeof *s->found);
    return s->share && s->c && s->r && s->found;
}

static int is_exact_and_real(const algsurf_i_input *in) {
    for (int k = in->low; k <= in->high; k++)
        if (in->c[k].im != 0 || (in->r && in->r[k] != 0)) return 0;
    return 1;
}

static int is_point(const algsurf_cinterval *b) { return b->re.lo == b->re.hi && b->im.lo == b->im.hi; }

static int is_zero(const algsurf_cinterval *b) { return is_point(b) && b->re.lo == 0 && b->im.lo == 0; }

static int has_cluster(const algsurf_complex_root *roots, int count) {
    for (int i = 0; i < count; i++)
        if (roots[i].multiplicity > 1 && !is_point(&roots[i].box)) return 1;
    return 0;
}

/* ---- the polynomial in integers ---- */

/* The coefficient of y^k is odd 2^exponent, but for its sign; 0: there is none. */
static algsurf_limb term(const separation *s, int k, int *exponent) {
    algsurf_limb odd = algsurf_z_odd_part(s->whole->c[s->whole->low + k].re, exponent);
    *exponent += k * s->unit;
    return odd;
}

/* p(2^unit y) 2^-least, where 2^least is the largest power of two that divides all coefficients. */
static int make_integral(const separation *s, algsurf_zpoly *z) {
    int n = s->whole->high - s->whole->low, least = INT_MAX, end = INT_MIN, e;
    for (int k = 0; k <= n; k++) {
        algsurf_limb odd = term(s, k, &e);
        if (!odd) continue;
        int top = e + algsurf_limb_bits(odd);
        least = e < least ? e : least;
        end = top > end ? top : end;
    }
    if (!algsurf_zpoly_new(s->m, n, algsurf_z_width(end - least), z)) return 0;
    for (int k = 0; k <= n; k++)
        algsurf_z_add_double(algsurf_zpoly_at(z, k), z->width, s->whole->c[s->whole->low + k].re,
                             k * s->unit - least);
    return 1;
}

/* f: the roots of multiplicity exactly k, once each.  Quotients are integral when what divides is primitive
 * (Gauss). */
static int make_factor(const separation *s, int count, int k, algsurf_zpoly *f) {
    int divides;
    algsurf_zpoly higher;
    if (!algsurf_zpoly_primitive(s->m, s->share + k - 1, f)) return 0;
    if (k == count) return 1;
    if (!algsurf_zpoly_primitive(s->m, s->share + k, &higher)) return 0;
    return algsurf_zpoly_divide(s->m, f, &higher, &divides, f) && divides;
}

/* ---- a factor's roots ---- */

/* f times a power of two, rounded; the radii hold what was lost.  The largest coefficient is just below
 * 2^1000, so that only those 2^2000 times smaller lose more than their last bits. */
static algsurf_i_input round_factor(const separation *s, const algsurf_zpoly *f) {
    int e = 1000 - algsurf_zpoly_bits(f);
    for (int k = 0; k <= f->degree; k++) {
        const algsurf_limb *a = algsurf_zpoly_at(f, k);
        double below = algsurf_z_round_down(a, f->width, e), above = algsurf_z_round_up(a, f->width, e);
        s->c[k] = (algsurf_complex){below, 0};
        s->r[k] = above - below; /* exact: 0, or neighbours */
    }
    return (algsurf_i_input){.c = s->c, .r = s->r, .high = f->degree, .real_radii = 1, .unit = s->unit};
}

static int solve_factor(separation *s, const algsurf_zpoly *f, int k) {
    int count;
    algsurf_i_input in = round_factor(s, f);
    algsurf_complex_root *e = s->found + s->count;
    if (algsurf_i_roots_solve(s->p, &in, NULL, s->work, e, &count) != ALGSURF_OK) return 0;
    for (int i = 0; i < count; i++) e[i].multiplicity *= k;
    s->count += count;
    return 1;
}

static algsurf_interval shared(algsurf_interval a, algsurf_interval b) {
    return (algsurf_interval){fmax(a.lo, b.lo), fmin(a.hi, b.hi)};
}

static double clamp(double x, algsurf_interval to) { return fmin(fmax(x, to.lo), to.hi); }

static int meet(const algsurf_cinterval *a, const algsurf_cinterval *b) {
    return a->re.lo <= b->re.hi && b->re.lo <= a->re.hi && a->im.lo <= b->im.hi && b->im.lo <= a->im.hi;
}

/* f_1's only box that meets `old`; null: there are several. */
static algsurf_complex_root *only_one(const separation *s, const algsurf_cinterval *old) {
    algsurf_complex_root *one = NULL;
    for (int i = 0; i < s->count; i++) {
        if (!meet(&s->found[i].box, old)) continue;
        if (one) return NULL;
        one = s->found + i;
    }
    return one;
}

/* A simple root in an isolating box of the first answer is a root of f_1: if only one of f_1's boxes meets
 * that box, and holds one root, then it is this root, in what the boxes share.  So no simple root comes out
 * in a wider box than before, even where the rounding of f_1 was much. */
static void narrow_simple(separation *s, const algsurf_complex_root *roots, int count) {
    for (int i = 0; i < count; i++) {
        if (roots[i].multiplicity > 1 || is_zero(&roots[i].box)) continue; /* the root 0 is not one of f_1 */
        algsurf_complex_root *e = only_one(s, &roots[i].box);
        if (!e || e->multiplicity > 1) continue;
        e->box = (algsurf_cinterval){shared(e->box.re, roots[i].box.re), shared(e->box.im, roots[i].box.im)};
        e->root = (algsurf_complex){clamp(e->root.re, e->box.re), clamp(e->root.im, e->box.im)};
        e->real = e->real || roots[i].real;
    }
}

/* The first answer's simple roots in place of f_1's, if all of them are isolated there. */
static void keep_simple(separation *s, const algsurf_complex_root *roots, int count, int wanted) {
    int isolated = 0;
    for (int i = 0; i < count; i++) isolated += roots[i].multiplicity == 1 && !is_zero(&roots[i].box);
    if (isolated < wanted) return;
    s->count = 0;
    for (int i = 0; i < count; i++)
        if (roots[i].multiplicity == 1 && !is_zero(&roots[i].box)) s->found[s->count++] = roots[i];
}

/* All factors but constant ones, the lowest multiplicity first; what each took is given back. */
static int solve_factors(separation *s, int highest, const algsurf_complex_root *roots, int count) {
    for (int k = 1; k <= highest; k++) {
        int degree = s->share[k - 1].degree - (k < highest ? s->share[k].degree : 0);
        if (degree == 0) continue;
        algsurf_memory_mark mark = algsurf_memory_here(s->m);
        algsurf_zpoly f;
        int done = make_factor(s, highest, k, &f) && solve_factor(s, &f, k);
        algsurf_memory_release(s->m, mark);
        if (!done) return 0;
        if (k == 1 && s->count < degree) keep_simple(s, roots, count, degree);
        if (k == 1) narrow_simple(s, roots, count);
    }
    return 1;
}

static double middle(algsurf_interval x) {
    return fmin(fmax(clamp(0.5 * x.lo + 0.5 * x.hi, x), -DBL_MAX), DBL_MAX);
}

/* Disjoint boxes. */
static void join(separation *s) {
    int before = s->count;
    if (s->whole->low > 0)
        s->found[s->count++] = (algsurf_complex_root){.multiplicity = s->whole->low, .real = 1};
    s->count = algsurf_i_roots_join(s->found, s->count, 1);
    if (s->count == before + (s->whole->low > 0)) return;
    for (int i = 0; i < s->count; i++) {
        algsurf_complex_root *e = s->found + i;
        if (e->multiplicity > 1) e->root = (algsurf_complex){middle(e->box.re), middle(e->box.im)};
    }
}

/* 1: s->found has all roots of a polynomial that is not squarefree. */
static int separate(separation *s, const algsurf_complex_root *roots, int count) {
    algsurf_zpoly z;
    int highest;
    if (!take_all(s, s->whole->high - s->whole->low + 1) || !make_integral(s, &z)) return 0;
    if (!algsurf_zpoly_multiplicities(s->m, &z, s->share, &highest) || highest < 2) return 0;
    if (!solve_factors(s, highest, roots, count)) return 0;
    join(s);
    return 1;
}

ALGSURF_NOINLINE void algsurf_i_roots_separate(algsurf_i_roots *p, const algsurf_i_input *in,
                                               algsurf_complex_root *boxes, algsurf_complex_root *roots,
                                               int *count) {
    uint64_t own[OWN_WORDS];
    algsurf_memory m;
    if (!has_cluster(roots, *count) || !is_exact_and_real(in)) return;
    algsurf_memory_begin(&m, own, OWN_WORDS, MEMORY_LIMIT);
    algsurf_memory_mark start = algsurf_memory_here(&m);
    separation s = {.p = p, .whole = in, .unit = algsurf_i_roots_unit(in), .m = &m, .work = boxes};
    if (separate(&s, roots, *count) && s.count >= *count) {
        *count = s.count;
        algsurf_i_roots_sort(s.found, s.count);
        memcpy(roots, s.found, (size_t)s.count * sizeof *roots);
    }
    algsurf_memory_release(&m, start);
}
