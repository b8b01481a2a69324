/* radii_template.h - the first root of each lane's polynomial, with an error radius for each coefficient.
 *
 * The walk of packet_template.h, for lanes that one radius for all coefficients leaves undecided.  A
 * coefficient w_j is known up to e_j, and both go through de Casteljau's scheme: its weights are not
 * negative, so the same weights that mix the coefficients mix the bounds on their errors.
 *
 * Rounding of a cut.  Below, "path" is a product of weights that leads from w_j to a coefficient of a part;
 * a coefficient is the sum over all paths of weight times w_j.  A path through n levels meets at most
 * 5 n + 1 roundings (packet_template.h, split) or 3 n (split_shares), each of relative size u: the error is
 * at most the sum over paths of weight times (5 n + 1) u |w_j|, to first order.  That is the scheme itself on
 * g_j = e_j + 8 n u |w_j|; 8 n instead of 5 n + 1 takes in the higher orders.  The scheme on g rounds, too,
 * and may lose (5 n + 1) u < 2^-44 of itself for n <= 64; therefore g_j = (1 + 2^-42) e_j + 8 n u |w_j|.
 *
 * Range: |w_j| and e_j are below 2^300.  Cells are split where before <= 2 n behind, so split's units grow to
 * (1 + 2 n)^n < 2^450 for n <= 64, and nothing overflows.  No radius is below UNDERFLOW of the room that
 * makes them, so underflow, 2^-1074 a step, is lost in the slack of g.
 *
 * Count.  A coefficient within its radius may have either sign.  With s_j the coefficients times the sign of
 * the first: no root if none of them can be negative; one root if the last is negative and no coefficient
 * that may be positive follows one that may be negative.  Then every choice of the open signs has the same
 * number of variations.  Both ends of a cell are places where the sign is known. */
#ifndef ALGSURF_RADII_TEMPLATE_H
#define ALGSURF_RADII_TEMPLATE_H
#include "packet_template.h"

/* As split, where a part may be as short as 2^-40: weights before / (before + behind) and behind / (before +
 * behind), whose sum of lengths is exact. */
INLINE void split_shares(lanes *w, lanes *left, int n, lanes before, lanes behind) {
    lanes rest = behind / (before + behind), ratio = before / (before + behind);
    left[0] = w[0];
    for (int i = 1; i <= n; i++) {
        for (int j = 0; j <= n - i; j++) w[j] = rest * w[j] + ratio * w[j + 1];
        left[i] = w[0];
    }
}

/* g of the head comment, in place of e. */
INLINE void widen(const lanes *w, lanes *e, int n) {
    for (int j = 0; j <= n; j++) e[j] = (1 + 0x1p-42) * e[j] + 8 * n * 0x1p-53 * absolute(w[j]);
}

/* Descartes' count where the first coefficient's sign is known. */
INLINE descartes known_variations(const lanes *w, const lanes *e, int n) {
    words sign = (words)w[0] & (words)all_lanes(-0.0), low = {0}, mixed = low, last = low;
    for (int j = 1; j <= n; j++) {
        lanes s = (lanes)((words)w[j] ^ sign);
        last = (words)(s + e[j]);
        mixed |= low & ~last;
        low |= (words)(s - e[j]);
    }
    return (descartes){~negative(low), ~negative(mixed) & negative(last), all_lanes(0)};
}

INLINE mask ends_known(const lanes *w, const lanes *e, int n) {
    return less(e[0], absolute(w[0])) & less(e[n], absolute(w[n]));
}

/* Polynomials with radii, and the cell of each lane. */
typedef struct walk {
    const lanes *e;                       /* radii of the packet's b */
    lanes cell_e[ALGSURF_MAX_DEGREE + 1]; /* of its w */
    search s;
    int counted; /* cells whose variations were counted, of all lanes together */
} walk;

INLINE void leave_undecided(packet *k, mask which) {
    k->doubtful |= k->open & which;
    k->open &= ~which;
}

/* Where `which`: the cell [from, to], multiples of 2^-40, cut from the whole polynomial. */
INLINE void cut_known_cell(packet *k, int n, walk *v, mask which, lanes from, lanes to) {
    lanes w[ALGSURF_MAX_DEGREE + 1], e[ALGSURF_MAX_DEGREE + 1], left[ALGSURF_MAX_DEGREE + 1];
    for (int j = 0; j <= n; j++) w[j] = k->b[j], e[j] = v->e[j];
    if (any(which & less(all_lanes(0), from))) {
        widen(w, e, n);
        split_shares(w, left, n, from, 1 - from);
        split_shares(e, left, n, from, 1 - from);
    }
    if (any(which & less(to, all_lanes(1)))) {
        widen(w, e, n);
        split_shares(w, left, n, to - from, 1 - to);
        for (int j = 0; j <= n; j++) w[j] = left[j];
        split_shares(e, left, n, to - from, 1 - to);
        for (int j = 0; j <= n; j++) e[j] = left[j];
    }
    for (int j = 0; j <= n; j++) k->w[j] = choose(which, w[j], k->w[j]);
    for (int j = 0; j <= n; j++) v->cell_e[j] = choose(which, e[j], v->cell_e[j]);
    k->p = choose(which, from, k->p);
    k->q = choose(which, to, k->q);
    v->s.c = known_variations(k->w, v->cell_e, n);
    v->counted++;
    leave_undecided(k, which & ~ends_known(k->w, v->cell_e, n));
}

/* Splits the cells of open lanes and keeps the first part that may hold a root. */
INLINE void divide_known(packet *k, int n, walk *v) {
    lanes left[ALGSURF_MAX_DEGREE + 1], left_e[ALGSURF_MAX_DEGREE + 1], right[ALGSURF_MAX_DEGREE + 1],
        right_e[ALGSURF_MAX_DEGREE + 1], at = split_point(k, &v->s, n);
    search *s = &v->s;
    for (int j = 0; j <= n; j++) right[j] = k->w[j], right_e[j] = v->cell_e[j];
    widen(right, right_e, n);
    split(right, left, n, at - k->p, k->q - at);
    split(right_e, left_e, n, at - k->p, k->q - at);
    s->turns += 1;
    leave_undecided(k, ~less(left_e[n], absolute(left[n])));
    descartes l = known_variations(left, left_e, n), r = known_variations(right, right_e, n);
    v->counted += 2;
    mask go_right = k->open & l.none, go_left = k->open & ~go_right;
    mask crosses = negative((words)left[0] ^ (words)left[n]);
    s->limit = choose(go_left & (crosses | (at_most(s->limit, k->q) & r.none)), at, s->limit);
    for (int j = 0; j <= n; j++) {
        k->w[j] = choose(go_right, right[j], choose(go_left, left[j], k->w[j]));
        v->cell_e[j] = choose(go_right, right_e[j], choose(go_left, left_e[j], v->cell_e[j]));
    }
    k->p = choose(go_right, at, k->p);
    k->q = choose(go_left, at, k->q);
    s->c.none = (go_right & r.none) | (go_left & l.none);
    s->c.one = (go_right & r.one) | (go_left & l.one);
}

/* The first bracket of each open lane within [from, 1], in p, q, w; e are the radii of b.  A lane is left
 * undecided where a sign that the walk needs is not known.  Returns how many cells were counted. */
INLINE int isolate_known_n(packet *k, int n, const lanes *e, lanes from) {
    walk v = {.e = e};
    v.s.limit = all_lanes(1);
    v.s.turns = all_lanes(0);
    for (int j = 0; j <= n; j++) v.cell_e[j] = all_lanes(0);
    cut_known_cell(k, n, &v, k->open, from, v.s.limit);
    while (any(k->open)) {
        mask one = k->open & v.s.c.one, again = k->open & v.s.c.none & less(k->q, v.s.limit);
        k->hit |= one;
        k->open &= ~one & (~v.s.c.none | again);
        if (any(again)) {
            cut_known_cell(k, n, &v, again, k->q, v.s.limit);
            continue;
        }
        leave_undecided(k, at_most(k->q - k->p, all_lanes(NARROWEST)) |
                               at_most(all_lanes(MOST_TURNS), v.s.turns));
        if (any(k->open)) divide_known(k, n, &v);
    }
    return v.counted;
}

APART int isolate_known(packet *k, int n, const lanes *e, const lanes *from) {
    if (n < 1 || n > ALGSURF_MAX_DEGREE) __builtin_unreachable();
    return isolate_known_n(k, n, e, *from);
}

/* The same, compiled for common degrees: for single rays and polynomials, which are all that they do. */
APART int isolate_known_often(packet *k, int n, const lanes *e, const lanes *from) {
    int counted = 0;
    FOR_DEGREE(n, counted = isolate_known_n(k, N, e, *from))
    return counted;
}

#endif
