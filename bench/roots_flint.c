/* roots_flint.c - FLINT: real roots of polynomials with integer coefficients, isolated by Vincent's theorem
 * and bisection (since 3.6), or counted. */
#include <flint/fmpq.h>
#include <flint/fmpq_vec.h>
#include <flint/fmpz_poly.h>
#include <flint/fmpz_vec.h>

#include "roots_integers.h"
#include "roots_others.h"

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
