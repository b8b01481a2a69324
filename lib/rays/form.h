/* form.h - P, and what bounds an extent, along a part of a ray, as forms with integer coefficients.
 *
 * All doubles are integers times powers of two, so on [lo,hi], t = lo (1-s) + hi s, the point (X, w) of the
 * ray, homogeneous, is linear in s, and 2^S times it has integer ends.  P, made homogeneous of its degree n,
 * is then a form of degree n in (1-s, s) with integer coefficients c_k; with an infinite end it is the same
 * with the direction, w = 0, for that end, times 2^m, about the size of the other one.  The numbers
 * k! (n-k)! c_k are n! times its Bernstein coefficients.
 *
 * A point is in a sphere where R^2 w^2 - |X - c w|^2 >= 0, a quadratic form, and in a box where
 * h_i w + (X_i - c_i w) >= 0 and h_i w - (X_i - c_i w) >= 0, six linear ones: the same is done to them.
 *
 * P and a form of the extent's have a root in common for certain if the form divides P: then all its roots
 * are P's.  Long division, without fractions, tells.
 *
 * Size of the integers.  If all ends are below 2^U and coefficients below 2^A, a form's coefficients add up
 * to at most 2^16 2^A 2^((U+1) n), for a surface has fewer than 2^16 terms; n! <= 2^(6n), and each bisection
 * adds n bits.  The extent's forms need no more than one of degree 2 with n! and 2^16 in it.  Each of the at
 * most n steps of a division multiplies by a number as long as the divisor's, and adds a bit.
 */
#ifndef ALGSURF_INTERSECT_FORM_H
#define ALGSURF_INTERSECT_FORM_H
#include "algsurf/ray.h"
#include "../base/eft_integer.h"
#include "../surface/impl.h"

enum { ALGSURF_MOST_FACES = 6 }; /* of an extent; the sphere has one */

typedef struct algsurf_i_form_linear {
    algsurf_i_factor at[2]; /* at s = 0 and s = 1 */
} algsurf_i_form_linear;

typedef struct algsurf_i_ray_form {
    const algsurf_surface *surface;
    const algsurf_extent *extent; /* null: none */
    double lo, hi;                /* not both infinite */
    int far;     /* m: where an end is infinite, t is lo + 2^m s/(1-s), or hi - 2^m (1-s)/s */
    int depth;   /* bisections that the integers have room for */
    int n, size; /* degree; words of an integer */
    uint32_t *p; /* n! times P's Bernstein coefficients */
    int faces, face_degree;
    uint32_t *inside;       /* those of each face's form, one after the other; all are >= 0 in the extent */
    uint32_t *left, *right; /* room for two more of degree n, */
    uint32_t *part;         /* and for two of a face's */
    int shift;              /* S; w is 2^S at finite ends */
    int coefficient_shift;  /* of the surface's coefficients */
    algsurf_i_form_linear x[3];
    uint32_t *memory, *row, *level, *spare; /* all of it; forms on the way; one integer */
} algsurf_i_ray_form;

/* n choose k, for n <= 64. */
uint64_t algsurf_i_binomial(int n, int k);

static inline uint32_t *algsurf_i_form_entry(const algsurf_i_ray_form *f, uint32_t *form, int k) {
    return form + (size_t)k * (size_t)f->size;
}

/* Makes the forms of a surface, an extent, and [lo,hi], which are set, as is depth.  0: there are too many
 * digits, or the surface's coefficients are not exact, or there is no memory.  To be freed if 1. */
int algsurf_i_ray_form_make(algsurf_i_ray_form *f, const algsurf_ray *ray);
void algsurf_i_ray_form_free(algsurf_i_ray_form *f);

static inline uint32_t *algsurf_i_form_face(const algsurf_i_ray_form *f, int face) {
    return algsurf_i_form_entry(f, f->inside, face * (f->face_degree + 1));
}

/* Does a face's form divide P?  0 also where that cannot be told: too many digits, no memory.  Cost: n^2
 * products of integers. */
int algsurf_i_face_divides(const algsurf_i_ray_form *f, int face);

#endif
