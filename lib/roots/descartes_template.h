/* descartes_template.h - Descartes' rule of signs on Bernstein coefficients, LANES polynomials at once: a
 * cell, its count of signs, where it is split, what a split leaves.
 *
 * A cell is a part [p,q] of [0,1] with the Bernstein coefficients w of its polynomial, each known up to a
 * radius e.  As many roots lie in the open cell as w has variations of sign, or fewer by an even number: none
 * if there are none, exactly one if there is one.  A cell with more is split, and the walk goes on with the
 * first part that may hold a root: so what is left of p holds none.  Positions are multiples of 2^-40, hence
 * exact.
 *
 * Radii come in two kinds, told apart by `own`, a constant of the caller: 0, e[0] is the radius of all
 * coefficients; 1, each has its own, which costs a second scheme and leaves far fewer signs undecided.
 *
 * Rounding of a split.  Below, "path" is a product of weights that leads from w_j to a coefficient of a part;
 * a coefficient is the sum over all paths of weight times w_j.  A path through n levels meets at most 5 n + 1
 * roundings (split) or 3 n (split_shares), each of relative size u: the error is at most the sum over paths
 * of weight times (5 n + 1) u |w_j|, to first order.  8 n instead of 5 n + 1 takes in the higher orders.
 * - One radius: weights are not negative and their sum is 1, so e[0] grows by 8 n u max|w| at most.
 * - Own radii: that is the scheme itself on g_j = e_j + 8 n u |w_j|.  The scheme on g rounds, too, and may
 *   lose (5 n + 1) u < 2^-44 of itself for n <= 64; therefore g_j = (1 + 2^-42) e_j + 8 n u |w_j|.
 *
 * Range: |w_j| and e_j are below 2^300.  Cells are split where before <= 2^10 behind at most, at 2 n behind
 * with radii of their own, so split's units are within (1 + 2 n)^n < 2^450 for n <= 64, and nothing
 * overflows.  No own radius is below 2^-550, so underflow, 2^-1074 a step, is lost in the slack of g.
 *
 * Count.  A coefficient within its radius may have either sign.  The first one, made positive, exceeds its
 * radius.  No root if none of the others can be negative; one root if the last is negative and no coefficient
 * that may be positive follows one that may be negative: then every choice of the open signs has the same
 * number of variations.
 *
 * The includer may define MOST_DEGREE, and MOST_OWN as 0 where there are no radii of their own: cells are as
 * large as that, and they live on the stack. */
#ifndef ALGSURF_DESCARTES_TEMPLATE_H
#define ALGSURF_DESCARTES_TEMPLATE_H
#include "../poly/triangle_template.h"
#include "../simd/lanes.h"
#include "algsurf/status.h"
#include "watch.h"

#ifndef MOST_DEGREE
#define MOST_DEGREE ALGSURF_MAX_DEGREE
#endif

#ifndef MOST_OWN
#define MOST_OWN MOST_DEGREE
#endif

#define MOST_TURNS 120
#define NARROWEST 0x1p-36 /* cells */

typedef struct cell {
    lanes p, q;
    lanes limit; /* right of it there is nothing to be found */
    lanes w[MOST_DEGREE + 1], e[MOST_OWN + 1];
    words side; /* the sign bit that was taken from all of w, so that w[0] is positive */
} cell;

/* Descartes' count for a cell: no variation of sign, or one, whatever the signs that are not known. */
typedef struct signs {
    mask none, one;
} signs;

INLINE lanes radius_of(const lanes *e, int j, int own) { return e[own ? j : 0]; }

/* For w[0] above its radius. */
INLINE signs count_signs(const lanes *w, const lanes *e, int n, int own) {
    words low = {0}, mixed = low, last = low; /* low: a coefficient so far may be negative */
    for (int j = 1; j <= n; j++) {
        last = (words)(w[j] + radius_of(e, j, own));
        mixed |= low & ~last; /* one after it may be positive */
        low |= (words)(w[j] - radius_of(e, j, own));
    }
    return (signs){~negative(low), ~negative(mixed) & negative(last)};
}

/* Both ends' signs are known, by more than `margin`. */
INLINE mask ends_known(const lanes *w, const lanes *e, int n, int own, lanes margin) {
    return less(e[0] + margin, absolute(w[0])) & less(radius_of(e, n, own) + margin, absolute(w[n]));
}

/* What a split adds to the radii: g of the head comment, or cut_error, 8 n u max|w| of the whole polynomial.
 */
INLINE void widen_radii(const lanes *w, lanes *e, int n, int own, lanes cut_error) {
    if (!own) e[0] += cut_error;
    for (int j = 0; own && j <= n; j++)
        e[j] = all_lanes(1 + 0x1p-42) * e[j] + all_lanes(8 * n * 0x1p-53) * absolute(w[j]);
}

/* Where to split cells, as a place in [0,1]: where the control polygon first dips below zero and turns, at
 * the vertex of the parabola through its three coefficients.  That is near where the polynomial comes closest
 * to zero, or is beyond it: so either both parts soon have no variation, or the left one has one.  Every
 * third turn in the middle, so that cells do shrink. */
INLINE lanes split_point(const cell *c, int n, int turn) {
    lanes zero = all_lanes(0), before = all_lanes(1), dip = zero, after = before, place = all_lanes(0.5 * n);
    for (int j = n - 1; j >= 1 && turn % 3 != 2; j--) {
        mask here = less(c->w[j], smaller(c->w[j + 1], zero));
        before = choose(here, c->w[j - 1], before);
        dip = choose(here, c->w[j], dip);
        after = choose(here, c->w[j + 1], after);
        place = choose(here, all_lanes(j), place);
    }
    lanes vertex = (place + 0.5 * (before - after) / (before - 2 * dip + after)) * all_lanes(1.0 / n);
    return floor40(c->p + vertex * (c->q - c->p));
}

/* The sign bit of w[0] where `which`, taken out of all of w. */
INLINE words take_sign(lanes *w, int n, mask which) {
    words side = (words)choose(which, w[0], all_lanes(0)) & (words)all_lanes(-0.0);
    for (int j = 0; j <= n; j++) w[j] = (lanes)((words)w[j] ^ side);
    return side;
}

/* Where `which`: the cell [from,to] cut from the whole polynomial b with radii e.  Its ends' signs may be
 * undecided. */
INLINE void cut_cell(cell *c, const lanes *b, const lanes *e, int n, int own, lanes cut_error, mask which,
                     lanes from, lanes to) {
    cell part;
    lanes left[MOST_DEGREE + 1];
    for (int j = 0; j <= n; j++) part.w[j] = b[j];
    for (int j = 0; j <= (own ? n : 0); j++) part.e[j] = e[j];
    if (any(which & less(all_lanes(0), from))) {
        widen_radii(part.w, part.e, n, own, cut_error);
        split_shares(part.w, left, n, from, 1 - from);
        if (own) split_shares(part.e, left, n, from, 1 - from);
    }
    if (any(which & less(to, all_lanes(1)))) {
        widen_radii(part.w, part.e, n, own, cut_error);
        split_shares(part.w, left, n, to - from, 1 - to);
        for (int j = 0; j <= n; j++) part.w[j] = left[j];
        if (own) split_shares(part.e, left, n, to - from, 1 - to);
        for (int j = 0; own && j <= n; j++) part.e[j] = left[j];
    }
    part.side = take_sign(part.w, n, which);
    for (int j = 0; j <= n; j++) c->w[j] = choose(which, part.w[j], c->w[j]);
    for (int j = 0; j <= (own ? n : 0); j++) c->e[j] = choose(which, part.e[j], c->e[j]);
    c->side = (words)choose(which, (lanes)part.side, (lanes)c->side);
    c->p = choose(which, from, c->p);
    c->q = choose(which, to, c->q);
}

/* A cell of the first lane is shown to whoever watches; side: are signs turned? */
APART void tell_cell(const algsurf_i_watch *watch, double p, double q, const lanes *w, const lanes *e, int n,
                     int own, int side) {
    signed char known[ALGSURF_MAX_DEGREE + 1];
    for (int j = 0; j <= n; j++) {
        double b = w[j][0], r = radius_of(e, j, own)[0];
        int sign = b == 0 && r == 0 ? 0 : b >= r ? 1 : b < -r ? -1 : ALGSURF_SIGN_UNDECIDED;
        known[j] = (signed char)(side && sign * sign == 1 ? -sign : sign);
    }
    const algsurf_cell told = {.lo = algsurf_i_watched_place(watch, p),
                               .hi = algsurf_i_watched_place(watch, q),
                               .variations = algsurf_i_most_variations(known, n),
                               .engine = ALGSURF_ENGINE_DOUBLES,
                               .degree = n,
                               .signs = known};
    algsurf_i_tell_cell(watch, &told);
}

/* Where `which`: splits the cell and keeps the part before, or, where that has no root or ends at `start`
 * already, the part behind; nothing is to be found right of `stop`, nor left of start, which is known to
 * blur. Returns the lanes where the sign at the split is not known.  watch: of the first lane, or null. */
INLINE mask divide(cell *c, int n, int own, lanes cut_error, mask which, lanes start, lanes blur, lanes stop,
                   int turn, signs *s, const algsurf_i_watch *watch) {
    lanes left[MOST_DEGREE + 1], left_e[MOST_OWN + 1], right[MOST_DEGREE + 1], right_e[MOST_OWN + 1],
        at = split_point(c, n, turn), before = at - c->p, behind = c->q - at;
    for (int j = 0; j <= n; j++) right[j] = c->w[j];
    for (int j = 0; j <= (own ? n : 0); j++) right_e[j] = c->e[j];
    widen_radii(right, right_e, n, own, cut_error);
    split(right, left, n, before, behind);
    if (own)
        split(right_e, left_e, n, before, behind);
    else
        left_e[0] = right_e[0];
    mask crosses = negative((words)left[n]), undecided = ~less(radius_of(left_e, n, own), absolute(left[n]));
    signs l = count_signs(left, left_e, n, own);
    int told = watch && bits(which) & 1;
    if (told) tell_cell(watch, c->p[0], at[0], left, left_e, n, own, c->side[0] != 0);
    mask go_right = which & (l.none | at_most(at, start)), go_left = which & ~go_right;
    if (any(go_right & crosses)) c->side ^= take_sign(right, n, go_right); /* a root before start */
    signs r = count_signs(right, right_e, n, own);
    if (told) tell_cell(watch, at[0], c->q[0], right, right_e, n, own, c->side[0] != 0);
    mask counts = at_most(start + blur, c->p); /* a root left of the split does */
    mask last = (crosses & counts) | (~crosses & r.none & at_most(c->limit, c->q)) | at_most(stop, at);
    c->limit = choose(last & go_left, at, c->limit);
    for (int j = 0; j <= n; j++) c->w[j] = choose(go_right, right[j], choose(go_left, left[j], c->w[j]));
    for (int j = 0; j <= (own ? n : 0); j++)
        c->e[j] = choose(go_right, right_e[j], choose(go_left, left_e[j], c->e[j]));
    c->p = choose(go_right, at, c->p);
    c->q = choose(go_left, at, c->q);
    s->none = (go_right & r.none) | (go_left & l.none);
    s->one = (go_right & r.one) | (go_left & l.one);
    return which & undecided;
}

/* Where the control polygon, positive first, crosses zero for the last time. */
INLINE lanes polygon_root(const lanes *w, int n) {
    lanes before = w[0], after = w[1], place = all_lanes(0);
    for (int j = 1; j < n; j++) {
        mask here = less(all_lanes(0), w[j]);
        before = choose(here, w[j], before);
        after = choose(here, w[j + 1], after);
        place = choose(here, all_lanes(j), place);
    }
    return (place + before / (before - after)) * all_lanes(1.0 / n);
}

#endif
