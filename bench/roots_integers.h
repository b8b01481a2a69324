/* roots_integers.h - doubles as polynomials with integer coefficients, for FLINT and Arb. */
#ifndef ROOTS_INTEGERS_H
#define ROOTS_INTEGERS_H
#include <math.h>

#include <flint/fmpz_poly.h>

enum { BITS = 53 };

/* A multiple by a power of two, made primitive. */
static inline void set_integers(fmpz_poly_t p, const double *c, int degree) {
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

#endif
