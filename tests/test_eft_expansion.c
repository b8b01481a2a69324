/* test_eft_expansion.c - exact sums and products, the signs computed with them, and the double-double
 * refiner, against rational arithmetic.
 *
 * Breaks caught, each tried: zero components kept (the last is not the largest), `exact` kept where a product
 * underflowed, or not taken over from a factor, a coefficient skipped, a refiner that stops at double
 * precision.
 */
#include <float.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include "exact_ray.h"

#include <cmocka.h>

#include "base/expansion.h"
#include "rays/expand_impl.h"
#include "poly/exact.h"
#include "roots/refine_dd.h"

#define SEED 31u

static void value_of(mpq_t value, const algsurf_i_expansion *e) {
    mpq_t x;
    mpq_init(x);
    mpq_set_ui(value, 0, 1);
    for (int i = 0; i < e->count; i++) exact_set(x, e->x[i]), mpq_add(value, value, x);
    mpq_clear(x);
}

/* If it claims to be exact: the value, and the form that makes the last component tell the sign. */
static void judge(const algsurf_i_expansion *e, const mpq_t wanted, int round) {
    assert_int_equal(algsurf_i_expansion_sign(e), e->exact ? mpq_sgn(wanted) : ALGSURF_SIGN_UNKNOWN);
    assert_in_range(e->count, 0, ALGSURF_EXPANSION_SIZE);
    if (!e->exact) return;
    mpq_t value;
    mpq_init(value);
    value_of(value, e);
    for (int i = 0; i < e->count; i++) {
        assert_true(e->x[i] != 0);
        if (i > 0 && !(fabs(e->x[i - 1]) < fabs(e->x[i]))) fail_msg("seed %u round %d: order", SEED, round);
    }
    if (!mpq_equal(value, wanted)) {
        exact_print_doubles("components", e->x, e->count), exact_print("wanted", wanted);
        fail_msg("seed %u round %d: another value", SEED, round);
    }
    mpq_clear(value);
}

static void test_sums_and_products(void **state) {
    (void)state;
    uint64_t seed = SEED;
    mpq_t value, other, x, y;
    mpq_inits(value, other, x, y, NULL);
    for (int i = 0; i < 400; i++) {
        algsurf_i_expansion e, f;
        int range = i % 4 == 0 ? 400 : i % 4 == 1 ? 2 : 60;
        double a = exact_random_wide(&seed, -range, range), b;
        algsurf_i_expansion_set(&e, a), exact_set(value, a);
        algsurf_i_expansion_set(&f, 0), exact_set(other, 0);
        for (int k = 0; k < 12; k++) {
            a = exact_random_wide(&seed, -range, range), b = exact_random_wide(&seed, -range, range);
            exact_set(x, a), exact_set(y, b);
            switch (exact_random_int(&seed, 5)) {
            case 0:
                algsurf_i_expansion_add_double(&e, a), mpq_add(value, value, x);
                break;
            case 1:
                algsurf_i_expansion_add_product(&e, a, b), mpq_mul(x, x, y), mpq_add(value, value, x);
                break;
            case 2:
                algsurf_i_expansion_add_double(&f, a), mpq_add(other, other, x);
                break;
            case 3:
                algsurf_i_expansion_add(&e, &f), mpq_add(value, value, other);
                break;
            default:
                if (e.count * f.count < 300)
                    algsurf_i_expansion_multiply(&e, &f), mpq_mul(value, value, other);
            }
            judge(&e, value, i), judge(&f, other, i);
            if (range <= 60 && k < 8) assert_true(f.exact);
        }
    }
    mpq_clears(value, other, x, y, NULL);
}

static void test_cancellation_and_zero(void **state) {
    (void)state;
    algsurf_i_expansion e;
    algsurf_i_expansion_set(&e, 0);
    assert_int_equal(algsurf_i_expansion_sign(&e), 0);
    algsurf_i_expansion_add_double(&e, 0x1p1000), algsurf_i_expansion_add_double(&e, 0x1p-1074);
    algsurf_i_expansion_add_double(&e, -0x1p1000);
    assert_int_equal(algsurf_i_expansion_sign(&e), 1);
    assert_int_equal(e.count, 1);
    algsurf_i_expansion_add_double(&e, -0x1p-1074);
    assert_int_equal(algsurf_i_expansion_sign(&e), 0);
    algsurf_i_expansion_add_product(&e, 1 + 0x1p-52, 1 - 0x1p-52), algsurf_i_expansion_add_double(&e, -1);
    assert_int_equal(algsurf_i_expansion_sign(&e), -1);
    algsurf_i_expansion_add_product(&e, 0x1p-52, 0x1p-52);
    assert_int_equal(algsurf_i_expansion_sign(&e), 0);
}

static void test_range(void **state) {
    (void)state;
    static const double pairs[][2] = {
        {0x1p-600, 0x1.8p-500}, {0x1p600, 0x1p600}, {0x1.fp-1040, 0x1.1p-30}, {DBL_MAX, 2}};
    algsurf_i_expansion e;
    for (size_t i = 0; i < sizeof pairs / sizeof pairs[0]; i++) {
        algsurf_i_expansion_set(&e, 1);
        algsurf_i_expansion_add_product(&e, pairs[i][0], pairs[i][1]);
        assert_int_equal(algsurf_i_expansion_sign(&e), ALGSURF_SIGN_UNKNOWN);
    }
    algsurf_i_expansion_set(&e, DBL_MAX), algsurf_i_expansion_add_double(&e, DBL_MAX);
    assert_int_equal(algsurf_i_expansion_sign(&e), ALGSURF_SIGN_UNKNOWN);
    algsurf_i_expansion_set(&e, 1), algsurf_i_expansion_add_product(&e, 0, 0x1p-1074);
    assert_int_equal(algsurf_i_expansion_sign(&e), 1);
}

/* More components than there is room for: not exact any more, and within the array. */
static void test_room(void **state) {
    (void)state;
    struct {
        algsurf_i_expansion e;
        double guard[4];
    } room = {.guard = {7, 7, 7, 7}};
    algsurf_i_expansion_set(&room.e, 0);
    for (int i = 0; i < 33; i++) algsurf_i_expansion_add_double(&room.e, ldexp(1, 60 * i - 1000));
    for (int i = 0; i < 400; i++)
        algsurf_i_expansion_add_product(&room.e, ldexp(1, 5 * i - 950), 1 + 0x1p-26);
    assert_true(room.e.count <= ALGSURF_EXPANSION_SIZE);
    for (int i = 0; i < 4; i++) assert_true(room.guard[i] == 7);
}

static void test_polynomial_sign(void **state) {
    (void)state;
    uint64_t seed = SEED;
    int known = 0, rounds = 2000;
    for (int i = 0; i < rounds; i++) {
        double c[21];
        int n = exact_random_int(&seed, 21), wide = i % 5 == 0;
        for (int k = 0; k <= n; k++) c[k] = exact_random_wide(&seed, wide ? -80 : -3, wide ? 80 : 3);
        double x = exact_random_wide(&seed, -10, 3);
        int sign = algsurf_i_poly_exact_sign(c, n, x);
        if (sign != ALGSURF_SIGN_UNKNOWN && sign != exact_poly_sign(c, n, x)) {
            exact_print_doubles("c", c, n + 1);
            fail_msg("seed %u round %d: sign %d at %a", SEED, i, sign, x);
        }
        known += sign != ALGSURF_SIGN_UNKNOWN;
    }
    assert_true(known > rounds * 85 / 100);
    const double c[] = {-5, 14, -13, 4}; /* (x-1)^2 (4x-5) */
    assert_int_equal(algsurf_i_poly_exact_sign(c, 3, 1), 0);
    assert_int_equal(algsurf_i_poly_exact_sign(c, 3, 1.25), 0);
    assert_int_equal(algsurf_i_poly_exact_sign(c, 3, nextafter(1, 2)), -1);
    assert_int_equal(algsurf_i_poly_exact_sign(c, 3, nextafter(1, 0)), -1);
    assert_int_equal(algsurf_i_poly_exact_sign(c, 3, nextafter(1.25, 2)), 1);
}

/* p in double-double in the bracket of one root: as near as its condition lets double-double tell. */
static void test_refine_dd(void **state) {
    (void)state;
    algsurf_dd c[6];
    const double p[] = {-2, 0, 1}, q[] = {-1, 3, 0, 0, 0, 1};
    for (int k = 0; k <= 5; k++) c[k] = algsurf_dd_from(k < 3 ? p[k] : 0);
    mpq_t value, x;
    mpq_inits(value, x, NULL);
    algsurf_dd root = algsurf_i_refine_dd(c, 2, algsurf_dd_from(0), algsurf_dd_from(2), -1);
    exact_set2(x, root.hi, root.lo), exact_poly(value, p, 2, x);
    assert_true(fabs(mpq_get_d(value)) < 0x1p-98);
    for (int k = 0; k <= 5; k++) c[k] = algsurf_dd_from(q[k]);
    root = algsurf_i_refine_dd(c, 5, algsurf_dd_from(-10), algsurf_dd_from(10), -1);
    exact_set2(x, root.hi, root.lo), exact_poly(value, q, 5, x);
    assert_true(fabs(mpq_get_d(value)) < 0x1p-98);
    const double triple[] = {-1, 3, -3, 1};
    for (int k = 0; k <= 3; k++) c[k] = algsurf_dd_from(triple[k]);
    root = algsurf_i_refine_dd(c, 3, algsurf_dd_from(0), algsurf_dd_from(3), -1);
    assert_true(fabs(root.hi - 1) < 1e-9);
    c[1] = c[2] = c[3] = algsurf_dd_from(0), c[0] = algsurf_dd_from(-0x1p-60), c[1] = algsurf_dd_from(1);
    root = algsurf_i_refine_dd(c, 1, algsurf_dd_from(-1), algsurf_dd_from(1), -1);
    assert_true(fabs(root.hi - 0x1p-60) < 0x1p-160);
    mpq_clears(value, x, NULL);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_sums_and_products),
        cmocka_unit_test(test_cancellation_and_zero),
        cmocka_unit_test(test_range),
        cmocka_unit_test(test_room),
        cmocka_unit_test(test_polynomial_sign),
        cmocka_unit_test(test_refine_dd),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
