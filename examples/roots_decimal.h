/* roots_decimal.h - numbers as they are written, exactly: d 5^f 2^g with an integer d. */
#ifndef ROOTS_DECIMAL_H
#define ROOTS_DECIMAL_H
#include <stdint.h>

/* A number of a text, which it points into. */
typedef struct roots_decimal {
    const char *digits; /* from the first to the last that is not 0, with the point; they are the integer d */
    int count;          /* of digits; 0: the number is 0 */
    int radix, negative;   /* 10 or 16 */
    long long fives, twos; /* the number is d 5^fives 2^twos */
} roots_decimal;

/* The number that a text begins with, decimal or hexadecimal, with an exponent or without.  Returns the text
 * behind it, null if there is none, or its exponent is beyond 10^12. */
const char *roots_decimal_read(const char *text, roots_decimal *d);

/* Bits that suffice for d 5^(fives - f) 2^(twos - g), f <= fives, g <= twos. */
long long roots_decimal_bits(const roots_decimal *d, long long f, long long g);

/* The magnitude of that integer, least significant limb first, into room for two limbs more than those bits
 * fill.  Returns its length: the last limb is not 0. */
int roots_decimal_limbs(const roots_decimal *d, long long f, long long g, uint64_t *limbs);

#endif
