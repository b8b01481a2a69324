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
    const algsurf_zpoly *q;
    algsurf_exact_place place;
} judge;

/* Does q' keep its sign over the place? */
static int is_monotone(const judge *j, int *monotone) {
    algsurf_zpoly slope;
    int at_a, at_b;
    if (!algsurf_zpoly_derivative(j->memory, j->q, &slope)) return 0;
    if (!algsurf_exact_signs(j->memory, &slope, &j->place, &at_a, &at_b)) return 0;
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

/* Decided by q at both ends, or at the point: *known. */
static int judge_ends(const judge *j, int *known, int *sign) {
    int at_a, at_b;
    if (!algsurf_exact_signs(j->memory, j->q, &j->place, &at_a, &at_b)) return 0;
    *sign = at_a != 0 ? at_a : at_b;
    *known = at_a * at_b >= 0;
    if (j->q->degree == 1 || !j->place.b) return 1;
    *known = at_a >= 0 && at_b >= 0;
    if (*known) *sign = 1;
    if (at_a >= 0 || at_b >= 0) return 1;
    return is_monotone(j, known) && (*known || is_negative(j, known));
}

/* Do f and q have the root in common? */
static int is_shared(const judge *j, int *shared) {
    algsurf_parts parts;
    int degree, at_a, at_b;
    *shared = 0;
    if (!algsurf_zpoly_gcd_degree(j->memory, j->place.of, j->q, 2, &degree)) return 0;
    if (degree == 0) return 1;
    if (!algsurf_zpoly_split(j->memory, j->place.of, j->q, &parts)) return 0;
    if (parts.g.degree < 1) return 1;
    if (!algsurf_exact_signs(j->memory, &parts.g, &j->place, &at_a, &at_b)) return 0;
    *shared = at_a * at_b < 0;
    return 1;
}

static int judge_root(judge *j, int *sign) {
    int known, before, shared;
    if (!judge_ends(j, &known, sign)) return 0;
    if (known) return 1;
    if (!is_shared(j, &shared)) return 0;
    if (shared) {
        *sign = 0;
        return 1;
    }
    if (!algsurf_exact_signs(j->memory, j->place.of, &j->place, &before, NULL)) return 0;
    while (!known) {
        if (!algsurf_exact_halve(j->memory, &j->place, before)) return 0;
        if (!judge_ends(j, &known, sign)) return 0;
    }
    return 1;
}

int algsurf_exact_sign_at_root(algsurf_exact_walk *walk, const algsurf_exact_root *root,
                               const algsurf_zpoly *q, int *sign) {
    algsurf_memory_mark mark = algsurf_memory_here(walk->memory);
    judge j = {walk->memory, q, root->place};
    int done = 1;
    if (q->degree <= 0)
        *sign = q->degree < 0 ? 0 : algsurf_z_sign(q->c, q->width);
    else
        done = judge_root(&j, sign);
    algsurf_memory_release(walk->memory, mark);
    return done;
}
