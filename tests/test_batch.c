/* test_batch.c - first roots of many polynomials: states against the single calls, roots against a Sturm
 * chain over integers, bits of one kernel against those of the others.
 *
 * Breaks caught, each tried: the error radius left out, of whole polynomials or of cells, what lies behind an
 * empty cell forgotten, an undecided lane told as one without a root, a scaled lane's radius not scaled, an
 * answer of another polynomial beside a bad one, a kernel that decides nothing, a root refined in the
 * unit of its bracket, where values underflow.  Not caught: a cut's
 * error left out, Halley's step taken where it is no better than none.
 */
#include "exact_roots.h"

#include "algsurf/intersect.h"
#include "algsurf/isolate.h"
#include "algsurf/batch.h"
#include "algsurf/poly.h"
#include "environments.h"
#include "roots/polys.h"
#include "unit.h"

#define SEED 71u
enum { MOST = 131, TOP = 40 };

static double c[TOP + 1][MOST], r[TOP + 1][MOST], lo[MOST], hi[MOST];

typedef struct answers {
    unsigned char state[MOST];
    double root[MOST];
    algsurf_status status;
} answers;

static algsurf_real_batch packet_of(int degree, size_t first, size_t count, int radii) {
    return (algsurf_real_batch){.size = sizeof(algsurf_real_batch),
                                .count = count,
                                .degree = degree,
                                .coefficients = {c[0] + first, MOST, 1},
                                .radii = {radii ? r[0] + first : NULL, MOST, 1},
                                .lo = lo + first,
                                .hi = hi + first,
                                .interval_step = 1};
}

static void solve(int degree, size_t first, size_t count, int radii, const char *kernel, answers *to) {
    algsurf_real_batch p = packet_of(degree, first, count, radii);
    algsurf_batch_options options = {.size = sizeof options, .kernel = kernel};
    to->status = algsurf_first_roots_batch(&p, &options, to->state + first, to->root + first);
}

static _Noreturn void complain(const char *what, int degree, int i, const answers *a, int expected) {
    double one[TOP + 1], radius[TOP + 1];
    for (int k = 0; k <= degree; k++) one[k] = c[k][i], radius[k] = r[k][i];
    exact_print_doubles("c", one, degree + 1);
    exact_print_doubles("r", radius, degree + 1);
    fail_msg("%s: degree %d on [%a, %a], number %d: state %d, root %a, expected %d (seed %u)", what, degree,
             lo[i], hi[i], i, a->state[i], a->root[i], expected, SEED);
    abort();
}

static int same(const answers *a, const answers *b, size_t count) {
    return memcmp(a->state, b->state, count) == 0 && memcmp(a->root, b->root, count * sizeof *a->root) == 0;
}

/* The call for the first root of one says what the batch does, bit for bit. */
static int same_alone(const double *one, int degree, int i, const answers *a, algsurf_status refused) {
    double root = 0.5;
    int found = 7, known = a->state[i] == ALGSURF_FIRST_ROOT_FOUND;
    if (algsurf_real_root_first(one, degree, lo[i], hi[i], &root, &found) != refused) return 0;
    if (refused != ALGSURF_OK) return root == 0.5 && found == 7;
    return found == known && memcmp(&root, known ? a->root + i : &(double){0.5}, sizeof root) == 0;
}

/* Single calls say the same; with radii the packet may know more. */
static void check_states(int degree, int count, int radii, const answers *a, int seen[5]) {
    algsurf_status first = ALGSURF_OK;
    for (int i = 0; i < count; i++) {
        double one[TOP + 1], radius[TOP + 1];
        algsurf_bracket b;
        int found = 0;
        for (int k = 0; k <= degree; k++) one[k] = c[k][i], radius[k] = r[k][i];
        algsurf_status status =
            algsurf_isolate_first(one, radii ? radius : NULL, degree, lo[i], hi[i], NULL, &b, &found);
        int expected = status < 0   ? ALGSURF_FIRST_ROOT_REFUSED
                       : status > 0 ? ALGSURF_FIRST_ROOT_UNDECIDED
                                    : found;
        if (first == ALGSURF_OK && status < 0) first = status;
        if (a->state[i] != expected && !(radii && expected == ALGSURF_FIRST_ROOT_UNDECIDED))
            complain("another state", degree, i, a, expected);
        if ((expected == ALGSURF_FIRST_ROOT_NONE || status < 0) && a->root[i] != (double)INFINITY)
            complain("a root of none", degree, i, a, expected);
        if (!radii && !same_alone(one, degree, i, a, status)) complain("alone", degree, i, a, expected);
        seen[expected]++;
        if (expected != ALGSURF_FIRST_ROOT_FOUND) continue;
        int inside = lo[i] <= a->root[i] && a->root[i] <= hi[i];
        if (!inside) complain("a root outside", degree, i, a, expected);
    }
    assert_int_equal(a->status, first);
}

static algsurf_real_root all_roots[MOST * TOP], alone_roots[MOST][TOP];
static int counts[MOST], alone_counts[MOST];

/* Single calls for all roots. */
static void solve_alone(int degree, int count) {
    double one[TOP + 1];
    for (int i = 0; i < count; i++) {
        for (int k = 0; k <= degree; k++) one[k] = c[k][i];
        algsurf_status status =
            algsurf_real_roots(one, degree, lo[i], hi[i], alone_roots[i], TOP, alone_counts + i);
        if (status < 0) alone_counts[i] = status;
    }
}

/* All roots of polynomial i are the single call's. */
static int same_roots(int degree, int i) {
    const size_t size = counts[i] > 0 ? (size_t)counts[i] * sizeof **alone_roots : 0;
    return counts[i] == alone_counts[i] && memcmp(all_roots + i * degree, alone_roots[i], size) == 0;
}

static exact_sturm sturm_of(int degree, int i) {
    double one[TOP + 1];
    for (int k = 0; k <= degree; k++) one[k] = c[k][i];
    return exact_sturm_of_doubles(one, degree);
}

/* The chain counts as many, and one at least between each pair of neighbours. */
static int true_roots(int degree, int i) {
    const algsurf_real_root *root = all_roots + i * degree;
    exact_sturm s = sturm_of(degree, i);
    int right = exact_count_roots(&s, lo[i], hi[i]) == counts[i];
    for (int k = 0; k < counts[i]; k++) {
        right &= root[k].lo == root[k].hi || nextafter(root[k].lo, (double)INFINITY) == root[k].hi;
        right &= exact_count_roots(&s, root[k].lo, root[k].hi) >= 1;
        right &= k == 0 || root[k - 1].lo <= root[k].lo;
    }
    exact_sturm_clear(&s);
    return right;
}

/* With every kernel; a chain for each polynomial where they are `judged`. */
static void check_all(int degree, int count, int judged) {
    static const char *const told = "all roots";
    algsurf_real_batch p = packet_of(degree, 0, (size_t)count, 0);
    algsurf_batch_options options = {.size = sizeof options};
    answers none = {.state = {0}};
    solve_alone(degree, count);
    for (int i = 0; (options.kernel = algsurf_kernel_name(i)); i++) {
        memset(all_roots, 0x55, sizeof all_roots);
        algsurf_status status = algsurf_real_roots_batch(&p, &options, all_roots, counts);
        for (int j = 0; j < count; j++)
            if (!same_roots(degree, j)) complain(told, degree, j, &none, counts[j]);
        int bad = 0;
        while (bad < count && counts[bad] >= 0) bad++;
        assert_int_equal(status, bad < count ? counts[bad] : ALGSURF_OK);
    }
    for (int j = 0; j < count && degree <= 12 && judged; j++)
        if (counts[j] >= 0 && !true_roots(degree, j)) complain(told, degree, j, &none, counts[j]);
}

/* All kernels, then single calls; returns through seen how often each state came. */
static void check_kernels(int degree, int count, int radii, int judged, answers *a, int seen[5]) {
    answers other;
    solve(degree, 0, (size_t)count, radii, NULL, a);
    const char *name;
    for (int i = 0; (name = algsurf_kernel_name(i)); i++) {
        memset(&other, 0x55, sizeof other);
        solve(degree, 0, (size_t)count, radii, name, &other);
        for (int j = 0; j < count; j++)
            if (a->state[j] != other.state[j] || memcmp(a->root + j, other.root + j, sizeof *a->root) != 0)
                complain(name, degree, j, &other, a->state[j]);
        assert_int_equal(other.status, a->status);
    }
    check_states(degree, count, radii, a, seen);
    if (!radii) check_all(degree, count, judged);
}

static void check(int degree, int count, int radii, answers *a, int seen[5]) {
    check_kernels(degree, count, radii, 1, a, seen);
}

/* Against the chain's first root. */
static void check_roots(int degree, int count, const answers *a, double tolerance) {
    for (int i = 0; i < count; i++) {
        if (a->state[i] >= ALGSURF_FIRST_ROOT_UNDECIDED) continue;
        exact_sturm s = sturm_of(degree, i);
        int roots = exact_count_roots(&s, lo[i], hi[i]);
        if ((roots > 0) != (a->state[i] == ALGSURF_FIRST_ROOT_FOUND))
            complain("not true", degree, i, a, roots > 0);
        if (roots > 0) {
            double root = exact_root(&s, lo[i], hi[i], 0), error = fabs(a->root[i] - root);
            if (!(error <= tolerance * (hi[i] - lo[i]) + 0x1p-52 * fabs(root)))
                complain("root is off", degree, i, a, 1);
        }
        exact_sturm_clear(&s);
    }
}

/* c of polynomial i becomes scale prod (t - root) prod ((t - a)^2 + e), in long double. */
static void put_product(int i, int degree, const double *roots, int count, uint64_t *random) {
    long double p[TOP + 3] = {1};
    int n = 0;
    for (; n < count && n < degree; n++)
        for (int k = n + 1; k >= 0; k--) p[k] = (k > 0 ? p[k - 1] : 0) - roots[n] * p[k];
    while (n + 2 <= degree) {
        double a = random_unit(random), e = 0.1 + fabs(random_unit(random));
        for (int k = n + 2; k >= 0; k--)
            p[k] = (k > 1 ? p[k - 2] : 0) - 2 * a * (k > 0 ? p[k - 1] : 0) + (a * a + e) * p[k];
        n += 2;
    }
    for (int k = 0; k <= degree; k++) c[k][i] = k <= n ? (double)p[k] : 0;
}

static void put_random(int degree, uint64_t *random) {
    for (int i = 0; i < MOST; i++) {
        double roots[TOP];
        int count = degree < 20 ? random_int(random, degree + 1) : random_int(random, 4);
        for (int k = 0; k < count; k++) roots[k] = 1.5 * random_unit(random);
        put_product(i, degree, roots, count, random);
        lo[i] = random_unit(random) - 1;
        hi[i] = lo[i] + 1.5 + random_unit(random);
    }
}

static const int degrees[] = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 20, 40};
#define EACH_DEGREE(n) for (int d_ = 0, n; d_ < 14 && (n = degrees[d_], 1); d_++)

TEST(test_random) {
    uint64_t random = SEED;
    EACH_DEGREE(n) {
        int seen[5] = {0};
        answers a;
        for (int round = 0; round < 2; round++) {
            put_random(n, &random);
            check(n, MOST, 0, &a, seen);
            if (n <= 12) check_roots(n, MOST, &a, 1e-11);
        }
        assert_often(seen[0] >= MOST / 16 && seen[1] >= MOST / 8 && seen[2] <= MOST / 16);
    }
}

/* c of polynomial i becomes ((t - at)^2 + gap), times quadratics without real roots. */
static void put_grazing(int i, int n, double at, double gap, uint64_t *random) {
    put_product(i, n - 2, NULL, 0, random);
    double q[3] = {at * at + gap, -2 * at, 1}, p[TOP + 1];
    for (int k = 0; k <= n; k++) {
        p[k] = 0;
        for (int j = 0; j <= 2; j++) p[k] += k >= j && k - j <= n - 2 ? q[j] * c[k - j][i] : 0;
    }
    for (int k = 0; k <= n; k++) c[k][i] = p[k];
    lo[i] = -1;
    hi[i] = 1;
}

TEST(test_grazing) {
    uint64_t random = SEED + 1;
    EACH_DEGREE(n) {
        int seen[5] = {0};
        answers a;
        if (n < 2 || n > 12) continue;
        for (int i = 0; i < MOST; i++) {
            double at = 0.5 * random_unit(&random), e = pow(10, -5.5 + 3.5 * random_unit(&random));
            put_grazing(i, n, at, i % 2 ? e * e : -e * e, &random);
        }
        check(n, MOST, 0, &a, seen);
        check_roots(n, MOST, &a, 1e-11);
        assert_true(seen[0] > MOST / 4 && seen[1] > MOST / 4);
    }
}

/* No root, but one within the radii for half of them: what is said must be true at their end too. */
TEST(test_touching) {
    uint64_t random = SEED + 12;
    EACH_DEGREE(n) {
        int seen[5] = {0};
        answers a;
        if (n < 2 || n > 12) continue;
        for (int i = 0; i < MOST; i++) {
            double at = 0.5 * random_unit(&random), f = 0;
            put_grazing(i, n, at, pow(10, -5 + 4 * random_unit(&random)), &random);
            for (int k = n; k >= 0; k--) f = f * at + c[k][i];
            for (int k = 1; k <= n; k++) r[k][i] = 0;
            r[0][i] = (i % 2 ? 2 : 0.25) * f;
        }
        check(n, MOST, 1, &a, seen);
        for (int i = 0; i < MOST; i++) c[0][i] -= 0.99 * r[0][i];
        check_roots(n, MOST, &a, INFINITY);
        assert_true(seen[0] > MOST / 4 && seen[2] > MOST / 4);
    }
}

/* Dyadic roots, so that products are exact: at ends, twice, at 0; leading zeros; zero polynomials. */
TEST(test_special) {
    uint64_t random = SEED + 2;
    for (int n = 1; n <= 6; n++)
        for (int round = 0; round < 4; round++) {
            int seen[5] = {0};
            answers a;
            for (int i = 0; i < MOST; i++) {
                double roots[TOP];
                int count = random_int(&random, n + 1);
                for (int k = 0; k < count; k++) roots[k] = (random_int(&random, 9) - 4) * 0.25;
                for (int k = 0; k <= n; k++) c[k][i] = 0;
                long double p[TOP + 1] = {i % 16 ? 1 : 0};
                for (int m = 0; m < count; m++)
                    for (int k = m + 1; k >= 0; k--) p[k] = (k > 0 ? p[k - 1] : 0) - roots[m] * p[k];
                for (int k = 0; k <= count; k++) c[k][i] = (double)p[k];
                lo[i] = -0.25 * (1 + random_int(&random, 4));
                hi[i] = 0.25 * (1 + random_int(&random, 4));
            }
            check(n, MOST, 0, &a, seen);
            check_roots(n, MOST, &a, 1e-11);
        }
    answers a;
    int seen[5] = {0};
    lo[0] = -1, hi[0] = 1;
    c[0][0] = 0;
    check(0, 1, 0, &a, seen);
    assert_int_equal(a.status, ALGSURF_E_ZERO);
    c[0][0] = 3;
    check(0, 1, 0, &a, seen);
    assert_int_equal(a.state[0], ALGSURF_FIRST_ROOT_NONE);
}

/* The chord over the interval crosses zero where p has no slope. */
TEST(test_flat) {
    static const double flat[] = {0x1.30cf06dd576e4p-6, 0x1.2b1293cc71dfdp-3, 0x1.d9c2916bb8cc5p-3,
                                  -0x1.e1fceae2a32dfp-3};
    uint64_t random = SEED + 11;
    int seen[5] = {0};
    answers a;
    for (int i = 0; i < MOST; i++) {
        for (int k = 0; k < 4; k++) c[k][i] = flat[k];
        c[0][i] += i * 0x1p-16 * random_unit(&random);
        hi[i] = 0x1.f942p+0; /* of -lo and hi: the chord's root is at p's maximum */
        lo[i] = -hi[i];
    }
    check(3, MOST, 0, &a, seen);
    check_roots(3, MOST, &a, 1e-11);
}

/* The first root is one of two that are close together, or just no longer there, near the ends of intervals
 * that may be short and far from 0; coefficients are moved by ulps.  Errors are within what is promised. */
TEST(test_aimed) {
    uint64_t random = SEED + 13;
    int found = 0;
    for (int round = 0; round < 24; round++) {
        int n = round % 4 < 2 ? 2 : round % 4 == 2 ? 1 : 3 + round / 4, seen[5] = {0};
        answers a;
        for (int i = 0; i < MOST; i++) {
            double at = 4 * random_unit(&random), length = exp2(-15 + 15 * random_unit(&random)),
                   gap = exp2(-25 + 20 * random_unit(&random));
            double roots[TOP] = {at - gap * length, at + gap * length};
            for (int k = 2; k < n; k++) roots[k] = at + 2 * length + 4 * fabs(random_unit(&random));
            put_product(i, n, roots, n, &random);
            for (int k = 0; k <= n; k++)
                for (int j = random_int(&random, 5) - 2; j; j -= j > 0 ? 1 : -1)
                    c[k][i] = nextafter(c[k][i], j > 0 ? HUGE_VAL : -HUGE_VAL);
            lo[i] = at - length * (0.5 + 0.6 * random_unit(&random));
            hi[i] = lo[i] + length;
        }
        check(n, MOST, 0, &a, seen);
        check_roots(n, MOST, &a, 1e-12);
        found += seen[1];
    }
    assert_true(found > 6 * MOST);
    static const double close[][8] = {
        {0x1.6b3d055196627p+1, 0x1.6b3d0a741633dp+1, 0x1.01b30cd7af18fp+3, -0x1.6b3d04a24293dp+2, 1},
        {-0x1.d894e488377e5p+0, 0x1.b18297cebb729p+0, -0x1.a47cf4802fc82p+6, -0x1.4ed463d3d02b4p+8,
         -0x1.7469d4aa37926p+7, 0x1.f4b00d653bc41p+6, -0x1.40d500bc2da6fp+4, 1}};
    static const int degree[] = {2, 5};
    for (int i = 0; i < 2; i++) {
        answers a;
        lo[0] = close[i][0], hi[0] = close[i][1];
        for (int k = 0; k <= degree[i]; k++) c[k][0] = close[i][2 + k];
        solve(degree[i], 0, 1, 0, NULL, &a);
        check_roots(degree[i], 1, &a, 1e-12);
    }
}

/* p(t / 2^e) 2^f has p's roots times 2^e, and nothing else changes. */
TEST(test_scale) {
    static const int at[][2] = {{0, 664}, {0, -664}, {100, 0}, {-100, 0}, {60, 300}, {-60, -300}, {0, 330}};
    uint64_t random = SEED + 3;
    for (int n = 1; n <= 8; n++)
        for (int j = 0; j < 7; j++) {
            int seen[5] = {0};
            answers plain, scaled;
            put_random(n, &random);
            check(n, MOST, 0, &plain, seen);
            int e = at[j][0], f = at[j][1];
            for (int i = 0; i < MOST; i++) {
                for (int k = 0; k <= n; k++) c[k][i] = ldexp(c[k][i], f - k * e);
                lo[i] = ldexp(lo[i], e);
                hi[i] = ldexp(hi[i], e);
            }
            check(n, MOST, 0, &scaled, seen);
            for (int i = 0; i < MOST; i++) {
                double error = fabs(ldexp(scaled.root[i], -e) - plain.root[i]);
                if (scaled.state[i] != plain.state[i])
                    complain("scale matters", n, i, &scaled, plain.state[i]);
                if (plain.state[i] == ALGSURF_FIRST_ROOT_FOUND && !(error <= 1e-11))
                    complain("root scales", n, i, &scaled, 1);
            }
        }
}

/* Intervals far from 0 in their own length, down to neighbouring doubles. */
TEST(test_narrow) {
    uint64_t random = SEED + 4;
    for (int n = 1; n <= 6; n++) {
        int seen[5] = {0};
        answers a;
        put_random(n, &random);
        for (int i = 0; i < MOST; i++) {
            double width = ldexp(1, -random_int(&random, 50));
            lo[i] = random_unit(&random);
            hi[i] = fmax(lo[i] + width, nextafter(lo[i], 2));
        }
        check(n, MOST, 0, &a, seen);
        check_roots(n, MOST, &a, 1e-11);
    }
}

TEST(test_radii) {
    uint64_t random = SEED + 5;
    EACH_DEGREE(n) {
        int seen[5] = {0};
        answers a;
        put_random(n, &random);
        double size = ldexp(1, -random_int(&random, 40));
        for (int i = 0; i < MOST; i++)
            for (int k = 0; k <= n; k++) r[k][i] = i % 4 ? size * fabs(random_unit(&random) * c[k][i]) : 0;
        check(n, MOST, 1, &a, seen);
        check_roots(n, n > 20 ? MOST / 8 : MOST, &a, INFINITY); /* c itself belongs to the set */
        for (int i = 0; i < MOST; i++)
            for (int k = 0; k <= n; k++) {
                c[k][i] = ldexp(c[k][i], -350);
                r[k][i] = ldexp(r[k][i], -350);
            }
        answers small;
        solve(n, 0, MOST, 1, NULL, &small);
        assert_memory_equal(small.state, a.state, MOST);
    }
}

/* One end, the other, or both: the single calls' answers, and those in finite intervals beside them as they
 * were. */
TEST(test_infinite_ends) {
    uint64_t random = SEED + 17;
    EACH_DEGREE(n) {
        int seen[5] = {0};
        answers finite, a;
        put_random(n, &random);
        for (int k = 0; k <= n; k++) c[k][5] = 0;
        solve(n, 0, MOST, 0, NULL, &finite);
        for (int i = 0; i < MOST; i++) {
            if (i % 4 & 1) lo[i] = -(double)INFINITY;
            if (i % 4 & 2) hi[i] = (double)INFINITY;
        }
        check(n, MOST, 0, &a, seen);
        for (int i = 0; i < MOST; i++) {
            double first = i % 4 == 0      ? finite.root[i]
                           : counts[i] > 0 ? all_roots[i * n].root
                                           : (double)INFINITY;
            if (a.root[i] != first || (a.state[i] == ALGSURF_FIRST_ROOT_FOUND && !isfinite(a.root[i])))
                complain("another root than the single call's", n, i, &a, counts[i]);
        }
        assert_often(seen[0] >= 4 && seen[1] >= MOST / 4 && seen[4] == 1);
        for (int i = 0; i < MOST; i++)
            for (int k = 0; k <= n; k++) r[k][i] = 0x1p-30 * fabs(c[k][i]);
        check(n, MOST, 1, &a, seen);
        for (int i = 0; i < MOST; i++)
            if (a.state[i] != ALGSURF_FIRST_ROOT_NONE && a.state[i] != ALGSURF_FIRST_ROOT_REFUSED &&
                !isfinite(a.root[i]))
                complain("no point", n, i, &a, a.state[i]);
    }
}

/* Neither the number of polynomials nor their neighbours matter, nor does what is behind get written. */
TEST(test_counts) {
    uint64_t random = SEED + 6;
    EACH_DEGREE(n) {
        answers all, some;
        put_random(n, &random);
        solve(n, 0, MOST, 0, NULL, &all);
        for (size_t first = 0, count = 0; count <= 17; first = (5 * first + 3) % 100, count++) {
            const char *name;
            for (int i = 0; (name = algsurf_kernel_name(i)); i++) {
                memset(&some, 0x55, sizeof some);
                solve(n, first, count, 0, name, &some);
                assert_memory_equal(some.state + first, all.state + first, count);
                assert_memory_equal(some.root + first, all.root + first, count * sizeof(double));
                assert_int_equal(some.state[first + count], 0x55);
                assert_int_equal(((unsigned char *)(some.root + first + count))[0], 0x55);
            }
        }
        algsurf_real_batch p = packet_of(n, 0, MOST, 0);
        assert_ok(algsurf_first_roots_batch(&p, NULL, some.state, NULL));
        assert_memory_equal(some.state, all.state, MOST);
    }
}

/* t^n + 2 t^(n-1) - sign: one root about -2, off by 2^-(n-1) or somewhat more. */
enum { HIGH = 511 };

static void check_wide(int n, double sign, double from, double to) {
    static double one[HIGH + 1];
    for (int k = 0; k <= n; k++) one[k] = k == n ? 1 : k == n - 1 ? 2 : k == 0 ? -sign : 0;
    const algsurf_real_batch p = {
        .size = sizeof p, .count = 1, .degree = n, .coefficients = {one, 1, 0}, .lo = &from, .hi = &to};
    algsurf_bracket b;
    unsigned char state;
    double root = 0;
    int found = 0;
    assert_ok(algsurf_first_roots_batch(&p, NULL, &state, &root));
    assert_int_equal(state, ALGSURF_FIRST_ROOT_FOUND);
    assert_ok(algsurf_isolate_first(one, NULL, n, from, to, NULL, &b, &found));
    /* what the kernels find is good to the interval, what is found alone to the root's own rounding */
    double room = 0x1p-52 * fabs(root) + (n <= 20 ? 1e-12 * (to - from) : 0);
    double left = fmax(root - room, b.lo), right = fmin(root + room, b.hi);
    int inside = b.lo <= root && root <= b.hi && (n <= 20 || fabs(root + 2) <= ldexp(2, 2 - n) + 0x1p-50);
    if (!inside || exact_poly_sign(one, n, left) * exact_poly_sign(one, n, right) > 0)
        fail_msg("t^%d + 2 t^%d - %g on [%a, %a]: root %a, in units of the interval %g off", n, n - 1, sign,
                 from, to, root, (root + 2) / (to - from));
}

/* The unit of the interval is not that of the root: in it the values of p about the root would underflow. */
TEST(test_wide_intervals) {
    static const int high[] = {4, 9, 19, 20, 21, 24, 29, 40, 63, 130, 255, 511};
    for (size_t i = 0; i < sizeof high / sizeof *high; i++)
        for (int e = 2; e <= 1000; e += high[i] > 100 ? 333 : e < 100 ? 24 : 200)
            for (int f = -100; f <= 1000; f += 300)
                for (int sign = -1; sign <= 1; sign += 2)
                    check_wide(high[i], sign, -ldexp(1, e), f < 0 ? 0 : -ldexp(1, -f));
}

TEST(test_tolerance) {
    uint64_t random = SEED + 7;
    for (int n = 1; n <= 10; n++) {
        answers fine, coarse;
        put_random(n, &random);
        solve(n, 0, MOST, 0, NULL, &fine);
        algsurf_real_batch p = packet_of(n, 0, MOST, 0);
        algsurf_batch_options options = {.size = sizeof options, .relative_tolerance = 1e-4};
        assert_ok(algsurf_first_roots_batch(&p, &options, coarse.state, coarse.root));
        for (int i = 0; i < MOST; i++)
            if (fine.state[i] == ALGSURF_FIRST_ROOT_FOUND &&
                !(fabs(fine.root[i] - coarse.root[i]) <= 2e-4 * (hi[i] - lo[i])))
                complain("tolerance", n, i, &coarse, 1);
    }
}

/* What the packet code leaves open of the polynomials put, asked for the first root or for all. */
static int left_open(int n, int all) {
    const algsurf_i_kernel *kernel = algsurf_i_kernel_find(NULL);
    answers a;
    int open = 0;
    algsurf_real_batch p = packet_of(n, 0, MOST, 0);
    algsurf_i_polys_job job = {.p = p};
    if (all) {
        job.roots = all_roots, job.found = counts;
        algsurf_i_roots_kernel_for(kernel)->solve_all(&job);
    } else {
        job.state = a.state, job.root = a.root;
        algsurf_i_roots_kernel_for(kernel)->solve(&job);
    }
    for (int i = 0; i < MOST; i++) open += all ? counts[i] < 0 : a.state[i] == ALGSURF_LANE_UNDECIDED;
    return open;
}

/* The packet code decides what is well-conditioned by itself. */
TEST(test_kernels_decide) {
    uint64_t random = SEED + 8;
    for (int n = 1; n <= 10; n++) {
        put_random(n, &random);
        assert_true(left_open(n, 0) <= MOST / 16);
    }
}

/* Two near roots, ill-conditioned: the packet code encloses them. */
TEST(test_kernels_enclose) {
    uint64_t random = SEED + 14;
    for (int n = 3; n <= 10; n++) {
        for (int i = 0; i < MOST; i++) {
            double e = pow(10, -4 + 0.5 * random_unit(&random));
            put_grazing(i, n, 0.5 * random_unit(&random), -e * e, &random);
        }
        assert_true(left_open(n, 0) <= MOST / 16);
    }
}

TEST(test_kernels_find_all) {
    uint64_t random = SEED + 13;
    for (int n = 3; n <= 10; n++) { /* below, many roots are doubles */
        put_random(n, &random);
        assert_true(left_open(n, 1) <= MOST / 16);
    }
}

static void expect_error(const algsurf_real_batch *p, const algsurf_batch_options *options,
                         algsurf_status status) {
    answers a, untouched;
    memset(&a, 0x55, sizeof a);
    untouched = a;
    assert_int_equal(algsurf_first_roots_batch(p, options, a.state, a.root), status);
    assert_memory_equal(&a, &untouched, sizeof a);
}

TEST(test_errors) {
    uint64_t random = SEED + 9;
    algsurf_batch_options options = {.size = sizeof options};
    answers a;
    put_random(3, &random);
    memset(r, 0, sizeof r);
    algsurf_real_batch good = packet_of(3, 0, MOST, 1), p = good;
    expect_error(NULL, NULL, ALGSURF_E_ARGUMENT);
    p.size = 3;
    expect_error(&p, NULL, ALGSURF_E_SIZE);
    p = good, p.degree = -1;
    expect_error(&p, NULL, ALGSURF_E_ARGUMENT);
    p = good, p.degree = ALGSURF_MAX_POLY_DEGREE + 1;
    expect_error(&p, NULL, ALGSURF_E_DEGREE);
    p = good, p.coefficients.at = NULL;
    expect_error(&p, NULL, ALGSURF_E_ARGUMENT);
    for (size_t size = 0; size < sizeof p; size++) { /* no release had a smaller struct */
        p = good, p.size = size;
        expect_error(&p, NULL, ALGSURF_E_SIZE);
    }
    options.kernel = "none";
    expect_error(&good, &options, ALGSURF_E_ARGUMENT);
    options = (algsurf_batch_options){.size = sizeof options, .relative_tolerance = -1};
    expect_error(&good, &options, ALGSURF_E_ARGUMENT);
    options.relative_tolerance = 0.5;
    p = packet_of(3, 0, MOST, 0);
    assert_int_equal(algsurf_real_roots_batch(&p, &options, all_roots, counts), ALGSURF_E_ARGUMENT);
    options.relative_tolerance = (double)NAN;
    expect_error(&good, &options, ALGSURF_E_NOT_FINITE);
    assert_int_equal(algsurf_first_roots_batch(&good, NULL, NULL, a.root), ALGSURF_E_ARGUMENT);
    assert_ok(algsurf_first_roots_batch(&good, NULL, a.state, a.root));
    assert_int_equal(algsurf_real_roots_batch(&good, NULL, all_roots, counts),
                     ALGSURF_E_ARGUMENT); /* radii */
    good = packet_of(3, 0, MOST, 0);
    assert_int_equal(algsurf_real_roots_batch(&good, NULL, NULL, counts), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_real_roots_batch(&good, NULL, all_roots, NULL), ALGSURF_E_ARGUMENT);
    p = (algsurf_real_batch){.size = sizeof p, .degree = 3};
    assert_ok(algsurf_real_roots_batch(&p, NULL, NULL, NULL));
    assert_ok(algsurf_first_roots_batch(&p, NULL, NULL, NULL));
}

/* A bad number, or a zero polynomial, is refused alone; an interval may be a point.  The others are as single
 * calls have them, which other tests here judge. */
static void spoil(int n, int i, int how, uint64_t *random) {
    static const double bad[] = {(double)NAN, (double)INFINITY, -(double)INFINITY};
    int k = random_int(random, n + 1);
    if (how < 3) c[k][i] = bad[how];
    if (how >= 3 && how < 6) r[k][i] = bad[how - 3];
    if (how == 6) r[k][i] = -0x1p-1074;
    if (how >= 7 && how < 10) lo[i] = bad[how - 7];
    if (how >= 10 && how < 13) hi[i] = bad[how - 10];
    if (how == 13) lo[i] = nextafter(hi[i], (double)INFINITY);
    if (how == 14) lo[i] = hi[i];
    for (int m = 0; how == 15 && m <= n; m++) c[m][i] = r[m][i] = 0;
    if (how == 16) lo[i] = hi[i] = c[0][i] = 0; /* which is a root then */
}

TEST(test_bad_polynomials) {
    uint64_t random = SEED + 16;
    EACH_DEGREE(n)
    for (int radii = 0; radii < 2; radii++)
        for (int how = 0; how <= 17; how++) { /* 17: all of them */
            if (n > 6 && (how + n) % 3) continue;
            int seen[5] = {0};
            answers a;
            put_random(n, &random);
            for (int k = 0; k <= n; k++)
                for (int i = 0; i < MOST; i++) r[k][i] = 0x1p-60 * fabs(c[k][i]);
            for (int i = 0; i < MOST; i++)
                if (how == 17 || random_int(&random, 5) == 0)
                    spoil(n, i, how < 17 ? how : random_int(&random, 17), &random);
            check_kernels(n, MOST, radii, 0, &a, seen);
        }
}

/* No interval is the whole line; half of one a half line. */
TEST(test_no_intervals) {
    uint64_t random = SEED + 17;
    EACH_DEGREE(n)
    for (int which = 1; which < 4; which++) {
        answers a, b;
        put_random(n, &random);
        algsurf_real_batch p = packet_of(n, 0, MOST, 0);
        if (which & 1) p.lo = NULL;
        if (which & 2) p.hi = NULL;
        assert_ok(algsurf_first_roots_batch(&p, NULL, a.state, a.root));
        for (int i = 0; i < MOST; i++) {
            if (which & 1) lo[i] = -(double)INFINITY;
            if (which & 2) hi[i] = (double)INFINITY;
        }
        solve(n, 0, MOST, 0, NULL, &b);
        assert_true(same(&a, &b, MOST));
        assert_ok(algsurf_real_roots_batch(&p, NULL, all_roots, counts));
        solve_alone(n, MOST);
        for (int i = 0; i < MOST; i++)
            if (!same_roots(n, i)) complain("all roots", n, i, &b, counts[i]);
    }
}

/* Roots of the whole line come from boxes of several polynomials at once: also beside those that have none,
 * that are refused, that are powers, or squares; with every kernel, and a last block that is not full. */
TEST(test_whole_line) {
    enum { COUNT = MOST - 3, WAYS = 20 };
    uint64_t random = SEED + 19;
    const answers none = {.state = {0}};
    EACH_DEGREE(n)
    for (int how = 0; how < WAYS; how++) {
        algsurf_batch_options options = {.size = sizeof options};
        put_random(n, &random);
        for (int i = 0; i < MOST; i++) {
            if (how < 17 && random_int(&random, 5) == 0) spoil(n, i, how, &random);
            for (int k = 1; k < n && how == 17 && i % 3; k++) c[k][i] = 0;           /* powers */
            for (int k = 1; k <= n && how == 18 && i % 3; k += 2) c[k][i] = 0;       /* of squares */
            for (int k = 0; k <= n && how == 19 && i % 3; k++) c[k][i] = k == n / 2; /* t^(n/2) */
            lo[i] = -(double)INFINITY, hi[i] = (double)INFINITY;
        }
        algsurf_real_batch p = packet_of(n, 0, COUNT, 0);
        p.lo = p.hi = NULL;
        solve_alone(n, COUNT);
        for (int kernel = 0; (options.kernel = algsurf_kernel_name(kernel)); kernel++) {
            memset(all_roots, 0x55, sizeof all_roots);
            const algsurf_status status = algsurf_real_roots_batch(&p, &options, all_roots, counts);
            int bad = 0;
            for (int i = 0; i < COUNT; i++)
                if (!same_roots(n, i)) complain("the whole line", n, i, &none, counts[i]);
            while (bad < COUNT && counts[bad] >= 0) bad++;
            assert_int_equal(status, bad < COUNT ? counts[bad] : ALGSURF_OK);
        }
    }
}

/* The same polynomials by rows, backwards, spread, as parts of complex numbers, in one interval or with one
 * coefficient for all: the same bits. */
TEST(test_layouts) {
    uint64_t random = SEED + 15;
    for (int n = 1; n <= 24; n += n < 6 ? 1 : 6) {
        static double spread[2 * (TOP + 1) * MOST], spread_radii[2 * (TOP + 1) * MOST];
        static algsurf_real_root found[MOST * TOP];
        static int found_counts[MOST];
        answers usual, here;
        put_random(n, &random);
        for (int i = 0; i < MOST; i++) lo[i] = -1, hi[i] = 2, c[n][i] = 0.75;
        memset(r, 0, sizeof r);
        for (int k = 0; k <= n; k++)
            for (int i = 0; i < MOST; i++) r[k][i] = 0x1p-60 * fabs(c[k][i]);
        const ptrdiff_t rows = n + 1,
                        layouts[][2] = {{1, rows}, {2, 2 * rows}, {MOST, 1}, {-1, -rows}, {2 * MOST, 2}};
        for (int radii = 0; radii < 2; radii++) {
            solve(n, 0, MOST, radii, NULL, &usual);
            for (size_t l = 0; l < sizeof layouts / sizeof *layouts; l++) {
                ptrdiff_t power = layouts[l][0], polynomial = layouts[l][1];
                ptrdiff_t start = power < 0 ? rows * MOST - 1 : 0;
                for (int k = 0; k <= n; k++)
                    for (int i = 0; i < MOST; i++) {
                        spread[start + k * power + i * polynomial] = c[k][i];
                        spread_radii[start + k * power + i * polynomial] = r[k][i];
                    }
                algsurf_real_batch p = packet_of(n, 0, MOST, 0);
                p.coefficients = (algsurf_table){spread + start, power, polynomial};
                if (radii) p.radii = (algsurf_table){spread_radii + start, power, polynomial};
                p.interval_step = 0;
                assert_ok(algsurf_first_roots_batch(&p, NULL, here.state, here.root));
                assert_true(same(&usual, &here, MOST));
                if (radii) continue;
                assert_ok(algsurf_real_roots_batch(&p, NULL, found, found_counts));
                p = packet_of(n, 0, MOST, 0);
                assert_ok(algsurf_real_roots_batch(&p, NULL, all_roots, counts));
                for (int i = 0; i < MOST; i++) {
                    assert_int_equal(found_counts[i], counts[i]);
                    assert_memory_equal(found + i * n, all_roots + i * n, (size_t)counts[i] * sizeof *found);
                }
            }
        }
    }
}

static int asked_degree;

static void solve_asked(void *to) { solve(asked_degree, 0, MOST, 0, NULL, to); }

TEST(test_environment) {
    uint64_t random = SEED + 10;
    EACH_DEGREE(n) {
        put_random(n, &random);
        asked_degree = n;
        environments_agree(solve_asked, sizeof(answers));
    }
}
