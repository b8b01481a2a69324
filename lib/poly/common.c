/* common.c - common factors of integral polynomials: images modulo primes, then a proof.
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
 */
#include "../base/arithmetic.h"
#include <string.h>

#include "integral_impl.h"
#include "lift.h"

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
    if (!i->x) return 0;
    i->y = i->x + a->degree + 1;
    return 1;
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
    algsurf_zpoly s = algsurf_zpoly_trimmed(a), t = b ? algsurf_zpoly_trimmed(b) : s;
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

/* What is known about the parts of a and b (degree of an image's gcd at most `degree`). */
typedef struct search {
    algsurf_memory *m;
    images images;
    algsurf_zpoly b;       /* also if it is a' */
    algsurf_limb *x, *y;   /* copies of the residues, for Euclid's algorithm */
    algsurf_limb *numbers; /* what is to be lifted, modulo the present prime */
    algsurf_lift lift;
    int degree, cofactors; /* cofactors: u and v are lifted, not g */
    int next;              /* images to the next guess */
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
    if (!s->x) return 0;
    s->y = s->x + a->degree + 1;
    s->numbers = s->x + n;
    return 1;
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
    algsurf_z_factor *fu = algsurf_zpoly_factors(s->m, u), *fv = algsurf_zpoly_factors(s->m, v);
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
static int divide_both(search *s, const algsurf_zpoly *g, algsurf_parts *p, int *divides) {
    algsurf_memory_mark mark = algsurf_memory_here(s->m);
    p->g = *g;
    p->has_gcd = 1;
    if (!algsurf_zpoly_divide(s->m, s->images.a, g, divides, &p->u)) return 0;
    if (!*divides) return 1;
    if (!algsurf_zpoly_divide(s->m, &s->b, g, divides, &p->v)) return 0;
    if (!*divides) algsurf_memory_release(s->m, mark);
    return 1;
}

/* From the numbers that were lifted. */
static int prove(search *s, const algsurf_zpoly *c, algsurf_parts *p, int *proved) {
    int du = s->images.a->degree - s->degree;
    if (!s->cofactors) return divide_both(s, c, p, proved);
    p->has_gcd = 0;
    p->u = (algsurf_zpoly){du, c->width, c->c};
    p->v = (algsurf_zpoly){du - 1, c->width, algsurf_zpoly_at(c, du + 1)};
    return same_fraction(s, &p->u, &p->v, proved);
}

/* A lower degree: all images before were useless. */
static void restart(search *s, int degree) {
    int n = s->images.a->degree;
    if (s->degree <= n) algsurf_lift_forget(&s->lift);
    s->degree = degree;
    s->cofactors = !s->images.b && degree > n - degree;
    s->next = 1;
    algsurf_lift_begin(&s->lift, s->m, s->cofactors ? 2 * (n - degree) + 1 : degree + 1);
}

static int guess(search *s, algsurf_parts *p, int *proved) {
    algsurf_memory_mark mark = algsurf_memory_here(s->m);
    algsurf_zpoly c;
    int found;
    s->next += s->next / 4 + 1; /* simple numbers need few images */
    if (!algsurf_lift_guess(&s->lift, &found, &c)) return 0;
    if (!found) return 1;
    algsurf_zpoly_cut(&c, 0);
    if (!prove(s, &c, p, proved)) return 0;
    if (!*proved) algsurf_memory_release(s->m, mark);
    return 1;
}

static int coprime(search *s, algsurf_parts *p) {
    *p = (algsurf_parts){.u = *s->images.a, .v = s->b, .has_gcd = 1};
    if (!algsurf_zpoly_new(s->m, 0, 1, &p->g)) return 0;
    p->g.c[0] = 1;
    return 1;
}

int algsurf_zpoly_split(algsurf_memory *m, const algsurf_zpoly *a, const algsurf_zpoly *b, algsurf_parts *p) {
    const algsurf_zpoly of_a = algsurf_zpoly_trimmed(a), of_b = algsurf_zpoly_trimmed(b ? b : a);
    search s;
    int proved = 0;
    if (!search_begin(&s, m, &of_a, b ? &of_b : NULL)) return 0;
    while (!proved) {
        algsurf_limb *gcd;
        int degree = search_next(&s, &gcd);
        if (degree == 0) return coprime(&s, p);
        if (degree > s.degree) continue;
        if (degree < s.degree) restart(&s, degree);
        if (!search_add(&s, gcd)) return 0;
        if (s.lift.primes >= s.next && !guess(&s, p, &proved)) return 0;
    }
    return 1;
}
