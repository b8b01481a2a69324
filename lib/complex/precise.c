/* precise.c - all complex roots of a polynomial of integers, to any number of bits.
 *
 * The roots are found and isolated as for doubles (allroots.c).  Then each is made as narrow as is asked, by
 * Newton's steps on its point and one more proof of all discs (part.c, discs.c).
 *
 * Of a real polynomial, roots that are proved real, and those above the axis, are taken; the conjugates of
 * these are the others.  Boxes of one factor's roots do not meet, as each is far smaller than the distance to
 * the next root.  Where those of different factors do, more bits are asked for: the roots are different, so
 * this ends. */
#include "../base/arithmetic.h"
#include <math.h>
#include <stdlib.h>

#include "../base/fpenv.h"
#include "../poly/value.h"
#include "discs.h"
#include "impl.h"

#define BITS_OF_DOUBLES 60 /* fewer than what discs are narrow to without being asked for more */

/* A root as it comes. */
typedef struct entry {
    algsurf_i_point z;
    algsurf_precise_root root; /* its integers are set at the end */
    int factor;
} entry;

struct algsurf_precise_roots {
    algsurf_memory m;          /* for all that follows */
    algsurf_memory_mark empty; /* without limbs of roots */
    int bits, count, factors;  /* factors: so many have delivered their roots */
    int failed;                /* a root could not be told from another */
    entry *found;              /* in order at last */
};

/* A root within R of z, which becomes integers in units of 2^-10 R or smaller ones. */
static int add(algsurf_precise_roots *to, const algsurf_i_point *z, algsurf_scaled R, int multiplicity,
               int real) {
    const int exact = is_zero(R);
    const int64_t low = exact ? z->exponent : R.exponent - 10;
    const int up = z->exponent > low ? (int)(z->exponent - low) : 0, w = z->w + up / 64 + 1;
    algsurf_limb *x = algsurf_memory_take(&to->m, 2 * (size_t)w);
    entry *e = to->found + to->count;
    if (!x) return 0;
    algsurf_z_zero(x, 2 * w);
    algsurf_i_add_shifted(x, w, z->x, z->w, up);
    algsurf_i_add_shifted(x + w, w, z->y, z->w, up);
    *e = (entry){.z = *z, .root = {.multiplicity = multiplicity, .real = real}, .factor = to->factors};
    e->z.x = x, e->z.y = x + w, e->z.w = e->z.room = w, e->z.exponent -= up;
    if (!exact) e->root.radius = (int)ceil(ldexp(R.re, (int)(R.exponent - e->z.exponent)));
    to->count++;
    return 1;
}

int algsurf_i_deliver_precisely(algsurf_i_discs *d, algsurf_i_answer *answer) {
    algsurf_precise_roots *to = answer->precise;
    int open;
    d->more = to->bits > BITS_OF_DOUBLES ? to->bits - BITS_OF_DOUBLES : 1;
    if (!algsurf_i_discs_run(d, ALGSURF_I_MOST_SWEEPS, &open)) return 0;
    for (int i = 0; i < d->n && !to->failed; i++) {
        const algsurf_i_disc *root = d->root + i;
        algsurf_i_point x = {.room = 0};
        algsurf_scaled R;
        int real = 0;
        if (open || !is_alone(d, i)) return to->failed = 1;
        if (d->p->real && !algsurf_i_is_real(d, i, &real)) return 0;
        if (real < 0) return to->failed = 1;
        if (!algsurf_i_centre(d, i, real, &x, &R)) return 0;
        if (d->p->real && !real && x.head.im < 0) continue;
        for (int mate = 0; mate < (d->p->real && !real ? 2 : 1); mate++) {
            const int multiplicity = root->multiplicity[mate];
            if (multiplicity > 0 && !add(to, &x, R, multiplicity, real)) return 0;
            if (!algsurf_i_set_conjugate(d->m, &x, &x)) return 0;
        }
    }
    answer->count = to->count;
    to->factors++;
    return 1;
}

/* ---- boxes of different factors ---- */

/* Whether any two boxes meet; -1: no memory. */
static int any_meet(algsurf_memory *m, const algsurf_precise_roots *r) {
    algsurf_scaled d;
    for (int i = 0; i < r->count; i++)
        for (int j = 0; j < i; j++) {
            const entry *a = r->found + i, *b = r->found + j;
            if (a->factor == b->factor) continue;
            if (!algsurf_i_difference(m, &a->z, &b->z, &d)) return -1;
            d = scaled_of(fmax(fabs(d.re), fabs(d.im)), 0, d.exponent);
            algsurf_scaled reach =
                sum(scaled_of(a->root.radius, 0, a->z.exponent), scaled_of(b->root.radius, 0, b->z.exponent));
            if (!less(by(reach, 1 + 0x1p-20), d)) return 1;
        }
    return 0;
}

/* ---- order ---- */

/* The sign of a 2^e - b 2^f: words from the top of both, of which the first one has the sign. */
static int compare_numbers(const algsurf_limb *a, int w, int64_t e, const algsurf_limb *b, int v, int64_t f) {
    int64_t at = (e + 64 * w > f + 64 * v ? e + 64 * w : f + 64 * v) - 64;
    algsurf_limb sign = (algsurf_limb)1 << 63;
    for (; at > (e < f ? e : f) - 64; at -= 64, sign = 0) {
        algsurf_limb x = algsurf_i_limb_at(a, w, at - e) ^ sign, y = algsurf_i_limb_at(b, v, at - f) ^ sign;
        if (x != y) return x > y ? 1 : -1;
    }
    return 0;
}

static int compare(const void *left, const void *right) {
    const algsurf_i_point *a = &((const entry *)left)->z, *b = &((const entry *)right)->z;
    int sign = compare_numbers(a->x, a->w, a->exponent, b->x, b->w, b->exponent);
    return sign ? sign : compare_numbers(a->y, a->w, a->exponent, b->y, b->w, b->exponent);
}

/* The number in place of which its magnitude is left. */
static algsurf_integer integer_of(algsurf_limb *a, int w) {
    int negative = algsurf_z_negative(a, w);
    if (negative) algsurf_z_negate(a, w);
    int length = algsurf_z_length(a, w);
    return (algsurf_integer){a, negative ? -length : length};
}

/* ---- the public calls ---- */

void algsurf_precise_roots_free(algsurf_precise_roots *r) {
    if (r) algsurf_memory_release(&r->m, (algsurf_memory_mark){0});
    free(r);
}

static algsurf_precise_roots *new_roots(int degree) {
    algsurf_precise_roots *r = calloc(1, sizeof *r);
    if (!r) return NULL;
    (void)algsurf_memory_begin(&r->m, NULL, 0, SIZE_MAX);
    r->found = algsurf_i_take(&r->m, (size_t)degree * sizeof *r->found);
    r->empty = algsurf_memory_here(&r->m);
    if (r->found) return r;
    algsurf_precise_roots_free(r);
    return NULL;
}

/* One attempt; *met: boxes meet. */
static algsurf_status find(const algsurf_integer *re, const algsurf_integer *im, int degree, size_t limit,
                           algsurf_precise_roots *r, int *met) {
    algsurf_memory m;
    algsurf_memory_mark mark = algsurf_memory_begin(&m, NULL, 0, limit);
    int at_zero;
    algsurf_memory_release(&r->m, r->empty);
    r->count = 0;
    algsurf_status status = algsurf_i_find_precise_roots(re, im, degree, limit, r, &at_zero);
    if (status == ALGSURF_OK && r->failed) status = ALGSURF_NOT_CONVERGED;
    if (status == ALGSURF_OK && at_zero > 0 && !add(r, &algsurf_i_origin, scaled_none(), at_zero, 1))
        status = ALGSURF_E_NO_MEMORY;
    if (status == ALGSURF_OK && (*met = any_meet(&m, r)) < 0) status = ALGSURF_E_NO_MEMORY;
    algsurf_memory_release(&m, mark);
    return status;
}

static algsurf_status create(const algsurf_integer *re, const algsurf_integer *im, int degree, int bits,
                             size_t limit, algsurf_precise_roots *r) {
    algsurf_status status;
    int met = 0;
    r->bits = bits;
    while ((status = find(re, im, degree, limit, r, &met)) == ALGSURF_OK && met) r->bits *= 2;
    qsort(r->found, (size_t)r->count, sizeof *r->found, compare);
    for (int i = 0; i < r->count; i++) {
        entry *e = r->found + i;
        e->root.re = integer_of(e->z.x, e->z.w), e->root.im = integer_of(e->z.y, e->z.w);
        e->root.exponent = (int)e->z.exponent;
    }
    return status;
}

algsurf_status algsurf_precise_roots_create(const algsurf_integer *re, const algsurf_integer *im, int degree,
                                            int bits, size_t max_memory, algsurf_precise_roots **roots) {
    if (!re || !roots || bits < 1 || bits > ALGSURF_MAX_ROOT_BITS) return ALGSURF_E_ARGUMENT;
    algsurf_status status = algsurf_i_check_degree(degree);
    if (status != ALGSURF_OK) return status;
    algsurf_precise_roots *r = new_roots(degree);
    if (!r) return ALGSURF_E_NO_MEMORY;
    ALGSURF_STANDARD(status =
                         create(re, im, degree, bits, max_memory ? max_memory : ALGSURF_I_COMPLEX_MEMORY, r));
    if (status != ALGSURF_OK)
        algsurf_precise_roots_free(r);
    else
        *roots = r;
    return status;
}

int algsurf_precise_roots_count(const algsurf_precise_roots *roots) { return roots ? roots->count : 0; }

algsurf_status algsurf_precise_roots_get(const algsurf_precise_roots *roots, int i,
                                         algsurf_precise_root *root) {
    if (!roots || !root || i < 0 || i >= roots->count) return ALGSURF_E_ARGUMENT;
    *root = roots->found[i].root;
    return ALGSURF_OK;
}
