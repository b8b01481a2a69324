/* roots_fraction.h - quotients of two numbers as they are written, exactly: 1/3, -2.5/0x1p3. */
#ifndef ROOTS_FRACTION_H
#define ROOTS_FRACTION_H
#include "roots_decimal.h"

enum { ROOTS_MOST_BITS = 1 << 15, ROOTS_MOST_LIMBS = ROOTS_MOST_BITS / 64 + 4 }; /* of an integer */

/* The number `over`, which has the signs and powers of five and two of both, by the digits of `under`. */
typedef struct roots_fraction {
    roots_decimal over, under;
    int under_bits; /* of these digits as an odd integer, from roots_fraction_common */
} roots_fraction;

/* The fraction, or the number, that a text begins with.  Returns the text behind it, null if there is none,
 * or an exponent is beyond 10^12; by zero: under.count is 0. */
const char *roots_fraction_read(const char *text, roots_fraction *f);

/* The least common multiple, an odd one, of the multiple that is there, at first 1, and the digits of f; what
 * these have of two goes to its powers of two.  Returns its length; 0 if it has more than ROOTS_MOST_BITS.
 * The room is ROOTS_MOST_LIMBS. */
int roots_fraction_common(roots_fraction *f, uint64_t *common, int length);

/* Bits that suffice for the fraction times common 5^-fives 2^-twos, an integer. */
long long roots_fraction_bits(const roots_fraction *f, long long fives, long long twos,
                              const uint64_t *common, int length);

/* The magnitude of that integer, of ROOTS_MOST_BITS at most, into room for four limbs more than its bits
 * fill; returns its length. */
int roots_fraction_limbs(const roots_fraction *f, long long fives, long long twos, const uint64_t *common,
                         int length, uint64_t *limbs);

/* The double nearest to it; infinite where it is too large, or has more than some ten thousand digits. */
double roots_fraction_double(const roots_fraction *f);

#endif
