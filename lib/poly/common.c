/* common.c - common factors and multiple roots of integral polynomials: images modulo primes, then a proof.
 *
 * Degree.  Modulo a prime that divides neither leading coefficient, gcd(a, b) keeps its degree, and the gcd
 * of the images has that degree or a higher one: the least degree seen is an upper bound, and an image of
 * higher degree than another is useless (Brown 1971; Collins 1967).
 *
 * What is lifted from the images to integers is the smaller one of two:
 *   - the gcd itself, proved by dividing both;
 *   - for p and p', if their gcd is large (p = q^m): u = p / gcd and v = p' / gcd.  If u p' = v p and deg u
 * is n less the bound above, then u is p / gcd: v / u is a fraction equal to p' / p, of which the reduced
 * form has the least denominator.  No integer of the gcd's size is ever made.
 *
 * Multiplicities (Yun 1976).  v / u = sum m_r / (x - r) over the roots r of p, m_r their multiplicities.  At
 * a root v = m_r u': gcd(u, v - k u') has those of multiplicity k, and dividing by it leaves a fraction of
 * the same kind with the roots of higher multiplicity.  When these all have the same one, it is their share
 * of the degree, and v = m u' proves it at once.
 */
#include <string.h>

#include "integral.h"
#include "lift.h"

static int larger(int a, int b) { return a > b ? a : b; }
static int smaller(int a, int b) { return a < b ? a : b; }
static int bits_of_int(int a) { return algsurf_limb_bits((algsurf_limb)a); }

/* Without leading zeros; nothing is copied. */
static algsurf_zpoly trimmed(const algsurf_zpoly *p) {
    algsurf_zpoly t = *p;
    while (t.degree >= 0 && algsurf_z_sign(algsurf_zpoly_at(&t, t.degree), t.width) == 0) t.degree--;
    return t;
}

/* Cuts limbs that all coefficients can spare, in place. */
static void narrow(algsurf_zpoly *p) {
    int from = p->width, w = algsurf_z_width(algsurf_zpoly_bits(p));
    if (w >= from) return;
    p->width = w;
    for (int k = 1; k <= p->degree; k++)
        memmove(algsurf_zpoly_at(p, k), p->c + (size_t)k * (size_t)from, (size_t)w * sizeof *p->c);
}

static size_t words_of(const algsurf_zpoly *p) { return (size_t)(p->degree + 1) * (size_t)p->width; }

/* Limbs for the coefficients of any factor of a in Z[x], of degree at most e (Mignotte): |c| <= 2^e |a|_2. */
static int factor_width(const algsurf_zpoly *a, int e) {
    return algsurf_z_width(algsurf_zpoly_bits(a) + 1 + e + (bits_of_int(a->degree + 1) + 1) / 2);
}

/* ---- images ---- */

/* a and b (null: a') modulo one prime after the other. */
typedef struct images {
    const algsurf_zpoly *a, *b;
    int db;
    algsurf_limb *x, *y; /* their residues, with a common factor if b is null, each with its own otherwise */
    algsurf_prime prime;
    int started;
} images;

static int images_begin(images *i, algsurf_memory *m, const algsurf_zpoly *a, const algsurf_zpoly *b) {
    int db = b ? b->degree : a->degree - 1;
    *i = (images){.a = a, .b = b, .db = db};
    i->x = algsurf_memory_take(m, (size_t)(a->degree + db + 2));
    i->y = i->x + a->degree + 1;
    return i->x != NULL;
}

/* The next prime that divides neither leading coefficient. */
static void images_next(images *i) {
    const algsurf_zpoly *a = i->a, *b = i->b;
    do {
        i->prime = i->started ? algsurf_prime_next(&i->prime) : algsurf_prime_first();
        i->started = 1;
        algsurf_residues_of(i->x, a->c, a->degree + 1, a->width, &i->prime);
        if (b)
            algsurf_residues_of(i->y, b->c, b->degree + 1, b->width, &i->prime);
        else
            algsurf_residues_derive(i->y, i->x, a->degree, &i->prime);
    } while (i->x[a->degree] == 0 || i->y[i->db] == 0);
}

static int images_gcd(const images *i, algsurf_limb *x, algsurf_limb *y, algsurf_limb **gcd) {
    int da = i->a->degree;
    return da >= i->db ? algsurf_residues_gcd(x, da, y, i->db, gcd, &i->prime)
                       : algsurf_residues_gcd(y, i->db, x, da, gcd, &i->prime);
}

int algsurf_zpoly_gcd_degree(algsurf_memory *m, const algsurf_zpoly *a, const algsurf_zpoly *b, int tries,
                             int *degree) {
    algsurf_memory_mark mark = algsurf_memory_here(m);
    algsurf_zpoly s = trimmed(a), t = b ? trimmed(b) : s;
    images i;
    *degree = b ? smaller(s.degree, t.degree) : s.degree - 1;
    if (*degree <= 0) {
        *degree = *degree < 0 ? larger(s.degree, t.degree) : 0; /* gcd(a, 0) = a; gcd(constant, b) = 1 */
        return 1;
    }
    if (!images_begin(&i, m, &s, b ? &t : NULL)) return 0;
    for (; tries > 0 && *degree > 0; tries--) {
        algsurf_limb *gcd;
        images_next(&i);
        *degree = smaller(*degree, images_gcd(&i, i.x, i.y, &gcd));
    }
    algsurf_memory_release(m, mark);
    return 1;
}

/* ---- a = g u, b = g v ---- */

/* If !has_gcd, g was not made, and u and v lack the content of a. */
typedef struct parts {
    algsurf_zpoly g, u, v;
    int has_gcd;
} parts;

/* What is known about the parts of a and b (degree of an image's gcd at most `degree`). */
typedef struct search {
    algsurf_memory *m;
    images images;
    algsurf_zpoly b;       /* also if it is a' */
    algsurf_limb *x, *y;   /* copies of the residues, for Euclid's algorithm */
    algsurf_limb *numbers; /* what is to be lifted, modulo the present prime */
    algsurf_lift lift;
    int degree, cofactors, next; /* cofactors: u and v are lifted, not g; next: images to the next guess */
} search;

static int search_begin(search *s, algsurf_memory *m, const algsurf_zpoly *a, const algsurf_zpoly *b) {
    *s = (search){.m = m, .degree = a->degree + 1};
    if (b)
        s->b = *b;
    else if (!algsurf_zpoly_derivative(m, a, &s->b))
        return 0;
    if (!images_begin(&s->images, m, a, b)) return 0;
    int n = a->degree + s->b.degree + 2;
    s->x = algsurf_memory_take(m, 2 * (size_t)n);
    s->y = s->x + a->degree + 1;
    s->numbers = s->x + n;
    return s->x != NULL;
}

/* Modulo the next prime: the degree of the gcd, which is at *gcd. */
static int search_next(search *s, algsurf_limb **gcd) {
    images *i = &s->images;
    images_next(i);
    memcpy(s->x, i->x, (size_t)(i->a->degree + i->db + 2) * sizeof *s->x);
    return images_gcd(i, s->x, s->y, gcd);
}

/* The inverses of three residues that are not 0, in place. */
static void invert(algsurf_limb r[3], const algsurf_prime *m) {
    algsurf_limb ab = algsurf_residue_times(r[0], r[1], m);
    algsurf_limb all = algsurf_residue_inverse(algsurf_residue_times(ab, r[2], m), m);
    algsurf_limb c = algsurf_residue_times(all, ab, m), rest = algsurf_residue_times(all, r[2], m);
    algsurf_limb a = algsurf_residue_times(rest, r[1], m), b = algsurf_residue_times(rest, r[0], m);
    r[0] = a, r[1] = b, r[2] = c;
}

/* u / lc(u) and v / lc(u) modulo the prime: u first, v behind it.  The residues y are those of a' / R. */
static void set_cofactors(search *s, const algsurf_limb *gcd, algsurf_limb inverse) {
    images *i = &s->images;
    const algsurf_prime *m = &i->prime;
    int n = i->a->degree, d = s->degree;
    algsurf_limb ordinary = algsurf_residue_times(inverse, 1, m);
    algsurf_residues_divide(i->x, n, gcd, d, m);
    algsurf_residues_divide(i->y, n - 1, gcd, d, m);
    for (int k = d; k <= n; k++) s->numbers[k - d] = algsurf_residue_times(i->x[k], ordinary, m);
    for (int k = d; k < n; k++) s->numbers[n + 1 - 2 * d + k] = algsurf_residue_times(i->y[k], inverse, m);
}

/* Another image joins; the gcd modulo the prime becomes monic. */
static int search_add(search *s, algsurf_limb *gcd) {
    images *i = &s->images;
    const algsurf_prime *m = &i->prime;
    int d = s->degree;
    algsurf_limb inverse[3] = {gcd[d], i->x[i->a->degree], algsurf_lift_modulus(&s->lift, m)};
    invert(inverse, m);
    if (s->cofactors) {
        for (int k = 0; k <= d; k++) gcd[k] = algsurf_residue_times(gcd[k], inverse[0], m);
        set_cofactors(s, gcd, inverse[1]);
    } else {
        algsurf_limb ordinary = algsurf_residue_times(inverse[0], 1, m);
        for (int k = 0; k <= d; k++) s->numbers[k] = algsurf_residue_times(gcd[k], ordinary, m);
    }
    return algsurf_lift_add(&s->lift, s->numbers, inverse[2], m);
}

/* The coefficients of p as factors. */
static algsurf_z_factor *factors_of(algsurf_memory *m, const algsurf_zpoly *p) {
    size_t size = ((size_t)(p->degree + 1) * sizeof(algsurf_z_factor) + 7) / 8;
    algsurf_z_factor *f = (algsurf_z_factor *)(void *)algsurf_memory_take(m, size);
    algsurf_limb *room = algsurf_memory_take(m, words_of(p));
    if (!f || !room) return NULL;
    for (int k = 0; k <= p->degree; k++)
        f[k] = algsurf_z_factor_of(algsurf_zpoly_at(p, k), p->width, room + (size_t)k * (size_t)p->width);
    return f;
}

/* sum += (or -=) coefficient k of p f, f of degree df. */
static void add_coefficient(algsurf_limb *sum, int w, const algsurf_zpoly *p, const algsurf_z_factor *f,
                            int df, int k, int negate) {
    for (int i = larger(0, k - p->degree); i <= df && i <= k; i++)
        algsurf_z_add_times(sum, w, algsurf_zpoly_at(p, k - i), p->width, f + i, negate);
}

/* Is u b = v a?  Coefficient by coefficient: a wrong guess fails at the first one, mostly. */
static int same_fraction(search *s, const algsurf_zpoly *u, const algsurf_zpoly *v, int *same) {
    const algsurf_zpoly *a = s->images.a, *b = &s->b;
    algsurf_memory_mark mark = algsurf_memory_here(s->m);
    int bits =
        larger(algsurf_zpoly_bits(u) + algsurf_zpoly_bits(b), algsurf_zpoly_bits(v) + algsurf_zpoly_bits(a));
    int w = algsurf_z_width(bits + 3 + bits_of_int(u->degree + 1));
    algsurf_z_factor *fu = factors_of(s->m, u), *fv = factors_of(s->m, v);
    algsurf_limb *sum = algsurf_memory_take(s->m, (size_t)w);
    int done = fu && fv && sum;
    *same = done;
    for (int k = u->degree + b->degree; k >= 0 && *same; k--) {
        algsurf_z_zero(sum, w);
        add_coefficient(sum, w, b, fu, u->degree, k, 0);
        add_coefficient(sum, w, a, fv, v->degree, k, 1);
        *same = algsurf_z_sign(sum, w) == 0;
    }
    algsurf_memory_release(s->m, mark);
    return done;
}

/* Does g divide both?  If so, p has the quotients. */
static int divide_both(search *s, const algsurf_zpoly *g, parts *p, int *divides) {
    algsurf_memory_mark mark = algsurf_memory_here(s->m);
    p->g = *g;
    p->has_gcd = 1;
    if (!algsurf_zpoly_divide(s->m, s->images.a, g, divides, &p->u)) return 0;
    if (!*divides) return 1;
    if (!algsurf_zpoly_divide(s->m, &s->b, g, divides, &p->v)) return 0;
    if (!*divides) algsurf_memory_release(s->m, mark);
    return 1;
}

/* The primitive part with a positive leading coefficient. */
static int positive_primitive(algsurf_memory *m, const algsurf_zpoly *p, algsurf_zpoly *primitive) {
    if (!algsurf_zpoly_primitive(m, p, primitive)) return 0;
    int n = primitive->degree, w = primitive->width;
    if (n >= 0 && algsurf_z_negative(algsurf_zpoly_at(primitive, n), w))
        for (int k = 0; k <= n; k++) algsurf_z_negate(algsurf_zpoly_at(primitive, k), w);
    return 1;
}

/* From the numbers that were lifted. */
static int prove(search *s, const algsurf_zpoly *c, parts *p, int *proved) {
    int du = s->images.a->degree - s->degree;
    if (!s->cofactors) return divide_both(s, c, p, proved);
    p->has_gcd = 0;
    p->u = (algsurf_zpoly){du, c->width, c->c};
    p->v = (algsurf_zpoly){du - 1, c->width, algsurf_zpoly_at(c, du + 1)};
    return same_fraction(s, &p->u, &p->v, proved);
}

/* If the images' gcd has the degree of a or b, that one may divide the other. */
static int try_divisor(search *s, parts *p, int *proved) {
    const algsurf_zpoly *smaller_one = s->degree == s->b.degree ? &s->b : s->images.a;
    algsurf_zpoly g;
    if (s->degree != smaller_one->degree || !s->images.b) return 1;
    if (!positive_primitive(s->m, smaller_one, &g)) return 0;
    return divide_both(s, &g, p, proved);
}

/* A lower degree: all images before were useless. */
static int restart(search *s, int degree, parts *p, int *proved) {
    int n = s->images.a->degree;
    if (s->degree <= n) algsurf_lift_forget(&s->lift);
    s->degree = degree;
    s->cofactors = !s->images.b && degree > n - degree;
    s->next = 1;
    if (!try_divisor(s, p, proved)) return 0;
    if (!*proved) algsurf_lift_begin(&s->lift, s->m, s->cofactors ? 2 * (n - degree) + 1 : degree + 1);
    return 1;
}

static int guess(search *s, parts *p, int *proved) {
    algsurf_memory_mark mark = algsurf_memory_here(s->m);
    algsurf_zpoly c;
    int found;
    s->next = s->lift.primes + 1 + s->lift.primes / 4;
    if (!algsurf_lift_guess(&s->lift, &found, &c)) return 0;
    if (!found) return 1;
    narrow(&c);
    if (!prove(s, &c, p, proved)) return 0;
    if (!*proved) algsurf_memory_release(s->m, mark);
    return 1;
}

static int coprime(search *s, parts *p) {
    *p = (parts){.u = *s->images.a, .v = s->b, .has_gcd = 1};
    if (!algsurf_zpoly_new(s->m, 0, 1, &p->g)) return 0;
    p->g.c[0] = 1;
    return 1;
}

/* The parts of a and b (null: a'), neither 0.  What was taken stays taken: the caller has set a mark. */
static int split(algsurf_memory *m, const algsurf_zpoly *a, const algsurf_zpoly *b, parts *p) {
    search s;
    int proved = 0;
    if (!search_begin(&s, m, a, b)) return 0;
    while (!proved) {
        algsurf_limb *gcd;
        int degree = search_next(&s, &gcd);
        if (degree == 0) return coprime(&s, p);
        if (degree > s.degree) continue;
        if (degree < s.degree && !restart(&s, degree, p, &proved)) return 0;
        if (proved) break;
        if (!search_add(&s, gcd)) return 0;
        if (s.lift.primes >= s.next && !guess(&s, p, &proved)) return 0;
    }
    return 1;
}

/* ---- results, kept below what was needed for them ---- */

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
    r->at += words_of(copy);
}

/* Everything behind what was copied is given back; after a failure all of it. */
static int place_end(place *r, algsurf_memory *m, int done) {
    r->after.at = r->at;
    algsurf_memory_release(m, done ? r->after : r->before);
    return done;
}

/* ---- the gcd ---- */

/* g and the cofactor of a, from parts without g. */
static int divide_out(algsurf_memory *m, const algsurf_zpoly *a, parts *p) {
    algsurf_zpoly q;
    int divides;
    if (!algsurf_zpoly_divide(m, a, &p->u, &divides, &q) || !positive_primitive(m, &q, &p->g)) return 0;
    return algsurf_zpoly_divide(m, a, &p->g, &divides, &p->u);
}

/* One of them is constant, or 0. */
static int trivial_gcd(algsurf_memory *m, const algsurf_zpoly *a, const algsurf_zpoly *b, parts *p) {
    int divides;
    if (a->degree >= 0 && b->degree >= 0) {
        p->u = *a;
        if (!algsurf_zpoly_new(m, 0, 1, &p->g)) return 0;
        p->g.c[0] = 1;
        return 1;
    }
    return positive_primitive(m, a->degree < 0 ? b : a, &p->g) &&
           algsurf_zpoly_divide(m, a, &p->g, &divides, &p->u);
}

static int find_gcd(algsurf_memory *m, const algsurf_zpoly *a, const algsurf_zpoly *b, parts *p) {
    if (a->degree < 1) return trivial_gcd(m, a, b ? b : a, p);
    if (b && b->degree < 1) return trivial_gcd(m, a, b, p);
    return split(m, a, b, p) && (p->has_gcd || divide_out(m, a, p));
}

int algsurf_zpoly_gcd(algsurf_memory *m, const algsurf_zpoly *a, const algsurf_zpoly *b, algsurf_zpoly *g,
                      algsurf_zpoly *cofactor) {
    algsurf_zpoly s = trimmed(a), t = b ? trimmed(b) : s;
    const algsurf_zpoly *larger_one = s.degree >= 0 ? &s : &t; /* gcd(0, b) = b */
    size_t words = (size_t)(larger_one->degree + 3) * (size_t)factor_width(larger_one, larger_one->degree);
    place result;
    parts p;
    if (!place_begin(&result, m, words)) return 0;
    int done = find_gcd(m, &s, b ? &t : NULL, &p);
    if (done) {
        place_copy(&result, &p.g, g);
        place_copy(&result, &p.u, cofactor);
    }
    return place_end(&result, m, done);
}

/* ---- multiplicities ---- */

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
        if (k < 0)
            algsurf_z_sub_product(to, w, from, u->width, size * (algsurf_limb)(j + 1), 0);
        else
            algsurf_z_add_product(to, w, from, u->width, size * (algsurf_limb)(j + 1), 0);
    }
    *z = trimmed(z);
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
    int k = c->least++, degree;
    parts p;
    *fewer = 0;
    if (!combination(c->m, &c->v, -k, &c->u, &z)) return 0;
    if (!algsurf_zpoly_gcd_degree(c->m, &c->u, &z, 1, &degree)) return 0;
    if (degree > 0) {
        if (!split(c->m, &c->u, &z, &p)) return 0;
        *fewer = p.g.degree > 0;
    }
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
    return (size_t)smaller(t * (d + 1), n + t) * (size_t)factor_width(p, d);
}

/* *distinct: an upper bound on the number of different roots, of which there must be as many: 0 roots fewer
 * or more room is needed. */
static int try_chain(algsurf_memory *m, const algsurf_zpoly *p, int *distinct, algsurf_zpoly *s, int *count) {
    place result;
    parts q;
    if (!place_begin(&result, m, chain_words(p, *distinct))) return 0;
    int done = split(m, p, NULL, &q);
    if (done && q.u.degree <= *distinct) {
        chain c = {m, q.u, q.v, 1, p->degree};
        done = make_chain(&c, &result, s, count);
    } else if (done)
        *distinct = q.u.degree; /* the primes of the bound were useless; *count is 0 */
    return place_end(&result, m, done);
}

int algsurf_zpoly_multiplicities(algsurf_memory *m, const algsurf_zpoly *p, algsurf_zpoly *s, int *count) {
    algsurf_zpoly t = trimmed(p);
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
