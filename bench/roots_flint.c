/* roots_flint.c - FLINT: real roots of polynomials with integer coefficients, isolated by Vincent's theorem
 * and bisection (since 3.6), or counted. */
#include <math.h>

#include <flint/fmpq.h>
#include <flint/fmpq_vec.h>
#include <flint/fmpz_poly.h>
#include <flint/fmpz_vec.h>

#include "roots_others.h"

enum { BITS = 53 };

/* A multiple by a power of two, made primitive. */
static void set_integers(fmpz_poly_t p, const double *c, int degree) {
    int exponent, least = 1 << 20;
    fmpz_t m;
    for (int k = 0; k <= degree; k++)
        if (c[k] != 0) {
            (void)frexp(c[k], &exponent);
            if (exponent - BITS < least) least = exponent - BITS;
        }
    fmpz_init(m);
    for (int k = degree; k >= 0; k--)
        if (c[k] != 0) {
            fmpz_set_si(m, (slong)ldexp(frexp(c[k], &exponent), BITS));
            fmpz_mul_2exp(m, m, (ulong)(exponent - BITS - least));
            fmpz_poly_set_coeff_fmpz(p, k, m);
        }
    fmpz_clear(m);
    fmpz_poly_primitive_part(p, p);
}

#ifdef WITH_FLINT_ISOLATION
int by_flint_isolated(const double *c, int degree) {
    slong exact, intervals;
    fmpz_poly_t p;
    fmpz_poly_init(p);
    set_integers(p, c, degree);
    fmpq *root = _fmpq_vec_init(degree);
    fmpz *at = _fmpz_vec_init(degree);
    slong *scale = flint_malloc((size_t)degree * sizeof *scale);
    fmpz_poly_isolate_real_roots(root, &exact, at, scale, &intervals, p);
    _fmpq_vec_clear(root, degree);
    _fmpz_vec_clear(at, degree);
    flint_free(scale);
    fmpz_poly_clear(p);
    return (int)(exact + intervals);
}
#endif

int by_flint_counted(const double *c, int degree) {
    fmpz_poly_t p;
    fmpz_poly_init(p);
    set_integers(p, c, degree);
    slong count = fmpz_poly_num_real_roots(p);
    fmpz_poly_clear(p);
    return (int)count;
}
