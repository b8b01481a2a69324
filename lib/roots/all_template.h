/* all_template.h - all roots of LANES polynomials given in the power basis, each between neighbouring
 * doubles.
 *
 * Isolated as in first_template.h, but both parts of a split cell are kept, on a stack.  A root that Halley's
 * method has found is enclosed as in enclose_template.h.  All that is undecided leaves its polynomial
 * undecided. */
#ifndef ALGSURF_ALL_TEMPLATE_H
#define ALGSURF_ALL_TEMPLATE_H
#include "block_template.h"
#include "brackets_template.h"
#include "first_template.h"
#include "settle_template.h"

/* Of polynomials: more cells than polynomials may wait. */
#define BATCH_OF(n) (POLYS_OF(n) / 2)

/* The root of a lane among those of its polynomial, in increasing order. */
INLINE void add_root(algsurf_real_root *roots, int count, const enclosure *e, int l) {
    double a = e->before[l], b = e->t[l];
    int rises = (e->last[l] < 0) == (a < b), i = count;
    for (; i > 0 && roots[i - 1].lo > fmin(a, b); i--) roots[i] = roots[i - 1];
    roots[i] = (algsurf_real_root){e->value[l], fmin(a, b), fmax(a, b), 1, rises ? -1 : 1};
}

/* Roots in brackets i, i+1 .. */
INLINE void enclose_some(const algsurf_i_polys_job *job, poly_block *block, size_t at, int i, int n) {
    approaches all;
    enclosure e[PAIR];
    approach_hits(job, block, i, n, &all);
    enclose_hits(job, block, at, i, &all, n, e);
    for (int w = 0; w < all.packets; w++)
        for (int l = 0; l < at_most_of(block->hits - i - w * LANES, LANES); l++) {
            size_t to = at + (size_t)all.id[w][l];
            if (bits(e[w].found) >> l & 1)
                add_root(job->roots + to * (size_t)n, job->found[to]++, e + w, l);
            else
                *in_row(block, PLACE, all.id[w][l], n) = UNDECIDED;
        }
}

static void enclose_all(const algsurf_i_polys_job *job, poly_block *block, size_t at, int n) {
    for (int i = 0; i < block->hits; i += PAIR * LANES) enclose_some(job, block, at, i, n);
    block->hits = 0;
}

/* What may hold roots of part of a cell: a bracket, or a cell to be split. */
INLINE void keep_part(poly_block *block, cell *part, lanes id, lanes cut_error, unsigned which, int n) {
    signs c = count_signs(part->w, part->e, n, 0);
    unsigned one = bits(c.one) & which;
    id = (lanes)((words)id ^ part->side);
    if (one) add_brackets(block, part, id, one, n);
    which &= ~one & ~bits(c.none);
    if (which) add_cells(block, part, id, cut_error, which, n);
}

/* Splits the last cells of the stack. */
INLINE void split_last_n(poly_block *block, int n, int turn) {
    cell left, right;
    lanes id, cut_error;
    int i = block->cells > LANES ? block->cells - LANES : 0;
    unsigned room = first_lanes(block->cells - i);
    take_cells(block, i, &right, &id, &cut_error, n);
    left.limit = right.limit = right.q;
    left.e[0] = right.e[0] += cut_error;
    block->cells = i;
    lanes at = split_point(&right, n, turn);
    mask undecided = at_most(right.q - right.p, all_lanes(NARROWEST));
    split(right.w, left.w, n, at - right.p, right.q - at);
    undecided |= ~less(left.e[0], absolute(right.w[0]));
    left.p = right.p;
    left.q = right.p = at;
    left.side = (words)all_lanes(0);
    right.side = take_sign(right.w, n, ~no_lane());
    unsigned unknown = bits(undecided) & room;
    if (unknown) leave_undecided(block, absolute(id), unknown, n);
    keep_part(block, &right, id, cut_error, room & ~unknown, n);
    keep_part(block, &left, id, cut_error, room & ~unknown, n);
}

APART void split_last(poly_block *block, int n, int turn) {
    if (n < 1) __builtin_unreachable();
    FOR_DEGREE(n, split_last_n(block, N, turn))
}

static void solve_batch(const algsurf_i_polys_job *job, poly_block *block, size_t at, int count, int n) {
    classify_all(job, block, at, count, n);
    for (int i = 0; i < count; i++) job->found[at + (size_t)i] = 0;
    for (int turn = 0; block->cells > 0; turn++) {
        if (block->hits > POLYS_OF(n) - 2 * LANES) enclose_all(job, block, at, n);
        if (block->cells > POLYS_OF(n) - LANES || turn > MOST_TURNS * BATCH_OF(n)) break;
        split_last(block, n, turn);
    }
    for (int i = 0; i < block->cells; i++) leave_undecided(block, absolute(load_row(block, ID, i, n)), 1, n);
    enclose_all(job, block, at, n);
    for (int i = 0; i < count; i++)
        if (*in_row(block, PLACE, i, n) == UNDECIDED) job->found[at + (size_t)i] = -1;
}

static void solve_all(const algsurf_i_polys_job *job) {
    poly_block block;
    begin_block(&block, job->p.degree);
    const size_t batch = (size_t)BATCH_OF(job->p.degree), count = job->p.count;
    for (size_t at = 0; at < count; at += batch)
        solve_batch(job, &block, at, (int)(count - at < batch ? count - at : batch), job->p.degree);
}

const algsurf_i_roots_kernel KERNEL(algsurf_i_roots) = {.solve = solve_polys,
                                                        .solve_all = solve_all,
                                                        .single = KERNEL(algsurf_i_roots_single),
                                                        .settle = settle_roots};

#endif
