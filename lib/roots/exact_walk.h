/* exact_walk.h - the exact engine: the real roots of a polynomial with integer coefficients, in order, always
 * decided.
 *
 * p(u) is given with its unit, t = 2^unit u, and an interval of t.  The engine cuts the interval into pieces,
 * makes Bernstein coefficients over each, counts their variations of sign (Descartes' rule: none, no root;
 * one, exactly one root) and halves what has more.  All of it is done in integers, so every count is true.
 *
 * Halving ends when no root is multiple.  Where a cell keeps two variations or more, the greatest common
 * divisor of p and p' is looked for; if it is not constant, the walk begins again with p's squarefree part
 * s[0], whose roots are p's, each once, and passes over as many roots as it has reported.  What s[i] (the
 * roots of multiplicity above i) does at a root then tells the multiplicity.
 *
 * Where halving gets far and still finds two variations, roots are too close for it: then all real roots come
 * from discs about all complex ones (complex/on_axis.c).
 *
 * Source: Collins, Akritas 1976; Rouillier, Zimmermann, Efficient isolation of polynomial's real roots, 2004;
 * Sagraloff, Mehlhorn, Computing real roots of real polynomials, 2016 (the step to a cluster). */
#ifndef ALGSURF_ROOTS_EXACT_WALK_H
#define ALGSURF_ROOTS_EXACT_WALK_H
#include "algsurf/isolate.h"
#include "../complex/impl.h"
#include "../poly/integral.h"
#include "coefficients.h"
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
    int active, count;            /* there is a cell in work; so many wait */
    const algsurf_i_watch *watch; /* null: nobody looks */
    algsurf_exact_piece piece;    /* that the cells are of */
    int unit;                     /* of the polynomial: t = 2^unit u */
} algsurf_exact_cells;

/* Where a root is: the only root of `of` in the open interval (a, b) 2^-r of u, `of` being nonzero with
 * different signs at its ends; or, when b is null, the point a 2^-r. */
typedef struct algsurf_exact_place {
    const algsurf_zpoly *of;
    const algsurf_limb *a, *b;
    int width, r;
} algsurf_exact_place;

/* A root of p.  What is marked "refined" is there only if the walk was told to refine. */
typedef struct algsurf_exact_root {
    double lo, hi;             /* encloses; refined: lo = hi = t, or neighbours with the root between them */
    double t;                  /* refined: one of lo and hi, the one where |p| is less */
    int multiplicity;          /* >= 1 */
    int sign_before;           /* of p just before the root: -1 or 1 */
    algsurf_exact_place place; /* lives until the next call */
} algsurf_exact_root;

/* A coefficient c: 2^(bits-1) <= |c| <= 2^bits, and |c| is nearly part 2^exponent, or c = 0. */
typedef struct algsurf_exact_size {
    double part;
    int exponent, bits, sign;
} algsurf_exact_size;

/* The pieces that an interval is cut into. */
typedef struct algsurf_exact_pieces {
    algsurf_exact_size *size; /* of each coefficient */
    int degree, unit;
    double lo, hi;   /* of t, finite or not; ends belong to it */
    int scattered;   /* 0: one piece; 1: cut at 0 and powers of two */
    int least, most; /* exponents between which p can have roots */
    int inner; /* scattered: those below 2^inner are in one piece on either side; least: there are none */
    int side, exponent; /* scattered: the next piece is 2^exponent <= |t| <= 2^(exponent+1) on this side */
    int done;
} algsurf_exact_pieces;

typedef struct algsurf_exact_walk {
    algsurf_memory *memory;
    algsurf_zpoly p; /* not constant */
    int unit;
    double lo, hi; /* the roots asked for */
    int refine;
    algsurf_exact_pieces pieces;
    /* squarefree part */
    int asked;                 /* 1: p is squarefree, or parts are there */
    int parts;                 /* 0: p itself is walked; else members of s */
    algsurf_zpoly *s;          /* s[0] is walked */
    int opened, gave_up;       /* how many pieces; discs do not have the roots */
    int given, skip;           /* roots so far; of those to be passed over again */
    algsurf_exact_cells cells; /* of the piece */
    int before;                /* the sign of what is walked before its last simple root */
    /* from discs */
    algsurf_i_root_on_axis *listed;         /* null: there are none; else the roots, */
    int list_length, next;                  /* how many; the next one */
    algsurf_memory_mark begin, bottom, top; /* before everything; below the piece; above the cell */
} algsurf_exact_walk;

enum { ALGSURF_EXACT_NO_MEMORY = -1, ALGSURF_EXACT_END = 0, ALGSURF_EXACT_ROOT = 1 };

/* The unit and the single piece that suit an interval of finite ends lo <= hi: [lo, hi] is inside, and hi not
 * at its end.  On one side of 0 if lo and hi are. */
algsurf_exact_piece algsurf_exact_piece_of(double lo, double hi);

/* Begins a walk over the roots t of p in [lo,hi], lo <= hi, infinite ends allowed; p has a degree of at least
 * 1 and no leading zeros, and is only referred to.  Memory is taken until algsurf_exact_end.  Returns 0 when
 * there is none.
 *   refine  ISOLATED, the cheapest: roots come without t, lo and hi around the place as it was isolated;
 *           BRACKETS: the same, lo and hi being the place itself if its ends are doubles in [lo,hi] and
 *           the root is simple, else as REFINED; REFINED, the dearest: with t
 *   watch   null, or who is told */
enum { ALGSURF_EXACT_ISOLATED = 0, ALGSURF_EXACT_REFINED = 1, ALGSURF_EXACT_BRACKETS = 2 };
int algsurf_exact_begin(algsurf_exact_walk *walk, algsurf_memory *m, const algsurf_zpoly *p, int unit,
                        double lo, double hi, int refine, const algsurf_i_watch *watch);

/* The next root, in increasing order. */
int algsurf_exact_next(algsurf_exact_walk *walk, algsurf_exact_root *root);

/* The sign of q at the root last reported, -1, 0 or 1, in *sign.  q is a polynomial in the same u: constant,
 * linear, or concave, that is, of degree 2 with a negative leading coefficient.  Returns 0 when there is no
 * memory. */
int algsurf_exact_sign_at_root(algsurf_exact_walk *walk, const algsurf_exact_root *root,
                               const algsurf_zpoly *q, int *sign);

void algsurf_exact_end(algsurf_exact_walk *walk);

/* ---- exact_radii.c: coefficients known to radii ---- */

/* Where roots are.
 * - sign_lo 1 or -1, lo < hi: every polynomial of the set has exactly one root in (lo,hi), a simple one, the
 *   sign sign_lo at lo and the other one at hi.  hi - lo is as small as doubles and radii allow.  One of them
 *   is infinite, and the other one the largest double, for a root beyond this.
 * - sign_lo 0: undecided; [lo,hi] holds any number of roots, not the same for all polynomials of the set.
 * With lo = hi: a root of all of them or of some; their signs there tell. */
typedef struct algsurf_exact_range {
    double lo, hi;
    int sign_lo;
} algsurf_exact_range;

/* The roots t = 2^unit u in [lo,hi], lo <= hi, infinite ends allowed, of the polynomials p + e, |e_k| <=
 * radius_k.  Radius has no negative coefficients; its degree may be above p's.  Outside of the ranges found,
 * which are in order and at most `capacity` >= 1, no polynomial of the set has a root in [lo,hi]; when there
 * is no room for more, ranges are joined to undecided ones.  watch: null, or who is told.  Returns 0 when
 * there is no memory; nothing of it is kept. */
int algsurf_exact_radii_isolate(algsurf_memory *m, const algsurf_zpoly *p, const algsurf_zpoly *radius,
                                int unit, double lo, double hi, algsurf_exact_range *found, int capacity,
                                int *count, const algsurf_i_watch *watch);

/* The sign at t, finite, that all these polynomials have in common, or 2: there is none.  Returns as above.
 */
int algsurf_exact_radii_sign(algsurf_memory *m, const algsurf_zpoly *p, const algsurf_zpoly *radius, int unit,
                             double t, int *sign);

/* ---- shared by the engine's files ---- */

/* exact_cell.c: cells, Bernstein coefficients in integers over dyadic parts of a piece. */

/* The whole of a piece becomes the cell, of f. */
int algsurf_exact_cells_open(algsurf_exact_cells *cells, const algsurf_zpoly *f,
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

/* The cell's numbers in these widths, in a new block at the top of the stack; the old one, where it is above
 * that, is still read.  Wider ones may begin where the old ones do, others before them. */
int algsurf_exact_move_cell(algsurf_memory *m, algsurf_exact_cell *cell, int width, int position_width);
/* Takes a common power of two out of the coefficients, and sets their bits. */
void algsurf_exact_strip(algsurf_exact_cell *cell);
int algsurf_exact_variations(const algsurf_exact_cell *cell);

/* The ends of one of the cells as a place, of no polynomial, in u, taken from memory. */
int algsurf_exact_cell_place(algsurf_memory *m, const algsurf_exact_cells *cells,
                             const algsurf_exact_cell *cell, algsurf_exact_place *place);

/* Shows a cell to whoever watches; returns 0 when there is no memory. */
int algsurf_exact_tell_cell(const algsurf_exact_cells *cells, const algsurf_exact_cell *cell);

/* A step to a cluster of v >= 2 roots of one polynomial: if all roots of the cell are proved to be in a much
 * narrower part of it, the cell becomes that part and *done 1, else *done is 0.  Neither end may be a root.
 */
int algsurf_exact_zoom(algsurf_memory *m, algsurf_exact_cell *cell, int v, int *done);

/* The coefficients as doubles, the largest between 1/2 and 1; each is off by 2^-52 of its size, and by
 * 2^-900. */
void algsurf_exact_cell_doubles(const algsurf_exact_cell *cell, double *b);

/* exact_pieces.c: the pieces of [lo,hi] from left to right, for p, a polynomial in u = 2^-unit t; returns 0
 * without memory.  _again: from the beginning. */
int algsurf_exact_pieces_begin(algsurf_exact_pieces *s, algsurf_memory *m, const algsurf_zpoly *p, int unit,
                               double lo, double hi);
void algsurf_exact_pieces_again(algsurf_exact_pieces *s);
enum {
    ALGSURF_EXACT_NO_PIECE, /* the end */
    ALGSURF_EXACT_PIECE,    /* roots may be in this one */
    ALGSURF_EXACT_ZERO      /* 0 is a root */
};
int algsurf_exact_pieces_next(algsurf_exact_pieces *s, algsurf_exact_piece *piece);

/* exact_refine.c: the signs of p at a and b of a place; at_b may be null, and is 0 where there is no b. */
int algsurf_exact_signs(algsurf_memory *m, const algsurf_zpoly *p, const algsurf_exact_place *place,
                        int *at_a, int *at_b);
/* Halves an interval, `before` being the sign just right of a; the middle may be found to be the root. */
int algsurf_exact_halve(algsurf_memory *m, algsurf_exact_place *place, int before);
/* lo, hi and t as the place tells them. */
void algsurf_exact_set_hull(const algsurf_exact_walk *walk, algsurf_exact_root *root);
/* From the cell with one root of f, whose ends may be other roots, to its place, and as follows. */
int algsurf_exact_refine_cell(algsurf_exact_walk *walk, const algsurf_zpoly *f, algsurf_exact_root *root);
/* From an interval with one root, simple in what is walked, before which walk->before is the sign, to
 * doubles, if that is asked for; _to_doubles: in any case, from a place whose hull is set. */
int algsurf_exact_refine_place(algsurf_exact_walk *walk, algsurf_exact_root *root);
int algsurf_exact_to_doubles(algsurf_exact_walk *walk, algsurf_exact_root *root);
/* Sign (and value 2^exponent, or null) of f, a polynomial in u = 2^-unit t, at t; of t = +-infinity the sign
 * beyond all roots, without a value. */
int algsurf_exact_at_double(algsurf_memory *m, const algsurf_zpoly *f, int unit, double t, int *sign,
                            double *value, int *exponent);
#endif
