/* exact_hits.h - the oracle for hits: the roots of P along a ray inside an extent, over the rationals.
 *
 * Roots of the squarefree part are isolated by bisection with a Sturm chain (exact_roots.h), the
 * multiplicity of a root is the number of polynomials g_0 = p, g_(i+1) = gcd(g_i, g_i') that have it, and a
 * root is inside the extent if no face, a polynomial of degree at most 2, is negative there: it is zero if
 * the two share the root, else the bracket is bisected until the face has no root in it.
 */
#ifndef EXACT_HITS_H
#define EXACT_HITS_H
#include <float.h>
#include <string.h>

#include "exact_ray.h"

enum { EXACT_MOST_HITS = ALGSURF_MAX_DEGREE };

/* A root: lo itself if lo = hi, else the only root in (lo,hi), neither of which is a root. */
typedef struct exact_place {
    mpq_t lo, hi;
    int multiplicity; /* 0: the ray lies in the surface */
    int side;         /* the sign of P just before */
} exact_place;

typedef struct exact_hits {
    int in_surface, count;
    exact_sturm roots; /* of the polynomial whose roots the places are; count 0: none is needed */
    exact_place place[EXACT_MOST_HITS];
    int infinite; /* the ray lies in the surface and has no begin: one hit at -infinity */
    int end_sign; /* of P where the ray's part inside ends, or EXACT_NOT_KNOWN */
    int is_short; /* that part is so short that it may be said to be none */
} exact_hits;

enum { EXACT_NOT_KNOWN = 2 };

/* The sign of sum p[k] x^k. */
static inline int exact_sign_q(mpz_t *p, int n, const mpq_t x) {
    mpz_t value, power;
    mpz_init(value), mpz_init_set_ui(power, 1);
    for (int k = n; k >= 0; k--) {
        mpz_mul(value, value, mpq_numref(x));
        mpz_addmul(value, p[k], power);
        mpz_mul(power, power, mpq_denref(x));
    }
    int sign = mpz_sgn(value);
    mpz_clears(value, power, NULL);
    return sign;
}

static inline mpz_t *exact_chain_at(const exact_sturm *s, int i) {
    return s->c + (size_t)i * ((size_t)s->top + 1);
}

static inline int exact_variations_q(const exact_sturm *s, const mpq_t x) {
    int variations = 0, last = 0;
    for (int i = 0; i < s->count; i++) {
        int sign = exact_sign_q(exact_chain_at(s, i), s->degree[i], x);
        variations += sign * last < 0;
        if (sign != 0) last = sign;
    }
    return variations;
}

/* The number of roots in (lo,hi]. */
static inline int exact_between_q(const exact_sturm *s, const mpq_t lo, const mpq_t hi) {
    return exact_variations_q(s, lo) - exact_variations_q(s, hi);
}

/* Doubles in their order as integers. */
static inline int64_t exact_rank(double x) {
    int64_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits < 0 ? INT64_MIN - bits : bits;
}

static inline double exact_of_rank(int64_t rank) {
    int64_t bits = rank < 0 ? INT64_MIN - rank : rank;
    double x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

/* Between lo and hi: in the middle of the doubles between them, if there are some, else of the interval. */
static inline void exact_middle(mpq_t middle, const mpq_t lo, const mpq_t hi) {
    mpq_t most;
    mpq_init(most);
    exact_set(most, DBL_MAX);
    int above = mpq_cmp(hi, most) > 0;
    mpq_neg(most, most);
    int below = mpq_cmp(lo, most) < 0;
    mpq_clear(most);
    if (!above || !below) {
        int64_t a = exact_rank(below ? -DBL_MAX : mpq_get_d(lo)),
                b = exact_rank(above ? DBL_MAX : mpq_get_d(hi));
        exact_set(middle, exact_of_rank(a / 2 + b / 2));
    } else {
        mpq_set_ui(middle, 0, 1);
    }
    if (mpq_cmp(lo, middle) < 0 && mpq_cmp(middle, hi) < 0) return;
    mpq_add(middle, lo, hi);
    mpq_div_2exp(middle, middle, 1);
}

/* Halves the bracket of a root of s's first polynomial. */
static inline void exact_narrow(const exact_sturm *s, exact_place *place) {
    mpq_t middle;
    if (mpq_equal(place->lo, place->hi)) return;
    mpq_init(middle);
    exact_middle(middle, place->lo, place->hi);
    int at = exact_sign_q(s->c, s->degree[0], middle);
    if (at == 0)
        mpq_set(place->lo, middle), mpq_set(place->hi, middle);
    else if (at == exact_sign_q(s->c, s->degree[0], place->hi))
        mpq_set(place->hi, middle);
    else
        mpq_set(place->lo, middle);
    mpq_clear(middle);
}

/* Appends the roots in (lo,hi], of which there are `count`. */
static inline void exact_isolate(const exact_sturm *s, const mpq_t lo, const mpq_t hi, int count,
                                 exact_hits *h) {
    if (count == 0) return;
    int at_hi = exact_sign_q(s->c, s->degree[0], hi) == 0;
    if (count == 1 && (at_hi || exact_sign_q(s->c, s->degree[0], lo) != 0)) {
        exact_place *place = h->place + h->count++;
        mpq_inits(place->lo, place->hi, NULL);
        mpq_set(place->lo, at_hi ? hi : lo), mpq_set(place->hi, hi);
        return;
    }
    mpq_t middle;
    mpq_init(middle);
    exact_middle(middle, lo, hi);
    int left = exact_between_q(s, lo, middle);
    exact_isolate(s, lo, middle, left, h), exact_isolate(s, middle, hi, count - left, h);
    mpq_clear(middle);
}

/* A power of two above all roots. */
static inline void exact_root_bound(mpq_t bound, const exact_sturm *s) {
    size_t most = 0, top = mpz_sizeinbase(s->c[s->degree[0]], 2);
    for (int k = 0; k <= s->degree[0]; k++) {
        size_t bits = mpz_sizeinbase(s->c[k], 2);
        most = bits > most ? bits : most;
    }
    mpq_set_ui(bound, 1, 1);
    mpq_mul_2exp(bound, bound, most + 2 > top ? most + 2 - top : 1);
}

/* The roots in [t_min,t_max], in order, without multiplicities. */
static inline void exact_all_roots(const exact_sturm *s, double t_min, double t_max, exact_hits *h) {
    mpq_t lo, hi;
    if (s->count == 0 || s->degree[0] < 1 || t_min > t_max || t_min == (double)INFINITY ||
        t_max == (double)-INFINITY)
        return;
    mpq_inits(lo, hi, NULL);
    exact_root_bound(hi, s);
    mpq_neg(lo, hi);
    if (isfinite(t_min)) exact_set(lo, t_min);
    if (isfinite(t_max)) exact_set(hi, t_max);
    if (isfinite(t_min) && exact_is_root(s, t_min)) {
        exact_place *place = h->place + h->count++;
        mpq_inits(place->lo, place->hi, NULL);
        mpq_set(place->lo, lo), mpq_set(place->hi, lo);
    }
    if (mpq_cmp(lo, hi) < 0) exact_isolate(s, lo, hi, exact_between_q(s, lo, hi), h);
    mpq_clears(lo, hi, NULL);
}

/* The sign of p just after a place. */
static inline int exact_sign_after(mpz_t *p, int n, const exact_place *place) {
    int sign = exact_sign_q(p, n, place->hi);
    mpz_t *q = exact_polynomials(1, n + 1);
    for (int k = 0; k <= n; k++) mpz_set(q[k], p[k]);
    for (int m = n; sign == 0 && m > 0; m--) { /* derivatives */
        for (int k = 1; k <= m; k++) mpz_mul_ui(q[k - 1], q[k], (unsigned long)k);
        sign = exact_sign_q(q, m - 1, place->hi);
    }
    exact_free(q, n + 1);
    return sign;
}

/* Multiplicities of all places, and sides, from p itself; `squarefree` is its chain. */
static inline void exact_multiplicities(exact_hits *h, mpz_t *p, int n, const exact_sturm *squarefree) {
    int width = n + 1, m = n;
    mpz_t *g = exact_polynomials(1, width);
    exact_sturm s = *squarefree;
    for (int k = 0; k <= n; k++) mpz_set(g[k], p[k]);
    exact_primitive(g, n);
    for (int i = 0; i < h->count; i++) h->place[i].multiplicity = 0;
    while (m > 0) {
        for (int i = 0; i < h->count; i++) {
            exact_place *x = h->place + i;
            int point = mpq_equal(x->lo, x->hi);
            x->multiplicity +=
                point ? exact_sign_q(s.c, s.degree[0], x->lo) == 0 : exact_between_q(&s, x->lo, x->hi);
        }
        m = exact_divide(g, m, s.c, s.degree[0]);
        if (s.c != squarefree->c) exact_sturm_clear(&s);
        s = exact_sturm_of(g, m);
    }
    if (s.c != squarefree->c) exact_sturm_clear(&s);
    exact_free(g, width);
    for (int i = 0; i < h->count; i++) {
        exact_place *x = h->place + i;
        x->side = exact_sign_after(p, n, x) * (x->multiplicity % 2 ? -1 : 1);
    }
}

/* The face's sign at a place, which is narrowed. */
static inline int exact_face_sign(const exact_sturm *s, exact_place *place, const exact_face *face) {
    mpz_t *f = (mpz_t *)face->c;
    if (face->degree <= 0) return face->degree < 0 ? 0 : mpz_sgn(f[0]);
    if (mpq_equal(place->lo, place->hi)) return exact_sign_q(f, face->degree, place->lo);
    int top = s->degree[0] > 2 ? s->degree[0] : 2;
    mpz_t *g = exact_polynomials(1, top + 1);
    int n = exact_gcd(g, s->c, s->degree[0], f, face->degree), shared = 0;
    if (n > 0) {
        exact_sturm common = exact_sturm_of(g, n);
        shared = exact_between_q(&common, place->lo, place->hi) > 0;
        exact_sturm_clear(&common);
    }
    exact_free(g, top + 1);
    if (shared) return 0;
    exact_sturm own = exact_sturm_of(f, face->degree);
    while (mpq_cmp(place->lo, place->hi) < 0 &&
           (exact_sign_q(f, face->degree, place->lo) == 0 || exact_between_q(&own, place->lo, place->hi) > 0))
        exact_narrow(s, place);
    exact_sturm_clear(&own);
    return exact_sign_q(f, face->degree, place->hi);
}

static inline int exact_is_inside(const exact_sturm *s, exact_place *place, const exact_face *face,
                                  int faces) {
    for (int i = 0; i < faces; i++)
        if (exact_face_sign(s, place, face + i) < 0) return 0;
    return 1;
}

/* Leaves only the places inside, at most `most` of them. */
static inline void exact_keep_inside(exact_hits *h, const exact_sturm *s, const exact_face *face, int faces,
                                     int most) {
    int kept = 0;
    for (int i = 0; i < h->count; i++) {
        exact_place *place = h->place + i;
        if (kept < most && exact_is_inside(s, place, face, faces)) {
            exact_place other = h->place[kept];
            h->place[kept++] = *place, *place = other;
        }
    }
    for (int i = kept; i < h->count; i++) mpq_clears(h->place[i].lo, h->place[i].hi, NULL);
    h->count = kept;
}

/* Is no face negative at -infinity? */
static inline int exact_is_inside_far_before(const exact_face *face, int faces) {
    for (int i = 0; i < faces; i++) {
        int n = face[i].degree;
        if (n >= 0 && mpz_sgn(face[i].c[n]) == (n % 2 ? 1 : -1)) return 0;
    }
    return 1;
}

/* A ray in the surface: the first of t_min and the faces' roots that is inside. */
static inline void exact_first_inside(exact_hits *h, const exact_face *face, int faces,
                                      const algsurf_ray *ray) {
    int n = 1;
    mpz_t *product = exact_polynomials(1, 2 * EXACT_MOST_FACES + 2), *next;
    if (ray->t_min > ray->t_max || ray->t_min == (double)INFINITY || ray->t_max == (double)-INFINITY) {
        exact_free(product, 2 * EXACT_MOST_FACES + 2);
        return;
    }
    if (isfinite(ray->t_min)) { /* a root at t_min */
        double ends[2] = {-ray->t_min, 1};
        (void)exact_integers(product, ends, 1);
    } else { /* a root before all others: none */
        mpz_set_ui(product[0], 1), n = 0;
    }
    h->infinite = !isfinite(ray->t_min) && exact_is_inside_far_before(face, faces);
    for (int i = 0; i < faces; i++) {
        if (face[i].degree < 1) continue;
        next = exact_polynomials(1, 2 * EXACT_MOST_FACES + 2);
        exact_multiply(next, product, n, (mpz_t *)face[i].c, face[i].degree);
        exact_free(product, 2 * EXACT_MOST_FACES + 2);
        product = next, n += face[i].degree;
    }
    h->roots = exact_sturm_of(product, n);
    exact_all_roots(&h->roots, ray->t_min, ray->t_max, h);
    exact_keep_inside(h, &h->roots, face, faces, 1);
    if (h->count) h->place[0].multiplicity = h->place[0].side = 0;
    exact_free(product, 2 * EXACT_MOST_FACES + 2);
}

/* Is a number on the ray, and in the extent? */
static inline int exact_is_shown(double t, const exact_face *face, int faces, const algsurf_ray *ray) {
    mpq_t q;
    int inside = isfinite(t) && t >= ray->t_min && t <= ray->t_max;
    mpq_init(q);
    if (inside) exact_set(q, t);
    for (int i = 0; inside && i < faces; i++)
        inside = face[i].degree < 0 || exact_sign_q((mpz_t *)face[i].c, face[i].degree, q) >= 0;
    mpq_clear(q);
    return inside;
}

/* Does the ray certainly have a part inside that is longer than rounding?  It meets a smaller extent then. */
static inline int exact_is_long(const algsurf_extent *extent, const algsurf_plane *planes, size_t plane_count,
                                const algsurf_ray *ray, const algsurf_ray *chord) {
    algsurf_extent inner = {.kind = ALGSURF_EXTENT_ALL};
    algsurf_plane closer[ALGSURF_MAX_CLIP_PLANES];
    algsurf_ray part;
    double far = 0, reach = fmax(fabs(chord->t_min), fabs(chord->t_max)), step = 0;
    for (int i = 0; i < 3; i++) step = fmax(step, fabs(ray->direction[i]));
    int meets = 0, ball = extent && extent->kind == ALGSURF_EXTENT_SPHERE;
    if (extent) inner = *extent;
    for (int i = 0; i < 3; i++) {
        far = fmax(far, fabs(ray->origin[i]) + fabs(inner.centre[i]));
        if (ray->direction[i] != 0 && fabs(ray->direction[i]) < fmax(DBL_MIN, 0x1p-900 * step)) return 0;
    }
    for (int i = 0; inner.kind != ALGSURF_EXTENT_ALL && i < (ball ? 1 : 3); i++)
        if (!((inner.size[i] -= ldexp(far + inner.size[i], -36)) > 0)) return 0;
    for (size_t k = 0; k < plane_count; k++) {
        double size = fabs(planes[k].offset);
        for (int i = 0; i < 3; i++)
            size += fabs(planes[k].normal[i]) * (fabs(ray->origin[i]) + reach * fabs(ray->direction[i]));
        closer[k] = planes[k], closer[k].offset -= ldexp(size, -36);
        if (!isfinite(closer[k].offset) || size < 0x1p-900) return 0;
    }
    return algsurf_ray_clip(ray, &inner, closer, plane_count, &part, &meets) == ALGSURF_OK && meets &&
           part.t_max - part.t_min >= fmax(ldexp(reach, -36), 0x1p-900);
}

/* The sign behind the last place; or, where there is none, at any number on the ray's part inside.  The
 * library's chord only says where such a number may be. */
static inline void exact_set_end_sign(exact_hits *h, mpz_t *p, int n, const exact_face *face, int faces,
                                      const algsurf_extent *extent, const algsurf_plane *planes,
                                      size_t plane_count, const algsurf_ray *ray) {
    algsurf_ray chord;
    int meets = 0;
    h->end_sign = EXACT_NOT_KNOWN, h->is_short = 1;
    if (h->count > 0) h->end_sign = exact_sign_after(p, n, h->place + h->count - 1);
    if (algsurf_ray_clip(ray, extent, planes, plane_count, &chord, &meets) != ALGSURF_OK || !meets) return;
    double lo = fmax(chord.t_min, -DBL_MAX), hi = fmin(chord.t_max, DBL_MAX);
    const double tried[] = {0.5 * lo + 0.5 * hi, fmax(lo, fmin(hi, 0)), lo, hi};
    for (size_t i = 0; h->end_sign == EXACT_NOT_KNOWN && i < sizeof tried / sizeof *tried; i++) {
        mpq_t q;
        if (!exact_is_shown(tried[i], face, faces, ray)) continue;
        mpq_init(q);
        exact_set(q, tried[i]);
        h->end_sign = exact_sign_q(p, n, q);
        mpq_clear(q);
    }
    h->is_short = h->end_sign == EXACT_NOT_KNOWN || !exact_is_long(extent, planes, plane_count, ray, &chord);
}

/* What there is on a ray; extent may be null, and planes where there are none.  To be cleared. */
static inline exact_hits *exact_hits_of(const algsurf_term *terms, int count, int degree,
                                        const algsurf_extent *extent, const algsurf_plane *planes,
                                        size_t plane_count, const algsurf_ray *ray) {
    exact_hits *h = calloc(1, sizeof *h);
    exact_face face[EXACT_MOST_FACES];
    int faces = exact_faces_of(face, extent, ray);
    for (size_t i = 0; i < plane_count; i++) exact_plane_of(face + faces++, planes + i, ray);
    exact_line line = exact_line_of(terms, count, degree, ray);
    int n = exact_degree(line.c, degree);
    h->in_surface = n < 0;
    if (n < 0) {
        exact_first_inside(h, face, faces, ray);
    } else {
        h->roots = exact_sturm_of(line.c, n);
        exact_all_roots(&h->roots, ray->t_min, ray->t_max, h);
        exact_keep_inside(h, &h->roots, face, faces, EXACT_MOST_HITS);
        exact_multiplicities(h, line.c, n, &h->roots);
        exact_set_end_sign(h, line.c, n, face, faces, extent, planes, plane_count, ray);
    }
    exact_line_clear(&line);
    for (int i = 0; i < faces; i++)
        for (int k = 0; k < 3; k++) mpz_clear(face[i].c[k]);
    return h;
}

static inline void exact_hits_clear(exact_hits *h) {
    for (int i = 0; i < h->count; i++) mpq_clears(h->place[i].lo, h->place[i].hi, NULL);
    if (h->roots.c) exact_sturm_clear(&h->roots);
    free(h);
}

/* x less than (-1), equal to, or above (1) the root at a place; x may be infinite. */
static inline int exact_compare(const exact_hits *h, int i, double x) {
    const exact_place *place = h->place + i;
    const exact_sturm *s = &h->roots;
    int result;
    mpq_t q;
    if (isinf(x)) return x > 0 ? 1 : -1;
    mpq_init(q);
    exact_set(q, x);
    if (mpq_equal(place->lo, place->hi) || mpq_cmp(q, place->hi) >= 0) {
        result = mpq_cmp(q, place->hi);
        result = (result > 0) - (result < 0);
    } else if (mpq_cmp(q, place->lo) <= 0) {
        result = -1;
    } else if (exact_sign_q(s->c, s->degree[0], q) == 0) {
        result = 0;
    } else {
        result = exact_between_q(s, q, place->hi) > 0 ? -1 : 1;
    }
    mpq_clear(q);
    return result;
}

#endif
