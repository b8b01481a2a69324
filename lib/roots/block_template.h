/* block_template.h - polynomials that are solved together, and what is known of them: a block.
 *
 * Each number of a polynomial, of a cell (descartes_template.h) or of a bracket has a row of its own, so that
 * those of neighbours are lanes.  Cells and brackets name their polynomial and are in any order: those that
 * remain of a packet are appended without gaps (store_chosen), and the next packets are full again. */
#ifndef ALGSURF_BLOCK_TEMPLATE_H
#define ALGSURF_BLOCK_TEMPLATE_H
#include "../poly/basis.h"
#include "polys.h"
#define MOST_DEGREE ALGSURF_MAX_POLYS_DEGREE
#define MOST_OWN 0
#include "../simd/lanes.h"
#include "centred_template.h"
#include "descartes_template.h"

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
    PLACE,  /* its root in [-1,1], NOWHERE, UNDECIDED, or ENCLOSED */
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
#define UNDECIDED 2.0
#define ENCLOSED 1.5

/* Polynomials and what was found. */
typedef struct poly_block {
    int degree, cells, hits;                                                       /* how many */
    double basis[(ALGSURF_MAX_POLYS_DEGREE + 1) * (ALGSURF_MAX_POLYS_DEGREE + 1)]; /* poly/basis.h */
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

static void begin_block(poly_block *block, int n) {
    algsurf_i_power_basis(block->basis, n);
    block->degree = n;
    for (int i = 0; i < ROW_OF(n); i++)
        *in_row(block, ID, i, n) = *in_row(block, HIT_ID, i, n) = 0; /* lanes behind the last name one too */
}

INLINE unsigned first_lanes(int count) { return count >= LANES ? (1u << LANES) - 1 : (1u << count) - 1; }

INLINE int at_most_of(int count, int most) { return count < most ? count : most; }

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

INLINE void add_brackets(poly_block *block, const cell *s, lanes id, unsigned chosen, int n) {
    int i = block->hits;
    store_chosen(in_row(block, HIT_ID, i, n), id, chosen);
    store_chosen(in_row(block, BEGIN, i, n), 2 * s->p - 1, chosen);
    store_chosen(in_row(block, END, i, n), 2 * s->q - 1, chosen);
    store_chosen(in_row(block, NEAR, i, n), 2 * (s->p + polygon_root(s->w, n) * (s->q - s->p)) - 1, chosen);
    block->hits += __builtin_popcount(chosen);
}

INLINE void leave_undecided(poly_block *block, lanes id, unsigned which, int n) {
    for (int l = 0; which >> l; l++)
        if (which >> l & 1) *in_row(block, PLACE, (int)id[l], n) = UNDECIDED;
}

#endif
