/* test_refine.c - every method on functions and polynomials with known roots.
 *
 * Breaks caught: a bracket that loses the root (ends of equal sign), a stop too early or too late, counts
 * that are not the callback's, a Brent that is not Brent's (its points are compared with the book's
 * procedure, one by one), a Newton whose far end stays where it was, a halving that overflows, a limit that
 * is not told, a final bracket that radii do not widen. */
#include "exact.h"

#include "algsurf/refine.h"
#include "environments.h"

#define SEED 11u
#define NEWTON_POINTS 248 /* 246 (search.c) and the two ends */
static const int methods[] = {ALGSURF_METHOD_DEFAULT, ALGSURF_METHOD_BRENT, ALGSURF_METHOD_BISECTION,
                              ALGSURF_METHOD_REGULA_FALSI};

static algsurf_refine_options options_of(int method, double tolerance, int limit) {
    return (algsurf_refine_options){.size = sizeof(algsurf_refine_options),
                                    .method = method,
                                    .max_iterations = limit,
                                    .absolute_tolerance = tolerance};
}

/* ---- functions, counted and recorded ---- */

#define RECORDED 4000
typedef struct {
    double (*f)(double);
    int calls;
    double at[RECORDED];
} probe;

static double call(double x, void *data) {
    probe *p = data;
    if (p->calls < RECORDED) p->at[p->calls] = x;
    p->calls++;
    return p->f(x);
}

static double width(double tolerance, double root) { return tolerance + 0x1p-50 * fmax(fabs(root), DBL_MIN); }

static int sign_of(double x) { return (x > 0) - (x < 0); }

/* What every result promises, whatever the method. */
static void check_result(const algsurf_refined_root *r, const probe *p, double lo, double hi,
                         double tolerance, int method) {
    assert_true(lo <= r->lo && r->lo <= r->root && r->root <= r->hi && r->hi <= hi);
    assert_true(r->root == r->lo || r->root == r->hi);
    assert_int_equal(r->evaluations, p->calls);
    assert_int_equal(r->evaluations, r->iterations + 2);
    assert_true(r->residual == p->f(r->root));
    assert_true(fabs(r->residual) <= fmin(fabs(p->f(r->lo)), fabs(p->f(r->hi))));
    assert_true(sign_of(p->f(r->lo)) * sign_of(p->f(r->hi)) <= 0);
    if (r->converged && r->residual != 0 && method != ALGSURF_METHOD_REGULA_FALSI)
        assert_true(r->hi - r->lo <= width(tolerance, r->root));
}

static double f_cos(double x) { return cos(x) - x; }
static double f_exp(double x) { return exp(x) - 2; }
static double f_cubic(double x) { return (x * x - 2) * x - 5; } /* Brent's and Wallis's */
static double f_flat(double x) { return x == 0 ? 0 : x * exp(-1 / (x * x)); }
static double f_steep(double x) { return pow(x, 21) - 1e-8; }
static double f_ninth(double x) { return pow(x - 1, 9); }
static double f_third(double x) { return (x - 1) * (x - 1) * (x - 1); }
static double f_root(double x) { return cbrt(x - 0.25); }
static double f_atan(double x) { return atan(1e6 * (x - 0.7)); }
static double f_pole(double x) { return 1 / (x - 0.2) - 1; } /* on the right of its pole */
static double f_step(double x) { return x < 0.3 ? -INFINITY : INFINITY; }
static double f_half_step(double x) { return x < 0.3 ? -INFINITY : x - 0.29; }
static double f_half_wall(double x) { return x < 0.3 ? x - 0.31 : INFINITY; }
static double f_sine(double x) { return sin(x) - x / 2; }
static double f_linear(double x) { return 3 * x - 1; }
static double f_huge(double x) { return x * 1.7e308 - 1e308; }

static const struct {
    const char *name;
    double (*f)(double);
    double lo, hi, root, slack; /* slack: how far f itself is from deciding at the root */
    int slow;                   /* regula falsi may fail to get near */
} table[] = {
    {"cos x - x", f_cos, 0, 1, 0.73908513321516064, 1e-15, 0},
    {"e^x - 2", f_exp, -4, 4, 0.69314718055994531, 1e-15, 0},
    {"x^3 - 2x - 5", f_cubic, 2, 3, 2.0945514815423265, 1e-15, 0},
    {"x e^(-1/x^2)", f_flat, -1, 4, 0, 0.04, 1},
    {"x^21 - 1e-8", f_steep, 0, 3, 0.41595621630718439, 1e-15, 1},
    {"(x-1)^9", f_ninth, 0, 3, 1, 1e-30, 1},
    {"(x-1)^3", f_third, -2, 3, 1, 1e-30, 1},
    {"cube root", f_root, -1, 2, 0.25, 1e-15, 0},
    {"atan", f_atan, 0, 1, 0.7, 1e-15, 0},
    {"1/(x-0.2) - 1", f_pole, 0.2000001, 9, 1.2, 1e-15, 1},
    {"infinite step", f_step, -1, 1, 0.3, 1e-15, 0},
    {"half infinite", f_half_step, -1, 1, 0.3, 1e-15, 0},
    {"half infinite, right", f_half_wall, -1, 1, 0.3, 1e-15, 0},
    {"sin x - x/2", f_sine, 1, 3, 1.8954942670339809, 1e-15, 0},
    {"3x - 1", f_linear, -5, 7, 1.0 / 3, 1e-15, 0},
    {"near overflow", f_huge, -1, 1, 1 / 1.7, 1e-15, 0},
};
#define TABLE ((int)(sizeof table / sizeof table[0]))

TEST(test_methods_agree_on_known_roots) {
    static const double tolerances[] = {1e-3, 1e-9, 0};
    static probe p;
    for (int i = 0; i < TABLE; i++)
        for (int t = 0; t < 3; t++)
            for (int m = 0; m < 4; m++) {
                double tolerance = tolerances[t], lo = table[i].lo, hi = table[i].hi;
                algsurf_refine_options o = options_of(methods[m], tolerance, 3000);
                algsurf_refined_root r;
                p.f = table[i].f, p.calls = 0;
                algsurf_status status = algsurf_refine_function(call, &p, lo, hi, &o, &r);
                check_result(&r, &p, lo, hi, tolerance, methods[m]);
                assert_int_equal(status, r.converged ? ALGSURF_OK : ALGSURF_NOT_CONVERGED);
                int falsi = methods[m] == ALGSURF_METHOD_REGULA_FALSI;
                if (falsi && table[i].slow) continue;
                double most = (falsi ? 10 : 1) * width(tolerance, r.root) + table[i].slack;
                if (!r.converged || !(fabs(r.root - table[i].root) <= most))
                    fail_msg("%s, method %d, tolerance %g: %.17g after %d", table[i].name, (int)methods[m],
                             tolerance, r.root, r.evaluations);
            }
}

/* Bisection needs log2 of width over tolerance, Brent stays under four times as many here (its own bound is
 * about the square), and a third of bisection's where the function is smooth. */
TEST(test_evaluations_are_bounded) {
    static probe p;
    for (int i = 0; i < TABLE; i++) {
        algsurf_refined_root brent, bisection;
        algsurf_refine_options o = options_of(ALGSURF_METHOD_BISECTION, 2e-12, 0);
        double lo = table[i].lo, hi = table[i].hi, halvings = ceil(log2((hi - lo) / 2e-12));
        p.f = table[i].f;
        assert_ok(algsurf_refine_function(call, &p, lo, hi, &o, &bisection));
        assert_true(bisection.evaluations <= 2 + halvings);
        o.method = ALGSURF_METHOD_BRENT;
        assert_ok(algsurf_refine_function(call, &p, lo, hi, &o, &brent));
        assert_true(brent.evaluations <= 2 + 4 * halvings);
        if (p.f == f_step || p.f == f_half_step || p.f == f_half_wall)
            assert_true(brent.evaluations <= bisection.evaluations + 2); /* an infinite end: halving */
        if (p.f == f_cos || p.f == f_exp || p.f == f_cubic || p.f == f_sine || p.f == f_linear)
            assert_true(3 * brent.evaluations < bisection.evaluations);
    }
}

/* Brent's procedure `zero` as printed (1973, section 4.6), writing down its points. */
static int book(double (*f)(double), double a, double b, double t, double *at) {
    double fa = f(a), fb = f(b), c = a, fc = fa, d = b - a, e = d;
    int count = 0;
    at[count++] = a, at[count++] = b;
    for (;;) {
        if (fabs(fc) < fabs(fb)) a = b, b = c, c = a, fa = fb, fb = fc, fc = fa;
        double tol = 2 * DBL_EPSILON * fabs(b) + t, m = 0.5 * (c - b);
        if (fabs(m) <= tol || fb == 0) return count;
        if (fabs(e) < tol || fabs(fa) <= fabs(fb)) {
            d = e = m;
        } else {
            double s = fb / fa, p, q, r;
            if (a == c) {
                p = 2 * m * s, q = 1 - s;
            } else {
                q = fa / fc, r = fb / fc;
                p = s * (2 * m * q * (q - r) - (b - a) * (r - 1)), q = (q - 1) * (r - 1) * (s - 1);
            }
            if (p > 0) q = -q;
            p = fabs(p);
            s = e, e = d;
            if (2 * p < 3 * m * q - fabs(tol * q) && p < fabs(0.5 * s * q))
                d = p / q;
            else
                d = e = m;
        }
        a = b, fa = fb;
        b += fabs(d) > tol ? d : m > 0 ? tol : -tol;
        fb = f(b), at[count++] = b;
        if ((fb > 0) == (fc > 0)) c = a, fc = fa, d = e = b - a;
    }
}

static double random_c[8];
static double f_random(double x) {
    double y = 0;
    for (int i = 7; i >= 0; i--) y = y * x + random_c[i];
    return y;
}

static void compare_with_book(double (*f)(double), double lo, double hi, double tolerance) {
    static probe p;
    static double at[RECORDED];
    algsurf_refine_options o = options_of(ALGSURF_METHOD_BRENT, tolerance, RECORDED);
    algsurf_refined_root r;
    p.f = f, p.calls = 0;
    assert_ok(algsurf_refine_function(call, &p, lo, hi, &o, &r));
    int count = book(f, lo, hi, 0.5 * tolerance, at); /* of half the width */
    assert_int_equal(p.calls, count);
    assert_memory_equal(p.at, at, (size_t)count * sizeof *at);
}

TEST(test_brent_is_brents) {
    for (int i = 0; i < TABLE; i++) {
        if (isinf(table[i].f(table[i].lo)) || isinf(table[i].f(table[i].hi)))
            continue; /* the book has no rule for infinite values */
        for (double t = 1e-2; t > 1e-15; t *= 0.1) compare_with_book(table[i].f, table[i].lo, table[i].hi, t);
    }
    uint64_t seed = SEED;
    for (int round = 0; round < 3000; round++) {
        for (int i = 0; i < 8; i++) random_c[i] = random_wide(&seed, -6, 3);
        double lo = 2 * random_unit(&seed), hi = lo + 2 * fabs(random_unit(&seed));
        if (sign_of(f_random(lo)) * sign_of(f_random(hi)) < 0)
            compare_with_book(f_random, lo, hi, ldexp(1.0, -5 - random_int(&seed, 45)));
    }
}

static double f_power(double x) { return pow(x, 9) - 0.5; }

/* The chord of a convex function moves one end by 1e-4 a step; the root is at 0.93. */
TEST(test_regula_falsi_says_when_it_fails) {
    static probe p = {.f = f_power};
    algsurf_refine_options o = options_of(ALGSURF_METHOD_REGULA_FALSI, 1e-14, 60);
    algsurf_refined_root r;
    assert_int_equal(algsurf_refine_function(call, &p, 0, 3, &o, &r), ALGSURF_NOT_CONVERGED);
    check_result(&r, &p, 0, 3, 1e-14, o.method);
    assert_true(!r.converged && r.iterations == 60 && r.root < 0.1 && r.hi == 3);
    assert_true(fabs(p.at[61] - p.at[60]) > 1e-14); /* it still moved */
    o.absolute_tolerance = 2e-3, p.calls = 0;       /* two points closer than this: the early stop */
    assert_ok(algsurf_refine_function(call, &p, 0, 3, &o, &r));
    assert_true(r.converged && r.hi - r.lo > 1 && p.calls == 4);
}

/* t^2 - 2 within a radius of its constant: the final bracket is the range of the roots, to a unit or two. */
TEST(test_radii) {
    algsurf_refined_root root = {.root = 7}, middle;
    static const double c[3] = {-2, 0, 1};
    for (int e = 2; e < 60; e += 3) {
        const double r[3] = {ldexp(1, -e), 0, 0};
        double lo = sqrt(2 - r[0]), hi = sqrt(2 + r[0]);
        assert_ok(algsurf_refine_poly(c, r, 2, 1, 3, NULL, &root));
        assert_ok(algsurf_refine_poly(c, NULL, 2, 1, 3, NULL, &middle));
        assert_true(root.root == middle.root && root.residual == middle.residual);
        assert_true(root.evaluations == middle.evaluations && root.iterations == middle.iterations);
        assert_true(root.converged);
        assert_true(lo - 0x1p-51 <= root.lo && root.lo <= lo + 0x1p-52);
        assert_true(hi - 0x1p-52 <= root.hi && root.hi <= hi + 0x1p-51);
        algsurf_refine_options coarse = options_of(ALGSURF_METHOD_DEFAULT, 0.25, 0);
        assert_ok(algsurf_refine_poly(c, r, 2, 1, 3, &coarse, &root));
        assert_true(root.lo <= lo + 0x1p-52 && hi - 0x1p-52 <= root.hi &&
                    root.evaluations < middle.evaluations);
    }
    const double none[3] = {0, 0, 0};
    assert_ok(algsurf_refine_poly(c, none, 2, 1, 3, NULL, &root));
    assert_ok(algsurf_refine_poly(c, NULL, 2, 1, 3, NULL, &middle));
    assert_true(root.lo == middle.lo && root.hi == middle.hi && root.evaluations == middle.evaluations);
    const double line[2] = {0, 1}, slope[2] = {0, 0.5}; /* all have the root 0 */
    assert_ok(algsurf_refine_poly(line, slope, 1, -1, 2, NULL, &root));
    assert_true(root.root == 0 && root.lo == 0 && root.hi == 0);
    assert_ok(algsurf_refine_poly(line, slope, 1, 0, 0, NULL, &root));
    assert_true(root.root == 0 && root.lo == 0 && root.hi == 0);
    const double thrice[4] = {-0.125, 0.75, -1.5, 1}, little[4] = {0x1p-40, 0, 0, 0}; /* about (t - 1/2)^3 */
    assert_ok(algsurf_refine_poly(thrice, little, 3, -1, 2, NULL, &root));
    assert_true(root.root == 0.5 && root.lo <= 0.5 - 9.6e-5 && root.hi >= 0.5 + 9.6e-5 &&
                root.hi - root.lo < 1e-3);
}

/* A bracket is refused where a polynomial of the set may have no root in it, and so are bad radii. */
TEST(test_radii_refused) {
    algsurf_refined_root root = {.root = 7};
    static const double c[3] = {-2, 0, 1}, r[3] = {0.5, 0, 0};
    static const struct {
        double r[3], lo, hi;
        algsurf_status status;
    } cases[] = {
        {{0.5, 0, 0}, 1.25, 3, ALGSURF_E_ARGUMENT}, /* the first of them have their root before it */
        {{0.5, 0, 0}, 1, 1.5, ALGSURF_E_ARGUMENT},
        {{0.5, 0, 0}, 2, 3, ALGSURF_E_ARGUMENT},  /* none has one */
        {{0.5, 0, 0}, -3, 3, ALGSURF_E_ARGUMENT}, /* two */
        {{2, 0, 1}, 1, 3, ALGSURF_E_ARGUMENT},    /* 0 is among them */
        {{2, 0, 0.5}, 0, 3, ALGSURF_E_ARGUMENT},
        {{-0.5, 0, 0}, 1, 3, ALGSURF_E_ARGUMENT},
        {{0.5, NAN, 0}, 1, 3, ALGSURF_E_NOT_FINITE},
        {{0.5, 0, INFINITY}, 1, 3, ALGSURF_E_NOT_FINITE},
        {{0.5, 0, 0}, 3, 1, ALGSURF_E_ARGUMENT},
        {{0.5, 0, 0}, 1, INFINITY, ALGSURF_E_NOT_FINITE},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++)
        assert_int_equal(algsurf_refine_poly(c, cases[i].r, 2, cases[i].lo, cases[i].hi, NULL, &root),
                         cases[i].status);
    for (int m = 1; m < 4; m++) {
        algsurf_refine_options o = options_of(methods[m], 0, 0);
        assert_int_equal(algsurf_refine_poly(c, r, 2, 1, 3, &o, &root), ALGSURF_E_ARGUMENT);
    }
    const double zero[3] = {0, 0, 0};
    assert_int_equal(algsurf_refine_poly(zero, r, 2, 1, 3, NULL, &root), ALGSURF_E_ARGUMENT);
    assert_true(root.root == 7);
}

TEST(test_iteration_limit) {
    static probe p;
    for (int m = 0; m < 4; m++)
        for (int limit = 1; limit < 6; limit++) {
            algsurf_refine_options o = options_of(methods[m], 0, limit);
            algsurf_refined_root r;
            p.f = f_exp, p.calls = 0;
            assert_int_equal(algsurf_refine_function(call, &p, -4, 4, &o, &r), ALGSURF_NOT_CONVERGED);
            check_result(&r, &p, -4, 4, 0, methods[m]);
            assert_int_equal(r.iterations, limit);
            assert_int_equal(r.converged, 0);
        }
}

static double f_identity(double x) { return x; }
static double f_shifted(double x) { return x - 0x1.8p-1070; }
static double f_big_root(double x) { return x > 1e-200 ? 1 : -1; }

TEST(test_ends_and_extremes) {
    static probe p;
    algsurf_refined_root r;
    for (int m = 0; m < 4; m++) {
        algsurf_refine_options o = options_of(methods[m], 0, 3000);
        p = (probe){.f = f_identity};
        assert_ok(algsurf_refine_function(call, &p, 0, 5, &o, &r)); /* root at lo */
        assert_true(r.root == 0 && r.residual == 0 && r.converged == 1 && p.calls == 2);
        assert_ok(algsurf_refine_function(call, &p, -5, 0, &o, &r)); /* at hi */
        assert_true(r.root == 0 && r.lo == -5 && r.hi == 0);
        assert_ok(algsurf_refine_function(call, &p, 0, 0, &o, &r)); /* lo = hi */
        assert_true(r.root == 0 && r.lo == 0 && r.hi == 0);
        p = (probe){.f = f_shifted}; /* subnormal bracket */
        assert_ok(algsurf_refine_function(call, &p, 0, 0x1p-1060, &o, &r));
        check_result(&r, &p, 0, 0x1p-1060, 0, methods[m]);
        assert_true(fabs(r.root - 0x1.8p-1070) <= 2 * 0x1p-1073);
        p = (probe){.f = f_big_root}; /* 1665 binary orders away from either end */
        assert_ok(algsurf_refine_function(call, &p, -1e300, 1e300, &o, &r));
        if (methods[m] != ALGSURF_METHOD_REGULA_FALSI) assert_true(fabs(r.root - 1e-200) < 1e-214);
        o.max_iterations = 0; /* the default limit is too small for plain halving, and it says so */
        if (methods[m] == ALGSURF_METHOD_BISECTION)
            assert_int_equal(algsurf_refine_function(call, &p, -1e300, 1e300, &o, &r), ALGSURF_NOT_CONVERGED);
        o.absolute_tolerance = 1e290; /* the width overflows */
        p = (probe){.f = f_identity};
        assert_ok(algsurf_refine_function(call, &p, -1.5e308, DBL_MAX, &o, &r));
        check_result(&r, &p, -1.5e308, DBL_MAX, 1e290, methods[m]);
    }
}

/* ---- polynomials ---- */

/* prod (x - roots[i]), exact when the roots are small dyadic numbers. */
static void from_roots(double *c, const double *roots, int n) {
    c[0] = 1;
    for (int i = 0; i < n; i++) {
        c[i + 1] = c[i];
        for (int k = i; k > 0; k--) c[k] = c[k - 1] - roots[i] * c[k];
        c[0] *= -roots[i];
    }
}

static void fail_poly(const char *what, const double *c, int n, int method, const algsurf_refined_root *r) {
    exact_print_doubles("c", c, n + 1);
    fail_msg("%s, seed %u, method %d: root %a in [%a,%a] after %d", what, SEED, (int)method, r->root, r->lo,
             r->hi, r->evaluations);
}

/* Roots k/16, distinct, degree up to 7: coefficients are exact, so is the sign between roots. */
TEST(test_polynomials_with_known_roots) {
    uint64_t seed = SEED;
    int points[4] = {0};
    for (int round = 0; round < 1500; round++) {
        int n = 1 + random_int(&seed, 7), at = random_int(&seed, n);
        double roots[7], c[8], gap = 2;
        for (int i = 0; i < n; i++) roots[i] = (i * 5 - 16 + random_int(&seed, 5)) / 16.0;
        from_roots(c, roots, n);
        if (at > 0) gap = fmin(gap, roots[at] - roots[at - 1]);
        if (at < n - 1) gap = fmin(gap, roots[at + 1] - roots[at]);
        double lo = roots[at] - gap * (0.01 + 0.98 * fabs(random_unit(&seed)));
        double hi = roots[at] + gap * (0.01 + 0.98 * fabs(random_unit(&seed)));
        for (int m = 0; m < 4; m++)
            for (int t = 0; t < 2; t++) {
                double tolerance = t ? 1e-9 : 0;
                algsurf_refine_options o = options_of(methods[m], tolerance, 100000);
                algsurf_refined_root r;
                assert_ok(algsurf_refine_poly(c, NULL, n, lo, hi, &o, &r));
                int narrow = r.residual == 0 || r.hi - r.lo <= width(tolerance, r.root);
                if (methods[m] == ALGSURF_METHOD_REGULA_FALSI) narrow = 1;
                double error = fabs(r.root - roots[at]), most = width(tolerance, r.root) + 1e-11;
                if (methods[m] == ALGSURF_METHOD_REGULA_FALSI) most = t ? 1e-5 : 1e-9;
                if (!narrow || error > most || r.lo < lo || r.hi > hi)
                    fail_poly("known root", c, n, methods[m], &r);
                if (t && exact_poly_sign(c, n, r.lo - 1e-11) * exact_poly_sign(c, n, r.hi + 1e-11) > 0)
                    fail_poly("bracket lost", c, n, methods[m], &r);
                if (methods[m] == ALGSURF_METHOD_DEFAULT && r.evaluations > (roots[at] == 0 ? 100 : 50))
                    fail_poly("slow", c, n, methods[m], &r);
                if (roots[at] != 0) points[m] += r.evaluations;
            }
    }
    assert_true(points[0] < 0.9 * points[1] && points[1] < points[2] / 2); /* Newton, Brent, bisection */
}

/* Odd multiplicities: rounding noise hides the root, but never the sign change, and nothing hangs. */
TEST(test_multiple_roots) {
    static const int multiplicity[] = {3, 5, 9};
    static const double noise[] = {1e-4, 5e-3, 0.1};
    for (int i = 0; i < 3; i++) {
        double roots[9], c[10];
        for (int k = 0; k < 9; k++) roots[k] = 1;
        from_roots(c, roots, multiplicity[i]);
        for (int m = 0; m < 3; m++)
            for (double shift = 0; shift < 0.9; shift += 0.13) {
                algsurf_refine_options o = options_of(methods[m], 0, 0);
                algsurf_refined_root r;
                assert_ok(algsurf_refine_poly(c, NULL, multiplicity[i], shift, 2.7, &o, &r));
                assert_true(r.residual == 0 || r.hi - r.lo <= width(0, r.root));
                if (fabs(r.root - 1) > noise[i] || r.evaluations > 150)
                    fail_poly("multiple root", c, multiplicity[i], methods[m], &r);
            }
    }
}

/* Newton's limit holds on whatever has a sign change, in brackets from subnormal to near overflow, and its
 * bracket always closes. */
TEST(test_newton_is_bounded) {
    uint64_t seed = SEED;
    static double c[ALGSURF_MAX_POLY_DEGREE + 1];
    static const int degrees[] = {1, 2, 3, 5, 9, 21, 64, 512};
    int done = 0, points = 0;
    for (int round = 0; round < 4000; round++) {
        int n = degrees[random_int(&seed, round % 20 ? 7 : 8)], wide = round % 3;
        for (int i = 0; i <= n; i++) c[i] = random_wide(&seed, wide ? -900 : -3, wide ? 900 : 3);
        int range = wide == 2 ? 1000 : 3;
        double lo = random_wide(&seed, -range, range), hi = random_wide(&seed, -range, range);
        algsurf_refined_root r;
        algsurf_status status = algsurf_refine_poly(c, NULL, n, fmin(lo, hi), fmax(lo, hi), NULL, &r);
        if (status == ALGSURF_E_ARGUMENT) continue; /* no sign change */
        assert_ok(status);
        int narrow = nextafter(nextafter(r.lo, INFINITY), INFINITY) >= r.hi;
        if (!narrow || r.evaluations > NEWTON_POINTS)
            fail_poly("not closed", c, n, ALGSURF_METHOD_DEFAULT, &r);
        done++, points += r.evaluations;
    }
    assert_true(done > 1000 && points < 22 * done); /* 51 when steps are not lengthened */
}

TEST(test_extreme_polynomials) {
    algsurf_refined_root r;
    static const double sqrt2 = 1.4142135623730951;
    static const double scales[] = {1, 1e300, 1e-300, 0x1p-1070, 0x1p1020};
    for (size_t i = 0; i < sizeof scales / sizeof scales[0]; i++)
        for (int m = 0; m < 3; m++) {
            const double c[3] = {-2 * scales[i], 0, scales[i]};
            algsurf_refine_options o = options_of(methods[m], 0, 0);
            assert_ok(algsurf_refine_poly(c, NULL, 2, 0, 1e10, &o, &r));
            assert_true(fabs(r.root - sqrt2) < 1e-15);
            o.absolute_tolerance = 0.1; /* the value is p's own, not a scaled one */
            assert_ok(algsurf_refine_poly(c, NULL, 2, 0, 3, &o, &r));
            assert_true(fabs(r.residual / scales[i] - (r.root * r.root - 2)) <=
                        (scales[i] < 0x1p-1000 ? 0.1 : 1e-14));
            const double far[3] = {-scales[i], scales[i] * 0.25, 0}; /* root 4, leading zero */
            o.absolute_tolerance = 0, o.max_iterations = 3000;
            assert_ok(algsurf_refine_poly(far, NULL, 2, -1e10, 1e300, &o, &r));
            assert_true(fabs(r.root - 4) < 1e-14);
        }
    /* values overflow at the root itself: x^41 - 1e10 x^40; the signs are right all the same */
    double c[42] = {0};
    c[41] = 1, c[40] = -1e10;
    assert_ok(algsurf_refine_poly(c, NULL, 41, 1e3, 1e15, NULL, &r));
    assert_true(fabs(r.root - 1e10) <= 1e-4);
    /* x^3 - 1e-300 between the ends of the range */
    const double tiny[4] = {-1e-300, 0, 0, 1};
    assert_ok(algsurf_refine_poly(tiny, NULL, 3, -1e300, 1e300, NULL, &r));
    assert_true(fabs(r.root / 1e-100 - 1) < 1e-14 && r.evaluations <= NEWTON_POINTS);
    /* degree 0: zero is a root everywhere, a constant nowhere */
    const double zero = 0, one = 1;
    assert_ok(algsurf_refine_poly(&zero, NULL, 0, -1, 1, NULL, &r));
    assert_true(r.residual == 0 && r.converged);
    assert_int_equal(algsurf_refine_poly(&one, NULL, 0, -1, 1, NULL, &r), ALGSURF_E_ARGUMENT);
}

/* ---- environment, options, bad input ---- */

typedef struct outcome {
    algsurf_status status;
    algsurf_refined_root root;
} outcome;

static void refine_by_all(void *answers) {
    static const double c[6] = {0.3, -1.1, 0.7, 2.3, -0.9, 0.01};
    static const double small[3] = {-0x1p-1060, 0x1p-1061, 0x1p-1062};
    outcome *to = answers;
    for (int m = 0; m < 4; m++, to += 2) {
        algsurf_refine_options o = options_of(methods[m], 0, 0);
        to[0].status = algsurf_refine_poly(c, NULL, 5, -1, 0, &o, &to[0].root);
        to[1].status = algsurf_refine_poly(small, NULL, 2, 0, 9, &o, &to[1].root);
    }
}

/* (That a function runs in the caller's environment: test_every_call.) */
TEST(test_any_environment) { environments_agree(refine_by_all, 8 * sizeof(outcome)); }

TEST(test_options) {
    static probe p = {.f = f_exp};
    algsurf_refined_root r;
    struct {
        algsurf_refine_options known;
        double later;
    } newer = {options_of(ALGSURF_METHOD_BISECTION, 1e-3, 0), 0};
    newer.known.size = sizeof newer;
    assert_ok(algsurf_refine_function(call, &p, 0, 1, &newer.known, &r));
    assert_int_equal(r.evaluations, 12);
    newer.later = 1; /* a wish this version does not know */
    assert_int_equal(algsurf_refine_function(call, &p, 0, 1, &newer.known, &r), ALGSURF_E_SIZE);
    algsurf_refine_options o = options_of(ALGSURF_METHOD_BISECTION, 1e-3, 2);
    for (o.size = 0; o.size < sizeof o; o.size++) /* no release had a smaller one */
        assert_int_equal(algsurf_refine_function(call, &p, 0, 1, &o, &r), ALGSURF_E_SIZE);
    algsurf_refine_options bad[7];
    for (int i = 0; i < 7; i++) bad[i] = options_of(ALGSURF_METHOD_DEFAULT, 0, 0);
    bad[0].size = 0, bad[1].size = sizeof(size_t) - 1, bad[2].absolute_tolerance = -1e-300,
    bad[3].absolute_tolerance = NAN;
    bad[4].absolute_tolerance = INFINITY, bad[5].max_iterations = -1, bad[6].method = 4;
    const double c[2] = {-0.5, 1};
    for (int i = 0; i < 7; i++) {
        const algsurf_status wanted = i < 2              ? ALGSURF_E_SIZE
                                      : i == 3 || i == 4 ? ALGSURF_E_NOT_FINITE
                                                         : ALGSURF_E_ARGUMENT;
        assert_int_equal(algsurf_refine_function(call, &p, 0, 1, &bad[i], &r), wanted);
        assert_int_equal(algsurf_refine_poly(c, NULL, 1, 0, 1, &bad[i], &r), wanted);
    }
}

static double f_nan(double x) { return x > 0.2 && x < 0.8 ? NAN : x - 0.5; }
static double f_nan_end(double x) { return x == 0 ? NAN : x - 0.5; }

TEST(test_bad_input) {
    static probe p = {.f = f_exp};
    algsurf_refined_root r, before;
    memset(&r, 0x5a, sizeof r), memcpy(&before, &r, sizeof r);
    assert_int_equal(algsurf_refine_function(NULL, &p, 0, 1, NULL, &r), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_refine_function(call, &p, 0, 1, NULL, NULL), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_refine_function(call, &p, 1, 0, NULL, &r), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_refine_function(call, &p, NAN, 1, NULL, &r), ALGSURF_E_NOT_FINITE);
    assert_int_equal(algsurf_refine_function(call, &p, 0, INFINITY, NULL, &r), ALGSURF_E_NOT_FINITE);
    assert_int_equal(p.calls, 0);
    assert_int_equal(algsurf_refine_function(call, &p, 1, 2, NULL, &r), ALGSURF_E_ARGUMENT); /* same signs */
    assert_int_equal(algsurf_refine_function(call, &p, 1, 1, NULL, &r), ALGSURF_E_ARGUMENT);
    for (int m = 0; m < 4; m++) {
        algsurf_refine_options o = options_of(methods[m], 0, 0);
        p.f = f_nan;
        assert_int_equal(algsurf_refine_function(call, &p, 0, 1, &o, &r), ALGSURF_E_NOT_FINITE);
        p.f = f_nan_end;
        assert_int_equal(algsurf_refine_function(call, &p, 0, 1, &o, &r), ALGSURF_E_NOT_FINITE);
        assert_int_equal(algsurf_refine_function(call, &p, -1, 0, &o, &r), ALGSURF_E_NOT_FINITE);
    }
    const double c[2] = {-0.5, 1}, nan_c[2] = {NAN, 1}, inf_c[2] = {1, -INFINITY};
    assert_int_equal(algsurf_refine_poly(NULL, NULL, 1, 0, 1, NULL, &r), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_refine_poly(c, NULL, 1, 0, 1, NULL, NULL), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_refine_poly(c, NULL, -1, 0, 1, NULL, &r), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_refine_poly(c, NULL, ALGSURF_MAX_POLY_DEGREE + 1, 0, 1, NULL, &r),
                     ALGSURF_E_DEGREE);
    assert_int_equal(algsurf_refine_poly(c, NULL, 1, 1, 0, NULL, &r), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_refine_poly(c, NULL, 1, 2, 3, NULL, &r), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_refine_poly(c, NULL, 1, -INFINITY, 3, NULL, &r), ALGSURF_E_NOT_FINITE);
    assert_int_equal(algsurf_refine_poly(c, NULL, 1, 0, NAN, NULL, &r), ALGSURF_E_NOT_FINITE);
    assert_int_equal(algsurf_refine_poly(nan_c, NULL, 1, 0, 1, NULL, &r), ALGSURF_E_NOT_FINITE);
    assert_int_equal(algsurf_refine_poly(inf_c, NULL, 1, 0, 1, NULL, &r), ALGSURF_E_NOT_FINITE);
    assert_memory_equal(&r, &before, sizeof r);
}

/* ---- the observer ---- */

static double power_less_half(double x, void *data) { return pow(x, *(const double *)data) - 0.5; }

typedef struct {
    int calls, other_rounding, engine;
    double x[RECORDED], value[RECORDED];
} record;

static void watch(double x, double value, int engine, void *data) {
    record *r = data;
    volatile double one = 1, tiny = 0x1p-60;
    assert_true(r->calls < RECORDED);
    assert_true(engine == ALGSURF_ENGINE_DOUBLES || engine == ALGSURF_ENGINE_INTEGERS);
    r->engine = engine > r->engine ? engine : r->engine;
    r->other_rounding |= one + tiny != 1 || one - tiny != 1;
    r->x[r->calls] = x;
    r->value[r->calls++] = value;
}

static double horner(const double *c, int n, double x) {
    double y = c[n];
    for (int i = n - 1; i >= 0; i--) y = y * x + c[i];
    return y;
}

/* What a record says is what happened: the ends, the points, their values, the bracket they leave. */
static void check_record(const record *seen, const double *c, int n, double lo, double hi, int method,
                         const algsurf_refined_root *r) {
    double left = lo, right = hi;
    int found = 0;
    assert_int_equal(seen->calls, r->evaluations);
    assert_true(seen->x[0] == lo && seen->x[1] == hi);
    for (int i = 0; i < seen->calls; i++) {
        double x = seen->x[i];
        if (method != ALGSURF_METHOD_DEFAULT)
            assert_true(seen->value[i] == horner(c, n, x));
        else
            assert_int_equal(sign_of(seen->value[i]), exact_poly_sign(c, n, x));
        assert_true(lo <= x && x <= hi);
        found |= x == r->root && seen->value[i] == r->residual;
        if (i < 2) continue;
        assert_true(left <= x && x <= right);
        if (sign_of(seen->value[i]) == sign_of(seen->value[0]))
            left = x;
        else
            right = x;
    }
    assert_true(found);
    if (r->residual != 0) assert_true(r->lo == left && r->hi == right);
}

/* Catches: an observer that is not told an end or a point, is told another polynomial's value (that of the
 * balanced one), counts otherwise, changes the result, or runs in the caller's rounding. */
TEST(test_observer) {
    static record seen;
    uint64_t seed = SEED;
    int polynomials = 0;
    for (int round = 0; round < 3000; round++) {
        double c[6], shift = ldexp(1, 600 * (round % 3 - 1)); /* balanced, as it is, balanced */
        for (int i = 0; i < 6; i++) c[i] = shift * random_wide(&seed, -6, 3);
        double lo = random_unit(&seed), hi = lo + fabs(random_unit(&seed));
        if (sign_of(horner(c, 5, lo)) * sign_of(horner(c, 5, hi)) >= 0) continue;
        polynomials++;
        for (int m = 0; m < 4; m++) {
            algsurf_refine_options o = options_of(methods[m], 1e-9, 0);
            algsurf_refined_root plain, r;
            memset(&plain, 0, sizeof plain), memset(&r, 0, sizeof r);
            algsurf_observer observer = {.size = sizeof observer, .data = &seen, .on_point = watch};
            seen.calls = seen.engine = 0;
            algsurf_status status = algsurf_refine_poly(c, NULL, 5, lo, hi, &o, &plain);
            o.observer = &observer;
            fesetround(round % 2 ? FE_UPWARD : FE_TONEAREST);
            algsurf_status observed = algsurf_refine_poly(c, NULL, 5, lo, hi, &o, &r);
            fesetround(FE_TONEAREST);
            assert_int_equal(observed, status);
            assert_memory_equal(&r, &plain, sizeof r);
            check_record(&seen, c, 5, lo, hi, methods[m], &r);
            assert_true(observer.evaluations == (size_t)seen.calls && observer.engine == seen.engine);
            assert_true(observer.cells == 0);
        }
    }
    assert_true(polynomials > 50);
    assert_int_equal(seen.other_rounding, 0);
}

/* Of a function, too, in the caller's environment; integers are named; what is refused has seen nothing, and
 * a bracket that is none both ends. */
TEST(test_observer_of_others) {
    static record seen;
    const double c[2] = {-0.5, 1}, thrice[4] = {-1, 3, -3, 1};
    algsurf_observer observer = {.size = sizeof observer, .data = &seen, .on_point = watch};
    algsurf_refine_options o = {.size = sizeof o, .observer = &observer};
    algsurf_refined_root r, plain;
    double power = 3;
    memset(&plain, 0, sizeof plain), memset(&r, 0, sizeof r);
    seen.calls = 0;
    assert_ok(algsurf_refine_function(power_less_half, &power, 0, 1, NULL, &plain));
    assert_ok(algsurf_refine_function(power_less_half, &power, 0, 1, &o, &r));
    assert_memory_equal(&r, &plain, sizeof r);
    assert_true(seen.calls == r.evaluations && seen.x[0] == 0 && seen.x[1] == 1);
    for (int i = 0; i < seen.calls; i++) assert_true(seen.value[i] == power_less_half(seen.x[i], &power));
    assert_true(observer.evaluations == (size_t)seen.calls && observer.engine == ALGSURF_ENGINE_DOUBLES);
    seen.calls = 0;
    assert_ok(algsurf_refine_poly(thrice, NULL, 3, 0.5, 1 + 0x1p-52, &o, &r));
    assert_true(seen.calls == r.evaluations && observer.engine == ALGSURF_ENGINE_INTEGERS);
    seen.calls = 0;
    assert_int_equal(algsurf_refine_poly(NULL, NULL, 1, 0, 1, &o, &r), ALGSURF_E_ARGUMENT);
    assert_int_equal(algsurf_refine_poly(c, NULL, 1, 1, 0, &o, &r), ALGSURF_E_ARGUMENT);
    observer.size = 7;
    assert_int_equal(algsurf_refine_poly(c, NULL, 1, 0, 1, &o, &r), ALGSURF_E_SIZE);
    assert_int_equal(algsurf_refine_function(power_less_half, &power, 0, 1, &o, &r), ALGSURF_E_SIZE);
    observer.size = sizeof observer;
    assert_int_equal(seen.calls, 0);
    assert_int_equal(algsurf_refine_poly(c, NULL, 1, 1, 2, &o, &r), ALGSURF_E_ARGUMENT);
    assert_int_equal(seen.calls, 2);
}
