/* surface/exact_eye.h - P along many rays from one point, with integer coefficients.
 *
 * P(eye + w) is made once; a ray's form is then its homogeneous parts at the direction. */
#ifndef ALGSURF_EXACT_EYE_H
#define ALGSURF_EXACT_EYE_H
#include "exact_form.h"

typedef struct algsurf_i_exact_eye {
    int degree, least;                /* P(eye + w) in units of 2^least */
    int unit[3];                      /* of w's coordinates, powers of two */
    size_t count;                     /* coefficients that are not 0 */
    int bits[ALGSURF_MAX_DEGREE + 1]; /* the most of a coefficient of that total degree; 0: there is none */
    /* Of each of them, by decreasing exponents of w_2, w_1, w_0: a word that tells exponents, sign and bits,
     * and the limbs of its magnitude. */
    const algsurf_limb *stream;
} algsurf_i_exact_eye;

/* Lives as long as what it takes from the memory; is only read by what follows, so that threads share it.
 * Returns 0 when there is no memory. */
int algsurf_i_exact_eye_make(algsurf_memory *m, const algsurf_surface *s, const double eye[3],
                             algsurf_i_exact_eye *y);

/* algsurf_i_exact_form of the ray from the eye: the same p and scale, bit by bit. */
int algsurf_i_exact_eye_form(algsurf_memory *m, const algsurf_i_exact_eye *y, const double direction[3],
                             int e, algsurf_zpoly *p, int *scale);
#endif
