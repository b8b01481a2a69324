/* first_walk_template.h - the first root of each lane's polynomial: the walk over the cells of
 * descartes_template.h, then a bracketed iteration.
 *
 * Only the part [start,stop] of [0,1] is searched, its ends known up to `blur`.  A lane whose cell is
 * exhausted goes on with its polynomial cut at the place it has reached.  A lane that would need a sign that
 * is not known leaves as undecided, and so does one that does not come to an end.
 *
 * Sides.  Where the includer defines SIDED as 1 and asks for a side, only roots before which p has that sign
 * are looked for: others are passed by like empty cells.  Then the sign where the search begins need not be
 * known, if p surely grows on the wanted side there (packet.loose; who sets it proves that): what root is
 * there has the other sign before it.  Such a cell counts as if it began with the wanted sign.  Has it no
 * variation of signs otherwise, it has at most one root, which comes from the other sign: none that counts.
 * One variation proves nothing, as there may be two or none in truth.  A split whose left part has none ends
 * this: the right part begins with the wanted sign, which is known there. */
#ifndef ALGSURF_FIRST_WALK_TEMPLATE_H
#define ALGSURF_FIRST_WALK_TEMPLATE_H
#include "../simd/degrees.h"
#include "descartes_template.h"

#ifndef KNOWN_DEGREES /* code for known degrees where each coefficient has its radius: see degrees.h */
#define KNOWN_DEGREES 0
#endif
#ifndef SIDED
#define SIDED 0
#endif
#define SHORT_STEP 0x1p-14 /* of an iteration: longer ones do not tell what is missing */

/* What is known of LANES polynomials, and what was found. */
typedef struct packet {
    lanes b[MOST_DEGREE + 1];     /* over [0,1] */
    lanes e[MOST_DEGREE + 1];     /* radii: one for all, or each its own */
    lanes start, stop;            /* part of [0,1] searched, multiples of 2^-40 */
    lanes blur;                   /* bound on the error of start and stop */
    lanes largest;                /* max|b| */
    lanes cut_error;              /* 8 n u max|b| */
    mask open;                    /* lanes still to be solved */
    mask hit, undecided;          /* lanes solved: the others have no root */
    int wanted;                   /* SIDED: the sign of p before roots that count; 0: all count */
    mask loose;                   /* SIDED: the sign where the cell begins is not known */
    cell at;                      /* of a hit: the bracket */
    signs s;                      /* the cell's count */
    const algsurf_i_watch *watch; /* null; or, with two lanes, of the first one */
} packet;

INLINE void leave_undecided(packet *k, mask which) {
    k->undecided |= k->open & which;
    k->open &= ~which;
}

/* To be called once b and e are known: the cell is [0,1]. */
INLINE void begin(packet *k, int n, int own) {
    cell *c = &k->at;
    for (int j = 0; j <= n; j++) c->w[j] = k->b[j];
    for (int j = 0; j <= (own ? n : 0); j++) c->e[j] = k->e[j];
    c->side = take_sign(c->w, n, ~no_lane());
    c->p = all_lanes(0);
    c->q = c->limit = all_lanes(1);
    k->s = count_signs(c->w, c->e, n, own);
    k->hit = no_lane();
}

/* Before any cut. */
INLINE void bound_errors(packet *k, int n, int own) {
    lanes radius = k->e[0];
    k->largest = absolute(k->b[0]);
    for (int j = 1; j <= n; j++) k->largest = larger(k->largest, absolute(k->b[j]));
    for (int j = 1; own && j <= n; j++) radius = larger(radius, k->e[j]);
    k->largest += radius;
    k->cut_error = all_lanes(8 * n * 0x1p-53) * k->largest;
}

/* What a polynomial can change by within `blur` of a point: |p'| <= 2 n max|b|. */
INLINE lanes end_error(const packet *k, int n) { return all_lanes(2 * n) * k->blur * k->largest; }

/* Lanes of which p has another sign than the wanted one where the cell begins, or may have it. */
INLINE mask off_side(const packet *k) {
    if (!SIDED || !k->wanted) return no_lane();
    return k->loose | (k->wanted > 0 ? negative(k->at.side) : ~negative(k->at.side));
}

/* After the signs of all lanes were counted, also of those whose cells did not change: a cell that begins
 * behind the start begins with a sign that is known; in the others one variation proves nothing. */
INLINE void keep_loose(packet *k) {
    if (!SIDED) return;
    k->loose &= at_most(k->at.p, all_lanes(0));
    k->s.one &= ~k->loose;
}

/* The cells [from,to] of `which` open lanes, and their count of signs. */
INLINE void enter(packet *k, int n, int own, mask which, lanes from, lanes to, const algsurf_i_watch *watch) {
    cut_cell(&k->at, k->b, k->e, n, own, k->cut_error, which, from, to);
    leave_undecided(k, which & ~ends_known(k->at.w, k->at.e, n, own, all_lanes(0)));
    k->s = count_signs(k->at.w, k->at.e, n, own);
    keep_loose(k);
    if (watch && bits(which) & 1)
        tell_cell(watch, k->at.p[0], k->at.q[0], k->at.w, k->at.e, n, own, k->at.side[0] != 0);
}

/* Brackets that are not surely inside [start, stop] are cut to it, the ends being known to blur only. */
INLINE void cut_to_ends(packet *k, int n, int own, mask across, const algsurf_i_watch *watch) {
    cell *c = &k->at;
    lanes from = larger(c->p, k->start), to = smaller(c->q, k->stop);
    mask beyond = across & ~less(from, to); /* wholly outside: as good as empty */
    across &= ~beyond;
    enter(k, n, own, across, from, to, watch);
    leave_undecided(k, across & ~ends_known(c->w, c->e, n, own, end_error(k, n)));
    k->s.none |= beyond;
    k->s.one &= ~beyond;
    /* What is left is inside.  Where an end is sure, |p| there exceeds what it can change by within blur: so
     * between `to` and a stop no further than blur there is nothing. */
    k->start = choose(across, all_lanes(-1), k->start);
    mask at_stop = across & at_most(k->stop - k->blur, to);
    c->limit = choose(at_stop, to, c->limit);
    k->stop = choose(at_stop, all_lanes(2), k->stop);
}

/* The first bracket of each open lane, from its cell on. */
INLINE void isolate_n(packet *k, int n, int own, const algsurf_i_watch *watch) {
    cell *c = &k->at;
    int turn = 0;
    while (any(k->open)) {
        mask one = k->open & k->s.one;
        mask inside = one & at_most(k->start + k->blur, c->p) & at_most(c->q, k->stop - k->blur);
        const mask off = off_side(k), passed = k->s.none | (inside & off);
        k->hit |= inside & ~off;
        k->open &= ~inside | off;
        mask across = one & ~inside, again = k->open & passed & less(c->q, smaller(c->limit, k->stop));
        k->open &= ~passed | again;
        if (any(across)) {
            cut_to_ends(k, n, own, across, watch);
        } else if (any(again)) {
            enter(k, n, own, again, c->q, c->limit, watch);
        } else {
            mask stuck = at_most(c->q - c->p, all_lanes(NARROWEST));
            leave_undecided(k, turn < MOST_TURNS ? stuck : k->open);
            if (!any(k->open)) break;
            const lanes blur = SIDED ? choose(off, all_lanes(HUGE_VAL), k->blur) : k->blur; /* never counts */
            leave_undecided(
                k, divide(c, n, own, k->cut_error, k->open, k->start, blur, k->stop, turn++, &k->s, watch));
            keep_loose(k);
        }
    }
}

/* A polynomial at a point: its value, slope and half its second derivative. */
typedef struct jet {
    lanes f, slope, bend;
} jet;

/* By de Casteljau's scheme: the value's error is at most 2 n u max|w|. */
INLINE jet jet_at(const lanes *w, int n, lanes x) {
    lanes b[MOST_DEGREE + 1], rest = 1 - x;
    for (int j = 0; j <= n; j++) b[j] = w[j];
    casteljau(b, NULL, n, n - 2, rest, x, 1);
    lanes bend = all_lanes(0);
    if (n > 1) {
        bend = all_lanes(0.5 * n * (n - 1)) * (b[2] - b[1] - (b[1] - b[0]));
        for (int j = 0; j < 2; j++) b[j] = rest * b[j] + x * b[j + 1];
    }
    return (jet){rest * b[0] + x * b[1], all_lanes(n) * (b[1] - b[0]), bend};
}

/* The first lane goes on from an end of a cell. */
INLINE void next(packet *k, int n, lanes from) {
    k->open = less(numbered(), all_lanes(1));
    k->hit = k->undecided = no_lane();
    k->at.limit = all_lanes(1);
    enter(k, n, 1, k->open, from, k->at.limit, k->watch);
}

/* The lanes `found` have their bracket: as `part`. */
INLINE void close(packet *k, int n, mask found, const cell *part) {
    cell *c = &k->at;
    for (int j = 0; j <= n; j++) c->w[j] = choose(found, part->w[j], c->w[j]);
    c->p = choose(found, part->p, c->p);
    c->q = choose(found, part->q, c->q);
    c->side = (words)choose(found, (lanes)part->side, (lanes)c->side);
    k->hit |= found;
    k->open &= ~found;
}

/* The roots of the hits as numbers in [0,1]: Chebyshev's iteration (Traub, Iterative Methods for the Solution
 * of Equations, 1964, 5.1) from where the control polygon has the root, kept between lo and hi.  With the
 * Newton step s and r = s f''/(2 f') it goes on by s (1 + r), and what is missing then is about 2 s r^2: it
 * ends when twice that is below tolerance, and r so small that it tells that. */
INLINE lanes refine_n(packet *k, int n, double tolerance, const algsurf_i_watch *watch) {
    const cell *c = &k->at;
    lanes width = c->q - c->p, lo = all_lanes(0), hi = all_lanes(1), x = polygon_root(c->w, n);
    mask moving = k->hit;
    for (int round = 0; any(moving); round++) {
        jet at = jet_at(c->w, n, x);
        if (watch && bits(moving) & 1)
            algsurf_i_tell_point(watch, algsurf_i_watched_place(watch, c->p[0] + width[0] * x[0]),
                                 c->side[0] ? -at.f[0] : at.f[0], 0, ALGSURF_ENGINE_DOUBLES);
        mask before = ~negative((words)at.f); /* the root is further right */
        lo = choose(before, x, lo);
        hi = choose(before, hi, x);
        lanes inverse = 1 / at.slope, newton = at.f * inverse, ratio = newton * (at.bend * inverse);
        lanes next = x - (newton + newton * ratio), step = absolute(newton) * width;
        mask sound = at_most(lo, next) & at_most(next, hi);
        x = choose(moving, choose(sound, next, 0.5 * (lo + hi)), x);
        moving &= ~(sound & at_most(absolute(ratio), all_lanes(0.125)) &
                    at_most(4 * step * ratio * ratio, all_lanes(tolerance)) &
                    at_most(step, all_lanes(tolerance > SHORT_STEP ? tolerance : SHORT_STEP)));
        if (round == MOST_TURNS) {
            k->undecided |= moving;
            k->hit &= ~moving;
            break;
        }
    }
    return c->p + width * x;
}

/* ---- the steps, compiled for the most common degrees and for all others ---- */

/* Single rays and polynomials, which may be watched, go in packets of two; the includer may say that none is
 * watched. */
#ifndef WATCHED
#define WATCHED (LANES == 2)
#endif
INLINE const algsurf_i_watch *watch_of(const packet *k) { return WATCHED ? k->watch : NULL; }

/* One radius. */
APART void isolate(packet *k, int n){FOR_DEGREE(n, isolate_n(k, N, 0, watch_of(k)))}

/* Radii of their own. */
APART void isolate_known(packet *k, int n) {
    if (n < 1 || n > MOST_DEGREE) __builtin_unreachable();
    FOR_DEGREE_IF(KNOWN_DEGREES && COMMON_DEGREES, n, isolate_n(k, N, 1, watch_of(k)))
}

APART void refine(packet *k, int n, double tolerance, lanes *at) {
    FOR_DEGREE(n, *at = refine_n(k, N, tolerance, watch_of(k)))
}

#endif
