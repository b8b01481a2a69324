/* exact_cell.h - a cell of the exact walk: Bernstein coefficients in integers over a dyadic part of a piece.
 */
#ifndef ALGSURF_EXACT_CELL_H
#define ALGSURF_EXACT_CELL_H
#include "../poly/integral.h"

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

/* The whole of a piece: f over [at, at + 2^length]. */
int algsurf_exact_cell_whole(algsurf_memory *m, const algsurf_zpoly *f, int64_t at, int length,
                             algsurf_exact_cell *cell);

/* Variations of sign, zeros left out. */
int algsurf_exact_variations(const algsurf_zpoly *b);

/* The cell becomes its right half, *left its left half, on top of it. */
int algsurf_exact_halve(algsurf_memory *m, algsurf_exact_cell *cell, algsurf_exact_cell *left);

/* The left half, on top of the right one, takes its place. */
void algsurf_exact_keep_left(algsurf_memory *m, algsurf_exact_cell *cell, const algsurf_exact_cell *left);

/* A step to a cluster of v >= 2 roots: if all roots of the cell are proved to be in a much narrower part of
 * it, the cell becomes that part and *done 1, else *done is 0.  Neither end may be a root. */
int algsurf_exact_zoom(algsurf_memory *m, algsurf_exact_cell *cell, int v, int *done);

/* The coefficients as doubles, the largest between 1/2 and 1; each is off by 2^-52 of its size, and by
 * 2^-900. */
void algsurf_exact_cell_doubles(const algsurf_exact_cell *cell, double *b);

#endif
