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

/* sum += a b, and a = 0 */
static inline void exact_add(mpz_t *sum, mpz_t *a, int n, mpz_t *b, int m) {
    for (int i = 0; i <= n; i++) {
        for (int j = 0; j <= m && mpz_sgn(a[i]); j++) mpz_addmul(sum[i + j], a[i], b[j]);
        mpz_set_ui(a[i], 0);
    }
}

/* The line of the terms along the ray; n at least the terms' total degrees.  To be cleared. */
static inline exact_line exact_line_of(const algsurf_term *terms, int count, int n, const algsurf_ray *ray) {
    int width = n + 1, unit;
    double six[6];
    mpz_t parts[6], *power[3], *row = exact_polynomials(1, width), *level = exact_polynomials(1, width);
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
    for (const algsurf_term *m = terms; m < terms + count; m++) { /* rows of one y^j z^k, levels of one z^k */
        mpz_t *f = factor + (m - terms);
        int last = m + 1 == terms + count || m[1].k != m->k;
        mpz_mul_2exp(*f, *f, (unsigned long)(unit * (n - m->i - m->j - m->k)));
        for (int e = 0; e <= m->i; e++) mpz_addmul(row[e], *f, power[0][m->i * width + e]);
        if (last || m[1].j != m->j) exact_add(level, row, n - m->j - m->k, power[1] + m->j * width, m->j);
        if (last) exact_add(line.c, level, n - m->k, power[2] + m->k * width, m->k);
    }
    for (int axis = 0; axis < 3; axis++) exact_free(power[axis], width * width);
    for (int i = 0; i < 6; i++) mpz_clear(parts[i]);
    exact_free(row, width), exact_free(level, width), exact_free(factor, count), free(a);
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

/* ---- faces: what an extent or a plane leaves of the line is where a polynomial is not negative ---- */

enum { EXACT_MOST_FACES = 6 + ALGSURF_MAX_CLIP_PLANES };

typedef struct exact_face {
    int degree; /* -1: zero on the whole ray */
    mpz_t c[3];
} exact_face;

/* From rational coefficients. */
static inline void exact_face_of(exact_face *face, mpq_t c[3]) {
    mpz_t common;
    mpz_init_set_ui(common, 1);
    for (int k = 0; k < 3; k++) mpz_lcm(common, common, mpq_denref(c[k]));
    for (int k = 0; k < 3; k++) {
        mpz_init(face->c[k]);
        mpz_divexact(face->c[k], common, mpq_denref(c[k]));
        mpz_mul(face->c[k], face->c[k], mpq_numref(c[k]));
    }
    mpz_clear(common);
    face->degree = exact_degree(face->c, 2);
}

/* offset + t step = X_i - c_i along the ray. */
static inline void exact_offset(mpq_t offset, mpq_t step, const algsurf_extent *e, const algsurf_ray *ray,
                                int i) {
    mpq_t q;
    mpq_init(q);
    exact_set(offset, ray->origin[i]), exact_set(q, e->centre[i]);
    mpq_sub(offset, offset, q);
    exact_set(step, ray->direction[i]);
    mpq_clear(q);
}

/* offset - normal.X along the ray. */
static inline void exact_plane_of(exact_face *face, const algsurf_plane *plane, const algsurf_ray *ray) {
    mpq_t c[3], n, x;
    mpq_inits(c[0], c[1], c[2], n, x, NULL);
    exact_set(c[0], plane->offset);
    for (int i = 0; i < 3; i++) {
        exact_set(n, plane->normal[i]);
        exact_set(x, ray->origin[i]), mpq_mul(x, x, n), mpq_sub(c[0], c[0], x);
        exact_set(x, ray->direction[i]), mpq_mul(x, x, n), mpq_sub(c[1], c[1], x);
    }
    exact_face_of(face, c);
    mpq_clears(c[0], c[1], c[2], n, x, NULL);
}

/* Inside: all faces >= 0. */
static inline int exact_faces_of(exact_face *face, const algsurf_extent *e, const algsurf_ray *ray) {
    mpq_t c[3], a, b, q;
    int count = 0;
    if (!e || e->kind == ALGSURF_EXTENT_ALL) return 0;
    mpq_inits(c[0], c[1], c[2], a, b, q, NULL);
    if (e->kind == ALGSURF_EXTENT_SPHERE) {
        exact_set(q, e->size[0]);
        mpq_mul(c[0], q, q);
        for (int i = 0; i < 3; i++) {
            exact_offset(a, b, e, ray, i);
            mpq_mul(q, a, a), mpq_sub(c[0], c[0], q);
            mpq_mul(q, a, b), mpq_mul_2exp(q, q, 1), mpq_sub(c[1], c[1], q);
            mpq_mul(q, b, b), mpq_sub(c[2], c[2], q);
        }
        exact_face_of(face + count++, c);
    } else {
        for (int i = 0; i < 6; i++) {
            exact_offset(a, b, e, ray, i / 2);
            if (i % 2) mpq_neg(a, a), mpq_neg(b, b);
            exact_set(q, e->size[i / 2]);
            mpq_add(c[0], q, a), mpq_set(c[1], b), mpq_set_ui(c[2], 0, 1);
            exact_face_of(face + count++, c);
        }
    }
    mpq_clears(c[0], c[1], c[2], a, b, q, NULL);
    return count;
}

#endif
