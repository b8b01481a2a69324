/* decide.c - from doubles (or a caller's integers) to integers, and the walks of exact_walk.c and
 * exact_radii.c over them. */
#include "../base/arithmetic.h"
#include "line.h"

#include <math.h>

#include "exact_walk.h"

enum { STACK_WORDS = 2048 };

static int unit_of(double lo, double hi) {
    return isfinite(lo) && isfinite(hi) ? algsurf_exact_piece_of(lo, hi).unit : 0;
}

int algsurf_i_take_integers(algsurf_memory *m, const algsurf_i_line *line, algsurf_zpoly *p) {
    if (!algsurf_zpoly_from_integers(m, line->z, line->p.degree, p)) return 0;
    algsurf_zpoly_compact(p);
    return 1;
}

algsurf_status algsurf_i_decide(const algsurf_i_line *line, algsurf_real_root *roots, int capacity,
                                int *count) {
    const algsurf_i_watch *watch = line->watch;
    const double *c = line->p.c;
    algsurf_i_watch scaled;
    algsurf_limb block[STACK_WORDS];
    algsurf_memory memory;
    algsurf_zpoly p;
    algsurf_exact_walk exact;
    algsurf_exact_root root;
    int unit = c ? unit_of(line->lo, line->hi) : 0, found = ALGSURF_EXACT_END,
        least = c ? algsurf_zpoly_least_bit(c, 1, line->p.degree, unit) : 0,
        refine = line->refined ? ALGSURF_EXACT_REFINED : ALGSURF_EXACT_BRACKETS;
    *count = 0;
    algsurf_memory_mark begin = algsurf_memory_begin(&memory, block, STACK_WORDS, ALGSURF_I_DECIDE_MEMORY);
    int done = c ? algsurf_zpoly_from_doubles(&memory, c, 1, line->p.degree, unit, least, &p)
                 : algsurf_i_take_integers(&memory, line, &p);
    if (done && p.degree > 0) {
        if (watch) {
            scaled = *watch;
            scaled.exponent += least;
            watch = &scaled;
        }
        done = algsurf_exact_begin(&exact, &memory, &p, unit, line->lo, line->hi, refine, watch);
        while (done && *count < capacity && (found = algsurf_exact_next(&exact, &root)) == ALGSURF_EXACT_ROOT)
            roots[(*count)++] =
                (algsurf_real_root){root.t, root.lo, root.hi, root.multiplicity, root.sign_before};
    }
    algsurf_memory_release(&memory, begin);
    return done && found != ALGSURF_EXACT_NO_MEMORY ? ALGSURF_OK : ALGSURF_E_NO_MEMORY;
}

/* ---- radii ---- */

/* Both in integers with one power of two: p and the radii are parts of one polynomial of twice as many
 * coefficients. */
static int in_integers(algsurf_memory *m, const algsurf_i_coefficients *p, int unit, algsurf_zpoly *centre,
                       algsurf_zpoly *radius) {
    int least = algsurf_zpoly_least_bit(p->c, 1, p->degree, unit),
        of_radii = algsurf_zpoly_least_bit(p->r, 1, p->degree, unit);
    if (of_radii < least) least = of_radii;
    return algsurf_zpoly_from_doubles(m, p->c, 1, p->degree, unit, least, centre) &&
           algsurf_zpoly_from_doubles(m, p->r, 1, p->degree, unit, least, radius);
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
                                       algsurf_bracket *brackets, int capacity, int *count,
                                       const algsurf_i_watch *watch) {
    algsurf_limb block[STACK_WORDS];
    algsurf_memory memory;
    algsurf_zpoly centre, radius;
    int unit = unit_of(lo, hi);
    *count = 0;
    if (p->degree < 1 || lo == HUGE_VAL || hi == -HUGE_VAL) return ALGSURF_OK;
    algsurf_memory_mark begin = algsurf_memory_begin(&memory, block, STACK_WORDS, ALGSURF_I_DECIDE_MEMORY);
    algsurf_exact_range *found = algsurf_i_take(&memory, (size_t)capacity * sizeof *found);
    int done =
        found && in_integers(&memory, p, unit, &centre, &radius) &&
        algsurf_exact_radii_isolate(&memory, &centre, &radius, unit, lo, hi, found, capacity, count, watch);
    for (int i = 0; i < *count; i++) brackets[i] = bracket_of(p, found + i);
    algsurf_memory_release(&memory, begin);
    return done ? ALGSURF_OK : ALGSURF_E_NO_MEMORY;
}

algsurf_status algsurf_i_decide_sign(const algsurf_i_coefficients *p, double x, int *sign) {
    algsurf_limb block[STACK_WORDS];
    algsurf_memory memory;
    algsurf_zpoly centre, radius;
    algsurf_memory_mark begin = algsurf_memory_begin(&memory, block, STACK_WORDS, ALGSURF_I_DECIDE_MEMORY);
    int done = in_integers(&memory, p, 0, &centre, &radius) &&
               algsurf_exact_radii_sign(&memory, &centre, &radius, 0, x, sign);
    algsurf_memory_release(&memory, begin);
    return done ? ALGSURF_OK : ALGSURF_E_NO_MEMORY;
}
