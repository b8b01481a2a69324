/* test_root_bounds.c - Fujiwara's bound of roots, which roots come as near to as they can.
 *
 * Break tried: a bound of roots half as large. */
#include "exact.h"

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
            const int least = algsurf_zpoly_least_bit(c, 1, n, 0);
            assert_true(algsurf_zpoly_from_doubles(&memory, c, 1, n, 0, least, &p));
            assert_true(algsurf_exact_pieces_begin(&s, &memory, &p, 0, -HUGE_VAL, HUGE_VAL));
            assert_int_equal(reverse ? s.least : s.most, reverse ? -2 : 2);
            assert_int_equal(sign_at(c, n, reverse ? -2 : 2), 1);
            assert_int_equal(sign_at(c, n, reverse ? -1 : 1), -1);
            algsurf_memory_release(&memory, (algsurf_memory_mark){block, block + 4096, NULL});
        }
}
