/* exact_radii.c - Descartes' rule for a set of polynomials, from its lower and its upper envelope.
 *
 * For u >= 0 each polynomial q of the set has p - radius <= q <= p + radius, coefficient by coefficient.  The
 * Bernstein coefficient b_j of u^k over [a, b], 0 <= a < b, is a mean of products of a's and b's, hence not
 * negative: every b_j of q lies between those of the two envelopes, and where both have one sign, q has it,
 * too. The other signs are unknown, and the most variations that any choice of them allows are
 * - none: no polynomial has a root in the open cell;
 * - one, with known signs at both ends: each polynomial has exactly one;
 * - more: the cell is halved, unless no sign is known in it, or no double is inside.  Then it is undecided.
 *
 * In a cell with one root the envelopes' own roots enclose those of all others: at doubles on their left both
 * have the sign at the left end, and bisection finds the last of these.
 *
 * Negative u are those of p(-u), in reverse order. */
#include <math.h>

#include "exact_radii.h"

enum { UNKNOWN = 2 };

/* One side of 0: u >= 0 after a reflection of the side below 0. */
typedef struct side {
    algsurf_memory *memory;
    algsurf_zpoly envelope[2];
    algsurf_exact_piece piece;
    int unit, mirrored;
    double lo, hi; /* 0 <= lo <= hi: what is asked for */
    algsurf_exact_range *found;
    int capacity, count;
} side;

/* Part of a piece taken as [0,1]: [position, position + 1] 2^-depth. */
typedef struct part {
    algsurf_zpoly b[2];
    const algsurf_limb *position;
    int width, depth;
} part;

static int both(int a, int b) { return a == b ? a : UNKNOWN; }

static int sign_of(const part *c, int j) {
    return both(algsurf_z_sign(algsurf_zpoly_at(c->b, j), c->b[0].width),
                algsurf_z_sign(algsurf_zpoly_at(c->b + 1, j), c->b[1].width));
}

/* The sign of all polynomials at t >= 0; *sign is UNKNOWN if they differ. */
static int sign_at(const side *s, double t, int *sign) {
    int e, at[2];
    algsurf_limb N = algsurf_z_odd_part(t, &e);
    for (int i = 0; i < 2; i++)
        if (!algsurf_zpoly_sign_at(s->memory, s->envelope + i, &N, 1, N ? s->unit - e : 0, at + i, NULL,
                                   NULL))
            return 0;
    *sign = both(at[0], at[1]);
    return 1;
}

/* The most variations: the longest chains that end with -, with +, each sign as it can be. */
static int most_variations(const part *c, int *known) {
    int most[2] = {-1, -1}; /* -1: no chain yet */
    *known = 0;
    for (int j = 0; j <= c->b[0].degree; j++) {
        int sign = sign_of(c, j), minus = most[0], plus = most[1];
        *known += sign == 1 || sign == -1;
        if (sign == 0) continue;
        int to_minus = plus + 1 > minus ? plus + 1 : minus, to_plus = minus + 1 > plus ? minus + 1 : plus;
        if (sign == UNKNOWN) {
            most[0] = to_minus > 0 ? to_minus : 0;
            most[1] = to_plus > 0 ? to_plus : 0;
        } else {
            most[sign > 0] = sign > 0 ? (to_plus > 0 ? to_plus : 0) : (to_minus > 0 ? to_minus : 0);
        }
    }
    return most[0] > most[1] ? most[0] : most[1];
}

/* ---- what is found ---- */

/* Appends a range within [lo,hi]; ranges that overlap, and undecided ones that touch, become one. */
static void append(side *s, double lo, double hi, int sign) {
    algsurf_exact_range *last = s->found + s->count - 1;
    lo = fmax(lo, s->lo), hi = fmin(hi, s->hi);
    if (lo > hi) return;
    int joins = s->count > 0 && (lo < last->hi || (lo == last->hi && sign == 0 && last->sign_lo == 0));
    if (joins || s->count == s->capacity) {
        last->hi = hi > last->hi ? hi : last->hi;
        last->sign_lo = 0;
    } else {
        s->found[s->count++] = (algsurf_exact_range){lo + 0.0, hi + 0.0, sign};
    }
}

static uint64_t bits_of(double t) {
    uint64_t bits;
    memcpy(&bits, &t, sizeof bits);
    return bits;
}
static double of_bits(uint64_t bits) {
    double t;
    memcpy(&t, &bits, sizeof t);
    return t;
}

/* Of the doubles from a, where the predicate (the sign is `sign`) is `at_a`, to b, where it is not: the last
 * one before it changes. */
static int last_before_change(const side *s, double a, double b, int sign, int at_a, double *last) {
    uint64_t from = bits_of(a), to = bits_of(b); /* not negative: in the order of their bits */
    while (to - from > 1) {
        int found;
        uint64_t middle = from + (to - from) / 2;
        if (!sign_at(s, of_bits(middle), &found)) return 0;
        if ((found == sign) == at_a)
            from = middle;
        else
            to = middle;
    }
    *last = of_bits(from);
    return 1;
}

/* One root of each polynomial in the open cell, between the doubles lo and hi around it; first and last are
 * those in it.  Then what of it can be in [s->lo, s->hi]. */
static int shrink(const side *s, double first, double last, int before, double *lo, double *hi) {
    int at_first, at_last;
    if (first > last) return 1;
    if (!sign_at(s, first, &at_first) || !sign_at(s, last, &at_last)) return 0;
    if (at_first == -before || at_first == 0) *hi = first;
    if (at_last == before || at_last == 0) *lo = last;
    if (at_first == 0) *lo = first;
    if (at_last == 0) *hi = last;
    if (*hi == first || *lo == last) return 1;
    if (at_first == before && !last_before_change(s, first, last, before, 1, lo)) return 0;
    if (at_last == -before) {
        double inner;
        if (!last_before_change(s, first, last, -before, 0, &inner)) return 0;
        *hi = of_bits(bits_of(inner) + 1);
    }
    return 1;
}

/* Is the root in the range asked for?  Decided at its ends.  Signs there that are not those on both sides of
 * the root leave it undecided: unknown ones, or those beyond another root, where an end is no double. */
static int append_root(side *s, double lo, double hi, int before) {
    int at_lo, at_hi;
    double from = fmax(lo, s->lo), to = fmin(hi, s->hi);
    if (from > to) return 1;
    if (!sign_at(s, from, &at_lo) || !sign_at(s, to, &at_hi)) return 0;
    if (from > lo && at_lo == -before) return 1;
    if (to < hi && at_hi == before) return 1;
    if (at_lo == 0 && from > lo && from < hi) to = from; /* in the cell: its root, of all polynomials */
    if (at_hi == 0 && to > lo && to < hi) from = to;
    int shown = from < to ? at_lo == before && at_hi == -before : at_lo == 0 || at_hi == 0;
    append(s, from, to, shown ? before : 0);
    return 1;
}

/* The doubles about the part: round[0] <= a <= round[1], round[2] <= b <= round[3]. */
static int part_ends(const side *s, const part *c, double round[4]) {
    const algsurf_exact_piece *piece = &s->piece;
    algsurf_memory_mark mark = algsurf_memory_here(s->memory);
    int w = algsurf_z_width(c->depth + piece->length + 66);
    algsurf_limb *a = algsurf_memory_take(s->memory, 2 * (size_t)w), *b = a ? a + w : NULL;
    const algsurf_limb one = 1;
    if (!a) return 0;
    algsurf_z_copy(b, w, c->position, c->width);
    algsurf_z_shift_up(b, w, piece->length);
    algsurf_z_set(a, w, piece->at);
    algsurf_z_shift_up(a, w, c->depth);
    algsurf_z_add(a, b, w);
    algsurf_z_copy(b, w, a, w);
    algsurf_z_add_product(b, w, &one, 1, (algsurf_limb)1 << piece->length, 0);
    int e = piece->unit - c->depth;
    round[0] = algsurf_z_round_down(a, w, e), round[1] = algsurf_z_round_up(a, w, e);
    round[2] = algsurf_z_round_down(b, w, e), round[3] = algsurf_z_round_up(b, w, e);
    algsurf_memory_release(s->memory, mark);
    return 1;
}

/* ---- halving ---- */

/* De Casteljau's scheme with sums, as in exact_cell.c, into room of the halves' own. */
static int halve(algsurf_memory *m, const algsurf_zpoly *b, algsurf_zpoly *left, algsurf_zpoly *right) {
    int n = b->degree, w = algsurf_z_width(algsurf_zpoly_bits(b) + n + 1);
    if (!algsurf_zpoly_new(m, n, w, left) || !algsurf_zpoly_copy(m, b, w, right)) return 0;
    for (int i = 0; i <= n; i++) {
        algsurf_z_copy(algsurf_zpoly_at(left, i), w, algsurf_zpoly_at(right, 0), w);
        algsurf_z_shift_up(algsurf_zpoly_at(left, i), w, n - i);
        for (int j = 0; j < n - i; j++)
            algsurf_z_add(algsurf_zpoly_at(right, j), algsurf_zpoly_at(right, j + 1), w);
        algsurf_z_shift_up(algsurf_zpoly_at(right, n - i), w, i < n ? n - i : 0);
    }
    algsurf_zpoly_cut(left, algsurf_zpoly_trailing(left));
    algsurf_zpoly_cut(right, algsurf_zpoly_trailing(right));
    return 1;
}

static int halves_of(algsurf_memory *m, const part *c, part half[2]) {
    int width = algsurf_z_width(c->depth + 2);
    for (int i = 0; i < 2; i++) {
        algsurf_limb *position = algsurf_memory_take(m, (size_t)width);
        if (!position || !halve(m, c->b + i, &half[0].b[i], &half[1].b[i])) return 0;
        algsurf_z_copy(position, width, c->position, c->width);
        algsurf_z_shift_up(position, width, 1);
        position[0] |= (algsurf_limb)i;
        half[i].position = position;
        half[i].width = width;
        half[i].depth = c->depth + 1;
    }
    return 1;
}

/* The ranges in [a, b) of the part; depth is bounded, as parts without a double inside are not halved. */
static int search(side *s, const part *c) {
    double round[4];
    int n = c->b[0].degree, known, before = sign_of(c, 0), after = sign_of(c, n);
    int most = most_variations(c, &known);
    if (most < 0) return 1; /* only zeros: p = 0 is not asked */
    if (!part_ends(s, c, round)) return 0;
    if (round[0] > s->hi || round[3] < s->lo) return 1;
    if (before == 0) append(s, round[0], round[1], 0);
    if (most == 0 && before != UNKNOWN && after != UNKNOWN) return 1;
    if (most == 1 && before * after == -1) {
        double lo = round[0], hi = round[3];
        return shrink(s, round[1], round[2], before, &lo, &hi) && append_root(s, lo, hi, before);
    }
    if (known == 0 || nextafter(round[0], HUGE_VAL) >= round[3]) {
        append(s, round[0], round[3], 0);
        return 1;
    }
    part half[2];
    algsurf_memory_mark mark = algsurf_memory_here(s->memory);
    int done = halves_of(s->memory, c, half) && search(s, half) && search(s, half + 1);
    algsurf_memory_release(s->memory, mark);
    return done;
}

/* ---- both sides ---- */

/* p(-u) - or + radius. */
static int make_envelope(algsurf_memory *m, const algsurf_zpoly *p, const algsurf_zpoly *radius, int mirrored,
                         int upper, algsurf_zpoly *envelope) {
    int bits = algsurf_zpoly_bits(p), more = algsurf_zpoly_bits(radius);
    int w = algsurf_z_width((bits > more ? bits : more) + 2);
    int n = p->degree > radius->degree ? p->degree : radius->degree;
    if (!algsurf_zpoly_new(m, n, w, envelope)) return 0;
    for (int k = 0; k <= n; k++) {
        algsurf_limb *c = algsurf_zpoly_at(envelope, k);
        if (k <= p->degree) algsurf_z_copy(c, w, algsurf_zpoly_at(p, k), p->width);
        if (mirrored && k % 2) algsurf_z_negate(c, w);
        if (k > radius->degree) continue;
        if (upper)
            algsurf_z_add_product(c, w, algsurf_zpoly_at(radius, k), radius->width, 1, 0);
        else
            algsurf_z_sub_product(c, w, algsurf_zpoly_at(radius, k), radius->width, 1, 0);
    }
    return 1;
}

/* c(2^shift u), up to a power of two. */
static int rescale(algsurf_memory *m, const algsurf_zpoly *c, int shift, algsurf_zpoly *r) {
    int n = c->degree, up = shift < 0 ? -shift : shift;
    if (!algsurf_zpoly_copy(m, c, algsurf_z_width(algsurf_zpoly_bits(c) + up * n), r)) return 0;
    for (int k = 0; k <= n; k++)
        algsurf_z_shift_up(algsurf_zpoly_at(r, k), r->width, up * (shift < 0 ? n - k : k));
    algsurf_zpoly_cut(r, algsurf_zpoly_trailing(r));
    return 1;
}

static int search_side(side *s, const algsurf_zpoly *p, const algsurf_zpoly *radius) {
    const algsurf_limb zero = 0;
    part whole = {.position = &zero, .width = 1};
    s->piece = algsurf_exact_piece_of(s->lo, s->hi);
    for (int i = 0; i < 2; i++) {
        algsurf_zpoly local;
        if (!make_envelope(s->memory, p, radius, s->mirrored, i, s->envelope + i) ||
            !rescale(s->memory, s->envelope + i, s->piece.unit - s->unit, &local) ||
            !algsurf_zpoly_bernstein(s->memory, &local, s->piece.at, s->piece.length, whole.b + i))
            return 0;
    }
    return search(s, &whole);
}

/* The ranges of the side below 0 into the order of t. */
static void reflect(algsurf_exact_range *found, int count) {
    for (int i = 0; 2 * i < count; i++) {
        algsurf_exact_range a = found[i], b = found[count - 1 - i];
        found[i] = (algsurf_exact_range){0 - b.hi, 0 - b.lo, -b.sign_lo};
        found[count - 1 - i] = (algsurf_exact_range){0 - a.hi, 0 - a.lo, -a.sign_lo};
    }
}

/* Ranges of both sides that meet at 0 are one: undecided, or the root 0 itself, seen from both sides. */
static int join_at_zero(algsurf_exact_range *found, int below, int all) {
    if (below == 0 || below == all || found[below - 1].hi < 0 || found[below].lo > 0) return all;
    found[below - 1].hi = found[below].hi;
    found[below - 1].sign_lo = 0;
    for (int i = below; i + 1 < all; i++) found[i] = found[i + 1];
    return all - 1;
}

int algsurf_exact_radii_isolate(algsurf_memory *m, const algsurf_zpoly *p, const algsurf_zpoly *radius,
                                int unit, double lo, double hi, algsurf_exact_range *found, int capacity,
                                int *count) {
    algsurf_memory_mark mark = algsurf_memory_here(m);
    int done = 1, below = 0, above = 0;
    if (lo < 0) {
        side s = {.memory = m, .unit = unit, .mirrored = 1, .found = found, .capacity = capacity};
        s.lo = hi < 0 ? -hi : 0, s.hi = -lo;
        done = search_side(&s, p, radius);
        below = s.count;
        reflect(found, below);
        algsurf_memory_release(m, mark);
    }
    if (done && hi >= 0) {
        int full = below == capacity; /* then the last range of the side below is joined with what follows */
        side s = {
            .memory = m, .unit = unit, .found = found + below - full, .capacity = capacity - below + full};
        algsurf_exact_range last = full ? found[below - 1] : (algsurf_exact_range){0, 0, 0};
        s.lo = lo > 0 ? lo : 0, s.hi = hi;
        done = search_side(&s, p, radius);
        above = s.count;
        algsurf_memory_release(m, mark);
        if (full && above) s.found[0] = (algsurf_exact_range){last.lo, s.found[0].hi, 0};
        if (full && !above) s.found[0] = last;
        above -= full && above;
    }
    *count = join_at_zero(found, below, below + above);
    return done;
}
