/* surface/exact_form.c - P along a ray by Horner's scheme in x, y, z over polynomials with integer
 * coefficients.
 *
 * Each coordinate is 2^unit (f0 + f1 v), f0 and f1 integers, nearly always of one limb (exact_axis.h).  A
 * term a x^i y^j z^k counts with the power of two of its units; `least`, the lowest bit of all, makes them
 * integers. Nested Horner needs no powers of the coordinates: one step is a product in place by f0 + f1 v, 2
 * limbs of products for each limb of the polynomial, and widths grow with the degree as they must.
 *
 * The parameter.  u = 2^shift v: v is chosen so that the bits of origins and directions lie over each other,
 * as far as one power of two can do that for three axes; then f0 and f1 have 53 to 56 bits, not 53 + |shift|.
 * The powers of 2^shift are put in at the end.
 *
 * Widths.  Every polynomial on the way is a sum of products of a term and some coordinates; with
 * |f0| + |f1| < 2^bits a product by a coordinate adds `bits` to the largest of the summands, and N summands
 * add log2 N.
 */
#include "../base/arithmetic.h"
#include "exact_form.h"

#include "exact_axis.h"
#include "impl.h"

typedef struct scheme {
    const algsurf_term *next, *end; /* sorted by decreasing k, j, i */
    int least;                      /* a unit of the integers is 2^least */
    algsurf_i_exact_axis axis[3];
    algsurf_i_exact_sum sum[3]; /* of a row in x, of the rows in y, of all */
    algsurf_limb *spare;
} scheme;

static int exponent(const algsurf_term *t, int axis) { return axis == 0 ? t->i : axis == 1 ? t->j : t->k; }

/* The bits of f0 and f1 together, in units of their lowest, with directions times 2^e. */
static int bits_along(const algsurf_i_exact_span *o, const algsurf_i_exact_span *d, int e) {
    int low = o->low < d->low + e ? o->low : d->low + e, top = o->top > d->top + e ? o->top : d->top + e;
    return top - low;
}

/* The exponent of v: the sum of all bits is a convex function of it with corners where two lowest or two
 * highest bits meet. */
static int choose_exponent(const double origin[3], const double direction[3], int e) {
    algsurf_i_exact_span o[3], d[3];
    int count = 0, best = e, best_bits = 0;
    for (int i = 0; i < 3; i++) {
        if (origin[i] == 0 || direction[i] == 0) continue;
        o[count] = algsurf_i_exact_span_of(origin[i]);
        d[count++] = algsurf_i_exact_span_of(direction[i]);
    }
    for (int corner = 0; corner < 2 * count; corner++) {
        int i = corner / 2, bits = 0, at = corner % 2 ? o[i].top - d[i].top : o[i].low - d[i].low;
        for (int j = 0; j < count; j++) bits += bits_along(&o[j], &d[j], at);
        if (corner == 0 || bits < best_bits) best = at, best_bits = bits;
    }
    return best;
}

/* Sets least; returns the bits of the largest term's product. */
static int measure(scheme *h) {
    int low = 0, top = 0;
    const algsurf_i_exact_axis *x = h->axis;
    for (const algsurf_term *t = h->next; t < h->end; t++) {
        algsurf_i_exact_span a = algsurf_i_exact_span_of(t->a);
        int unit = t->i * x[0].unit + t->j * x[1].unit + t->k * x[2].unit;
        int bits = t->i * x[0].bits + t->j * x[1].bits + t->k * x[2].bits;
        a.low += unit, a.top += unit + bits;
        if (t == h->next || a.low < low) low = a.low;
        if (t == h->next || a.top > top) top = a.top;
    }
    h->least = low;
    return top - low;
}

static void add_term(scheme *h) {
    const algsurf_term *t = h->next++;
    int unit = t->i * h->axis[0].unit + t->j * h->axis[1].unit + t->k * h->axis[2].unit;
    algsurf_i_exact_sum_add_double(&h->sum[0], t->a, unit - h->least);
}

/* Does the next term belong to the same power of the axes outside of this one? */
static int goes_on(const scheme *h, const algsurf_term *t, int axis) {
    if (h->next == h->end) return 0;
    return (axis > 1 || h->next->k == t->k) && (axis > 0 || h->next->j == t->j);
}

/* Horner's scheme in one coordinate, over sums in those inside of it. */
static void evaluate(scheme *h, int axis) {
    algsurf_i_exact_sum *sum = &h->sum[axis];
    int more = 1;
    sum->degree = -1;
    while (more) {
        const algsurf_term *t = h->next;
        if (axis == 0) {
            add_term(h);
        } else {
            evaluate(h, axis - 1);
            algsurf_i_exact_sum_add(sum, &h->sum[axis - 1]);
        }
        more = goes_on(h, t, axis);
        int steps = exponent(t, axis) - (more ? exponent(h->next, axis) : 0);
        while (steps-- > 0) algsurf_i_exact_sum_times(sum, &h->axis[axis], h->spare);
    }
}

/* p's degree and width, when the lowest bit of all becomes bit 0; returns where that one is. */
static int measure_result(const algsurf_i_exact_sum *sum, int shift, algsurf_zpoly *p) {
    int low = 0, top = 0;
    p->degree = -1;
    for (int k = 0; k <= sum->degree; k++) {
        const algsurf_limb *a = sum->c + (size_t)k * sum->stride;
        int zeros = algsurf_z_trailing(a, sum->width);
        if (zeros == ALGSURF_Z_NO_BIT) continue;
        int bits = algsurf_z_bits(a, sum->width);
        if (p->degree < 0 || zeros + k * shift < low) low = zeros + k * shift;
        if (p->degree < 0 || bits + k * shift > top) top = bits + k * shift;
        p->degree = k;
    }
    p->width = algsurf_z_width(top - low);
    return low;
}

/* p(u) = 2^-low sum(v), v = 2^shift u, into the room that p has; the sum is changed.  Returns low, 0 if p is
 * zero. */
static int set_result(const algsurf_i_exact_sum *sum, int shift, algsurf_zpoly *p) {
    int low = measure_result(sum, shift, p);
    for (int k = 0; k <= p->degree; k++) {
        algsurf_limb *a = sum->c + (size_t)k * sum->stride;
        int up = k * shift - low;
        if (up < 0) algsurf_z_shift_down(a, sum->width, -up);
        algsurf_z_copy(algsurf_zpoly_at(p, k), p->width, a, sum->width);
        if (up > 0) algsurf_z_shift_up(algsurf_zpoly_at(p, k), p->width, up);
    }
    return low;
}

/* Room for three sums; the scheme's coordinates and terms are set. */
static int take_work(algsurf_memory *m, scheme *h, int degree, int bits) {
    size_t stride = (size_t)algsurf_z_width(bits), size = (size_t)(degree + 1) * stride;
    algsurf_limb *room = algsurf_memory_take(m, 3 * size + stride);
    if (!room) return 0;
    for (int i = 0; i < 3; i++) h->sum[i].stride = stride, h->sum[i].c = room + (size_t)i * size;
    h->spare = room + 3 * size;
    return 1;
}

int algsurf_i_exact_form(algsurf_memory *m, const algsurf_surface *s, const double origin[3],
                         const double direction[3], int e, algsurf_zpoly *p, int *scale) {
    scheme h = {.next = s->terms, .end = s->terms + s->term_count};
    int own = choose_exponent(origin, direction, e), n = s->degree;
    for (int i = 0; i < 3; i++) algsurf_i_exact_axis_make(&h.axis[i], origin[i], direction[i], own);
    int bits = measure(&h) + algsurf_limb_bits(s->term_count - 1);
    algsurf_memory_mark before = algsurf_memory_here(m);
    if (!algsurf_zpoly_new(m, n, algsurf_z_width(bits + n * (e < own ? own - e : e - own)), p)) return 0;
    algsurf_memory_mark kept = algsurf_memory_here(m);
    if (!take_work(m, &h, n, bits)) {
        algsurf_memory_release(m, before);
        return 0;
    }
    evaluate(&h, 2);
    int low = set_result(&h.sum[2], e - own, p);
    kept.at = p->c + (size_t)(p->degree + 1) * (size_t)p->width; /* what the result needs of its room */
    algsurf_memory_release(m, kept);
    if (scale) *scale = p->degree < 0 ? 0 : -(h.least + low);
    return 1;
}
