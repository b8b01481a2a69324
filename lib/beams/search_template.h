/* search_template.h - where the rays of a beam can have roots, all of them at once.
 *
 * P along the rays is one polynomial in depth, its Bernstein coefficients known as polynomials in two
 * parameters, |xi|, |eta| <= 1, that tell the rays apart: terms T_k,ij xi^i eta^j up to the second order, and
 * the size of the rest.  LANES beams are searched side by side; none of them depends on its neighbours.
 *
 * Range.  With xi^2 = 1/2 +- 1/2 and likewise eta^2,
 *     |b_k - (T_00 + T_20/2 + T_02/2)| <= |T_10| + |T_01| + |T_20|/2 + |T_02|/2 + |T_11| + rest.
 * A cut in depth is a sum with positive weights that add up to 1, of each T; so what bounds a term's size
 * before bounds it after.  The search cuts the middle and the first order, whose signs matter most, and of
 * all other terms the sizes: together, a third less to cut for no more leaves.
 *
 * Cells of depth are those of descartes_template.h.  A cell without a variation of sign, whatever the
 * coefficients in their range, has no root of any ray; one with one variation has one root of each. */
#ifndef ALGSURF_SEARCH_TEMPLATE_H
#define ALGSURF_SEARCH_TEMPLATE_H
#include "../roots/first_walk_template.h"
#include "../simd/lanes.h"
#include "../surface/beam.h"

#define BEAM_DEGREE ALGSURF_MAX_BEAM_DEGREE
#define TURNS 5          /* cells that a beam is searched in, besides the first; 4 and 6 are 2 % slower */
#define SHORTEST 0x1p-11 /* of them */

/* Terms of a beam, in this order. */
enum { T00, T10, T01, T20, T11, T02, LOW_TERMS, T30 = LOW_TERMS, T21, T12, T03, TERMS };

static const signed char term_at[4][4] = {
    {T00, T01, T02, T03}, {T10, T11, T12, TERMS}, {T20, T21, TERMS, TERMS}, {T30, TERMS, TERMS, TERMS}};

/* P along LANES beams over a part of their depths: Bernstein coefficients. */
typedef struct beam {
    lanes t[LOW_TERMS][BEAM_DEGREE + 1], rest[BEAM_DEGREE + 1];
} beam;

/* The part [from,to] of [0,1]. */
INLINE void cut_part(const lanes *whole, lanes *part, int n, lanes from, lanes to) {
    lanes w[BEAM_DEGREE + 1];
    for (int j = 0; j <= n; j++) w[j] = whole[j];
    split_shares(w, part, n, from, 1 - from);
    split_shares(w, part, n, to - from, 1 - to);
}

/* As a cell: w[0] positive, a radius for each coefficient. */
INLINE void cell_of(const beam *r, lanes rounding, cell *c, int n) {
    for (int k = 0; k <= n; k++) {
        lanes radius = r->rest[k] + rounding;
        c->w[k] = r->t[T00][k] + 0.5 * (r->t[T20][k] + r->t[T02][k]);
        for (int i = 1; i < LOW_TERMS; i++) radius += (i == T20 || i == T02 ? 0.5 : 1) * absolute(r->t[i][k]);
        c->e[k] = radius;
    }
    c->side = take_sign(c->w, n, ~no_lane());
}

/* What is known of the beams: empty; one root in [p,q], after none; or none before p. */
typedef struct verdict {
    mask empty, one;
    lanes p, q, guess;
    words side; /* of P at p: its sign bit */
} verdict;

/* A beam as it is searched: the middle of its range but for the first order; that; the size of all else. */
enum { VALUE, BY_XI, BY_ETA, ELSE, PARTS };

typedef struct search_part {
    lanes t[PARTS][BEAM_DEGREE + 1];
} search_part;

INLINE void search_part_of(const beam *whole, lanes rounding, search_part *part, int n) {
    for (int k = 0; k <= n; k++) {
        part->t[VALUE][k] = whole->t[T00][k] + 0.5 * (whole->t[T20][k] + whole->t[T02][k]);
        part->t[BY_XI][k] = whole->t[T10][k];
        part->t[BY_ETA][k] = whole->t[T01][k];
        part->t[ELSE][k] = rounding + whole->rest[k] + absolute(whole->t[T11][k]) +
                           0.5 * (absolute(whole->t[T20][k]) + absolute(whole->t[T02][k]));
    }
}

INLINE void choose_part(mask where, const search_part *a, search_part *b, int n) {
    for (int i = 0; i < PARTS; i++)
        for (int k = 0; k <= n; k++) b->t[i][k] = choose(where, a->t[i][k], b->t[i][k]);
}

/* The count of a cell whose first sign is known, nothing of others. */
INLINE signs count_part(const search_part *part, cell *c, mask *known, int n) {
    for (int k = 0; k <= n; k++) {
        c->w[k] = part->t[VALUE][k];
        c->e[k] = part->t[ELSE][k] + absolute(part->t[BY_XI][k]) + absolute(part->t[BY_ETA][k]);
    }
    c->side = take_sign(c->w, n, ~no_lane());
    *known = less(c->e[0], absolute(c->w[0]));
    signs s = count_signs(c->w, c->e, n, 1);
    return (signs){s.none & *known, s.one & *known};
}

/* The first cells of open beams, whose coefficients are off by `rounding` at most. */
APART void search(const beam *beams, lanes rounding, mask open, int n, verdict *to) {
    search_part whole, part;
    cell c = {.p = all_lanes(0), .q = all_lanes(1)};
    verdict v = {no_lane(), no_lane(), c.p, c.q, c.p, (words)c.p};
    mask known;
    if (n < 1 || n > BEAM_DEGREE) __builtin_unreachable();
    search_part_of(beams, rounding, &whole, n);
    part = whole;
    signs s = count_part(&part, &c, &known, n);
    for (int turn = 0;; turn++) {
        mask one = open & s.one, none = open & s.none, last = none & at_most(all_lanes(1), c.q);
        lanes chord_root = c.p + (c.q - c.p) * (c.w[0] / (c.w[0] - c.w[n]));
        v.empty |= last;
        v.one |= one;
        v.p = choose(open, choose(none, c.q, c.p), v.p);
        v.q = choose(one, c.q, v.q);
        v.guess = choose(one, chord_root, v.guess);
        v.side = (words)choose(one, (lanes)c.side, (lanes)v.side);
        open &= known & ~(last | one) & less(all_lanes(SHORTEST), c.q - c.p);
        if (turn == TURNS || !any(open)) break;
        const mask again = open & none, on = open & ~none;
        search_part other;
        if (any(on)) {
            lanes at = split_point(&c, n, turn);
            for (int i = 0; i < PARTS; i++) split(part.t[i], other.t[i], n, at - c.p, c.q - at);
            mask right = on & count_part(&other, &c, &known, n).none;
            c.p = choose(right, at, c.p);
            c.q = choose(on & ~right, at, c.q);
            choose_part(~right, &other, &part, n);
        }
        if (any(again)) {
            lanes from = choose(again, c.q, all_lanes(0));
            for (int i = 0; i < PARTS; i++) cut_part(whole.t[i], other.t[i], n, from, all_lanes(1));
            choose_part(again, &other, &part, n);
            c.p = choose(again, c.q, c.p);
            c.q = choose(again, all_lanes(1), c.q);
        }
        s = count_part(&part, &c, &known, n);
    }
    *to = v;
}

#endif
