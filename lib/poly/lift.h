/* poly/lift.h - rational numbers with one denominator, from their images modulo primes. */
#ifndef ALGSURF_LIFT_H
#define ALGSURF_LIFT_H
#include "integral.h"
#include "residue.h"

typedef struct algsurf_image algsurf_image;

typedef struct algsurf_lift {
    algsurf_memory *memory;
    algsurf_memory_mark start;
    algsurf_image *last; /* the images so far, newest first; null: none */
    int count, primes;   /* numbers; images */
} algsurf_lift;

/* Nothing yet about `count` >= 1 numbers.  Images are kept in m, above everything taken so far. */
void algsurf_lift_begin(algsurf_lift *lift, algsurf_memory *m, int count);

/* Forgets all images. */
void algsurf_lift_forget(algsurf_lift *lift);

/* The product of the primes so far, modulo another one, in Montgomery's form; not 0. */
algsurf_limb algsurf_lift_modulus(const algsurf_lift *lift, const algsurf_prime *m);

/* Another image: x[k] is the k-th number modulo m, in ordinary form; inverse: of algsurf_lift_modulus. */
int algsurf_lift_add(algsurf_lift *lift, const algsurf_limb *x, algsurf_limb inverse, const algsurf_prime *m);

/* A guess, if the images suffice for one: integers c_k = D x_k with D > 0, which have no factor in common
 * with D, in `c` with count - 1 as degree.  It proves nothing.  Once the numbers are small enough for the
 * images it is right, but in one of 2^12 cases or so, where a residue is small by chance. */
int algsurf_lift_guess(algsurf_lift *lift, int *found, algsurf_zpoly *c);
#endif
