/* test_isolate_radii.c - coefficients with radii: what isolate says holds for every polynomial in the box;
 * and results do not depend on the caller's floating-point environment.
 *
 * Breaks caught, each tried: radii left out of the Bernstein form's bound, the radius of the wrong
 * coefficient in a far piece, work done outside the guarded environment, an environment not restored, an
 * interval that is empty in the unit of the roots, a set that holds the zero polynomial, or a constant,
 * treated as others.
 */
#include "isolate_case.h"

#include "algsurf/refine.h"
#include "environments.h"

#define SEED 12u

static isolate_answer answer;
static int refined, narrower;

/* |p(x)| > sum r_k |x|^k, exactly: the sign at x is that of every member. */
static int margin_holds(const double *c, const double *r, int n, double x) {
    mpq_t value, slack;
    mpq_inits(value, slack, NULL);
    exact_poly_at(value, c, n, x), exact_poly_at(slack, r, n, fabs(x));
    mpq_abs(value, value);
    int holds = mpq_cmp(value, slack) > 0;
    mpq_clears(value, slack, NULL);
    return holds;
}

/* The chain of a member: a corner of the box, or a point halfway. */
static exact_sturm member(uint64_t *seed, const double *c, const double *r, int n) {
    double both[2 * 21];
    mpz_t integer[2 * 21];
    for (int k = 0; k <= n; k++) both[2 * k] = c[k], both[2 * k + 1] = r[k] / 2;
    for (int k = 0; k < 2 * n + 2; k++) mpz_init(integer[k]);
    (void)exact_integers(integer, both, 2 * n + 1);
    for (int k = 0; k <= n; k++) {
        for (int e = random_int(seed, 5) - 2; e > 0; e--)
            mpz_add(integer[2 * k], integer[2 * k], integer[2 * k + 1]);
        for (int e = random_int(seed, 5) - 2; e > 0; e--)
            mpz_sub(integer[2 * k], integer[2 * k], integer[2 * k + 1]);
        mpz_swap(integer[k], integer[2 * k]);
    }
    exact_sturm s = exact_sturm_of(integer, n);
    for (int k = 0; k < 2 * n + 2; k++) mpz_clear(integer[k]);
    return s;
}

/* Every bracket is refined, to one that each polynomial has its root in. */
static const char *judge_refined(uint64_t *seed, const double *c, const double *r, int n) {
    for (int i = 0; i < answer.count; i++) {
        const algsurf_bracket *b = answer.b + i;
        algsurf_refined_root root;
        if (b->kind == ALGSURF_BRACKET_UNDECIDED) continue;
        if (algsurf_refine_poly(c, r, n, b->lo, b->hi, NULL, &root) != ALGSURF_OK) return "not refined";
        if (!(b->lo <= root.lo && root.lo <= root.root && root.root <= root.hi && root.hi <= b->hi))
            return "order of the refined";
        for (int k = 0; k < 4; k++) {
            exact_sturm s = member(seed, c, r, n);
            int inside = s.count > 0 ? exact_count_roots(&s, root.lo, root.hi) : 1;
            exact_sturm_clear(&s);
            if (inside != 1) return "a root lost in refinement";
        }
        refined++, narrower += root.hi - root.lo < 0.5 * (b->hi - b->lo);
    }
    return NULL;
}

static void judge_box(uint64_t *seed, const double *c, const double *r, int n, double lo, double hi) {
    memset(&answer, 0, sizeof answer);
    answer.status =
        algsurf_isolate_all(c, r, n, lo, hi, NULL, answer.b, ALGSURF_MAX_POLY_DEGREE + 1, &answer.count);
    const char *wrong = answer.status < 0 ? "refused" : isolate_form(c, r, n, lo, hi, &answer);
    for (int i = 0; !wrong && i < answer.count; i++) {
        const algsurf_bracket *b = answer.b + i;
        if (b->kind != ALGSURF_BRACKET_ISOLATED) continue;
        if ((isfinite(b->lo) && !margin_holds(c, r, n, b->lo)) ||
            (isfinite(b->hi) && !margin_holds(c, r, n, b->hi)))
            wrong = "no margin at an end";
    }
    if (!wrong) wrong = isolate_signs(c, n, &answer);
    for (int i = 0; !wrong && i < 4; i++) {
        exact_sturm s = member(seed, c, r, n);
        if (s.count > 0) wrong = isolate_truth(&s, lo, hi, &answer);
        exact_sturm_clear(&s);
    }
    if (!wrong) wrong = judge_refined(seed, c, r, n);
    if (wrong) isolate_fail(wrong, c, r, n, lo, hi, &answer);
}

TEST(test_boxes) {
    uint64_t seed = SEED;
    int decided = 0, rounds = 600, undecided = 0;
    for (int i = 0; i < rounds; i++) {
        double c[21], r[21], ends[4] = {-1.5, 2, -INFINITY, INFINITY};
        int n = 1 + random_int(&seed, 12), bits = 1 + random_int(&seed, 50);
        for (int k = 0; k <= n; k++) {
            c[k] = random_wide(&seed, -3, 3);
            r[k] = random_int(&seed, 3) ? ldexp(fabs(random_unit(&seed)), -bits) : 0.0;
        }
        c[n] = 1;
        double lo = ends[2 * random_int(&seed, 2)], hi = ends[1 + 2 * random_int(&seed, 2)];
        judge_box(&seed, c, r, n, lo, hi);
        decided += answer.status == ALGSURF_OK;
        undecided += answer.status != ALGSURF_OK && bits < 10;
    }
    if (decided * 100 < rounds * 80) fail_msg("seed %u: %d of %d decided", SEED, decided, rounds);
    assert_true(undecided > 0 && refined > rounds && narrower > refined / 2);
}

/* Known gaps: x^2 - 2 e x + e^2 - d has the roots e +- sqrt d; they part when the radius is below d. */
TEST(test_box_decides_where_it_can) {
    uint64_t seed = SEED;
    for (int k = 4; k <= 40; k += 2) {
        double d = ldexp(1, -k), c[3] = {1 - d, -2, 1}, r[3] = {d / 4, 0, 0};
        judge_box(&seed, c, r, 2, 0, 4);
        assert_ok(answer.status);
        assert_int_equal(answer.count, 2);
        r[0] = 2 * d;
        judge_box(&seed, c, r, 2, 0, 4);
        assert_int_equal(answer.status, ALGSURF_UNDECIDED_MULTIPLE);
    }
    const double zero[3] = {0, 0, 0}, some[3] = {0x1p-30, 0, 0x1p-30}; /* nothing is known at all */
    judge_box(&seed, zero, some, 2, -1, 1);
    assert_true(answer.status > 0);
    assert_true(answer.b[0].lo == -1 && answer.b[answer.count - 1].hi == 1);
    const double lead[3] = {-1, 1, 0}, unsure[3] = {0, 0, 0x1p-30}; /* a root that may be at infinity */
    assert_true(algsurf_isolate_all(lead, unsure, 2, -INFINITY, INFINITY, NULL, answer.b, 3, &answer.count) >
                0);
    judge_box(&seed, lead, unsure, 2, -100, 100);
    assert_ok(answer.status);
}

/* Far from 0 the radius of the leading coefficient counts, not that of the constant. */
TEST(test_far_radii) {
    uint64_t seed = SEED;
    const double c[2] = {1, 0x1p-10}, lead[2] = {0, 0x1p-9}, constant[2] = {0x1p-9, 0};
    algsurf_bracket first;
    int found = -1;
    assert_true(algsurf_isolate_first(c, lead, 1, 2, INFINITY, NULL, &first, &found) > 0 && found);
    assert_true(first.lo <= 1024); /* 1 - 2^-10 x */
    judge_box(&seed, c, lead, 1, 2, 900);
    assert_int_equal(answer.count, 0);
    judge_box(&seed, c, constant, 1, 2, INFINITY);
    assert_int_equal(answer.count, 0);
}

/* Roots of sizes far apart, and no annulus between them that is certainly free of roots: the coefficient that
 * would tell is known to a factor only.  And a root beyond the range of double. */
TEST(test_sizes_that_overlap) {
    uint64_t seed = SEED;
    const double c[3] = {1, 1, 1e-300}, r[3] = {0, 0.9, 0}, line[2] = {-0x1p600, 0x1p-600}, none[2] = {0, 0},
                 some[2] = {0, 0x1p-599};
    judge_box(&seed, c, r, 2, -INFINITY, INFINITY);
    assert_true(answer.count > 0);
    judge_box(&seed, line, none, 1, 0, INFINITY);
    assert_true(answer.status == ALGSURF_OK && answer.count == 1);
    assert_true(answer.b[0].lo == DBL_MAX && answer.b[0].hi == INFINITY);
    judge_box(&seed, line, some, 1, 0, INFINITY); /* a leading coefficient that may vanish */
    assert_true(answer.status == ALGSURF_UNDECIDED_RANGE && answer.b[answer.count - 1].hi == INFINITY);
    judge_box(&seed, line, none, 1, 0, DBL_MAX);
    assert_int_equal(answer.count, 0);
}

TEST(test_one_point_of_a_box) {
    uint64_t seed = SEED;
    const double c[2] = {-1, 1}, r[2] = {0x1p-20, 0};
    judge_box(&seed, c, r, 1, 1, 1);
    assert_int_equal(answer.status, ALGSURF_UNDECIDED_ZERO);
    judge_box(&seed, c, r, 1, 1.5, 1.5);
    assert_int_equal(answer.count, 0);
    for (int k = -1; k <= 1; k++) { /* the same point as an end, and within */
        judge_box(&seed, c, r, 1, fmin(1, 1 + k), fmax(1, 1 + k));
        assert_true(answer.status > 0 && answer.count == 1);
    }
}

/* Sets with members whose roots are below the least double, or all of an interval that is hardly longer, or 0
 * with a neighbour: nothing may get lost, and nothing be certain. */
TEST(test_least_numbers) {
    uint64_t seed = SEED;
    static const struct {
        double c[3], r[3], lo, hi;
    } cases[] = {
        {{0, 1, 0}, {5, 0, 0}, 0, 0x1p-1074},
        {{0, 1, 0}, {5, 0, 0}, 0, 0x1p-1073},
        {{0, 1, 0}, {5, 0, 0}, -0x1p-1074, 0x1p-1074},
        {{0, 1, 1e5}, {0, 1, 0}, -1, 1},
        {{0, 1, 1e5}, {0, 1, 0}, -1, 0},
        {{1, 0, 0}, {0, 0x1p-1060, 0}, -INFINITY, INFINITY},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        judge_box(&seed, cases[i].c, cases[i].r, 2, cases[i].lo, cases[i].hi);
        if (answer.status == ALGSURF_OK)
            isolate_fail("decided", cases[i].c, cases[i].r, 2, cases[i].lo, cases[i].hi, &answer);
    }
    const double c[] = {0, 1}, r[] = {0, 0.5}; /* the root at 0 is certain, for all members */
    judge_box(&seed, c, r, 1, -1, 1);
    assert_ok(answer.status);
    assert_int_equal(answer.b[0].kind, ALGSURF_BRACKET_EXACT);
    judge_box(&seed, c, r, 1, 0, 0);
    assert_ok(answer.status);
    const double touching[] = {0, 1, 1e5}, touch[] = {0, 1, 0}; /* the other root is not right of 0 */
    judge_box(&seed, touching, touch, 2, 0, 1);
    assert_ok(answer.status);
    assert_int_equal(answer.b[0].kind, ALGSURF_BRACKET_EXACT);
    const double least[] = {0, 1e5, 1}, below[] = {0x1p-1060, 0, 0}; /* a root below the least double */
    judge_box(&seed, least, below, 2, -1, 1);
    assert_ok(answer.status);
    assert_true(answer.b[0].lo == -0x1p-1074 && answer.b[0].hi == 0x1p-1074 && answer.b[0].sign == -1);
}

/* A simple root that is on either side of 0, or of a power of two, as coefficients are. */
TEST(test_root_on_either_side) {
    uint64_t seed = SEED;
    const double line[] = {0, 1}, narrow[4] = {1e-9};
    judge_box(&seed, line, narrow, 1, -1, 1);
    assert_ok(answer.status);
    assert_int_equal(answer.count, 1);
    assert_true(answer.b[0].kind == ALGSURF_BRACKET_ISOLATED && answer.b[0].sign == -1);
    assert_true(answer.b[0].lo < -1e-9 && answer.b[0].lo > -1.1e-9);
    assert_true(answer.b[0].hi > 1e-9 && answer.b[0].hi < 1.1e-9);
    judge_box(&seed, line, narrow, 1, 0, 1); /* not for all of them */
    assert_int_equal(answer.status, ALGSURF_UNDECIDED_MULTIPLE);
    const double half[] = {1, 1}, touch[] = {1, 0}; /* the root in [-2,0] */
    judge_box(&seed, half, touch, 1, -INFINITY, INFINITY);
    assert_true(answer.status == ALGSURF_OK && answer.count == 1 &&
                answer.b[0].kind == ALGSURF_BRACKET_ISOLATED);
    const double cube[] = {0, 0, 0, 1}; /* not simple for one of the set */
    judge_box(&seed, cube, narrow, 3, -1, 1);
    assert_true(answer.status > 0);
    for (int i = 0; i < 400; i++) { /* (x - root) times a polynomial without roots near it */
        double c[9], r[9], root = i % 2 ? 0 : ldexp(i % 4 ? 1 : -1, random_int(&seed, 9) - 4);
        int n = 1 + random_int(&seed, 7), bits = 12 + random_int(&seed, 40);
        c[0] = 1, c[n] = 0;
        for (int k = 1; k < n; k++) c[k] = ldexp(random_unit(&seed), -6 * k - 3);
        for (int k = n; k >= 0; k--) c[k] = (k > 0 ? c[k - 1] : 0) - root * (k < n ? c[k] : 0);
        for (int k = 0; k <= n; k++) r[k] = ldexp(fabs(random_unit(&seed)), -bits - 8 * k);
        judge_box(&seed, c, r, n, root - 2, root + 2);
        if (answer.status != ALGSURF_OK || answer.count != 1 ||
            !(answer.b[0].lo < root && root < answer.b[0].hi))
            isolate_fail("not decided", c, r, n, root - 2, root + 2, &answer);
    }
}

/* The leading coefficient may vanish, and signs exclude what would be far out. */
TEST(test_nothing_far_out) {
    uint64_t seed = SEED;
    const double c[] = {-1, 1, 0.5},
                 r[] = {0, 0, 0.5}; /* a root on the right, perhaps another one far left */
    judge_box(&seed, c, r, 2, -0.5, INFINITY);
    assert_ok(answer.status);
    assert_int_equal(answer.count, 1);
    judge_box(&seed, c, r, 2, -INFINITY, INFINITY);
    assert_int_equal(answer.status, ALGSURF_UNDECIDED_RANGE);
    assert_true(answer.count == 2 && answer.b[0].lo == -INFINITY && answer.b[0].hi < -1);
    const double even[] = {1, 0, 1, 0, 1e-30}, open[] = {0.5, 0.5, 0.5, 0, 1e-30};
    judge_box(&seed, even, open, 4, -INFINITY, INFINITY);
    assert_int_equal(answer.count, 0);
    const double far[] = {-0x1p600, 0x1p-600}, some[] = {0x1p580, 0x1p-620}; /* certain, and beyond DBL_MAX */
    judge_box(&seed, far, some, 1, 0, INFINITY);
    assert_true(answer.status == ALGSURF_OK && answer.b[0].lo == DBL_MAX && answer.b[0].hi == INFINITY);
    judge_box(&seed, far, some, 1, 0, DBL_MAX);
    assert_int_equal(answer.count, 0);
    for (int side = -1; side <= 1; side += 2) { /* infinity is no root */
        judge_box(&seed, c, r, 2, side * HUGE_VAL, side * HUGE_VAL);
        assert_int_equal(answer.count, 0);
    }
}

/* Cells of integers are counted, too. */
TEST(test_counted) {
    const double c[] = {-1, 1, 0.5}, r[] = {0, 0, 0.5};
    algsurf_bracket first;
    int found = 0;
    algsurf_observer observer = {.size = sizeof observer};
    const algsurf_isolate_options watched = {.size = sizeof watched, .observer = &observer};
    assert_ok(algsurf_isolate_first(c, r, 2, -0.5, INFINITY, &watched, &first, &found));
    assert_true(found == 1 && observer.cells > 0 && observer.engine == ALGSURF_ENGINE_INTEGERS);
}

/* A set with the zero polynomial among its members: the whole interval, undecided; with a constant that only
 * almost vanishes: no root. */
TEST(test_zero_polynomial_in_a_box) {
    uint64_t seed = SEED;
    const double c[] = {0, 1, 0, -3}, r[] = {0, 10, 0x1p-9, 3};
    for (int n = 0; n <= 3; n++)
        for (int k = 0; k < 4; k++) {
            const double ends[][2] = {{0, 0.25}, {-1, 1}, {1, 1}, {-INFINITY, INFINITY}};
            if (n == 0) judge_box(&seed, c + 1, r + 1, 0, ends[k][0], ends[k][1]);
            if (n > 0) judge_box(&seed, c, r, n, ends[k][0], ends[k][1]);
            assert_int_equal(answer.status, ALGSURF_UNDECIDED_ZERO);
            assert_int_equal(answer.count, 1);
            assert_true(answer.b[0].lo == ends[k][0] && answer.b[0].hi == ends[k][1]);
            assert_int_equal(answer.b[0].multiplicity, n > 0 ? n : 1);
        }
    const double almost[] = {-2, 0}, radius[] = {0x1.fffffffffffffp+0, 0};
    for (int n = 0; n <= 1; n++) {
        judge_box(&seed, almost, radius, n, -INFINITY, INFINITY);
        assert_int_equal(answer.count, 0);
    }
}

/* ---- high degrees ---- */

/* The roots of a member, which is given in doubles, are in the entries, one in each that is decided. */
static const char *judge_member(const double *member, int n) {
    static algsurf_real_root root[ALGSURF_MAX_POLY_DEGREE];
    int count, in[ALGSURF_MAX_POLY_DEGREE] = {0};
    if (algsurf_real_roots(member, n, -INFINITY, INFINITY, root, n, &count) != ALGSURF_OK) return "no roots";
    for (int i = 0, k = 0; i < count; i++) {
        while (k < answer.count && answer.b[k].hi < root[i].hi) k++;
        if (k == answer.count || answer.b[k].lo > root[i].lo) return "a root outside the entries";
        in[k]++;
    }
    for (int k = 0; k < answer.count; k++)
        if (answer.b[k].kind == ALGSURF_BRACKET_ISOLATED && in[k] != 1) return "not one root";
    return NULL;
}

static double seconds_of(const double *c, const double *r, int n) {
    double best = HUGE_VAL;
    for (int i = 0; i < 2; i++) {
        double start = unit_seconds();
        answer.status = algsurf_isolate_all(c, r, n, -INFINITY, INFINITY, NULL, answer.b,
                                            ALGSURF_MAX_POLY_DEGREE + 1, &answer.count);
        best = fmin(best, unit_seconds() - start);
    }
    return best;
}

/* As many times the cost without radii, at most, and all members right. */
static void judge_high(uint64_t *seed, const double *c, const double *r, int n, double most) {
    double plain = seconds_of(c, NULL, n), time = seconds_of(c, r, n), member[ALGSURF_MAX_POLY_DEGREE + 1];
    assert_true(answer.status >= 0);
    if (time > most * plain) fail_msg("degree %d: %g s, without radii %g s", n, time, plain);
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k <= n; k++) member[k] = c[k] + (random_int(seed, 3) - 1) * r[k];
        const char *wrong = judge_member(member, n);
        if (wrong) fail_msg("degree %d, member %d, seed %u: %s", n, i, SEED, wrong);
    }
}

TEST(test_high_degrees) {
    uint64_t seed = SEED;
    static double c[513], r[513], before[513];
    for (int i = 0; i < 4; i++) {
        for (int k = 0; k <= 512; k++) c[k] = random_int(&seed, 2) ? 1 : -1, r[k] = ldexp(1, -8 - 11 * i);
        judge_high(&seed, c, r, 512, 100);
        int sure = 0;
        for (int k = 0; k < answer.count; k++) sure += answer.b[k].kind == ALGSURF_BRACKET_ISOLATED;
        assert_true(i == 0 || sure == answer.count);
    }
    memset(c, 0, sizeof c), memset(before, 0, sizeof before);
    before[0] = 1, c[1] = 1;
    for (int k = 1; k < 256; k++) /* Chebyshev's polynomials, rounded from degree 49 on */
        for (int j = k + 1; j >= 0; j--) {
            double next = (j > 0 ? 2 * c[j - 1] : 0) - before[j];
            before[j] = c[j], c[j] = next;
        }
    for (int k = 0; k <= 256; k++) r[k] = ldexp(fabs(c[k]), -52);
    judge_high(&seed, c, r, 256, 100);
    assert_true(answer.count > 10);
}

/* ---- the environment ---- */

typedef struct outcome {
    algsurf_status status[3];
    int count, found, roots;
    algsurf_bracket first, b[21];
} outcome;

static void run(const double *c, const double *r, int n, double lo, double hi, outcome *o) {
    memset(o, 0, sizeof *o);
    o->status[0] = algsurf_isolate_all(c, r, n, lo, hi, NULL, o->b, 21, &o->count);
    o->status[1] = algsurf_isolate_first(c, r, n, lo, hi, NULL, &o->first, &o->found);
    o->status[2] = algsurf_count_roots(c, r, n, lo, hi, &o->roots);
}

TEST(test_environment) {
    uint64_t seed = SEED;
    for (int i = 0; i < 150; i++) {
        double c[21], r[21];
        int n = 1 + random_int(&seed, 20), tiny = i % 3 == 0, multiple = i % 5 == 0;
        for (int k = 0; k <= n; k++) {
            c[k] = random_wide(&seed, tiny ? -1020 : -4, tiny ? -1000 : 4);
            r[k] = ldexp(fabs(c[k]), -45);
        }
        if (multiple) n = 4, c[0] = 4, c[1] = 0, c[2] = -4, c[3] = 0, c[4] = 1;
        outcome usual, other;
        const double *radii = i % 2 ? r : NULL;
        run(c, radii, n, -0x1p-1030, i % 4 ? INFINITY : 2, &usual);
        for (int e = 1; e < ENVIRONMENTS; e++) {
            environment_set(e);
            run(c, radii, n, -0x1p-1030, i % 4 ? INFINITY : 2, &other);
            int unchanged = environment_unset(e);
            if (!unchanged) fail_msg("seed %u round %d: environment %d is not restored", SEED, i, e);
            if (memcmp(&usual, &other, sizeof usual) != 0) {
                exact_print_doubles("c", c, n + 1);
                fail_msg("seed %u round %d: another answer in environment %d", SEED, i, e);
            }
        }
    }
}
