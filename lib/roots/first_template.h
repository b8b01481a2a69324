/* first_template.h - the first roots of LANES polynomials given in the power basis.
 *
 * They are counted by Descartes' rule.  Those with more than one variation of sign are split, all of them
 * once; what is still open is packed together and split again, so that no lane waits for another.  Brackets
 * are refined by Halley's method on the power basis about the middle (halley_template.h), from where the
 * control polygon crosses zero. */
#ifndef ALGSURF_FIRST_TEMPLATE_H
#define ALGSURF_FIRST_TEMPLATE_H
#include "../poly/table.h"
#include "kernel.h"
#define MOST_DEGREE ALGSURF_MAX_POLYS_DEGREE
#define MOST_OWN 0
#include "../simd/degrees.h"
#include "../simd/lanes.h"
#include "centred_template.h"
#include "closed_template.h"
#include "descartes_template.h"
#include "enclose_template.h"
#include "halley_template.h"

#define LEAST_ROOT_STEP 0x1p-52
#define USUAL_ROOT_STEP 0x1p-44 /* 3e-14 of the interval: what is expected of a step is no bound */
#define MANY_ROUNDS 8           /* of Halley's method; two or three are usual */
#define BLURRED 0x1p-39         /* errors of roots that are left to double-double */

/* The bytes of `hits` become 1, those of `doubts` 2, others 0. */
INLINE void store_states(uint8_t *state, mask hits, mask doubts, int count) {
    static const uint8_t spread[16][4] = {{0, 0, 0, 0}, {1, 0, 0, 0}, {0, 1, 0, 0}, {1, 1, 0, 0},
                                          {0, 0, 1, 0}, {1, 0, 1, 0}, {0, 1, 1, 0}, {1, 1, 1, 0},
                                          {0, 0, 0, 1}, {1, 0, 0, 1}, {0, 1, 0, 1}, {1, 1, 0, 1},
                                          {0, 0, 1, 1}, {1, 0, 1, 1}, {0, 1, 1, 1}, {1, 1, 1, 1}};
    uint8_t all[8] = {0};
    for (int l = 0; l < LANES; l += 4) {
        uint32_t hit, doubt;
        __builtin_memcpy(&hit, spread[bits(hits) >> l & 15], 4);
        __builtin_memcpy(&doubt, spread[bits(doubts) >> l & 15], 4);
        hit = ALGSURF_LANE_HIT * hit + ALGSURF_LANE_DOUBTFUL * doubt;
        __builtin_memcpy(all + l, &hit, 4);
    }
    if (count >= LANES) {
        __builtin_memcpy(state, all, LANES);
    } else {
        for (int l = 0; l < count; l++) state[l] = all[l];
    }
}

/* Rows of numbers, one for each polynomial, cell or bracket, of those that are solved together. */
enum {
    ID, /* a cell of descartes_template.h that is to be split: its polynomial, and what it is */
    CELL_P,
    CELL_Q,
    LIMIT,
    ERROR,     /* its one radius */
    CUT_ERROR, /* what a cut adds to it */
    HIT_ID,    /* a part [begin,end] of [-1,1] with one root, which is about `near` */
    BEGIN,
    END,
    NEAR,
    RADIUS, /* polynomial number id, in column id */
    PLACE,  /* its root in [-1,1], NOWHERE, IN_DOUBT, or ENCLOSED */
    VALUE,  /* which is then here */
    D       /* its n + 1 coefficients about the middle */
};
#define CELL_W(n) (D + (n) + 1) /* those of a cell */
#define ROWS_OF(n) (CELL_W(n) + (n) + 1)

/* So many polynomials of degree n are solved together, and so many of their cells may wait: more share
 * packets better, fewer need less stack and stay in a cache of 48 KiB.  Each row has room for what
 * store_chosen writes behind the last one. */
#define POLYS_OF(n) ((n) <= 10 ? 128 : 80)
#define ROW_OF(n) (POLYS_OF(n) + 8)

#define ROOM (ROWS_OF(ALGSURF_MAX_POLYS_DEGREE) * ROW_OF(ALGSURF_MAX_POLYS_DEGREE))
_Static_assert(ROWS_OF(10) * ROW_OF(10) <= ROOM, "rows");

#define NOWHERE 4.0
#define IN_DOUBT 2.0
#define ENCLOSED 1.5

/* Polynomials and what was found. */
typedef struct poly_block {
    int degree, cells, hits; /* how many */
    bernstein_basis basis;
    double rows[ROOM];
} poly_block;

/* From place i of a row on. */
INLINE double *in_row(poly_block *block, int row, int i, int n) { return block->rows + row * ROW_OF(n) + i; }

INLINE lanes load_row(const poly_block *block, int row, int i, int n) {
    return load(block->rows + row * ROW_OF(n) + i);
}

/* Of polynomials `id`. */
INLINE lanes gather_row(const poly_block *block, int row, const int *id, int n) {
    return gather(block->rows + row * ROW_OF(n), 1, id);
}

INLINE unsigned first_lanes(int count) { return count >= LANES ? (1u << LANES) - 1 : (1u << count) - 1; }

INLINE void add_cells(poly_block *block, const cell *s, lanes id, lanes cut_error, unsigned chosen, int n) {
    double *to = in_row(block, 0, block->cells, n);
    const int row = ROW_OF(n);
    store_chosen(to + ID * row, id, chosen);
    store_chosen(to + CELL_P * row, s->p, chosen);
    store_chosen(to + CELL_Q * row, s->q, chosen);
    store_chosen(to + LIMIT * row, s->limit, chosen);
    store_chosen(to + ERROR * row, s->e[0], chosen);
    store_chosen(to + CUT_ERROR * row, cut_error, chosen);
    for (int j = 0; j <= n; j++) store_chosen(to + (CELL_W(n) + j) * row, s->w[j], chosen);
    block->cells += __builtin_popcount(chosen);
}

/* Where the control polygon of one variation crosses zero. */
INLINE lanes crossing(const lanes *w, int n) {
    lanes before = w[0], after = w[1], place = all_lanes(0);
    for (int j = 1; j < n; j++) {
        mask further = less(all_lanes(0), w[j]);
        before = choose(further, w[j], before);
        after = choose(further, w[j + 1], after);
        place = choose(further, all_lanes(j), place);
    }
    return (place + before / (before - after)) * (1.0 / n);
}

INLINE void add_brackets(poly_block *block, const cell *s, lanes id, unsigned chosen, int n) {
    int i = block->hits;
    store_chosen(in_row(block, HIT_ID, i, n), id, chosen);
    store_chosen(in_row(block, BEGIN, i, n), 2 * s->p - 1, chosen);
    store_chosen(in_row(block, END, i, n), 2 * s->q - 1, chosen);
    store_chosen(in_row(block, NEAR, i, n), 2 * (s->p + crossing(s->w, n) * (s->q - s->p)) - 1, chosen);
    block->hits += __builtin_popcount(chosen);
}

INLINE void leave_in_doubt(poly_block *block, lanes id, unsigned which, int n) {
    for (int l = 0; which >> l; l++)
        if (which >> l & 1) *in_row(block, PLACE, (int)id[l], n) = IN_DOUBT;
}

/* Descartes' count over the whole intervals of polynomials i .. i+count-1 of the block, at `at` of the job.
 * Their signs become those that make the first coefficient positive. */
INLINE void classify(const algsurf_i_polys_job *job, poly_block *block, size_t at, int i, int room, int n) {
    centred p;
    cell s;
    lanes largest = all_lanes(0), id = numbered() + i;
    centre(job, at, room, &p, n);
    centred_to_bernstein(&block->basis, p.d, s.w, n);
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
    store(in_row(block, PLACE, i, n), choose(ends, all_lanes(NOWHERE), all_lanes(IN_DOUBT)));
    unsigned some = bits(ends & ~whole.none) & first_lanes(room), one = bits(whole.one) & some;
    if (one) add_brackets(block, &s, id, one, n);
    add_cells(block, &s, id, (8 * n * 0x1p-53) * (largest + p.radius), some & ~one, n);
}

INLINE int at_most_of(int count, int most) { return count < most ? count : most; }

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
    centred_to_bernstein(&block->basis, d, b, n);
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
    mask unsure = at_most(s->q - s->p, all_lanes(NARROWEST));
    unsure |=
        divide(s, n, 0, cut_error, ~no_lane(), all_lanes(-1), all_lanes(0), all_lanes(2), turn, &c, NULL);
    mask again = c.none & less(s->q, s->limit);
    if (bits(again) & which) {
        go_on(block, s, &id, &cut_error, &again);
        unsure |= again & ~ends_known(s->w, s->e, n, 0, all_lanes(0));
        c = count_signs(s->w, s->e, n, 0);
    }
    unsigned doubts = bits(unsure) & which, hits = bits(c.one) & which & ~doubts;
    if (doubts) leave_in_doubt(block, id, doubts, n);
    if (hits) add_brackets(block, s, id, hits, n);
    return which & ~bits(c.none) & ~hits & ~doubts;
}

/* Waiting cells i, i+1 .. */
INLINE void take_cells(const poly_block *block, int i, cell *s, lanes *id, lanes *cut_error, int n) {
    *id = load_row(block, ID, i, n);
    *cut_error = load_row(block, CUT_ERROR, i, n);
    s->p = load_row(block, CELL_P, i, n);
    s->q = load_row(block, CELL_Q, i, n);
    s->limit = load_row(block, LIMIT, i, n);
    s->e[0] = load_row(block, ERROR, i, n);
    s->side = (words)all_lanes(0);
    for (int j = 0; j <= n; j++) s->w[j] = load_row(block, CELL_W(n) + j, i, n);
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
    if (n < 3) __builtin_unreachable();
    FOR_DEGREE(n, divide_cells_n(block, N, turn))
}

INLINE void divide_last_cells_n(poly_block *block, int n, int turn) {
    cell s;
    lanes id, cut_error;
    unsigned open = first_lanes(block->cells);
    take_cells(block, 0, &s, &id, &cut_error, n);
    for (; open && turn < MOST_TURNS; turn++) open = divide_some(block, &s, id, cut_error, open, n, turn);
    leave_in_doubt(block, id, open, n);
}

/* The same until no cell is open: one packet, which stays where it is. */
APART void divide_last_cells(poly_block *block, int n, int turn) {
    if (n < 3) __builtin_unreachable();
    FOR_DEGREE(n, divide_last_cells_n(block, N, turn))
}

/* What of the sizes that S adds up is left at a distance of x halves from the middle. */
INLINE
double part_at(const algsurf_i_polys_job *job, size_t at, int n, double middle, double half, double x) {
    double near = 0, far = 0, m = fabs(middle);
    for (int k = n; k >= 0; k--) {
        double c = fabs(algsurf_i_table_entry(&job->c, k, at));
        near = near * (m + half * fabs(x)) + c;
        far = far * (m + half) + c;
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
        to->noise[w] = gather_row(block, RADIUS, id, n) * (1.0 / (6 * n + 10));
    }
    for (int round = 0; round < MOST_TURNS; round++) {
        mask moving = no_lane();
        for (int w = 0; w < to->packets; w++) {
            halley(a + w, d[w], n, to->noise[w], tolerance, round >= MANY_ROUNDS);
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

/* Brackets i, i+1 .. that have been approached, to neighbouring doubles: the same code for all degrees, for
 * each step of the compensated scheme waits for the one before. */
APART void enclose_hits(const algsurf_i_polys_job *job, const poly_block *block, size_t at, int i,
                        const approaches *all, int n, enclosure *e) {
    for (int w = 0; w < all->packets; w++) {
        int first = i + w * LANES;
        mask open = less(numbered(), all_lanes(block->hits - first)) & ~all->a[w].moving;
        begin_enclosure(job, at, all->id[w], load_row(block, BEGIN, first, n), load_row(block, END, first, n),
                        all->a[w].x, open, e + w, n);
    }
    for (int point = 0; point < MOST_POINTS; point++) {
        mask open = no_lane();
        for (int w = 0; w < all->packets; w++) {
            newton(e + w, n);
            open |= e[w].open;
        }
        if (!any(open)) break;
    }
}

/* Stores the roots that a packet's brackets led to; returns the lanes in doubt, those that did not come to an
 * end or whose root may be off by more than BLURRED. */
INLINE unsigned store_hits(const algsurf_i_polys_job *job, poly_block *block, size_t at, int count, int n,
                           const approaches *all, int w) {
    const approach *a = all->a + w;
    mask blurred = less(BLURRED * absolute(a->slope), all->noise[w]);
    unsigned doubts = bits(a->moving | (a->stuck & blurred)), flat = bits(blurred);
    for (int l = 0; l < LANES && l < count; l++) {
        int id = all->id[w][l];
        double x = a->x[l];
        if (flat >> l & 1) {
            size_t to = at + (size_t)id;
            ptrdiff_t which = (ptrdiff_t)to * job->interval;
            double middle = 0.5 * job->lo[which] + 0.5 * job->hi[which],
                   half = 0.5 * job->hi[which] - 0.5 * job->lo[which];
            double blur = all->noise[w][l] * part_at(job, to, n, middle, half, x);
            doubts |= (unsigned)!(blur <= BLURRED * fabs(a->slope[l])) << l;
        }
        *in_row(block, PLACE, id, n) = doubts >> l & 1 ? IN_DOUBT : x;
    }
    return doubts;
}

/* Roots in brackets i, i+1 ..  Ill-conditioned ones, without radii, by values that are better than doubles.
 */
APART void refine_some(const algsurf_i_polys_job *job, poly_block *block, size_t at, int i, int n) {
    approaches all;
    enclosure e[PAIR];
    unsigned doubts[PAIR] = {0}, some = 0;
    approach_hits(job, block, i, n, &all);
    for (int w = 0; w < all.packets; w++)
        some |= doubts[w] = store_hits(job, block, at, block->hits - i - w * LANES, n, &all, w);
    if (!some || job->r.at) return;
    enclose_hits(job, block, at, i, &all, n, e);
    for (int w = 0; w < all.packets; w++)
        for (int l = 0; doubts[w] >> l; l++)
            if (doubts[w] & bits(e[w].found) & 1u << l) {
                *in_row(block, PLACE, all.id[w][l], n) = ENCLOSED;
                *in_row(block, VALUE, all.id[w][l], n) = e[w].value[l];
            }
}

/* The answers of polynomials i .. of the block; returns whether some are in doubt. */
INLINE int finish(const algsurf_i_polys_job *job, const poly_block *block, size_t at, int i, int room,
                  int n) {
    lanes v = load_row(block, PLACE, i, n);
    mask hit = less(v, all_lanes(IN_DOUBT)), doubtful = at_most(v, all_lanes(IN_DOUBT)) & ~hit;
    store_states(job->state + at, hit, doubtful, room);
    if (!job->root) return any(doubtful);
    lanes lo, hi;
    load_interval(job, at, room, &lo, &hi);
    lanes t = 0.5 * lo + 0.5 * hi + v * (0.5 * hi - 0.5 * lo);
    t = choose(at_most(absolute(v - ENCLOSED), all_lanes(0)), load_row(block, VALUE, i, n), t);
    store_some(job->root + at, choose(hit, smaller(larger(t, lo), hi), all_lanes(HUGE_VAL)), room);
    return any(doubtful);
}

INLINE int solve_block(const algsurf_i_polys_job *job, poly_block *block, size_t at, int count, int n) {
    int turn = 0, doubts = 0;
    classify_all(job, block, at, count, n);
    for (; block->cells > LANES && turn < MOST_TURNS; turn++) divide_cells(block, n, turn);
    for (int i = LANES; i < block->cells; i++) leave_in_doubt(block, load_row(block, ID, i, n), 1, n);
    if (block->cells > 0) divide_last_cells(block, n, turn);
    for (int i = 0; i < block->hits && !job->root; i++)
        *in_row(block, PLACE, (int)*in_row(block, HIT_ID, i, n), n) = 0;
    for (int i = 0; i < block->hits && job->root; i += PAIR * LANES) refine_some(job, block, at, i, n);
    for (int i = 0; i < count; i += LANES)
        doubts |= finish(job, block, at + (size_t)i, i, at_most_of(count - i, LANES), n);
    return doubts;
}

INLINE int solve_closed(const algsurf_i_polys_job *job, size_t at, int count, int n) {
    centred p;
    mask hit, doubtful;
    centre(job, at, count, &p, n);
    lanes v = first_root_closed(&p, n, &hit, &doubtful);
    store_states(job->state + at, hit, doubtful, count);
    if (!job->root) return any(doubtful);
    lanes t = smaller(larger(p.middle + v * p.half, p.lo), p.hi);
    store_some(job->root + at, choose(hit, t, all_lanes(HUGE_VAL)), count);
    return any(doubtful);
}

/* Degrees 1 and 2. */
INLINE int solve_closed_n(const algsurf_i_polys_job *job, size_t count, int n) {
    int doubts = 0;
    for (size_t at = 0; at < count; at += LANES)
        doubts |= solve_closed(job, at, count - at < LANES ? (int)(count - at) : LANES, n);
    return doubts;
}

static void begin_block(poly_block *block, int n) {
    if (n < 1) __builtin_unreachable();
    FOR_DEGREE(n, set_basis(&block->basis, N))
    block->degree = n;
    for (int i = 0; i < ROW_OF(n); i++)
        *in_row(block, ID, i, n) = *in_row(block, HIT_ID, i, n) = 0; /* lanes behind the last name one too */
}

static int solve_polys(const algsurf_i_polys_job *job, size_t count) {
    int doubts = 0, n = job->degree;
    if (n <= 2) return n == 2 ? solve_closed_n(job, count, 2) : solve_closed_n(job, count, 1);
    poly_block block;
    begin_block(&block, n);
    const size_t together = (size_t)POLYS_OF(n);
    for (size_t at = 0; at < count; at += together)
        doubts |= solve_block(job, &block, at, (int)(count - at < together ? count - at : together), n);
    return doubts;
}

#endif
