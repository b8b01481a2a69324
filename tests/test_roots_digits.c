/* test_roots_digits.c - roots as decimals, against GMP's rational numbers: values are the nearest multiples
 * of 10^-places, the ends of intervals the next ones outward, and places are those of the larger part.
 *
 * Breaks tried, each caught: an end rounded inward, a power of five left out, the radius added to one side.
 */
#include "exact_limbs.h"
#include "roots_digits.h"
#include "unit.h"

#include <limits.h>

static uint64_t seed = 7;

/* A decimal as people write it. */
static void read_decimal(const char *text, mpq_t x) {
    char digits[4096];
    int n = 0, point = -1;
    const char *at = text;
    if (*at == '-') digits[n++] = *at++;
    for (; *at && *at != 'e'; at++)
        if (*at == '.')
            point = n;
        else
            digits[n++] = *at;
    digits[n] = '\0';
    const long last = (*at == 'e' ? strtol(at + 1, NULL, 10) : 0) - (point < 0 ? 0 : n - point);
    mpz_t power;
    mpz_init(power);
    mpz_ui_pow_ui(power, 10, (unsigned long)labs(last));
    assert_int_equal(mpz_set_str(mpq_numref(x), digits, 10), 0);
    mpz_set_ui(mpq_denref(x), 1);
    if (last > 0)
        mpz_mul(mpq_numref(x), mpq_numref(x), power);
    else
        mpz_set(mpq_denref(x), power);
    mpq_canonicalize(x);
    mpz_clear(power);
}

/* (z + add) 2^exponent */
static void exact(algsurf_integer z, int add, int exponent, mpq_t x) {
    mpz_set_ui(mpq_denref(x), 1);
    mpz_import(mpq_numref(x), (size_t)abs(z.length), -1, sizeof *z.limbs, 0, 0, z.limbs);
    if (z.length < 0) mpz_neg(mpq_numref(x), mpq_numref(x));
    mpz_add_ui(mpq_numref(x), mpq_numref(x), (unsigned long)(add > 0 ? add : 0));
    mpz_sub_ui(mpq_numref(x), mpq_numref(x), (unsigned long)(add < 0 ? -add : 0));
    if (exponent > 0)
        mpq_mul_2exp(x, x, (mp_bitcnt_t)exponent);
    else
        mpq_div_2exp(x, x, (mp_bitcnt_t)-exponent);
}

static void power_of_ten(mpq_t x, long e) {
    mpq_set_ui(x, 1, 1);
    mpz_ui_pow_ui(e > 0 ? mpq_numref(x) : mpq_denref(x), 10, (unsigned long)labs(e));
}

/* The text is a multiple of the unit, and low / 2 <= (it - x) / unit <= high / 2. */
static int is_near(const char *decimal, const mpq_t x, const mpq_t unit, int low, int high) {
    mpq_t text, d;
    mpq_inits(text, d, NULL);
    read_decimal(decimal, text);
    mpq_div(d, text, unit);
    int answer = mpz_cmp_ui(mpq_denref(d), 1) == 0;
    mpq_sub(d, text, x), mpq_div(d, d, unit);
    answer = answer && mpq_cmp_si(d, low, 2) >= 0 && mpq_cmp_si(d, high, 2) <= 0;
    mpq_clears(text, d, NULL);
    return answer;
}

static int is_right(algsurf_integer z, int radius, int exponent, long last, const roots_decimals *d) {
    mpq_t x, unit;
    mpq_inits(x, unit, NULL);
    power_of_ten(unit, last);
    exact(z, 0, exponent, x);
    int right = is_near(d->value, x, unit, -1, 1);
    exact(z, -radius, exponent, x);
    right = right && is_near(d->lo, x, unit, -2, 0);
    exact(z, radius, exponent, x);
    right = right && is_near(d->hi, x, unit, 0, 2);
    mpq_clears(x, unit, NULL);
    return right;
}

/* The exponent of the first digit of a number that is not 0. */
static long first_place(algsurf_integer z, int exponent) {
    mpq_t x, end;
    mpq_inits(x, end, NULL);
    exact(z, 0, exponent, x), mpq_abs(x, x);
    long e = (long)floor((64.0 * abs(z.length) + exponent) * 0.30103) + 1;
    for (power_of_ten(end, e); mpq_cmp(end, x) > 0; power_of_ten(end, e)) e--;
    mpq_clears(x, end, NULL);
    return e;
}

static algsurf_integer random_integer(uint64_t *limbs, int most) {
    int w = random_int(&seed, most + 1);
    random_limbs(&seed, limbs, w > 0 ? w : 1);
    if (w > 0 && random_int(&seed, 4) == 0) limbs[w - 1] = 1 + (limbs[w - 1] & 1023);
    while (w > 0 && !limbs[w - 1]) w--;
    return (algsurf_integer){limbs, random_int(&seed, 2) ? w : -w};
}

TEST(random_ones) {
    for (int round = 0; round < 4000; round++) {
        uint64_t a[8], b[8];
        const uint64_t begin = seed;
        algsurf_precise_root r = {.re = random_integer(a, 6), .im = random_integer(b, 6), .multiplicity = 1};
        r.exponent = random_int(&seed, 1400) - 900;
        r.radius = random_int(&seed, 2) ? random_int(&seed, 3000) : 0;
        const int digits = 1 + random_int(&seed, round % 2 ? 20 : 300);
        if (r.re.length == 0 && r.im.length == 0) continue;
        roots_decimals re, im;
        assert_true(roots_digits(&r, digits, &re, &im));
        long x = r.re.length ? first_place(r.re, r.exponent) : LONG_MIN,
             y = r.im.length ? first_place(r.im, r.exponent) : LONG_MIN, last = (x > y ? x : y) - digits + 1;
        if (!is_right(r.re, r.radius, r.exponent, last, &re) ||
            !is_right(r.im, r.radius, r.exponent, last, &im))
            fail_msg("seed %llu, %d digits: %s [%s, %s], %s [%s, %s]", (unsigned long long)begin, digits,
                     re.value, re.lo, re.hi, im.value, im.lo, im.hi);
        roots_digits_free(&re), roots_digits_free(&im);
    }
}

TEST(as_people_write_them) {
    static const struct {
        int z, exponent, digits;
        const char *text;
    } cases[] = {{0, 5, 7, "0"},
                 {1, -1, 9, "0.5"},
                 {-3, -2, 9, "-0.75"},
                 {1, 10, 9, "1024"},
                 {1, 10, 4, "1024"},
                 {1, 10, 3, "1.02e+3"},
                 {5, 0, 1, "5"},
                 {1, -20, 9, "9.53674316e-7"},
                 {1, -16, 30, "0.0000152587890625"},
                 {100, 0, 9, "100"},
                 {100, 0, 2, "1e+2"},
                 {3, -1, 1, "2"}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const uint64_t limb = (uint64_t)abs(cases[i].z);
        const int length = cases[i].z == 0 ? 0 : cases[i].z < 0 ? -1 : 1;
        const algsurf_precise_root r = {{&limb, length}, {NULL, 0}, cases[i].exponent, 0, 1, 1};
        roots_decimals re, im;
        assert_true(roots_digits(&r, cases[i].digits, &re, &im));
        assert_string_equal(re.value, cases[i].text);
        assert_string_equal(im.value, "0");
        roots_digits_free(&re), roots_digits_free(&im);
    }
}
