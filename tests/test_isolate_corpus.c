/* test_isolate_corpus.c - polynomials that have broken root finders, with what is known of their roots.
 *
 * Breaks caught, each tried: leading zeros kept (a root at infinity stays undecided), signs used inside their
 * bound (a multiple root lost), an exact sign that skips a coefficient or forgets that it is not exact, the
 * border of a group of roots at 0 or infinity, a gap left beside an exact root, a root reported once more as
 * its neighbour, a loose bracket that is believed.
 */

#include "isolate_case.h"

static isolate_answer answer;

/* The case, judged by Sturm's chain; it must have this many roots. */
static void decided(const double *c, int n, double lo, double hi, int roots) {
    isolate_judge(c, n, lo, hi, &answer);
    if (answer.count != roots) isolate_fail("corpus", c, NULL, n, lo, hi, &answer);
}

/* ---- cases of other people's accidents ---- */

TEST(test_ghosts_and_losses) {
    const double ghost[] = {9627.17676, -660.766052, 0.00329589844, 0, 1};
    const double pair[] = {26471900.25, -1325880, 25449, -240, 1};
    const double tiny_lead[] = {14482, -83592, 84888, 1.3022974889306702e-11, 8.0779356694631609e-28};
    const double tiny_ghost[] = {35842, -57720, 59800, -5.2252677e-12, 2.0194839e-28};
    decided(ghost, 4, -INFINITY, INFINITY, 0);
    decided(ghost, 4, -1e3, 1e3, 0);
    decided(pair, 4, -INFINITY, INFINITY, 2);
    decided(pair, 4, 0, 100, 2);
    decided(tiny_lead, 4, 0, 10, 2);
    decided(tiny_ghost, 4, 0, 10, 0);
    decided(tiny_lead, 4, -INFINITY, INFINITY, 2);
    decided(tiny_ghost, 4, -INFINITY, INFINITY, 0);
}

TEST(test_multiple_root) {
    const double fourth[] = {1, -4, 6, -4, 1};
    const double ends[][2] = {{-INFINITY, INFINITY}, {0, 2}, {1, 2}, {1, 1}};
    for (int i = 0; i < 4; i++) {
        decided(fourth, 4, ends[i][0], ends[i][1], 1);
        assert_true(answer.b[0].kind == ALGSURF_BRACKET_EXACT && answer.b[0].multiplicity == 4);
    }
    decided(fourth, 4, 1.25, INFINITY, 0);
}

/* The leading coefficient passes through zero: a root comes from infinity. */
TEST(test_degree_drop) {
    for (int k = -60; k <= 60; k++) {
        double lead = k ? copysign(ldexp(1, -abs(k)), k) : 0, c[] = {-2, 1, 0, lead, 0, 0};
        isolate_judge(c, 5, -INFINITY, INFINITY, &answer);
        assert_ok(answer.status);
        isolate_judge(c, 5, -2.5, 3, &answer);
        assert_ok(answer.status);
    }
}

/* ---- classical families ---- */

TEST(test_wilkinson) {
    double c[21] = {1};
    int n = 0;
    while (n < 14) n = isolate_times_root(c, n, n + 1, 1); /* exact up to here */
    decided(c, 14, 0, 20, 14);
    decided(c, 14, -INFINITY, INFINITY, 14);
    for (int k = 15; k <= 20; k++) { /* rounded: another polynomial, whose roots Sturm knows */
        for (int i = k; i >= 0; i--) c[i] = (i > 0 ? c[i - 1] : 0) - (i < k ? k * c[i] : 0);
        isolate_judge(c, k, 0, 25, &answer);
        assert_ok(answer.status);
        isolate_judge(c, k, -INFINITY, INFINITY, &answer);
        assert_ok(answer.status);
    }
}

TEST(test_chebyshev) {
    double c[3][32] = {{1}, {0, 1}};
    for (int n = 2; n <= 30; n++) {
        double *t = c[n % 3];
        for (int k = 0; k <= n; k++)
            t[k] = (k > 0 ? 2 * c[(n + 2) % 3][k - 1] : 0) - (k < n - 1 ? c[(n + 1) % 3][k] : 0);
        if (n % 4 != 2) continue;
        decided(t, n, -1, 1, n);
        decided(t, n, -INFINITY, INFINITY, n);
        decided(t, n, 0, 1, n / 2);
    }
}

/* n! L_n, exact integers: roots from 0.2 to 4 n. */
TEST(test_laguerre) {
    for (int n = 2; n <= 14; n += 3) {
        double c[16], a = 1;
        for (int k = n; k >= 0; k--) { /* n! C(n,k) (-1)^k / k!: from the top down */
            c[k] = k % 2 ? -a : a;
            a = a * k * k / (n - k + 1);
        }
        decided(c, n, 0, INFINITY, n);
        decided(c, n, -INFINITY, 0, 0);
    }
}

/* Mignotte: x^n - 2 (3x - 1)^2 has two roots around 1/3, about 3^-(n+2)/2 apart; from n = 72 on between the
 * same doubles. */
TEST(test_mignotte) {
    for (int n = 6; n <= 90; n += 6) {
        double c[91] = {-2, 12, -18};
        c[n] = 1;
        decided(c, n, 0, 1, 2);
        assert_int_equal(n >= 72, answer.b[0].lo == answer.b[1].lo);
    }
}

TEST(test_close_pairs) {
    for (int k = 1; k <= 26; k++) { /* (2^k x - a)(2^k x - (a+1)), a about 2^k / 3, and a third root */
        double c[4] = {1}, a = floor(ldexp(1, k) / 3);
        int n = isolate_times_root(c, 0, a, ldexp(1, k));
        if (k <= 24) n = isolate_times_root(c, n, a + 1, ldexp(1, k));
        decided(c, n, 0, 1, n);
        decided(c, n, -INFINITY, INFINITY, n);
    }
    for (int k = 2; k <= 45; k++) { /* (x - 1)^2 - 2^-k, roots 2^(1-k/2) apart */
        double c[] = {1 - ldexp(1, -k), -2, 1};
        decided(c, 2, 0, 3, 2);
    }
    for (int k = 1; k <= 45; k++) { /* x (x - 2^-k), at 0, and moved there: (x + 1) x (x - 2^-k) */
        double e = ldexp(1, -k), c[] = {0, -e, 1}, d[] = {0, -e, 1 - e, 1};
        decided(c, 2, -1, 1, 2);
        if (k <= 15) decided(d, 3, -2, 1, 3);
    }
}

TEST(test_clusters) {
    for (int k = 2; k <= 14; k++) { /* roots a-1, a, a+1 over 2^k */
        double c[5] = {1}, a = floor(ldexp(1, k) / 3) + 1;
        int n = 0;
        for (int i = -1; i <= 1; i++) n = isolate_times_root(c, n, a + i, ldexp(1, k));
        decided(c, n, 0, 1, 3);
    }
    for (int k = 2; k <= 50; k++) { /* x^3 - 2^-k x: three roots 2^-k/2 apart */
        double c[] = {0, -ldexp(1, -k), 0, 1};
        decided(c, 3, -1, 1, 3);
    }
}

/* ---- bounded work ---- */

TEST(test_bounded_work) {
    static double c[ALGSURF_MAX_POLY_DEGREE + 1];
    uint64_t seed = 5;
    int count;
    double start = unit_seconds();
    double a = 1;
    for (int k = 0; k <= 64; k++) { /* (x - 1/2)^64 as far as doubles hold it: rounded, it has no root */
        c[k] = ldexp(k % 2 ? -a : a, k - 64);
        a = a * (64 - k) / (k + 1);
    }
    isolate_judge(c, 64, -1, 1, &answer);
    isolate_judge(c, 64, 0.25, INFINITY, &answer);
    memset(&answer, 0, sizeof answer);
    for (int k = 0; k <= ALGSURF_MAX_POLY_DEGREE; k++) c[k] = random_unit(&seed);
    assert_ok(algsurf_isolate_all(c, NULL, 512, -INFINITY, INFINITY, NULL, answer.b, 513, &answer.count));
    for (int i = 0; i < answer.count; i++)
        if (isfinite(answer.b[i].lo))
            assert_int_equal(exact_poly_sign(c, 512, answer.b[i].lo), answer.b[i].sign);
    for (int k = 0; k <= ALGSURF_MAX_POLY_DEGREE; k++) c[k] = 0;
    c[200] = 1, c[0] = -2, c[1] = 12, c[2] = -18; /* two roots next to 1/3, 2^-160 apart */
    assert_true(algsurf_count_roots(c, NULL, 200, -INFINITY, INFINITY, &count) >= 0);
    double seconds = unit_seconds() - start;
    if (seconds > 10) fail_msg("%g s", seconds);
}

/* ---- degenerate polynomials ---- */

TEST(test_degenerate) {
    const double constant[] = {-3, 0, 0, 0}, monomial[] = {0, 0, 0, 0x1p-1000}, leading[] = {-1, 2, 0, 0, 0};
    const double trailing[] = {0, 0, -1, 2, 0}, largest[] = {-DBL_MAX, DBL_MAX, DBL_MAX},
                 least[] = {-0x1p-1074, 0x1p-1074};
    decided(constant, 0, -INFINITY, INFINITY, 0);
    decided(constant, 3, -INFINITY, INFINITY, 0);
    decided(monomial, 3, -1, 1, 1);
    assert_int_equal(answer.b[0].kind, ALGSURF_BRACKET_EXACT);
    decided(monomial, 3, 0x1p-1074, 1, 0);
    decided(monomial, 3, -INFINITY, 0, 1);
    decided(monomial, 3, 0, 0, 1);
    decided(leading, 4, -INFINITY, INFINITY, 1);
    decided(trailing, 4, -INFINITY, INFINITY, 2);
    decided(trailing, 4, 0, 0.5, 2);
    isolate_judge(largest, 2, -INFINITY, INFINITY, &answer);
    isolate_judge(least, 1, -INFINITY, INFINITY, &answer);
}

/* ---- where no double parts a root from what is beside it ---- */

/* The case, judged; it must have, in order, entries of these kinds within these ends. */
typedef struct narrow_case {
    int degree;
    double c[8], lo, hi;
    int count;
    struct {
        int kind;
        double lo, hi;
    } entry[3];
} narrow_case;

TEST(test_roots_between_doubles) {
    enum { BRACKET = ALGSURF_BRACKET_ISOLATED, EXACT = ALGSURF_BRACKET_EXACT };
    const double least = 0x1p-1074, inf = INFINITY;
    const narrow_case cases[] = {
        /* below the least double, beyond the largest, both, and a whole group of them */
        {2, {least, 1024, 1024}, -0.5, 0.5, 1, {{BRACKET, -4 * least, 4 * least}}},
        {1, {least, 1024}, -inf, inf, 1, {{BRACKET, -4 * least, 4 * least}}},
        {1, {least, 1024}, -least, 0, 1, {{BRACKET, -least, 0}}},
        {1, {-least, 1024}, least, inf, 0, {{0, 0, 0}}},
        {2, {1, 5, 0x1p-1060}, -inf, inf, 2, {{BRACKET, -inf, -DBL_MAX}, {BRACKET, -1, 1}}},
        {2, {1, -5, 0x1p-1060}, 0, inf, 2, {{BRACKET, 0, 1}, {BRACKET, DBL_MAX, inf}}},
        {3,
         {71, DBL_MAX, 1, least},
         -inf,
         5,
         3,
         {{BRACKET, -inf, -DBL_MAX}, {BRACKET, -inf, -DBL_MAX}, {BRACKET, -1, 0}}},
        {1, {1, -0x1p-1060}, 0, inf, 1, {{BRACKET, DBL_MAX, inf}}},
        {1, {1, -0x1p-1060}, 0, DBL_MAX, 0, {{0, 0, 0}}},
        {1, {1, 0x1p-1060}, -inf, 0, 1, {{BRACKET, -inf, -DBL_MAX}}},
        {1, {0x1.8p1023, 1}, -inf, inf, 1, {{EXACT, -0x1.8p1023, -0x1.8p1023}}},
        {2, {0x1p-1060, -1, 0x1p-1000}, 0, inf, 2, {{BRACKET, 0, 1}, {BRACKET, 1, 0x1p1001}}},
        /* beside a root at 0 */
        {2, {0, least, 1e5}, -1, 1, 2, {{BRACKET, -4 * least, 0}, {EXACT, 0, 0}}},
        {2, {0, -least, 1e5}, -1, 1, 2, {{EXACT, 0, 0}, {BRACKET, 0, 4 * least}}},
        {7,
         {0, least, 1, 0, 0, 0, 0, 11},
         -1,
         0,
         3,
         {{BRACKET, -1, -0.5}, {BRACKET, -4 * least, 0}, {EXACT, 0, 0}}},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        const narrow_case *k = cases + i;
        isolate_judge(k->c, k->degree, k->lo, k->hi, &answer);
        int as_told = answer.count == k->count;
        for (int j = 0; as_told && j < k->count; j++) {
            const algsurf_bracket *b = answer.b + j;
            as_told = b->kind == k->entry[j].kind && b->lo >= k->entry[j].lo && b->hi <= k->entry[j].hi;
        }
        if (!as_told) isolate_fail("between doubles", k->c, NULL, k->degree, k->lo, k->hi, &answer);
    }
}
