/* random.h - the random numbers of the tests: splitmix64 (Steele, Lea, Flood 2014), from any seed.
 *
 * Seeds stand in the tests, so that each run is like the other. TEST_SEED in the environment, a number other
 * than 0, changes every sequence (tests/long sets it); a failure is repeated with the same number.
 */
#ifndef RANDOM_H
#define RANDOM_H
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

static uint64_t random_salt;

__attribute__((constructor)) static void random_read_salt(void) {
    const char *text = getenv("TEST_SEED");
    random_salt = text ? strtoull(text, NULL, 0) : 0;
    if (random_salt) fprintf(stderr, "TEST_SEED=%llu\n", (unsigned long long)random_salt);
}

static inline uint64_t random_mix(uint64_t z) {
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

static inline uint64_t random_bits(uint64_t *state) {
    *state += 0x9e3779b97f4a7c15u;
    return random_mix(*state ^ random_mix(random_salt)); /* 0 stays 0 */
}

/* How often cases come up in the sequences of the tests' own seeds. */
#define assert_often(condition) assert_true(random_salt || (condition))

/* Uniform in [-1,1]. */
static inline double random_unit(uint64_t *state) { return (double)(int64_t)random_bits(state) * 0x1p-63; }

/* Uniform in [lo,hi]. */
static inline double random_between(uint64_t *state, double lo, double hi) {
    return lo + (hi - lo) * 0.5 * (1 + random_unit(state));
}

/* Of at most `bits` bits, in [-1,1]. */
static inline double random_short(uint64_t *state, int bits) {
    return ldexp(floor(ldexp(random_unit(state), bits)), -bits);
}

/* Uniform in 0 .. n-1. */
static inline int random_int(uint64_t *state, int n) { return (int)(random_bits(state) % (uint64_t)n); }

/* A multiple of 1/2, at most `most` in size. */
static inline double random_halves(uint64_t *state, int most) {
    return 0.5 * (random_int(state, 4 * most + 1) - 2 * most);
}

/* A full random mantissa and sign, the exponent uniform in [low,high]; ldexp rounds into the subnormals. */
static inline double random_wide(uint64_t *state, int low, int high) {
    double x = 1.0 + fabs(random_unit(state));
    if (random_bits(state) & 1) x = -x;
    return ldexp(x, low + random_int(state, high - low + 1));
}

#endif
