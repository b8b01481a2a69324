/* exact_limbs.h - GMP's integers and arrays of limbs in two's complement, for tests. */
#ifndef EXACT_LIMBS_H
#define EXACT_LIMBS_H
#include "exact.h"

/* z = a; w limbs. */
static inline void exact_limbs(mpz_t z, const uint64_t *a, int w) {
    mpz_import(z, (size_t)w, -1, sizeof *a, 0, 0, a);
    if (a[w - 1] >> 63) {
        mpz_t top;
        mpz_init(top);
        mpz_setbit(top, (mp_bitcnt_t)(64 * w));
        mpz_sub(z, z, top);
        mpz_clear(top);
    }
}

/* Is a = z modulo 2^(64 w)? */
static inline int exact_limbs_equal(const uint64_t *a, int w, const mpz_t z) {
    mpz_t x;
    mpz_init(x);
    exact_limbs(x, a, w);
    mpz_sub(x, x, z);
    mpz_fdiv_r_2exp(x, x, (mp_bitcnt_t)(64 * w));
    int equal = mpz_sgn(x) == 0;
    mpz_clear(x);
    return equal;
}

/* For messages. */
static inline void exact_limbs_print(const char *name, const uint64_t *a, int w) {
    fprintf(stderr, "%s = {", name);
    for (int i = 0; i < w; i++) fprintf(stderr, "%s0x%016llx", i ? ", " : "", (unsigned long long)a[i]);
    fprintf(stderr, "}, lowest limb first\n");
}

/* Random limbs of a kind: uniform, runs of zeros and ones, a power of two and its neighbours, short, 0, -1,
 * the least integer of that width. */
static inline void random_limbs(uint64_t *state, uint64_t *a, int w) {
    int kind = random_int(state, 16), bit = random_int(state, 64 * w), some = random_int(state, w + 1);
    uint64_t fill = kind & 1 ? 0 : ~(uint64_t)0;
    for (int i = 0; i < w; i++) {
        uint64_t x = random_bits(state);
        a[i] = kind < 5 ? x : kind < 9 ? (x & 4 ? 0 : ~(uint64_t)0) : kind < 12 && i < some ? x : fill;
    }
    if (kind == 12 || kind == 13) a[bit / 64] ^= (uint64_t)1 << bit % 64;
    if (kind == 14) {
        for (int i = 0; i < w; i++) a[i] = 0;
        a[w - 1] = (uint64_t)1 << 63;
    }
    if (kind >= 12 && kind < 15 && random_int(state, 4) == 0) a[0] += 1;
}
#endif
