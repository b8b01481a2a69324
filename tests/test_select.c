/* test_select.c - the least root in a sector, three-valued.
 *
 * Catches: the conjugate range forgotten, an undecided box counted as inside, a smaller undecided root
 * overlooked, conjugates taken for rivals, magnitudes outside [lo,hi] accepted. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>

#include "algsurf/select.h"

static const double pi = 3.141592653589793;

static algsurf_enclosure box(double re_lo, double re_hi, double im_lo, double im_hi) {
    return (algsurf_enclosure){{{re_lo, re_hi}, {im_lo, im_hi}},
                               {0.5 * (re_lo + re_hi), 0.5 * (im_lo + im_hi)},
                               1,
                               im_lo == 0 && im_hi == 0};
}

static algsurf_enclosure near_point(double re, double im) {
    double r = 1e-12 * hypot(re, im), s = im == 0 ? 0 : r;
    return box(re - r, re + r, im - s, im + s);
}

static void check_holds(double sigma, double delta, algsurf_enclosure root, int expected) {
    const algsurf_sector sector = {sigma, delta};
    int holds = 17;
    assert_int_equal(algsurf_sector_holds(&sector, &root, &holds), ALGSURF_OK);
    assert_int_equal(holds, expected);
}

static void test_membership(void **state) {
    (void)state;
    check_holds(0, 1e-10, near_point(2, 0), 1);
    check_holds(0, 1e-10, near_point(-2, 0), 0);
    check_holds(0, pi, near_point(-2, 0), 1);
    check_holds(0, 1e-10, near_point(2, 1e-3), 0);
    check_holds(0, 1e-10, box(2, 2, -1e-9, 1e-9), 2); /* may be real, may be outside */
    check_holds(0, 0.5, near_point(cos(0.3), sin(0.3)), 1);
    check_holds(0, 0.5, near_point(cos(0.3), -sin(0.3)), 1); /* the conjugate range */
    check_holds(0.4, 0.5, near_point(cos(0.3), -sin(0.3)), 0);
    check_holds(0.2, 0.5, near_point(cos(0.3), -sin(0.3)), 1);
    check_holds(0, 0.3, box(cos(0.3) - 1e-9, cos(0.3) + 1e-9, sin(0.3) - 1e-9, sin(0.3) + 1e-9), 2);
    check_holds(2, 1, near_point(-1, 0.5), 1);
    check_holds(0, 1, box(0, 0, 0, 0), 1); /* 0 counts as real and positive */
    check_holds(0.1, 1, box(0, 0, 0, 0), 0);
    check_holds(0, 1, box(-1, 1, -1, 1), 2);
}

static void check_select(const algsurf_enclosure *roots, int count, double lo, double hi,
                         algsurf_selected expected, int which) {
    const algsurf_sector sector = {0, 0.5};
    algsurf_selected selected = ALGSURF_SELECTED_UNDECIDED;
    int index = 99;
    assert_int_equal(algsurf_select(roots, count, &sector, lo, hi, &selected, &index), ALGSURF_OK);
    assert_int_equal(selected, expected);
    assert_int_equal(index, expected == ALGSURF_SELECTED_NONE ? 99 : which);
}

static void test_least(void **state) {
    (void)state;
    const algsurf_enclosure roots[] = {near_point(3, 0), near_point(0.5, 2), near_point(2, 0.4),
                                       near_point(2, -0.4), near_point(-1, 0)};
    check_select(roots, 5, 0, HUGE_VAL, ALGSURF_SELECTED_ONE, 2);
    check_select(roots, 5, 2.5, HUGE_VAL, ALGSURF_SELECTED_ONE, 0);
    check_select(roots, 5, 0, 2.5, ALGSURF_SELECTED_ONE, 2);
    check_select(roots, 5, 0, 1.5, ALGSURF_SELECTED_NONE, 0);
    check_select(roots, 5, 4, 5, ALGSURF_SELECTED_NONE, 0);
    check_select(roots, 2, 0, HUGE_VAL, ALGSURF_SELECTED_ONE, 0);
    check_select(NULL, 0, 0, HUGE_VAL, ALGSURF_SELECTED_NONE, 0);
}

static void test_undecided(void **state) {
    (void)state;
    algsurf_enclosure edge = box(cos(0.5) - 1e-9, cos(0.5) + 1e-9, sin(0.5) - 1e-9, sin(0.5) + 1e-9);
    const algsurf_enclosure smaller[] = {near_point(3, 0), edge};
    check_select(smaller, 2, 0, HUGE_VAL, ALGSURF_SELECTED_UNDECIDED, 1);
    const algsurf_enclosure larger[] = {near_point(0.9, 0), edge};
    check_select(larger, 2, 0, HUGE_VAL, ALGSURF_SELECTED_ONE, 0);
    const algsurf_enclosure overlap[] = {box(1, 1.1, 0, 0), box(1.05, 1.2, 0, 0)};
    check_select(overlap, 2, 0, HUGE_VAL, ALGSURF_SELECTED_UNDECIDED, 0);
    const algsurf_enclosure at_end[] = {box(1, 1.1, 0, 0)};
    check_select(at_end, 1, 1.05, 2, ALGSURF_SELECTED_UNDECIDED, 0);
}

static void test_bad_arguments(void **state) {
    (void)state;
    const algsurf_sector good = {0, 1}, bad[] = {{-1, 1}, {0, -1}, {3, 1}, {NAN, 1}, {0, NAN}};
    const algsurf_enclosure root = near_point(1, 0);
    algsurf_selected selected = ALGSURF_SELECTED_ONE;
    int index = 7, holds = 7;
    for (int i = 0; i < 5; i++) {
        assert_int_equal(algsurf_sector_holds(bad + i, &root, &holds), ALGSURF_E_ARGUMENT);
        assert_int_equal(algsurf_select(&root, 1, bad + i, 0, 1, &selected, &index), ALGSURF_E_ARGUMENT);
    }
    assert_int_equal(algsurf_sector_holds(NULL, &root, &holds), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_sector_holds(&good, NULL, &holds), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_sector_holds(&good, &root, NULL), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_select(NULL, 1, &good, 0, 1, &selected, &index), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_select(&root, -1, &good, 0, 1, &selected, &index), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_select(&root, 1, &good, 2, 1, &selected, &index), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_select(&root, 1, &good, -1, 1, &selected, &index), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_select(&root, 1, &good, NAN, 1, &selected, &index), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_select(&root, 1, &good, 0, 1, NULL, &index), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_select(&root, 1, &good, 0, 1, &selected, NULL), ALGSURF_E_ARGUMENT);
    assert_int_equal(holds, 7);
    assert_int_equal(index, 7);
    assert_int_equal(selected, ALGSURF_SELECTED_ONE);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_membership),
        cmocka_unit_test(test_least),
        cmocka_unit_test(test_undecided),
        cmocka_unit_test(test_bad_arguments),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
