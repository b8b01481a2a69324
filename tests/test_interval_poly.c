/* test_interval_poly.c - the range of a real polynomial against exact rationals (complex ones:
 * test_cinterval.c).
 *
 * Breaks caught (each tried): a slope shifted by one in the centred form, its middle not taken as a point,
 * Horner's result not met. */
#include "interval_cases.h"
#include "unit.h"

#define SEED 14u

static algsurf_interval horner(const algsurf_interval *c, int n, algsurf_interval x) {
    algsurf_interval y = c[n];
    for (int k = n - 1; k >= 0; k--) y = algsurf_interval_add(algsurf_interval_mul(y, x), c[k]);
    return y;
}

/* Members of the coefficient intervals at points of x lie in the result, which lies in Horner's, is Horner's
 * at points, and is far better for thin arguments. */
TEST(test_poly) {
    uint64_t seed = SEED;
    mpq_t y, x, c;
    mpq_inits(y, x, c, NULL);
    int better = 0;
    for (int i = 0; i < 2500; i++) {
        int n = random_int(&seed, 14), tame = i % 4 != 0;
        algsurf_interval p[14], t = tame ? case_tame(&seed) : case_interval(&seed), h, r = {7, 7};
        for (int k = 0; k <= n; k++) p[k] = tame ? case_tame(&seed) : case_interval(&seed);
        if (tame && i % 2)
            for (int k = 0; k <= n; k++) p[k].hi = p[k].lo;
        assert_ok(algsurf_interval_poly(p, n, t, &r));
        h = horner(p, n, t);
        exact_set(x, case_inside(&seed, t)), mpq_set_ui(y, 0, 1);
        for (int k = n; k >= 0; k--)
            exact_set(c, case_inside(&seed, p[k])), mpq_mul(y, y, x), mpq_add(y, y, c);
        int within = t.lo == t.hi ? r.lo == h.lo && r.hi == h.hi : r.lo >= h.lo && r.hi <= h.hi;
        if (!exact_between(r.lo, y, r.hi) || !within)
            fail_msg("seed %u round %d: degree %d over [%a,%a]: [%a,%a], Horner's [%a,%a]", SEED, i, n, t.lo,
                     t.hi, r.lo, r.hi, h.lo, h.hi);
        better += algsurf_interval_width(r) < algsurf_interval_width(h);
    }
    mpq_clears(y, x, c, NULL);
    assert_true(better > 300);
    /* (x-1)^3 over 1 +- h: the range is +- h^3, Horner's width is above 4 h, this one below 32 h^2 */
    const algsurf_interval cube[] = {{-1, -1}, {3, 3}, {-3, -3}, {1, 1}};
    algsurf_interval r, t = {1 - 0x1p-10, 1 + 0x1p-10};
    assert_ok(algsurf_interval_poly(cube, 3, t, &r));
    assert_true(algsurf_interval_width(horner(cube, 3, t)) > 0x1p-8 && algsurf_interval_width(r) < 0x1p-15);
}

TEST(test_bad_arguments) {
    const algsurf_interval one = {1, 1}, bad[] = {{1, 0}, {NAN, 1}, {0, NAN}, {INFINITY, INFINITY}};
    algsurf_interval r = {7, 8};
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        const algsurf_interval b = bad[i], c[] = {one, b};
        assert_int_equal(algsurf_interval_poly(c, 1, one, &r), ALGSURF_E_ARGUMENT);
        assert_int_equal(algsurf_interval_poly(&one, 0, b, &r), ALGSURF_E_ARGUMENT);
    }
    assert_int_equal(algsurf_interval_poly(NULL, 0, one, &r), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_interval_poly(&one, -1, one, &r), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_interval_poly(&one, ALGSURF_MAX_POLY_DEGREE + 1, one, &r), ALGSURF_E_DEGREE);
    assert_true(r.lo == 7 && r.hi == 8);
    assert_int_equal(algsurf_interval_poly(&one, 0, one, NULL), ALGSURF_E_ARGUMENT);
}
