/* decide.c - from doubles to integers, and the walks of exact.c and exact_radii.c over them.
 *
 * Infinite ends of an interval for polynomials with radii: a root is beyond the largest double T only if
 * |c_n| - r_n <= sum of (|c_k| + r_k) T^(k-n) over k < n; what may be there is an undecided place of its own.
 */
#include "decide.h"

#include <float.h>
#include <math.h>

#include "exact.h"
#include "exact_radii.h"

enum { STACK_WORDS = 2048 };

static algsurf_real_root root_of(const algsurf_exact_root *root) {
    return (algsurf_real_root){root->t, root->lo, root->hi, root->multiplicity, root->sign_before};
}

static algsurf_status walk(algsurf_memory *m, const algsurf_zpoly *p, int unit, double lo, double hi,
                           int most, algsurf_real_root *roots, int *count, int *cells) {
    algsurf_exact_walk walk;
    algsurf_exact_root root;
    int found = ALGSURF_EXACT_END;
    if (!algsurf_exact_begin(&walk, m, p, unit, lo, hi, 1)) return ALGSURF_E_NO_MEMORY;
    while (*count < most && (found = algsurf_exact_next(&walk, &root)) == ALGSURF_EXACT_ROOT)
        roots[(*count)++] = root_of(&root);
    if (cells) *cells += walk.counted;
    return found == ALGSURF_EXACT_NO_MEMORY ? ALGSURF_E_NO_MEMORY : ALGSURF_OK;
}

algsurf_status algsurf_i_decide_roots(const double *c, int degree, double lo, double hi, int first_only,
                                      algsurf_real_root *roots, int capacity, int *count, int *cells) {
    algsurf_limb block[STACK_WORDS];
    algsurf_memory memory;
    algsurf_zpoly p;
    int unit = isfinite(lo) && isfinite(hi) ? algsurf_exact_piece_of(lo, hi).unit : 0;
    *count = 0;
    algsurf_memory_begin(&memory, block, STACK_WORDS, ALGSURF_I_DECIDE_MEMORY);
    algsurf_memory_mark begin = algsurf_memory_here(&memory);
    algsurf_status status = ALGSURF_E_NO_MEMORY;
    if (algsurf_exact_from_doubles(&memory, c, degree, unit, &p))
        status = p.degree < 1
                     ? ALGSURF_OK
                     : walk(&memory, &p, unit, lo, hi, first_only ? 1 : capacity, roots, count, cells);
    algsurf_memory_release(&memory, begin);
    return status;
}

/* ---- radii ---- */

/* May some polynomial of the set have roots beyond the largest double? */
static int may_be_beyond(const algsurf_i_coefficients *p) {
    int n = p->degree, spare = 10; /* the sum of at most 512 terms, and roundings */
    double lead = fabs(p->c[n]) - p->r[n];
    if (!(lead > 0)) return 1;
    for (int k = 0; k < n; k++) {
        double size = fabs(p->c[k]) + p->r[k];
        if (size > 0 && ilogb(size) + 1 + spare - 1023 * (n - k) >= ilogb(lead)) return 1;
    }
    return 0;
}

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

static algsurf_bracket bracket_of(const algsurf_exact_range *range, int degree) {
    if (range->lo == range->hi)
        return (algsurf_bracket){range->lo, range->hi, ALGSURF_ROOT_EXACT, 0, degree, ALGSURF_OK};
    if (range->sign_lo)
        return (algsurf_bracket){range->lo, range->hi, ALGSURF_ROOT_BRACKET, range->sign_lo, 1, ALGSURF_OK};
    return (algsurf_bracket){range->lo, range->hi, ALGSURF_ROOT_UNDECIDED,
                             0,         degree,    ALGSURF_UNDECIDED_MULTIPLE};
}

static void add_beyond(algsurf_bracket *b, int capacity, int *count, double lo, double hi, int degree) {
    const algsurf_bracket beyond = {lo, hi, ALGSURF_ROOT_UNDECIDED, 0, degree, ALGSURF_UNDECIDED_RANGE};
    if (*count < capacity) {
        b[(*count)++] = beyond;
    } else {
        b[*count - 1] = (algsurf_bracket){b[*count - 1].lo,       hi, ALGSURF_ROOT_UNDECIDED, 0, degree,
                                          ALGSURF_UNDECIDED_RANGE};
    }
}

algsurf_status algsurf_i_decide_ranges(const algsurf_i_coefficients *p, double lo, double hi,
                                       algsurf_bracket *brackets, int capacity, int *count) {
    algsurf_limb block[STACK_WORDS];
    algsurf_memory memory;
    algsurf_zpoly centre, radius;
    algsurf_exact_range found[ALGSURF_MAX_POLY_DEGREE];
    double from = fmax(lo, -DBL_MAX), to = fmin(hi, DBL_MAX);
    int n = 0, beyond = (from > lo || to < hi) && may_be_beyond(p),
        unit = algsurf_exact_piece_of(from, to).unit;
    *count = 0;
    if (p->degree < 1) return ALGSURF_OK;
    algsurf_memory_begin(&memory, block, STACK_WORDS, ALGSURF_I_DECIDE_MEMORY);
    algsurf_memory_mark begin = algsurf_memory_here(&memory);
    int done = in_integers(&memory, p, unit, &centre, &radius) &&
               algsurf_exact_radii_isolate(&memory, &centre, &radius, unit, from, to, found, capacity, &n);
    algsurf_memory_release(&memory, begin);
    if (!done) return ALGSURF_E_NO_MEMORY;
    if (beyond && from > lo) add_beyond(brackets, capacity, count, lo, from, p->degree);
    for (int i = 0; i < n; i++) {
        algsurf_bracket b = bracket_of(found + i, p->degree);
        if (*count < capacity)
            brackets[(*count)++] = b;
        else
            add_beyond(brackets, capacity, count, b.lo, b.hi, p->degree);
    }
    if (beyond && to < hi) add_beyond(brackets, capacity, count, to, hi, p->degree);
    return ALGSURF_OK;
}
