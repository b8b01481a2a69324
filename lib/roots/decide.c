/* decide.c - from doubles (or a caller's integers) to integers, and the walks of exact.c and exact_radii.c
 * over them. */
#include "../base/arithmetic.h"
#include "decide.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "exact.h"
#include "exact_radii.h"

enum { STACK_WORDS = 2048 };

static algsurf_real_root root_of(const algsurf_exact_root *root) {
    return (algsurf_real_root){root->t, root->lo, root->hi, root->multiplicity, root->sign_before};
}

static algsurf_status walk(algsurf_memory *m, const algsurf_zpoly *p, int unit, double lo, double hi,
                           int refine, int most, algsurf_real_root *roots, int *count, int *cells) {
    algsurf_exact_walk walk;
    algsurf_exact_root root;
    int found = ALGSURF_EXACT_END;
    if (!algsurf_exact_begin(&walk, m, p, unit, lo, hi, refine)) return ALGSURF_E_NO_MEMORY;
    while (*count < most && (found = algsurf_exact_next(&walk, &root)) == ALGSURF_EXACT_ROOT)
        roots[(*count)++] = root_of(&root);
    if (cells) *cells += walk.cells.counted;
    return found == ALGSURF_EXACT_NO_MEMORY ? ALGSURF_E_NO_MEMORY : ALGSURF_OK;
}

static int unit_of(double lo, double hi) {
    return isfinite(lo) && isfinite(hi) ? algsurf_exact_piece_of(lo, hi).unit : 0;
}

int algsurf_i_from_integers(algsurf_memory *m, const algsurf_integer *c, int degree, algsurf_zpoly *p) {
    int longest = 0;
    for (int k = 0; k <= degree; k++)
        if (abs(c[k].length) > longest) longest = abs(c[k].length);
    if (!algsurf_zpoly_new(m, degree, longest + 1, p)) return 0;
    for (int k = 0; k <= degree; k++) {
        algsurf_limb *a = algsurf_zpoly_at(p, k);
        if (c[k].length) memcpy(a, c[k].limbs, (size_t)abs(c[k].length) * sizeof *a);
        if (c[k].length < 0) algsurf_z_negate(a, p->width);
    }
    algsurf_zpoly_compact(p);
    return 1;
}

/* The first `most` roots of a polynomial from doubles c or, if that is null, from integers z. */
static algsurf_status decide(const double *c, const algsurf_integer *z, int degree, double lo, double hi,
                             int refine, int most, algsurf_real_root *roots, int *count, int *cells) {
    algsurf_limb block[STACK_WORDS];
    algsurf_memory memory;
    algsurf_zpoly p;
    int unit = c ? unit_of(lo, hi) : 0;
    *count = 0;
    algsurf_memory_begin(&memory, block, STACK_WORDS, ALGSURF_I_DECIDE_MEMORY);
    algsurf_memory_mark begin = algsurf_memory_here(&memory);
    algsurf_status status = ALGSURF_E_NO_MEMORY;
    if (c ? algsurf_exact_from_doubles(&memory, c, degree, unit, &p)
          : algsurf_i_from_integers(&memory, z, degree, &p))
        status =
            p.degree < 1 ? ALGSURF_OK : walk(&memory, &p, unit, lo, hi, refine, most, roots, count, cells);
    algsurf_memory_release(&memory, begin);
    return status;
}

algsurf_status algsurf_i_decide_roots(const double *c, int degree, double lo, double hi, int refine,
                                      algsurf_real_root *roots, int capacity, int *count, int *cells) {
    return decide(c, NULL, degree, lo, hi, refine ? ALGSURF_EXACT_REFINED : ALGSURF_EXACT_BRACKETS, capacity,
                  roots, count, cells);
}

algsurf_status algsurf_i_decide_integers(const algsurf_integer *c, int degree, double lo, double hi,
                                         algsurf_real_root *roots, int capacity, int *count) {
    return decide(NULL, c, degree, lo, hi, ALGSURF_EXACT_REFINED, capacity, roots, count, NULL);
}

/* ---- radii ---- */

/* Both in integers with one power of two: p and the radii are parts of one polynomial of twice as many
 * coefficients. */
static int in_integers(algsurf_memory *m, const algsurf_i_coefficients *p, int unit, algsurf_zpoly *centre,
                       algsurf_zpoly *radius) {
    int least = ALGSURF_Z_NO_BIT;
    for (int k = 0; k <= p->degree; k++) {
        int low = algsurf_exact_low_bit(p->c[k]), low_radius = algsurf_exact_low_bit(p->r[k]);
        if (low != ALGSURF_Z_NO_BIT && low + k * unit < least) least = low + k * unit;
        if (low_radius != ALGSURF_Z_NO_BIT && low_radius + k * unit < least) least = low_radius + k * unit;
    }
    return algsurf_exact_from_doubles_above(m, p->c, p->degree, unit, least, centre) &&
           algsurf_exact_from_doubles_above(m, p->r, p->degree, unit, least, radius);
}

/* A range's bracket.  With lo = hi, a root only where all of the set vanish. */
static algsurf_bracket bracket_of(const algsurf_i_coefficients *p, const algsurf_exact_range *range) {
    algsurf_bracket b = {range->lo, range->hi, ALGSURF_BRACKET_UNDECIDED,
                         0,         p->degree, ALGSURF_UNDECIDED_MULTIPLE};
    if (b.lo == b.hi && algsurf_i_sign_at(p, b.lo) == 0) {
        b.kind = ALGSURF_BRACKET_EXACT;
        b.status = ALGSURF_OK;
    } else if (b.lo == b.hi) {
        b.status = ALGSURF_UNDECIDED_ZERO;
    } else if (range->sign_lo) {
        b = (algsurf_bracket){b.lo, b.hi, ALGSURF_BRACKET_ISOLATED, range->sign_lo, 1, ALGSURF_OK};
    } else if (isinf(b.lo) || isinf(b.hi)) {
        b.status = ALGSURF_UNDECIDED_RANGE;
    }
    return b;
}

algsurf_status algsurf_i_decide_ranges(const algsurf_i_coefficients *p, double lo, double hi,
                                       algsurf_bracket *brackets, int capacity, int *count, int *cells) {
    algsurf_exact_range found[ALGSURF_MAX_POLY_DEGREE];
    algsurf_limb block[STACK_WORDS];
    algsurf_memory memory;
    algsurf_zpoly centre, radius;
    int unit = unit_of(lo, hi);
    *count = 0;
    if (p->degree < 1 || lo == HUGE_VAL || hi == -HUGE_VAL) return ALGSURF_OK;
    algsurf_memory_begin(&memory, block, STACK_WORDS, ALGSURF_I_DECIDE_MEMORY);
    algsurf_memory_mark begin = algsurf_memory_here(&memory);
    int done =
        in_integers(&memory, p, unit, &centre, &radius) &&
        algsurf_exact_radii_isolate(&memory, &centre, &radius, unit, lo, hi, found, capacity, count, cells);
    algsurf_memory_release(&memory, begin);
    for (int i = 0; i < *count; i++) brackets[i] = bracket_of(p, found + i);
    return done ? ALGSURF_OK : ALGSURF_E_NO_MEMORY;
}
