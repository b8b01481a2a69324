/* test_real_roots.c - algsurf_real_roots_integers against a Sturm chain over GMP's integers; for coefficients
 * that are doubles, the tests of isolate ask it, too.
 *
 * Roots of powers are judged by exact signs beside them.
 *
 * Breaks caught, each tried: ends of a root of q's, neighbours, taken for neighbours of p's, the sign of a
 * coefficient lost, no room for it, limbs beyond the first left out, leading zeros taken for the degree.
 */
#include "isolate_case.h"
#include "roots/line.h"

static isolate_answer answer;

enum { TOP = 24 };

static void random_integer(uint64_t *seed, mpz_t z, int bits) {
    mpz_set_ui(z, 0);
    for (int i = 0; i < bits; i += 8) {
        mpz_mul_2exp(z, z, 8);
        mpz_add_ui(z, z, (unsigned long)random_int(seed, 256));
    }
    if (random_int(seed, 2)) mpz_neg(z, z);
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

TEST(test_random) {
    static const double ends[][2] = {{-INFINITY, INFINITY}, {-1, 1}, {0, INFINITY}, {-3, 0x1p-30}};
    uint64_t seed = 5;
    mpz_t *p = exact_polynomials(1, TOP + 1);
    for (int i = 0; i < 400; i++) {
        int n = 1 + random_int(&seed, 9);
        for (int k = 0; k <= n; k++) random_integer(&seed, p[k], random_int(&seed, 6) ? 8 * (i % 200) : 0);
        if (exact_degree(p, n) < 0) continue;
        isolate_judge_integers(p, n, ends[i % 4][0], ends[i % 4][1], &answer);
    }
    exact_free(p, TOP + 1);
}

/* Rational roots of many digits, some multiple, some 2^-500 apart. */
TEST(test_known) {
    uint64_t seed = 6;
    int multiple = 0, shared = 0;
    mpz_t a, b, *p = exact_polynomials(1, TOP + 1);
    mpz_inits(a, b, NULL);
    for (int i = 0; i < 150; i++) {
        int n = 0;
        mpz_set_ui(p[0], 1);
        for (int roots = 1 + random_int(&seed, 3); roots > 0; roots--) {
            random_integer(&seed, a, 8 + 8 * random_int(&seed, 40));
            random_integer(&seed, b, 8 + 8 * random_int(&seed, 40));
            if (mpz_sgn(b) == 0) continue;
            for (int m = 1 + random_int(&seed, 2); m > 0; m--) n = times_root(p, n, a, b);
            mpz_mul_2exp(a, a, 500), mpz_mul_2exp(b, b, 500), mpz_add_ui(a, a, 1);
            if (random_int(&seed, 2)) n = times_root(p, n, a, b);
        }
        isolate_judge_integers(p, n, -INFINITY, INFINITY, &answer);
        for (int k = 0; k < answer.count; k++) {
            multiple += answer.b[k].multiplicity > 1;
            shared += k > 0 && isolate_same_place(answer.b + k - 1, answer.b + k);
        }
    }
    assert_true(multiple > 100 && shared > 50);
    mpz_clears(a, b, NULL);
    exact_free(p, TOP + 1);
}

/* Roots far below the least double, far above the largest, and both. */
TEST(test_far) {
    mpz_t *p = exact_polynomials(1, 3);
    for (int e = 1000; e < 60000; e *= 3) {
        mpz_set_ui(p[0], 1), mpz_set_si(p[1], -7), mpz_set_ui(p[2], 1);
        mpz_mul_2exp(p[1], p[1], (unsigned long)e);
        isolate_judge_integers(p, 2, -INFINITY, INFINITY, &answer); /* about 2^-e / 7 and 7 2^e */
        isolate_judge_integers(p, 2, 0, 1, &answer);
        isolate_judge_integers(p, 2, 0x1p-1074, 1e308, &answer);
        isolate_judge_integers(p, 2, -1, 0, &answer);
    }
    exact_free(p, 3);
}

/* The form of the coefficients: leading zero limbs, null for 0, a common power of two, negative lengths. */
TEST(test_form) {
    static const uint64_t six[] = {0, 6, 0, 0}, five[] = {0, 5}, one[] = {0, 1, 0}, zero[] = {0, 0};
    const algsurf_integer c[] = {{six, 4}, {five, -2}, {one, 3}, {NULL, 0}, {zero, -2}};
    algsurf_real_root t[4];
    int count = -1;
    assert_ok(algsurf_real_roots_integers(c, 4, -INFINITY, INFINITY, t, 4, &count));
    assert_int_equal(count, 2);
    for (int i = 0; i < 2; i++) {
        assert_true(t[i].root == 2 + i && t[i].lo == 2 + i && t[i].hi == 2 + i);
        assert_true(t[i].multiplicity == 1 && t[i].sign == 1 - 2 * i);
    }
    for (int i = 0; i < 4; i++) { /* of one point */
        const double x[] = {2, 0x1.0000000000001p+1, 0, 3};
        assert_ok(algsurf_real_roots_integers(c, 4, x[i], x[i], t, 4, &count));
        assert_int_equal(count, i % 3 == 0);
        assert_true(!count || (t[0].lo == x[i] && t[0].hi == x[i] && t[0].sign == (i ? -1 : 1)));
    }
    assert_ok(algsurf_real_roots_integers(c, 0, -INFINITY, INFINITY, t, 0, &count));
    assert_int_equal(count, 0);
}

TEST(test_refused) {
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
                     ALGSURF_E_DEGREE);
    assert_int_equal(algsurf_real_roots_integers(good, 2, 1, 0, t, 2, &count), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_real_roots_integers(good, 2, NAN, 0, t, 2, &count), ALGSURF_E_NOT_FINITE);
    assert_int_equal(algsurf_real_roots_integers(good, 2, -9, 9, NULL, 2, &count), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_real_roots_integers(good, 2, -9, 9, t, 2, NULL), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_real_roots_integers(good, 2, -9, 9, t, -1, &count), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_real_roots_integers(good, 2, -9, 9, t, 1, &count), ALGSURF_E_CAPACITY);
    assert_int_equal(count, 77);
    assert_ok(algsurf_real_roots_integers(longest, 1, 0, 1, t, 1, &count));
    assert_true(count == 1 && t[0].lo == 0 && t[0].hi == 0x1p-1074);
}

/* A root of t^m q(t^k), refined: a double that is one, or between neighbours of different signs. */
static void check_final(const double *c, int n, const algsurf_real_root *r) {
    int at_lo = exact_poly_sign(c, n, r->lo), at_hi = exact_poly_sign(c, n, r->hi);
    int final = r->lo == r->hi ? at_lo == 0 : nextafter(r->lo, (double)INFINITY) == r->hi;
    int told = r->lo == r->hi || (at_lo == r->sign && at_hi == -r->sign) || r->multiplicity > 1 ||
               (at_lo == 0 && r->lo == 0) || (at_hi == 0 && r->hi == 0);
    if (final && told && (r->root == r->lo || r->root == r->hi)) return;
    exact_print_doubles("c", c, n + 1);
    fail_msg("degree %d: root %a in [%a, %a], signs %d, %d", n, r->root, r->lo, r->hi, at_lo, at_hi);
}

static void check_power(const double *c, int n, double lo, double hi, int expected) {
    algsurf_real_root t[4];
    int count = -1;
    assert_ok(algsurf_real_roots(c, n, lo, hi, t, 4, &count));
    assert_int_equal(count, expected);
    for (int i = 0; i < count; i++) check_final(c, n, t + i);
}

/* q's root, b / a, is among the subnormal numbers, whose neighbours are far apart in proportion: 0 to 53
 * binary digits of it, and a root below all of them. */
TEST(test_powers_of_subnormals) {
    static const double known[][2] = {{3, 1e-310}, {3, 1e-320}, {0x1p100, 0x1.8p-974}};
    static const int steps[] = {2, 3, 4, 7, 20, 25, 64, 99, 256};
    uint64_t seed = 7;
    for (int i = 0; i < 400; i++) {
        double a = ldexp(1 + fabs(random_unit(&seed)), random_int(&seed, 200) - 100), c[300] = {0};
        double root = ldexp(1 + fabs(random_unit(&seed)), -1022 - random_int(&seed, 53));
        if (a < 1) a = 1 / a;
        double b = i < 3 ? known[i][1] : a * root;
        int k = i < 3 ? 20 : steps[random_int(&seed, 9)], m = i % 4 == 3 ? random_int(&seed, 4) : 0;
        c[m] = i % 2 ? b : -b, c[m + k] = i < 3 ? known[i][0] : a;
        int roots = c[m] < 0 && k % 2 == 0 ? 2 : k % 2, zero = m > 0, above = c[m] < 0;
        check_power(c, m + k, -INFINITY, INFINITY, roots + zero);
        check_power(c, m + k, 0, 1, above + zero);
        check_power(c, m + k, 0x1p-1074, 1e300, above);
    }
}

/* ---- bounds, formulas, boxes: what does not walk ---- */

/* Nothing is cut that holds a root, and p is not 0 at a new end.  Catches: a bound from terms of one sign, a
 * rounded unit, near and far exchanged. */
static void check_cut(const double *c, int n, double lo, double hi) {
    const algsurf_i_coefficients p = {c, NULL, n};
    double end[2] = {lo, hi};
    exact_sturm s = exact_sturm_of_doubles(c, n);
    algsurf_i_cut_far(&p, &end[0], &end[1]);
    if (end[0] <= end[1]) algsurf_i_cut_near(&p, &end[0], &end[1]);
    int all = exact_count_roots(&s, lo, hi),
        kept = end[0] <= end[1] ? exact_count_roots(&s, end[0], end[1]) : 0;
    int clean = end[0] > end[1] || ((end[0] == lo || exact_poly_sign(c, n, end[0]) != 0) &&
                                    (end[1] == hi || exact_poly_sign(c, n, end[1]) != 0));
    exact_sturm_clear(&s);
    if (all == kept && clean) return;
    exact_print_doubles("c", c, n + 1);
    fail_msg("[%a, %a] has %d roots, cut to [%a, %a] %d", lo, hi, all, end[0], end[1], kept);
}

/* Roots just inside and at a bound: t^k = a and (t - a)^k, of all sizes; terms of both signs at random. */
TEST(test_cuts) {
    static const double ends[][2] = {{-INFINITY, INFINITY}, {0, INFINITY}, {0, 2}, {-3, 0}, {-1, 0x1p-1074}};
    uint64_t seed = 8;
    for (int i = 0; i < 1500; i++) {
        int n = 1 + random_int(&seed, 9), wide = i % 3 == 0 ? 1020 : 20;
        double c[10] = {0};
        for (int k = 0; k <= n; k++) c[k] = random_int(&seed, 3) ? random_wide(&seed, -wide, wide) : 0;
        if (i % 4 == 0)
            for (int k = 1; k < n; k++) c[k] = 0;
        if (i % 4 == 1 && wide == 20) {
            double root = ldexp(random_int(&seed, 63) - 31, random_int(&seed, 9) - 4);
            for (int k = 0; k <= n; k++) c[k] = k == 0;
            for (int m = 0; m < n; m++)
                for (int k = m + 1; k >= 0; k--) c[k] = (k > 0 ? c[k - 1] : 0) - root * c[k];
        }
        if (c[0] == 0 || c[n] == 0) continue;
        for (int j = 0; j < 5; j++) check_cut(c, n, ends[j][0], ends[j][1]);
    }
}

/* Roots that are doubles, beside doubles, at an end of the interval and one ulp beside it: degree 1 and 2 by
 * formula, 3 to 24 by boxes, with 0 as a root, and on all kinds of intervals.  Catches: a box's end taken for
 * no root, roots on the wrong side of an end, signs that do not alternate, a root at 0 forgotten. */
TEST(test_ends_at_roots) {
    uint64_t seed = 9;
    for (int i = 0; i < 500; i++) {
        int n = 0, zeros = i % 5 == 4 ? 1 + i % 3 : 0, most = 1 + random_int(&seed, i % 10 == 0 ? 8 : 5);
        double c[30] = {1}, ends[5] = {-INFINITY, INFINITY, 0}, root[16];
        for (int m = 0; m < most; m++) {
            root[m] = (2 * random_int(&seed, 2) - 1) * (m + 1 + 0.25 * random_int(&seed, 4));
            n = isolate_times_root(c, n, 4 * root[m], 4);
        }
        for (int k = n; zeros && k >= 0; k--) c[k + zeros] = c[k];
        for (int k = 0; k < zeros; k++) c[k] = 0;
        ends[3] = root[0], ends[4] = root[most / 2];
        if (i % 2) c[zeros] = nextafter(c[zeros], i % 4 == 1 ? HUGE_VAL : -HUGE_VAL);
        for (int a = 0; a < 5; a++)
            for (int b = 0; b < 5; b++) {
                double lo = ends[a], hi = ends[b];
                if (i % 3 == 1 && isfinite(lo)) lo = nextafter(lo, i % 7 < 3 ? HUGE_VAL : -HUGE_VAL);
                if (lo <= hi) isolate_judge(c, n + zeros, lo, hi, &answer);
            }
    }
}

/* An end at 0, or far beyond the roots, costs no more than one beside them: counted in what the walk looks
 * at.
 */
TEST(test_zero_is_no_place_to_search) {
    static double c[513];
    static algsurf_bracket b[512];
    uint64_t seed = 10;
    for (int n = 8; n <= 512; n *= 2)
        for (int round = 0; round < 3; round++) {
            size_t cells[3];
            int count[3];
            for (int k = 0; k <= n; k++) c[k] = random_unit(&seed);
            static const double lo[] = {1e-300, 0, -0x1p-1074};
            for (int i = 0; i < 3; i++) {
                algsurf_observer o = {.size = sizeof o};
                const algsurf_isolate_options options = {.size = sizeof options, .observer = &o};
                assert_ok(algsurf_isolate_all(c, NULL, n, lo[i], 2, &options, b, 512, count + i));
                cells[i] = o.cells;
            }
            assert_true(count[1] == count[0] && count[2] == count[0]);
            assert_true(cells[1] <= cells[0] + 2 && cells[2] <= cells[0] + 4);
            assert_ok(algsurf_isolate_all(c, NULL, n, 0, 0, NULL, b, 512, count));
            assert_int_equal(count[0], 0);
        }
}
