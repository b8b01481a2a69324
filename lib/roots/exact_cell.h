/* exact_cell.h - cells of the exact walk: Bernstein coefficients in integers over dyadic parts of a piece. */
#ifndef ALGSURF_EXACT_CELL_H
#define ALGSURF_EXACT_CELL_H
#include "../poly/integral.h"
#include "watch.h"

/* A part of the line: u' in [at, at + 2^length), t = 2^unit u'; 0 <= length <= 5. */
typedef struct algsurf_exact_piece {
    int unit, length;
    int64_t at;
} algsurf_exact_piece;

/* The part [position 2^-(depth+fine), that + 2^-depth] of its piece taken as [0,1].  Coefficients and
 * position are one block of memory, the last one taken. */
typedef struct algsurf_exact_cell {
    algsurf_zpoly b; /* up to a positive factor */
    int bits;        /* |b_j| <= 2^bits */
    algsurf_limb *position;
    int position_width, depth, fine;
    int variations; /* of sign in b, zeros left out */
    int left_done;  /* b_0 = 0, and the root there has been dealt with */
    algsurf_memory_mark begin;
} algsurf_exact_cell;

/* The cell in work and, further to the right, those that wait. */
typedef struct algsurf_exact_cells {
    algsurf_memory *memory;
    algsurf_exact_cell cell, *waiting;
    int active; /* there is a cell in work */
    int count, room;
    const algsurf_i_watch *watch; /* null: nobody looks */
    algsurf_exact_piece piece;    /* that the cells are of */
    int unit;                     /* of the polynomial: t = 2^unit u */
} algsurf_exact_cells;

/* No cells, and room for `room` that wait. */
int algsurf_exact_cells_begin(algsurf_exact_cells *cells, algsurf_memory *m, int room,
                              const algsurf_i_watch *watch);

/* The whole of a piece becomes the cell, of f, a polynomial in u = 2^-unit t. */
int algsurf_exact_cells_open(algsurf_exact_cells *cells, const algsurf_zpoly *f, int unit,
                             const algsurf_exact_piece *piece);

/* The cell is done with: the next one that waits, if any. */
void algsurf_exact_cells_next(algsurf_exact_cells *cells);

/* Halves the cell; what may have roots is kept, the right half waits for the left one. */
int algsurf_exact_cells_halve(algsurf_exact_cells *cells);

static inline int algsurf_exact_sign(const algsurf_exact_cell *cell, int j) {
    return algsurf_z_sign(algsurf_zpoly_at(&cell->b, j), cell->b.width);
}

/* Is the cell's left end a root that has not been dealt with? */
static inline int algsurf_exact_begins_with_root(const algsurf_exact_cell *cell) {
    return !cell->left_done && algsurf_exact_sign(cell, 0) == 0;
}

int algsurf_exact_variations(const algsurf_exact_cell *cell);

/* The bounds of a cell of the piece in u = 2^-unit t: N 2^-r, taken from memory. */
int algsurf_exact_cell_ends(algsurf_memory *m, const algsurf_exact_cell *cell,
                            const algsurf_exact_piece *piece, int unit, algsurf_limb **a, algsurf_limb **b,
                            int *width, int *r);

/* Shows a cell to whoever watches; returns 0 when there is no memory. */
int algsurf_exact_tell_cell(const algsurf_exact_cells *cells, const algsurf_exact_cell *cell);

/* A step to a cluster of v >= 2 roots of one polynomial: if all roots of the cell are proved to be in a much
 * narrower part of it, the cell becomes that part and *done 1, else *done is 0.  Neither end may be a root.
 */
int algsurf_exact_zoom(algsurf_memory *m, algsurf_exact_cell *cell, int v, int *done);

/* The coefficients as doubles, the largest between 1/2 and 1; each is off by 2^-52 of its size, and by
 * 2^-900. */
void algsurf_exact_cell_doubles(const algsurf_exact_cell *cell, double *b);

#endif
