/* test_root_bounds.c - bounds of roots at their borders: Fujiwara's, which roots come as near to as they can,
 * and inclusion discs where squares of distances, or radii, are subnormal on the way.
 *
 * Breaks tried, each caught by the tests named:
 *   a bound of roots half as large         reached
 *   squares of differences as they are     close
 *   radii without exponents on the way     small
 */
#include "exact.h"

#include "complex/impl.h"
#include "roots/exact_walk.h"
#include "unit.h"

/* The sign of c[0] + .. + c[n] t^n at 2^e. */
static int sign_at(const double *c, int n, int e) { return exact_poly_sign(c, n, ldexp(1, e)); }

/* t^n - 2 t^(n-1) - 4 t^(n-2) .. - 2^n, whose bits give the bound 4: its root is 4 (1 - 2^-n) or so; and the
 * same in reverse. */
TEST(reached) {
    algsurf_limb block[4096];
    for (int n = 2; n <= 60; n++)
        for (int reverse = 0; reverse < 2; reverse++) {
            double c[61];
            algsurf_memory memory;
            algsurf_zpoly p;
            algsurf_exact_pieces s;
            algsurf_memory_begin(&memory, block, 4096, 0);
            for (int k = 0; k <= n; k++) c[reverse ? n - k : k] = k < n ? -ldexp(1, n - k) : 1;
            assert_true(algsurf_exact_from_doubles(&memory, c, n, 0, &p));
            assert_true(algsurf_exact_pieces_begin(&s, &memory, &p, 0, -HUGE_VAL, HUGE_VAL));
            assert_int_equal(reverse ? s.least : s.most, reverse ? -2 : 2);
            assert_int_equal(sign_at(c, n, reverse ? -2 : 2), 1);
            assert_int_equal(sign_at(c, n, reverse ? -1 : 1), -1);
            algsurf_memory_release(&memory, (algsurf_memory_mark){block, block + 4096, NULL});
        }
}

/* Two approximations at distance d of a polynomial of degree 2 with leading coefficient 1. */
static void check_discs(double d, double residual, int exponent) {
    double size[3] = {1, 1, 1}, radius[3] = {0}, x[2] = {1, 1}, y[2] = {0}, xl[2] = {0, d}, yl[2] = {0};
    double residuals[2] = {residual, residual}, disc[2];
    int exponents[2] = {exponent, exponent}, group[2], done[2], shift[3] = {0};
    algsurf_i_roots p = {.n = 2,
                         .real = 1,
                         .narrow = 1,
                         .size = size,
                         .radius = radius,
                         .x = x,
                         .y = y,
                         .xl = xl,
                         .yl = yl,
                         .residual = residuals,
                         .disc = disc,
                         .exponent = exponents,
                         .group = group,
                         .done = done,
                         .shift = shift};
    mpq_t least, distance;
    mpq_inits(least, distance, NULL);
    (void)algsurf_i_roots_group(&p);
    exact_set(least, 2 * residual), exact_set(distance, d), mpq_div(least, least, distance);
    if (exponent > 0)
        mpq_mul_2exp(least, least, (mp_bitcnt_t)exponent);
    else
        mpq_div_2exp(least, least, (mp_bitcnt_t)-exponent);
    for (int i = 0; i < 2; i++)
        if (!exact_between(-HUGE_VAL, least, disc[i]))
            fail_msg("distance %a, residual %a 2^%d: %a is too small", d, residual, exponent, disc[i]);
    mpq_clears(least, distance, NULL);
}

TEST(close) {
    uint64_t random = 20251126;
    for (int e = -300; e >= -700; e -= 5)
        for (int k = 0; k < 8; k++)
            check_discs(ldexp(1.5 + 0.5 * exact_random_unit(&random), e), 0x1p-900, 0);
}

TEST(small) {
    uint64_t random = 20251127;
    for (int e = -960; e >= -1073; e -= 3)
        for (int k = 0; k < 8; k++)
            check_discs(ldexp(1.5 + 0.5 * exact_random_unit(&random), 40),
                        ldexp(1.5 + 0.5 * exact_random_unit(&random), e), k % 2 ? 700 : -20);
}

int main(void) { return unit_run("root bounds"); }
