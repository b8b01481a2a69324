/* isolate_impl.h - the walk along the line that finds roots in order, for isolate and intersect.
 *
 * A polynomial q(s) = sum c[k] s^k is scaled so that its roots of interest have |s| about 1.  The
 * line is cut into pieces, each with a local variable v in [lo,hi], |v| <= ALGSURF_CUT:
 *     near piece    v = s
 *     far piece     v = -1/s, which grows with s on either side of 0;
 *                   |v|^n q(s) = +-sum c[n-j] (-1)^j v^j, so infinity is v = 0, a point like any other.
 * The walk visits the pieces from left to right, turns each to Bernstein form and bisects by
 * Descartes' rule.  It exists for double and for double-double: one text, walk_template.h.
 */
#ifndef ALGSURF_ISOLATE_IMPL_H
#define ALGSURF_ISOLATE_IMPL_H
#include <stdint.h>

#include "algsurf/isolate.h"
#include "../base/eft.h"
#include "../base/expansion.h"

/* Where near and far pieces meet: a little beyond 1 and off every number a caller would use, so that
 * no root of a constructed example lies on the cut (there it would stay undecided). */
#define ALGSURF_CUT 0x1.0b7e151628aedp+0

typedef struct algsurf_i_piece {
    int far;
    algsurf_dd lo, hi;          /* ends in the local variable, lo < hi */
    int zero_at_lo, zero_at_hi; /* 1: the polynomial is known to be exactly zero at that end */
} algsurf_i_piece;

/* A place where roots are, in the local variable of its piece. */
typedef struct algsurf_i_cell {
    const algsurf_i_piece *piece;
    int kind;                  /* an algsurf_root_kind */
    int sign;                  /* at lo, of the local polynomial, for a bracket */
    int most;                  /* for undecided: variations at most */
    int at_lo, at_hi;          /* 1: the cell touches that end of its piece */
    algsurf_dd lo, hi;         /* its ends, to double-double */
    int exact;                 /* 1: they are the ends, and doubles; the piece is near */
    double value_lo, value_hi; /* of the local polynomial, approximate */
} algsurf_i_cell;

static inline algsurf_dd algsurf_i_dd_from_int(int64_t i) {
    double high = (double)(i >> 31) * 0x1p31;
    return algsurf_two_sum(high, (double)(i & 0x7fffffff));
}

#define ALGSURF_WALK_STRUCTS(suffix, number)                                                                 \
    typedef struct algsurf_i_walk_##suffix {                                                                 \
        int degree;                                                                                          \
        const number *c; /* q, degree+1 coefficients */                                                      \
        const double *r; /* their radii, or null for none */                                                 \
        int bounded;     /* 0: no rounding errors are accounted for (the fast tier) */                       \
        int any;         /* 1: a cell with an odd number of roots will do, it need not be one */             \
        const algsurf_i_piece *pieces;                                                                       \
        int count, index, active;                                                                            \
        int64_t position, stride;       /* next cell starts here, in 2^-62 of the piece; width to try */     \
        int64_t unknown_lo, unknown_hi; /* the last undecided cells, in a row */                             \
        int hi_told;                                                                                         \
        int counted;            /* cells so far whose variations were counted */                             \
        double radius, largest; /* error bound and largest magnitude of b */                                 \
        double cell_radius;                                                                                  \
        number local[ALGSURF_MAX_POLY_DEGREE + 1]; /* power basis in the local variable */                   \
        number b[ALGSURF_MAX_POLY_DEGREE + 1];     /* Bernstein basis over the piece */                      \
        number w[ALGSURF_MAX_POLY_DEGREE + 1];     /* Bernstein basis over the current cell */               \
    } algsurf_i_walk_##suffix;                                                                               \
    /* Starts a walk over pieces; all pointers stay the caller's. */                                         \
    void algsurf_i_walk_begin_##suffix(algsurf_i_walk_##suffix *walk, const number *c, const double *r,      \
                                       int degree, int bounded, const algsurf_i_piece *pieces, int count);   \
    /* The next place with roots, from left to right; 0: there is none.  walk->local is its polynomial. */   \
    int algsurf_i_walk_next_##suffix(algsurf_i_walk_##suffix *walk, algsurf_i_cell *cell);

ALGSURF_WALK_STRUCTS(d, double)
ALGSURF_WALK_STRUCTS(dd, algsurf_dd)

/* Cuts [lo,hi] of s (dd, may be infinite: hi components +-inf) into at most three pieces, left to right;
 * returns their number.  Ends beyond +-ALGSURF_CUT become far pieces. */
int algsurf_i_cut_line(algsurf_dd lo, algsurf_dd hi, algsurf_i_piece pieces[3]);

/* A caller's polynomial: leading exact zeros removed, `zeros` exact zeros at the low end. */
typedef struct algsurf_i_coefficients {
    const double *c, *r; /* r may be null */
    int degree, zeros;   /* zeros <= degree */
} algsurf_i_coefficients;

/* A stretch of the line, lo < hi, to be walked in units of 2^exponent. */
typedef struct algsurf_i_stretch {
    double lo, hi;
    int exponent;
} algsurf_i_stretch;

/* The largest exponent among the coefficients from `first` on (or their radii), in units of 2^unit. */
int algsurf_i_common_exponent(const algsurf_i_coefficients *p, int first, int unit);

#define ALGSURF_MOST_STRETCHES (2 * ALGSURF_MAX_POLY_DEGREE + 3)

/* The stretches of [lo,hi], lo < hi, from left to right; 0 parts two of them when p has zeros there. */
int algsurf_i_stretches(const algsurf_i_coefficients *p, double lo, double hi,
                        algsurf_i_stretch s[ALGSURF_MOST_STRETCHES]);

/* Brackets in increasing order, at most `capacity` >= 1.  Each holds the roots of its own cells alone, but
 * the last one when it is loose: then it reaches beyond its cell, and is certain once the next one is added.
 */
typedef struct algsurf_i_brackets {
    algsurf_bracket *b;
    int count, capacity, loose;
    double above; /* if loose: the root is greater than this */
} algsurf_i_brackets;

/* Certain sign of p at x (may be infinite): -1, +1, 0 for an exact zero, or ALGSURF_SIGN_UNKNOWN. */
int algsurf_i_sign_at(const algsurf_i_coefficients *p, double x);

/* Appends an exact root of multiplicity at most `most`, or a cell of a stretch as a bracket with double ends
 * of certain sign where that is possible.  An undecided one that touches an undecided one before it is
 * joined with it.  Returns 0, and appends nothing, when there was no room. */
int algsurf_i_add_exact(algsurf_i_brackets *found, const algsurf_i_coefficients *p, double x, int most);
int algsurf_i_add_cell(algsurf_i_brackets *found, const algsurf_i_coefficients *p, const algsurf_i_stretch *s,
                       const algsurf_i_cell *cell);

#endif
