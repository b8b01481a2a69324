/* pixels_template.h - the first roots along the rays of some pixels of a row, LANES at once: coefficients by
 * Horner's rule in u, Descartes' walk (roots/first_walk_template.h), the root.
 *
 * Each lane has a range of depth of its own: its chord, cut to what is known of its root.  P along the ray is
 * made in powers of depth, which Taylor's shift to the range's middle, a factor and the change of basis bring
 * to Bernstein coefficients over the range; surface/view.c counts the roundings.
 *
 * Ends.  Where it is known that no root lies before a depth inside the chord, the range begins there, and a
 * root in it counts.  Else it holds the chord's end and is longer than the chord by less than `blur`, in
 * units of its length: where |P| at that end of the range exceeds what it can change by within blur, no root
 * is between.  In both cases the end need not be looked at again.
 *
 * All of space.  Chords are the depths [-1,1], from the eye on, as planes cut them; so what is found is the
 * first hit if there is no root between the eye and the depth -1, and a miss is one if there is none beyond 1
 * either.  The coefficients over [-1,1] tell that (roots/beyond_template.h), whatever planes cut off.  Their
 * radius takes in the noise: it bounds how far the coefficients of the pixel's own ray are from those that
 * are computed, and a proof about all within it holds for all depths of that ray.  Pixels not proved are
 * undecided; they go as rays, which know how to go on. */
#ifndef ALGSURF_PIXELS_TEMPLATE_H
#define ALGSURF_PIXELS_TEMPLATE_H
#include "../poly/triangle_template.h"
#include "dips_template.h"
#include "../roots/beyond_template.h"
#include "sight_template.h"

#define END_ROUNDING 0x1p-39 /* more than what floor40 moves an end by */

INLINE void expand_pixels_n(const algsurf_i_row_job *job, lanes u, const depth_range *r, packet *p, int n) {
    lanes c[ALGSURF_MAX_VIEW_DEGREE + 1];
    powers_at(job, u, c, n);
    lanes half = 0.5 * r->length;
    shift_and_scale(c, n, r->lo + half, half);
    powers_to_bernstein(job->basis, n + 1, c, p->b, n);
    p->e[0] = radius_at(job, u, n);
}

APART void expand_pixels(const algsurf_i_row_job *job, const lanes *u, const depth_range *r, packet *p,
                         int n){FOR_DEGREE(n, expand_pixels_n(job, *u, r, p, N))}

/* The whole range is searched.  after: it begins inside the chord. */
INLINE void set_ends(packet *k, lanes blur, mask after, int n) {
    k->blur = blur;
    lanes margin = k->e[0] + end_error(k, n);
    after |= less(margin, absolute(k->b[0]));
    mask before = less(margin, absolute(k->b[n]));
    k->start = choose(after, all_lanes(-1), all_lanes(0));
    k->stop = choose(before, all_lanes(2), all_lanes(1));
}

/* LANES pixels whose rays have no root on their chords before low.  Returns those that have chords behind it,
 * and these with their errors as ranges. */
INLINE mask solve_packet(const algsurf_i_row_job *job, const sight *s, lanes low, packet *k, depth_range *r,
                         lanes *z, int n) {
    chord c = clip(job, s, all_lanes(job->near), &k->open);
    lanes gap = 2 * c.blur, sure = gap + END_ROUNDING;
    k->watch = NULL;
    k->undecided = c.undecided;
    k->hit = no_lane();
    r->lo = larger(floor40(larger(c.near - gap, low)), all_lanes(-1));
    lanes hi = smaller(-floor40(-(c.far + gap)), all_lanes(1));
    const mask searched = k->open &= less(r->lo, hi);
    if (!any(searched)) return searched;
    r->lo = choose(searched, r->lo, all_lanes(-1));
    r->length = choose(searched, hi, all_lanes(1)) - r->lo;
    expand_pixels(job, &s->u, r, k, n);
    begin(k, n, 0);
    leave_undecided(k, ~ends_known(k->b, k->e, n, 0, all_lanes(0)));
    k->open &= ~k->s.none;
    if (!any(k->open)) return searched;
    bound_errors(k, n, 0);
    set_ends(k, 2 * sure / r->length, less(c.near + sure, low), n);
    isolate(k, n);
    if (!any(k->hit)) return searched;
    refine(k, n, 0.5 * (job->tolerance > ENOUGH ? job->tolerance : ENOUGH), z);
    *z = r->lo + r->length * *z;
    return searched;
}

/* All of space: leaves undecided what depths beyond [-1,1] are not proved to have no part in. */
APART void look_outside(const algsurf_i_row_job *job, const lanes *u, const lanes *low, mask searched,
                        const depth_range *r, packet *k, int n) {
    const depth_range whole = {all_lanes(-1), all_lanes(2)};
    const mask inside = less(whole.lo, all_lanes(job->near - 2 * job->view->noise));
    const mask open = ~(k->undecided | less(whole.lo, *low));
    if (!any(open)) return;
    if (any(open & ~(searched & ~less(r->length, whole.length)))) expand_pixels(job, u, &whole, k, n);
    const beyond is = look_beyond(k->b, k->e, n, 0, all_lanes(job->degree));
    k->undecided |= open & ~((is.none_before | inside) & (is.none_behind | k->hit));
    k->hit &= ~k->undecided;
}

static void solve_pixels(const algsurf_i_row_job *job, const algsurf_i_pixels *p, double *depth,
                         uint8_t *state, algsurf_i_dips *dips) {
    int n = job->row->degree;
    if (n < 1) __builtin_unreachable();
    for (int i = 0; i < p->count; i += LANES) {
        int count = p->count - i;
        packet k;
        depth_range r;
        lanes z = all_lanes(0);
        const sight s = sight_at(job, load_some_integers(p->at + i, count));
        const lanes low = load_some(p->low + i, count);
        mask searched = solve_packet(job, &s, low, &k, &r, &z, n);
        if (job->extent->kind == ALGSURF_EXTENT_ALL) look_outside(job, &s.u, &low, searched, &r, &k, n);
        store_states(k.hit, k.undecided, count, state + i);
        if (any(k.hit)) store_some(depth + i, z, count);
        searched &= less(numbered(), all_lanes(count));
        if (dips && any(searched)) add_dips(job, &s, &r, &k, &z, &searched, p->at + i, dips, n);
    }
}

#endif
