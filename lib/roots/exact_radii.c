/* exact_radii.c - Descartes' rule for a set of polynomials, from its lower and its upper envelope.
 *
 * For u >= 0 each polynomial q of the set has p - radius <= q <= p + radius, coefficient by coefficient.  The
 * Bernstein coefficient b_j of u^k over [a, b], 0 <= a < b, is a mean of products of a's and b's, hence not
 * negative: every b_j of q lies between those of the two envelopes, and where both have one sign, q has it,
 * too.  For u <= 0 that holds for -u; the envelopes there are p(u) -+ radius(-u).  The other signs are
 * unknown, and the most variations that any choice of them allows are
 * - none: no polynomial has a root in the open cell;
 * - one, with known signs at both ends: each polynomial has exactly one;
 * - more: the cell is halved, unless no sign is known in it, or no double is inside.  Then it is undecided.
 *
 * In a cell with one root the envelopes' own roots enclose those of all others: at doubles on their left both
 * have the sign at the left end, and bisection finds the last of these.
 *
 * A root that may be on either side of 0, or of a power of two between two pieces, is in no cell of all
 * polynomials.  So a range that stays undecided is asked for roots of the derivatives, which are a set of
 * their own: without any, and with different signs at its ends, it has exactly one root of each polynomial.
 */
#include "../base/arithmetic.h"
#include <float.h>
#include <math.h>

#include "exact_radii.h"

/* Cells of [2^e, 2^(e+1)] are between neighbouring doubles after 52 halvings; those of [0, 2^e] have roots of
 * the envelopes down to 2^(e-10), and 62 are enough.  An interval that is one piece is longer than 1/8 of it
 * or than 2^-40 of its numbers, which are less than 2^6 times each other: 2^-59 of its length is between
 * neighbours, too, hence 2^-62 of the piece's.  (What found no room would be undecided.) */
enum { MOST_WAITING = 64, UNKNOWN = 2 };

typedef struct set {
    algsurf_exact_cells cells;
    algsurf_exact_pieces pieces;
    algsurf_exact_piece piece;
    algsurf_zpoly envelope[2][2]; /* for u below 0 and above: lower and upper */
    int unit;
    double lo, hi; /* what is asked for */
    algsurf_exact_range *found;
    int capacity, count;
} set;

/* The sign of all polynomials whose envelopes have these signs. */
static int both(int lower, int upper) { return lower == upper ? lower : UNKNOWN; }

static int sign_of(const algsurf_exact_cell *cell, int j) {
    return both(algsurf_exact_lower_sign(cell, j), algsurf_exact_upper_sign(cell, j));
}

static int sign_at(const set *s, double t, int *sign) {
    int at[2];
    for (int i = 0; i < 2; i++)
        if (!algsurf_exact_at_double(s->cells.memory, &s->envelope[t >= 0][i], s->unit, t, at + i, NULL,
                                     NULL))
            return 0;
    *sign = both(at[0], at[1]);
    return 1;
}

/* ---- what is found ---- */

/* Appends a range within [lo,hi]; ranges that overlap, and undecided ones that touch, become one. */
static void append(set *s, double lo, double hi, int sign) {
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

/* Of the doubles from a, where the predicate (the sign is `sign`) is `at_a`, to b, where it is not: the last
 * one before it changes. */
static int last_before_change(const set *s, double a, double b, int sign, int at_a, double *last) {
    uint64_t from = algsurf_exact_order_of(a), to = algsurf_exact_order_of(b);
    while (to - from > 1) {
        int found;
        uint64_t middle = from + (to - from) / 2;
        if (!sign_at(s, algsurf_exact_double_at(middle), &found)) return 0;
        if ((found == sign) == at_a)
            from = middle;
        else
            to = middle;
    }
    *last = algsurf_exact_double_at(from);
    return 1;
}

/* One root of each polynomial between the doubles lo and hi, which may be too far out; first and last are the
 * doubles that are not.  Shrinks lo and hi. */
static int shrink(const set *s, double first, double last, int before, double *lo, double *hi) {
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
        *hi = nextafter(inner, HUGE_VAL);
    }
    return 1;
}

/* Is the root in the range asked for?  Decided at its ends.  Signs there that are not those on both sides of
 * the root leave it undecided: unknown ones, or those beyond another root, where an end is no double.  What
 * is beyond the largest double needs no question: other roots there have ranges that overlap. */
static int append_root(set *s, double lo, double hi, int before) {
    double from = fmax(lo, s->lo), to = fmin(hi, s->hi);
    int at_lo = before, at_hi = -before;
    if (from > to) return 1;
    if ((isfinite(from) && !sign_at(s, from, &at_lo)) || (isfinite(to) && !sign_at(s, to, &at_hi))) return 0;
    if (from > lo && at_lo == -before) return 1;
    if (to < hi && at_hi == before) return 1;
    if (at_lo == 0 && from > lo && from < hi) to = from; /* in the cell: its root, of all polynomials */
    if (at_hi == 0 && to > lo && to < hi) from = to;
    int shown = from < to ? at_lo == before && at_hi == -before : at_lo == 0 || at_hi == 0;
    append(s, from, to, shown ? before : 0);
    return 1;
}

/* The doubles about the cell: round[0] <= a <= round[1], round[2] <= b <= round[3]. */
static int round_ends(const set *s, double round[4]) {
    algsurf_memory *m = s->cells.memory;
    algsurf_memory_mark mark = algsurf_memory_here(m);
    algsurf_limb *a, *b;
    int w, r;
    if (!algsurf_exact_cell_ends(m, &s->cells.cell, &s->piece, s->unit, &a, &b, &w, &r)) return 0;
    round[0] = algsurf_z_round_down(a, w, s->unit - r), round[1] = algsurf_z_round_up(a, w, s->unit - r);
    round[2] = algsurf_z_round_down(b, w, s->unit - r), round[3] = algsurf_z_round_up(b, w, s->unit - r);
    algsurf_memory_release(m, mark);
    return 1;
}

/* ---- the walk ---- */

static int knows_a_sign(const algsurf_exact_cell *cell) {
    for (int j = 0; j <= cell->b.degree; j++)
        if (sign_of(cell, j) * sign_of(cell, j) == 1) return 1;
    return 0;
}

/* The range in the cell, if any: 1; 0 when the cell has to be halved, -1 without memory. */
static int settle_cell(set *s) {
    algsurf_exact_cell *cell = &s->cells.cell;
    double round[4];
    int before = sign_of(cell, 0), after = sign_of(cell, cell->b.degree);
    if (!round_ends(s, round)) return -1;
    if (round[0] > s->hi || round[3] < s->lo) return 1;
    if (algsurf_exact_begins_with_root(cell)) append(s, round[0], round[1], 0);
    cell->left_done = 1;
    if (cell->variations == 0) return 1;
    if (cell->variations == 1 && before * after == -1) {
        double lo = round[0], hi = round[3];
        return shrink(s, round[1], round[2], before, &lo, &hi) && append_root(s, lo, hi, before) ? 1 : -1;
    }
    if (knows_a_sign(cell) && nextafter(round[0], HUGE_VAL) < round[3] && s->cells.count < s->cells.room)
        return 0;
    append(s, round[0], round[3], 0);
    return 1;
}

/* The ranges in the piece, without its right end. */
static int search_piece(set *s) {
    algsurf_memory_mark mark = algsurf_memory_here(s->cells.memory);
    int done = algsurf_exact_cells_open(&s->cells, s->envelope[s->piece.at >= 0], 2, s->unit, &s->piece);
    while (done && s->cells.active) {
        int settled = settle_cell(s);
        done = settled > 0 || (settled == 0 && algsurf_exact_cells_halve(&s->cells));
        if (settled > 0) algsurf_exact_cells_next(&s->cells);
    }
    algsurf_memory_release(s->cells.memory, mark);
    return done;
}

static int walk(set *s) {
    const algsurf_exact_pieces *pieces = &s->pieces;
    algsurf_exact_pieces_begin(&s->pieces, s->envelope[0], s->envelope[1], 2, s->unit, s->lo, s->hi);
    int done = 1, piece;
    while (done && (piece = algsurf_exact_pieces_next(&s->pieces, &s->piece)) != ALGSURF_EXACT_NO_PIECE) {
        if (piece == ALGSURF_EXACT_PIECE)
            done = search_piece(s);
        else if (piece == ALGSURF_EXACT_ZERO)
            append(s, 0, 0, 0);
        else if (s->piece.at < 0)
            append(s, -pieces->far, -pieces->near, 0);
        else
            append(s, pieces->near, pieces->far, 0);
    }
    return done;
}

/* p(u) - or + radius(|u|). */
static int make_envelope(algsurf_memory *m, const algsurf_zpoly *p, const algsurf_zpoly *radius, int above,
                         int upper, algsurf_zpoly *envelope) {
    int bits = algsurf_zpoly_bits(p), more = algsurf_zpoly_bits(radius);
    int w = algsurf_z_width((bits > more ? bits : more) + 2);
    int n = p->degree > radius->degree ? p->degree : radius->degree;
    if (!algsurf_zpoly_new(m, n, w, envelope)) return 0;
    for (int k = 0; k <= n; k++) {
        algsurf_limb *c = algsurf_zpoly_at(envelope, k);
        if (k <= p->degree) algsurf_z_copy(c, w, algsurf_zpoly_at(p, k), p->width);
        if (k > radius->degree) continue;
        if (upper == (above || k % 2 == 0))
            algsurf_z_add_product(c, w, algsurf_zpoly_at(radius, k), radius->width, 1, 0);
        else
            algsurf_z_sub_product(c, w, algsurf_zpoly_at(radius, k), radius->width, 1, 0);
    }
    return 1;
}

static int isolate(set *s, const algsurf_zpoly *p, const algsurf_zpoly *radius,
                   const algsurf_i_watch *watch) {
    algsurf_memory *m = s->cells.memory;
    int vanishes = 0; /* p = 0 is one of the set */
    for (int i = 0; i < 4; i++) {
        algsurf_zpoly *envelope = &s->envelope[i / 2][i % 2];
        if (!make_envelope(m, p, radius, i / 2, i % 2, envelope)) return 0;
        vanishes = vanishes || algsurf_zpoly_trailing(envelope) == ALGSURF_Z_NO_BIT;
    }
    if (!vanishes) return algsurf_exact_cells_begin(&s->cells, m, MOST_WAITING, watch) && walk(s);
    append(s, s->lo, s->hi, 0);
    return 1;
}

int algsurf_exact_radii_sign(algsurf_memory *m, const algsurf_zpoly *p, const algsurf_zpoly *radius, int unit,
                             double t, int *sign) {
    algsurf_memory_mark mark = algsurf_memory_here(m);
    set s = {.unit = unit};
    s.cells.memory = m;
    int done = make_envelope(m, p, radius, t >= 0, 0, &s.envelope[t >= 0][0]) &&
               make_envelope(m, p, radius, t >= 0, 1, &s.envelope[t >= 0][1]) && sign_at(&s, t, sign);
    algsurf_memory_release(m, mark);
    return done;
}

/* ---- ranges with one root ---- */

/* Moves the end t of a range outwards to a double with a known sign, if it is the next one. */
static int find_known_sign(const set *s, double outwards, double *t, int *sign) {
    if (!sign_at(s, *t, sign)) return 0;
    if (*sign * *sign == 1) return 1;
    *t = nextafter(*t, outwards);
    return sign_at(s, *t, sign);
}

/* The undecided range i, if it is shown that each polynomial has one root in it. */
static int decide_range(set *s, const algsurf_zpoly *slope, const algsurf_zpoly *radius, int i) {
    algsurf_exact_range *range = s->found + i, any;
    double lo = range->lo, hi = range->hi;
    int at_lo, at_hi;
    if (range->sign_lo != 0 || isinf(lo) || isinf(hi)) return 1;
    if (!sign_at(s, lo, &at_lo)) return 0;
    if (lo == hi && at_lo == 0) return 1; /* this is the root, of all polynomials */
    if (!find_known_sign(s, -DBL_MAX, &lo, &at_lo) || !find_known_sign(s, DBL_MAX, &hi, &at_hi)) return 0;
    if (at_lo * at_hi != -1 || lo < (i > 0 ? range[-1].hi : s->lo) ||
        hi > (i + 1 < s->count ? range[1].lo : s->hi))
        return 1;
    algsurf_memory_mark mark = algsurf_memory_here(s->cells.memory);
    set slopes = {.unit = s->unit, .lo = lo, .hi = hi, .found = &any, .capacity = 1};
    slopes.cells.memory = s->cells.memory;
    int done = isolate(&slopes, slope, radius, NULL);
    algsurf_memory_release(s->cells.memory, mark);
    if (!done || slopes.count > 0) return done;
    *range = (algsurf_exact_range){lo, hi, at_lo};
    return shrink(s, lo, hi, at_lo, &range->lo, &range->hi);
}

static int decide_ranges(set *s, const algsurf_zpoly *p, const algsurf_zpoly *radius) {
    algsurf_zpoly slope, slope_radius;
    int done = algsurf_zpoly_derivative(s->cells.memory, p, &slope) &&
               algsurf_zpoly_derivative(s->cells.memory, radius, &slope_radius);
    for (int i = 0; done && i < s->count; i++) done = decide_range(s, &slope, &slope_radius, i);
    return done;
}

int algsurf_exact_radii_isolate(algsurf_memory *m, const algsurf_zpoly *p, const algsurf_zpoly *radius,
                                int unit, double lo, double hi, algsurf_exact_range *found, int capacity,
                                int *count, const algsurf_i_watch *watch) {
    algsurf_memory_mark mark = algsurf_memory_here(m);
    set s = {.unit = unit, .lo = lo, .hi = hi, .found = found, .capacity = capacity};
    s.cells.memory = m;
    int done = isolate(&s, p, radius, watch) && decide_ranges(&s, p, radius);
    algsurf_memory_release(m, mark);
    *count = s.count;
    return done;
}
