/* test_real_roots.c - algsurf_real_roots_integers against a Sturm chain over GMP's integers; for coefficients
 * that are doubles, the tests of isolate ask it, too.
 *
 * Breaks caught, each tried: the sign of a coefficient lost, no room for it, limbs beyond the first left out,
 * leading zeros taken for the degree.
 */
#include "isolate_case.h"

static isolate_answer answer;

enum { TOP = 24 };

static void random_integer(uint64_t *seed, mpz_t z, int bits) {
    mpz_set_ui(z, 0);
    for (int i = 0; i < bits; i += 8) {
        mpz_mul_2exp(z, z, 8);
        mpz_add_ui(z, z, (unsigned long)exact_random_int(seed, 256));
    }
    if (exact_random_int(seed, 2)) mpz_neg(z, z);
}

/* Multiplies p, of degree n, by b x - a; returns n + 1. */
static int times_root(mpz_t *p, int n, mpz_t a, mpz_t b) {
    mpz_set_ui(p[n + 1], 0);
    for (int k = n + 1; k >= 0; k--) {
        mpz_mul(p[k], p[k], a);
        mpz_neg(p[k], p[k]);
        if (k > 0) mpz_addmul(p[k], b, p[k - 1]);
    }
    return n + 1;
}

static void test_random(void **state) {
    (void)state;
    static const double ends[][2] = {{-INFINITY, INFINITY}, {-1, 1}, {0, INFINITY}, {-3, 0x1p-30}};
    uint64_t seed = 5;
    mpz_t *p = isolate_integers(TOP + 1);
    for (int i = 0; i < 600; i++) {
        int n = 1 + exact_random_int(&seed, 9);
        for (int k = 0; k <= n; k++)
            random_integer(&seed, p[k], exact_random_int(&seed, 6) ? 8 * (i % 200) : 0);
        if (exact_degree(p, n) < 0) continue;
        isolate_judge_integers(p, n, ends[i % 4][0], ends[i % 4][1], &answer);
    }
    isolate_integers_clear(p, TOP + 1);
}

/* Rational roots of many digits, some multiple, some 2^-500 apart. */
static void test_known(void **state) {
    (void)state;
    uint64_t seed = 6;
    int multiple = 0, shared = 0;
    mpz_t a, b, *p = isolate_integers(TOP + 1);
    mpz_inits(a, b, NULL);
    for (int i = 0; i < 150; i++) {
        int n = 0;
        mpz_set_ui(p[0], 1);
        for (int roots = 1 + exact_random_int(&seed, 3); roots > 0; roots--) {
            random_integer(&seed, a, 8 + 8 * exact_random_int(&seed, 40));
            random_integer(&seed, b, 8 + 8 * exact_random_int(&seed, 40));
            if (mpz_sgn(b) == 0) continue;
            for (int m = 1 + exact_random_int(&seed, 2); m > 0; m--) n = times_root(p, n, a, b);
            mpz_mul_2exp(a, a, 500), mpz_mul_2exp(b, b, 500), mpz_add_ui(a, a, 1);
            if (exact_random_int(&seed, 2)) n = times_root(p, n, a, b);
        }
        isolate_judge_integers(p, n, -INFINITY, INFINITY, &answer);
        for (int k = 0; k < answer.count; k++) {
            multiple += answer.b[k].multiplicity > 1;
            shared += k > 0 && isolate_same_place(answer.b + k - 1, answer.b + k);
        }
    }
    assert_true(multiple > 100 && shared > 50);
    mpz_clears(a, b, NULL);
    isolate_integers_clear(p, TOP + 1);
}

/* Roots far below the least double, far above the largest, and both. */
static void test_far(void **state) {
    (void)state;
    mpz_t *p = isolate_integers(3);
    for (int e = 1000; e < 60000; e *= 3) {
        mpz_set_ui(p[0], 1), mpz_set_si(p[1], -7), mpz_set_ui(p[2], 1);
        mpz_mul_2exp(p[1], p[1], (unsigned long)e);
        isolate_judge_integers(p, 2, -INFINITY, INFINITY, &answer); /* about 2^-e / 7 and 7 2^e */
        isolate_judge_integers(p, 2, 0, 1, &answer);
        isolate_judge_integers(p, 2, 0x1p-1074, 1e308, &answer);
        isolate_judge_integers(p, 2, -1, 0, &answer);
    }
    isolate_integers_clear(p, 3);
}

/* The form of the coefficients: leading zero limbs, null for 0, a common power of two, negative lengths. */
static void test_form(void **state) {
    (void)state;
    static const uint64_t six[] = {0, 6, 0, 0}, five[] = {0, 5}, one[] = {0, 1, 0}, zero[] = {0, 0};
    const algsurf_integer c[] = {{six, 4}, {five, -2}, {one, 3}, {NULL, 0}, {zero, -2}};
    algsurf_real_root t[4];
    int count = -1;
    assert_int_equal(algsurf_real_roots_integers(c, 4, -INFINITY, INFINITY, t, 4, &count), ALGSURF_OK);
    assert_int_equal(count, 2);
    for (int i = 0; i < 2; i++) {
        assert_true(t[i].root == 2 + i && t[i].lo == 2 + i && t[i].hi == 2 + i);
        assert_true(t[i].multiplicity == 1 && t[i].sign == 1 - 2 * i);
    }
    assert_int_equal(algsurf_real_roots_integers(c, 0, -INFINITY, INFINITY, t, 0, &count), ALGSURF_OK);
    assert_int_equal(count, 0);
}

static void test_refused(void **state) {
    (void)state;
    static const uint64_t limb[ALGSURF_MAX_LIMBS + 1] = {[0] = 1, [ALGSURF_MAX_LIMBS] = 1};
    const algsurf_integer good[] = {{limb, -1}, {limb, 1}, {limb, 1}}, zero[] = {{limb + 1, 2}, {NULL, 0}};
    const algsurf_integer bad[][2] = {{{limb, ALGSURF_MAX_LIMBS + 1}, {limb, 1}},
                                      {{limb, 1}, {limb, -ALGSURF_MAX_LIMBS - 1}},
                                      {{limb, 1}, {limb, INT32_MIN}},
                                      {{NULL, 1}, {limb, 1}}};
    const algsurf_integer longest[] = {{limb, -1}, {limb + 1, ALGSURF_MAX_LIMBS}};
    algsurf_real_root t[2];
    int count = 77;
    for (int i = 0; i < 4; i++)
        assert_int_equal(algsurf_real_roots_integers(bad[i], 1, 0, 1, t, 2, &count), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_real_roots_integers(zero, 1, 0, 1, t, 2, &count), ALGSURF_E_ZERO);
    assert_int_equal(algsurf_real_roots_integers(NULL, 1, 0, 1, t, 2, &count), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_real_roots_integers(good, -1, 0, 1, t, 2, &count), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_real_roots_integers(good, ALGSURF_MAX_POLY_DEGREE + 1, 0, 1, t, 2, &count),
                     ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_real_roots_integers(good, 2, 1, 0, t, 2, &count), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_real_roots_integers(good, 2, NAN, 0, t, 2, &count), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_real_roots_integers(good, 2, -9, 9, NULL, 2, &count), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_real_roots_integers(good, 2, -9, 9, t, 2, NULL), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_real_roots_integers(good, 2, -9, 9, t, -1, &count), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_real_roots_integers(good, 2, -9, 9, t, 1, &count), ALGSURF_E_ARGUMENT);
    assert_int_equal(count, 77);
    assert_int_equal(algsurf_real_roots_integers(longest, 1, 0, 1, t, 1, &count), ALGSURF_OK);
    assert_true(count == 1 && t[0].lo == 0 && t[0].hi == 0x1p-1074);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_random), cmocka_unit_test(test_known),   cmocka_unit_test(test_far),
        cmocka_unit_test(test_form),   cmocka_unit_test(test_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
