/* test_complex_batch.c - all roots of many polynomials: the bits of single calls, by every kernel, and
 * boxes that hold their roots, judged by arithmetic without rounding (exact_complex.h): the disc about z that
 * holds a root must lie within the box, whose ends no root here is as near as that, or leave it to its
 * rounding.
 *
 * Breaks tried, each caught by the test named:
 *   the growth of discs left out, ends rounded inward, the lower root of a pair not taken from the upper one,
 *   sums over the other roots in another order in one layout                       boxes_hold_their_roots
 *   the guard of the discriminant left out                                         quadratics
 */
#include "algsurf/batch.h"
#include "complex/boxes.h"
#include "exact_complex.h"
#include "unit.h"

enum { MANY = 11 }; /* packets that are full, and one that is not, whatever the kernel */

static const char *const names[] = {"avx512", "avx2", "baseline"};

/* Coefficients of p[i] as the interface wants them. */
typedef struct batch {
    double re[MOST + 1][MANY], im[MOST + 1][MANY];
    algsurf_complex_batch packet;
} batch;

static void set_batch(batch *b, const problem *p, int real) {
    for (int k = 0; k <= p->n; k++)
        for (int i = 0; i < MANY; i++) b->re[k][i] = p[i].re[k], b->im[k][i] = p[i].im[k];
    b->packet = (algsurf_complex_batch){.size = sizeof b->packet,
                                        .count = MANY,
                                        .degree = p->n,
                                        .re = {b->re[0], MANY, 1},
                                        .im = {real ? NULL : b->im[0], MANY, 1}};
}

static algsurf_status solve_one(const problem *p, algsurf_complex_root *roots, int *count) {
    algsurf_complex c[MOST + 1];
    if (p->real) return algsurf_complex_roots_of_real(p->re, NULL, p->n, roots, count);
    for (int k = 0; k <= p->n; k++) c[k] = (algsurf_complex){p->re[k], p->im[k]};
    return algsurf_complex_roots(c, NULL, p->n, roots, count);
}

static int lies_in(const mpf_t x, double by, double lo, double hi) {
    mpf_t a, b;
    mpf_init2(a, BITS), mpf_init2(b, BITS);
    mpf_set_d(a, by), mpf_add(b, x, a), mpf_sub(a, x, a);
    int in = mpf_cmp_d(a, lo) >= 0 && mpf_cmp_d(b, hi) <= 0;
    mpf_clear(a), mpf_clear(b);
    return in;
}

/* Boxes are disjoint, in order, symmetric for real p, and each simple one holds a root. */
static void judge(const problem *p, const algsurf_complex_root *e, int count) {
    point z;
    init(&z);
    for (int i = 0; i < count; i++) {
        const algsurf_cinterval *b = &e[i].box;
        int mirrored = 0;
        assert_true(b->re.lo <= e[i].root.re && e[i].root.re <= b->re.hi);
        assert_true(b->im.lo <= e[i].root.im && e[i].root.im <= b->im.hi);
        assert_true(!signbit(e[i].root.im) || e[i].root.im < 0);
        if (i > 0)
            assert_true(e[i].root.re > e[i - 1].root.re ||
                        (e[i].root.re == e[i - 1].root.re && e[i].root.im > e[i - 1].root.im));
        for (int j = 0; j < count; j++) {
            const algsurf_cinterval *a = &e[j].box;
            if (j < i)
                assert_true(b->re.hi < a->re.lo || a->re.hi < b->re.lo || b->im.hi < a->im.lo ||
                            a->im.hi < b->im.lo);
            mirrored += a->re.lo == b->re.lo && a->re.hi == b->re.hi && a->im.lo == -b->im.hi &&
                        a->im.hi == -b->im.lo;
        }
        if (p->real) assert_int_equal(mirrored, 1);
        double size = hypot(e[i].root.re, e[i].root.im);
        if (e[i].multiplicity > 1 || !(size > 0x1p-300 && size < 0x1p300)) continue; /* not in lanes */
        double width = fmin(b->re.hi - b->re.lo, e[i].real ? HUGE_VAL : b->im.hi - b->im.lo);
        double radius = find_root(p, e[i].root.re, e[i].root.im, 0x1p-150 * width, &z);
        if (!(radius <= 0x1p-100 * width) || !lies_in(z.re, -radius, b->re.lo, b->re.hi) ||
            !(e[i].real ? lies_in(z.im, 0, -radius, radius) : lies_in(z.im, -radius, b->im.lo, b->im.hi))) {
            print_error("degree %d, root %d at (%a,%a), found in %a\n", p->n, i, e[i].root.re, e[i].root.im,
                        radius);
            for (int k = 0; k <= p->n; k++) print_error("  %a %a\n", p->re[k], p->im[k]);
            fail();
        }
    }
    clear(&z);
}

/* Batch and single calls agree in each bit; the answers are true if asked for. */
static void compare(const problem *p, int real, int judged) {
    batch b;
    algsurf_complex_root single[MANY][MOST], roots[MANY * MOST];
    int count[MANY], found[MANY];
    set_batch(&b, p, real);
    for (int i = 0; i < MANY; i++) {
        algsurf_status status = solve_one(p + i, single[i], count + i);
        if (status < 0)
            count[i] = status;
        else if (judged)
            judge(p + i, single[i], count[i]);
    }
    for (size_t k = 0; k < sizeof names / sizeof *names; k++) {
        const algsurf_batch_options options = {.size = sizeof options, .kernel = names[k]};
        if (!algsurf_i_kernel_find(names[k])) continue;
        algsurf_status status = algsurf_complex_roots_batch(&b.packet, &options, roots, found),
                       first = ALGSURF_OK;
        for (int i = 0; i < MANY; i++) {
            assert_int_equal(found[i], count[i]);
            if (found[i] < 0 && first == ALGSURF_OK) first = (algsurf_status)found[i];
            if (found[i] > 0)
                assert_memory_equal(roots + i * p->n, single[i], (size_t)count[i] * sizeof *roots);
        }
        assert_int_equal(status, first);
    }
}

/* A unit in the last place wide, or two about a root that is nearly a double; a part that is far below the
 * other one may be wider. */
static void check_width(algsurf_interval part, double at, double size) {
    double width = part.hi - part.lo;
    assert_true(width <= 2 * DBL_EPSILON * fabs(at) || width <= 0x1p-70 * size);
}

/* How many of them each kernel solves in lanes: all the same ones, one by one or not, with the same bits. */
static int solved_in_lanes(const problem *p, int real) {
    batch b;
    algsurf_complex_root one[MOST], roots[MANY * MOST];
    int found[MANY], before[MANY], solved = 0;
    set_batch(&b, p, real);
    for (size_t k = 0, kernels = 0; k < sizeof names / sizeof *names; k++) {
        const algsurf_i_kernel *kernel = algsurf_i_kernel_find(names[k]);
        if (!kernel) continue;
        const algsurf_i_allroots_kernel *code = algsurf_i_allroots_kernel_for(kernel);
        code->many(&b.packet.re, &b.packet.im, p->n, MANY, roots, found);
        if (kernels++ > 0) assert_memory_equal(found, before, sizeof found);
        memcpy(before, found, sizeof found);
        solved = 0;
        for (int i = 0; i < MANY; i++) {
            int alone = code->one(p[i].re, real ? NULL : p[i].im, 1, p->n, one);
            assert_int_equal(alone, found[i] > 0);
            if (alone) assert_memory_equal(one, roots + i * p->n, (size_t)p->n * sizeof *one);
            solved += alone;
            for (int j = 0; alone && j < p->n; j++) {
                double size = hypot(one[j].root.re, one[j].root.im);
                check_width(one[j].box.re, one[j].root.re, size);
                check_width(one[j].box.im, one[j].root.im, size);
            }
        }
    }
    return solved;
}

/* Which the public calls solve as real ones. */
static int any_real(const problem p[MANY]) {
    for (int i = 0; i < MANY; i++) {
        int real = 1;
        for (int k = 0; k <= p->n; k++) real = real && p[i].im[k] == 0;
        if (real) return 1;
    }
    return 0;
}

TEST(boxes_hold_their_roots) {
    int solved[KINDS] = {0}, tried[KINDS] = {0};
    for (int round = 0; round < 280; round++) {
        problem p[MANY];
        int n = 1 + below(MOST), kind = round % KINDS, real = below(2);
        for (int i = 0; i < MANY; i++) p[i] = random_problem(n, kind, real);
        compare(p, real, round % 2);
        if (!real && any_real(p)) continue;
        tried[kind] += MANY;
        solved[kind] += solved_in_lanes(p, real);
    }
    for (int k = 0; k < KINDS; k++) print_message("kind %d: %d of %d in lanes\n", k, solved[k], tried[k]);
    assert_true(solved[PLAIN] * 50 >= tried[PLAIN] * 49);
    assert_true(solved[CLUSTERED] * 4 >= tried[CLUSTERED] && solved[CLUSTERED] < tried[CLUSTERED]);
}

/* Nearly double roots, b = 0, sizes far apart. */
TEST(quadratics) {
    int solved = 0, tried = 0;
    for (int round = 0; round < 400; round++) {
        problem p[MANY];
        for (int i = 0; i < MANY; i++) {
            double x = uniform(), gap = ldexp(uniform(), -below(round % 2 ? 18 : 60));
            p[i] = (problem){.n = 2, .real = 1, .re = {x * x - gap, -2 * x, 1}};
            if (below(4) == 0) p[i] = random_problem(2, below(KINDS), 1);
            if (below(8) == 0) p[i].re[1] = 0;
            if (below(8) == 0) p[i].re[below(3)] *= ldexp(1, below(600) - 300);
        }
        compare(p, 1, 1);
        tried += MANY;
        solved += solved_in_lanes(p, 1);
    }
    assert_true(solved * 4 >= tried * 3);
}

/* Roots at 0, multiple ones, degrees that drop, numbers out of range: never in lanes, and never wrong. */
TEST(hard_ones) {
    static const double cases[][4] = {{0, 0, 1, 0},       {0, 0, 1, 1},        {0, 1, 2, 1},
                                      {1, 2, 1, 0},       {0, -2, 1, 1},       {0, 0, 0, 0},
                                      {0, 0, 0, 1},       {1, 1, 1, 0x1p-400}, {0x1p-500, 1, 1, 1},
                                      {1, 1, 0x1p400, 1}, {5, 0, 0, 0}};
    problem p[MANY];
    for (int i = 0; i < MANY; i++) {
        p[i] = (problem){.n = 3, .real = 1};
        memcpy(p[i].re, cases[i], sizeof cases[i]);
    }
    compare(p, 1, 1);
    assert_int_equal(solved_in_lanes(p, 1), 0);
    for (int i = 0; i < MANY; i++) p[i].re[1] = i == 3 ? NAN : i == 7 ? HUGE_VAL : 1;
    compare(p, 1, 0);
    assert_int_equal(algsurf_complex_roots_batch(NULL, NULL, NULL, NULL), ALGSURF_E_ARGUMENT);
}

/* Complex numbers by rows, as algsurf_complex keeps them: the bits of single calls. */
TEST(rows_of_numbers) {
    static algsurf_complex z[MANY][MOST + 1];
    static algsurf_complex_root roots[MANY * MOST], single[MOST];
    int found[MANY], count;
    for (int n = 1; n <= 12; n++) {
        const ptrdiff_t row = 2 * (MOST + 1);
        const algsurf_complex_batch rows = {.size = sizeof rows,
                                            .count = MANY,
                                            .degree = n,
                                            .re = {&z[0][0].re, 2, row},
                                            .im = {&z[0][0].im, 2, row}};
        for (int i = 0; i < MANY; i++) {
            problem p = random_problem(n, PLAIN, 0);
            for (int k = 0; k <= n; k++) z[i][k] = (algsurf_complex){p.re[k], p.im[k]};
        }
        assert_ok(algsurf_complex_roots_batch(&rows, NULL, roots, found));
        for (int i = 0; i < MANY; i++) {
            assert_ok(algsurf_complex_roots(z[i], NULL, n, single, &count));
            assert_int_equal(found[i], count);
            assert_memory_equal(single, roots + i * n, (size_t)count * sizeof *single);
        }
    }
}

/* A bad number, or zero alone, is refused alone; of degree 0 there are no roots. */
TEST(bad_polynomials) {
    static const double bad[] = {(double)NAN, (double)INFINITY, -(double)INFINITY};
    for (int round = 0; round < 400; round++) {
        problem p[MANY];
        int n = round % 13, real = below(2);
        for (int i = 0; i < MANY; i++) {
            p[i] = random_problem(n, PLAIN, real);
            int how = below(8), k = below(n + 1);
            if (how < 3) p[i].re[k] = bad[how];
            if (how == 3 && !real) p[i].im[k] = bad[below(3)];
            for (int m = 0; how == 4 && m <= n; m++) p[i].re[m] = p[i].im[m] = 0;
        }
        compare(p, real, 0);
    }
}

/* Real ones among complex ones, radii, and misuse. */
TEST(the_interface) {
    problem p[MANY];
    batch b;
    algsurf_complex_root roots[MANY * MOST], single[MOST];
    int found[MANY], count;
    double radii[MOST + 1];
    static const double spread[MANY] = {0x1p-30, 0x1p-30, 0, 0x1p-20, 0, 0x1p-10, 0, 0, 0, 0, 0};
    for (int round = 0; round < 20; round++) {
        for (int i = 0; i < MANY; i++) {
            p[i] = random_problem(5, PLAIN, round % 2 ? 1 : below(2));
            p[i].real = 0; /* algsurf_complex_roots, which sees for itself */
        }
        compare(p, 0, 0);
    }
    for (int i = 0; i < MANY; i++) p[i] = random_problem(5, PLAIN, 1);
    set_batch(&b, p, 1);
    b.packet.radii = (algsurf_table){spread, 0, 1};
    assert_ok(algsurf_complex_roots_batch(&b.packet, NULL, roots, found));
    for (int i = 0; i < MANY; i++) {
        for (int k = 0; k <= 5; k++) radii[k] = spread[i];
        assert_ok(algsurf_complex_roots_of_real(p[i].re, radii, 5, single, &count));
        assert_int_equal(count, found[i]);
        assert_memory_equal(single, roots + i * 5, (size_t)count * sizeof *single);
    }
    const algsurf_batch_options unknown = {.size = sizeof unknown, .kernel = "none"}, small = {.size = 1},
                                coarse = {.size = sizeof coarse, .relative_tolerance = 0.5};
    algsurf_complex_batch bad = b.packet;
    found[0] = 77;
    assert_int_equal(algsurf_complex_roots_batch(&bad, &unknown, roots, found), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_complex_roots_batch(&bad, &small, roots, found), ALGSURF_E_SIZE);
    assert_int_equal(algsurf_complex_roots_batch(&bad, &coarse, roots, found), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_complex_roots_batch(&bad, NULL, NULL, found), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_complex_roots_batch(&bad, NULL, roots, NULL), ALGSURF_E_ARGUMENT);
    bad.degree = -1;
    assert_int_equal(algsurf_complex_roots_batch(&bad, NULL, roots, found), ALGSURF_E_ARGUMENT);
    bad.degree = ALGSURF_MAX_POLY_DEGREE + 1;
    assert_int_equal(algsurf_complex_roots_batch(&bad, NULL, roots, found), ALGSURF_E_DEGREE);
    bad.degree = 5, bad.re.at = NULL;
    assert_int_equal(algsurf_complex_roots_batch(&bad, NULL, roots, found), ALGSURF_E_ARGUMENT);
    assert_int_equal(found[0], 77);
    bad.count = 0;
    assert_ok(algsurf_complex_roots_batch(&bad, NULL, NULL, NULL));
}
