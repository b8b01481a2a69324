/* line.h - the real roots of one polynomial in an interval of the line, and the rungs of the ladder:
 * formulas, powers, a walk in doubles, integers. */
#ifndef ALGSURF_LINE_H
#define ALGSURF_LINE_H
#include "algsurf/allroots.h"
#include "algsurf/isolate.h"
#include "../poly/integral.h"
#include "coefficients.h"
#include "watch.h"

enum { ALGSURF_I_ALL, ALGSURF_I_FIRST, ALGSURF_I_NUMBER };

/* What is asked: of p, exact and checked, the roots in [lo,hi], lo <= hi, ends infinite or not. */
typedef struct algsurf_i_line {
    algsurf_i_coefficients p;
    const algsurf_integer *z; /* not null: these are the coefficients, and p.c is null */
    double lo, hi;
    int wanted;                   /* all; the first; or how many, without places, on the whole line */
    int refined;                  /* 1: between neighbouring doubles; 0: isolated, multiple ones refined */
    const algsurf_i_watch *watch; /* null: nobody looks */
    int wide;                     /* 1: isolated, the wider the better */
    const algsurf_complex_root *boxes; /* all roots of p, from complex/boxes.h; null: they are not known */
} algsurf_i_line;

/* roots, in order, with room for as many as the degree says, at least one: lo = hi is a root, else there is
 * one in (lo,hi), the sign of p at lo being that before it; members are those of algsurf_real_root, .root
 * only where refined.  Returns OK or E_NO_MEMORY. */
algsurf_status algsurf_i_line_solve(const algsurf_i_line *line, algsurf_real_root *roots, int *count);

/* ---- low.c: polynomials of the lowest degrees, by formula ---- */

/* The real roots of p, of degree 1 or 2, exact, c[0] and c[degree] not 0, in order, isolated: each is in
 * (lo,hi), about 2^-29 of its size wide.  Returns how many, or -1: not known. */
int algsurf_i_low_roots(const algsurf_i_coefficients *p, algsurf_real_root *roots);

/* How many a p of degree 1 to 3 has, simple ones, or -1. */
int algsurf_i_low_number(const algsurf_i_coefficients *p);

/* ---- power.c: p(t) = q(t^k), the roots of p from those of q ---- */

typedef struct algsurf_i_power {
    int step, degree;                      /* k, above 1; of q */
    double q[ALGSURF_MAX_POLY_DEGREE + 1]; /* q[0] and q[degree] are not 0 */
} algsurf_i_power;

/* The largest k for p, of degree >= 1 with c[0] and c[degree] not 0; returns 0 where it is 1. */
int algsurf_i_power_of(const double *c, int degree, algsurf_i_power *w);

/* The interval of q's roots that holds those of p in [lo,hi]: at 0 or above for even k. */
void algsurf_i_power_interval(const algsurf_i_power *w, double lo, double hi, double *from, double *to);

/* q's roots there, isolated or refined, *count of them, become brackets of p's roots in [lo,hi]; these need
 * not be final where q's are.  Returns 0, with roots lost, where q's are too wide for that: beside a multiple
 * root, or beyond the range of doubles.  Room for p's degree. */
int algsurf_i_power_roots(const algsurf_i_power *w, const algsurf_i_coefficients *p, double lo, double hi,
                          algsurf_real_root *roots, int *count);

/* ---- walk.c: roots in an interval by doubles; and where none can be ---- */

/* Is no term of p much larger than c_0 for |t| <= size?  Then one piece will do. */
int algsurf_i_is_level(const algsurf_i_coefficients *p, double size);

/* Cut from [lo,hi] what is farther from 0, or nearer, than the sizes of the coefficients, which have no
 * radii, let roots be; c[0] and c[degree] are not 0.  Nothing is left where lo > hi.  p is not 0 at a new
 * end. */
void algsurf_i_cut_far(const algsurf_i_coefficients *p, double *lo, double *hi);
void algsurf_i_cut_near(const algsurf_i_coefficients *p, double *lo, double *hi);

/* A root of p, c[0] not 0, isolated or final: if its bracket holds 0, it keeps the side with the root,
 * without 0 itself unless that is an end that has no double between it and the other one.  Returns 0 where no
 * double is below the root. */
int algsurf_i_leave_zero(const algsurf_i_coefficients *p, algsurf_real_root *root);

/* A root, isolated or final: is it in [lo,hi]?  A bracket that an end lies inside is cut there: two
 * neighbours are not. */
int algsurf_i_is_inside(const algsurf_i_coefficients *p, double lo, double hi, algsurf_real_root *root);

/* Brackets of the roots of p in [lo,hi] in order, at most `most`, which may be as many as the degree says:
 * simple roots, ends of certain sign.  Returns 0 when something is left undecided, between the last bracket,
 * or lo, and hi.  level: of p and [lo,hi].  watch: null, or who is told. */
int algsurf_i_walk(const algsurf_i_coefficients *p, double lo, double hi, int level, int most,
                   algsurf_bracket *b, int *count, const algsurf_i_watch *watch);

/* ---- integers.c: integer coefficients in doubles ---- */

/* The integers as c with radii r, up to a power of two, and its degree without leading zeros; no r is set
 * where c is exact.  Returns 0 where exponents differ too much for doubles, or the degree is above
 * ALGSURF_MAX_DEGREE. */
int algsurf_i_integers_round(const algsurf_i_line *line, double *c, double *r, int *degree);

/* Simple roots in brackets b, near those of the rounded polynomial, become those of the integers; returns how
 * many do, from the first on. */
int algsurf_i_integers_close_in(const algsurf_i_line *line, const algsurf_bracket *b, int count,
                                algsurf_real_root *roots);

/* ---- decide.c: by integers ---- */

/* line->z without a common power of two; returns 0 without memory. */
int algsurf_i_take_integers(algsurf_memory *m, const algsurf_i_line *line, algsurf_zpoly *p);

/* The roots on a line in increasing order, whatever is wanted, the first `capacity` of them; the degree
 * always suffices.  lo = hi is a root; else there is one in (lo,hi), with the sign before it, and either
 * these are neighbours or, where not `refined`, the root is simple, alone there, and p is not 0 at the ends.
 * Returns OK or E_NO_MEMORY.  Stack: 20 KiB, and what the walk takes. */
algsurf_status algsurf_i_decide(const algsurf_i_line *line, algsurf_real_root *roots, int capacity,
                                int *count);

/* The roots in [lo,hi] of all polynomials within the radii, as brackets and undecided places, at most
 * `capacity` >= 1, in order (the last one covers what there is no room for).  watch: null, or who is told.
 * OK or E_NO_MEMORY. */
algsurf_status algsurf_i_decide_ranges(const algsurf_i_coefficients *p, double lo, double hi,
                                       algsurf_bracket *brackets, int capacity, int *count,
                                       const algsurf_i_watch *watch);

/* The sign at x, finite, that all polynomials within the radii have in common, or ALGSURF_SIGN_UNKNOWN: there
 * is none.  OK or E_NO_MEMORY. */
algsurf_status algsurf_i_decide_sign(const algsurf_i_coefficients *p, double x, int *sign);

#endif
