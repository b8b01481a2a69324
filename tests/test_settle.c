/* test_settle.c - simple roots brought between neighbouring doubles, by every kernel: exact signs at both
 * ends, the same bits, and hardly one left open.
 *
 * Catches: a pair that does not enclose, lanes that answer for others, a bound of compensated values that is
 * too small or never felt, neighbours across a power of two or below 0. */

#include "exact.h"
#include "roots/polys.h"
#include "simd/baseline.h"
#undef KERNEL
#define KERNEL(name) name##_here
#include "roots/settle_template.h"
#include "unit.h"

#define SEED 20261123u

typedef struct tally {
    long roots, open;
} tally;

static void judge(const double *c, int n, double lo, double hi, tally *seen) {
    algsurf_bracket b[ALGSURF_MAX_DEGREE];
    algsurf_real_root r[ALGSURF_MAX_DEGREE], other[ALGSURF_MAX_DEGREE];
    const algsurf_i_coefficients p = {c, NULL, n};
    const algsurf_i_kernel *kernel;
    int all = 0, count = 0;
    assert_ok(algsurf_isolate_all(c, NULL, n, lo, hi, NULL, b, ALGSURF_MAX_DEGREE, &all));
    for (int i = 0; i < all; i++)
        if (b[i].kind == ALGSURF_BRACKET_ISOLATED && b[i].multiplicity == 1 && !isinf(b[i].lo) &&
            !isinf(b[i].hi))
            b[count++] = b[i];
    memset(r, 0, sizeof r);
    memset(other, 0, sizeof other);
    for (int k = 0; (kernel = algsurf_i_kernel_at(k)); k++) {
        algsurf_real_root *to = k == 0 ? r : other;
        for (int i = 0; i < count; i++)
            to[i] = (algsurf_real_root){.lo = b[i].lo, .hi = b[i].hi, .multiplicity = 1, .sign = b[i].sign};
        algsurf_i_roots_kernel_for(kernel)->settle(&p, to, count);
        for (int i = 0; k > 0 && i < count; i++) {
            int same = r[i].multiplicity == other[i].multiplicity &&
                       (!r[i].multiplicity || memcmp(&r[i], &other[i], sizeof *r) == 0);
            if (!same) fail_msg("kernel %s, degree %d: [%a,%a]", kernel->name, n, r[i].lo, r[i].hi);
        }
    }
    for (int i = 0; i < count; i++) {
        seen->roots++;
        seen->open += !r[i].multiplicity;
        if (!r[i].multiplicity) continue;
        int before = algsurf_i_sign_at(&p, r[i].lo), after = algsurf_i_sign_at(&p, r[i].hi);
        if (!(before == b[i].sign && after == -b[i].sign && nextafter(r[i].lo, r[i].hi) == r[i].hi &&
              b[i].lo <= r[i].lo && r[i].hi <= b[i].hi && (r[i].root == r[i].lo || r[i].root == r[i].hi)))
            fail_msg("seed %u, degree %d: bracket [%a,%a], root in [%a,%a], signs %d, %d", SEED, n, b[i].lo,
                     b[i].hi, r[i].lo, r[i].hi, before, after);
    }
}

TEST(test_random) {
    uint64_t random = SEED;
    tally seen = {0, 0};
    for (int i = 0; i < 12000; i++) {
        double c[21];
        int n = 1 + i % 20;
        for (int k = 0; k <= n; k++)
            c[k] = ldexp(random_unit(&random), i % 3 ? 0 : random_int(&random, 40) - 20);
        judge(c, n, -1, 1, &seen);
        judge(c, n, -0x1p20, 0x1p19, &seen);
    }
    assert_true(seen.roots > 15000);
    if (seen.open * 500 > seen.roots) fail_msg("%ld of %ld open", seen.open, seen.roots);
}

/* Roots that plain values cannot see: Wilkinson's, and clusters. */
TEST(test_ill_conditioned) {
    uint64_t random = SEED;
    tally seen = {0, 0};
    for (int i = 0; i < 4000; i++) {
        double c[21] = {1};
        int n = 2 + i % 14;
        for (int m = 0; m < n; m++) {
            double root = 0.5 + ldexp(random_unit(&random), -(i % 9));
            for (int k = m + 1; k >= 0; k--) c[k] = (k > 0 ? c[k - 1] : 0) - (k <= m ? root * c[k] : 0);
        }
        judge(c, n, -3, 3, &seen);
    }
    assert_true(seen.roots > 10000);
}

/* |v - p(x)| over the bound, exactly. */
static double error_to_bound(const double *c, int n, double x, double v, double bound) {
    mpq_t y, t, k;
    mpq_inits(y, t, k, NULL);
    mpq_set_d(t, x);
    for (int i = n; i >= 0; i--) {
        mpq_mul(y, y, t);
        mpq_set_d(k, c[i]);
        mpq_add(y, y, k);
    }
    mpq_set_d(k, v);
    mpq_sub(y, y, k);
    mpq_set_d(k, bound);
    mpq_div(y, y, k);
    double ratio = fabs(mpq_get_d(y));
    mpq_clears(y, t, k, NULL);
    return ratio;
}

/* The bound of a compensated value, but for the u |p(x)| that changes no sign: where p is almost 0. */
TEST(test_bound) {
    uint64_t random = SEED;
    double worst = 0;
    for (int i = 0; i < 60000; i++) {
        double c[33] = {1}, x = 0.75 + 0.5 * random_unit(&random);
        int n = 1 + i % 32;
        for (int m = 0; m < n; m++) {
            double root = x + ldexp(random_unit(&random), -(i / 32 % 12) - m % 3);
            for (int k = m + 1; k >= 0; k--) c[k] = (k > 0 ? c[k - 1] : 0) - (k <= m ? root * c[k] : 0);
        }
        double size = 0;
        for (int k = n; k >= 0; k--) size = size * fabs(x) + fabs(c[k]);
        lanes value, slope;
        double bound = 8.0 * n * n * 0x1p-106 * size,
               sure = certain_value((terms){c, NULL}, n, all_lanes(x), &value, &slope)[0];
        double ratio = error_to_bound(c, n, x, value[0], bound + 0x1p-53 * fabs(value[0]));
        worst = fmax(worst, ratio);
        assert_true(sure == 0 || (sure == value[0] && fabs(sure) > 0.999 * bound));
        if (ratio > 1) fail_msg("seed %u, degree %d, x %a: %g of the bound", SEED, n, x, ratio);
    }
    if (worst < 0.01) fail_msg("the bound is never felt: %g", worst);
}
