/* test_cinterval.c - rectangles of the complex plane against exact rationals (their argument:
 * test_interval_arg.c).
 *
 * Breaks caught (each tried): a component's sign in a product, an inverse whose extremes are sought at the
 * wrong corner, the scaling of division left out, a slope without its lowest coefficient, the environment not
 * entered. */
#include "interval_cases.h"
#include "unit.h"

#define SEED 12u

static algsurf_cinterval case_rectangle(uint64_t *seed) {
    return (algsurf_cinterval){case_interval(seed), case_interval(seed)};
}

/* Ordinary rectangles, some scaled far away, some on an axis. */
static algsurf_cinterval case_ordinary(uint64_t *seed) {
    algsurf_cinterval a = {case_tame(seed), case_tame(seed)};
    int k = random_int(seed, 4) ? 0 : random_int(seed, 2000) - 1000, axis = random_int(seed, 12);
    a.re = case_sorted(ldexp(a.re.lo, k), ldexp(a.re.hi, k));
    a.im = case_sorted(ldexp(a.im.lo, k), ldexp(a.im.hi, k));
    if (axis == 0) a.im = (algsurf_interval){0, 0};
    if (axis == 1) a.re = (algsurf_interval){0, 0};
    return a;
}

static algsurf_cinterval point(algsurf_complex z) { return (algsurf_cinterval){{z.re, z.re}, {z.im, z.im}}; }

static algsurf_complex inside(uint64_t *seed, algsurf_cinterval a) {
    return (algsurf_complex){case_inside(seed, a.re), case_inside(seed, a.im)};
}

static int same_interval(algsurf_interval a, algsurf_interval b) { return a.lo == b.lo && a.hi == b.hi; }

/* ---- exact complex numbers ---- */

typedef struct {
    mpq_t re, im;
} exact_complex;

static void init(exact_complex *z) { mpq_inits(z->re, z->im, NULL); }
static void clear(exact_complex *z) { mpq_clears(z->re, z->im, NULL); }
static void set(exact_complex *z, algsurf_complex w) { exact_set(z->re, w.re), exact_set(z->im, w.im); }

static void times(exact_complex *r, const exact_complex *a, const exact_complex *b) {
    mpq_t x, y, t;
    mpq_inits(x, y, t, NULL);
    mpq_mul(x, a->re, b->re), mpq_mul(t, a->im, b->im), mpq_sub(x, x, t);
    mpq_mul(y, a->re, b->im), mpq_mul(t, a->im, b->re), mpq_add(y, y, t);
    mpq_set(r->re, x), mpq_set(r->im, y);
    mpq_clears(x, y, t, NULL);
}

static void square_sum(mpq_t r, const exact_complex *a) {
    mpq_t t;
    mpq_init(t);
    mpq_mul(r, a->re, a->re), mpq_mul(t, a->im, a->im), mpq_add(r, r, t);
    mpq_clear(t);
}

static void inverted(exact_complex *r, const exact_complex *a) {
    mpq_t size;
    mpq_init(size), square_sum(size, a);
    mpq_div(r->re, a->re, size), mpq_div(r->im, a->im, size), mpq_neg(r->im, r->im);
    mpq_clear(size);
}

static void print(const char *name, algsurf_cinterval a) {
    fprintf(stderr, "%s = [%a,%a] + i[%a,%a]\n", name, a.re.lo, a.re.hi, a.im.lo, a.im.hi);
}

/* Fails with the operands; `round` is that of the seed, or the operation's number. */
static void report(const char *name, int round, algsurf_cinterval a, algsurf_cinterval b,
                   algsurf_cinterval r) {
    print("a", a), print("b", b), print("result", r);
    fail_msg("%s, seed %u round %d", name, SEED, round);
}

static void require(const char *name, int round, algsurf_cinterval a, algsurf_cinterval b,
                    algsurf_cinterval r, const exact_complex *value) {
    if (exact_between(r.re.lo, value->re, r.re.hi) && exact_between(r.im.lo, value->im, r.im.hi)) return;
    exact_print("re", value->re), exact_print("im", value->im);
    report(name, round, a, b, r);
}

/* Products are exactly what tight real operations give. */
TEST(test_ring_operations) {
    uint64_t seed = SEED;
    exact_complex x, y, z;
    init(&x), init(&y), init(&z);
    for (int i = 0; i < 4000; i++) {
        algsurf_cinterval a = case_rectangle(&seed), b = case_rectangle(&seed), r;
        set(&x, inside(&seed, a)), set(&y, inside(&seed, b));
        mpq_add(z.re, x.re, y.re), mpq_add(z.im, x.im, y.im);
        require("add", i, a, b, algsurf_cinterval_add(a, b), &z);
        mpq_sub(z.re, x.re, y.re), mpq_sub(z.im, x.im, y.im);
        require("sub", i, a, b, algsurf_cinterval_sub(a, b), &z);
        times(&z, &x, &y), r = algsurf_cinterval_mul(a, b);
        require("mul", i, a, b, r, &z);
        algsurf_interval re =
            algsurf_interval_sub(algsurf_interval_mul(a.re, b.re), algsurf_interval_mul(a.im, b.im));
        algsurf_interval im =
            algsurf_interval_add(algsurf_interval_mul(a.re, b.im), algsurf_interval_mul(a.im, b.re));
        assert_true(same_interval(r.re, re) && same_interval(r.im, im));
    }
    clear(&x), clear(&y), clear(&z);
}

/* ---- division, modulus ---- */

TEST(test_division) {
    uint64_t seed = SEED;
    exact_complex x, y, z;
    init(&x), init(&y), init(&z);
    for (int i = 0; i < 6000; i++) {
        int wild = i % 3 == 0;
        algsurf_cinterval a = wild ? case_rectangle(&seed) : case_ordinary(&seed), r = {{7, 7}, {7, 7}};
        algsurf_cinterval b = wild ? case_rectangle(&seed) : case_ordinary(&seed);
        int refused = algsurf_cinterval_contains(b, (algsurf_complex){0, 0});
        assert_int_equal(algsurf_cinterval_div(a, b, &r), refused ? ALGSURF_E_RANGE : ALGSURF_OK);
        if (refused) {
            assert_true(r.re.lo == 7 && r.re.hi == 7 && r.im.lo == 7 && r.im.hi == 7);
            continue;
        }
        set(&x, inside(&seed, a)), set(&y, inside(&seed, b));
        inverted(&z, &y), times(&z, &z, &x);
        require("div", i, a, b, r, &z);
    }
    clear(&x), clear(&y), clear(&z);
}

/* Points divide to a few units in the last place of the modulus, whatever their size. */
TEST(test_division_of_points) {
    uint64_t seed = SEED;
    for (int i = 0; i < 4000; i++) {
        int k = random_int(&seed, 2060) - 1050;
        algsurf_complex z = {random_wide(&seed, k - 20, k), random_wide(&seed, k - 20, k)};
        algsurf_complex w = {random_wide(&seed, k - 20, k), random_wide(&seed, k - 20, k)};
        algsurf_cinterval a = point(z), b = point(w), r;
        assert_ok(algsurf_cinterval_div(a, b, &r));
        double size = algsurf_cinterval_abs(r).hi;
        if (!(algsurf_cinterval_width(r) <= 0x1p-49 * size && size < INFINITY)) report("div", i, a, b, r);
    }
    algsurf_cinterval r, i = {{0, 0}, {1, 1}}, two = {{2, 2}, {0, 0}};
    assert_ok(algsurf_cinterval_div(two, i, &r));
    assert_true(r.re.lo == 0 && r.re.hi == 0 && r.im.lo == -2 && r.im.hi == -2);
}

/* The inverse of a rectangle is its hull: what a walk along the border finds, and little more. */
TEST(test_inverse_is_tight) {
    uint64_t seed = SEED;
    const algsurf_cinterval one = {{1, 1}, {0, 0}};
    for (int i = 0; i < 1500; i++) {
        double x = 4 * random_unit(&seed), y = 4 * random_unit(&seed);
        algsurf_cinterval b = {case_sorted(x, x + 3 * random_unit(&seed)),
                               case_sorted(y, y + 3 * random_unit(&seed))},
                          r;
        if (fmin(algsurf_interval_abs(b.re).lo, 9) + algsurf_interval_abs(b.im).lo < 0.1) continue;
        assert_ok(algsurf_cinterval_div(one, b, &r));
        algsurf_cinterval walk = {{INFINITY, -INFINITY}, {INFINITY, -INFINITY}};
        for (int k = 0; k < 4 * 200; k++) {
            double t = k / 4 / 199.0;
            double u = k % 4 == 0 ? b.re.lo : k % 4 == 1 ? b.re.hi : b.re.lo + t * (b.re.hi - b.re.lo);
            double v = k % 4 == 2 ? b.im.lo : k % 4 == 3 ? b.im.hi : b.im.lo + t * (b.im.hi - b.im.lo);
            double re = u / (u * u + v * v), im = -v / (u * u + v * v);
            walk.re.lo = fmin(walk.re.lo, re), walk.re.hi = fmax(walk.re.hi, re);
            walk.im.lo = fmin(walk.im.lo, im), walk.im.hi = fmax(walk.im.hi, im);
        }
        double slack = 0.01 * algsurf_cinterval_abs(r).hi;
        if (r.re.lo < walk.re.lo - slack || r.re.hi > walk.re.hi + slack || r.im.lo < walk.im.lo - slack ||
            r.im.hi > walk.im.hi + slack)
            report("inverse against the walk", i, b, walk, r);
    }
}

TEST(test_modulus) {
    uint64_t seed = SEED;
    exact_complex x;
    mpq_t size, end;
    init(&x), mpq_inits(size, end, NULL);
    for (int i = 0; i < 5000; i++) {
        algsurf_cinterval a = i % 2 ? case_rectangle(&seed) : case_ordinary(&seed);
        if (i % 4 == 0) a.re.hi = a.re.lo, a.im.hi = a.im.lo;
        algsurf_interval r = algsurf_cinterval_abs(a);
        set(&x, inside(&seed, a)), square_sum(size, &x);
        int holds = r.lo >= 0 && isfinite(r.lo);
        exact_set(end, r.lo), mpq_mul(end, end, end), holds &= mpq_cmp(end, size) <= 0;
        if (isfinite(r.hi)) exact_set(end, r.hi), mpq_mul(end, end, end), holds &= mpq_cmp(end, size) >= 0;
        if (i % 4 == 0) holds &= algsurf_interval_width(r) <= 0x1p-50 * r.hi;
        if (!holds) report("abs", i, a, a, (algsurf_cinterval){r, {0, 0}});
    }
    clear(&x), mpq_clears(size, end, NULL);
    algsurf_interval five = algsurf_cinterval_abs((algsurf_cinterval){{-3, -3}, {4, 4}});
    assert_true(five.lo == 5 && five.hi == 5);
    five = algsurf_cinterval_abs((algsurf_cinterval){{-3, 1}, {-4, 2}});
    assert_true(five.lo == 0 && five.hi == 5);
}

/* ---- sets, polynomials, misuse, environments ---- */

TEST(test_sets) {
    const algsurf_cinterval a = {{-1, 2}, {0, 1}}, b = {{0, 3}, {0.5, 4}}, far = {{0, 1}, {5, 6}};
    algsurf_cinterval r = algsurf_cinterval_hull(a, b);
    assert_true(r.re.lo == -1 && r.re.hi == 3 && r.im.lo == 0 && r.im.hi == 4);
    assert_ok(algsurf_cinterval_intersect(a, b, &r));
    assert_true(r.re.lo == 0 && r.re.hi == 2 && r.im.lo == 0.5 && r.im.hi == 1);
    assert_int_equal(algsurf_cinterval_intersect(a, far, &r), ALGSURF_E_RANGE);
    assert_true(r.re.hi == 2);
    assert_true(algsurf_cinterval_width(a) == 3 && algsurf_cinterval_width(b) == 3.5);
    assert_true(algsurf_cinterval_mid(a).re == 0.5 && algsurf_cinterval_mid(a).im == 0.5);
    assert_true(algsurf_cinterval_contains(a, (algsurf_complex){-1, 1}));
    assert_false(algsurf_cinterval_contains(a, (algsurf_complex){0, 2}));
    assert_false(algsurf_cinterval_contains(a, (algsurf_complex){3, 0}));
    const algsurf_cinterval core = {{-0.5, 1}, {0.25, 0.5}}, edge = {{-0.5, 1}, {0, 0.5}};
    assert_true(algsurf_cinterval_interior(core, a));
    assert_false(algsurf_cinterval_interior(edge, a) || algsurf_cinterval_interior(b, a));
}

/* Within Horner's enclosure, and often much narrower. */
TEST(test_poly) {
    uint64_t seed = SEED;
    exact_complex x, y, c;
    init(&x), init(&y), init(&c);
    int better = 0;
    for (int i = 0; i < 1500; i++) {
        int n = random_int(&seed, 10), wild = i % 4 == 0;
        algsurf_cinterval p[10], z = wild ? case_rectangle(&seed) : case_ordinary(&seed), h, r;
        for (int k = 0; k <= n; k++)
            p[k] = wild ? case_rectangle(&seed) : (algsurf_cinterval){case_tame(&seed), case_tame(&seed)};
        if (i % 4 == 1)
            for (int k = 0; k <= n; k++) p[k] = point((algsurf_complex){p[k].re.lo, p[k].im.lo});
        assert_ok(algsurf_cinterval_poly(p, n, z, &r));
        h = p[n];
        for (int k = n - 1; k >= 0; k--) h = algsurf_cinterval_add(algsurf_cinterval_mul(h, z), p[k]);
        set(&x, inside(&seed, z)), mpq_set_ui(y.re, 0, 1), mpq_set_ui(y.im, 0, 1);
        for (int k = n; k >= 0; k--) {
            set(&c, inside(&seed, p[k])), times(&y, &y, &x);
            mpq_add(y.re, y.re, c.re), mpq_add(y.im, y.im, c.im);
        }
        require("poly", i, z, p[n], r, &y);
        if (r.re.lo < h.re.lo || r.re.hi > h.re.hi || r.im.lo < h.im.lo || r.im.hi > h.im.hi)
            report("poly wider than Horner's", i, z, h, r);
        better += algsurf_cinterval_width(r) < 0.9 * algsurf_cinterval_width(h);
    }
    clear(&x), clear(&y), clear(&c);
    assert_true(better > 100);
}

TEST(test_bad_arguments) {
    const algsurf_cinterval one = {{1, 1}, {0, 0}}, bad[] = {{{1, 0}, {0, 0}}, {{1, 1}, {0, NAN}}};
    algsurf_cinterval r = {{7, 8}, {9, 10}};
    for (size_t i = 0; i < 2; i++) {
        const algsurf_cinterval b = bad[i], c[] = {one, b};
        assert_int_equal(algsurf_cinterval_div(b, one, &r), ALGSURF_E_ARGUMENT);
        assert_int_equal(algsurf_cinterval_div(one, b, &r), ALGSURF_E_ARGUMENT);
        assert_int_equal(algsurf_cinterval_intersect(b, one, &r), ALGSURF_E_ARGUMENT);
        assert_int_equal(algsurf_cinterval_intersect(one, b, &r), ALGSURF_E_ARGUMENT);
        assert_int_equal(algsurf_cinterval_poly(c, 1, one, &r), ALGSURF_E_ARGUMENT);
        assert_int_equal(algsurf_cinterval_poly(&one, 0, b, &r), ALGSURF_E_ARGUMENT);
    }
    assert_int_equal(algsurf_cinterval_poly(NULL, 0, one, &r), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_cinterval_poly(&one, -1, one, &r), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_cinterval_poly(&one, ALGSURF_MAX_POLY_DEGREE + 1, one, &r), ALGSURF_E_DEGREE);
    assert_true(r.re.lo == 7 && r.re.hi == 8 && r.im.lo == 9 && r.im.hi == 10);
    assert_int_equal(algsurf_cinterval_div(one, one, NULL), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_cinterval_intersect(one, one, NULL), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_cinterval_poly(&one, 0, one, NULL), ALGSURF_E_ARGUMENT);
}

#define POOL 100
#define RESULTS 9

static struct { algsurf_cinterval a[POOL], b[POOL], expected[POOL][RESULTS], got[POOL][RESULTS]; } pool;

static void evaluate(void *into) {
    algsurf_cinterval(*r)[RESULTS] = into;
    for (int i = 0; i < POOL; i++) {
        algsurf_cinterval a = pool.a[i], b = pool.b[i], *s = r[i];
        s[0] = algsurf_cinterval_add(a, b), s[1] = algsurf_cinterval_sub(a, b),
        s[2] = algsurf_cinterval_mul(a, b);
        s[3] = algsurf_cinterval_hull(a, b), s[4].re = algsurf_cinterval_abs(a);
        s[4].im.lo = algsurf_cinterval_interior(a, b);
        s[4].im.hi = algsurf_cinterval_contains(a, (algsurf_complex){b.re.lo, b.im.hi});
        s[5] = point(algsurf_cinterval_mid(a)), s[5].re.lo = algsurf_cinterval_width(b);
        (void)algsurf_cinterval_div(a, b, &s[6]), (void)algsurf_cinterval_arg(a, &s[7].re);
        (void)algsurf_cinterval_poly(&pool.a[i], 0, b, &s[8]);
    }
}

static void same(void *into, const char *name) {
    (void)into;
    for (int i = 0; i < POOL; i++)
        for (int k = 0; k < RESULTS; k++)
            if (memcmp(&pool.expected[i][k], &pool.got[i][k], sizeof pool.got[i][k]) != 0)
                report(name, k, pool.a[i], pool.b[i], pool.got[i][k]);
    assert_string_not_equal(name, "mode not restored");
    memset(pool.got, 0, sizeof pool.got);
}

TEST(test_any_environment) {
    uint64_t seed = SEED;
    for (int i = 0; i < POOL; i++) {
        pool.a[i] = i % 2 ? case_rectangle(&seed) : case_ordinary(&seed);
        pool.b[i] = i % 2 ? case_rectangle(&seed) : case_ordinary(&seed);
    }
    evaluate(pool.expected);
    case_environments(evaluate, same, pool.got);
}
