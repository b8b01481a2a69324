/* leaves_template.h - the pixels of leaves: the first root along the ray of each.
 *
 * They are few, and neighbours in a packet may be far apart in depth.  So each lane has a
 * range of depth of its own: its chord, cut to what its tile has left open.  P along the ray is made in
 * powers of depth by Horner's rule in u, then brought to Bernstein's basis over the range as it is for a
 * segment of a row: on its way a term meets no more roundings than there (surface/view.c).
 *
 * Ends.  Where the tile leaves open less than the chord, the range is inside the chord, and a root in it
 * counts.  Else it holds the chord's end and is longer than the chord by less than `blur`, in units of its
 * length: where |P| at that end of the range exceeds what it can change by within blur, no root is between.
 * In both cases the end need not be looked at again. */
#ifndef ALGSURF_LEAVES_TEMPLATE_H
#define ALGSURF_LEAVES_TEMPLATE_H
#include "row_template.h"

/* Depths between which a packet is searched. */
typedef struct leaf_range {
    lanes lo, length;
} leaf_range;

/* Powers of depth to coefficients over the range. */
INLINE void range_to_bernstein(const double *basis, const leaf_range *r, lanes *c, lanes *b, int n) {
    lanes half = 0.5 * r->length, middle = r->lo + half, power = all_lanes(1);
    UNROLLED
    for (int i = 0; i < n; i++) {
        UNROLLED
        for (int k = n - 1; k >= i; k--) c[k] += middle * c[k + 1];
    }
    for (int k = 1; k <= n; k++) {
        power *= half;
        c[k] *= power;
    }
    for (int j = 0; 2 * j <= n; j++) {
        const double *row = basis + j * (n + 1);
        lanes even = c[0], odd = all_lanes(row[1]) * c[1];
        for (int k = 2; k <= n; k += 2) even += all_lanes(row[k]) * c[k];
        for (int k = 3; k <= n; k += 2) odd += all_lanes(row[k]) * c[k];
        b[n - j] = even - odd;
        b[j] = even + odd;
    }
}

INLINE void expand_leaves(const algsurf_i_row_job *job, lanes u, const leaf_range *r, packet *p, int n) {
    lanes c[ALGSURF_MAX_BEAM_DEGREE + 1];
    for (int k = 0; k <= n; k++) {
        const double *row = job->row->c + k * job->row->stride;
        c[k] = all_lanes(row[n]);
        for (int m = n - 1; m >= 0; m--) c[k] = c[k] * u + all_lanes(row[m]);
    }
    range_to_bernstein(job->basis, r, c, p->b, n);
    p->e[0] = radius_at(job, u, n);
}

/* The whole range is searched.  after, before: it begins, or ends, inside the chord. */
INLINE void set_ends(packet *k, lanes blur, mask after, mask before, int n) {
    k->blur = blur;
    lanes margin = k->e[0] + end_error(k, n);
    after |= less(margin, absolute(k->b[0]));
    before |= less(margin, absolute(k->b[n]));
    k->start = choose(after, all_lanes(-1), all_lanes(0));
    k->stop = choose(before, all_lanes(2), all_lanes(1));
}

/* Of parts of rays, with P positive: is there a place of least P, or several, where it is not large? */
typedef struct dips {
    mask some, one;
} dips;

INLINE dips dips_of(const lanes *w, lanes large, int n) {
    mask fell = no_lane(), rose = fell, some = fell, more = fell;
    lanes least = w[0];
    for (int j = 1; j <= n; j++) {
        mask falls = less(w[j], w[j - 1]), rises = less(w[j - 1], w[j]);
        least = smaller(least, w[j]);
        some |= fell & rises;
        more |= rose & falls;
        fell |= falls;
        rose |= rises;
    }
    some &= at_most(least, large);
    return (dips){some, some & ~more};
}

/* Is there such a place before the hits of a packet, or anywhere where there are none?  z: of hits. */
INLINE mask dips_before(const algsurf_i_row_job *job, const packet *k, lanes z, lanes length, int n) {
    lanes w[MOST_DEGREE + 1], left[MOST_DEGREE + 1], zero = all_lanes(0);
    const mask negative_first = less(k->b[0], zero);
    for (int j = 0; j <= n; j++) w[j] = choose(negative_first, -k->b[j], k->b[j]);
    lanes end = choose(k->hit, larger(z - job->thin_before / length, zero), all_lanes(1));
    if (any(k->hit)) {
        split_shares(w, left, n, end, 1 - end);
        for (int j = 0; j <= n; j++) w[j] = left[j];
    }
    return dips_of(w, job->thin_large + k->e[0], n).some;
}

#define LEAF_ROUNDING 0x1p-39 /* more than what floor40 moves an end by */

/* LANES leaves; *thin: is there a place where something thin may be? */
INLINE void solve_leaf_packet(const algsurf_i_row_job *job, lanes pixel, lanes low, lanes high, packet *k,
                              lanes *z, mask *thin, int n) {
    const sight s = sight_at(job, pixel);
    const guess unknown = {low, low, no_lane()};
    leaf_range r;
    chord c = clip(job, &s, all_lanes(job->near), &k->open);
    lanes gap = 2 * c.blur, sure = gap + LEAF_ROUNDING;
    k->watch = NULL;
    *thin = k->undecided = c.undecided;
    k->hit = no_lane();
    r.lo = larger(floor40(larger(c.near - gap, low)), all_lanes(-1));
    lanes hi = smaller(-floor40(-smaller(c.far + gap, high)), all_lanes(1));
    k->open &= less(r.lo, hi);
    if (!any(k->open)) return;
    const mask all = k->open;
    r.lo = choose(k->open, r.lo, all_lanes(-1));
    r.length = choose(k->open, hi, all_lanes(1)) - r.lo;
    expand_leaves(job, s.u, &r, k, n);
    begin(k, n, 0);
    leave_undecided(k, ~ends_known(k->b, k->e, n, 0, all_lanes(0)));
    k->open &= ~k->s.none;
    if (any(k->open)) {
        bound_errors(k, n, 0);
        set_ends(k, 2 * sure / r.length, less(c.near + sure, low), less(high, c.far - sure), n);
        isolate(k, n, NULL);
        if (any(k->hit)) refine(k, n, &unknown, 0.5 * (job->tolerance > ENOUGH ? job->tolerance : ENOUGH), z);
    }
    if (job->thin_large > 0) *thin = k->undecided | (all & dips_before(job, k, *z, r.length, n));
    *z = r.lo + r.length * *z;
}

INLINE void solve_leaves_n(const algsurf_i_row_job *job, const algsurf_i_leaves *p, double *depth,
                           uint8_t *state, int n) {
    if (n < 1) __builtin_unreachable();
    for (int i = 0; i < p->count; i += LANES) {
        int count = p->count - i;
        packet k;
        mask thin;
        lanes z = all_lanes(0);
        solve_leaf_packet(job, load_some_integers(p->at + i, count), load_some(p->low + i, count),
                          load_some(p->high + i, count), &k, &z, &thin, n);
        store_solved(&k, z, count, depth + i, state + i);
        const unsigned which = bits(thin);
        for (int l = 0; p->thin && l < LANES && l < count; l++) p->thin[i + l] = which >> l & 1;
    }
}

static void solve_leaves(const algsurf_i_row_job *job, const algsurf_i_leaves *leaves, double *depth,
                         uint8_t *state) {
    FOR_DEGREE(job->row->degree, solve_leaves_n(job, leaves, depth, state, N))
}

#endif
