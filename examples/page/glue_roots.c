/* glue_roots.c - all complex roots of the polynomial along a ray, each in a box that is proved to hold it.
 *
 * Where the polynomial is real it is expanded about the middle of the chord, and not about the eye: the roots
 * that are seen are then near 0, where rounded coefficients change them least.  The boxes cover what is
 * rounded on the way.
 */
#include <float.h>
#include <math.h>
#include <stdlib.h>

#include "glue.h"

/* The surface with the magnitudes of the coefficients; it is to be freed. */
static algsurf_status magnitudes_of(const algsurf_surface *surface, algsurf_surface **magnitudes) {
    const size_t count = algsurf_surface_term_count(surface);
    algsurf_term *terms = malloc((count + 1) * sizeof *terms);
    if (!terms) return ALGSURF_E_NO_MEMORY;
    algsurf_status status = algsurf_surface_terms(surface, terms);
    for (size_t i = 0; i < count; i++) terms[i].a = fabs(terms[i].a);
    keep(&status, algsurf_surface_from_terms(terms, count, magnitudes));
    free(terms);
    return status;
}

/* Adds to the radii what a relative error of 2^-52 in each component of the origin changes: each term of the
 * coefficient of s^k is a product of at most degree - k of these. */
static algsurf_status add_rounding(const algsurf_surface *surface, const algsurf_ray *ray, double *r) {
    const int degree = algsurf_surface_degree(surface);
    double m[ALGSURF_MAX_DEGREE + 1], radii[ALGSURF_MAX_DEGREE + 1];
    algsurf_surface *magnitudes = NULL;
    algsurf_ray positive = *ray;
    for (int i = 0; i < 3; i++) {
        positive.origin[i] = fabs(ray->origin[i]);
        positive.direction[i] = fabs(ray->direction[i]);
    }
    algsurf_status status = magnitudes_of(surface, &magnitudes);
    keep(&status, status == ALGSURF_OK ? algsurf_expand_power(magnitudes, &positive, m, radii) : status);
    algsurf_surface_free(magnitudes);
    if (status != ALGSURF_OK) return status;
    for (int k = 0; k < degree; k++)
        if (m[k] + radii[k] > 0) r[k] += 1.01 * (degree - k) * DBL_EPSILON * (m[k] + radii[k]) + DBL_MIN;
    return ALGSURF_OK;
}

/* Is a b + c, rounded, what fma gives without an error? */
static int exact_sum(double a, double b, double c) {
    const double product = a * b, sum = product + c, part = sum - product;
    return fma(a, b, -product) == 0 && (product - (sum - part)) + (c - part) == 0;
}

/* t = middle + half s: about the middle of the chord, or about the eye for a ray without a bounded chord.
 * half is a power of two. */
typedef struct parameter {
    double middle, half;
} parameter;
static const parameter THE_SAME = {0, 1};

static parameter about_middle(const algsurf_ray *chord) {
    const double length = 0.5 * (chord->t_max - chord->t_min);
    int exponent = 0;
    if (!isfinite(length) || !(length > 0)) return THE_SAME;
    (void)frexp(length, &exponent);
    return (parameter){chord->t_min + length, ldexp(1, exponent)};
}

/* The ray's polynomial in s.  The radii cover that the origin is rounded.  Returns E_RANGE where that cannot
 * be done. */
static algsurf_status in_parameter(const algsurf_surface *surface, const algsurf_ray *chord, parameter s,
                                   double *c, double *r) {
    static const double TINY = 1e-290; /* roundings above it are relative */
    algsurf_ray ray = *chord;
    int exact = 1;
    for (int i = 0; i < 3; i++) {
        ray.origin[i] = fma(s.middle, chord->direction[i], chord->origin[i]);
        ray.direction[i] = s.half * chord->direction[i];
        if (ray.direction[i] / s.half != chord->direction[i]) return ALGSURF_E_RANGE;
        if (exact_sum(s.middle, chord->direction[i], chord->origin[i])) continue;
        if (fabs(ray.origin[i]) < TINY) return ALGSURF_E_RANGE;
        exact = 0;
    }
    algsurf_status status = algsurf_expand_power(surface, &ray, c, r);
    return status != ALGSURF_OK || exact ? status : add_rounding(surface, &ray, r);
}

/* All roots s of the polynomial along the ray. */
static algsurf_status real_roots_in(const algsurf_surface *surface, const algsurf_ray *chord, parameter s,
                                    algsurf_complex_root *root, int *count) {
    double c[ALGSURF_MAX_DEGREE + 1], r[ALGSURF_MAX_DEGREE + 1];
    const algsurf_status status = in_parameter(surface, chord, s, c, r);
    if (status != ALGSURF_OK) return status;
    return algsurf_complex_roots_of_real(c, r, algsurf_surface_degree(surface), root, count);
}

/* The same of the polynomial in t with the state's imaginary parts. */
static algsurf_status complex_roots_in(const algsurf_surface *surface, const algsurf_ray *chord,
                                       const page_state *state, algsurf_complex_root *root, int *count) {
    algsurf_complex c[ALGSURF_MAX_DEGREE + 1];
    double p[ALGSURF_MAX_DEGREE + 1], radii[ALGSURF_MAX_DEGREE + 1];
    const int degree = algsurf_surface_degree(surface);
    const algsurf_status status = algsurf_expand_power(surface, chord, p, radii);
    if (status != ALGSURF_OK) return status;
    for (int k = 0; k <= degree; k++) c[k] = (algsurf_complex){p[k], state->imaginary[k]};
    return algsurf_complex_roots(c, radii, degree, root, count);
}

/* middle + half s, rounded in the direction of `to`. */
static double outwards(double middle, double half, double s, double to) {
    return s == 0 ? middle : nextafter(middle + nextafter(half * s, to), to);
}

/* All roots t of the polynomial along the ray, with the state's imaginary parts.  The boxes hold the roots of
 * the exact polynomial along the ray of these doubles.
 *   rows  eight numbers each: root (re, im), box (re lo, re hi, im lo, im hi), multiplicity, real;
 *         room for 64
 * Returns how many. */
EXPORTED(page_complex_roots)
int page_complex_roots(const algsurf_surface *surface, const page_state *state, const algsurf_ray *chord,
                       double *rows) {
    algsurf_complex_root root[ALGSURF_MAX_DEGREE];
    parameter s = THE_SAME;
    int degree = algsurf_surface_degree(surface), count = 0, real = 1;
    algsurf_status status;
    for (int k = 0; k <= degree; k++) real = real && (state->complex_given == 0 || state->imaginary[k] == 0);
    if (real) {
        s = about_middle(chord);
        status = real_roots_in(surface, chord, s, root, &count);
        if (status == ALGSURF_E_RANGE) { /* about the eye nothing is rounded */
            s = THE_SAME;
            status = real_roots_in(surface, chord, s, root, &count);
        }
    } else {
        status = complex_roots_in(surface, chord, state, root, &count);
    }
    for (int i = 0; i < count; i++, rows += 8) {
        const algsurf_complex_root *z = &root[i];
        rows[0] = s.middle + s.half * z->root.re;
        rows[1] = s.half * z->root.im;
        rows[2] = outwards(s.middle, s.half, z->box.re.lo, -INFINITY);
        rows[3] = outwards(s.middle, s.half, z->box.re.hi, INFINITY);
        rows[4] = outwards(0, s.half, z->box.im.lo, -INFINITY);
        rows[5] = outwards(0, s.half, z->box.im.hi, INFINITY);
        rows[6] = z->multiplicity;
        rows[7] = z->real;
    }
    return status < 0 ? (int)status : count;
}
