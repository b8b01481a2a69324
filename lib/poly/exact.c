/* exact.c - Horner's rule over expansions: exact, for points where no bound can tell.
 *
 * The point is brought to [1,2) and the coefficients scaled along, by powers of two, the largest to about
 * 2^TOP: products then have some 1750 bits below them before they leave the range in which two_prod is
 * exact, enough for degree 30 with full mantissas. */
#include "exact.h"

#include <math.h>

#define TOP 800

int algsurf_i_poly_exact_sign(const double *c, int degree, double x) {
    algsurf_i_expansion value, point;
    if (x == 0) return (c[0] > 0) - (c[0] < 0);
    int unit = ilogb(x), common = -0x7fffffff;
    for (int k = 0; k <= degree; k++)
        if (c[k] != 0 && ilogb(c[k]) + k * unit > common) common = ilogb(c[k]) + k * unit;
    common -= TOP;
    algsurf_i_expansion_set(&value, 0);
    algsurf_i_expansion_set(&point, ldexp(x, -unit));
    for (int k = degree; k >= 0; k--) {
        double scaled = ldexp(c[k], k * unit - common);
        if (ldexp(scaled, common - k * unit) != c[k]) return ALGSURF_SIGN_UNKNOWN;
        algsurf_i_expansion_multiply(&value, &point);
        algsurf_i_expansion_add_double(&value, scaled);
    }
    return algsurf_i_expansion_sign(&value);
}
