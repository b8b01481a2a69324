/* eft_integer.h - integers of any fixed size, for signs that no error bound can tell.
 *
 * An integer is `size` words of 32 bits, the lowest first, in two's complement: sums and products are those
 * modulo 2^(32 size), hence exact as long as the true value fits; the caller sees to that.
 */
#ifndef ALGSURF_EFT_INTEGER_H
#define ALGSURF_EFT_INTEGER_H
#include <stdint.h>

#define ALGSURF_FACTOR_WORDS 144

/* A factor, as sign and magnitude: short against what it multiplies. */
typedef struct algsurf_i_factor {
    int negative, count; /* words in use */
    uint32_t word[ALGSURF_FACTOR_WORDS];
} algsurf_i_factor;

/* The exponent of the last bit that is set in x, which is finite and not 0. */
int algsurf_i_last_bit(double x);

void algsurf_i_integer_zero(uint32_t *a, int size);
void algsurf_i_integer_add(uint32_t *a, const uint32_t *b, int size);    /* a += b */
void algsurf_i_integer_shift(uint32_t *a, int size, int bits);           /* a <<= bits >= 0 */
int algsurf_i_integer_sign(const uint32_t *a, int size);                 /* -1, 0, +1 */
void algsurf_i_integer_multiply(uint32_t *a, int size, uint32_t factor); /* a *= factor */
/* a += b f; a and b are different. */
void algsurf_i_integer_add_product(uint32_t *a, const uint32_t *b, const algsurf_i_factor *f, int size);

/* f = x 2^shift, an integer that fits. */
void algsurf_i_factor_of(algsurf_i_factor *f, double x, int shift);
/* f = a, of at most ALGSURF_FACTOR_WORDS words. */
void algsurf_i_factor_from(algsurf_i_factor *f, const uint32_t *a, int size);

#endif
