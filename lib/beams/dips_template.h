/* dips_template.h - the places along rays where |P| is least, but not large, for what is thin
 * (thin_template.h).
 *
 * From P's Bernstein coefficients over the part of a ray that is looked at: their differences show where |P|
 * falls and then grows.  Parts where that may be, and where a coefficient is not large, are halved until it
 * happens once, and Newton's method on P's derivative has come close, or until they are as short as a pixel
 * is wide.  A part that begins where P fell before has its least |P| at that end if it grows there.
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

#define DIP_TURNS 100 /* parts of a ray */

/* Depths between which a packet is searched. */
typedef struct depth_range {
    lanes lo, length;
} depth_range;

/* The square of lines of sight's distance from the view's centre, at depth z. */
INLINE lanes distance2_at(const sight *s, lanes z) {
    lanes x = s->u + z * s->a, y = s->v + z * s->b;
    return x * x + (y * y + z * z);
}

/* Above which |P| is large within a distance from the view's centre. */
INLINE lanes large_within(const algsurf_i_row_job *job, lanes distance2, int n) {
    lanes r = root(distance2), sum = all_lanes(0);
    for (int m = n; m >= 2; m--) sum = sum * r + job->thin_bends[m];
    return sum;
}

/* Parts of rays, with P positive: where P may fall and then grow, and not be large; where it does so once at
 * most, and then where, as the control polygon has it; the largest coefficient; where P falls at the end. */
typedef struct falls {
    mask some, one, ends;
    lanes place, most;
} falls;

/* fell: where P falls as the part begins. */
INLINE falls falls_of(const lanes *w, mask fell, lanes large, int n) {
    const lanes zero = all_lanes(0);
    mask rose = no_lane(), some = rose, more = rose, down = fell;
    lanes least = w[0], most = absolute(w[0]), before = zero, after = all_lanes(1), last = zero, place = zero;
    for (int j = 1; j <= n; j++) {
        lanes step = w[j] - w[j - 1];
        mask up = less(zero, step), here = up & fell & ~rose;
        least = smaller(least, w[j]);
        most = larger(most, absolute(w[j]));
        before = choose(here, last, before);
        after = choose(here, step, after);
        place = choose(here, all_lanes(j - 2), place);
        last = step;
        down = less(step, zero) | (down & ~up);
        some |= up & fell;
        more |= less(step, zero) & some;
        fell |= down;
        rose |= up & fell;
    }
    place = (place + before / (before - after)) * (n > 1 ? 1.0 / (n - 1) : 1);
    place = larger(smaller(place, all_lanes(1)), zero);
    return (falls){some & at_most(least, large), ~more, down, place, most};
}

/* Where P is least in a part, that value, and how far Newton's method has yet to go. */
typedef struct least_value {
    lanes place, value, off;
} least_value;

/* From a place near it. */
INLINE least_value least_near(const lanes *w, int n, lanes place) {
    least_value v = {place, place, place};
    for (int round = 0; round < 2; round++) {
        const jet at = jet_at(w, n, v.place);
        lanes step = choose(less(all_lanes(0), at.bend), -0.5 * at.slope / at.bend, all_lanes(1));
        v.value = at.f + 0.5 * at.slope * step;
        v.off = absolute(step);
        v.place = larger(smaller(v.place + step, all_lanes(1)), all_lanes(0));
    }
    return v;
}

/* Of solved rays, in front of their hits z, or all along the ranges of those that are open.  at: the pixels.
 */
INLINE void add_dips_n(const algsurf_i_row_job *job, const sight *s, const depth_range *r, packet *k, lanes z,
                       mask open, const int *at, algsurf_i_dips *dips, int n) {
    if (n < 2) return;
    const lanes zero = all_lanes(0), one = all_lanes(1);
    lanes from = zero, to = one, w[MOST_DEGREE + 1], cut[MOST_DEGREE + 1];
    lanes end = choose(k->hit, (z - job->thin_before - r->lo) / r->length, one);
    int found[LANES] = {0};
    mask fell = no_lane();
    open &= less(zero, end);
    take_sign(k->b, n, open);
    if (any(open & less(end, one))) {
        split_shares(k->b, cut, n, end, 1 - end);
        for (int j = 0; j <= n; j++) k->b[j] = cut[j];
    }
    for (int j = 0; j <= n; j++) w[j] = k->b[j];
    const lanes length = r->length * end;
    for (int turn = 0; any(open) && turn < DIP_TURNS; turn++) {
        const lanes size = to - from;
        const lanes near = distance2_at(s, r->lo + length * from), far = distance2_at(s, r->lo + length * to),
                    large = k->e[0] + large_within(job, larger(near, far), n);
        const falls f = falls_of(w, fell, large, n);
        mask some = open & f.some, on = open & ~some;
        const lanes pixel = job->thin_side / (length * size);
        const mask narrow = at_most(one, pixel), flat = at_most(f.most, k->e[0]),
                   ready = some & (f.one | narrow | flat);
        if (any(ready)) {
            const least_value least = least_near(w, n, f.place);
            lanes depth = r->lo + length * (from + size * choose(flat, all_lanes(0.5), least.place));
            mask known = ready & (at_most(least.off, 0.25 * pixel) | narrow | flat);
            const unsigned which = bits(known & (flat | at_most(least.value, large)));
            on |= known;
            for (int l = 0; which >> l && l < LANES; l++) {
                if (!(which >> l & 1) || found[l]++ == ALGSURF_I_MOST_DIPS) continue;
                dips->at[dips->count] = at[l];
                dips->depth[dips->count++] = depth[l];
            }
        }
        const mask halve = some & ~on;
        if (any(halve)) {
            const lanes middle = from + 0.5 * size;
            lanes right[MOST_DEGREE + 1];
            for (int j = 0; j <= n; j++) right[j] = w[j];
            split_shares(right, cut, n, all_lanes(0.5), all_lanes(0.5));
            const falls g = falls_of(cut, fell, large, n);
            const mask pass = halve & ~g.some, stay = halve & g.some;
            for (int j = 0; j <= n; j++) w[j] = choose(pass, right[j], choose(stay, cut[j], w[j]));
            from = choose(pass, middle, from);
            to = choose(stay, middle, to);
            fell = (pass & g.ends) | (fell & ~pass);
        }
        fell = (on & f.ends) | (fell & ~on);
        open &= ~(on & at_most(one, to));
        if (any(open & on)) {
            lanes rest[MOST_DEGREE + 1];
            for (int j = 0; j <= n; j++) rest[j] = k->b[j];
            split_shares(rest, cut, n, to, 1 - to);
            for (int j = 0; j <= n; j++) w[j] = choose(on, rest[j], w[j]);
            from = choose(on, to, from);
            to = choose(on, one, to);
        }
    }
}

APART void add_dips(const algsurf_i_row_job *job, const sight *s, const depth_range *r, packet *k,
                    const lanes *z, const mask *open, const int *at, algsurf_i_dips *dips, int n) {
    FOR_DEGREE(n, add_dips_n(job, s, r, k, *z, *open, at, dips, N))
}

#endif
