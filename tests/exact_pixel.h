/* exact_pixel.h - the oracle for a pixel: the first root of P along its ray inside the extent, over integers.
 *
 * The part of the ray inside the extent, made a little longer, becomes [0,1], with integers over a power of
 * two as its ends; the roots of P along it are isolated from left to right by Descartes' rule and bisection
 * (Collins, Akritas 1976), a cluster that does not come apart by a Sturm chain.  What `room` says is what the
 * ends of the part may be off by: of a root closer to an end of the extent than that, either answer is right.
 * The ray's own beginning, the eye, is exact.
 */
#ifndef EXACT_PIXEL_H
#define EXACT_PIXEL_H
#include <limits.h>
#include <string.h>

#include "exact_ray.h"

enum { PIXEL_BITS = 1024, DEEPEST = 110 };

/* A root: in [at, at + 1] 2^-bits, or at 2^-bits itself. */
typedef struct exact_place {
    mpz_t at;
    int bits, exact, multiple;
} exact_place;

/* A ray's part inside the extent as [0,1]: t = t0 + x length, p = sum p[k] x^k. */
typedef struct exact_part {
    int n, empty;                  /* 1: nothing of the ray is near the extent */
    mpf_t t0, length, first, last; /* from first to last: surely inside; in t */
    mpz_t *p;
    mpf_t scale; /* p = P scale */
} exact_part;

/* The first roots that are surely inside the extent, as many as wanted, and others that may be. */
typedef struct exact_answer {
    int sure;      /* roots that are surely inside */
    int count;     /* of t: the last one is the last sure one wanted, if there is */
    int clustered; /* a root is multiple, or as good as */
    char is_sure[ALGSURF_MAX_DEGREE + 1];
    double t[ALGSURF_MAX_DEGREE + 1], rest[ALGSURF_MAX_DEGREE + 1];          /* the root is t + rest */
    long double slope[ALGSURF_MAX_DEGREE + 1], bend[ALGSURF_MAX_DEGREE + 1]; /* |dP/dt|, |d2P/dt2| there */
} exact_answer;

/* p, of degree n, becomes p (u + v x). */
static inline void exact_times_linear(mpz_t *p, int n, const mpz_t u, const mpz_t v) {
    for (int k = n + 1; k >= 0; k--) {
        mpz_mul(p[k], p[k], u);
        if (k > 0) mpz_addmul(p[k], p[k - 1], v);
    }
}

/* f = x / 2^shift. */
static inline void exact_float(mpf_t f, const mpz_t x, long shift) {
    mpf_set_z(f, x);
    shift >= 0 ? mpf_div_2exp(f, f, (mp_bitcnt_t)shift) : mpf_mul_2exp(f, f, (mp_bitcnt_t)-shift);
}

/* Where the line o + t d is inside the extent, to some 1000 bits; returns 0 where it is nowhere, and then
 * both ends are the middle of the smallest gap that a ball would leave, or untouched. */
static inline int exact_inside(const algsurf_extent *extent, const algsurf_ray *ray, mpf_t in, mpf_t out) {
    exact_face face[EXACT_MOST_FACES];
    int faces = exact_faces_of(face, extent, ray), inside = 1, begins = 0, ends = 0;
    mpz_t square, other;
    mpf_t t, root;
    mpz_inits(square, other, NULL), mpf_init2(t, PIXEL_BITS), mpf_init2(root, PIXEL_BITS);
    for (int i = 0; i < faces; i++) {
        mpz_t *c = face[i].c;
        if (face[i].degree == 2) { /* c_0 + c_1 t + c_2 t^2 >= 0, c_2 < 0 */
            mpz_mul(square, c[1], c[1]), mpz_mul(other, c[0], c[2]), mpz_submul_ui(square, other, 4);
            inside = mpz_sgn(square) >= 0;
            mpz_abs(square, square), mpf_set_z(root, square), mpf_sqrt(root, root);
            mpz_neg(other, c[1]), mpf_set_z(t, other), mpf_add(in, t, root), mpf_sub(out, t, root);
            mpz_mul_2exp(other, c[2], 1), mpf_set_z(t, other), mpf_div(in, in, t), mpf_div(out, out, t);
        } else if (face[i].degree == 1) { /* from -c_0 / c_1 on, or up to there */
            mpz_neg(other, c[0]), mpf_set_z(t, other), mpf_set_z(root, c[1]), mpf_div(t, t, root);
            if (mpz_sgn(c[1]) > 0 && (!begins++ || mpf_cmp(t, in) > 0)) mpf_set(in, t);
            if (mpz_sgn(c[1]) < 0 && (!ends++ || mpf_cmp(t, out) < 0)) mpf_set(out, t);
        } else {
            inside &= mpz_sgn(c[0]) >= 0;
        }
        for (int k = 0; k < 3; k++) mpz_clear(c[k]);
    }
    mpz_clears(square, other, NULL), mpf_clears(t, root, NULL);
    return inside && mpf_cmp(in, out) <= 0;
}

/* The part of the ray from t = 0 on; room: in t. */
static inline exact_part exact_part_of(const exact_line *line, const algsurf_extent *extent,
                                       const algsurf_ray *ray, double room) {
    exact_part part = {.n = line->degree, .p = exact_polynomials(1, line->degree + 2)};
    mpf_t wide, f;
    mpf_init2(part.t0, PIXEL_BITS), mpf_init2(part.length, PIXEL_BITS), mpf_init2(part.scale, PIXEL_BITS);
    mpf_init2(part.first, PIXEL_BITS), mpf_init2(part.last, PIXEL_BITS);
    mpf_init2(wide, PIXEL_BITS), mpf_init2(f, PIXEL_BITS);
    int inside = exact_inside(extent, ray, part.t0, part.last);
    mpf_set_d(wide, room);
    mpf_sub(part.length, part.last, part.t0);
    mpf_add(f, wide, wide);
    if (!inside && mpf_cmp(part.length, f) > 0) part.empty = 1; /* a ball passed by, or a box */
    if (!inside && mpf_sgn(part.length) < 0 && extent->kind == ALGSURF_EXTENT_BOX) {
        mpf_neg(part.length, part.length), mpf_swap(part.t0, part.last);
        part.empty = mpf_cmp(part.length, f) > 0;
    }
    mpf_add(part.first, part.t0, wide), mpf_sub(part.t0, part.t0, wide);
    mpf_add(f, part.last, wide), mpf_sub(part.last, part.last, wide);
    if (mpf_sgn(part.t0) < 0) mpf_set_ui(part.t0, 0);
    if (mpf_sgn(part.first) < 0) mpf_set_ui(part.first, 0);
    if (!inside) mpf_sub(part.last, part.first, wide);
    mpf_sub(part.length, f, part.t0);
    if (mpf_sgn(part.length) <= 0) part.empty = 1;
    if (!part.empty) { /* integers: t0 and length as multiples of 2^-fine */
        mpz_t t0, length, term;
        long e, fine;
        (void)mpf_get_d_2exp(&e, wide);
        fine = 80 - e;
        if (fine < 0) fine = 0;
        mpz_inits(t0, length, term, NULL);
        mpf_mul_2exp(f, part.t0, (mp_bitcnt_t)fine), mpz_set_f(t0, f);
        mpf_mul_2exp(f, part.length, (mp_bitcnt_t)fine), mpz_set_f(length, f), mpz_add_ui(length, length, 1);
        exact_float(part.t0, t0, fine), exact_float(part.length, length, fine);
        for (int k = part.n; k >= 0; k--) {
            exact_times_linear(part.p, part.n - k - 1, t0, length);
            mpz_mul_2exp(term, line->c[k], (mp_bitcnt_t)(fine * (part.n - k)));
            mpz_add(part.p[0], part.p[0], term);
        }
        mpf_set_ui(part.scale, 1);
        mpf_mul_2exp(part.scale, part.scale, (mp_bitcnt_t)(fine * part.n + line->shift));
        mpz_clears(t0, length, term, NULL);
    }
    mpf_clears(wide, f, NULL);
    return part;
}

static inline void exact_part_clear(exact_part *part) {
    exact_free(part->p, part->n + 2);
    mpf_clears(part->t0, part->length, part->first, part->last, part->scale, NULL);
}

/* p(x) becomes p(x + 1). */
static inline void exact_shift(mpz_t *p, int n) {
    for (int i = 0; i < n; i++)
        for (int k = n - 1; k >= i; k--) mpz_add(p[k], p[k], p[k + 1]);
}

/* Descartes' bound for the roots in (0,1): the variations of (x+1)^n p(1/(x+1)), more than 1 counting as 2.
 */
static inline int exact_descartes(mpz_t *p, int n) {
    mpz_t *r = exact_polynomials(1, n + 1);
    int variations = 0, last = 0;
    for (int k = 0; k <= n; k++) mpz_set(r[k], p[n - k]);
    exact_shift(r, n);
    for (int k = 0; k <= n && variations < 2; k++) {
        int sign = mpz_sgn(r[k]);
        variations += sign * last < 0;
        if (sign != 0) last = sign;
    }
    exact_free(r, n + 1);
    return variations;
}

typedef int (*exact_visit)(exact_place *place, void *data); /* returns 1 to stop */

/* Visits the roots in [0,1) of p, which is sum q_k ((x + at) / 2^bits)^k of the polynomial looked at, from
 * left to right; changes p. */
static inline int exact_walk(mpz_t *p, int n, const mpz_t at, int bits, exact_visit visit, void *data) {
    exact_place place = {.bits = bits};
    int stop = 0;
    mpz_init_set(place.at, at);
    if (mpz_sgn(p[0]) == 0) {
        int zeros = 0;
        while (n > 0 && mpz_sgn(p[0]) == 0) {
            for (int k = 0; k < n; k++) mpz_swap(p[k], p[k + 1]);
            n--, zeros++;
        }
        place.exact = 1, place.multiple = zeros > 1;
        stop = visit(&place, data);
        place.exact = place.multiple = 0;
    }
    int variations = stop ? 0 : exact_descartes(p, n);
    if (variations == 1) {
        stop = visit(&place, data);
    } else if (variations > 1 && bits >= DEEPEST) {
        exact_sturm s = exact_sturm_of(p, n);
        int roots = exact_count_roots(&s, 0, 1);
        exact_sturm_clear(&s);
        place.multiple = 1;
        if (roots > 0) stop = visit(&place, data);
    } else if (variations > 1) {
        mpz_t *half = exact_polynomials(1, n + 1), next;
        mpz_init(next);
        for (int k = 0; k <= n; k++) {
            mpz_mul_2exp(p[k], p[k], (unsigned long)(n - k));
            mpz_set(half[k], p[k]);
        }
        mpz_mul_2exp(next, at, 1);
        stop = exact_walk(half, n, next, bits + 1, visit, data);
        if (!stop) {
            exact_shift(p, n);
            mpz_add_ui(next, next, 1);
            stop = exact_walk(p, n, next, bits + 1, visit, data);
        }
        exact_free(half, n + 1), mpz_clear(next);
    }
    mpz_clear(place.at);
    return stop;
}

/* The derivative of order `by`, 0 to 2, of p at x = at 2^-bits, times 2^(bits (n - by)). */
static inline void exact_at(mpz_t value, mpz_t *p, int n, const mpz_t at, int bits, int by) {
    mpz_t term;
    mpz_init(term);
    mpz_set_ui(value, 0);
    for (int k = n; k >= by; k--) {
        unsigned long factor = 1;
        for (int i = 0; i < by; i++) factor *= (unsigned long)(k - i);
        mpz_mul(value, value, at);
        mpz_mul_ui(term, p[k], factor), mpz_mul_2exp(term, term, (unsigned long)(bits * (n - k)));
        mpz_add(value, value, term);
    }
    mpz_clear(term);
}

/* The magnitude of the same derivative of P by t. */
static inline long double exact_derivative(exact_part *part, const mpz_t at, int bits, int by) {
    mpf_t f;
    mpz_t value;
    long e;
    mpf_init2(f, PIXEL_BITS), mpz_init(value);
    exact_at(value, part->p, part->n, at, bits, by);
    exact_float(f, value, (long)bits * (part->n - by));
    for (int i = 0; i < by; i++) mpf_div(f, f, part->length);
    mpf_div(f, f, part->scale);
    long double size = fabs(mpf_get_d_2exp(&e, f));
    mpf_clear(f), mpz_clear(value);
    return ldexpl(size, (int)e);
}

/* Halves the place of a simple root until it is 2^-bits wide. */
static inline void exact_narrow(mpz_t *p, int n, exact_place *place, int bits) {
    mpz_t value;
    mpz_init(value);
    exact_at(value, p, n, place->at, place->bits, 0);
    int left = mpz_sgn(value);
    if (left == 0 && !place->exact) { /* a root at the left end is another one: the sign right of it */
        exact_at(value, p, n, place->at, place->bits, 1);
        left = mpz_sgn(value);
    }
    while (!place->exact && !place->multiple && place->bits < bits) {
        mpz_mul_2exp(place->at, place->at, 1), place->bits++;
        mpz_add_ui(place->at, place->at, 1);
        exact_at(value, p, n, place->at, place->bits, 0);
        if (mpz_sgn(value) == 0)
            place->exact = 1;
        else if (mpz_sgn(value) != left)
            mpz_sub_ui(place->at, place->at, 1);
    }
    mpz_clear(value);
}

typedef struct exact_collector {
    exact_part *part;
    exact_answer *answer;
    int wanted;
} exact_collector;

static inline int exact_collect(exact_place *place, void *data) {
    exact_collector *c = data;
    exact_part *part = c->part;
    exact_answer *answer = c->answer;
    mpf_t t, rest;
    mpf_init2(t, PIXEL_BITS), mpf_init2(rest, PIXEL_BITS);
    exact_narrow(part->p, part->n, place, DEEPEST);
    exact_float(t, place->at, place->bits), mpf_mul(t, t, part->length), mpf_add(t, t, part->t0);
    int i = answer->count++, sure = mpf_cmp(t, part->first) >= 0 && mpf_cmp(t, part->last) <= 0;
    answer->is_sure[i] = (char)sure, answer->sure += sure;
    answer->clustered |= place->multiple;
    answer->t[i] = mpf_get_d(t);
    answer->slope[i] = exact_derivative(part, place->at, place->bits, 1);
    answer->bend[i] = exact_derivative(part, place->at, place->bits, 2);
    mpf_set_d(rest, answer->t[i]), mpf_sub(t, t, rest), answer->rest[i] = mpf_get_d(t);
    mpf_clears(t, rest, NULL);
    return answer->sure == c->wanted;
}

static inline exact_answer exact_first_roots(const exact_line *line, const algsurf_extent *extent,
                                             const algsurf_ray *ray, double room, int wanted) {
    exact_answer answer = {0};
    exact_part part = exact_part_of(line, extent, ray, room);
    if (!part.empty) {
        int n = line->degree, zeros = exact_degree(part.p, n) < 0;
        mpz_t *copy = exact_polynomials(1, n + 1), zero;
        mpz_init(zero);
        for (int k = 0; k <= n; k++) mpz_set(copy[k], part.p[k]);
        exact_collector c = {&part, &answer, wanted};
        if (zeros)
            answer.clustered = 1, answer.sure = 1; /* the ray lies in the surface */
        else
            (void)exact_walk(copy, n, zero, 0, exact_collect, &c);
        exact_free(copy, n + 1), mpz_clear(zero);
    }
    exact_part_clear(&part);
    return answer;
}

static inline exact_answer exact_first_root(const algsurf_term *terms, int count, int n,
                                            const algsurf_extent *extent, const algsurf_ray *ray,
                                            double room) {
    exact_line line = exact_line_of(terms, count, n, ray);
    exact_answer answer = exact_first_roots(&line, extent, ray, room, 1);
    exact_line_clear(&line);
    return answer;
}

#endif
