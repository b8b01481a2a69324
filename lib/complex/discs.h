/* discs.h - the second engine: all complex roots of a polynomial of integers, as far apart as they are.
 *
 * Values are integers cut to as many limbs as they need (taylor.c), points are integers (point.c), everything
 * else is doubles with exponents (scaled.h).  propose.c begins, discs.c proves, part.c brings roots apart,
 * answer.c rounds. */
#ifndef ALGSURF_COMPLEX_DISCS_H
#define ALGSURF_COMPLEX_DISCS_H
#include "boxes.h"
#include "impl.h"
#include "scaled.h"

/* sum (re_k + i im_k) z^k with integers, the leading coefficient not 0, and what doubles say of them. */
typedef struct algsurf_i_integers {
    algsurf_zpoly re, im;        /* of one degree and width; im.c null: real */
    int real;                    /* coefficients are real, and so is what the radii mean */
    int *bits;                   /* degree+1, as all that follows: |re_k|, |im_k| <= 2^bits; -1: both are 0 */
    algsurf_scaled *head, *size; /* size: with the radius */
    const algsurf_scaled *radius; /* coefficients are off by that much; null: exact */
    unsigned char *exact;         /* coefficient k is its head */
    algsurf_i_flat flat;          /* once propose.c has made it, if they fit doubles */
} algsurf_i_integers;

/* (x + iy) 2^exponent, in w limbs each. */
typedef struct algsurf_i_point {
    algsurf_limb *x, *y;
    int w, room; /* limbs in use, and at x and y */
    int64_t exponent;
    algsurf_scaled head;   /* off by 2^-52 of its larger part in each part */
    algsurf_scaled above;  /* |y|, off by 2^-52 of itself */
    int exact;             /* it is the head */
    double flat[2], reach; /* the head as doubles, its larger part; NaN: beyond 2^+-250 */
} algsurf_i_point;

/* A root, and what is known of it.  Its group's discs hold as many roots as the group has members; one that
 * is alone lies within blur + error of z - step. */
typedef struct algsurf_i_disc {
    algsurf_i_point z;
    algsurf_scaled value, lost; /* p(z), and a size by which it may be off */
    algsurf_scaled step, error; /* W = p(z) / (c_n prod (z - z_j)), and a size by which it may be off */
    algsurf_scaled disc;        /* n |W|, rounded up; ALGSURF_I_ENDLESS: none */
    algsurf_scaled blur;        /* of z - step, by the other discs; endless: not known */
    algsurf_scaled nearest;     /* no other point is closer; n = 1: endless */
    algsurf_scaled next;        /* work space */
    int width;                  /* limbs of values */
    int group, members;    /* the group's first root; how many there are in the group that starts here, */
    int age, before;       /* for how many sweeps, and before them */
    unsigned char known;   /* value is p(z) */
    unsigned char stuck;   /* it is 0 within four times the radii */
    unsigned char placed;  /* where its disc is about as small as radii allow */
    unsigned char done;    /* needs no step */
    unsigned char snapped; /* has been at the double it is next to */
    unsigned char pressed; /* its box meets another one: both are to be narrow in each part */
    int mate;              /* the root at the conjugate point, of a real polynomial; -1: none */
    int multiplicity[2];   /* of the root, and of its conjugate, in what is asked for; 0: no root of that */
} algsurf_i_disc;

#define ALGSURF_I_RANGE_OF_DOUBLES 2200 /* bits: from 2^1024 down to 2^-1075, and some more */

#define ALGSURF_I_ENDLESS ((algsurf_scaled){1, 0, (int64_t)1 << 46}) /* a size above all others */

/* Where roots go to. */
typedef struct algsurf_i_answer {
    int64_t unit;                   /* roots are times 2^unit */
    int count;                      /* of boxes, which may meet */
    algsurf_complex_root *roots;    /* room for the degree; of complex ones for three times that: conjugates
                                       are among them at first */
    algsurf_precise_roots *precise; /* not null: the roots go there, in place of boxes */
    int factors, pressed; /* how many polynomials they are of; 1: all are to be narrow in each part */
    int proposed, moved;            /* steps it took */
} algsurf_i_answer;

/* Functions that return int give 0 when there is no memory. */

/* ---- taylor.c ---- */

/* 64 bits of a from bit `from` on, which may be negative. */
algsurf_limb algsurf_i_limb_at(const algsurf_limb *a, int w, int64_t from);
/* r += floor(a 2^shift), for w limbs. */
void algsurf_i_add_shifted(algsurf_limb *r, int w, const algsurf_limb *a, int wa, int64_t shift);
/* r += x 2^shift, |x| < 4, rounded down. */
void algsurf_i_add_double(algsurf_limb *r, int w, double x, int64_t shift);
/* Of the larger part; y null, here and below: 0. */
int algsurf_i_bits(const algsurf_limb *x, const algsurf_limb *y, int w);
/* The head of (x + iy) 2^exponent. */
algsurf_scaled algsurf_i_head(const algsurf_limb *x, const algsurf_limb *y, int w, int64_t exponent);
/* It is exactly that. */
int algsurf_i_head_is_exact(const algsurf_limb *x, const algsurf_limb *y, int w);
/* (re + i im) 2^exponent in w limbs each. */
typedef struct algsurf_i_sum {
    algsurf_limb *re, *im;
    int w, bits; /* |re|, |im| <= 2^bits; -1: both are 0 */
    int64_t exponent;
} algsurf_i_sum;
static inline algsurf_scaled algsurf_i_sum_head(const algsurf_i_sum *a) {
    return algsurf_i_head(a->re, a->im, a->w, a->exponent);
}
/* The coefficients of p(z + y) up to that of y^last are at[0] to at[last], by Horner's rule on integers of
 * w >= 2 limbs or few more, radii not counted.  They stay until the next call. */
typedef struct algsurf_i_sums {
    algsurf_memory *m;
    algsurf_i_sum *at;
    algsurf_scaled lost; /* at[0] is off by that at most: 0 where nothing was cut */
    algsurf_limb *room, *rest;
    size_t limbs, rest_limbs;
    int last; /* -1: no room yet */
} algsurf_i_sums;
/* Limbs for which nothing of p(z) is cut. */
int algsurf_i_whole_width(const algsurf_i_integers *p, const algsurf_i_point *z);
int algsurf_i_taylor(algsurf_i_sums *s, const algsurf_i_integers *p, const algsurf_i_point *z, int last,
                     int w);

typedef struct algsurf_i_discs {
    const algsurf_i_integers *p;
    algsurf_memory *m;
    int n, moved; /* degree; steps so far */
    int settled;  /* doubles have brought all points to rest, apart from each other */
    int64_t more; /* bits of a root that are asked for beyond those of a double */
    algsurf_i_disc *root;
    algsurf_i_sums sums; /* of the last value */
} algsurf_i_discs;

/* ---- point.c ---- */

extern const algsurf_i_point algsurf_i_origin;

/* z = from + way, rounded down to multiples of 2^low; y = 0 if on_axis.  z may be `from`. */
int algsurf_i_set_point(algsurf_memory *m, algsurf_i_point *z, const algsurf_i_point *from,
                        algsurf_scaled way, int64_t low, int on_axis);
/* z = the conjugate of `from`. */
int algsurf_i_set_conjugate(algsurf_memory *m, algsurf_i_point *z, const algsurf_i_point *from);
/* b is exactly the conjugate of a. */
int algsurf_i_is_conjugate(const algsurf_i_point *a, const algsurf_i_point *b);
/* a - b as below, from the points' integers. */
int algsurf_i_exact_difference(algsurf_memory *m, const algsurf_i_point *a, const algsurf_i_point *b,
                               algsurf_scaled *result);
/* a - b, off by 2^-25 of itself; 0 only where they are equal.  Not normalised, but within 2^+-300.
 * Heads tell it where it is at least 2^-25 of the larger one: each part is then off by at most
 * 2 * 2^-52 * 2^25 and a rounding. */
static inline int algsurf_i_gap(algsurf_memory *m, const algsurf_i_point *a, const algsurf_i_point *b,
                                algsurf_scaled *result) {
    double x = a->flat[0] - b->flat[0], y = a->flat[1] - b->flat[1];
    double size = fabs(x) > fabs(y) ? fabs(x) : fabs(y);
    *result = (algsurf_scaled){x, y, 0};
    return (size >= 0x1p-25 * a->reach && size >= 0x1p-25 * b->reach && size > 0) ||
           algsurf_i_exact_difference(m, a, b, result);
}
/* The same, normalised. */
static inline int algsurf_i_difference(algsurf_memory *m, const algsurf_i_point *a, const algsurf_i_point *b,
                                       algsurf_scaled *result) {
    if (!algsurf_i_gap(m, a, b, result)) return 0;
    *result = normal(*result);
    return 1;
}

/* Of two points of d. */
static inline int difference(const algsurf_i_discs *d, int i, int j, algsurf_scaled *result) {
    return algsurf_i_difference(d->m, &d->root[i].z, &d->root[j].z, result);
}
static inline int is_alone(const algsurf_i_discs *d, int i) { return d->root[d->root[i].group].members == 1; }

/* z = z - at[j] / (factor at[j + 1]), cut below 2^low; y = 0 if on_axis. */
int algsurf_i_subtract_quotient(algsurf_i_sums *s, algsurf_i_point *z, int j, int factor, int64_t low,
                                int on_axis);

/* ---- propose.c ---- */

/* A unit vector, another one for each i. */
void algsurf_i_aside(int i, double way[2]);

/* Start values for the n roots of sum c_k z^k, |c_k| <= size_k; *fit: doubles suffice to go on from them. */
int algsurf_i_start(algsurf_memory *memory, const algsurf_scaled *size, int n, algsurf_scaled *z, int *fit);

/* Approximations of all roots, some of them perhaps bad, from start values `given` where that is not null and
 * they are not 0; sizes are not 0 for k = 0 and n.  Where radii are known, less is not asked.  Sets flat.
 * Adds to *corrections how many there were of a root; null: there is none, the start values are the answer.
 * *settled: each came to rest, apart from the others. */
int algsurf_i_propose(algsurf_memory *m, algsurf_i_integers *p, const algsurf_scaled *given,
                      algsurf_scaled *z, int *corrections, int *settled);

/* ---- discs.c, part.c ---- */

/* Approximations of all roots, of degree 1 at least, as algsurf_i_propose has them; no discs yet. */
int algsurf_i_discs_begin(algsurf_i_discs *d, algsurf_memory *m, algsurf_i_integers *p,
                          const algsurf_scaled *given, int *corrections);
/* p at the points that have moved, and all discs and groups. */
int algsurf_i_discs_prove(algsurf_i_discs *d);
/* d's sums at z in w limbs or as many as it takes: the first one is `clear` times its error, or lost in the
 * radii, that is, in spread[0].  *spread: bounds of what radii make of the sums. */
int algsurf_i_clear_taylor(algsurf_i_discs *d, const algsurf_i_point *z, int last, double clear, int *w,
                           algsurf_scaled *spread);
/* Sweeps until all roots are alone and narrow, or as small as radii allow, or `most` times; *open: how many
 * are not.  The discs are those of the points where it stops. */
int algsurf_i_discs_run(algsurf_i_discs *d, int most, int *open);

/* ---- squares.c ---- */

/* p is a polynomial of z^2. */
int algsurf_i_is_in_squares(const algsurf_i_integers *p);
/* Begins and runs discs for p, which is squarefree. */
int algsurf_i_discs_separate(algsurf_i_discs *d, algsurf_memory *m, algsurf_i_integers *p, int most,
                             int *open, int *corrections);

/* ---- factors.c ---- */

/* u + iv, or u where v is null, in one degree and width; real where v is null. */
int algsurf_i_make_integers(algsurf_memory *m, const algsurf_zpoly *u, const algsurf_zpoly *v,
                            algsurf_i_integers *z);

/* All roots of an exact polynomial, each with its multiplicity, if there are multiple ones, or a complex one
 * has real roots, or a root and its conjugate; else the answer's count stays 0. */
int algsurf_i_solve_factors(algsurf_memory *m, const algsurf_i_integers *p, algsurf_i_answer *answer);

/* ---- on_axis.c ---- */

/* Root i, which is alone, is real: 1, 0; -1: not known. */
int algsurf_i_is_real(algsurf_i_discs *d, int i, int *answer);

/* ---- answer.c ---- */

/* Root i, which is alone, is within R of x in each part; R is 0 where it is exactly x. */
int algsurf_i_centre(algsurf_i_discs *d, int i, int on_axis, algsurf_i_point *x, algsurf_scaled *R);
/* The roots of d are added to the answer. */
int algsurf_i_deliver(algsurf_i_discs *d, algsurf_i_answer *answer);
/* The real and the imaginary part of the number of 53 bits in each that is inside of the box of root i, which
 * is alone: 0, where that is inside, or the only one; 0: there is none, or one part is 2^1000 times the
 * other. */
int algsurf_i_double_inside(const algsurf_i_discs *d, int i, algsurf_scaled z[2]);
/* Joins boxes that meet; `real`: also those that meet one box's mirror image.  Returns the number left, in
 * order. */
int algsurf_i_join_boxes(algsurf_complex_root *roots, int count, int real);

/* ---- precise.c ---- */

/* As algsurf_i_deliver, to as many bits as are wanted. */
int algsurf_i_deliver_precisely(algsurf_i_discs *d, algsurf_i_answer *answer);

#endif
