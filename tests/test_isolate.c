/* test_isolate.c - isolate against a Sturm chain over integers, for polynomials made at random or of known
 * roots, and what is refused.
 *
 * Breaks caught, each tried: no bound on the Bernstein form, signs used inside their bound, the far piece of
 * the line left out, the exact test of an end or the zero at 0 left out, a bracket rounded inward, a bracket
 * whose signs at the ends are not looked at, a bracket that ends on another root, a solver that never
 * decides.
 */
#include "isolate_case.h"

#define SEED 11u

static isolate_answer answer;

/* ---- random polynomials ---- */

typedef struct family {
    const char *name;
    int rounds, most_degree;
    int low, high; /* binary exponents of coefficients; low = high = 0: small integers */
} family;

static void random_coefficients(uint64_t *seed, const family *f, double *c, int n) {
    for (int k = 0; k <= n; k++)
        c[k] = f->low < f->high ? random_wide(seed, f->low, f->high) : random_int(seed, 7) - 3;
    if (c[n] == 0) c[n] = 1;
}

static void random_interval(uint64_t *seed, double *lo, double *hi) {
    double a = random_unit(seed) * 3, b = random_unit(seed) * 3;
    *lo = fmin(a, b), *hi = fmax(a, b);
    switch (random_int(seed, 9)) {
    case 0:
        *hi = INFINITY;
        break;
    case 1:
        *lo = -INFINITY;
        break;
    case 2:
        *lo = -INFINITY, *hi = INFINITY;
        break;
    case 3:
        *hi = nextafter(*lo, INFINITY);
        break;
    case 4:
        *hi = *lo + 0x1p-40;
        break;
    case 5:
        *lo = 1e6, *hi = 1e9;
        break;
    case 6:
        *lo = -1e290, *hi = -1e200;
        break;
    case 7:
        *lo = -0x1p-1074, *hi = 1;
        break;
    default:
        break;
    }
}

static void judge_family(const family *f) {
    uint64_t seed = SEED;
    double c[21], lo, hi;
    for (int i = 0; i < f->rounds; i++) {
        int n = 1 + random_int(&seed, f->most_degree);
        random_coefficients(&seed, f, c, n);
        random_interval(&seed, &lo, &hi);
        isolate_judge(c, n, lo, hi, &answer);
    }
}

TEST(test_random) {
    static const family families[] = {
        {"one size", 750, 20, -1, 1},
        {"sizes of a ray's coefficients", 300, 20, -10, 10},
        {"small integers, roots at 0, 1, -1, multiple ones", 750, 20, 0, 0},
        {"the largest", 100, 12, 1015, 1022},
    };
    for (size_t i = 0; i < sizeof families / sizeof families[0]; i++) judge_family(families + i);
}

/* ---- products of known roots ---- */

/* The entry that holds x; null: none. */
static const algsurf_bracket *entry_at(double x) {
    for (int i = 0; i < answer.count; i++)
        if (answer.b[i].lo <= x && x <= answer.b[i].hi) return answer.b + i;
    return NULL;
}

TEST(test_known_roots) {
    uint64_t seed = SEED;
    for (int i = 0; i < 600; i++) {
        int multiplicity[17] = {0}, n = 0, most = 1 + random_int(&seed, 12);
        double c[20] = {1}, lo = i % 3 ? -2.5 : -INFINITY, hi = i % 5 ? 2.25 : INFINITY;
        while (n < most) {
            int at = random_int(&seed, 17), m = random_int(&seed, 3) ? 1 : 1 + random_int(&seed, 4);
            for (int k = 0; k < m && n < 12 && multiplicity[at] < 4; k++, multiplicity[at]++)
                n = isolate_times_root(c, n, at - 8, 4);
        }
        isolate_judge(c, n, lo, hi, &answer);
        for (int at = 0; at < 17; at++) {
            const algsurf_bracket *b = entry_at((at - 8) / 4.0);
            int m = multiplicity[at];
            if (m > 0 && !(b && b->multiplicity == m && (m == 1 || b->kind == ALGSURF_BRACKET_EXACT)))
                isolate_fail("a known root", c, NULL, n, lo, hi, &answer);
        }
    }
}

/* Roots exactly at the ends, the middle, the quarters, in every combination, at all scales. */
TEST(test_split_points) {
    static const int intervals[][2] = {{0, 4}, {-4, 4}, {8, 16}, {-16, 0}, {4, 40}, {-12, -8}};
    static const int exponents[] = {0, -2, 1, 40, -40, 160, -160};
    for (size_t k = 0; k < 6 * 7; k++)
        for (int subset = 1; subset < 32; subset++) {
            const int *ends = intervals[k / 7];
            int e = exponents[k % 7], n = 0;
            double c[6] = {1}, lo = ldexp(ends[0], e), hi = ldexp(ends[1], e);
            for (int i = 0; i < 5; i++)
                if (subset >> i & 1) n = isolate_times_root(c, n, ends[0] + (ends[1] - ends[0]) / 4 * i, 1);
            for (int i = 0; i <= n; i++) c[i] = ldexp(c[i], -i * e);
            isolate_judge(c, n, lo, hi, &answer);
            if (answer.status != ALGSURF_OK || answer.count != n)
                isolate_fail("split points", c, NULL, n, lo, hi, &answer);
            isolate_judge(c, n, -INFINITY, INFINITY, &answer);
            if (answer.status != ALGSURF_OK || answer.count != n)
                isolate_fail("split points", c, NULL, n, -INFINITY, INFINITY, &answer);
        }
}

/* The split points that are tried instead of the middle are roots, too. */
TEST(test_moved_split_points) {
    for (int shift = 0; shift < 3; shift++) {
        double c[8] = {1};
        int n = 0;
        for (int k = 22; k <= 26; k++) n = isolate_times_root(c, n, k, 64);
        for (int k = 0; k <= n; k++) c[k] = ldexp(c[k], -4 * k * shift);
        isolate_judge(c, n, ldexp(0.25, 4 * shift), ldexp(0.5, 4 * shift), &answer);
        assert_ok(answer.status);
        assert_int_equal(answer.count, 5);
    }
}

TEST(test_plus_minus_powers) {
    for (int k = -460; k <= 460; k += 20) {
        double x = ldexp(1, k), c[3] = {-x * x, 0, 1};
        const double ends[][2] = {{-x, x},       {0, x}, {-x, 0},    {-INFINITY, INFINITY},
                                  {x, INFINITY}, {x, x}, {-x, 2 * x}};
        for (size_t i = 0; i < sizeof ends / sizeof ends[0]; i++) {
            isolate_judge(c, 2, ends[i][0], ends[i][1], &answer);
            if (answer.status != ALGSURF_OK)
                isolate_fail("undecided", c, NULL, 2, ends[i][0], ends[i][1], &answer);
        }
    }
}

/* t^m q(t^k), q of multiple roots, of roots at 0 and below, at all scales; intervals that cut pairs of roots,
 * end at roots, between them, at 0, or nowhere.  Breaks caught, each tried: the wrong side of 0, a sign that
 * forgets t^m, a bracket that ends at the root 0, a root of even multiplicity between the images of its two
 * doubles, an end that is not looked at. */
TEST(test_powers) {
    uint64_t seed = SEED;
    for (int i = 0; i < 2000; i++) {
        int m = random_int(&seed, 3), k = 1 + random_int(&seed, 5), n = 0;
        int most = random_int(&seed, 6), scale = i % 4 ? 0 : (random_int(&seed, 9) - 4) * 6;
        double q[8] = {1}, c[48] = {0}, lo, hi;
        while (n < most) {
            int root = i % 5 ? random_int(&seed, 33) - 16 : random_int(&seed, 2) ? 4 : 16;
            int again = random_int(&seed, 4) ? 1 : 2;
            for (; again > 0 && n < 7; again--) n = isolate_times_root(q, n, root, 1 + i % 3);
        }
        if (i % 7 == 0) q[0] += 0x1p-20; /* roots that are no doubles, close pairs, pairs that are no more */
        if (i % 11 == 0)
            for (int j = 0; j <= n; j++) q[j] = random_wide(&seed, -3, 3);
        for (int j = 0; j <= n; j++) c[m + j * k] = ldexp(q[j], -(m + j * k) * scale);
        random_interval(&seed, &lo, &hi);
        if (i % 3 == 0) lo = ldexp(random_int(&seed, 9) - 4, scale), hi = lo + ldexp(2.5, scale);
        if (i % 6 == 1) lo = -INFINITY, hi = INFINITY;
        isolate_judge(c, m + n * k, lo, hi, &answer);
    }
}

/* One high term and a few low ones are counted by a Sturm chain.  With a multiple root, close pairs, roots on
 * one side. Breaks caught, each tried: a remainder's sign, chains of t^n's other parity, the sign at 0. */
TEST(test_low_terms) {
    uint64_t seed = SEED;
    for (int i = 0; i < 400; i++) {
        int low = 1 + random_int(&seed, 3), n = low + 2 + random_int(&seed, 12);
        double c[20] = {0};
        for (int k = 0; k <= low; k++) c[k] = random_int(&seed, 41) - 20;
        c[n] = i % 2 ? 1 : -1;
        if (i % 4 == 0) c[0] = n - 1, c[1] = -n, c[2] = c[3] = 0, c[n] = 1; /* (t - 1)^2 divides it */
        if (i % 4 == 1) c[0] = -2, c[1] = 4.0 * (1 + i % 9), c[2] = -c[1] * c[1] / 8, c[3] = 0;
        isolate_judge(c, n, -INFINITY, INFINITY, &answer);
    }
}

/* Degrees 2 and 3 are counted by their discriminants: about 0, and of all sizes. */
TEST(test_discriminants) {
    uint64_t seed = SEED;
    for (int i = 0; i < 1500; i++) {
        int n = 0, far = i % 3 == 0 ? 250 : 20;
        double c[4] = {1}, root = random_int(&seed, 2001) - 1000;
        n = isolate_times_root(c, n, root, 64);
        n = isolate_times_root(c, n, root + (i % 4 == 0), 64);
        if (i % 2) n = isolate_times_root(c, n, random_int(&seed, 201) - 100, 64);
        int at = random_int(&seed, n + 1), by = random_int(&seed, 9) - 4, e = random_int(&seed, far);
        c[at] *= 1 + by * 0x1p-52;
        for (int k = 0; k <= n; k++) c[k] = ldexp(c[k], i % 5 == 0 ? -k * e : e);
        isolate_judge(c, n, -INFINITY, INFINITY, &answer);
    }
}

/* Degrees beyond those that doubles decide. */
TEST(test_many_terms) {
    uint64_t seed = SEED;
    for (int i = 0; i < 24; i++) {
        int n = 61 + i;
        double c[85] = {0}, lo = -INFINITY, hi = INFINITY;
        for (int k = 0; k <= n; k++) c[k] = ldexp(random_int(&seed, 2) ? 1 : -1, -k * (i % 3));
        if (i % 4 == 1) lo = 0.5, hi = 1.5;
        if (i % 4 == 3) lo = -1.75;
        isolate_judge(c, n, lo, hi, &answer);
    }
}

TEST(test_one_point) {
    const double c[] = {-3, 4}, third[] = {-1, 3};
    isolate_judge(c, 1, 0.75, 0.75, &answer);
    assert_int_equal(answer.count, 1);
    assert_int_equal(answer.b[0].kind, ALGSURF_BRACKET_EXACT);
    isolate_judge(c, 1, nextafter(0.75, 1), nextafter(0.75, 1), &answer);
    assert_int_equal(answer.count, 0);
    isolate_judge(third, 1, 1.0 / 3, 1.0 / 3, &answer); /* off by 2^-55 or so */
    assert_int_equal(answer.count, 0);
}

/* Which holds no number. */
TEST(test_interval_at_infinity) {
    const double c[] = {-1, 0.5, 3, 1}, r[] = {0x1p-60, 0, 0x1p-60, 0}, ends[] = {-INFINITY, INFINITY};
    for (int n = 1; n <= 3; n++)
        for (int i = 0; i < 2; i++) {
            algsurf_bracket b;
            algsurf_real_root roots[3];
            int count = 77;
            isolate_judge(c, n, ends[i], ends[i], &answer);
            assert_int_equal(answer.count, 0);
            assert_ok(algsurf_isolate_first(c, r, n, ends[i], ends[i], NULL, &b, &count));
            assert_int_equal(count, 0);
            assert_ok(algsurf_count_roots(c, r, n, ends[i], ends[i], &count));
            assert_int_equal(count, 0);
            count = 77;
            assert_ok(algsurf_real_roots(c, n, ends[i], ends[i], roots, 3, &count));
            assert_int_equal(count, 0);
        }
}

/* ---- what is refused ---- */

static void expect(algsurf_status wanted, const double *c, const double *r, int n, double lo, double hi) {
    algsurf_bracket b[2], untouched;
    int k = 77;
    memset(b, 0x5a, sizeof b), memset(&untouched, 0x5a, sizeof untouched);
    assert_int_equal(algsurf_isolate_all(c, r, n, lo, hi, NULL, b, 2, &k), wanted);
    assert_int_equal(algsurf_isolate_first(c, r, n, lo, hi, NULL, b, &k), wanted);
    assert_int_equal(algsurf_count_roots(c, r, n, lo, hi, &k), wanted);
    assert_int_equal(k, 77);
    assert_memory_equal(b, &untouched, sizeof untouched);
    assert_memory_equal(b + 1, &untouched, sizeof untouched);
}

TEST(test_bad_input) {
    const double c[] = {1, 0, -1}, zero[] = {0, 0, 0}, nan[] = {1, NAN, 1}, inf[] = {1, 0, INFINITY};
    const double negative[] = {0, -1, 0};
    expect(ALGSURF_E_ARGUMENT, NULL, NULL, 2, 0, 1);
    expect(ALGSURF_E_ARGUMENT, c, NULL, -1, 0, 1);
    expect(ALGSURF_E_DEGREE, c, NULL, ALGSURF_MAX_POLY_DEGREE + 1, 0, 1);
    expect(ALGSURF_E_ARGUMENT, c, NULL, 2, 1, 0);
    expect(ALGSURF_E_NOT_FINITE, c, NULL, 2, NAN, 1);
    expect(ALGSURF_E_NOT_FINITE, c, NULL, 2, 0, NAN);
    expect(ALGSURF_E_ARGUMENT, c, negative, 2, 0, 1);
    expect(ALGSURF_E_NOT_FINITE, nan, NULL, 2, 0, 1);
    expect(ALGSURF_E_NOT_FINITE, inf, NULL, 2, 0, 1);
    expect(ALGSURF_E_NOT_FINITE, c, nan, 2, 0, 1);
    expect(ALGSURF_E_NOT_FINITE, c, inf, 2, 0, 1);
    expect(ALGSURF_E_ZERO, zero, NULL, 2, 0, 1);
    expect(ALGSURF_E_ZERO, zero, zero, 2, 0, 1);
    algsurf_bracket b[2];
    int k = 77;
    assert_int_equal(algsurf_isolate_all(c, NULL, 2, 0, 1, NULL, NULL, 2, &k), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_isolate_all(c, NULL, 2, 0, 1, NULL, b, 2, NULL), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_isolate_all(c, NULL, 2, 0, 1, NULL, b, -1, &k), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_isolate_first(c, NULL, 2, 0, 1, NULL, NULL, &k), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_isolate_first(c, NULL, 2, 0, 1, NULL, b, NULL), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_count_roots(c, NULL, 2, 0, 1, NULL), ALGSURF_E_ARGUMENT);
    assert_int_equal(k, 77);
}

TEST(test_capacity) {
    const double c[] = {-6, 11, -6, 1};
    algsurf_bracket b[3], untouched[3];
    int k = 77;
    memset(b, 0x5a, sizeof b), memcpy(untouched, b, sizeof b);
    for (int room = 0; room < 3; room++)
        assert_int_equal(algsurf_isolate_all(c, NULL, 3, 0, 4, NULL, b, room, &k), ALGSURF_E_CAPACITY);
    assert_int_equal(k, 77);
    assert_memory_equal(b, untouched, sizeof b);
    assert_ok(algsurf_isolate_all(c, NULL, 3, 0, 4, NULL, b, 3, &k));
    assert_int_equal(k, 3);
    assert_ok(algsurf_isolate_all(c, NULL, 3, 5, 6, NULL, b, 0, &k));
    assert_int_equal(k, 0);
    assert_ok(algsurf_isolate_all(c, NULL, 3, 1.5, 2.5, NULL, b, 1, &k));
    assert_int_equal(k, 1);
}

/* Quadratics have a way of their own.  Roots by a quadratic's exact discriminant and ends, over wide numbers
 * and where rounding nearly hides them. */
TEST(test_quadratics) {
    uint64_t seed = 77;
    int two = 0, none = 0;
    for (int i = 0; i < 30000; i++) {
        int n = 1 + (i % 8 > 0), wide = i % 3 == 0 ? 300 : 2, k = 0;
        double c[3], lo = random_wide(&seed, -wide, wide), hi = random_wide(&seed, -wide, wide);
        for (int j = 0; j <= n; j++) c[j] = random_wide(&seed, -wide, wide);
        if (i % 4 == 1 && n == 2) { /* about (t - lo)^2, or with a root about an end */
            c[1] = -2 * lo * c[2], c[0] = c[2] * lo * lo * (1 + (random_int(&seed, 9) - 4) * 0x1p-52);
            lo -= 1 + random_unit(&seed), hi = lo + 2;
        }
        if (lo > hi) lo = -lo, hi = -hi;
        if (!(lo < hi)) continue;
        algsurf_bracket b[2];
        assert_ok(algsurf_isolate_all(c, NULL, n, lo, hi, NULL, b, 2, &k));
        exact_sturm s = exact_sturm_of_doubles(c, n);
        int all = exact_count_roots(&s, lo, hi), held = 0;
        for (int j = 0; j < k; j++) held += exact_count_roots(&s, b[j].lo, b[j].hi);
        if (k != all || held != k)
            fail_msg("seed 77, %d: %a %a %a on [%a, %a]: %d brackets, %d roots", i, c[0], c[1],
                     n > 1 ? c[2] : 0, lo, hi, k, all);
        two += k == 2, none += k == 0;
        exact_sturm_clear(&s);
    }
    assert_true(two > 2000 && none > 2000);
}

/* The first root, and how many intervals are looked at. */
static size_t intervals(const double *c, int n, double lo, double hi, algsurf_bracket *b, int *found) {
    algsurf_observer observer = {.size = sizeof observer};
    const algsurf_isolate_options watched = {.size = sizeof watched, .observer = &observer};
    assert_ok(algsurf_isolate_first(c, NULL, n, lo, hi, &watched, b, found));
    return observer.cells;
}

/* Intervals that Descartes' rule looks at.  Catches: a walk that is not counted, or counted twice; a
 * multiple root that is halved to the last bit before the greatest common divisor is asked. */
TEST(test_counted) {
    /* (t^2 + 0.1)(t + 3)(t - 4), ... */
    const double none[] = {-1.2, -0.1, -11.9, -1, 1}, two[] = {1.995, -4.285, 1.35, 1};
    const double one[] = {-0.9, 1}, dyadic[] = {-0.25, 0, 1};
    const double twice[] = {0.140625, -0.75, 1};  /* (t - 3/8)^2 */
    const double irrational[] = {4, 0, -4, 0, 1}; /* (t^2 - 2)^2 */
    algsurf_bracket b;
    int found;
    assert_int_equal(intervals(none, 4, -1, 1, &b, &found), 3); /* the whole, two halves */
    assert_int_equal(found, 0);
    assert_int_equal(intervals(one, 1, 0, 1, &b, &found), 1); /* signs at the ends are a look at the whole */
    assert_int_equal(found, 1);
    assert_int_equal(intervals(two, 3, 0.5, 1, &b, &found), 3); /* the same, the left half's root is first */
    assert_int_equal(found, 1);
    (void)intervals(dyadic, 2, 0.5, 0.5, &b, &found);
    assert_true(found == 1 && b.kind == ALGSURF_BRACKET_EXACT);
    /* the divisor is asked for when halving comes to no end */
    assert_in_range(intervals(twice, 2, 0, 1, &b, &found), 20, 100);
    assert_int_equal(found, 1);
    assert_in_range(intervals(irrational, 4, 0, 4, &b, &found), 16, 100);
    assert_true(found == 1 && b.kind == ALGSURF_BRACKET_ISOLATED && b.multiplicity == 2);
}
