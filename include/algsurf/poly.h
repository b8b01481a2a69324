/* algsurf/poly.h - a real polynomial in one variable, with an error radius per coefficient.
 *
 * A polynomial of degree at most n is n+1 doubles, lowest degree first:
 *     p(t) = c[0] + c[1] t + ... + c[n] t^n                               power basis
 *     p(t) = sum b[j] C(n,j) (1-s)^(n-j) s^j,  s = (t-lo)/(hi-lo)         Bernstein basis on [lo,hi]
 * An optional array of radii r >= 0 turns it into a set: that of all polynomials whose i-th coefficient lies
 * in [c[i]-r[i], c[i]+r[i]] for each i.  Every guarantee then holds for each of them.  If the pointer to the
 * radii is null, the coefficients are exact.  Leading zeros are allowed: n bounds the degree.
 */
#ifndef ALGSURF_POLY_H
#define ALGSURF_POLY_H
#include <stddef.h>
#include <stdint.h>

#include "algsurf/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/* An integer of any length, not owned.  Its sign is that of its length, as in GMP: an mpz_t z with limbs of
 * 64 bits is {mpz_limbs_read(z), mpz_sgn(z) * (int)mpz_size(z)}. */
typedef struct algsurf_integer {
    const uint64_t *limbs; /* the magnitude, least significant limb first; the last ones may be 0 */
    int length; /* how many, negated for a negative integer; 0: the integer 0, `limbs` may be null */
} algsurf_integer;

/* Largest number of limbs of a coefficient: 2^20 bits, 315,000 decimals. */
#define ALGSURF_MAX_LIMBS 16384

/* The value at a point, computed in double, with a bound on its error.
 *   c, r    degree+1 coefficients (power basis) and radii, or r null
 *   value   p(t), by Horner's rule; not finite on overflow, which is OK, not an error
 *   bound   encloses: |value - q(t)| <= bound for every q in the set; +inf on overflow.  Null: not asked for
 * Errors: E_ARGUMENT (null, negative degree or radius), E_DEGREE (above ALGSURF_MAX_POLY_DEGREE),
 * E_NOT_FINITE.  Cost: O(degree).  Source: running error bound, Higham, Accuracy and Stability of
 * Numerical Algorithms, 2002, 5.1.  Since 1.0. */
ALGSURF_API algsurf_status algsurf_poly_value(const double *c, const double *r, int degree, double t,
                                             double *value, double *bound);

/* The same with a value computed as if in doubled precision: bound is about one unit in the last place of
 * value, plus sum r_i |t|^i, plus at most about n^2 2^-103 sum |c_i t^i|, n the degree, plus 2^-1069 sum
 * |t|^i times the largest coefficient or radius, for what underflows beside it (coefficients, t or partial
 * sums beyond 2^900 may get the bound of algsurf_poly_value instead).
 * Cost: O(degree), three to four times that of algsurf_poly_value.  Source: compensated Horner scheme,
 * Graillat, Langlois, Louvet 2005.  Errors: as above.  Since 1.0. */
ALGSURF_API algsurf_status algsurf_poly_value_compensated(const double *c, const double *r, int degree,
                                                         double t, double *value, double *bound);

/* Power basis to Bernstein basis on [lo,hi].
 *   b, br   degree+1 Bernstein coefficients and their radii, or br null; may not overlap c, r.
 *           Encloses: every member of the input set has its coefficients in b[j] +- br[j].
 * Errors: as above; E_ARGUMENT also for lo >= hi, E_NOT_FINITE for infinite lo, hi, E_RANGE (overflow).
 * Cost: O(degree^2).  Source: blossoming (Ramshaw 1989), as a Horner scheme in normalised
 * Bernstein form: no binomials, error at most O(degree) u sum |c_i| max(|lo|,|hi|)^i.
 * 10 KiB of stack.  Since 1.0. */
ALGSURF_API algsurf_status algsurf_poly_to_bernstein(const double *c, const double *r, int degree, double lo,
                                                     double hi, double *b, double *br);

/* Where the coefficients of many polynomials, or other numbers for each power of each polynomial, are in the
 * caller's memory: that of power k of polynomial i is at[k * power + i * polynomial].  With n = degree + 1,
 * and m polynomials:
 *     a polynomial a row, double c[m][n]          {&c[0][0], 1, n}
 *     a polynomial a column, double c[n][m]       {&c[0][0], m, 1}
 *     algsurf_complex z[m][n], real parts         {&z[0][0].re, 2, 2 * n}
 *                              imaginary parts    {&z[0][0].im, 2, 2 * n}
 * Steps may be negative, or 0: then all have the same number. */
typedef struct algsurf_table {
    const double *at;            /* null, where that is allowed: there are none */
    ptrdiff_t power, polynomial; /* steps from one to the next, in doubles */
} algsurf_table;

#ifdef __cplusplus
}
#endif
#endif
