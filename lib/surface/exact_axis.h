/* surface/exact_axis.h - one coordinate of a ray as a linear form with integer coefficients, and products by
 * it.
 *
 * Along a ray with the parameter 2^e u the coordinate is o + d 2^e u = 2^unit (f0 + f1 u), f0 and f1
 * integers. Each coordinate has a unit of its own, the largest possible, so that f0 and f1 nearly always fit
 * one limb. Where they do not, each is still two limbs at some place among zeros, for it comes from one
 * double. */
#ifndef ALGSURF_EXACT_AXIS_H
#define ALGSURF_EXACT_AXIS_H
#include <stddef.h>

#include "../base/integer.h"

/* (low + 2^64 high) 2^(64 at), negated when `sign` is all ones; sign is 0 otherwise. */
typedef struct algsurf_i_exact_factor {
    algsurf_limb low, high, sign;
    int at;
} algsurf_i_exact_factor;

typedef struct algsurf_i_exact_axis {
    int unit;
    int bits;     /* |f[0]| + |f[1]| < 2^bits */
    int one_limb; /* bits <= 64, hence f[i].high and f[i].at are 0 */
    algsurf_i_exact_factor f[2];
} algsurf_i_exact_axis;

/* Where the bits of a double lie: x is an odd multiple of 2^low, and |x| < 2^top; 0: low = top = 0. */
typedef struct algsurf_i_exact_span {
    int low, top;
} algsurf_i_exact_span;
static inline algsurf_i_exact_span algsurf_i_exact_span_of(double x) {
    int e;
    algsurf_limb odd = algsurf_z_odd_part(x, &e);
    return (algsurf_i_exact_span){e, e + algsurf_limb_bits(odd)};
}

void algsurf_i_exact_axis_make(algsurf_i_exact_axis *x, double origin, double direction, int e);

/* A polynomial in the making: a sum of `count` polynomials with coefficients below 2^bits in magnitude.  The
 * width follows from these two, never from the values: intermediate signs need no attention. */
typedef struct algsurf_i_exact_sum {
    int degree; /* -1: zero, the other members except stride and c mean nothing */
    int bits, count, width;
    size_t stride;   /* limbs from one coefficient to the next, at least every width to come */
    algsurf_limb *c; /* room for every degree to come */
} algsurf_i_exact_sum;

/* Limbs for a sum of `count` integers below 2^bits in magnitude. */
int algsurf_i_exact_sum_width(int bits, int count);

/* Makes p ready for `count` more summands of at most that degree, below 2^bits: only its values stay. */
void algsurf_i_exact_sum_expect(algsurf_i_exact_sum *p, int degree, int bits, int count);

/* p += x 2^shift, an integer. */
void algsurf_i_exact_sum_add_double(algsurf_i_exact_sum *p, double x, int shift);
/* p += q; q is used up (p may receive its room). */
void algsurf_i_exact_sum_add(algsurf_i_exact_sum *p, algsurf_i_exact_sum *q);
/* p becomes p times f[0] + f[1] u; spare: `stride` limbs. */
void algsurf_i_exact_sum_times(algsurf_i_exact_sum *p, const algsurf_i_exact_axis *x, algsurf_limb *spare);
#endif
