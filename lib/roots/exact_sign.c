/* exact_sign.c - the sign of another polynomial at a root: is it inside a condition's range?
 *
 * q has degree 1, or degree 2 with a negative leading coefficient.  Over the root's place (a, b):
 * - degree 1: with one sign at both ends, or 0 at one, it has that sign between them;
 * - degree 2: q is concave; not negative at both ends it is positive between them, and negative at both it is
 *   negative between them where its slope keeps its sign, and everywhere where its discriminant is negative
 *   (so the root may well be at its top: it would stay between the ends for ever);
 * - else the place is halved, unless the root is q's, too: then it would be for ever.  So before the first
 *   halving the common factor of f and q is looked for.  Its roots are f's, hence it changes its sign over
 * the place, where f has no more than one root, if and only if that root is shared. */
#include "../base/arithmetic.h"
#include "exact_walk.h"

typedef struct judge {
    algsurf_memory *memory;
    const algsurf_zpoly *f, *q;
    algsurf_limb *a, *b;
    int width, r;
} judge;

static int sign_of(const judge *j, const algsurf_zpoly *p, const algsurf_limb *N, int *sign) {
    return algsurf_zpoly_sign_at(j->memory, p, N, j->width, j->r, sign, NULL, NULL);
}

/* Does q' keep its sign over the place? */
static int is_monotone(const judge *j, int *monotone) {
    algsurf_zpoly slope;
    int at_a, at_b;
    if (!algsurf_zpoly_derivative(j->memory, j->q, &slope)) return 0;
    if (!sign_of(j, &slope, j->a, &at_a) || !sign_of(j, &slope, j->b, &at_b)) return 0;
    *monotone = at_a * at_b >= 0;
    return 1;
}

/* Is q, of degree 2, negative everywhere: q_1^2 < 4 q_2 q_0? */
static int is_negative(const judge *j, int *negative) {
    const algsurf_zpoly *q = j->q;
    int w = q->width, wide = 2 * w + 1;
    algsurf_limb *d = algsurf_memory_take(j->memory, (size_t)wide + 2 * (size_t)w);
    if (!d) return 0;
    algsurf_limb *room = d + wide;
    algsurf_z_factor q1 = algsurf_z_factor_of(algsurf_zpoly_at(q, 1), w, room),
                     q0 = algsurf_z_factor_of(algsurf_zpoly_at(q, 0), w, room + w);
    algsurf_z_zero(d, wide);
    algsurf_z_add_times(d, wide, algsurf_zpoly_at(q, 2), w, &q0, 1);
    algsurf_z_shift_up(d, wide, 2);
    algsurf_z_add_times(d, wide, algsurf_zpoly_at(q, 1), w, &q1, 0);
    *negative = algsurf_z_sign(d, wide) < 0;
    return 1;
}

/* Decided by q at both ends: *known. */
static int judge_ends(const judge *j, int *known, int *sign) {
    int at_a, at_b, below = 0;
    *known = 1;
    if (!sign_of(j, j->q, j->a, &at_a) || !sign_of(j, j->q, j->b, &at_b)) return 0;
    *sign = at_a != 0 ? at_a : at_b;
    if (j->q->degree == 1) {
        *known = at_a * at_b >= 0;
    } else if (at_a >= 0 && at_b >= 0) {
        *sign = 1;
    } else {
        *known = 0;
        if (at_a < 0 && at_b < 0) {
            if (!is_monotone(j, &below)) return 0;
            if (!below && !is_negative(j, &below)) return 0;
            *known = below;
        }
    }
    return 1;
}

/* Do f and q have the root in common? */
static int is_shared(const judge *j, int *shared) {
    algsurf_parts parts;
    int degree, at_a, at_b;
    *shared = 0;
    if (!algsurf_zpoly_gcd_degree(j->memory, j->f, j->q, 2, &degree)) return 0;
    if (degree == 0) return 1;
    if (!algsurf_zpoly_split(j->memory, j->f, j->q, &parts)) return 0;
    if (parts.g.degree < 1) return 1;
    if (!sign_of(j, &parts.g, j->a, &at_a) || !sign_of(j, &parts.g, j->b, &at_b)) return 0;
    *shared = at_a * at_b < 0;
    return 1;
}

/* Copies of the ends, with room for `spare` more bits. */
static int widen(judge *j, int spare) {
    int width = j->width + algsurf_z_width(spare);
    algsurf_limb *ends = algsurf_memory_take(j->memory, 2 * (size_t)width);
    if (!ends) return 0;
    algsurf_z_copy(ends, width, j->a, j->width);
    algsurf_z_copy(ends + width, width, j->b, j->width);
    j->a = ends;
    j->b = ends + width;
    j->width = width;
    return 1;
}

/* Halves the place; *point: its middle is the root, and is a. */
static int halve(judge *j, int before, int *point) {
    int sign;
    if (algsurf_z_bits(j->a, j->width) + 3 > 64 * j->width ||
        algsurf_z_bits(j->b, j->width) + 3 > 64 * j->width)
        if (!widen(j, 256)) return 0;
    algsurf_limb *middle = algsurf_memory_take(j->memory, (size_t)j->width);
    if (!middle) return 0;
    algsurf_z_copy(middle, j->width, j->a, j->width);
    algsurf_z_add(middle, j->b, j->width);
    algsurf_z_shift_up(j->a, j->width, 1);
    algsurf_z_shift_up(j->b, j->width, 1);
    j->r++;
    if (!sign_of(j, j->f, middle, &sign)) return 0;
    algsurf_z_copy(sign == 0 || sign == before ? j->a : j->b, j->width, middle, j->width);
    *point = sign == 0;
    return 1;
}

static int judge_root(judge *j, int *sign) {
    int known, before, shared, point = 0;
    if (!judge_ends(j, &known, sign)) return 0;
    if (known) return 1;
    if (!is_shared(j, &shared)) return 0;
    if (shared) {
        *sign = 0;
        return 1;
    }
    if (!widen(j, 64) || !sign_of(j, j->f, j->a, &before)) return 0;
    while (!known) {
        if (!halve(j, before, &point)) return 0;
        if (point) return sign_of(j, j->q, j->a, sign);
        if (!judge_ends(j, &known, sign)) return 0;
    }
    return 1;
}

int algsurf_exact_sign_at_root(algsurf_exact_walk *walk, const algsurf_exact_root *root,
                               const algsurf_zpoly *q, int *sign) {
    const algsurf_exact_place *place = &root->place;
    algsurf_memory_mark mark = algsurf_memory_here(walk->memory);
    judge j = {walk->memory, place->of, q, NULL, NULL, place->width, place->r};
    int done = 1;
    if (q->degree <= 0) {
        *sign = q->degree < 0 ? 0 : algsurf_z_sign(q->c, q->width);
    } else if (!place->b) {
        done = sign_of(&j, q, place->a, sign);
    } else {
        algsurf_limb *ends = algsurf_memory_take(walk->memory, 2 * (size_t)place->width);
        j.a = ends;
        j.b = ends ? ends + place->width : NULL;
        if (ends) {
            algsurf_z_copy(j.a, j.width, place->a, j.width);
            algsurf_z_copy(j.b, j.width, place->b, j.width);
        }
        done = ends && judge_root(&j, sign);
    }
    algsurf_memory_release(walk->memory, mark);
    return done;
}
