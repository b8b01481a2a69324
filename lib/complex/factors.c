/* factors.c - polynomials with multiple roots, by factors that have none; complex ones with real roots.
 *
 * Real ones: p is a constant times prod f_k^k, where the squarefree f_k holds the roots of multiplicity k,
 * once each (Yun 1976, poly/multiplicity.c); each f_k is solved by itself.
 *
 * Others: p = a + ib with a, b in Z[x], g = gcd(a, b), p = g h.  The real g has the real roots, and those
 * that have their conjugates with them; it is solved like that.  h has no real root and none together with
 * its conjugate.  Let h* be h with the conjugate coefficients, which has the conjugate roots.  If N = h h* is
 * squarefree, so is h, which is solved as it is.  If not, N, which is real, is solved like g.  Boxes of roots
 * that g and N have in common are joined as they meet; where they cannot be, p p* takes the place of both.
 *
 * A root has in p p* the multiplicities that it and its conjugate have in p, together.  That in p is at most
 * i if derivative i of p is not 0 there; where what is known so of a root and its conjugate adds up to what
 * both have together, it is exact.  Derivatives are shown not to vanish: |h(z)| exceeds its change over a
 * disc that holds the root, R sum k |c_k| (|z| + R)^(k-1). */
#include "../base/arithmetic.h"

#include "discs.h"

/* What doubles say of z. */
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

/* The roots' multiplicities, k of each and its conjugate together, by p and its derivatives h, of which the
 * last is constant; *told: they are known. */
static int set_multiplicities(algsurf_i_discs *d, int k, const algsurf_i_integers *h, int *told) {
    *told = 1;
    for (int i = 0; i < d->n && *told; i++) {
        int *most = d->root[i].multiplicity, differs;
        algsurf_i_point z[2] = {{.room = 0}, {.room = 0}};
        algsurf_scaled R;
        if (!is_alone(d, i)) return !(*told = 0);
        if (!algsurf_i_centre(d, i, 0, z, &R) || !algsurf_i_set_conjugate(d->m, z + 1, z)) return 0;
        const int w = z[0].w + 3 + (int)(d->more / 64);
        most[0] = most[1] = k;
        for (int j = 0; j < k && most[0] + most[1] > k; j++)
            for (int mate = 0; mate < 2; mate++) {
                if (most[mate] < k) continue;
                if (!is_no_root(&d->sums, h + j, z + mate, R, w, &differs)) return 0;
                if (differs) most[mate] = j;
            }
        *told = most[0] + most[1] == k;
    }
    return 1;
}

/* The roots of f, which is squarefree: those of multiplicity k; h not null: together with their conjugates.
 * Discs that are narrow enough, and sums that are long enough, tell the multiplicities. */
static int solve_factor(algsurf_memory *m, algsurf_i_integers *f, int k, const algsurf_i_integers *h,
                        algsurf_i_answer *answer) {
    algsurf_i_discs d;
    int open, told = !h;
    if (!algsurf_i_discs_separate(&d, m, f, ALGSURF_I_MOST_SWEEPS, &open, &answer->proposed)) return 0;
    for (int i = 0; i < d.n; i++) d.root[i].multiplicity[0] = d.root[i].multiplicity[1] = k;
    for (; !told; d.more += d.more + 64)
        if (!algsurf_i_discs_run(&d, ALGSURF_I_MOST_SWEEPS, &open) || !set_multiplicities(&d, k, h, &told))
            return 0;
    return algsurf_i_deliver(&d, answer);
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

/* p and its derivatives, `count` in all at most; null: no memory. */
static algsurf_i_integers *derivatives_of(algsurf_memory *m, const algsurf_i_integers *p, int count) {
    algsurf_i_integers *h = algsurf_i_take(m, (size_t)count * sizeof *h);
    algsurf_zpoly u, v;
    if (h) h[0] = *p;
    for (int i = 1; h && i < count && i <= p->re.degree; i++)
        if (!algsurf_zpoly_derivative(m, &h[i - 1].re, &u) ||
            !algsurf_zpoly_derivative(m, &h[i - 1].im, &v) || !algsurf_i_make_integers(m, &u, &v, h + i))
            return NULL;
    return h;
}

/* Each share of the roots of p by itself, if there are multiple ones, or always; `of` not null: p is the
 * product of that and its conjugate. */
static int solve_shares(algsurf_memory *m, const algsurf_zpoly *p, const algsurf_i_integers *of, int always,
                        algsurf_i_answer *answer) {
    int highest;
    algsurf_memory_mark mark = algsurf_memory_here(m);
    algsurf_zpoly *share = algsurf_i_take(m, (size_t)(p->degree + 1) * sizeof *share), f;
    algsurf_i_integers z, *h = NULL;
    if (!share || !algsurf_zpoly_multiplicities(m, p, share, &highest)) return 0;
    if (of && !(h = derivatives_of(m, of, highest))) return 0;
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

/* N = p p*. */
static int make_norm(algsurf_memory *m, const algsurf_i_integers *p, algsurf_zpoly *N) {
    const algsurf_zpoly *part[2] = {&p->re, &p->im};
    const int n = p->re.degree, w = p->re.width;
    if (!algsurf_zpoly_new(m, 2 * n, 2 * w + 1, N)) return 0;
    for (int i = 0; i < 2; i++) {
        const algsurf_z_factor *f = algsurf_zpoly_factors(m, part[i]);
        if (!f) return 0;
        for (int k = 0; k <= n; k++)
            for (int j = 0; j <= n; j++)
                algsurf_z_add_times(algsurf_zpoly_at(N, j + k), N->width, algsurf_zpoly_at(part[i], j), w,
                                    f + k, 0);
    }
    return 1;
}

int algsurf_i_solve_factors(algsurf_memory *m, const algsurf_i_integers *p, algsurf_i_answer *answer) {
    int multiple = 0, shared = 0;
    algsurf_zpoly N, all;
    algsurf_i_integers h;
    if (!p->im.c) return solve_shares(m, &p->re, NULL, 0, answer);
    algsurf_memory_mark mark = algsurf_memory_here(m);
    algsurf_parts parts = {.u = algsurf_zpoly_trimmed(&p->re), .v = algsurf_zpoly_trimmed(&p->im)};
    if (parts.u.degree > 0 && parts.v.degree > 0 && !algsurf_zpoly_split(m, &p->re, &p->im, &parts)) return 0;
    const algsurf_zpoly *g = &parts.g;
    if (!algsurf_i_make_integers(m, &parts.u, &parts.v, &h) || !make_norm(m, &h, &N)) return 0;
    if (N.degree > 0 && !algsurf_zpoly_gcd_degree(m, &N, NULL, 2, &multiple)) return 0;
    if (answer->precise && g->degree > 0 && N.degree > 0 && !algsurf_zpoly_gcd_degree(m, &N, g, 2, &shared))
        return 0;
    if (shared) {
        if (!make_norm(m, p, &all) || !solve_shares(m, &all, p, 1, answer)) return 0;
    } else {
        if (g->degree > 0 && !solve_shares(m, g, NULL, 1, answer)) return 0;
        if (multiple && !solve_shares(m, &N, &h, 1, answer)) return 0;
        if (!multiple && g->degree > 0 && N.degree > 0 && !solve_factor(m, &h, 1, NULL, answer)) return 0;
    }
    algsurf_memory_release(m, mark);
    return 1;
}
