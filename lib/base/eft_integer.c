/* eft_integer.c - see eft_integer.h. */
#include "eft_integer.h"

#include <math.h>
#include <string.h>

/* |x| = mantissa 2^exponent, the mantissa odd; x is finite and not 0. */
static uint64_t odd_mantissa(double x, int *exponent) {
    uint64_t mantissa = (uint64_t)ldexp(frexp(fabs(x), exponent), 53);
    *exponent -= 53;
    for (; mantissa % 2 == 0; mantissa /= 2) ++*exponent;
    return mantissa;
}

int algsurf_i_last_bit(double x) {
    int exponent;
    (void)odd_mantissa(x, &exponent);
    return exponent;
}

void algsurf_i_integer_zero(uint32_t *a, int size) { memset(a, 0, (size_t)size * sizeof *a); }

void algsurf_i_integer_add(uint32_t *a, const uint32_t *b, int size) {
    uint64_t carry = 0;
    for (int i = 0; i < size; i++) {
        carry += (uint64_t)a[i] + b[i];
        a[i] = (uint32_t)carry;
        carry >>= 32;
    }
}

void algsurf_i_integer_shift(uint32_t *a, int size, int bits) {
    int words = bits / 32, rest = bits % 32;
    for (int i = size - 1; i >= 0; i--) {
        uint64_t here = i >= words ? a[i - words] : 0, below = i > words ? a[i - words - 1] : 0;
        a[i] = (uint32_t)((here << 32 | below) << rest >> 32);
    }
}

int algsurf_i_integer_sign(const uint32_t *a, int size) {
    if (a[size - 1] >> 31) return -1;
    for (int i = 0; i < size; i++)
        if (a[i] != 0) return 1;
    return 0;
}

void algsurf_i_integer_multiply(uint32_t *a, int size, uint32_t factor) {
    uint64_t carry = 0;
    for (int i = 0; i < size; i++) {
        carry += (uint64_t)a[i] * factor;
        a[i] = (uint32_t)carry;
        carry >>= 32;
    }
}

static void complement(uint32_t *a, int size) {
    for (int i = 0; i < size; i++) a[i] = ~a[i];
}

void algsurf_i_integer_add_product(uint32_t *a, const uint32_t *b, const algsurf_i_factor *f, int size) {
    if (f->negative) complement(a, size); /* ~(~a + b f) = a - b f */
    for (int j = 0; j < f->count && j < size; j++) {
        uint64_t carry = 0;
        for (int i = j; i < size; i++) {
            carry += (uint64_t)b[i - j] * f->word[j] + a[i];
            a[i] = (uint32_t)carry;
            carry >>= 32;
        }
    }
    if (f->negative) complement(a, size);
}

void algsurf_i_factor_from(algsurf_i_factor *f, const uint32_t *a, int size) {
    f->negative = algsurf_i_integer_sign(a, size) < 0;
    memcpy(f->word, a, (size_t)size * sizeof *a);
    f->count = size;
    if (f->negative) {
        const uint32_t minus_one = 0xffffffff;
        uint64_t carry = 1;
        for (int i = 0; i < size; i++) {
            carry += f->word[i] ^ minus_one;
            f->word[i] = (uint32_t)carry;
            carry >>= 32;
        }
    }
    while (f->count > 0 && f->word[f->count - 1] == 0) f->count--;
}

void algsurf_i_factor_of(algsurf_i_factor *f, double x, int shift) {
    uint32_t words[ALGSURF_FACTOR_WORDS] = {0};
    int exponent = 0;
    uint64_t mantissa = x == 0 ? 0 : odd_mantissa(x, &exponent);
    words[0] = (uint32_t)mantissa;
    words[1] = (uint32_t)(mantissa >> 32);
    algsurf_i_integer_shift(words, ALGSURF_FACTOR_WORDS, x == 0 ? 0 : exponent + shift);
    algsurf_i_factor_from(f, words, ALGSURF_FACTOR_WORDS);
    f->negative = x < 0;
}
