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

/* A place for results, taken before their sizes are known. */
typedef struct place {
    algsurf_memory_mark before, after;
    algsurf_limb *at;
} place;

static int place_begin(place *r, algsurf_memory *m, size_t words) {
    r->before = algsurf_memory_here(m);
    r->at = algsurf_memory_take(m, words);
    r->after = algsurf_memory_here(m);
    return r->at != NULL;
}

static void place_copy(place *r, const algsurf_zpoly *p, algsurf_zpoly *copy) {
    *copy = (algsurf_zpoly){p->degree, algsurf_z_width(algsurf_zpoly_bits(p)), r->at};
    for (int k = 0; k <= p->degree; k++)
        algsurf_z_copy(algsurf_zpoly_at(copy, k), copy->width, algsurf_zpoly_at(p, k), p->width);
    r->at += algsurf_zpoly_words(copy);
}

/* Gives back everything behind what was copied; after a failure (done = 0) all of it.  Returns done. */
static int place_end(place *r, algsurf_memory *m, int done) {
    r->after.at = r->at;
    algsurf_memory_release(m, done ? r->after : r->before);
    return done;
}

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

/* Takes the roots of multiplicity c->least out of u, and adds 1 to c->least; *fewer: there were any. */
static int chain_step(chain *c, int *fewer) {
    algsurf_memory_mark mark = algsurf_memory_here(c->m);
    algsurf_zpoly z;
    int k = c->least++;
    algsurf_parts p = {.g.degree = 0};
    if (!combination(c->m, &c->v, -k, &c->u, &z)) return 0;
    if (z.degree > 0 && !algsurf_zpoly_split(c->m, &c->u, &z, &p)) return 0;
    *fewer = p.g.degree > 0;
    if (!*fewer) {
        algsurf_memory_release(c->m, mark);
        return 1;
    }
    c->share -= k * p.g.degree;
    c->u = p.u;
    return combination(c->m, &p.v, k, &p.u, &c->v);
}

/* Fills s from s[0] = c->u on, new members into r. */
static int make_chain(chain *c, place *r, algsurf_zpoly *s, int *count) {
    int uniform, fewer = 1;
    for (int i = 0;; i++) {
        if (fewer)
            place_copy(r, &c->u, s + i);
        else
            s[i] = s[i - 1];
        *count = i + 1;
        if (!is_uniform(c, &uniform)) return 0;
        if (uniform) break;
        if (!chain_step(c, &fewer)) return 0;
    }
    for (int last = c->share / c->u.degree; *count < last; (*count)++) s[*count] = s[*count - 1];
    return 1;
}

/* Limbs for a chain that begins with degree d, at most: t different multiplicities add up to t (t + 1) / 2,
 * and the degrees of all members to n, at most. */
static size_t chain_words(const algsurf_zpoly *p, int d) {
    int n = p->degree, t = 1;
    while (t < d && (t + 1) * (t + 2) / 2 <= n) t++;
    return (size_t)smaller(t * (d + 1), n + t) * (size_t)algsurf_zpoly_factor_width(p, d);
}

/* *distinct: a lower bound on the number of different roots, from an upper bound on the gcd's degree; room is
 * taken for that many.  If there are more, the number is corrected, and *count stays 0. */
static int try_chain(algsurf_memory *m, const algsurf_zpoly *p, int *distinct, algsurf_zpoly *s, int *count) {
    place result;
    algsurf_parts q;
    if (!place_begin(&result, m, chain_words(p, *distinct))) return 0;
    int done = algsurf_zpoly_split(m, p, NULL, &q);
    if (done && q.u.degree <= *distinct) {
        chain c = {m, q.u, q.v, 1, p->degree};
        done = make_chain(&c, &result, s, count);
    } else if (done)
        *distinct = q.u.degree; /* the bound came from useless primes */
    return place_end(&result, m, done);
}

int algsurf_zpoly_multiplicities(algsurf_memory *m, const algsurf_zpoly *p, algsurf_zpoly *s, int *count) {
    algsurf_zpoly t = algsurf_zpoly_trimmed(p);
    int degree;
    *count = 0;
    if (t.degree < 1) return 1;
    if (!algsurf_zpoly_gcd_degree(m, &t, NULL, 2, &degree)) return 0;
    if (degree == 0) {
        *count = 1;
        return algsurf_zpoly_copy(m, &t, t.width, s);
    }
    for (int distinct = t.degree - degree; *count == 0;)
        if (!try_chain(m, &t, &distinct, s, count)) return 0;
    return 1;
}
