/* exact_arg.h - the argument of a complex number by a series, in the precision of GMP's default; call
 * mpf_set_default_prec first. */
#ifndef EXACT_ARG_H
#define EXACT_ARG_H
#include "exact.h"

/* y = atan(t), 0 <= t <= 1: three halvings atan t = 2 atan(t / (1 + sqrt(1 + t^2))), then the series. */
static inline void exact_arctangent(mpf_t y, const mpf_t t) {
    mpf_t x, z, term;
    mpf_inits(x, z, term, NULL);
    mpf_set(x, t);
    for (int i = 0; i < 3; i++) {
        mpf_mul(z, x, x), mpf_add_ui(z, z, 1), mpf_sqrt(z, z), mpf_add_ui(z, z, 1);
        mpf_div(x, x, z);
    }
    mpf_mul(z, x, x), mpf_neg(z, z), mpf_set_ui(y, 0);
    for (unsigned k = 1; k < 140; k += 2) { /* (1/8)^140 < 2^-384 */
        mpf_div_ui(term, x, k), mpf_add(y, y, term);
        mpf_mul(x, x, z);
    }
    mpf_mul_2exp(y, y, 3);
    mpf_clears(x, z, term, NULL);
}

/* pi = 4 atan 1 */
static inline void exact_add_pi(mpf_t y, int times) {
    mpf_t one, pi;
    mpf_inits(one, pi, NULL);
    mpf_set_ui(one, 1), exact_arctangent(pi, one), mpf_mul_2exp(pi, pi, 2);
    while (times-- > 0) mpf_add(y, y, pi);
    mpf_clears(one, pi, NULL);
}

/* The argument in (-pi,pi], in (0,2 pi) if around. */
static inline void exact_argument(mpf_t y, double re, double im, int around) {
    mpf_t n, d, half;
    mpf_inits(n, d, half, NULL);
    int steep = fabs(im) > fabs(re);
    mpf_set_d(n, fabs(steep ? re : im)), mpf_set_d(d, fabs(steep ? im : re)), mpf_div(n, n, d);
    exact_arctangent(y, n);
    if (steep) mpf_set_ui(half, 0), exact_add_pi(half, 1), mpf_div_2exp(half, half, 1), mpf_sub(y, half, y);
    if (re < 0) mpf_neg(y, y), exact_add_pi(y, 1);
    if (im < 0) mpf_neg(y, y), exact_add_pi(y, around ? 2 : 0);
    mpf_clears(n, d, half, NULL);
}

#endif
