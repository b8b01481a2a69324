/* test_certain.c - refined roots of polynomials on which plain values fail, against exact signs.
 *
 * Each polynomial is isolated, and every bracket refined by the default method: it is accepted, its final
 * bracket is at most two units in the last place wide, has different exact signs at its ends (or is a root),
 * and the value's sign is the polynomial's own.  Breaks caught: a bound left out, an underflow or overflow
 * taken for a root or a sign, a wrong unit, an end that is given up for a point on the root's other side. */
#include "exact.h"

#include "algsurf/isolate.h"
#include "algsurf/refine.h"
#include "unit.h"

#define SEED 29u
enum { MOST = 128 };

static int refined; /* brackets */

static _Noreturn void give_up(const char *what, const double *c, int n, const algsurf_bracket *b,
                              const algsurf_refined_root *r) {
    exact_print_doubles("c", c, n + 1);
    fail_msg("%s: [%a,%a] -> %a in [%a,%a], value %g after %d", what, b->lo, b->hi, r->root, r->lo, r->hi,
             r->residual, r->evaluations);
    abort();
}

/* At an infinite end, that of the leading term. */
static int sign_at(const double *c, int n, double x) {
    while (n > 0 && c[n] == 0) n--;
    if (isfinite(x)) return exact_poly_sign(c, n, x);
    return (c[n] > 0 ? 1 : -1) * (x < 0 && n % 2 ? -1 : 1);
}

static void check_bracket(const double *c, int n, const algsurf_bracket *b) {
    algsurf_refined_root r;
    memset(&r, 0, sizeof r);
    algsurf_status status = algsurf_refine_poly(c, NULL, n, b->lo, b->hi, NULL, &r);
    if (status != ALGSURF_OK) give_up(algsurf_status_text(status), c, n, b, &r);
    int at = exact_poly_sign(c, n, r.root), lo = sign_at(c, n, r.lo), hi = sign_at(c, n, r.hi);
    int given = r.lo == b->lo && r.hi == b->hi; /* between neighbours there may be two, or a double one */
    if (!(b->lo <= r.lo && r.lo <= r.root && r.root <= r.hi && r.hi <= b->hi)) give_up("order", c, n, b, &r);
    if (nextafter(nextafter(r.lo, INFINITY), INFINITY) < r.hi) give_up("wide", c, n, b, &r);
    if (lo * hi > 0 && !given) give_up("root lost", c, n, b, &r);
    if (at != (r.residual > 0) - (r.residual < 0)) give_up("value", c, n, b, &r);
    if (!given && r.residual == 0 && r.lo != r.hi) give_up("not a point", c, n, b, &r);
    refined++;
}

static int check_on(const double *c, int n, double lo, double hi) {
    static algsurf_bracket b[MOST];
    int count;
    assert_ok(algsurf_isolate_all(c, NULL, n, lo, hi, NULL, b, MOST, &count));
    for (int i = 0; i < count; i++)
        if (b[i].kind == ALGSURF_BRACKET_ISOLATED) check_bracket(c, n, b + i);
    return count;
}

/* On the whole line, where integers isolate, and on an interval, where doubles do. */
static int check(const double *c, int n, double reach) {
    check_on(c, n, -reach, reach);
    return check_on(c, n, -INFINITY, INFINITY);
}

/* c times (x - root) */
static void times_root(double *c, int n, double root) {
    c[n + 1] = c[n];
    for (int k = n; k > 0; k--) c[k] = c[k - 1] - root * c[k];
    c[0] *= -root;
}

TEST(test_wilkinson) {
    for (int n = 5; n <= 36; n++)
        for (int shift = -600; shift <= 600; shift += 600) {
            double c[MOST + 1] = {ldexp(1, shift)};
            for (int k = 0; k < n; k++) times_root(c, k, k + 1);
            check(c, n, 1.01 * n + 0.3);
        }
}

/* T_n = 2 x T_(n-1) - T_(n-2); k P_k = (2 k - 1) x P_(k-1) - (k - 1) P_(k-2): `legendre`. */
static void recur(double *c, int n, int legendre) {
    double p[2][MOST + 1] = {{1}, {0, 1}};
    for (int k = 2; k <= n; k++) {
        double a = legendre ? (2 * k - 1.0) / k : 2, b = legendre ? (k - 1.0) / k : 1;
        double *next = p[k % 2], *last = p[(k - 1) % 2];
        for (int i = k; i >= 0; i--) next[i] = (i ? a * last[i - 1] : 0) - b * next[i];
    }
    memcpy(c, p[n % 2], (size_t)(n + 1) * sizeof *c);
}

TEST(test_orthogonal) {
    double c[MOST + 1];
    for (int legendre = 0; legendre < 2; legendre++)
        for (int n = 4; n <= 72; n += n < 40 ? 1 : 8) {
            recur(c, n, legendre);
            check(c, n, 1.1);
        }
}

/* x^n - 2 (a x - 1)^2: two roots near 1/a, a^(-1-n/2) apart. */
TEST(test_mignotte) {
    for (int n = 5; n <= 33; n += 4)
        for (double a = 10; a < 2000; a *= 7) {
            double c[MOST + 1] = {-2, 4 * a, -2 * a * a};
            c[n] = 1;
            assert_true(check(c, n, a) >= 2);
        }
}

/* x^k (x - a): at the lower end, 2^-1074, the value underflows to 0. */
TEST(test_underflow) {
    for (int k = 1; k <= 40; k += 3)
        for (int e = -300; e <= 300; e += 75) {
            double c[MOST + 1] = {0}, a = ldexp(k % 2 ? 1 : 1.7, e);
            const algsurf_bracket b = {.lo = 0x1p-1074, .hi = 1.1 * a};
            algsurf_refined_root r;
            c[k] = -a, c[k + 1] = 1;
            check(c, k + 1, 1.1 * a);
            assert_ok(algsurf_refine_poly(c, NULL, k + 1, b.lo, b.hi, NULL, &r));
            if (r.root != a || r.residual != 0 || r.lo != a || r.hi != a)
                give_up("known root", c, k + 1, &b, &r);
        }
}

TEST(test_clusters) {
    uint64_t seed = SEED;
    for (int round = 0; round < 200; round++) {
        int n = 2 + random_int(&seed, 8), gap = 3 + random_int(&seed, 45);
        double c[MOST + 1] = {1}, centre = 2 * random_unit(&seed);
        for (int k = 0; k < n; k++) {
            double apart = ldexp(random_unit(&seed), -gap);
            times_root(c, k, k % 3 ? centre + apart : 3 * random_unit(&seed));
        }
        check(c, n, 3.5);
    }
}

TEST(test_wide_coefficients) {
    uint64_t seed = SEED;
    int roots = 0;
    for (int round = 0; round < 300; round++) {
        int n = 1 + random_int(&seed, 16), range = round % 3 == 0 ? 40 : 1000;
        double c[MOST + 1];
        for (int k = 0; k <= n; k++) c[k] = random_wide(&seed, -range, range);
        roots += check(c, n, ldexp(1, random_int(&seed, 2000) - 1000));
    }
    assert_true(roots > 300);
}

/* Simple roots far apart: c_i = 2^(-k i^2), all positive, has n of them. */
TEST(test_spread_roots) {
    for (int k = 2; k <= 7; k++)
        for (int n = 4; n <= 12; n++) {
            double c[MOST + 1];
            for (int i = 0; i <= n; i++) c[i] = ldexp(1, -k * i * i);
            assert_int_equal(check(c, n, ldexp(1, 2 * k * n)), n);
        }
}

/* A wide bracket of a multiple root closes in a few steps. */
TEST(test_multiple_roots) {
    for (int m = 3; m <= 11; m += 2) {
        double c[MOST + 1] = {1};
        algsurf_refined_root r;
        for (int k = 0; k < m; k++) times_root(c, k, 1);
        assert_ok(algsurf_refine_poly(c, NULL, m, -0.7, 2.3, NULL, &r));
        assert_true(r.root == 1 && r.residual == 0 && r.evaluations < 16);
    }
}

/* Neighbouring doubles are kept as they are if there is a root: of even multiplicity, two of them, one beyond
 * the largest double, one at an end and another one inside. */
TEST(test_neighbours) {
    static const double third_squared[] = {1, -6, 9}, none[] = {1, 0, 1}, beyond[] = {-0x1p1000, 0x1p-100};
    double third = 1.0 / 3, above = nextafter(third, 1);
    const algsurf_bracket good = {.lo = third, .hi = above}, far = {.lo = DBL_MAX, .hi = INFINITY};
    algsurf_refined_root r;
    check_bracket(third_squared, 2, &good);
    check_bracket(beyond, 1, &far);
    assert_ok(algsurf_refine_poly(beyond, NULL, 1, DBL_MAX, INFINITY, NULL, &r));
    assert_true(r.lo == DBL_MAX && r.root == DBL_MAX && isinf(r.hi) && r.residual != 0);
    assert_int_equal(algsurf_refine_poly(none, NULL, 2, third, above, NULL, &r), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_refine_poly(beyond, NULL, 1, -INFINITY, -DBL_MAX, NULL, &r), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_refine_poly(beyond, NULL, 1, INFINITY, INFINITY, NULL, &r),
                     ALGSURF_E_NOT_FINITE);
    assert_int_equal(algsurf_refine_poly(beyond, NULL, 1, 1, INFINITY, NULL, &r), ALGSURF_E_NOT_FINITE);
    const algsurf_refine_options brent = {.size = sizeof brent, .method = ALGSURF_METHOD_BRENT};
    assert_int_equal(algsurf_refine_poly(beyond, NULL, 1, DBL_MAX, INFINITY, &brent, &r),
                     ALGSURF_E_NOT_FINITE);
}

TEST(test_enough) { assert_true(refined > 5000); }
