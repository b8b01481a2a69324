/* impl.h - how a surface is stored, for the rooms that evaluate and expand it.
 *
 * Lengths are measured in the surface's natural unit 2^unit, in which the terms of highest degree
 * and the others balance, and P is multiplied by 2^scale, so that the largest coefficient lies in
 * [1/2, 1).  Both are powers of two: coef = a 2^(unit (i+j+k) + scale) is exact, and so is every
 * value, unless it leaves the range of double.  `inexact` tells that a coefficient did (it then is
 * off by at most 2^-1074, far below any bound's absolute part).
 *
 * A surface with an `error` stands for all polynomials whose coefficients are off by up to that part of their
 * magnitude.  Bounds then grow by error times the scheme on magnitudes, and exact arithmetic on the
 * coefficients decides nothing.
 *
 * Horner's scheme nests x in y in z.  For each power k of z a level, for each power j of y in it a
 * row: the dense coefficients of x^0 .. x^(length-1), length 0 when the row is empty.
 */
#ifndef ALGSURF_SURFACE_IMPL_H
#define ALGSURF_SURFACE_IMPL_H
#include "algsurf/surface.h"

typedef struct algsurf_row {
    size_t first; /* index into coef */
    int length;   /* degree in x plus one; 0: no terms */
} algsurf_row;

typedef struct algsurf_level {
    size_t first; /* index into rows of power y^0 */
    int count;    /* degree in y plus one; 0: no terms */
} algsurf_level;

struct algsurf_surface {
    int degree; /* total */
    int unit, scale;
    int inexact;
    double smallest; /* least magnitude of the non-zero coef */
    double size;     /* sum of the magnitudes of coef */
    double error;    /* relative, of each coef; a little more, for the rounding of bounds */
    double rounding; /* relative, with which the coefficients stand for an equation's */
    size_t term_count;
    algsurf_term *terms; /* the caller's coefficients, merged, sorted by decreasing k, j, i */
    int level_count;     /* degree in z plus one */
    algsurf_level *levels;
    algsurf_row *rows;
    double *coef;
    int stride[3]; /* 2 for a coordinate of which P has only even powers, else 1 */
    /* For packets of rays, null for degree 0.  Polynomials along a ray have Bernstein coefficients of degree
     * node_degree over [-1,1].  Row j of from_powers makes coefficient j of the coefficients of v^k, with
     * entries off by 3 u.  Up to ALGSURF_MAX_NODE_DEGREE there are node_degree + 1 nodes, too, and
     * to_bernstein does it with the values there: coefficient j of the value at node i stands at
     * i ALGSURF_NODE_STRIDE + j, off by (3 node_degree + 4) u; what is behind the last node and coefficient
     * is 0. */
    int node_degree; /* at least degree */
    double *tables, *from_powers, *nodes, *to_bernstein;
    double amplification; /* the largest sum of |entries| of to_bernstein for one coefficient */
    double most_reach;    /* of a chord in natural units: its reach^node_degree is at most 2^280 */
    /* For rays without ends.  Along a line through the origin the roots that are not far out have real parts
     * up to about this, in natural units: where to look first, no bound. */
    double spread;
    int goes_far; /* 1: P's highest terms are not of one sign, as far as was looked: roots are far out, too */
    /* P = c Q^power, or root is null.  Rays ask Q; they and their answers are as for P. */
    algsurf_surface *root;      /* Q: owned */
    int power, power_sign;      /* >= 2; the sign of c, which is 1 where the power is odd */
    unsigned char degree_in[8]; /* P's degree in those coordinates whose bits, 1, 2, 4, are set */
};

/* Rounding of values at nodes counts amplification times, which doubles with each degree, that of powers
 * once; and from degree 13 on powers are faster, too. */
#define ALGSURF_MAX_NODE_DEGREE 12
#define ALGSURF_NODE_STRIDE 16

/* A surface from checked terms, in the standard environment. */
algsurf_status algsurf_i_surface_make(const algsurf_term *terms, size_t count, double error, double rounding,
                                      algsurf_surface **surface);

/* Sets what packets of rays need; 0 when there is no memory. */
int algsurf_i_surface_set_tables(algsurf_surface *s);

/* Sets the root, if there is one; OK or E_NO_MEMORY. */
algsurf_status algsurf_i_surface_find_power(algsurf_surface *s);

/* The surface that rays ask: it has the same points, and its polynomial fewer multiple roots. */
static inline const algsurf_surface *algsurf_i_surface_solved(const algsurf_surface *s) {
    return s->root ? s->root : s;
}

/* The sign of P in front of every hit, where Q^k has the same sign everywhere; else 0. */
static inline int algsurf_i_surface_front(const algsurf_surface *s) {
    return s->root && s->power % 2 == 0 ? s->power_sign : 0;
}

/* P and its gradient at a point in natural units, in natural scale (value 2^scale P, derivatives by
 * natural coordinates), in double, no bounds. */
double algsurf_i_surface_value(const algsurf_surface *s, const double x[3], double gradient[3]);

/* The sum of the sizes of P's terms, in natural scale, at a point in natural units: too small by 2 n + 3
 * roundings at most; what is 0 or underflows counts as 2^-960 or more. */
double algsurf_i_surface_magnitude(const algsurf_surface *s, const double x[3]);

/* The same gradient, of the coefficients as they are, at a point in the caller's units; 0 where it may be
 * that rounding leaves less than 20 bits of it: then its direction is off by less than 10^-4 degrees. */
#define ALGSURF_I_CLEAR 0x1p20
int algsurf_i_surface_clear_gradient(const algsurf_surface *s, const double point[3], double gradient[3]);

/* The gradient at a complex point, same units. */
typedef struct algsurf_i_complex {
    double re, im;
} algsurf_i_complex;
void algsurf_i_surface_gradient_complex(const algsurf_surface *s, const algsurf_i_complex x[3],
                                        algsurf_i_complex gradient[3]);

#endif
