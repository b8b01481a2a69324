/* factors.c - polynomials with multiple roots, by factors that have none; complex ones with real roots.
 *
 * Real ones: p is a constant times prod f_k^k, where the squarefree f_k holds the roots of multiplicity k,
 * once each (Yun 1976, poly/multiplicity.c); each f_k is solved by itself.
 *
 * Others: p = a + ib with a, b in Z[x], g = gcd(a, b), p = g h.  The real g has the real roots, and those
 * that have their conjugates with them; it is solved like that.  h = u + iv has no real root and none
 * together with its conjugate, as both u and v would vanish there, which have no common factor.  If it is
 * squarefree it is solved as it is.  If not, the roots of N = u^2 + v^2 = h h* are those of h, with their
 * multiplicities, and their conjugates: of each pair, h vanishes at one.  At the other it is shown not to:
 * |h(z)| exceeds its change over a disc that holds the root, R sum k |c_k| (|z| + R)^(k-1). */
#include "../base/arithmetic.h"

#include "../poly/residue.h"
#include "discs.h"

/* What is said of z->p. */
static int make_heads(algsurf_memory *m, algsurf_i_integers *z) {
    const size_t terms = (size_t)z->re.degree + 1;
    const int w = z->re.width;
    z->bits = algsurf_i_take(m, terms * sizeof *z->bits);
    z->head = algsurf_i_take(m, 2 * terms * sizeof *z->head);
    z->exact = algsurf_i_take(m, terms);
    if (!z->bits || !z->head || !z->exact) return 0;
    z->size = z->head + terms;
    for (int k = 0; k <= z->re.degree; k++) {
        const algsurf_limb *x = algsurf_zpoly_at(&z->re, k),
                           *y = z->im.c ? algsurf_zpoly_at(&z->im, k) : NULL;
        z->head[k] = algsurf_i_head(x, y, w, 0);
        z->size[k] = size_of(z->head[k]);
        z->bits[k] = is_zero(z->head[k]) ? -1 : algsurf_i_bits(x, y, w);
        z->exact[k] = (unsigned char)algsurf_i_head_is_exact(x, y, w);
    }
    return 1;
}

int algsurf_i_make_integers(algsurf_memory *m, const algsurf_zpoly *u, const algsurf_zpoly *v,
                            algsurf_i_integers *z) {
    const algsurf_zpoly *part[2] = {u, v};
    *z = (algsurf_i_integers){.re = *u, .real = !v};
    if (!v) return make_heads(m, z);
    int n = u->degree > v->degree ? u->degree : v->degree, w = u->width > v->width ? u->width : v->width;
    if (!algsurf_zpoly_new(m, n, w, &z->re) || !algsurf_zpoly_new(m, n, w, &z->im)) return 0;
    for (int i = 0; i < 2; i++)
        for (int k = 0; k <= part[i]->degree; k++)
            algsurf_z_copy(algsurf_zpoly_at(i ? &z->im : &z->re, k), w, algsurf_zpoly_at(part[i], k),
                           part[i]->width);
    return make_heads(m, z);
}

/* ---- is there a multiple root? ---- */

/* A square root of -1 modulo the next prime that has one; 0: this one has none. */
static algsurf_limb root_of_minus_one(const algsurf_prime *q) {
    if (q->p % 4 != 1) return 0;
    for (algsurf_limb a = 2;; a++) { /* a^((q-1)/4) for one of every two a */
        algsurf_limb i = algsurf_residue_power(algsurf_residue_times(a, q->square, q), (q->p - 1) / 4, q);
        if (algsurf_residue_times(i, i, q) == q->p - q->one) return i;
    }
}

/* gcd(p, p') is constant modulo a prime ideal of Z[i] that does not divide the leading coefficient: no root
 * is multiple.  Two images at most; if neither shows it, p has a multiple root, or luck was bad. */
static int is_squarefree(algsurf_memory *m, const algsurf_i_integers *p, int *answer) {
    const int n = p->re.degree;
    algsurf_memory_mark mark = algsurf_memory_here(m);
    algsurf_limb *x = algsurf_memory_take(m, 3 * (size_t)(n + 1)), *y = x + n + 1, *derivative = y + n + 1,
                 *gcd;
    if (!x) return 0;
    *answer = 0;
    algsurf_prime q = algsurf_prime_first();
    for (int tries = 0; tries < 2 && !*answer; q = algsurf_prime_next(&q)) {
        algsurf_limb i = root_of_minus_one(&q);
        if (!i) continue;
        algsurf_residues_of(x, p->re.c, n + 1, p->re.width, &q);
        algsurf_residues_of(y, p->im.c, n + 1, p->re.width, &q);
        for (int k = 0; k <= n; k++)
            x[k] = algsurf_residue_minus(x[k], algsurf_residue_times(i, q.p - y[k], &q), &q);
        tries++;
        if (x[n] == 0) continue;
        algsurf_residues_derive(derivative, x, n, &q);
        *answer = n < 2 || algsurf_residues_gcd(x, n, derivative, n - 1, &gcd, &q) == 0;
    }
    algsurf_memory_release(m, mark);
    return 1;
}

/* ---- one factor ---- */

/* h is not 0 within R of z, as sums of w limbs tell. */
static int is_no_root(algsurf_i_sums *sums, const algsurf_i_integers *h, const algsurf_i_point *z,
                      algsurf_scaled R, int w, int *answer) {
    algsurf_scaled far = sum(size_of(z->head), R), change = scaled_none();
    if (!algsurf_i_taylor(sums, h, z, 0, w)) return 0;
    for (int k = h->re.degree; k > 0; k--) change = sum(times(change, far), by(h->size[k], k));
    change = sum(times(change, R), sums->lost);
    *answer = less(by(change, 1 + 0x1p-20), size_of(algsurf_i_sum_head(sums->at)));
    return 1;
}

/* Leaves out the roots that h has not; *told: that is known of each. */
static int choose(algsurf_i_discs *d, const algsurf_i_integers *h, int *told) {
    *told = 1;
    for (int i = 0; i < d->n && *told; i++) {
        algsurf_i_disc *root = d->root + i;
        algsurf_i_point z = {.room = 0};
        int is_out, mate_is_out;
        algsurf_scaled R;
        if (!is_alone(d, i)) return !(*told = 0);
        if (!algsurf_i_centre(d, i, 0, &z, &R)) return 0;
        const int w = z.w + 3 + (int)(d->more / 64);
        if (!is_no_root(&d->sums, h, &z, R, w, &is_out)) return 0;
        if (!algsurf_i_set_conjugate(d->m, &z, &z)) return 0;
        if (!is_no_root(&d->sums, h, &z, R, w, &mate_is_out)) return 0;
        root->left_out = (unsigned char)is_out;
        *told = is_out != mate_is_out;
    }
    return 1;
}

/* The same of each: h is 0 at one of two conjugates only, so discs that are narrow enough, and sums that are
 * long enough, tell at which. */
static int choose_all(algsurf_i_discs *d, const algsurf_i_integers *h) {
    for (int told, open;; d->more += d->more + 64) {
        if (!algsurf_i_discs_run(d, ALGSURF_I_MOST_SWEEPS, &open) || !choose(d, h, &told)) return 0;
        if (told) return 1;
    }
}

/* The roots of f, which is squarefree; h not null: those that h has, too. */
static int solve_factor(algsurf_memory *m, algsurf_i_integers *f, int multiplicity,
                        const algsurf_i_integers *h, algsurf_i_answer *answer) {
    algsurf_i_discs d;
    int open;
    if (!algsurf_i_discs_separate(&d, m, f, ALGSURF_I_MOST_SWEEPS, &open, &answer->proposed)) return 0;
    if (h && !choose_all(&d, h)) return 0;
    if (h) f->real = 0;
    return algsurf_i_deliver(&d, multiplicity, answer);
}

/* ---- all factors ---- */

/* f: the roots of multiplicity exactly k, once each.  Quotients are integral when what divides is primitive
 * (Gauss). */
static int make_factor(algsurf_memory *m, const algsurf_zpoly *share, int count, int k, algsurf_zpoly *f) {
    int divides;
    algsurf_zpoly higher;
    if (!algsurf_zpoly_primitive(m, share + k - 1, f)) return 0;
    if (k == count) return 1;
    if (!algsurf_zpoly_primitive(m, share + k, &higher)) return 0;
    return algsurf_zpoly_divide(m, f, &higher, &divides, f) && divides;
}

/* Each share of the roots of p by itself, if there are multiple ones, or h is given. */
static int solve_shares(algsurf_memory *m, const algsurf_zpoly *p, const algsurf_i_integers *h, int always,
                        algsurf_i_answer *answer) {
    int highest;
    algsurf_memory_mark mark = algsurf_memory_here(m);
    algsurf_zpoly *share = algsurf_i_take(m, (size_t)(p->degree + 1) * sizeof *share), f;
    algsurf_i_integers z;
    if (!share || !algsurf_zpoly_multiplicities(m, p, share, &highest)) return 0;
    for (int k = 1; k <= highest && (always || highest > 1); k++) {
        algsurf_memory_mark before = algsurf_memory_here(m);
        if (share[k - 1].degree == (k < highest ? share[k].degree : 0)) continue;
        if (!make_factor(m, share, highest, k, &f) || !algsurf_i_make_integers(m, &f, NULL, &z) ||
            !solve_factor(m, &z, k, h, answer))
            return 0;
        algsurf_memory_release(m, before);
    }
    algsurf_memory_release(m, mark);
    return 1;
}

/* N = u^2 + v^2. */
static int make_norm(algsurf_memory *m, const algsurf_zpoly *u, const algsurf_zpoly *v, algsurf_zpoly *N) {
    const algsurf_zpoly *part[2] = {u, v};
    int n = u->degree > v->degree ? u->degree : v->degree, w = u->width > v->width ? u->width : v->width;
    if (!algsurf_zpoly_new(m, 2 * n, 2 * w + 1, N)) return 0;
    for (int i = 0; i < 2; i++) {
        const algsurf_z_factor *f = algsurf_zpoly_factors(m, part[i]);
        if (!f) return 0;
        for (int k = 0; k <= part[i]->degree; k++)
            for (int j = 0; j <= part[i]->degree; j++)
                algsurf_z_add_times(algsurf_zpoly_at(N, j + k), N->width, algsurf_zpoly_at(part[i], j),
                                    part[i]->width, f + k, 0);
    }
    return 1;
}

int algsurf_i_solve_factors(algsurf_memory *m, const algsurf_i_integers *p, algsurf_i_answer *answer) {
    int squarefree, common;
    algsurf_zpoly N;
    algsurf_i_integers h;
    if (!p->im.c) return solve_shares(m, &p->re, NULL, 0, answer);
    if (!is_squarefree(m, p, &squarefree)) return 0;
    if (squarefree && !algsurf_zpoly_gcd_degree(m, &p->re, &p->im, 2, &common)) return 0;
    if (squarefree && common == 0) return 1;
    algsurf_memory_mark mark = algsurf_memory_here(m);
    algsurf_parts parts = {.u = algsurf_zpoly_trimmed(&p->re), .v = algsurf_zpoly_trimmed(&p->im)};
    if (parts.u.degree > 0 && parts.v.degree > 0 && !algsurf_zpoly_split(m, &p->re, &p->im, &parts)) return 0;
    if (parts.g.degree > 0 && !solve_shares(m, &parts.g, NULL, 1, answer)) return 0;
    if (!algsurf_i_make_integers(m, &parts.u, &parts.v, &h)) return 0;
    if (h.re.degree > 0 && squarefree && !solve_factor(m, &h, 1, NULL, answer)) return 0;
    if (h.re.degree > 0 && !squarefree &&
        (!make_norm(m, &parts.u, &parts.v, &N) || !solve_shares(m, &N, &h, 1, answer)))
        return 0;
    algsurf_memory_release(m, mark);
    return 1;
}
