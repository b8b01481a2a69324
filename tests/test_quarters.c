/* test_quarters.c - the parts of an interval that can have roots, against a Sturm chain over integers.
 *
 * Breaks caught, each tried: variations of the wrong side; the sign of the polynomial in reverse; a part that
 * is cut and taken for whole; a part left out that has two variations. */
#include "isolate_case.h"

#include "roots/quarters.h"

#define SEED 77u

static void check(const double *c, int n, double lo, double hi, int *single) {
    const algsurf_i_coefficients p = {c, NULL, n};
    algsurf_i_part part[ALGSURF_I_PARTS];
    int count = algsurf_i_parts_of(&p, lo, hi, part, NULL), inside = 0;
    exact_sturm s = exact_sturm_of_doubles(c, n);
    for (int i = 0; i < count; i++) {
        int roots = exact_count_roots(&s, part[i].lo, part[i].hi);
        assert_true(part[i].lo >= (i ? part[i - 1].hi : lo) && part[i].lo <= part[i].hi && part[i].hi <= hi);
        inside += roots;
        if (part[i].sign == 0) continue;
        assert_int_equal(roots, 1);
        assert_int_equal(exact_poly_sign(c, n, part[i].lo), part[i].sign);
        assert_int_equal(exact_poly_sign(c, n, part[i].hi), -part[i].sign);
        ++*single;
    }
    assert_int_equal(
        inside, exact_count_roots(&s, lo, hi)); /* neither end of a part that has a neighbour is a root */
    exact_sturm_clear(&s);
}

static void test_random(void **state) {
    (void)state;
    uint64_t seed = SEED;
    int single = 0;
    for (int i = 0; i < 600; i++) {
        int n = 14 + exact_random_int(&seed, 8), scale = exact_random_int(&seed, 7) - 3, odds = 1 + i % 5;
        double c[22], lo = -INFINITY, hi = INFINITY;
        for (int k = 0; k <= n; k++) {
            int size = 1 + exact_random_int(&seed, 9), negative = exact_random_int(&seed, odds + 1) == 0;
            c[k] = ldexp(negative ? -size : size, -k * scale);
            if (i % 7 == 0 && k % 2) c[k] = -c[k];
        }
        if (i % 2) lo = ldexp(exact_random_int(&seed, 7) - 4, scale - 1);
        if (i % 3 == 0) hi = fmax(lo, 0) + ldexp(exact_random_int(&seed, 5), scale - 1);
        check(c, n, lo, hi, &single);
    }
    assert_true(single > 300);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_random)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
