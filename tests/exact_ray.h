/* exact_ray.h - the oracle for rays: the polynomial P(o + t d), from its definition, over integers.
 *
 * Doubles are integers times powers of two; with one power for the ray and one for the surface,
 *     P(o + t d) = 2^-shift sum c[k] t^k,  c[k] integers,
 * and nothing is rounded.
 */
#ifndef EXACT_RAY_H
#define EXACT_RAY_H
#include "algsurf/ray.h"
#include "algsurf/surface.h"
#include "exact_roots.h"

typedef struct exact_line {
    int degree; /* of the surface: c[0..degree] */
    long shift;
    mpz_t *c;
} exact_line;

/* product = a b for polynomials of the given degrees; product has room and is none of them. */
static inline void exact_multiply(mpz_t *product, mpz_t *a, int n, mpz_t *b, int m) {
    for (int k = 0; k <= n + m; k++) mpz_set_ui(product[k], 0);
    for (int i = 0; i <= n; i++)
        for (int j = 0; j <= m; j++) mpz_addmul(product[i + j], a[i], b[j]);
}

/* The line of the terms along the ray; n at least the terms' total degrees.  To be cleared. */
static inline exact_line exact_line_of(const algsurf_term *terms, int count, int n, const algsurf_ray *ray) {
    int width = n + 1, unit;
    double six[6];
    mpz_t parts[6], *power[3], *xy = exact_polynomials(1, width), *xyz = exact_polynomials(1, width);
    exact_line line = {n, 0, exact_polynomials(1, width)};
    for (int i = 0; i < 3; i++) six[2 * i] = ray->origin[i], six[2 * i + 1] = ray->direction[i];
    for (int i = 0; i < 6; i++) mpz_init(parts[i]);
    unit = exact_integers(parts, six, 5);
    for (int axis = 0; axis < 3; axis++) { /* power[axis] + e width: (o + t d)^e, degree e */
        power[axis] = exact_polynomials(width, width);
        mpz_set_ui(power[axis][0], 1);
        for (int e = 1; e <= n; e++)
            exact_multiply(power[axis] + e * width, power[axis] + (e - 1) * width, e - 1, parts + 2 * axis,
                           1);
    }
    double *a = calloc((size_t)count, sizeof *a);
    mpz_t *factor = exact_polynomials(1, count);
    for (int i = 0; i < count; i++) a[i] = terms[i].a;
    line.shift = exact_integers(factor, a, count - 1) + (long)unit * n;
    for (int i = 0; i < count; i++) {
        const algsurf_term *m = terms + i;
        int degree = m->i + m->j + m->k;
        exact_multiply(xy, power[0] + m->i * width, m->i, power[1] + m->j * width, m->j);
        exact_multiply(xyz, xy, m->i + m->j, power[2] + m->k * width, m->k);
        mpz_mul_2exp(factor[i], factor[i], (unsigned long)(unit * (n - degree)));
        for (int k = 0; k <= degree; k++) mpz_addmul(line.c[k], factor[i], xyz[k]);
    }
    for (int axis = 0; axis < 3; axis++) exact_free(power[axis], width * width);
    for (int i = 0; i < 6; i++) mpz_clear(parts[i]);
    exact_free(xy, width), exact_free(xyz, width), exact_free(factor, count), free(a);
    return line;
}

static inline void exact_line_clear(exact_line *line) { exact_free(line->c, line->degree + 1); }

/* Coefficient k as a number. */
static inline void exact_line_coefficient(mpq_t q, const exact_line *line, int k) {
    mpq_set_z(q, line->c[k]);
    mpq_div_2exp(q, q, (mp_bitcnt_t)line->shift);
}

/* sum |coefficients| of everything that is added up to coefficient k of P(o + t d): the same with
 * magnitudes. */
static inline exact_line exact_magnitudes_of(const algsurf_term *terms, int count, int n,
                                             const algsurf_ray *ray) {
    algsurf_term *size = malloc((size_t)count * sizeof *size);
    algsurf_ray positive = *ray;
    for (int i = 0; i < count; i++) size[i] = terms[i], size[i].a = fabs(terms[i].a);
    for (int i = 0; i < 3; i++) {
        positive.origin[i] = fabs(ray->origin[i]);
        positive.direction[i] = fabs(ray->direction[i]);
    }
    exact_line line = exact_line_of(size, count, n, &positive);
    free(size);
    return line;
}

static inline exact_sturm exact_sturm_along(const algsurf_term *terms, int count, int n,
                                            const algsurf_ray *ray) {
    exact_line line = exact_line_of(terms, count, n, ray);
    exact_sturm s = exact_sturm_of(line.c, n);
    exact_line_clear(&line);
    return s;
}

#endif
