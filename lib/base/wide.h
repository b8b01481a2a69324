/* base/wide.h - sums, products and quotients of two limbs.
 *
 * Where the compiler has integers of 128 bits they are used, and on x86-64 the two instructions for a carry
 * (gcc does not find them in a loop by itself); elsewhere the same results come from 64 bits alone. */
#ifndef ALGSURF_WIDE_H
#define ALGSURF_WIDE_H
#include <stdint.h>

typedef uint64_t algsurf_limb;

#if defined(__SIZEOF_INT128__) && !defined(ALGSURF_PORTABLE_LIMBS)
#define ALGSURF_HAS_WIDE 1
__extension__ typedef unsigned __int128 algsurf_wide;
#else
#define ALGSURF_HAS_WIDE 0
#endif

/* a + b + *carry; *carry is 0 or 1, before and after. */
static inline algsurf_limb algsurf_limb_add(algsurf_limb a, algsurf_limb b, unsigned char *carry) {
#if ALGSURF_HAS_WIDE && defined(__x86_64__)
    unsigned long long sum;
    *carry = __builtin_ia32_addcarryx_u64(*carry, a, b, &sum);
    return (algsurf_limb)sum;
#else
    algsurf_limb partial = a + b, sum = partial + *carry;
    *carry = (unsigned char)((partial < a) | (sum < partial));
    return sum;
#endif
}

/* *r = a + b + carry, *r = a - b - borrow; the carry is returned.  gcc stores the result of its two builtins
 * for carries to memory in any case: here once, to where it belongs.  (It does so without regard to types.)
 */
static inline unsigned char algsurf_limb_add_to(algsurf_limb *r, algsurf_limb a, algsurf_limb b,
                                                unsigned char carry) {
#if ALGSURF_HAS_WIDE && defined(__x86_64__) && !defined(__clang__)
    return __builtin_ia32_addcarryx_u64(carry, a, b, (unsigned long long *)(void *)r);
#else
    *r = algsurf_limb_add(a, b, &carry);
    return carry;
#endif
}
static inline unsigned char algsurf_limb_sub_to(algsurf_limb *r, algsurf_limb a, algsurf_limb b,
                                                unsigned char borrow) {
#if ALGSURF_HAS_WIDE && defined(__x86_64__) && defined(__clang__)
    unsigned long long difference;
    borrow = __builtin_ia32_subborrow_u64(borrow, a, b, &difference);
    *r = (algsurf_limb)difference;
    return borrow;
#elif ALGSURF_HAS_WIDE && defined(__x86_64__)
    return __builtin_ia32_sbb_u64(borrow, a, b, (unsigned long long *)(void *)r);
#else
    algsurf_limb partial = a - b;
    *r = partial - borrow;
    return (unsigned char)((a < b) | (partial < borrow));
#endif
}

/* *r += a + carry or, for `minus`, *r -= a + carry. */
static inline __attribute__((always_inline)) unsigned char algsurf_limb_join(algsurf_limb *r, algsurf_limb a,
                                                                             unsigned char carry, int minus) {
    return minus ? algsurf_limb_sub_to(r, *r, a, carry) : algsurf_limb_add_to(r, *r, a, carry);
}

/* a b + c + d = result + 2^64 *high, which never overflows: (2^64 - 1)^2 + 2 (2^64 - 1) = 2^128 - 1. */
static inline algsurf_limb algsurf_limb_product(algsurf_limb a, algsurf_limb b, algsurf_limb c,
                                                algsurf_limb d, algsurf_limb *high) {
#if ALGSURF_HAS_WIDE
    algsurf_wide p = (algsurf_wide)a * b + c + d;
    *high = (algsurf_limb)(p >> 64);
    return (algsurf_limb)p;
#else
    const algsurf_limb half = 0xffffffffu;
    algsurf_limb al = a & half, ah = a >> 32, bl = b & half, bh = b >> 32;
    algsurf_limb low = al * bl, middle = ah * bl + (low >> 32), other = al * bh + (middle & half);
    algsurf_limb top = ah * bh + (middle >> 32) + (other >> 32), r = other << 32 | (low & half);
    r += c, top += r < c;
    r += d, top += r < d;
    *high = top;
    return r;
#endif
}

/* Leading and trailing zeros of x, which is not 0. */
static inline int algsurf_limb_leading(algsurf_limb x) { return __builtin_clzll(x); }
static inline int algsurf_limb_trailing(algsurf_limb x) { return __builtin_ctzll(x); }
/* The least b with x < 2^b. */
static inline int algsurf_limb_bits(algsurf_limb x) { return x ? 64 - algsurf_limb_leading(x) : 0; }

/* The quotient of high 2^64 + low by d, for high < d and d >= 2^63. */
static inline algsurf_limb algsurf_limb_quotient(algsurf_limb high, algsurf_limb low, algsurf_limb d) {
#if ALGSURF_HAS_WIDE
    return (algsurf_limb)(((algsurf_wide)high << 64 | low) / d);
#else /* two digits of 32 bits (Knuth, algorithm D); a trial quotient by d's upper half: 0 to 2 too large */
    algsurf_limb q = 0, dh = d >> 32, dl = d & 0xffffffffu;
    for (int shift = 32; shift >= 0; shift -= 32) {
        algsurf_limb next = low >> shift & 0xffffffffu, digit = high / dh, rest = high % dh;
        while (digit >> 32 || (!(rest >> 32) && digit * dl > (rest << 32 | next))) digit--, rest += dh;
        high = (high << 32 | next) - digit * d;
        q = q << 32 | digit;
    }
    return q;
#endif
}

/* Division by one limb again and again (Moller, Granlund, Improved division by invariant integers, 2011):
 * inverse = floor((2^128 - 1) / d) - 2^64, for d >= 2^63. */
static inline algsurf_limb algsurf_limb_inverse(algsurf_limb d) {
    return algsurf_limb_quotient(~d, ~(algsurf_limb)0, d);
}
/* The quotient of high 2^64 + low by d, and the remainder; high < d, d >= 2^63 (their algorithm 4). */
static inline algsurf_limb algsurf_limb_divide(algsurf_limb high, algsurf_limb low, algsurf_limb d,
                                               algsurf_limb inverse, algsurf_limb *remainder) {
    unsigned char carry = 0;
    algsurf_limb q1, q0 = algsurf_limb_product(inverse, high, 0, 0, &q1);
    q0 = algsurf_limb_add(q0, low, &carry);
    q1 = algsurf_limb_add(q1, high, &carry) + 1;
    algsurf_limb r = low - q1 * d;
    if (r > q0) q1--, r += d;
    if (r >= d) q1++, r -= d;
    *remainder = r;
    return q1;
}
#endif
