/* roots_limbs.h - natural numbers of any length: limbs, the least significant first.  The last one is not 0,
 * and the number 0 has none.  Schoolbook arithmetic: numbers in lines are short. */
#ifndef ROOTS_LIMBS_H
#define ROOTS_LIMBS_H
#include <stdint.h>

/* All that return an int return a length. */

/* a = a factor + add, in place: a limb more may be filled. */
int roots_limbs_times(uint64_t *a, int length, uint32_t factor, uint32_t add);

/* a 2^bits in place: so many bits more are filled, and the limb behind them. */
int roots_limbs_shift_up(uint64_t *a, int length, long long bits);

/* a > 0 divided by the largest power of two there is in it, 2^*twos, in place. */
int roots_limbs_make_odd(uint64_t *a, int length, int *twos);

/* The bits of a > 0. */
int roots_limbs_bits(const uint64_t *a, int length);

/* a b, into room for the limbs of both, apart from them. */
int roots_limbs_product(const uint64_t *a, int a_length, const uint64_t *b, int b_length, uint64_t *product);

/* a / b of odd numbers, where b divides a: into room for the limbs of a.  Loses a, which needs room for one
 * limb more. */
int roots_limbs_quotient(uint64_t *a, int a_length, const uint64_t *b, int b_length, uint64_t *quotient);

/* The gcd of two odd numbers, into b.  Loses a; both need room for one limb more. */
int roots_limbs_gcd(uint64_t *a, int a_length, uint64_t *b, int b_length);

/* The double nearest to a 2^-down, infinite where that is too large; sets *off where it is rounded. */
double roots_limbs_double(const uint64_t *a, int length, int down, int *off);

/* The double nearest to a / b 2^up, a and b > 0; infinite where it is too large.  Loses a and b, which need
 * room for the bits of both and a limb more. */
double roots_limbs_ratio(uint64_t *a, int a_length, uint64_t *b, int b_length, long long up);

#endif
