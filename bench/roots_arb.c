/* roots_arb.c - Arb, now part of FLINT: balls in arbitrary precision.
 *
 * Real roots go by the polynomial with integer coefficients that is an exact multiple of the one
 * given, squarefree factors first: whether a root is real is then proved, and roots may be multiple.  All
 * roots go by acb_poly_find_roots, in a precision doubled until each is isolated and known to 53 bits; of
 * real integers, by arb_fmpz_poly_complex_roots.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <flint/fmpz_poly.h>
#include <flint/fmpz_poly_factor.h>
#if __has_include(<flint/acb_poly.h>)
#include <flint/acb_poly.h>
#include <flint/arb_fmpz_poly.h>
#else
#include <acb_poly.h>
#include <arb_fmpz_poly.h>
#endif

#include "algsurf/status.h"
#include "roots_integers.h"
#include "roots_others.h"

enum { FIRST_PRECISION = 64, LAST_PRECISION = 4096 };

static other_root root_of_ball(const acb_struct *ball) {
    mag_t radius;
    other_root root = {arf_get_d(arb_midref(acb_realref(ball)), ARF_RND_NEAR),
                       arf_get_d(arb_midref(acb_imagref(ball)), ARF_RND_NEAR), 0};
    mag_init(radius);
    mag_hypot(radius, arb_radref(acb_realref(ball)), arb_radref(acb_imagref(ball)));
    root.radius = mag_get_d(radius);
    mag_clear(radius);
    return root;
}

static int roots_of_factor(const fmpz_poly_struct *factor, other_root *roots) {
    slong degree = fmpz_poly_degree(factor);
    if (degree < 1) return 0;
    acb_ptr balls = _acb_vec_init(degree);
    arb_fmpz_poly_complex_roots(balls, factor, 0, BITS);
    for (slong i = 0; i < degree; i++) roots[i] = root_of_ball(balls + i);
    _acb_vec_clear(balls, degree);
    return (int)degree;
}

int by_arb_interval(const double *c, int degree, double *real) {
    other_root roots[ALGSURF_MAX_DEGREE];
    fmpz_poly_t integral;
    fmpz_poly_factor_t factors;
    int count = 0;
    fmpz_poly_init(integral);
    fmpz_poly_factor_init(factors);
    set_integers(integral, c, degree);
    fmpz_poly_factor_squarefree(factors, integral);
    for (slong i = 0; i < factors->num; i++) count += roots_of_factor(factors->p + i, roots + count);
    fmpz_poly_factor_clear(factors);
    fmpz_poly_clear(integral);
    return others_in_interval(roots, count, real);
}

static int known(acb_srcptr balls, slong count) {
    for (slong i = 0; i < count; i++)
        if (acb_rel_accuracy_bits(balls + i) < BITS && !acb_is_zero(balls + i)) return 0;
    return 1;
}

/* To 53 bits each. */
static int find_roots(const acb_poly_t exact, slong most_bits, int degree, other_root *roots) {
    acb_poly_t p;
    acb_ptr balls = _acb_vec_init(degree);
    slong isolated = 0;
    acb_poly_init(p);
    for (slong precision = FIRST_PRECISION; precision <= most_bits; precision *= 2) {
        acb_poly_set_round(p, exact, precision);
        isolated = acb_poly_find_roots(balls, p, precision > FIRST_PRECISION ? balls : NULL, 0, precision);
        if (isolated == degree && known(balls, degree)) break;
    }
    for (slong i = 0; i < isolated; i++) roots[i] = root_of_ball(balls + i);
    _acb_vec_clear(balls, degree);
    acb_poly_clear(p);
    return (int)isolated;
}

int by_arb_all(const double *re, const double *im, int degree, other_root *roots) {
    acb_poly_t p;
    acb_poly_init2(p, degree + 1);
    for (int k = 0; k <= degree; k++) acb_set_d_d(p->coeffs + k, re[k], im ? im[k] : 0);
    _acb_poly_set_length(p, degree + 1);
    int count = find_roots(p, LAST_PRECISION, degree, roots);
    acb_poly_clear(p);
    return count;
}

static void set_part(fmpz_poly_t p, const algsurf_integer *z, int degree) {
    fmpz_t c;
    fmpz_init(c);
    for (int k = degree; k >= 0; k--) {
        fmpz_set_ui_array(c, (const ulong *)z[k].limbs, abs(z[k].length));
        if (z[k].length < 0) fmpz_neg(c, c);
        if (z[k].length) fmpz_poly_set_coeff_fmpz(p, k, c);
    }
    fmpz_clear(c);
}

/* Squarefree factors, which only polynomials over the integers have here. */
int by_arb_integers(const algsurf_integer *re, const algsurf_integer *im, int degree, other_root *roots) {
    fmpz_poly_t real, imaginary;
    fmpz_poly_factor_t factors;
    acb_poly_t p;
    int count = 0;
    fmpz_poly_init(real), fmpz_poly_init(imaginary), fmpz_poly_factor_init(factors), acb_poly_init(p);
    set_part(real, re, degree);
    if (im) {
        set_part(imaginary, im, degree);
        acb_poly_set2_fmpz_poly(p, real, imaginary, 2 * LAST_PRECISION);
        count = find_roots(p, LAST_PRECISION, degree, roots);
    } else {
        fmpz_poly_factor_squarefree(factors, real);
        for (slong i = 0; i < factors->num; i++) {
            int some = roots_of_factor(factors->p + i, roots + count);
            for (slong times = 1; times < factors->exp[i]; times++)
                memcpy(roots + count + some * times, roots + count, (size_t)some * sizeof *roots);
            count += some * (int)factors->exp[i];
        }
    }
    fmpz_poly_clear(real), fmpz_poly_clear(imaginary), fmpz_poly_factor_clear(factors), acb_poly_clear(p);
    return count;
}
