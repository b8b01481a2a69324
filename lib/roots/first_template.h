/* first_template.h - the first roots of LANES polynomials given in the power basis.
 *
 * They are counted by Descartes' rule.  Those with more than one variation of sign are split, all of them
 * once; what is still open is packed together and split again (block_template.h), so that no lane waits for
 * another.  The roots in the brackets are brackets_template.h's.  Degrees 1 and 2 have a closed form; what
 * this leaves open takes the same way as all others.
 *
 * The closed form.  Let d be the polynomial about the middle as computed, R the bound on its error in [-1,1]
 * (centred_template.h has it for the Bernstein coefficients: it is the same), s the sign at the left end.
 * Where signs at the ends differ, or both are s, the middle coefficient's is not, and the discriminant D is
 * positive, the first root is the one where the slope d_1 + 2 d_2 v = -s q, q = sqrt(D).
 *
 * Which case it is.  Errors R of b are errors of at most R of d_0, d_1 and 2 R of d_2; they change D by less
 * than 16 R (size + R), size = |d_0| + |d_1| + |d_2|.  That is more than D's roundings, 3 u size^2, too, as R
 * is at least 16 u S, S >= size.
 *
 * Where the root is.  Hits have q >= 2^40 R and q >= 2^-10 size, so D changes by less than 2^-25 of itself on
 * the way from d to the polynomial: that moves the root by R / q, 2^-40 at most.  Roundings change q by 1.5 u
 * size^2 / q + u q, below 2^-42 size; and the root v by that over max(|d_1| + q, 2 |d_2|), which is size / 3
 * at least, as |d_0| <= |d_1| + |d_2| where |v| <= 1.  Together with the roundings of the quotient that is
 * below 2^-39, 0.91e-12 of the interval's length.  All others are left to the walk. */
#ifndef ALGSURF_FIRST_TEMPLATE_H
#define ALGSURF_FIRST_TEMPLATE_H
#include "../simd/degrees.h"
#include "../simd/lanes.h"
#include "block_template.h"
#include "brackets_template.h"
#include "centred_template.h"
#include "descartes_template.h"
#include "polys.h"

#define FLAT 0x1p-10
#define STEEP 0x1p40

INLINE lanes first_root_closed(const centred *p, int n, mask *hit, mask *undecided) {
    lanes a = n == 2 ? p->d[2] : all_lanes(0), b = p->d[1], c = p->d[0], radius = p->radius;
    lanes left = c - b + a, middle = c - a, right = c + b + a;
    words sign = (words)left & (words)all_lanes(-0.0);
    lanes size = absolute(a) + absolute(b) + absolute(c), discriminant = b * b - 4 * a * c;
    mask crosses = negative((words)left ^ (words)right), dips = negative((words)left ^ (words)middle);
    mask sure = p->sound & less(radius, smaller(absolute(left), absolute(right)));
    mask around = ~crosses & (dips | ~less(radius, absolute(middle)));
    sure &= ~around | (dips & less(radius, absolute(middle)) &
                       less(16 * radius * (size + radius), absolute(discriminant)));
    lanes slope = root(larger(discriminant, all_lanes(0)));
    *hit = sure & (crosses | (around & less(all_lanes(0), discriminant)));
    *undecided = ~sure | (*hit & less(slope, larger(FLAT * size, STEEP * radius)));
    *hit &= ~*undecided;
    mask same = ~negative((words)b ^ sign);
    lanes sum = b + (lanes)((words)slope | ((words)b & (words)all_lanes(-0.0)));
    return choose(same, -sum, -2 * c) / choose(same, 2 * a, sum);
}

/* Descartes' count over the whole intervals of polynomials i .. i+count-1 of the block, at `at` of the job.
 * Their signs become those that make the first coefficient positive. */
INLINE void classify(const algsurf_i_polys_job *job, poly_block *block, size_t at, int i, int room, int n) {
    centred p;
    cell s;
    lanes largest = all_lanes(0), id = numbered() + i;
    centre(job, at, room, &p, n);
    powers_to_bernstein(block->basis, n + 1, p.d, s.w, n);
    s.side = take_sign(s.w, n, ~no_lane());
    for (int k = 0; k <= n; k++) {
        store(in_row(block, D + k, i, n), (lanes)((words)p.d[k] ^ s.side));
        largest = larger(largest, absolute(s.w[k]));
    }
    store(in_row(block, RADIUS, i, n), p.radius);
    s.e[0] = p.radius;
    s.p = all_lanes(0);
    s.q = s.limit = all_lanes(1);
    mask ends = p.sound & ends_known(s.w, s.e, n, 0, s.p);
    signs whole = count_signs(s.w, s.e, n, 0);
    store(in_row(block, PLACE, i, n), choose(ends, all_lanes(NOWHERE), all_lanes(UNDECIDED)));
    unsigned some = bits(ends & ~whole.none) & first_lanes(room), one = bits(whole.one) & some;
    if (one) add_brackets(block, &s, id, one, n);
    add_cells(block, &s, id, (8 * n * 0x1p-53) * (largest + p.radius), some & ~one, n);
}

INLINE void classify_all_n(const algsurf_i_polys_job *job, poly_block *block, size_t at, int count, int n) {
    for (int i = 0; i < count; i += LANES)
        classify(job, block, at + (size_t)i, i, at_most_of(count - i, LANES), n);
}

/* The first `count` polynomials from `at` on. */
APART void classify_all(const algsurf_i_polys_job *job, poly_block *block, size_t at, int count, int n) {
    if (n < 1) __builtin_unreachable();
    block->cells = block->hits = 0;
    FOR_DEGREE(n, classify_all_n(job, block, at, count, N))
}

INLINE void go_on_n(const poly_block *block, cell *s, lanes id, lanes cut_error, mask which, int n) {
    lanes d[ALGSURF_MAX_POLYS_DEGREE + 1], b[ALGSURF_MAX_POLYS_DEGREE + 1], radius;
    int index[LANES];
    to_index(id, index);
    for (int k = 0; k <= n; k++) d[k] = gather_row(block, D + k, index, n);
    radius = gather_row(block, RADIUS, index, n);
    powers_to_bernstein(block->basis, n + 1, d, b, n);
    cut_cell(s, b, &radius, n, 0, cut_error, which, s->q, s->limit);
}

/* The cells of `which` lanes become what is left to search of the whole interval. */
APART void go_on(const poly_block *block, cell *s, const lanes *id, const lanes *cut_error,
                 const mask *which){FOR_DEGREE(block->degree, go_on_n(block, s, *id, *cut_error, *which, N))}

/* Splits the cells of `which` lanes and keeps the first part that may hold a root; returns what is still
 * open. */
INLINE unsigned divide_some(poly_block *block, cell *s, lanes id, lanes cut_error, unsigned which, int n,
                            int turn) {
    signs c;
    mask undecided = at_most(s->q - s->p, all_lanes(NARROWEST));
    undecided |=
        divide(s, n, 0, cut_error, ~no_lane(), all_lanes(-1), all_lanes(0), all_lanes(2), turn, &c, NULL);
    mask again = c.none & less(s->q, s->limit);
    if (bits(again) & which) {
        go_on(block, s, &id, &cut_error, &again);
        undecided |= again & ~ends_known(s->w, s->e, n, 0, all_lanes(0));
        c = count_signs(s->w, s->e, n, 0);
    }
    unsigned unknown = bits(undecided) & which, hits = bits(c.one) & which & ~unknown;
    if (unknown) leave_undecided(block, id, unknown, n);
    if (hits) add_brackets(block, s, id, hits, n);
    return which & ~bits(c.none) & ~hits & ~unknown;
}

INLINE void divide_cells_n(poly_block *block, int n, int turn) {
    int waiting = block->cells;
    block->cells = 0;
    for (int i = 0; i < waiting; i += LANES) {
        cell s;
        lanes id, cut_error;
        take_cells(block, i, &s, &id, &cut_error, n);
        unsigned open = divide_some(block, &s, id, cut_error, first_lanes(waiting - i), n, turn);
        add_cells(block, &s, id, cut_error, open, n);
    }
}

/* Splits each cell once. */
APART void divide_cells(poly_block *block, int n, int turn) {
    if (n < 1) __builtin_unreachable();
    FOR_DEGREE(n, divide_cells_n(block, N, turn))
}

/* The bytes of `hits` become 1, those of `undecided` 2, others 0. */
INLINE void store_states(uint8_t *state, mask hits, mask undecided, int count) {
    static const uint8_t spread[16][4] = {{0, 0, 0, 0}, {1, 0, 0, 0}, {0, 1, 0, 0}, {1, 1, 0, 0},
                                          {0, 0, 1, 0}, {1, 0, 1, 0}, {0, 1, 1, 0}, {1, 1, 1, 0},
                                          {0, 0, 0, 1}, {1, 0, 0, 1}, {0, 1, 0, 1}, {1, 1, 0, 1},
                                          {0, 0, 1, 1}, {1, 0, 1, 1}, {0, 1, 1, 1}, {1, 1, 1, 1}};
    uint8_t all[8] = {0};
    for (int l = 0; l < LANES; l += 4) {
        uint32_t hit, open;
        __builtin_memcpy(&hit, spread[bits(hits) >> l & 15], 4);
        __builtin_memcpy(&open, spread[bits(undecided) >> l & 15], 4);
        hit = ALGSURF_LANE_HIT * hit + ALGSURF_LANE_UNDECIDED * open;
        __builtin_memcpy(all + l, &hit, 4);
    }
    if (count >= LANES) {
        __builtin_memcpy(state, all, LANES);
    } else {
        for (int l = 0; l < count; l++) state[l] = all[l];
    }
}

/* The answers of polynomials i .. of the block; returns whether some are undecided. */
INLINE int store_answers(const algsurf_i_polys_job *job, const poly_block *block, size_t at, int i, int room,
                         int n) {
    lanes v = load_row(block, PLACE, i, n);
    mask hit = less(v, all_lanes(UNDECIDED)), undecided = at_most(v, all_lanes(UNDECIDED)) & ~hit;
    store_states(job->state + at, hit, undecided, room);
    if (!job->root) return any(undecided);
    lanes lo, hi;
    load_interval(job, at, room, &lo, &hi);
    lanes t = 0.5 * lo + 0.5 * hi + v * (0.5 * hi - 0.5 * lo);
    t = choose(at_most(absolute(v - ENCLOSED), all_lanes(0)), load_row(block, VALUE, i, n), t);
    store_some(job->root + at, choose(hit, smaller(larger(t, lo), hi), all_lanes(HUGE_VAL)), room);
    return any(undecided);
}

INLINE int solve_block(const algsurf_i_polys_job *job, poly_block *block, size_t at, int count, int n) {
    int turn = 0, undecided = 0;
    classify_all(job, block, at, count, n);
    for (; block->cells > 0 && turn < MOST_TURNS; turn++) divide_cells(block, n, turn);
    for (int i = 0; i < block->cells; i++) leave_undecided(block, load_row(block, ID, i, n), 1, n);
    for (int i = 0; i < block->hits && !job->root; i++)
        *in_row(block, PLACE, (int)*in_row(block, HIT_ID, i, n), n) = 0;
    for (int i = 0; i < block->hits && job->root; i += PAIR * LANES) refine_some(job, block, at, i, n);
    for (int i = 0; i < count; i += LANES)
        undecided |= store_answers(job, block, at + (size_t)i, i, at_most_of(count - i, LANES), n);
    return undecided;
}

/* LANES polynomials of degree 1 or 2 by the closed form; returns whether it leaves some open. */
INLINE int solve_closed(const algsurf_i_polys_job *job, size_t at, int count, int n) {
    centred p;
    mask hit, undecided;
    centre(job, at, count, &p, n);
    lanes v = first_root_closed(&p, n, &hit, &undecided);
    store_states(job->state + at, hit, undecided, count);
    if (!job->root) return any(undecided);
    lanes t = smaller(larger(p.middle + v * p.half, p.lo), p.hi);
    store_some(job->root + at, choose(hit, t, all_lanes(HUGE_VAL)), count);
    return any(undecided);
}

INLINE int solve_closed_n(const algsurf_i_polys_job *job, int n) {
    const size_t count = job->p.count;
    int undecided = 0;
    for (size_t at = 0; at < count; at += LANES)
        undecided |= solve_closed(job, at, count - at < LANES ? (int)(count - at) : LANES, n);
    return undecided;
}

/* Degrees 1 and 2.  What the closed form leaves open is walked like all others. */
static int solve_low(const algsurf_i_polys_job *job) {
    const int n = job->p.degree;
    const size_t count = job->p.count;
    if (!(n == 2 ? solve_closed_n(job, 2) : solve_closed_n(job, 1))) return 0;
    poly_block block;
    int undecided = 0, open = 0;
    begin_block(&block, n);
    for (size_t at = 0; at <= count; at++) {
        if (at < count && job->state[at] == ALGSURF_LANE_UNDECIDED && open < POLYS_OF(n)) {
            open++;
        } else if (open) {
            undecided |= solve_block(job, &block, at - (size_t)open, open, n);
            open = at < count && job->state[at] == ALGSURF_LANE_UNDECIDED;
        }
    }
    return undecided;
}

static int solve_polys(const algsurf_i_polys_job *job) {
    int undecided = 0, n = job->p.degree;
    if (n <= 2) return solve_low(job);
    poly_block block;
    begin_block(&block, n);
    const size_t together = (size_t)POLYS_OF(n), count = job->p.count;
    for (size_t at = 0; at < count; at += together)
        undecided |= solve_block(job, &block, at, (int)(count - at < together ? count - at : together), n);
    return undecided;
}

#endif
