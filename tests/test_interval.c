/* test_interval.c - real intervals against exact rationals: every end is the best double there is.
 *
 * Breaks caught (each tried): an end not rounded outward, or one unit too far; the far paths of sums,
 * products, quotients and roots left out (subnormals, overflow, limits of the error-free product); a wrong
 * corner for one combination of signs; 0 * inf not 0; the environment not entered; in the centred form a
 * slope shifted by one, its middle not taken as a point, Horner's result not met. */
#include "interval_cases.h"
#include "unit.h"

#define SEED 11u
#define ROUNDS 40000

/* ---- the oracle: rationals and two infinities ---- */

typedef struct {
    int infinite; /* -1, 0, 1 */
    mpq_t q;
} number;

static void number_set(number *n, double x) {
    n->infinite = isinf(x) ? (x > 0 ? 1 : -1) : 0;
    if (!n->infinite) exact_set(n->q, x);
}

static int sign(const number *n) { return n->infinite ? n->infinite : mpq_sgn(n->q); }

static int compare(const number *a, const number *b) {
    if (a->infinite || b->infinite) return a->infinite - b->infinite;
    return mpq_cmp(a->q, b->q);
}

static void number_copy(number *to, const number *from) {
    to->infinite = from->infinite;
    mpq_set(to->q, from->q);
}

typedef void (*operation)(number *, const number *, const number *);

static void add(number *r, const number *a, const number *b) {
    r->infinite = a->infinite ? a->infinite : b->infinite;
    if (!r->infinite) mpq_add(r->q, a->q, b->q);
}

static void sub(number *r, const number *a, const number *b) {
    r->infinite = a->infinite ? a->infinite : -b->infinite;
    if (!r->infinite) mpq_sub(r->q, a->q, b->q);
}

static void mul(number *r, const number *a, const number *b) {
    r->infinite = a->infinite || b->infinite ? sign(a) * sign(b) : 0;
    if (a->infinite || b->infinite)
        mpq_set_ui(r->q, 0, 1); /* 0 * inf */
    else
        mpq_mul(r->q, a->q, b->q);
}

static void quotient(number *r, const number *a, const number *b) {
    r->infinite = a->infinite && !b->infinite ? sign(a) * sign(b) : 0;
    if (a->infinite || b->infinite)
        mpq_set_ui(r->q, 0, 1); /* x / inf */
    else
        mpq_div(r->q, a->q, b->q);
}

/* The least and the greatest value at the corners; sums take equal ends only, inf - inf never being one. */
static void corners(operation f, int monotone, algsurf_interval a, algsurf_interval b, number *lo,
                    number *hi) {
    number x, y, value;
    mpq_inits(x.q, y.q, value.q, NULL);
    for (int i = 0; i < 4; i++) {
        if (monotone && i != 0 && i != 3) continue;
        number_set(&x, i & 1 ? a.hi : a.lo);
        number_set(&y, ((i & 2) != 0) != (f == sub) ? b.hi : b.lo);
        f(&value, &x, &y);
        if (i == 0 || compare(&value, lo) < 0) number_copy(lo, &value);
        if (i == 0 || compare(&value, hi) > 0) number_copy(hi, &value);
    }
    mpq_clears(x.q, y.q, value.q, NULL);
}

/* Is x the largest double (or -inf) not above q? */
static int is_best_lower(double x, const number *q) {
    if (q->infinite) return q->infinite < 0 ? x == -INFINITY : x == INFINITY;
    double inward = nextafter(x, INFINITY);
    return exact_between(x, q->q, INFINITY) && !exact_between(inward, q->q, INFINITY) &&
           !(x == 0 && signbit(x));
}

static int is_best_upper(double x, number *q) {
    if (x == 0 && signbit(x)) return 0;
    q->infinite = -q->infinite, mpq_neg(q->q, q->q);
    int best = is_best_lower(0.0 - x, q);
    q->infinite = -q->infinite, mpq_neg(q->q, q->q);
    return best;
}

static void require_best(const char *name, int round, algsurf_interval a, algsurf_interval b,
                         algsurf_interval r, const number *lo, number *hi) {
    if (is_best_lower(r.lo, lo) && is_best_upper(r.hi, hi)) return;
    fail_msg("%s, seed %u round %d: [%a,%a] and [%a,%a] gave [%a,%a]", name, SEED, round, a.lo, a.hi, b.lo,
             b.hi, r.lo, r.hi);
}

static algsurf_interval divided(algsurf_interval a, algsurf_interval b) {
    algsurf_interval r = {7, 7};
    algsurf_status status = algsurf_interval_div(a, b, &r);
    int refused = b.lo <= 0 && b.hi >= 0;
    assert_int_equal(status, refused ? ALGSURF_E_RANGE : ALGSURF_OK);
    if (refused) assert_true(r.lo == 7 && r.hi == 7);
    return r;
}

/* Operands that nearly cancel, or whose product is near a rim of the range. */
static algsurf_interval relative(uint64_t *seed, algsurf_interval a) {
    algsurf_interval b = case_interval(seed);
    int kind = random_int(seed, 4);
    if (kind == 0 && isfinite(a.lo)) b.lo = b.hi = -a.lo * (1 + 0x1p-52 * random_int(seed, 5));
    if (kind == 1 && a.hi != 0 && isfinite(a.hi)) b.lo = b.hi = ldexp(1 / a.hi, random_int(seed, 2) * -1070);
    return isfinite(b.lo) && isfinite(b.hi) ? b : case_interval(seed);
}

TEST(test_four_operations) {
    uint64_t seed = SEED;
    number lo, hi;
    mpq_inits(lo.q, hi.q, NULL);
    for (int i = 0; i < ROUNDS; i++) {
        algsurf_interval a = case_interval(&seed), b = relative(&seed, a);
        corners(add, 1, a, b, &lo, &hi);
        require_best("add", i, a, b, algsurf_interval_add(a, b), &lo, &hi);
        corners(sub, 1, a, b, &lo, &hi);
        require_best("sub", i, a, b, algsurf_interval_sub(a, b), &lo, &hi);
        double width = algsurf_interval_width(a);
        corners(sub, 1, a, a, &lo, &hi);
        assert_true(is_best_upper(width, &hi));
        corners(mul, 0, a, b, &lo, &hi);
        require_best("mul", i, a, b, algsurf_interval_mul(a, b), &lo, &hi);
        algsurf_interval r = divided(a, b);
        if (b.lo <= 0 && b.hi >= 0) continue;
        corners(quotient, 0, a, b, &lo, &hi);
        require_best("div", i, a, b, r, &lo, &hi);
    }
    mpq_clears(lo.q, hi.q, NULL);
}

/* Named cases, so that they do not hang on a seed. */
TEST(test_extremes) {
    algsurf_interval big = {DBL_MAX, DBL_MAX}, tiny = {0x1p-1074, 0x1p-1074}, half = {0.5, 0.5};
    algsurf_interval small = {-1e-200, -1e-200}, line = {-INFINITY, INFINITY}, zero = {0, 0},
                     up = {1, INFINITY}, r;
    r = algsurf_interval_add(big, big);
    assert_true(r.lo == DBL_MAX && r.hi == INFINITY);
    r = algsurf_interval_mul(small, (algsurf_interval){1e-200, 1e-200});
    assert_true(r.lo == -0x1p-1074 && r.hi == 0 && !signbit(r.hi));
    r = algsurf_interval_mul(tiny, half);
    assert_true(r.lo == 0 && r.hi == 0x1p-1074);
    r = algsurf_interval_mul(line, zero);
    assert_true(r.lo == 0 && r.hi == 0);
    r = divided(up, up);
    assert_true(r.lo == 0 && r.hi == INFINITY);
    r = divided(tiny, big);
    assert_true(r.lo == 0 && r.hi == 0x1p-1074);
    assert_ok(algsurf_interval_make(-0.0, -0.0, &r));
    assert_true(r.lo == 0 && r.hi == 0 && !signbit(r.lo) && !signbit(r.hi));
    r = algsurf_interval_sub(zero, zero);
    assert_false(signbit(r.lo) || signbit(r.hi));
    r = algsurf_interval_add(big, (algsurf_interval){-0x1p970, -0x1p970});
    assert_true(r.hi >= r.lo && r.hi < INFINITY);
}

/* ---- one operand ---- */

TEST(test_squares_and_roots) {
    uint64_t seed = SEED;
    number lo, hi, q;
    mpq_inits(lo.q, hi.q, q.q, NULL);
    for (int i = 0; i < ROUNDS; i++) {
        algsurf_interval a = case_interval(&seed), size = algsurf_interval_abs(a), r = {7, 7};
        assert_true(size.lo == (a.lo <= 0 && a.hi >= 0 ? 0 : fmin(fabs(a.lo), fabs(a.hi))));
        assert_true(size.hi == fmax(fabs(a.lo), fabs(a.hi)));
        number_set(&q, size.lo), mul(&lo, &q, &q);
        number_set(&q, size.hi), mul(&hi, &q, &q);
        assert_ok(algsurf_interval_pow(a, 2, &r));
        require_best("pow 2", i, a, a, r, &lo, &hi);
        assert_ok(algsurf_interval_sqrt(size, &r));
        /* best: the ends squared enclose, the next ones inward squared do not */
        for (int k = 0; k < 2; k++) {
            double x = k ? size.hi : size.lo, s = k ? r.hi : r.lo, inward = nextafter(s, k ? -1 : INFINITY);
            if (x == 0 || isinf(x)) {
                assert_true(s == x);
                continue;
            }
            number_set(&q, x);
            number_set(&lo, s), mul(&lo, &lo, &lo), number_set(&hi, inward), mul(&hi, &hi, &hi);
            int encloses = k ? compare(&lo, &q) >= 0 : compare(&lo, &q) <= 0;
            int next_does = k ? compare(&hi, &q) >= 0 : compare(&hi, &q) <= 0;
            if (!encloses || next_does) fail_msg("sqrt, seed %u round %d: %a gave end %a", SEED, i, x, s);
        }
        if (a.lo < 0) assert_int_equal(algsurf_interval_sqrt(a, &r), ALGSURF_E_RANGE);
    }
    mpq_clears(lo.q, hi.q, q.q, NULL);
}

static void power(mpq_t y, double x, int n) {
    mpq_t q;
    mpq_init(q), exact_set(q, x), mpq_set_ui(y, 1, 1);
    for (int i = 0; i < abs(n); i++) mpq_mul(y, y, q);
    if (n < 0) mpq_inv(y, y);
    mpq_clear(q);
}

TEST(test_powers) {
    uint64_t seed = SEED;
    mpq_t y;
    mpq_init(y);
    for (int i = 0; i < 4000; i++) {
        algsurf_interval a = i % 2 ? case_interval(&seed) : case_tame(&seed), r = {7, 7};
        int n = random_int(&seed, 25) - 12, refused = n < 0 && a.lo <= 0 && a.hi >= 0;
        assert_int_equal(algsurf_interval_pow(a, n, &r), refused ? ALGSURF_E_RANGE : ALGSURF_OK);
        if (refused) {
            assert_true(r.lo == 7 && r.hi == 7);
            continue;
        }
        double x = case_inside(&seed, a);
        power(y, x, n);
        if (!exact_between(r.lo, y, r.hi))
            fail_msg("seed %u round %d: [%a,%a]^%d at %a gave [%a,%a]", SEED, i, a.lo, a.hi, n, x, r.lo,
                     r.hi);
        if (i % 2 == 0 && a.lo == a.hi) assert_true(r.hi - r.lo <= 0x1p-48 * fabs(r.lo));
        if (n % 2 == 0) assert_true(r.lo >= 0);
    }
    mpq_clear(y);
    algsurf_interval r = {7, 7};
    assert_ok(algsurf_interval_pow((algsurf_interval){-3, 2}, 3, &r));
    assert_true(r.lo == -27 && r.hi == 8);
    assert_ok(algsurf_interval_pow((algsurf_interval){-2, 1}, 2, &r));
    assert_true(r.lo == 0 && r.hi == 4);
    assert_ok(algsurf_interval_pow((algsurf_interval){-2, -2}, -3, &r));
    assert_true(r.lo == -0.125 && r.hi == -0.125);
    assert_ok(algsurf_interval_pow((algsurf_interval){1, 1}, INT32_MIN, &r));
    assert_true(r.lo == 1 && r.hi == 1);
}

/* The middle is the nearest double to the exact one, and inside. */
TEST(test_middle) {
    uint64_t seed = SEED;
    mpq_t middle, q, here, there;
    mpq_inits(middle, q, here, there, NULL);
    for (int i = 0; i < ROUNDS; i++) {
        algsurf_interval a = case_interval(&seed);
        double m = algsurf_interval_mid(a);
        assert_true(isfinite(m) && algsurf_interval_contains(a, m));
        if (isinf(a.lo) || isinf(a.hi)) {
            assert_true(m == (isfinite(a.lo) ? DBL_MAX : isfinite(a.hi) ? -DBL_MAX : 0));
            continue;
        }
        exact_set(middle, a.lo), exact_set(q, a.hi), mpq_add(middle, middle, q);
        mpq_div_2exp(middle, middle, 1);
        exact_error(here, m, middle);
        for (int k = -1; k <= 1; k += 2) {
            double other = nextafter(m, k > 0 ? INFINITY : -INFINITY);
            if (isinf(other)) continue;
            exact_error(there, other, middle);
            if (mpq_cmp(there, here) < 0) fail_msg("seed %u round %d: [%a,%a] %a", SEED, i, a.lo, a.hi, m);
        }
    }
    mpq_clears(middle, q, here, there, NULL);
}

TEST(test_sets) {
    const algsurf_interval a = {-1, 2}, b = {0x1p-1074, 5}, line = {-INFINITY, INFINITY}, far = {6, INFINITY};
    algsurf_interval r = algsurf_interval_hull(a, far);
    assert_true(r.lo == -1 && r.hi == INFINITY);
    assert_ok(algsurf_interval_intersect(a, b, &r));
    assert_true(r.lo == 0x1p-1074 && r.hi == 2);
    assert_int_equal(algsurf_interval_intersect(a, far, &r), ALGSURF_E_RANGE);
    assert_true(r.lo == 0x1p-1074 && r.hi == 2);
    assert_true(algsurf_interval_contains(a, 2) && !algsurf_interval_contains(b, 0));
    assert_false(algsurf_interval_contains(line, INFINITY) || algsurf_interval_contains(line, NAN));
    assert_true(algsurf_interval_interior(a, line) && algsurf_interval_interior(line, line));
    assert_true(algsurf_interval_interior(far, (algsurf_interval){5, INFINITY}));
    assert_false(algsurf_interval_interior(a, a) || algsurf_interval_interior((algsurf_interval){-1, 0}, a));
    assert_true(algsurf_interval_width(far) == INFINITY && algsurf_interval_width(a) == 3);
}

/* ---- polynomials (complex ones: test_cinterval.c) ---- */

static algsurf_interval horner(const algsurf_interval *c, int n, algsurf_interval x) {
    algsurf_interval y = c[n];
    for (int k = n - 1; k >= 0; k--) y = algsurf_interval_add(algsurf_interval_mul(y, x), c[k]);
    return y;
}

/* Members of the coefficient intervals at points of x lie in the result, which lies in Horner's, is Horner's
 * at points, and is far better for thin arguments. */
TEST(test_poly) {
    uint64_t seed = SEED + 3;
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
            fail_msg("seed %u round %d: polynomial of degree %d over [%a,%a]: [%a,%a], Horner's [%a,%a]",
                     SEED + 3, i, n, t.lo, t.hi, r.lo, r.hi, h.lo, h.hi);
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

/* ---- misuse, and the host's environment ---- */

TEST(test_bad_arguments) {
    const algsurf_interval bad[] = {{1, 0}, {NAN, 1}, {0, NAN}, {INFINITY, INFINITY}, {-INFINITY, -INFINITY}};
    const algsurf_interval one = {1, 1};
    algsurf_interval r = {7, 8};
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        const algsurf_interval b = bad[i], c[] = {one, b};
        assert_int_equal(algsurf_interval_poly(c, 1, one, &r), ALGSURF_E_ARGUMENT);
        assert_int_equal(algsurf_interval_poly(&one, 0, b, &r), ALGSURF_E_ARGUMENT);
        assert_int_equal(algsurf_interval_make(b.lo, b.hi, &r), ALGSURF_E_ARGUMENT);
        assert_int_equal(algsurf_interval_div(b, one, &r), ALGSURF_E_ARGUMENT);
        assert_int_equal(algsurf_interval_div(one, b, &r), ALGSURF_E_ARGUMENT);
        assert_int_equal(algsurf_interval_pow(b, 2, &r), ALGSURF_E_ARGUMENT);
        assert_int_equal(algsurf_interval_sqrt(b, &r), ALGSURF_E_ARGUMENT);
        assert_int_equal(algsurf_interval_intersect(b, one, &r), ALGSURF_E_ARGUMENT);
        assert_int_equal(algsurf_interval_intersect(one, b, &r), ALGSURF_E_ARGUMENT);
        (void)algsurf_interval_mul(b, one), (void)algsurf_interval_add(one, b); /* anything but a crash */
    }
    assert_int_equal(algsurf_interval_poly(NULL, 0, one, &r), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_interval_poly(&one, -1, one, &r), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_interval_poly(&one, ALGSURF_MAX_POLY_DEGREE + 1, one, &r), ALGSURF_E_DEGREE);
    assert_true(r.lo == 7 && r.hi == 8);
    assert_int_equal(algsurf_interval_poly(&one, 0, one, NULL), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_interval_make(0, 1, NULL), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_interval_div(one, one, NULL), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_interval_pow(one, 2, NULL), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_interval_sqrt(one, NULL), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_interval_intersect(one, one, NULL), ALGSURF_E_ARGUMENT);
    assert_ok(algsurf_interval_make(-INFINITY, INFINITY, &r));
    assert_true(r.lo == -INFINITY && r.hi == INFINITY);
}

#define POOL 200
#define RESULTS 12

static struct { algsurf_interval a[POOL], b[POOL], expected[POOL][RESULTS], got[POOL][RESULTS]; } pool;

static void evaluate(void *into) {
    algsurf_interval(*r)[RESULTS] = into;
    for (int i = 0; i < POOL - 1; i++) { /* the polynomial takes a[i] and a[i+1] */
        algsurf_interval a = pool.a[i], b = pool.b[i], *s = r[i], size = algsurf_interval_abs(a);
        s[0] = algsurf_interval_add(a, b), s[1] = algsurf_interval_sub(a, b),
        s[2] = algsurf_interval_mul(a, b);
        s[3] = algsurf_interval_hull(a, b), s[4] = size;
        s[5] = (algsurf_interval){algsurf_interval_width(a), algsurf_interval_mid(a)};
        s[6] = (algsurf_interval){algsurf_interval_contains(a, b.lo), algsurf_interval_interior(a, b)};
        (void)algsurf_interval_div(a, b, &s[7]), (void)algsurf_interval_sqrt(size, &s[8]);
        (void)algsurf_interval_pow(a, 2, &s[9]), (void)algsurf_interval_pow(a, 3, &s[10]);
        (void)algsurf_interval_poly(&pool.a[i], 1, b, &s[11]);
    }
}

static void same(void *into, const char *name) {
    (void)into;
    for (int i = 0; i < POOL - 1; i++)
        for (int k = 0; k < RESULTS; k++)
            if (memcmp(&pool.expected[i][k], &pool.got[i][k], sizeof pool.got[i][k]) != 0)
                fail_msg("%s: operation %d differs on [%a,%a], [%a,%a]", name, k, pool.a[i].lo, pool.a[i].hi,
                         pool.b[i].lo, pool.b[i].hi);
    assert_string_not_equal(name, "mode not restored");
    memset(pool.got, 0, sizeof pool.got);
}

TEST(test_any_environment) {
    uint64_t seed = SEED;
    for (int i = 0; i < POOL; i++) pool.a[i] = case_interval(&seed), pool.b[i] = case_interval(&seed);
    evaluate(pool.expected);
    case_environments(evaluate, same, pool.got);
}
