/* brackets_template.h - the roots in the brackets of a block (block_template.h).
 *
 * Halley's method on the power basis about the
 * middle of the interval, beginning where the control polygon crosses zero.
 *
 * Error.  A value at v is off by at most noise = (5n + 1) u S (centred_template.h), where S may be taken as
 * sum |c_k| (|m| + h |v|)^k.  A root is off by noise / |p'|, where this is below BLURRED: as |p''| <= n^2 S,
 * |p'| changes by less than 2^-10 of itself on such a way.  (The last step's own error, below 2^-44 as the
 * steps before show, is no bound.)  A root that may be off by more is enclosed by values that are better than
 * doubles (enclose_template.h), if its coefficients are exact; otherwise it is undecided, as is a root to
 * which the method does not converge. */
#ifndef ALGSURF_BRACKETS_TEMPLATE_H
#define ALGSURF_BRACKETS_TEMPLATE_H
#include "../simd/degrees.h"
#include "../simd/lanes.h"
#include "block_template.h"
#include "enclose_template.h"
#include "polys.h"

#define LEAST_ROOT_STEP 0x1p-52
#define USUAL_ROOT_STEP 0x1p-44 /* 3e-14 of the interval: what is expected of a step is no bound */
#define MANY_ROUNDS 8           /* of Halley's method; two or three are usual */
#define BLURRED 0x1p-39         /* 0.91e-12 of the interval: errors of roots that are left to double-double */

/* What of the sizes that S adds up is left at a distance of x halves from the middle. */
INLINE lanes part_at(const algsurf_i_polys_job *job, size_t at, const int *id, lanes x, int n) {
    lanes lo, hi, near = all_lanes(0), far = near;
    gather_interval(job, at, id, &lo, &hi);
    lanes m = absolute(0.5 * lo + 0.5 * hi), h = 0.5 * hi - 0.5 * lo;
    for (int k = n; k >= 0; k--) {
        lanes c = absolute(gather_table(&job->p.coefficients, k, at, id));
        near = near * (m + h * absolute(x)) + c;
        far = far * (m + h) + c;
    }
    return near / far;
}

/* Brackets i, i+1 .. of a block, two packets side by side, for each waits for its own divisions. */
typedef struct approaches {
    int packets, id[PAIR][LANES];
    lanes noise[PAIR];
    approach a[PAIR];
} approaches;

/* Halley's method on them.  The sign bit of a bracket's id is that of its polynomial before the root. */
INLINE void approach_hits_n(const algsurf_i_polys_job *job, const poly_block *block, int i, int n,
                            approaches *to) {
    approach *a = to->a;
    lanes d[PAIR][ALGSURF_MAX_POLYS_DEGREE + 1];
    double wanted = job->tolerance > 0 ? 2 * job->tolerance : USUAL_ROOT_STEP,
           tolerance = wanted > LEAST_ROOT_STEP ? wanted : LEAST_ROOT_STEP;
    to->packets = block->hits - i > LANES ? 2 : 1;
    for (int w = 0; w < to->packets; w++) {
        int first = i + w * LANES, *id = to->id[w];
        lanes number = load_row(block, HIT_ID, first, n);
        words side = (words)number & (words)all_lanes(-0.0);
        to_index(absolute(number), id);
        for (int l = block->hits - first; l < LANES; l++) id[l] = id[0];
        for (int k = 0; k <= n; k++) d[w][k] = (lanes)((words)gather_row(block, D + k, id, n) ^ side);
        a[w].begin = load_row(block, BEGIN, first, n);
        a[w].end = load_row(block, END, first, n);
        a[w].x = load_row(block, NEAR, first, n);
        a[w].last = all_lanes(0);
        a[w].moving = less(numbered(), all_lanes(block->hits - first));
        a[w].slope = a[w].last;
        a[w].stuck = no_lane();
        to->noise[w] = gather_row(block, RADIUS, id, n) * part_of_values(job, n);
    }
    for (int round = 0; round < MOST_TURNS; round++) {
        mask moving = no_lane();
        for (int w = 0; w < to->packets; w++) {
            halley(a + w, d[w], n, all_lanes(1), tolerance, to->noise[w], round >= MANY_ROUNDS);
            moving |= a[w].moving;
        }
        if (!any(moving)) break;
    }
}

APART void approach_hits(const algsurf_i_polys_job *job, const poly_block *block, int i, int n,
                         approaches *to) {
    if (n < 1) __builtin_unreachable();
    FOR_DEGREE(n, approach_hits_n(job, block, i, N, to))
}

/* What enclose_template.h asks for: only lanes with |t| <= M, M in 2^+-20 and sum |c_k| M^k in 2^+-300 count,
 * so |c_k| < 2^700, |t|^n <= 2^400, and nothing overflows.  The ends of a cell as doubles, middle + half v,
 * are off by 4 u M: points nearer to them than 2^-50 M are not used, but where the end is the interval's. */
INLINE void begin_hits(const algsurf_i_polys_job *job, const poly_block *block, size_t at, int i,
                       const approaches *all, int w, lanes *c, enclosure *e, int n) {
    const int first = i + w * LANES, *id = all->id[w];
    mask open = less(numbered(), all_lanes(block->hits - first)) & ~all->a[w].moving;
    lanes lo, hi, begin = load_row(block, BEGIN, first, n), end = load_row(block, END, first, n);
    gather_interval(job, at, id, &lo, &hi);
    lanes most = larger(absolute(lo), absolute(hi)), margin = 0x1p-50 * most;
    lanes middle = 0.5 * lo + 0.5 * hi, half = 0.5 * hi - 0.5 * lo;
    for (int k = 0; k <= n; k++) c[k] = gather_table(&job->p.coefficients, k, at, id);
    begin_enclosure(e, choose(at_most(begin, all_lanes(-1)), lo, middle + begin * half + margin),
                    choose(at_most(all_lanes(1), end), hi, middle + end * half - margin),
                    middle + all->a[w].x * half,
                    open & within(most, LARGE_END) & within(magnitude(c, n, most), LARGE_SIZE));
}

/* Brackets i, i+1 .. that have been approached, to neighbouring doubles: the same code for all degrees, for
 * each step of the compensated scheme waits for the one before. */
APART void enclose_hits(const algsurf_i_polys_job *job, const poly_block *block, size_t at, int i,
                        const approaches *all, int n, enclosure *e) {
    lanes c[PAIR][ALGSURF_MAX_POLYS_DEGREE + 1];
    for (int w = 0; w < all->packets; w++) begin_hits(job, block, at, i, all, w, c[w], e + w, n);
    for (int point = 0; point < MOST_POINTS; point++) {
        mask open = no_lane();
        for (int w = 0; w < all->packets; w++) {
            newton(e + w, (terms){NULL, c[w]}, n);
            open |= e[w].open;
        }
        if (!any(open)) break;
    }
}

/* Stores the roots that a packet's brackets led to; returns the lanes undecided, those that did not come to
 * an end or whose root may be off by more than BLURRED. */
INLINE unsigned store_hits(const algsurf_i_polys_job *job, poly_block *block, size_t at, int count, int n,
                           const approaches *all, int w) {
    const approach *a = all->a + w;
    const lanes allowed = BLURRED * absolute(a->slope);
    mask blurred = less(numbered(), all_lanes(count)) & ~at_most(all->noise[w], allowed);
    mask open = a->moving | (a->stuck & blurred);
    if (any(blurred) && !job->p.radii.at) /* radii may be all of c_0's, and the same everywhere */
        blurred &= ~at_most(all->noise[w] * part_at(job, at, all->id[w], a->x, n), allowed);
    unsigned undecided = bits(open | blurred);
    for (int l = 0; l < LANES && l < count; l++)
        *in_row(block, PLACE, all->id[w][l], n) = undecided >> l & 1 ? UNDECIDED : a->x[l];
    return undecided;
}

/* Roots in brackets i, i+1 ..  Ill-conditioned ones, without radii, by values that are better than doubles.
 */
APART void refine_some(const algsurf_i_polys_job *job, poly_block *block, size_t at, int i, int n) {
    approaches all;
    enclosure e[PAIR];
    unsigned undecided[PAIR] = {0}, some = 0;
    approach_hits(job, block, i, n, &all);
    for (int w = 0; w < all.packets; w++)
        some |= undecided[w] = store_hits(job, block, at, block->hits - i - w * LANES, n, &all, w);
    if (!some || job->p.radii.at) return;
    enclose_hits(job, block, at, i, &all, n, e);
    for (int w = 0; w < all.packets; w++)
        for (int l = 0; undecided[w] >> l; l++)
            if (undecided[w] & bits(e[w].found) & 1u << l) {
                *in_row(block, PLACE, all.id[w][l], n) = ENCLOSED;
                *in_row(block, VALUE, all.id[w][l], n) = e[w].value[l];
            }
}

#endif
