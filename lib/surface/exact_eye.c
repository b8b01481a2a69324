/* surface/exact_eye.c - P(eye + w), and along a ray w = 2^e u d.
 *
 * Once for an eye: with units of the axes in which eye's coordinates are integers f_a below 2^64, P(eye + w)
 * has integer coefficients: Taylor shifts by f_0, f_1, f_2 (synthetic division along each line of
 * coefficients).
 *
 * For a ray: w_a = d_a 2^e u = 2^unit y_a v with integers y_a, the parameter v as coarse as that allows. Then
 *
 *     sum_k (y_2 v)^k sum_j (y_1 v)^j sum_i A_ijk y_0^i v^i
 *
 * with powers of y_0, and Horner's scheme in y_1 v and y_2 v: for a dense surface of degree n about n^5/120 +
 * n^4/12 products of limbs, against n^5/30 + n^4/6 for a ray of its own.  Measured: 0.6 / 0.55 / 0.45 of its
 * time at degree 6 / 10 / 16.  The shifts fill a sparse surface: 0.85 / 0.6 for Chmutov's of degree 10 / 20,
 * but 1.25 for Barth's sextic. */
#include "../base/arithmetic.h"
#include "exact_eye.h"

#include <string.h>

#include "impl.h"

/* ---- once for an eye ---- */

/* All coefficients up to the degree, of one width. */
typedef struct grid {
    int n, width;
    uint64_t *index; /* by exponents: 1, 2, ... of those that may not be 0; 0 of the others */
    algsurf_limb *c;
} grid;

/* The index of the coefficient of w_axis^e on the line of exponents p, q of the next axes, cyclically. */
static uint64_t *index_of(const grid *g, int axis, int e, int p, int q) {
    size_t at[3], side = (size_t)g->n + 1;
    at[axis] = (size_t)e, at[(axis + 1) % 3] = (size_t)p, at[(axis + 2) % 3] = (size_t)q;
    return &g->index[(at[2] * side + at[1]) * side + at[0]];
}

static algsurf_limb *coefficient(const grid *g, uint64_t index) {
    return g->c + (size_t)(index - 1) * (size_t)g->width;
}

/* What a shift along the line may make: all coefficients below the highest. */
static void support_line(const grid *g, int axis, int p, int q, const algsurf_i_exact_factor *f) {
    uint64_t some = 0;
    (void)f;
    for (int e = g->n - p - q; e >= 0; e--) {
        uint64_t *index = index_of(g, axis, e, p, q);
        some |= *index, *index = some;
    }
}

/* The polynomial at w_axis + f on one line. */
static void shift_line(const grid *g, int axis, int p, int q, const algsurf_i_exact_factor *f) {
    int length = g->n - p - q;
    while (length > 0 && *index_of(g, axis, length, p, q) == 0) length--;
    for (int i = 0; i < length; i++)
        for (int e = length - 1; e >= i; e--) {
            const algsurf_limb *above = coefficient(g, *index_of(g, axis, e + 1, p, q));
            algsurf_limb *c = coefficient(g, *index_of(g, axis, e, p, q));
            if (f->sign)
                algsurf_z_sub_product(c, g->width, above, g->width, f->low, 0);
            else
                algsurf_z_add_product(c, g->width, above, g->width, f->low, 0);
        }
}

/* On each line along an axis in which the eye is not 0. */
static void on_lines(const grid *g, const algsurf_i_exact_axis f[3],
                     void (*line)(const grid *, int, int, int, const algsurf_i_exact_factor *)) {
    for (int axis = 0; axis < 3; axis++)
        for (int p = 0; f[axis].f[0].low != 0 && p <= g->n; p++)
            for (int q = 0; p + q <= g->n; q++) line(g, axis, p, q, &f[axis].f[0]);
}

/* One unit for all axes, the lowest bit of the eye, as far as f < 2^63 allows: then y_a is short, too. */
static void choose_units(const double eye[3], int unit[3]) {
    algsurf_i_exact_span span[3];
    int low = 0, some = 0;
    for (int i = 0; i < 3; i++) {
        span[i] = algsurf_i_exact_span_of(eye[i]);
        if (eye[i] != 0 && (!some || span[i].low < low)) low = span[i].low, some = 1;
    }
    for (int i = 0; i < 3; i++) { /* 53 bits end above bit top - 63 */
        unit[i] = low;
        if (eye[i] != 0 && span[i].top - low > 63) unit[i] = span[i].top - 63;
    }
}

static int unit_of(const algsurf_i_exact_eye *y, const algsurf_term *t) {
    return t->i * y->unit[0] + t->j * y->unit[1] + t->k * y->unit[2];
}

/* Sets least; returns a bound for the bits of P(eye + w), with |f + 1| <= 2^bits. */
static int measure(const algsurf_surface *s, const algsurf_i_exact_axis f[3], algsurf_i_exact_eye *y) {
    int low = 0, top = 0;
    for (size_t c = 0; c < s->term_count; c++) {
        const algsurf_term *t = &s->terms[c];
        algsurf_i_exact_span a = algsurf_i_exact_span_of(t->a);
        a.low += unit_of(y, t);
        a.top += unit_of(y, t) + t->i * f[0].bits + t->j * f[1].bits + t->k * f[2].bits;
        if (c == 0 || a.low < low) low = a.low;
        if (c == 0 || a.top > top) top = a.top;
    }
    y->least = low;
    return top - low + algsurf_limb_bits(s->term_count - 1);
}

/* P(eye + w) in the grid. */
static int shift(algsurf_memory *work, const algsurf_surface *s, const algsurf_i_exact_eye *y,
                 const algsurf_i_exact_axis f[3], grid *g, size_t *used) {
    size_t side = (size_t)g->n + 1, size = side * side * side;
    *used = 0;
    g->index = algsurf_memory_take(work, size);
    if (!g->index) return 0;
    memset(g->index, 0, size * sizeof *g->index);
    for (size_t c = 0; c < s->term_count; c++)
        *index_of(g, 0, s->terms[c].i, s->terms[c].j, s->terms[c].k) = 1;
    on_lines(g, f, support_line);
    for (size_t c = 0; c < size; c++)
        if (g->index[c]) g->index[c] = ++*used;
    g->c = algsurf_memory_take(work, *used * (size_t)g->width);
    if (!g->c) return 0;
    memset(g->c, 0, *used * (size_t)g->width * sizeof *g->c);
    for (size_t c = 0; c < s->term_count; c++) {
        const algsurf_term *t = &s->terms[c];
        algsurf_z_add_double(coefficient(g, *index_of(g, 0, t->i, t->j, t->k)), g->width, t->a,
                             unit_of(y, t) - y->least);
    }
    on_lines(g, f, shift_line);
    return 1;
}

/* ---- the stream ---- */

/* The coefficient of w_0^e[0] w_1^e[1] w_2^e[2]: its magnitude, below 2^bits and at least 2^(bits-1). */
typedef struct entry {
    int e[3], bits;
    algsurf_limb sign; /* all ones: negative */
    const algsurf_limb *limb;
} entry;

static int length_of(const entry *a) { return (a->bits + 63) / 64; }

static algsurf_limb *write_entry(algsurf_limb *to, const entry *a) {
    *to++ = (algsurf_limb)a->bits << 32 | (a->sign & 1) << 24 | (algsurf_limb)a->e[2] << 16 |
            (algsurf_limb)a->e[1] << 8 | (algsurf_limb)a->e[0];
    memcpy(to, a->limb, (size_t)length_of(a) * sizeof *to);
    return to + length_of(a);
}

static entry read_entry(const algsurf_limb *from) {
    algsurf_limb head = *from;
    entry a = {{(int)(head & 255), (int)(head >> 8 & 255), (int)(head >> 16 & 255)},
               (int)(head >> 32),
               0 - (head >> 24 & 1),
               from + 1};
    return a;
}

/* The coefficient at these exponents, made a magnitude; bits 0: it is 0. */
static entry take_entry(const grid *g, int i, int j, int k) {
    entry a = {{i, j, k}, 0, 0, NULL};
    uint64_t index = *index_of(g, 0, i, j, k);
    if (index == 0) return a;
    algsurf_limb *c = coefficient(g, index);
    a.limb = c;
    if (algsurf_z_negative(c, g->width)) algsurf_z_negate(c, g->width), a.sign = ~a.sign;
    int length = algsurf_z_length(c, g->width);
    if (length) a.bits = 64 * (length - 1) + algsurf_limb_bits(c[length - 1]);
    return a;
}

/* The stream of all of them; returns its end. */
static algsurf_limb *write_all(const grid *g, algsurf_i_exact_eye *y, algsurf_limb *to) {
    y->stream = to;
    for (int k = g->n; k >= 0; k--)
        for (int j = g->n - k; j >= 0; j--)
            for (int i = g->n - k - j; i >= 0; i--) {
                entry a = take_entry(g, i, j, k);
                if (a.bits == 0) continue;
                if (y->bits[i + j + k] < a.bits) y->bits[i + j + k] = a.bits;
                to = write_entry(to, &a), y->count++;
            }
    return to;
}

static int make(algsurf_memory *m, algsurf_memory *work, const algsurf_surface *s, const double eye[3],
                algsurf_i_exact_eye *y) {
    algsurf_i_exact_axis f[3];
    grid g = {.n = s->degree};
    size_t used;
    choose_units(eye, y->unit);
    for (int i = 0; i < 3; i++) algsurf_i_exact_axis_in_unit(&f[i], eye[i], 0, 0, y->unit[i]);
    g.width = algsurf_z_width(measure(s, f, y));
    if (!shift(work, s, y, f, &g, &used)) return 0;
    algsurf_limb *stream = algsurf_memory_take(m, used * (size_t)(g.width + 1));
    if (!stream) return 0;
    algsurf_memory_mark kept = algsurf_memory_here(m);
    kept.at = write_all(&g, y, stream);
    algsurf_memory_release(m, kept);
    return 1;
}

int algsurf_i_exact_eye_make(algsurf_memory *m, const algsurf_surface *s, const double eye[3],
                             algsurf_i_exact_eye *y) {
    algsurf_memory work; /* a stack of its own: all of it is given back, the stream stays */
    algsurf_memory_begin(&work, NULL, 0, m->limit - m->allocated);
    algsurf_memory_mark empty = algsurf_memory_here(&work);
    *y = (algsurf_i_exact_eye){.degree = s->degree};
    int done = make(m, &work, s, eye, y);
    algsurf_memory_release(&work, empty);
    return done;
}

/* ---- for a ray ---- */

typedef struct scheme {
    const algsurf_limb *next; /* in the stream */
    size_t left;
    algsurf_i_exact_axis axis[3]; /* y v: f[0] = 0 */
    algsurf_i_exact_sum sum[2];   /* of the rows of one power of y_2, of all */
    algsurf_limb *spare;
    const algsurf_limb *power[ALGSURF_MAX_DEGREE + 1]; /* of |y_0|, magnitudes */
    int length[ALGSURF_MAX_DEGREE + 1];
} scheme;

/* The coarsest parameter with integers y: 2^own times each component of the direction is a multiple of the
 * unit. */
static int choose_exponent(const algsurf_i_exact_eye *y, const double direction[3]) {
    int own = 0, some = 0;
    for (int i = 0; i < 3; i++) {
        int least = y->unit[i] - algsurf_i_exact_span_of(direction[i]).low;
        if (direction[i] != 0 && (!some || least > own)) own = least, some = 1;
    }
    return own;
}

/* Words for the powers of y_0, those of a product included. */
static size_t power_words(int n, int bits) {
    size_t words = 0;
    for (int i = 0; i <= n; i++) words += (size_t)algsurf_z_width(i * bits);
    return words;
}

static void make_powers(scheme *h, int n, algsurf_limb *room) {
    const algsurf_i_exact_factor *f = &h->axis[0].f[1];
    *room = 1;
    h->power[0] = room, h->length[0] = 1;
    for (int i = 1, width = 1; i <= n; i++) {
        const algsurf_limb *before = room;
        int wider = algsurf_z_width(i * h->axis[0].bits);
        room += width;
        algsurf_z_zero(room, wider);
        algsurf_z_add_product(room, wider, before, width, f->low, f->at);
        if (f->high) algsurf_z_add_product(room, wider, before, width, f->high, f->at + 1);
        h->power[i] = room, h->length[i] = algsurf_z_length(room, wider);
        width = wider;
    }
}

/* r = a b of magnitudes, na + nb limbs. */
static void multiply(algsurf_limb *r, const algsurf_limb *a, int na, const algsurf_limb *b, int nb) {
    for (int j = 0; j < nb; j++) {
        algsurf_limb carry = 0;
        for (int i = 0; i < na; i++) {
            algsurf_limb before = j ? r[i + j] : 0;
            r[i + j] = algsurf_limb_product(a[i], b[j], before, carry, &carry);
        }
        r[na + j] = carry;
    }
}

/* Adds a y_0^i to coefficient i. */
static void add_entry(scheme *h, const entry *a, algsurf_i_exact_sum *sum) {
    int i = a->e[0], width = sum->width, length = length_of(a) + h->length[i];
    algsurf_limb *r = sum->c + (size_t)i * sum->stride, *product = h->spare;
    algsurf_limb sign = i % 2 ? a->sign ^ h->axis[0].f[1].sign : a->sign;
    unsigned char carry = sign & 1; /* -x = ~x + 1 */
    multiply(product, a->limb, length_of(a), h->power[i], h->length[i]);
    if (length > width) length = width; /* 0 above */
    for (int k = 0; k < length; k++) r[k] = algsurf_limb_add(r[k], product[k] ^ sign, &carry);
    for (int k = length; k < width; k++) r[k] = algsurf_limb_add(r[k], sign, &carry);
}

static int same_row(const entry *a, const entry *b) { return a->e[1] == b->e[1] && a->e[2] == b->e[2]; }

/* Adds the coefficients with the next one's powers of w_1 and w_2. */
static void add_row(scheme *h, algsurf_i_exact_sum *sum) {
    entry first = read_entry(h->next), a = first;
    const algsurf_limb *at = h->next, *end = at;
    int bits = 0, count = 0;
    for (; h->left && same_row(&a, &first); h->left--, count++) {
        if (bits < a.bits + a.e[0] * h->axis[0].bits) bits = a.bits + a.e[0] * h->axis[0].bits;
        end = a.limb + length_of(&a);
        if (h->left > 1) a = read_entry(end);
    }
    h->next = end;
    algsurf_i_exact_sum_expect(sum, first.e[0], bits, 1);
    for (; count > 0; count--) {
        a = read_entry(at), at = a.limb + length_of(&a);
        if (h->length[a.e[0]]) add_entry(h, &a, sum);
    }
}

/* Does the next coefficient belong to the same power of the axes outside of this one? */
static int goes_on(const scheme *h, const entry *a, int axis) {
    return h->left && (axis > 1 || read_entry(h->next).e[2] == a->e[2]);
}

/* Horner's scheme in y_axis v. */
static void evaluate(scheme *h, int axis) {
    algsurf_i_exact_sum *sum = &h->sum[axis - 1];
    int more = 1;
    sum->degree = -1;
    while (more) {
        entry a = read_entry(h->next);
        if (axis == 1) {
            add_row(h, sum);
        } else {
            evaluate(h, 1);
            algsurf_i_exact_sum_add(sum, &h->sum[0]);
        }
        more = goes_on(h, &a, axis);
        int steps = a.e[axis] - (more ? read_entry(h->next).e[axis] : 0);
        while (steps-- > 0) algsurf_i_exact_sum_times(sum, &h->axis[axis], h->spare);
    }
}

/* Bits of every sum on the way. */
static int bound(const algsurf_i_exact_eye *y, const algsurf_i_exact_axis axis[3]) {
    int most = 0, bits = 0;
    for (int i = 0; i < 3; i++)
        if (axis[i].bits > most) most = axis[i].bits;
    for (int k = 0; k <= y->degree; k++)
        if (y->bits[k] && y->bits[k] + k * most > bits) bits = y->bits[k] + k * most;
    return bits + algsurf_limb_bits(y->count - 1);
}

static int take_work(algsurf_memory *m, scheme *h, int degree, int bits) {
    size_t stride = (size_t)algsurf_z_width(bits), size = (size_t)(degree + 1) * stride;
    /* spare: a product may have a limb more than its bits need */
    algsurf_limb *room = algsurf_memory_take(m, 2 * size + stride + 2 + power_words(degree, h->axis[0].bits));
    if (!room) return 0;
    for (int i = 0; i < 2; i++) h->sum[i].stride = stride, h->sum[i].c = room + (size_t)i * size;
    h->spare = room + 2 * size;
    make_powers(h, degree, h->spare + stride + 2);
    return 1;
}

int algsurf_i_exact_eye_form(algsurf_memory *m, const algsurf_i_exact_eye *y, const double direction[3],
                             int e, algsurf_zpoly *p, int *scale) {
    scheme h;
    algsurf_i_exact_result result;
    int own = choose_exponent(y, direction);
    h.next = y->stream, h.left = y->count;
    for (int i = 0; i < 3; i++) algsurf_i_exact_axis_in_unit(&h.axis[i], 0, direction[i], own, y->unit[i]);
    int bits = bound(y, h.axis);
    if (!algsurf_i_exact_form_begin(m, y->degree, bits, e - own, &result)) return 0;
    if (!take_work(m, &h, y->degree, bits)) {
        algsurf_memory_release(m, result.before);
        return 0;
    }
    evaluate(&h, 2);
    int low = algsurf_i_exact_form_end(m, &result, &h.sum[1], p);
    if (scale) *scale = p->degree < 0 ? 0 : -(y->least + low);
    return 1;
}
