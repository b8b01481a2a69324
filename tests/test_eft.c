/* test_eft.c - the private rooms eft and fpenv, against exact rationals.
 *
 * Breaks caught: a term lost from a transform or from a double-double operation (the relative bound fails
 * at once), operands in the wrong order, a bound stated too small, an environment that is not set or not
 * given back (rounding mode, FTZ, DAZ, exception flags). */
#include "exact.h"

#include <fenv.h>

#include "base/eft.h"
#include "base/fpenv.h"
#include "unit.h"

#define ROUNDS 20000
#define SEED 20240607u

static void fail_dd(const char *what, int round, algsurf_dd a, algsurf_dd b, algsurf_dd got) {
    fail_msg("%s, seed %u round %d: a = %a + %a, b = %a + %a, result %a + %a", what, SEED, round, a.hi, a.lo,
             b.hi, b.lo, got.hi, got.lo);
}

/* Is |got - exact| <= factor |exact|? */
static int relative(algsurf_dd got, const mpq_t exact, double factor) {
    mpq_t error, limit;
    mpq_inits(error, limit, NULL);
    exact_set2(error, got.hi, got.lo);
    mpq_sub(error, error, exact), mpq_abs(error, error);
    exact_set(limit, factor);
    mpq_mul(limit, limit, exact), mpq_abs(limit, limit);
    int holds = mpq_cmp(error, limit) <= 0;
    mpq_clears(error, limit, NULL);
    return holds;
}

static int normalised(algsurf_dd a) { return a.hi + a.lo == a.hi; }

/* A double-double with a full second half; exponents close enough that sums cancel now and then. */
static algsurf_dd random_dd(uint64_t *seed) {
    double hi = random_wide(seed, -3, 3);
    return algsurf_fast_two_sum(hi, hi * 0x1p-53 * random_unit(seed));
}

TEST(test_transforms_are_exact) {
    uint64_t seed = SEED;
    mpq_t x, y, sum, product, got;
    mpq_inits(x, y, sum, product, got, NULL);
    for (int i = 0; i < ROUNDS; i++) {
        double a = random_wide(&seed, -60, 60), b = random_wide(&seed, -60, 60);
        exact_set(x, a), exact_set(y, b);
        mpq_add(sum, x, y), mpq_mul(product, x, y);
        algsurf_dd s = algsurf_two_sum(a, b), p = algsurf_two_prod(a, b);
        exact_set2(got, s.hi, s.lo);
        if (!mpq_equal(got, sum) || s.hi != a + b)
            fail_dd("two_sum", i, (algsurf_dd){a, 0}, (algsurf_dd){b, 0}, s);
        exact_set2(got, p.hi, p.lo);
        if (!mpq_equal(got, product) || p.hi != a * b)
            fail_dd("two_prod", i, (algsurf_dd){a, 0}, (algsurf_dd){b, 0}, p);
        s = fabs(a) >= fabs(b) ? algsurf_fast_two_sum(a, b) : algsurf_fast_two_sum(b, a);
        exact_set2(got, s.hi, s.lo);
        if (!mpq_equal(got, sum)) fail_dd("fast_two_sum", i, (algsurf_dd){a, 0}, (algsurf_dd){b, 0}, s);
    }
    mpq_clears(x, y, sum, product, got, NULL);
}

/* |got - (a b + c)| <= (1/2 + 2^-50) ulp, for results that are normal and finite. */
static int rounded_once(double a, double b, double c, double got) {
    int exponent;
    mpq_t x, y, limit;
    mpq_inits(x, y, limit, NULL);
    exact_set(x, a), exact_set(y, b);
    mpq_mul(x, x, y);
    exact_set(y, c);
    mpq_add(x, x, y);
    exact_set(y, got);
    mpq_sub(x, x, y), mpq_abs(x, x);
    (void)frexp(got, &exponent);
    exact_set(limit, ldexp(1 + 0x1p-50, exponent - 54 < -1074 ? -1074 : exponent - 54));
    int holds = got == 0 ? mpq_sgn(x) == 0 : mpq_cmp(x, limit) <= 0;
    mpq_clears(x, y, limit, NULL);
    return holds;
}

TEST(test_multiply_add) {
    uint64_t seed = SEED + 7;
    for (int i = 0; i < ROUNDS; i++) {
        static const int range[4] = {3, 60, 450, 900};
        int wide = range[i % 4];
        double a = random_wide(&seed, -wide, wide), b = random_wide(&seed, -wide, wide), c;
        if (i % 16 == 15) b = ldexp(b, -1000); /* subnormal, too */
        double product = a * b;
        if (!isfinite(product)) product = copysign(0x1p1000, product);
        switch (i / 4 % 4) { /* all cancels but the product's error; nearly all; little; c is far from it */
        case 0:
            c = -product;
            break;
        case 1:
            c = -product * (1 + 0x1p-40 * random_unit(&seed));
            break;
        case 2:
            c = product * random_unit(&seed);
            break;
        default:
            c = random_wide(&seed, -1000, 1000);
        }
        double got = algsurf_multiply_add(a, b, c), size = fabs(got);
        if (isinf(got)) assert_true(!(fabs(a * b) / 2 + fabs(c) / 2 < 0x1p1023 - 0x1p969));
        if (isfinite(a * b) && isfinite(got) && size >= 0x1p-1022 && !rounded_once(a, b, c, got))
            fail_msg("multiply_add, seed %u round %d: %a * %a + %a is not %a", SEED + 7, i, a, b, c, got);
    }
    assert_true(algsurf_multiply_add(0x1p1000, 0x1p1000, -1) == INFINITY);
    assert_true(algsurf_multiply_add(0x1p1000, 0x1p1000, -DBL_MAX) == INFINITY);
    assert_true(algsurf_multiply_add(0x1p600, 0x1p500, -0x1p1023) == INFINITY);
    assert_true(algsurf_multiply_add(0x1p512, 0x1p512, -0x1.8p1023) == 0x1p1022);
    assert_true(algsurf_multiply_add(0x1p-600, 0x1p-600, 1) == 1);
    assert_true(algsurf_multiply_add(0x1p-600, 0x1p-400, 0x1p-1000) == 0x1p-999);
    assert_true(algsurf_multiply_add(0, 3, -2) == -2);
    assert_true(algsurf_multiply_add(INFINITY, -2, 1) == -INFINITY);
}

/* The products the header promises: down to 2^-969, and factors up to 2^995 when nothing overflows. */
TEST(test_two_prod_at_its_limits) {
    uint64_t seed = SEED + 1;
    mpq_t x, y, got;
    mpq_inits(x, y, got, NULL);
    for (int i = 0; i < ROUNDS; i++) {
        int low = i % 2;
        double a = low ? random_wide(&seed, -484, -450) : random_wide(&seed, 900, 994);
        double b = low ? random_wide(&seed, -484, -450) : random_wide(&seed, -1000, 20);
        exact_set(x, a), exact_set(y, b), mpq_mul(x, x, y);
        algsurf_dd p = algsurf_two_prod(a, b);
        exact_set2(got, p.hi, p.lo);
        if (!mpq_equal(got, x)) fail_dd("two_prod", i, (algsurf_dd){a, 0}, (algsurf_dd){b, 0}, p);
    }
    mpq_clears(x, y, got, NULL);
}

/* What underflow may take from two_prod: at most 5 * 2^-1074, which poly.c relies on. */
TEST(test_two_prod_in_underflow) {
    uint64_t seed = SEED + 2;
    mpq_t x, y, got;
    mpq_inits(x, y, got, NULL);
    for (int i = 0; i < ROUNDS; i++) {
        double a = random_wide(&seed, -600, -450), b = random_wide(&seed, -600, -450);
        exact_set(x, a), exact_set(y, b), mpq_mul(x, x, y);
        algsurf_dd p = algsurf_two_prod(a, b);
        exact_set2(got, p.hi, p.lo);
        mpq_sub(got, got, x), mpq_abs(got, got), exact_set(y, 5 * 0x1p-1074);
        if (mpq_cmp(got, y) > 0) fail_dd("two_prod", i, (algsurf_dd){a, 0}, (algsurf_dd){b, 0}, p);
    }
    mpq_clears(x, y, got, NULL);
}

TEST(test_double_double_sums) {
    uint64_t seed = SEED + 3;
    mpq_t x, y, e;
    mpq_inits(x, y, e, NULL);
    for (int i = 0; i < ROUNDS; i++) {
        algsurf_dd a = random_dd(&seed), b = random_dd(&seed), r;
        if (i % 4 == 0) b = (algsurf_dd){-a.hi, b.lo * 0.25}; /* heavy cancellation */
        exact_set2(x, a.hi, a.lo), exact_set2(y, b.hi, b.lo);
        mpq_add(e, x, y), r = algsurf_dd_add(a, b);
        if (!relative(r, e, ALGSURF_DD_U) || !normalised(r)) fail_dd("add", i, a, b, r);
        mpq_sub(e, x, y), r = algsurf_dd_sub(a, b);
        if (!relative(r, e, ALGSURF_DD_U) || !normalised(r)) fail_dd("sub", i, a, b, r);
        exact_set(y, b.hi), mpq_add(e, x, y), r = algsurf_dd_add_d(a, b.hi);
        if (!relative(r, e, ALGSURF_DD_U) || !normalised(r)) fail_dd("add_d", i, a, b, r);
    }
    mpq_clears(x, y, e, NULL);
}

TEST(test_double_double_products) {
    uint64_t seed = SEED + 4;
    mpq_t x, y, e;
    mpq_inits(x, y, e, NULL);
    for (int i = 0; i < ROUNDS; i++) {
        algsurf_dd a = random_dd(&seed), b = random_dd(&seed), r;
        exact_set2(x, a.hi, a.lo), exact_set2(y, b.hi, b.lo);
        mpq_mul(e, x, y), r = algsurf_dd_mul(a, b);
        if (!relative(r, e, ALGSURF_DD_U) || !normalised(r)) fail_dd("mul", i, a, b, r);
        mpq_div(e, x, y), r = algsurf_dd_div(a, b);
        if (!relative(r, e, 10 * 0x1p-106) || !normalised(r)) fail_dd("div", i, a, b, r);
        exact_set(y, b.hi), mpq_mul(e, x, y), r = algsurf_dd_mul_d(a, b.hi);
        if (!relative(r, e, ALGSURF_DD_U) || !normalised(r)) fail_dd("mul_d", i, a, b, r);
    }
    mpq_clears(x, y, e, NULL);
}

/* Root and exact root differ by about (r^2 - a)/(2a) of it: "a few u^2" is tested as 8 u^2. */
TEST(test_double_double_root) {
    uint64_t seed = SEED + 5;
    mpq_t x, r2;
    mpq_inits(x, r2, NULL);
    for (int i = 0; i < ROUNDS; i++) {
        algsurf_dd a = random_dd(&seed);
        if (a.hi < 0) a = algsurf_dd_neg(a);
        algsurf_dd r = algsurf_dd_sqrt(a);
        exact_set2(x, a.hi, a.lo), exact_set2(r2, r.hi, r.lo);
        mpq_mul(r2, r2, r2);
        mpq_sub(r2, r2, x), mpq_div(r2, r2, x), mpq_abs(r2, r2), exact_set(x, 16 * 0x1p-106);
        if (mpq_cmp(r2, x) > 0 || !normalised(r)) fail_dd("sqrt", i, a, a, r);
    }
    mpq_clears(x, r2, NULL);
    assert_true(algsurf_dd_sqrt(algsurf_dd_from(0.0)).hi == 0.0);
}

TEST(test_double_double_scale) {
    const algsurf_dd more = {1, 0x1p-60};
    assert_true(algsurf_dd_scale(more, 0x1p10).hi == 0x1p10 && algsurf_dd_scale(more, 0x1p10).lo == 0x1p-50);
}

/* ---- the environment ---- */

typedef struct {
    double third, fifth, half_smallest;
} probe;

/* Results that differ between the rounding modes, and when subnormals are flushed. */
static ALGSURF_NOINLINE probe take_probe(void) {
    volatile double one = 1.0, three = 3.0, five = 5.0, smallest = 0x1p-1022, half = 0.5;
    return (probe){one / three, one / five, smallest * half};
}

/* To nearest, 1/3 is rounded down and 1/5 up: each other mode gets one of them wrong. */
static int is_standard(probe p) { return p.third == 0x1.5555555555555p-2 && p.fifth == 0x1.999999999999ap-3; }

static const int modes[] = {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};

TEST(test_every_rounding_mode) {
    for (size_t i = 0; i < sizeof modes / sizeof modes[0]; i++) {
        assert_int_equal(fesetround(modes[i]), 0);
        feclearexcept(FE_ALL_EXCEPT);
        int differs = !is_standard(take_probe());
        feclearexcept(FE_ALL_EXCEPT);
        feraiseexcept(FE_DIVBYZERO);
        algsurf_fpenv saved;
        algsurf_fpenv_enter(&saved);
        probe inside = take_probe();
        algsurf_fpenv_leave(&saved);
        int mode = fegetround(), flags = fetestexcept(FE_ALL_EXCEPT);
        fesetround(FE_TONEAREST);
        assert_int_equal(differs, modes[i] != FE_TONEAREST); /* the probe sees something */
        assert_true(is_standard(inside));
        assert_int_equal(mode, modes[i]);
        assert_int_equal(flags,
                         FE_DIVBYZERO); /* "inexact" from the probe is gone, the caller's flag is not */
    }
    feclearexcept(FE_ALL_EXCEPT);
}

#if defined(__SSE2__) || defined(__x86_64__)
#define FTZ 0x8000u
#define DAZ 0x0040u
TEST(test_flush_to_zero) {
    static const unsigned bits[] = {FTZ, DAZ, FTZ | DAZ};
    for (size_t i = 0; i < 3; i++) {
        unsigned before = _mm_getcsr(), mine = before | bits[i];
        _mm_setcsr(mine);
        probe outside = take_probe();
        algsurf_fpenv saved;
        algsurf_fpenv_enter(&saved);
        probe inside = take_probe();
        algsurf_fpenv_leave(&saved);
        unsigned after = _mm_getcsr();
        _mm_setcsr(before);
        assert_true(outside.half_smallest == ((bits[i] & FTZ) ? 0.0 : 0x1p-1023));
        assert_true(inside.half_smallest == 0x1p-1023);
        assert_int_equal(after & ALGSURF_MXCSR_CONTROL, mine & ALGSURF_MXCSR_CONTROL);
    }
}
#endif
