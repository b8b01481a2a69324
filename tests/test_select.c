/* test_select.c - the least root in a sector, three-valued.
 *
 * Catches: the conjugate range forgotten, an undecided box counted as inside, a smaller undecided root
 * overlooked, conjugates taken for rivals, roots of equal enclosures taken for conjugates, magnitudes outside
 * [lo,hi] accepted, the end of a sector rounded. */
#include "algsurf/select.h"
#include "exact_arg.h"
#include "unit.h"

#define SEED 23u

static const double pi = 3.141592653589793;

static algsurf_complex_root box(double re_lo, double re_hi, double im_lo, double im_hi) {
    return (algsurf_complex_root){{{re_lo, re_hi}, {im_lo, im_hi}},
                                  {0.5 * (re_lo + re_hi), 0.5 * (im_lo + im_hi)},
                                  1,
                                  im_lo == 0 && im_hi == 0};
}

static algsurf_complex_root near_point(double re, double im) {
    double r = 1e-12 * hypot(re, im), s = im == 0 ? 0 : r;
    return box(re - r, re + r, im - s, im + s);
}

static void check_holds(double sigma, double delta, algsurf_complex_root root, int expected) {
    const algsurf_sector sector = {sigma, delta};
    int holds = 17;
    assert_ok(algsurf_sector_holds(&sector, &root, &holds));
    assert_int_equal(holds, expected);
}

TEST(test_membership) {
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

/* Where arg is in a sector: 1, or 0. */
static int truth_of(const algsurf_sector *sector, const mpf_t arg) {
    mpf_t end, delta;
    mpf_inits(end, delta, NULL);
    mpf_set_d(end, sector->sigma), mpf_set_d(delta, sector->delta), mpf_add(end, end, delta);
    int in = mpf_cmp_d(arg, sector->sigma) >= 0 && mpf_cmp(arg, end) <= 0;
    mpf_clears(end, delta, NULL);
    return in;
}

static int held(const algsurf_sector *sector, double re, double im) {
    const algsurf_complex_root root = box(re, re, im, im);
    int holds = 17;
    assert_ok(algsurf_sector_holds(sector, &root, &holds));
    return holds;
}

/* A sector for a point of argument arg > 0: arg is an end of it, up to some units in the last place. */
static algsurf_sector sector_at(uint64_t *seed, double arg, int at_begin) {
    double from = arg * fabs(random_unit(seed)), shift = 0x1p-52 * (random_int(seed, 9) - 4);
    if (at_begin) return (algsurf_sector){arg * (1 + shift), 0.25 * (pi - arg)};
    return (algsurf_sector){from, (arg - from) * (1 + 0.5 * shift)};
}

/* Points of an argument next to an end of the sector, on which side only exact sums tell. */
TEST(test_ends) {
    uint64_t seed = SEED;
    int seen[3] = {0, 0, 0}, rounded_in = 0, rounded_out = 0;
    mpf_set_default_prec(384);
    mpf_t arg;
    mpf_init(arg);
    for (int i = 0; i < 20000; i++) {
        double re = random_wide(&seed, -2, 2), im = fabs(random_wide(&seed, -2, 2));
        if (i % 4 == 3) im = ldexp(im, -random_int(&seed, 70));
        exact_argument(arg, re, im, 0);
        algsurf_sector sector = sector_at(&seed, mpf_get_d(arg), i % 8 == 7);
        double end = sector.sigma + sector.delta;
        if (end >= pi) continue; /* stands for pi: test_pi */
        int in = truth_of(&sector, arg), holds = held(&sector, re, im);
        if (holds != held(&sector, re, -im) || (holds == 1 && !in) || (holds == 0 && in))
            fail_msg("seed %u round %d: %a + i %a in {%a, %a}: %d, not %d", SEED, i, re, im, sector.sigma,
                     sector.delta, holds, in);
        seen[holds]++;
        rounded_in += !in && mpf_cmp_d(arg, sector.sigma) >= 0 && mpf_cmp_d(arg, end) <= 0;
        rounded_out += in && mpf_cmp_d(arg, end) > 0;
    }
    assert_true(seen[0] > 1000 && seen[1] > 1000 && seen[2] > 1000 && seen[2] < 12000);
    assert_true(rounded_in > 300 && rounded_out > 300);
    const algsurf_sector known = {0x1.8a77d5895888cp-1, 0x1.2550104c9e5b3p-3}; /* 3.4e-18 beyond the end */
    assert_true(held(&known, 0x1.471c3e531ba1fp+0, 0x1.a7fb6d6c38f88p+0) != 1);
    mpf_clear(arg);
}

/* A sum that rounds to pi's double stands for pi. */
TEST(test_pi) {
    static const algsurf_sector ends_at_pi[] = {{0, 0x1.921fb54442d18p+1},
                                                {0, 0x1.921fb54442d19p+1},
                                                {0x1.921fb54442d17p+0, 0x1.921fb54442d18p+0},
                                                {0x1.921fb54442d18p+1, 0}};
    static const algsurf_sector below = {0, 0x1.921fb54442d17p+1};
    for (int i = 0; i < 4; i++) {
        assert_int_equal(held(ends_at_pi + i, -1, 0), 1);
        if (i < 3) assert_int_equal(held(ends_at_pi + i, -1, 0x1p-1074), 1);
        if (i < 3) assert_int_equal(held(ends_at_pi + i, -1, -0x1p-60), 1);
    }
    assert_int_equal(held(&below, -1, 0), 0);
    assert_int_equal(held(&below, -1, 0x1p-60), 0);
    assert_int_equal(held(&below, -1, -0x1p-40), 1);
}

static void check_select(const algsurf_complex_root *roots, int count, double lo, double hi, int expected,
                         int which) {
    const algsurf_sector sector = {0, 0.5};
    int selected = ALGSURF_SELECTED_UNDECIDED;
    int index = 99;
    assert_ok(algsurf_select_of_real(roots, count, &sector, lo, hi, &selected, &index));
    assert_int_equal(selected, expected);
    assert_int_equal(index, expected == ALGSURF_SELECTED_NONE ? 99 : which);
}

TEST(test_least) {
    const algsurf_complex_root roots[] = {near_point(3, 0), near_point(0.5, 2), near_point(2, 0.4),
                                          near_point(2, -0.4), near_point(-1, 0)};
    check_select(roots, 5, 0, HUGE_VAL, ALGSURF_SELECTED_ONE, 2);
    check_select(roots, 5, 2.5, HUGE_VAL, ALGSURF_SELECTED_ONE, 0);
    check_select(roots, 5, 0, 2.5, ALGSURF_SELECTED_ONE, 2);
    check_select(roots, 5, 0, 1.5, ALGSURF_SELECTED_NONE, 0);
    check_select(roots, 5, 4, 5, ALGSURF_SELECTED_NONE, 0);
    check_select(roots, 2, 0, HUGE_VAL, ALGSURF_SELECTED_ONE, 0);
    check_select(NULL, 0, 0, HUGE_VAL, ALGSURF_SELECTED_NONE, 0);
}

TEST(test_undecided) {
    algsurf_complex_root edge = box(cos(0.5) - 1e-9, cos(0.5) + 1e-9, sin(0.5) - 1e-9, sin(0.5) + 1e-9);
    const algsurf_complex_root smaller[] = {near_point(3, 0), edge};
    check_select(smaller, 2, 0, HUGE_VAL, ALGSURF_SELECTED_UNDECIDED, 1);
    const algsurf_complex_root larger[] = {near_point(0.9, 0), edge};
    check_select(larger, 2, 0, HUGE_VAL, ALGSURF_SELECTED_ONE, 0);
    const algsurf_complex_root overlap[] = {box(1, 1.1, 0, 0), box(1.05, 1.2, 0, 0)};
    check_select(overlap, 2, 0, HUGE_VAL, ALGSURF_SELECTED_UNDECIDED, 0);
    const algsurf_complex_root at_end[] = {box(1, 1.1, 0, 0)};
    check_select(at_end, 1, 1.05, 2, ALGSURF_SELECTED_UNDECIDED, 0);
}

typedef algsurf_status selector(const algsurf_complex_root *, int, const algsurf_sector *, double, double,
                                int *, int *);

static int selected_by(selector *by, const algsurf_complex_root *roots, int count, double delta, int *index) {
    const algsurf_sector sector = {0, delta};
    int selected = ALGSURF_SELECTED_NONE;
    assert_ok(by(roots, count, &sector, 0, HUGE_VAL, &selected, index));
    return selected;
}

static selector *const selectors[2] = {algsurf_select, algsurf_select_of_real};

/* Of the roots of t^2 + 2^-k t - 1 the positive one is the smaller, by 2^-k. */
TEST(test_real_rivals) {
    int decided = 0;
    for (int k = 1; k <= 1074; k++) {
        const double c[3] = {-1, ldexp(1, -k), 1};
        algsurf_complex_root roots[2];
        int count, index = 99;
        assert_ok(algsurf_complex_roots_of_real(c, NULL, 2, roots, &count));
        assert_int_equal(count, 2);
        for (int i = 0; i < 2; i++) {
            int selected = selected_by(selectors[i], roots, 2, pi, &index);
            assert_true(selected != ALGSURF_SELECTED_NONE);
            if (selected != ALGSURF_SELECTED_ONE) continue;
            decided++;
            if (roots[index].root.re < 0)
                fail_msg("k = %d: the larger root, in [%a,%a]", k, roots[index].box.re.lo,
                         roots[index].box.re.hi);
        }
    }
    assert_true(decided > 2 * 40);
}

/* (t - 1 - i) (t - (1 - i) (1 + 2^-k)): of complex coefficients, all exact; 1 + i is the smaller root. */
TEST(test_near_conjugates) {
    int decided = 0;
    for (int k = 1; k <= 51; k++) {
        double e = ldexp(1, -k);
        const algsurf_complex c[3] = {{2 + 2 * e, 0}, {-(2 + e), e}, {1, 0}};
        algsurf_complex_root roots[2];
        int count, index = 99;
        assert_ok(algsurf_complex_roots(c, NULL, 2, roots, &count));
        assert_int_equal(count, 2);
        int selected = selected_by(algsurf_select, roots, 2, pi, &index);
        assert_true(selected != ALGSURF_SELECTED_NONE);
        if (selected != ALGSURF_SELECTED_ONE) continue;
        decided++;
        if (roots[index].root.im < 0) fail_msg("k = %d: the larger root", k);
    }
    assert_true(decided > 40);
}

/* Boxes that look alike are no proof: only those of a real polynomial, off the axis, mirror a root. */
TEST(test_alike) {
    const algsurf_complex_root upper = box(1, 1.1, 1, 1.1), lower = box(1, 1.1, -1.1, -1),
                               other = box(1, 1.1, -1.2, -1);
    const algsurf_complex_root right = box(1, 1.1, 0, 0), left = box(-1.1, -1, 0, 0),
                               axis = box(1, 1.1, -1, 1);
    const struct {
        algsurf_complex_root roots[2];
        int any, real;
    } cases[] = {
        {{upper, lower}, ALGSURF_SELECTED_UNDECIDED, ALGSURF_SELECTED_ONE},
        {{lower, upper}, ALGSURF_SELECTED_UNDECIDED, ALGSURF_SELECTED_ONE},
        {{upper, other}, ALGSURF_SELECTED_UNDECIDED, ALGSURF_SELECTED_UNDECIDED},
        {{upper, upper}, ALGSURF_SELECTED_UNDECIDED, ALGSURF_SELECTED_UNDECIDED},
        {{right, left}, ALGSURF_SELECTED_UNDECIDED, ALGSURF_SELECTED_UNDECIDED},
        {{right, right}, ALGSURF_SELECTED_UNDECIDED, ALGSURF_SELECTED_UNDECIDED},
        {{axis, axis}, ALGSURF_SELECTED_UNDECIDED, ALGSURF_SELECTED_UNDECIDED},
        {{box(3, 3, 4, 4), box(-4, -4, 3, 3)},
         ALGSURF_SELECTED_ONE,
         ALGSURF_SELECTED_ONE}, /* none is smaller */
        {{upper, box(-3, -2, 0, 0)}, ALGSURF_SELECTED_ONE, ALGSURF_SELECTED_ONE},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        int index = 99;
        assert_int_equal(selected_by(algsurf_select, cases[i].roots, 2, pi, &index), cases[i].any);
        assert_int_equal(index, 0);
        assert_int_equal(selected_by(algsurf_select_of_real, cases[i].roots, 2, pi, &index), cases[i].real);
        assert_int_equal(index, 0);
    }
    /* a third root as large as a pair's may be */
    const algsurf_complex_root three[] = {upper, lower, box(-1.1, -1, 1, 1.1)};
    int index = 99;
    assert_int_equal(selected_by(algsurf_select_of_real, three, 3, pi, &index), ALGSURF_SELECTED_UNDECIDED);
}

TEST(test_bad_arguments) {
    const algsurf_sector good = {0, 1}, bad[] = {{-1, 1}, {0, -1}, {3, 1}, {NAN, 1}, {0, NAN}};
    const algsurf_complex_root root = near_point(1, 0);
    int selected = ALGSURF_SELECTED_ONE;
    int index = 7, holds = 7;
    for (int i = 0; i < 5; i++) {
        algsurf_status why = i < 3 ? ALGSURF_E_ARGUMENT : ALGSURF_E_NOT_FINITE;
        assert_int_equal(algsurf_sector_holds(bad + i, &root, &holds), why);
        assert_int_equal(algsurf_select(&root, 1, bad + i, 0, 1, &selected, &index), why);
    }
    assert_int_equal(algsurf_sector_holds(NULL, &root, &holds), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_sector_holds(&good, NULL, &holds), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_sector_holds(&good, &root, NULL), ALGSURF_E_ARGUMENT);
    for (int i = 0; i < 2; i++) {
        selector *by = selectors[i];
        assert_int_equal(by(NULL, 1, &good, 0, 1, &selected, &index), ALGSURF_E_ARGUMENT);
        assert_int_equal(by(&root, -1, &good, 0, 1, &selected, &index), ALGSURF_E_ARGUMENT);
        assert_int_equal(by(&root, 1, &good, 2, 1, &selected, &index), ALGSURF_E_ARGUMENT);
        assert_int_equal(by(&root, 1, &good, -1, 1, &selected, &index), ALGSURF_E_ARGUMENT);
        assert_int_equal(by(&root, 1, &good, NAN, 1, &selected, &index), ALGSURF_E_NOT_FINITE);
        assert_int_equal(by(&root, 1, &good, 0, 1, NULL, &index), ALGSURF_E_ARGUMENT);
        assert_int_equal(by(&root, 1, &good, 0, 1, &selected, NULL), ALGSURF_E_ARGUMENT);
    }
    assert_int_equal(holds, 7);
    assert_int_equal(index, 7);
    assert_int_equal(selected, ALGSURF_SELECTED_ONE);
}
