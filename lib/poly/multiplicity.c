/* multiplicity.c - the roots of an integral polynomial by their multiplicities.
 *
 * Yun 1976, on the fraction p'/p instead of p: let v / u = p' / p with u = p / gcd(p, p').  Then
 * v / u = sum m_r / (x - r) over the roots r of p, with their multiplicities m_r, and v = m_r u' at r:
 * gcd(u, v - k u') has the roots of multiplicity k.  Dividing both by it, and adding k u' again, leaves a
 * fraction of the same kind with the roots of higher multiplicity.  When these all have one multiplicity, it
 * is their share of the degree divided by their number, and v = m u' proves it at once: p = q^m needs no gcd
 * but the first, all of whose numbers are as short as q.
 */
#include "../base/arithmetic.h"
#include "integral_impl.h"

/* The roots of u have multiplicities of at least `least` in p, `share` together, and v = sum m_r u / (x - r).
 */
typedef struct chain {
    algsurf_memory *m;
    algsurf_zpoly u, v;
    int least, share;
} chain;

/* z = v + k u'. */
static int combination(algsurf_memory *m, const algsurf_zpoly *v, int k, const algsurf_zpoly *u,
                       algsurf_zpoly *z) {
    algsurf_limb size = (algsurf_limb)(k < 0 ? -k : k);
    int slope = algsurf_zpoly_bits(u) + bits_of_int(u->degree) + algsurf_limb_bits(size);
    int w = algsurf_z_width(larger(algsurf_zpoly_bits(v), slope) + 2);
    if (!algsurf_zpoly_new(m, u->degree - 1, w, z)) return 0;
    for (int j = 0; j < u->degree; j++) {
        algsurf_limb *to = algsurf_zpoly_at(z, j), *from = algsurf_zpoly_at(u, j + 1);
        if (j <= v->degree) algsurf_z_copy(to, w, algsurf_zpoly_at(v, j), v->width);
        algsurf_z_join_product(to, w, from, u->width, size * (algsurf_limb)(j + 1), 0, k < 0);
    }
    *z = algsurf_zpoly_trimmed(z);
    return 1;
}

/* Have all roots of u the same multiplicity? */
static int is_uniform(const chain *c, int *uniform) {
    algsurf_memory_mark mark = algsurf_memory_here(c->m);
    algsurf_zpoly z;
    *uniform = 0;
    if (c->share % c->u.degree) return 1;
    if (!combination(c->m, &c->v, -(c->share / c->u.degree), &c->u, &z)) return 0;
    *uniform = z.degree < 0;
    algsurf_memory_release(c->m, mark);
    return 1;
}

/* Takes the roots of multiplicity c->least out of u, and adds 1 to c->least. */
static int chain_step(chain *c) {
    algsurf_memory_mark mark = algsurf_memory_here(c->m);
    algsurf_zpoly z;
    int k = c->least++;
    algsurf_parts p = {.g.degree = 0};
    if (!combination(c->m, &c->v, -k, &c->u, &z)) return 0;
    if (z.degree > 0 && !algsurf_zpoly_split(c->m, &c->u, &z, &p)) return 0;
    if (p.g.degree <= 0) { /* there are none */
        algsurf_memory_release(c->m, mark);
        return 1;
    }
    c->share -= k * p.g.degree;
    c->u = p.u;
    return combination(c->m, &p.v, k, &p.u, &c->v);
}

/* For p with a multiple root, or one that might have one. */
static int make_chain(algsurf_memory *m, const algsurf_zpoly *p, algsurf_zpoly *s, int *count) {
    algsurf_parts q;
    int uniform = 0;
    if (!algsurf_zpoly_split(m, p, NULL, &q)) return 0;
    chain c = {m, q.u, q.v, 1, p->degree};
    while (!uniform) {
        s[(*count)++] = c.u;
        if (!is_uniform(&c, &uniform)) return 0;
        if (!uniform && !chain_step(&c)) return 0;
    }
    for (int last = c.share / c.u.degree; *count < last; (*count)++) s[*count] = c.u;
    return 1;
}

int algsurf_zpoly_multiplicities(algsurf_memory *m, const algsurf_zpoly *p, algsurf_zpoly *s, int *count) {
    const algsurf_zpoly t = algsurf_zpoly_trimmed(p);
    algsurf_memory_mark mark = algsurf_memory_here(m);
    int degree;
    *count = 0;
    if (t.degree < 1) return 1;
    if (!algsurf_zpoly_gcd_degree(m, &t, NULL, 2, &degree)) return 0;
    if (degree == 0) return s[(*count)++] = t, 1;
    int done = make_chain(m, &t, s, count);
    if (!done) algsurf_memory_release(m, mark);
    return done;
}
