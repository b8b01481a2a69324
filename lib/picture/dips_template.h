/* dips_template.h - the places along rays where |P| is least, but not large, for what is thin
 * (thin_template.h).
 *
 * From P's Bernstein coefficients over the part of a ray that is looked at: their differences show where |P|
 * falls and then grows.  Parts where that may be, and where a coefficient is not large, are halved until it
 * happens once, and Newton's method on P's derivative has come close, or until they are as short as a pixel
 * is wide.
 *
 * Large.  Let l be the largest second derivative about a point without width, or a line, and d the size of a
 * pixel: it is at most d / 2^(1/2) from the ray of its pixel, so that P is at most l d^2 / 4 there.  Twice
 * that is taken; and l is at most sum m (m-1) r^(m-2) M_m at a distance r from the view's centre, where M_m
 * bounds P's terms of degree m on the unit sphere (Banach); thin.c takes M_m from some directions.
 *
 * Flat.  Where no coefficient of a part exceeds its error, P may be least anywhere: its middle is taken. */
#ifndef ALGSURF_DIPS_TEMPLATE_H
#define ALGSURF_DIPS_TEMPLATE_H
#include "sight_template.h"

#define DIP_TURNS 100  /* parts of a ray */
#define OVERLAP 0x1p-5 /* of a part with those beside it: P may be least between them */

/* Depths between which a packet is searched. */
typedef struct depth_range {
    lanes lo, length;
} depth_range;

/* Above which |P| is large where lines of sight are at depth z. */
INLINE lanes large_at(const algsurf_i_row_job *job, const sight *s, lanes z, int n) {
    lanes x = s->u + z * s->a, y = s->v + z * s->b, r = root(x * x + (y * y + z * z)), sum = all_lanes(0);
    for (int m = n; m >= 2; m--) sum = sum * r + all_lanes(job->thin_bends[m]);
    return sum;
}

/* Parts of rays, with P positive: where P may fall and then grow, and not be large; where it does so once at
 * most, and then where, as the control polygon has it; the largest coefficient. */
typedef struct falls {
    mask some, one;
    lanes place, most;
} falls;

INLINE falls falls_of(const lanes *w, lanes large, int n) {
    const lanes zero = all_lanes(0);
    mask fell = no_lane(), rose = fell, some = fell, more = fell;
    lanes least = w[0], most = absolute(w[0]), before = all_lanes(-1), after = zero, last = zero,
          place = zero;
    for (int j = 1; j <= n; j++) {
        lanes step = w[j] - w[j - 1];
        mask down = less(step, zero), up = less(zero, step), here = up & fell & ~rose;
        least = smaller(least, w[j]);
        most = larger(most, absolute(w[j]));
        before = choose(here, last, before);
        after = choose(here, step, after);
        place = choose(here, all_lanes(j - 2), place);
        last = step;
        some |= up & fell;
        more |= down & some;
        fell |= down;
        rose |= up & fell;
    }
    place = (place + before / (before - after)) * all_lanes(n > 1 ? 1.0 / (n - 1) : 1);
    return (falls){some & at_most(least, large), ~more, place, most};
}

/* Where P is least in a part, from a place near it: *least, and how far it is from there. */
INLINE lanes least_near(const lanes *w, int n, lanes place, lanes *least, lanes *off) {
    for (int round = 0;; round++) {
        const jet at = jet_at(w, n, place);
        lanes step = choose(less(all_lanes(0), at.bend), -0.5 * at.slope / at.bend, all_lanes(1));
        *least = at.f + 0.5 * at.slope * step;
        *off = absolute(step);
        place = larger(smaller(place + step, all_lanes(1)), all_lanes(0));
        if (round == 2) return place;
    }
}

/* Of solved rays, in front of their hits z, or all along the ranges of those that are open.  at: the pixels.
 */
INLINE void add_dips_n(const algsurf_i_row_job *job, const sight *s, const depth_range *r, packet *k, lanes z,
                       mask open, const int *at, algsurf_i_dips *dips, int n) {
    if (n < 2) return;
    const lanes zero = all_lanes(0), one = all_lanes(1);
    lanes from = zero, size = one, cut[MOST_DEGREE + 1];
    lanes end = choose(k->hit, (z - job->thin_before - r->lo) / r->length, one);
    int found[LANES] = {0};
    open &= less(zero, end);
    take_sign(k->b, n, open);
    if (any(open & less(end, one))) {
        split_shares(k->b, cut, n, end, 1 - end);
        for (int j = 0; j <= n; j++) k->b[j] = cut[j];
    }
    const lanes length = r->length * end;
    for (int turn = 0; any(open) && turn < DIP_TURNS; turn++) {
        const lanes to = from + size, lo = larger(from - OVERLAP * size, zero);
        const lanes hi = smaller(to + OVERLAP * size, one), part = hi - lo;
        lanes w[MOST_DEGREE + 1];
        for (int j = 0; j <= n; j++) w[j] = k->b[j];
        if (any(open & less(zero, lo))) split_shares(w, cut, n, lo, 1 - lo);
        if (any(open & less(hi, one))) {
            split_shares(w, cut, n, part, 1 - hi);
            for (int j = 0; j <= n; j++) w[j] = cut[j];
        }
        const lanes large =
            larger(large_at(job, s, r->lo + length * lo, n), large_at(job, s, r->lo + length * hi, n));
        const falls f = falls_of(w, k->e[0] + large, n);
        mask some = open & f.some, on = open & ~some;
        const lanes pixel = job->thin_side / (length * part);
        const mask flat = at_most(f.most, k->e[0]), ready = some & (f.one | at_most(one, pixel) | flat);
        if (any(ready)) {
            lanes least, off, place = least_near(w, n, f.place, &least, &off);
            lanes depth = r->lo + length * (lo + part * choose(flat, all_lanes(0.5), place));
            mask known = (f.one & at_most(off, 0.25 * pixel)) | at_most(one, pixel) | flat;
            mask dip = some & known & (flat | at_most(least, k->e[0] + large_at(job, s, depth, n)));
            on |= some & known;
            const unsigned which = bits(dip);
            for (int l = 0; which >> l && l < LANES; l++) {
                if (!(which >> l & 1) || found[l]++ == ALGSURF_I_MOST_DIPS) continue;
                dips->at[dips->count] = at[l];
                dips->depth[dips->count++] = depth[l];
            }
        }
        from = choose(on, to, from);
        size = choose(on, size, 0.5 * size);
        lanes pairs = from / (2 * size), whole = (pairs + 0x1.8p52) - 0x1.8p52;
        size = choose(on & at_most(pairs, whole) & at_most(whole, pairs), 2 * size, size);
        open &= less(from, one);
    }
}

APART void add_dips(const algsurf_i_row_job *job, const sight *s, const depth_range *r, packet *k,
                    const lanes *z, const mask *open, const int *at, algsurf_i_dips *dips, int n) {
    FOR_DEGREE(n, add_dips_n(job, s, r, k, *z, *open, at, dips, N))
}

#endif
