/* impl.h - the parts of the robust solver and what they share.
 *
 * Proposal and proof are different files: propose.c finds approximations, fast, and may be wrong; tighten.c
 * and retry.c improve them beyond double; prove.c alone decides what is certain.
 *
 * The problem is scaled by powers of two: roots, in units of 2^unit, have magnitudes around 1; so have
 * the coefficients' mantissas, c_k = (cr + i ci) 2^shift.  A narrow problem, nearly every one, has all
 * shifts 0 and is evaluated as it stands; a wide one is first brought into the unit of the root at
 * hand.  A root is x + iy, x and y each a sum high + low.
 */
#ifndef ALGSURF_ALLROOTS_IMPL_H
#define ALGSURF_ALLROOTS_IMPL_H
#include "algsurf/allroots.h"
#include "../base/eft.h"

/* A problem; its arrays are slices of one block of work memory. */
typedef struct algsurf_i_roots {
    int n;      /* degree >= 1; c[0] and c[n] are not 0 */
    int real;   /* all coefficients are real */
    int narrow; /* shifts are 0, and Horner's rule at every start radius stays within the range of double */
    int iterations, retries;
    double reach, unit_of_reach; /* largest start radius, its inverse; all roots lie within twice that
                                    (Fujiwara 1916) */
    /* degree+1 each: */
    double *cr, *ci;           /* coefficients */
    double *size, *radius;     /* |c_k|, rounded up; bound on its error */
    double *lr, *li, *ls, *le; /* the same in the unit of one root (algsurf_i_in_unit_of) */
    /* degree each: */
    double *x, *y, *xl, *yl; /* roots: high and low parts */
    double *residual;        /* |p| at the root is at most residual 2^exponent */
    double *disc;            /* radius of the root's inclusion disc */
    int *exponent, *group, *done;
    int *shift; /* degree+1 */
} algsurf_i_roots;

#define ALGSURF_ROOTS_DOUBLES 14
#define ALGSURF_ROOTS_INTS 4

/* A problem of degree at most ALGSURF_MAX_DEGREE with its memory, for the stack. */
typedef struct algsurf_i_roots_memory {
    algsurf_i_roots p;
    double doubles[ALGSURF_ROOTS_DOUBLES * (ALGSURF_MAX_DEGREE + 1)];
    int ints[ALGSURF_ROOTS_INTS * (ALGSURF_MAX_DEGREE + 1)];
    algsurf_complex_root boxes[ALGSURF_MAX_DEGREE + 1];
} algsurf_i_roots_memory;

/* The polynomial to be solved, without exact zeros at either end. */
typedef struct algsurf_i_input {
    const algsurf_complex *c;
    const double *r; /* or null */
    int low, high;   /* from c[low] to c[high] */
    int real_radii;  /* they stand for real numbers where the coefficients are real */
    int unit;        /* of the variable: z = 2^unit is 1 here */
} algsurf_i_input;

/* The exponent of a unit of the variable in which the roots are near 1, as far as that is possible. */
int algsurf_i_roots_unit(const algsurf_i_input *in);
/* All roots by value, clusters among them.  boxes: work space for as many as `roots`. */
algsurf_status algsurf_i_roots_solve(algsurf_i_roots *p, const algsurf_i_input *in,
                                     const algsurf_complex *start, algsurf_complex_root *boxes,
                                     algsurf_complex_root *roots, int *count);
/* The answer of algsurf_i_roots_solve with the multiple roots in boxes of their own, if the polynomial is
 * real and exact, and has some; else unchanged.  May allocate. */
void algsurf_i_roots_separate(algsurf_i_roots *p, const algsurf_i_input *in, algsurf_complex_root *boxes,
                              algsurf_complex_root *roots, int *count);
void algsurf_i_roots_sort(algsurf_complex_root *roots, int count);

/* algsurf_complex_solver_run for degree at most ALGSURF_MAX_DEGREE, in the standard environment, without
 * memory from elsewhere: multiple roots stay clusters.  memory->p.iterations tells what it took.  real_radii:
 * those of real coefficients mean real numbers. */
algsurf_status algsurf_i_roots_run(algsurf_i_roots_memory *memory, const algsurf_complex *c, const double *r,
                                   int degree, int real_radii, const algsurf_complex *start,
                                   algsurf_complex_root *roots, int *count);

/* algsurf_complex_roots in the standard environment, without lanes: on the stack, from degree
 * ALGSURF_MAX_DEGREE + 1 up on the heap; multiple roots are parted. */
algsurf_status algsurf_i_roots_alone(const algsurf_complex *c, const double *r, int degree, int real_radii,
                                     algsurf_complex_root *roots, int *count);

/* Coefficients in units of 2^unit of the variable, divided by 2^exponent. */
typedef struct algsurf_i_local {
    const double *cr, *ci, *size, *radius;
    int unit, exponent;
} algsurf_i_local;

/* Coefficients that are safe to use near z = x + iy. */
algsurf_i_local algsurf_i_in_unit_of(algsurf_i_roots *p, double x, double y);

/* Start values on circles whose radii are slopes of Newton's polygon.  Sets narrow. */
void algsurf_i_roots_start(algsurf_i_roots *p);
/* Ehrlich-Aberth iteration in double from the values in x, y. */
void algsurf_i_roots_propose(algsurf_i_roots *p);
/* One Newton step with a residual in doubled precision for each root whose residual is HUGE_VAL, that is
 * unknown, and whose low parts are 0; sets low parts and residual, or nothing where the root is too
 * undecided for that. */
void algsurf_i_roots_tighten(algsurf_i_roots *p);
/* One Newton step of root i in double-double; sets its residual. */
void algsurf_i_roots_sharpen(algsurf_i_roots *p, int i);
/* Ehrlich-Aberth iteration in double-double of the roots whose done[i] is 0; sets residuals. */
void algsurf_i_roots_retry(algsurf_i_roots *p);
/* Inclusion discs of all roots, from their residuals; groups of discs that touch.  Returns the number
 * of roots whose group holds others. */
int algsurf_i_roots_group(algsurf_i_roots *p);
/* Boxes of the groups, disjoint, conjugate ones exactly so; returns their number.  Scaled units. */
int algsurf_i_roots_boxes(algsurf_i_roots *p, algsurf_complex_root *boxes);
/* Joins boxes that meet; for a real polynomial also those that meet one box's mirror image.  Returns the
 * number left. */
int algsurf_i_roots_join(algsurf_complex_root *e, int count, int real);

#endif
