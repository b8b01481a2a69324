/* test_elementary.c - the private room elementary, against libm's long double functions, which have at least
 * 11 more bits; and the bits themselves, which are to be those of every machine.
 *
 * Breaks caught: a term lost from a series, a constant without its low part, a wrong quarter, operations that
 * the compiler fuses or reorders. */
#include "base/arithmetic.h" /* the arguments are to be the same everywhere, too */
#include "base/elementary.h"
#include "unit.h"

#define ROUNDS 100000
#define MOST_ULPS 0.9L

_Static_assert(LDBL_MANT_DIG >= 64, "long double says nothing here");

static uint64_t seed;

/* In [0, 1), multiples of 2^-53. */
static double next_random(void) {
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    return (double)(seed >> 11) * 0x1p-53;
}

static double between(double lo, double hi) { return lo + (hi - lo) * next_random(); }

/* The value is exact but for some share of a unit in the last place, and for the slack. */
static void assert_close(const char *what, double x, double y, double got, long double exact,
                         long double slack) {
    int e;
    (void)frexpl(exact, &e);
    long double ulp = ldexpl(1, (e < DBL_MIN_EXP ? DBL_MIN_EXP : e) - DBL_MANT_DIG);
    if (!(fabsl((long double)got - exact) <= MOST_ULPS * ulp + slack))
        fail_msg("%s(%a, %a) = %a, off by %Lg ulp", what, x, y, got, ((long double)got - exact) / ulp);
}

static void assert_near(const char *what, double x, double y, double got, long double exact) {
    assert_close(what, x, y, got, exact, 0);
}

static void assert_circle(double angle) {
    double p[2];
    algsurf_i_circle(angle, p);
    assert_close("cos", angle, 0, p[0], cosl(angle), 0x1p-100L * fabsl(angle));
    assert_close("sin", angle, 0, p[1], sinl(angle), 0x1p-100L * fabsl(angle));
}

TEST(logarithms) {
    seed = 1;
    for (int i = 0; i < ROUNDS; i++) {
        double x = ldexp(between(1, 2), i % 2 ? (int)between(-1074, 1024) : i % 3 - 1);
        assert_near("log2", x, 0, algsurf_i_log2(x), log2l(x));
    }
    for (int k = -1074; k < 1024; k++) assert_true(algsurf_i_log2(ldexp(1, k)) == k);
    assert_near("log2", 1 - 0x1p-53, 0, algsurf_i_log2(1 - 0x1p-53), log2l(1 - 0x1p-53L));
}

TEST(powers_of_two) {
    seed = 2;
    for (int i = 0; i < ROUNDS; i++) {
        double x = i % 2 ? between(-1021, 1023.9) : between(-1, 1);
        assert_near("exp2", x, 0, algsurf_i_exp2(x), exp2l(x));
    }
    for (int k = -1074; k < 1024; k++) assert_true(algsurf_i_exp2(k) == ldexp(1, k));
    assert_true(algsurf_i_exp2(1024) == HUGE_VAL && algsurf_i_exp2(HUGE_VAL) == HUGE_VAL);
    assert_true(algsurf_i_exp2(-1080) == 0 && algsurf_i_exp2(-HUGE_VAL) == 0 && algsurf_i_exp2(-1e300) == 0);
    assert_true(isnan(algsurf_i_exp2(NAN)));
}

TEST(powers) {
    seed = 3;
    for (int i = 0; i < ROUNDS; i++) {
        double x = i % 2 ? between(0, 1) : ldexp(between(1, 2), (int)between(-1000, 1000));
        double y = i % 2 ? between(0, 60) : between(0, 1);
        double got = algsurf_i_pow(x, y);
        long double exact = powl(x, y), unit = ldexpl(1, ilogbl(exact) + 1 - DBL_MANT_DIG);
        if (got >= DBL_MIN) assert_close("pow", x, y, got, exact, fabsl(y * log2l(x)) / 32 * unit);
    }
    static const double special[][3] = {
        {0, 0, 1},        {0, 0.5, 0},          {0, 1e300, 0},    {1, 1e300, 1},
        {0.5, 1e300, 0},  {2, 1e300, HUGE_VAL}, {1e-300, 1.1, 0}, {HUGE_VAL, 0.1, HUGE_VAL},
        {HUGE_VAL, 0, 1}, {0x1p600, 1, 0x1p600}};
    for (size_t i = 0; i < sizeof special / sizeof *special; i++)
        assert_true(algsurf_i_pow(special[i][0], special[i][1]) == special[i][2]);
    assert_true(isnan(algsurf_i_pow(NAN, 2)));
}

TEST(circles) {
    seed = 4;
    for (int i = 0; i < ROUNDS; i++) {
        assert_circle(between(-0x1p20, 0x1p20));
        assert_circle(between(-4, 4));
        assert_circle(ldexp(between(1, 2), -i % 1000));
        assert_circle(1.57079632679489662 * i); /* next to a zero */
    }
    double p[2];
    algsurf_i_circle(0, p);
    assert_true(p[0] == 1 && p[1] == 0);
}

/* FNV-1a over the bits. */
static void mix(uint64_t *hash, double value) {
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    for (int i = 0; i < 64; i += 8) *hash = (*hash ^ (bits >> i & 255)) * 1099511628211u;
}

TEST(same_bits_everywhere) {
    uint64_t hash = 14695981039346656037u;
    seed = 5;
    for (int i = 0; i < ROUNDS; i++) {
        double p[2];
        algsurf_i_circle(between(-100, 100), p);
        mix(&hash, p[0]), mix(&hash, p[1]);
        mix(&hash, algsurf_i_log2(between(0, 10)));
        mix(&hash, algsurf_i_exp2(between(-30, 30)));
        double x = next_random(), y = between(0, 90);
        mix(&hash, algsurf_i_pow(x, y));
    }
    assert_int_equal(hash, 0xb799a805aa8bd44bu);
}
