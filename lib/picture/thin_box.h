/* thin_box.h - P over a box of rays, and over its parts: has it a zero there, and which way does it grow? */
#ifndef ALGSURF_PICTURE_THIN_BOX_H
#define ALGSURF_PICTURE_THIN_BOX_H
#include "thin.h"

enum {
    ALGSURF_I_BOX_TERMS = (ALGSURF_MAX_BEAM_DEGREE + 1) * (ALGSURF_MAX_BEAM_DEGREE + 2) / 2,
    ALGSURF_I_COLUMN_TERMS = 8
};

/* P over the rays |xi|, |eta| <= 1 of a box between two depths: Bernstein coefficients of each term. */
typedef struct algsurf_i_solid {
    int degree;
    double t[ALGSURF_MAX_BEAM_DEGREE + 1][ALGSURF_I_BOX_TERMS]; /* for each power of eta, those of xi */
    double fourth, rounding; /* for bounds, of each coefficient, on a column's terms of the fourth order and
                                more, and on the errors */
    double from, to;         /* the depths */
} algsurf_i_solid;

/* The same over a column of it: 1, xi, eta, xi^2, xi eta, eta^2, and a radius; the last term is nothing. */
typedef struct algsurf_i_column {
    double t[ALGSURF_MAX_BEAM_DEGREE + 1][ALGSURF_I_COLUMN_TERMS];
    double half; /* of its side, in that of the box */
} algsurf_i_column;

/* What P is in a part of a column, each a bit: it has a sign; or it surely grows in a direction, one of
 * DIRECTIONS across the view, from xi towards eta all around, or along it. */
#define ALGSURF_I_DIRECTIONS 16
#define ALGSURF_I_ACROSS ((1u << ALGSURF_I_DIRECTIONS) - 1)
#define ALGSURF_I_ALONG (3u << ALGSURF_I_DIRECTIONS)
#define ALGSURF_I_POSITIVE (4u << ALGSURF_I_DIRECTIONS)
#define ALGSURF_I_NEGATIVE (8u << ALGSURF_I_DIRECTIONS)

/* Over -1 <= z <= 1. */
void algsurf_i_solid_expand(const algsurf_i_thin_box *box, algsurf_i_solid *s);

/* P on the middle ray, at a place of the depths. */
double algsurf_i_solid_middle(const algsurf_i_solid *s, double place);

/* To the part [from,to] of its depths as [0,1]. */
void algsurf_i_solid_narrow(algsurf_i_solid *s, double from, double to);

/* The column |xi - x|, |eta - y| <= half. */
void algsurf_i_solid_column(const algsurf_i_solid *s, double x, double y, double half, algsurf_i_column *c);

/* The part [from,to] of a column's depths; returns the sign of P there, 0 if it is not known. */
unsigned algsurf_i_column_cut(const algsurf_i_solid *s, const algsurf_i_column *c, double from, double to,
                              algsurf_i_column *part);

/* The sign of P in a part, by its squares: known of more parts than by the above, and takes longer. */
unsigned algsurf_i_column_square_sign(const algsurf_i_solid *s, const algsurf_i_column *part);

/* The directions in which P grows in a part of that share of the depths. */
unsigned algsurf_i_column_growth(const algsurf_i_solid *s, const algsurf_i_column *part, double share);

#endif
