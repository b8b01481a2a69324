/* test_verified_roots.c - what the benchmarks rest on: bench/measure, and the judge of verified_roots.
 *
 * The judge must find nothing wrong with true answers and something with each false one.  Breaks tried, each
 * caught by the test named:
 *   seconds not divided by calls                                                    seconds_of_a_call
 *   the product not compared, in another order than Leja's, with a factor twice     judge_finds
 *   boxes that meet not looked for, only one direction between two answers          judge_finds
 *   a root counted twice                                                            roots_are_counted_once
 *   the ray not re-centred, the chord twice as long                                 rays_are_recentred
 *   the neighbour's roots left in its own variable, or not sorted                   neighbours_are_near
 */
#include "unit.h"
#include "verified_roots.h"

static const uint64_t SEED = 20241;

/* ---- measure ---- */

TEST(quantiles) {
    double x[5] = {3, -1, 4, 1, 5};
    measure_sort(x, 5);
    assert_true(x[0] == -1 && x[1] == 1 && x[2] == 3 && x[3] == 4 && x[4] == 5);
    assert_true(measure_quantile(x, 5, 0) == -1 && measure_quantile(x, 5, 1) == 5);
    assert_true(measure_quantile(x, 5, 0.5) == 3 && measure_quantile(x, 4, 0.5) == 1);
    assert_true(measure_quantile(x, 5, 0.2) == -1 && measure_quantile(x, 5, 0.21) == 1);
    assert_true(measure_quantile(x, 1, 0.99) == -1);
}

/* The published first numbers of splitmix64 from the seed 1234567. */
TEST(random_numbers) {
    static const uint64_t expected[3] = {6457827717110365317u, 3203168211198807973u, 9817491932198370423u};
    measure_random random = {1234567};
    double least = 1, most = 0;
    for (int i = 0; i < 3; i++) assert_true(measure_bits(&random) == expected[i]);
    for (int i = 0; i < 1000; i++) {
        double x = measure_uniform(&random, -3, 5);
        assert_true(x >= -3 && x <= 5);
        least = fmin(least, x), most = fmax(most, x);
    }
    assert_true(least < -2.9 && most > 4.9);
}

/* Uses 30 microseconds of CPU time. */
static void spin(void *data) {
    double begin = measure_cpu();
    while (measure_cpu() - begin < 30e-6) {
    }
    ++*(int *)data;
}

/* One call is too short for the clock to tell, two never are: 1 + 2 calls, or 1 that was disturbed. */
TEST(seconds_of_a_call) {
    int calls = 0;
    double begin = measure_cpu(), seconds = measure_call(spin, &calls), all = measure_cpu() - begin;
    assert_true(calls == 1 || calls == 3);
    assert_true(seconds >= 30e-6 && seconds * (calls == 1 ? 1 : 2) <= all);
}

/* ---- polynomials ---- */

static polynomial *rays(const char *name, int count) {
    measure_random random = {SEED};
    polynomial *p = calloc((size_t)count, sizeof *p);
    assert_non_null(p);
    polynomials_of_rays(catalogue_find(name), &random, p, count);
    return p;
}

static algsurf_complex value_at(const polynomial *p, double x) {
    algsurf_complex v = {0, 0};
    for (int k = p->degree; k >= 0; k--) v = (algsurf_complex){v.re * x + p->c[k].re, v.im * x + p->c[k].im};
    return v;
}

/* The unit sphere in a ball of radius 1.2: at both ends of a chord x^2 + y^2 + z^2 - 1 = 0.44, or a
 * little more, as chords are rounded outward. */
TEST(rays_are_recentred) {
    enum { COUNT = 200 };
    polynomial *p = rays("sphere", COUNT);
    int hits = 0;
    for (int i = 0; i < COUNT; i++) {
        algsurf_complex a = value_at(&p[i], -1), b = value_at(&p[i], 1), middle = value_at(&p[i], 0);
        assert_int_equal(p[i].degree, 2);
        assert_true(fabs(a.re - 0.44) < 1e-11 && fabs(b.re - 0.44) < 1e-11 && a.im == 0 && b.im == 0);
        hits += middle.re < 0;
    }
    assert_in_range(hits, COUNT / 2, COUNT - 10); /* (1 / 1.2)^2 = 0.69 in parallel projection */
    free(p);
}

static double distance(algsurf_complex a, algsurf_complex b) { return hypot(a.re - b.re, a.im - b.im); }

TEST(neighbours_are_near) {
    enum { COUNT = 200 };
    polynomial *p = rays("barth-decic", COUNT);
    int near = 0, roots = 0;
    for (int i = 0; i < COUNT; i++) {
        algsurf_complex_root root[ALGSURF_MAX_DEGREE];
        int count;
        if (!p[i].has_near) continue;
        assert_ok(algsurf_complex_roots(p[i].c, NULL, p[i].degree, root, &count));
        for (int k = 0; k < p[i].degree; k++) {
            const algsurf_complex z = p[i].near[k], zero = {0, 0};
            double least = INFINITY;
            assert_true(k == 0 || distance(z, zero) >= distance(p[i].near[k - 1], zero));
            for (int j = 0; j < count; j++) least = fmin(least, distance(z, root[j].root));
            near += least < 0.01 * (1 + distance(z, zero));
            roots++;
        }
    }
    assert_in_range(roots, COUNT * 9, COUNT * 10);
    assert_true(near > roots * 9 / 10);
    free(p);
}

/* ---- the judge ---- */

static answer true_answer(const polynomial *p) {
    algsurf_complex_root root[ALGSURF_MAX_DEGREE];
    answer a = {.complete = 1};
    assert_ok(algsurf_complex_roots(p->c, NULL, p->degree, root, &a.count));
    for (int i = 0; i < a.count; i++)
        a.root[i] = (answer_root){root[i].box, root[i].root, root[i].multiplicity, root[i].multiplicity == 1};
    return a;
}

/* Moves a box and its value by dx along the real axis. */
static void move(answer_root *root, double dx) {
    root->box.re.lo += dx;
    root->box.re.hi += dx;
    root->value.re += dx;
}

/* The judge says nothing, or something with the word expected; if not, the polynomial is printed. */
static void assert_said(const polynomial *p, const char *expected, const char *said) {
    if (expected && said ? strstr(said, expected) != NULL : !expected && !said) return;
    print_error("seed %llu, expected %s, got %s:", (unsigned long long)SEED, expected ? expected : "nothing",
                said ? said : "nothing");
    for (int k = 0; k <= p->degree; k++) print_error(" %a,%a", p->c[k].re, p->c[k].im);
    print_error("\n");
    fail();
}

/* One root of the answer is made wrong in every way there is. */
static void judge_one(const polynomial *p, int k) {
    const answer right = true_answer(p);
    answer a = right;
    assert_said(p, NULL, contradiction(p, &right));
    assert_said(p, NULL, contradiction_between(&right, &right));

    move(&a.root[k], 1e-6 * fmax(0.1, fabs(a.root[k].value.re)));
    assert_said(p, "product", contradiction(p, &a));
    assert_said(p, "no root", contradiction_between(&a, &right));
    a.complete = 0;
    assert_said(p, NULL, contradiction(p, &a));
    assert_said(p, "no root", contradiction_between(&a, &right));
    a.root[k].multiplicity = 0;
    assert_said(p, NULL, contradiction_between(&a, &right));

    a = right, a.root[k].value.re = a.root[k].box.re.hi + 1;
    assert_said(p, "outside", contradiction(p, &a));
    a = right, a.root[k].multiplicity++;
    assert_said(p, "add up", contradiction(p, &a));
    a = right, a.root[k].multiplicity = 0;
    assert_said(p, "without roots", contradiction(p, &a));
    a = right, a.root[k] = a.root[(k + 1) % a.count];
    assert_said(p, "meet", contradiction(p, &a));
    assert_said(p, "no box", contradiction_between(&a, &right));
    polynomial q = *p;
    q.c[k].im += 1e-6 * fabs(q.c[q.degree].re);
    assert_said(&q, "product", contradiction(&q, &right));
}

TEST(judge_finds) {
    enum { COUNT = 20 };
    static const char *const names[3] = {"torus", "boy", "barth-decic"};
    static const int degrees[3] = {7, 32, 64};
    for (int s = 0; s < 3; s++) {
        measure_random random = {SEED};
        polynomial *p = rays(names[s], COUNT);
        for (int i = 0; i < COUNT; i++) judge_one(&p[i], i % p[i].degree);
        polynomials_at_random(degrees[s], &random, p, COUNT);
        for (int i = 0; i < COUNT; i++) judge_one(&p[i], i % p[i].degree);
        free(p);
    }
}

/* (X-1)^2 (X+2): a cluster counts as often as it says. */
TEST(clusters_are_judged) {
    const polynomial p = {.degree = 3, .c = {{2, 0}, {-3, 0}, {0, 0}, {1, 0}}};
    answer a = true_answer(&p);
    assert_int_equal(a.count, 2);
    assert_said(&p, NULL, contradiction(&p, &a));
    assert_int_equal(simple_roots(&a), 1);
    int cluster = a.root[0].multiplicity == 2 ? 0 : 1;
    a.root[cluster].multiplicity = 1;
    a.root[1 - cluster].multiplicity = 2;
    assert_said(&p, "product", contradiction(&p, &a));
}

TEST(roots_are_counted_once) {
    const polynomial p = {.degree = 3, .c = {{-6, 0}, {11, 0}, {-6, 0}, {1, 0}}}; /* roots 1, 2, 3 */
    answer a = true_answer(&p);
    assert_int_equal(simple_roots(&a), 3);
    a.root[2] = a.root[0];
    assert_int_equal(simple_roots(&a), 2);
    a.root[0].simple = 0; /* what is not proved hides nothing */
    assert_int_equal(simple_roots(&a), 2);
    a.root[1].simple = 0;
    assert_int_equal(simple_roots(&a), 1);
}
