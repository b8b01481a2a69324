/* scaled.h - complex numbers in double precision, each with an exponent of its own.
 *
 * A number is (re + i im) 2^exponent; the larger part is in [1, 2), so that no product over- or underflows. A
 * product is off by sqrt(5) u of itself (Brent, Percival, Zimmermann 2007), a quotient by 8 u.  A size is
 * such a number with re >= 0 and im = 0. */
#ifndef ALGSURF_COMPLEX_SCALED_H
#define ALGSURF_COMPLEX_SCALED_H
#include <stdint.h>
#include <string.h>

#include "algsurf/interval.h"
#include "../base/eft.h"

static inline algsurf_complex plus(algsurf_complex a, algsurf_complex b) {
    return (algsurf_complex){a.re + b.re, a.im + b.im};
}

static inline algsurf_complex product(algsurf_complex a, algsurf_complex b) {
    return (algsurf_complex){a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}

typedef struct algsurf_scaled {
    double re, im;
    int64_t exponent; /* of 0: ALGSURF_SCALED_NONE */
} algsurf_scaled;

#define ALGSURF_SCALED_NONE                                                                                  \
    (-((int64_t)1 << 48)) /* below all others: no sum or difference of exponents leaves 64 bits */

/* 2^k for |k| <= 1022. */
static inline double power_of_two(int64_t k) {
    uint64_t image = (uint64_t)(k + 1023) << 52;
    double x;
    memcpy(&x, &image, sizeof x);
    return x;
}

static inline algsurf_scaled scaled_none(void) { return (algsurf_scaled){0, 0, ALGSURF_SCALED_NONE}; }

/* x, y: 0 or normal, with magnitudes between 2^-1000 and 2^1000. */
static inline algsurf_scaled scaled_of(double x, double y, int64_t exponent) {
    double size = x < 0 ? -x : x, other = y < 0 ? -y : y;
    uint64_t image;
    if (other > size) size = other;
    if (size == 0) return scaled_none();
    memcpy(&image, &size, sizeof image);
    int64_t k = (int64_t)(image >> 52) - 1023;
    double unit = power_of_two(-k);
    return (algsurf_scaled){x * unit, y * unit, exponent + k};
}

static inline algsurf_scaled normal(algsurf_scaled a) { return scaled_of(a.re, a.im, a.exponent); }

static inline int is_zero(algsurf_scaled a) { return a.re == 0 && a.im == 0; }

static inline algsurf_scaled times(algsurf_scaled a, algsurf_scaled b) {
    return scaled_of(a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re, a.exponent + b.exponent);
}

/* a = a (x + iy) 2^exponent, not normalised: parts of a stay below 2^300, x and y are below 2^300, the larger
 * one above 2^-300. */
static inline void scaled_multiply(algsurf_scaled *a, double x, double y, int64_t exponent) {
    double re = a->re * x - a->im * y, im = a->re * y + a->im * x, size = fabs(re) + fabs(im);
    a->re = re, a->im = im, a->exponent += exponent;
    if (!(size > 0x1p-300 && size < 0x1p300)) *a = scaled_of(re, im, a->exponent);
}

/* A factor within 2^+-900. */
static inline algsurf_scaled by(algsurf_scaled a, double factor) {
    return scaled_of(a.re * factor, a.im * factor, a.exponent);
}

/* b is not 0. */
static inline algsurf_scaled over(algsurf_scaled a, algsurf_scaled b) {
    double square = b.re * b.re + b.im * b.im;
    return scaled_of((a.re * b.re + a.im * b.im) / square, (a.im * b.re - a.re * b.im) / square,
                     a.exponent - b.exponent);
}

static inline algsurf_scaled negative(algsurf_scaled a) { return (algsurf_scaled){-a.re, -a.im, a.exponent}; }

/* a + b, rounded: off by u of the larger one in each part. */
static inline algsurf_scaled sum(algsurf_scaled a, algsurf_scaled b) {
    const int64_t down = a.exponent > b.exponent ? a.exponent - b.exponent : b.exponent - a.exponent;
    const double unit = down < 900 ? power_of_two(-down) : 0;
    if (b.exponent > a.exponent) return scaled_of(a.re * unit + b.re, a.im * unit + b.im, b.exponent);
    return scaled_of(a.re + unit * b.re, a.im + unit * b.im, a.exponent);
}

/* |a|, up to 3 u of it. */
static inline algsurf_scaled size_of(algsurf_scaled a) {
    return scaled_of(sqrt(a.re * a.re + a.im * a.im), 0, a.exponent);
}

/* Sizes: a < b; the larger one. */
static inline int less(algsurf_scaled a, algsurf_scaled b) {
    return a.exponent != b.exponent ? a.exponent < b.exponent : a.re < b.re;
}
static inline algsurf_scaled larger(algsurf_scaled a, algsurf_scaled b) { return less(a, b) ? b : a; }

#endif
