/* packet_template.h - the first root of each lane's polynomial: Descartes' rule on Bernstein coefficients,
 * then a bracketed Newton iteration.
 *
 * It is the walk of walk_template.h for many polynomials at once.  A cell is a part [p,q] of [0,1] with
 * its Bernstein coefficients w; what lies left of p, from `start` on, is known to hold no root.  Cells are
 * split at multiples of 2^-40, so that positions are exact.  A lane whose cell is exhausted goes on with its
 * polynomial cut at the place it has reached.  A sign is used only beyond the error radius; a lane that would
 * need another leaves as doubtful, and so does one that does not come to an end.
 *
 * Error bounds as there: a cut adds at most 8 n u max|b|. */
#ifndef ALGSURF_ROOTS_PACKET_TEMPLATE_H
#define ALGSURF_ROOTS_PACKET_TEMPLATE_H
#include "../simd/lanes.h"
#include "algsurf/status.h"

#define MOST_TURNS 120
#define NARROWEST 0x1p-36
#define CLOSE_TO_END 0x1p-10 /* no cuts where they tell, for split() */
#define SHORT_STEP 0x1p-14   /* of Newton's method: longer ones do not tell what is missing */

/* What is known of LANES polynomials, and what was found. */
typedef struct packet {
    lanes b[ALGSURF_MAX_DEGREE + 1];       /* over [0,1] */
    lanes start, stop;                     /* part of [0,1] searched, multiples of 2^-40 */
    lanes radius;                          /* bound on the error of b */
    lanes blur;                            /* bound on the error of start and stop */
    lanes largest;                         /* max|b| */
    lanes cut_error;                       /* 8 n u max|b| */
    mask open;                             /* lanes still to be solved */
    mask hit, doubtful;                    /* lanes solved: the others have no root */
    lanes p, q, w[ALGSURF_MAX_DEGREE + 1]; /* the cell; of a hit: the bracket */
} packet;

/* Descartes' count for a cell. */
typedef struct descartes {
    mask none, one; /* no variation of sign, one variation */
    lanes least;    /* the least magnitude: the count holds if that exceeds the error */
} descartes;

INLINE descartes variations(const lanes *w, int n) {
    words once = {0}, twice = {0};
    lanes least = absolute(w[0]);
    for (int j = 1; j <= n; j++) {
        words change = (words)w[j - 1] ^ (words)w[j];
        twice |= once & change;
        once |= change;
        least = smaller(least, absolute(w[j]));
    }
    mask some = negative(once);
    return (descartes){~some, some & ~negative(twice), least};
}

/* w becomes the part right of the ratio, left the part left of it: de Casteljau's scheme, for any ratio in
 * [0,1]. */
INLINE void split_at(lanes *w, lanes *left, int n, lanes ratio) {
    lanes rest = 1 - ratio;
    left[0] = w[0];
    for (int i = 1; i <= n; i++) {
        for (int j = 0; j <= n - i; j++) w[j] = rest * w[j] + ratio * w[j + 1];
        left[i] = w[0];
    }
}

/* The same for a cell cut between lengths `before` and `behind`, before <= 2^10 behind, at two thirds of the
 * cost: level i is kept in units of (behind/(before + behind))^i, so that each sum is one multiplication and
 * one addition.  If the lengths are exact, the quotient and the share have error u each: every level adds 3 u
 * max|w|, its unit 2 u. */
INLINE void split(lanes *w, lanes *left, int n, lanes before, lanes behind) {
    lanes quotient = before / behind, share = behind / (before + behind), unit = all_lanes(1);
    left[0] = w[0];
    UNROLLED
    for (int i = 1; i <= n; i++) {
        UNROLLED
        for (int j = 0; j <= n - i; j++) w[j] += quotient * w[j + 1];
        w[n - i + 1] *= unit;
        unit *= share;
        left[i] = unit * w[0];
    }
    w[0] = left[n];
}

/* To be called once b and radius are known. */
INLINE void begin(packet *k, int n, int bounded) {
    k->largest = absolute(k->b[0]);
    for (int j = 1; j <= n; j++) k->largest = larger(k->largest, absolute(k->b[j]));
    k->cut_error = (bounded ? 8 * n * 0x1p-53 : 0) * (k->largest + k->radius);
    k->p = all_lanes(0);
    k->q = all_lanes(1);
    for (int j = 0; j <= n; j++) k->w[j] = k->b[j];
    k->hit = k->open & ~k->open;
}

/* Where `which`: the cell [from, to], cut from the whole polynomial. */
INLINE void cut_cell(packet *k, int n, mask which, lanes from, lanes to) {
    lanes left[ALGSURF_MAX_DEGREE + 1], right[ALGSURF_MAX_DEGREE + 1];
    for (int j = 0; j <= n; j++) right[j] = k->b[j];
    if (any(which & less(all_lanes(0), from))) split_at(right, left, n, from);
    if (any(which & less(to, all_lanes(1)))) {
        split_at(right, left, n, (to - from) / (1 - from));
        for (int j = 0; j <= n; j++) right[j] = left[j];
    }
    for (int j = 0; j <= n; j++) k->w[j] = choose(which, right[j], k->w[j]);
    k->p = choose(which, from, k->p);
    k->q = choose(which, to, k->q);
}

/* A search for first brackets. */
typedef struct search {
    lanes error; /* of w */
    lanes limit; /* nothing is to be found beyond */
    lanes turns; /* splits so far */
    descartes c; /* of w */
} search;

/* Where to split the cells: where the control polygon, seen from the sign at the left end, first dips below
 * zero and turns, at the vertex of the parabola through its three coefficients.  That is near where the
 * polynomial comes closest to zero, or is beyond it: so either both parts soon have no variation, or the left
 * one has one.  Every third time in the middle, so that cells do shrink. */
INLINE lanes split_point(const packet *k, const search *s, int n) {
    words sign = (words)k->w[0] & (words)all_lanes(-0.0);
    lanes a = all_lanes(0), b = a, c = a, place = a, before = absolute(k->w[0]);
    lanes here = (lanes)((words)k->w[1] ^ sign);
    mask found = no_lane();
    for (int j = 1; j < n; j++) {
        lanes next = (lanes)((words)k->w[j + 1] ^ sign);
        mask dip = less(here, all_lanes(0)) & less(here, next) & ~found;
        found |= dip;
        place = choose(dip, all_lanes(j), place);
        a = choose(dip, before, a);
        b = choose(dip, here, b);
        c = choose(dip, next, c);
        before = here;
        here = next;
    }
    /* turns 2, 5, 8 ...: what turns/3 is above the nearest whole number is 0, 1/3 or -1/3 */
    lanes third = s->turns * (1 / 3.0), over = third - ((third + 0x1.8p52) - 0x1.8p52);
    lanes vertex = (place + 0.5 * (a - c) / (a - 2 * b + c)) * (1.0 / n);
    lanes at = choose(found & less(all_lanes(-0.2), over), vertex, all_lanes(0.5));
    return floor40(k->p + at * (k->q - k->p));
}

/* What a polynomial can change by between a computed end and the true one. */
INLINE lanes end_error(const packet *k, int n) { return 2 * n * k->blur * (k->largest + k->radius); }

/* Brackets that are not surely inside [start, stop] are cut to it, the ends being known to blur only. */
INLINE void cut_to_ends(packet *k, int n, mask across, search *s, int bounded) {
    lanes from = larger(k->p, k->start), to = smaller(k->q, k->stop);
    mask beyond = across & ~less(from, to); /* wholly outside: as good as empty */
    across &= ~beyond;
    cut_cell(k, n, across, from, to);
    lanes ends = smaller(absolute(k->w[0]), absolute(k->w[n]));
    s->error = choose(across, k->radius + 2 * k->cut_error, s->error);
    mask unsure = across & ~less(s->error + (bounded ? end_error(k, n) : all_lanes(0)), ends);
    k->doubtful |= unsure;
    k->open &= ~unsure;
    s->c = variations(k->w, n);
    s->c.none |= beyond;
    s->c.one &= ~beyond;
    /* What is left is inside.  Where an end is sure, |p| there exceeds what it can change by within blur: so
     * between `to` and a stop no further than blur there is nothing. */
    k->start = choose(across, all_lanes(-1), k->start);
    mask at_stop = across & at_most(k->stop - k->blur, to);
    s->limit = choose(at_stop, to, s->limit);
    k->stop = choose(at_stop, all_lanes(2), k->stop);
}

/* Splits the cells of open lanes and keeps the first part that may hold a root. */
INLINE void divide(packet *k, int n, search *s) {
    lanes left[ALGSURF_MAX_DEGREE + 1], right[ALGSURF_MAX_DEGREE + 1], at = split_point(k, s, n);
    for (int j = 0; j <= n; j++) right[j] = k->w[j];
    split(right, left, n, at - k->p, k->q - at);
    s->error = choose(k->open, s->error + k->cut_error, s->error);
    s->turns += 1;
    descartes l = variations(left, n), r = variations(right, n);
    mask go_right = k->open & ((l.none & less(s->error, l.least)) | at_most(at, k->start));
    mask go_left = k->open & ~go_right;
    mask last = at_most(s->limit, k->q) & r.none & less(s->error, r.least);
    s->limit = choose(go_left & (last | at_most(k->stop, at)), at, s->limit);
    for (int j = 0; j <= n; j++) k->w[j] = choose(go_right, right[j], choose(go_left, left[j], k->w[j]));
    k->p = choose(go_right, at, k->p);
    k->q = choose(go_left, at, k->q);
    s->c.none = (go_right & r.none) | (go_left & l.none);
    s->c.one = (go_right & r.one) | (go_left & l.one);
    s->c.least = choose(go_right, r.least, l.least);
}

#define MOST_CUTS 4

/* The places that a polynomial without roots was cut at to show it. */
typedef struct cuts {
    int count; /* more than MOST_CUTS: too many to be kept */
    double at[MOST_CUTS];
} cuts;

INLINE void add_cut(cuts *c, double at) {
    if (c->count < MOST_CUTS) c->at[c->count] = at;
    c->count++;
}

/* Open lanes that have no root, as the same cuts show, are closed. */
INLINE void skirt_n(packet *k, int n, const cuts *c) {
    lanes left[ALGSURF_MAX_DEGREE + 1], right[ALGSURF_MAX_DEGREE + 1], error = k->radius;
    mask empty = k->open;
    double from = 0;
    for (int j = 0; j <= n; j++) right[j] = k->b[j];
    for (int i = 0; i < c->count; i++) {
        split(right, left, n, all_lanes(c->at[i] - from), all_lanes(1 - c->at[i]));
        from = c->at[i];
        error += k->cut_error;
        descartes l = variations(left, n);
        empty &= l.none & less(error, l.least);
        if (!any(empty)) return;
    }
    descartes r = variations(right, n);
    k->open &= ~(empty & r.none & less(error, r.least));
}

/* The first bracket of each open lane, in p, q, w, from the cell it has, with its count; and the cuts it took
 * in the last lane, if that is open.  Not bounded: no rounding error is accounted for. */
INLINE void isolate_n(packet *k, int n, descartes c, int bounded, cuts *last) {
    search s = {k->radius, all_lanes(1), all_lanes(0), c};
    int kept = bits(k->open) >> (LANES - 1) & 1;
    if (kept) last->count = 0;
    while (any(k->open)) {
        double reached = k->p[LANES - 1];
        mask unsure = ~less(s.error, s.c.least) | at_most(k->q - k->p, all_lanes(NARROWEST)) |
                      at_most(all_lanes(MOST_TURNS), s.turns);
        k->doubtful |= k->open & unsure;
        k->open &= ~unsure;
        mask one = k->open & s.c.one;
        mask inside = one & at_most(k->start + k->blur, k->p) & at_most(k->q, k->stop - k->blur);
        k->hit |= inside;
        k->open &= ~inside;
        mask across = one & ~inside, again = k->open & s.c.none & less(k->q, smaller(s.limit, k->stop));
        k->open &= ~s.c.none | again;
        if (any(across)) {
            cut_to_ends(k, n, across, &s, bounded);
        } else if (any(again)) {
            cut_cell(k, n, again, k->q, s.limit);
            s.error = choose(again, k->radius + 2 * k->cut_error, s.error);
            s.c = variations(k->w, n);
        } else if (any(k->open)) {
            divide(k, n, &s);
        }
        if (kept && k->p[LANES - 1] > reached) add_cut(last, k->p[LANES - 1]);
    }
    if (kept && s.limit[LANES - 1] < 1) add_cut(last, s.limit[LANES - 1]);
}

/* Where the first root is expected: `near` it, within `reach`. */
typedef struct guess {
    lanes near, reach;
    mask known;
} guess;

/* A polynomial at a point: its value, slope and half its second derivative. */
typedef struct jet {
    lanes f, slope, bend;
} jet;

/* By de Casteljau's scheme: the value's error is at most 2 n u max|w|. */
INLINE jet jet_at(const lanes *w, int n, lanes x) {
    lanes b[ALGSURF_MAX_DEGREE + 1], rest = 1 - x;
    for (int j = 0; j <= n; j++) b[j] = w[j];
    UNROLLED
    for (int i = 1; i <= n - 2; i++) {
        UNROLLED
        for (int j = 0; j <= n - i; j++) b[j] = rest * b[j] + x * b[j + 1];
    }
    lanes bend = all_lanes(0);
    if (n > 1) {
        bend = 0.5 * n * (n - 1) * (b[2] - b[1] - (b[1] - b[0]));
        for (int j = 0; j < 2; j++) b[j] = rest * b[j] + x * b[j + 1];
    }
    return (jet){rest * b[0] + x * b[1], n * (b[1] - b[0]), bend};
}

/* Has the polynomial at x the sign it has at 0, and by more than `margin`? */
INLINE mask same_sign_at(const lanes *w, int n, lanes x, lanes margin) {
    lanes f = jet_at(w, n, x).f;
    return ~negative((words)f ^ (words)w[0]) & less(margin, absolute(f));
}

/* The brackets found in w, p, q of some lanes. */
INLINE void close(packet *k, int n, mask found, const lanes *w, lanes p, lanes q) {
    for (int j = 0; j <= n; j++) k->w[j] = choose(found, w[j], k->w[j]);
    k->p = choose(found, p, k->p);
    k->q = choose(found, q, k->q);
    k->hit |= found;
    k->open &= ~found;
}

/* Open lanes whose first root is where it is expected: one variation up to a little beyond it, and none
 * before `start`; or none up to a little before it, and one from there.  They are closed as hits. */
INLINE void follow_n(packet *k, int n, const guess *g) {
    lanes right[ALGSURF_MAX_DEGREE + 1], left[ALGSURF_MAX_DEGREE + 1];
    lanes zero = all_lanes(0), end = floor40(g->near + g->reach), error = k->radius + k->cut_error;
    mask tried = k->open & g->known & less(end, k->stop - k->blur) & less(k->start + k->blur, end);
    tried &= less(end, all_lanes(1 - CLOSE_TO_END));
    if (!any(tried)) return;
    for (int j = 0; j <= n; j++) right[j] = k->b[j];
    end = choose(tried, end, all_lanes(0.5));
    split(right, left, n, end, 1 - end);
    descartes l = variations(left, n);
    mask found = tried & l.one & less(error, l.least);
    if (any(found)) {
        lanes x = choose(found, k->start / end, zero);
        found &= same_sign_at(left, n, x, error + k->cut_error + end_error(k, n));
        close(k, n, found, left, zero, end);
    }
    lanes begin = floor40(g->near - g->reach);
    tried &= ~found & less(k->start + k->blur, begin);
    if (!any(tried)) return;
    begin = choose(tried, begin, 0.5 * end);
    error += k->cut_error;
    for (int j = 0; j <= n; j++) right[j] = left[j];
    split(right, left, n, begin, end - begin);
    l = variations(left, n);
    descartes r = variations(right, n);
    close(k, n, tried & l.none & r.one & less(error, smaller(l.least, r.least)), right, begin, end);
}

/* The roots of the hits as numbers in [0,1]: Chebyshev's iteration (Traub, Iterative Methods for the Solution
 * of Equations, 1964, 5.1) from where the root is expected, kept between lo and hi.  With the Newton step s
 * and r = s f''/(2 f') it goes on by s (1 + r), and what is missing then is about 2 s r^2: it ends when twice
 * that is below tolerance, and r so small that it tells that. */
INLINE lanes refine_n(packet *k, int n, const guess *g, double tolerance) {
    lanes width = k->q - k->p, lo = all_lanes(0), hi = all_lanes(1);
    lanes x = k->w[0] / (k->w[0] - k->w[n]), expected = (g->near - k->p) / width;
    x = choose(g->known & less(lo, expected) & less(expected, hi), expected, x);
    mask moving = k->hit;
    for (int round = 0; any(moving); round++) {
        jet at = jet_at(k->w, n, x);
        mask before = ~negative((words)at.f ^ (words)k->w[0]); /* the root is further right */
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
            k->doubtful |= moving;
            k->hit &= ~moving;
            break;
        }
    }
    return k->p + width * x;
}

/* ---- the steps, compiled for the most common degrees and for all others ---- */

/* A sanitizer needs minutes for the code of each degree; there the code for all of them must do. */
#if defined(__SANITIZE_ADDRESS__)
#define INSTRUMENTED 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define INSTRUMENTED 1
#endif
#endif
#ifndef INSTRUMENTED
#define INSTRUMENTED 0
#endif

#define APART static __attribute__((noinline, unused))

/* The statement with N = n, a constant for common degrees. */
#define FOR_DEGREE(n, statement)                                                                             \
    switch (INSTRUMENTED ? 0 : (n)) {                                                                        \
        FOR_ONE_DEGREE(2, statement)                                                                         \
        FOR_ONE_DEGREE(3, statement)                                                                         \
        FOR_ONE_DEGREE(4, statement)                                                                         \
        FOR_ONE_DEGREE(5, statement)                                                                         \
        FOR_ONE_DEGREE(6, statement)                                                                         \
        FOR_ONE_DEGREE(8, statement)                                                                         \
        FOR_ONE_DEGREE(10, statement)                                                                        \
    default: {                                                                                               \
        const int N = (n);                                                                                   \
        if (N < 1) __builtin_unreachable();                                                                  \
        statement;                                                                                           \
    }                                                                                                        \
    }
#define FOR_ONE_DEGREE(n, statement)                                                                         \
    case n: {                                                                                                \
        enum { N = n };                                                                                      \
        statement;                                                                                           \
        break;                                                                                               \
    }

APART void follow(packet *k, int n, const guess *g){FOR_DEGREE(n, follow_n(k, N, g))}

APART void skirt(packet *k, int n, const cuts *c){FOR_DEGREE(n, skirt_n(k, N, c))}

APART void isolate(packet *k, int n, const descartes *c, int bounded,
                   cuts *last){FOR_DEGREE(n, isolate_n(k, N, *c, bounded, last))}

APART void refine(packet *k, int n, const guess *g, double tolerance, lanes *at) {
    FOR_DEGREE(n, *at = refine_n(k, N, g, tolerance))
}

#endif
