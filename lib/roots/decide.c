/* decide.c - from doubles to integers, and the walks of exact.c and exact_radii.c over them.
 *
 * For polynomials with radii the interval is first cut where no root can be: |t| <= 2 max |c_k /
 * c_n|^(1/(n-k)) for all roots (Fujiwara 1916), with the largest |c_k| and the least |c_n| of the set.  Where
 * that is beyond the largest double, or c_n may vanish, what is beyond it is an undecided place of its own.
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

static int quotient_up(int a, int b) { return a > 0 ? (a + b - 1) / b : -(-a / b); }

/* An exponent e so that |t| <= 2^e for all roots of the set; above 1023 if there is none.  |c_k| is below
 * 2^(i+2), i the exponent of the larger one of |c_k| and r_k; the difference that is least |c_n|, rounded, is
 * at most twice too large. */
static int root_bound(const algsurf_i_coefficients *p) {
    int n = p->degree, bound = -1000;
    double lead = fabs(p->c[n]) - p->r[n];
    if (!(lead > 0)) return 1024;
    for (int k = 0; k < n; k++) {
        double size = fmax(fabs(p->c[k]), p->r[k]);
        int e = size > 0 ? quotient_up(ilogb(size) + 3 - ilogb(lead), n - k) : bound;
        if (e > bound) bound = e;
    }
    return bound + 1;
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

/* A range's bracket.  With lo = hi, a root only where all of the set vanish. */
static algsurf_bracket bracket_of(const algsurf_i_coefficients *p, const algsurf_exact_range *range) {
    algsurf_bracket b = {range->lo, range->hi, ALGSURF_ROOT_UNDECIDED,
                         0,         p->degree, ALGSURF_UNDECIDED_MULTIPLE};
    if (b.lo == b.hi && algsurf_i_sign_at(p, b.lo) == 0) {
        b.kind = ALGSURF_ROOT_EXACT;
        b.status = ALGSURF_OK;
    } else if (b.lo == b.hi) {
        b.status = ALGSURF_UNDECIDED_ZERO;
    } else if (range->sign_lo) {
        b = (algsurf_bracket){b.lo, b.hi, ALGSURF_ROOT_BRACKET, range->sign_lo, 1, ALGSURF_OK};
    }
    return b;
}

static algsurf_bracket beyond(double lo, double hi, int degree) {
    return (algsurf_bracket){lo, hi, ALGSURF_ROOT_UNDECIDED, 0, degree, ALGSURF_UNDECIDED_RANGE};
}

/* Appends an entry; undecided ones that touch become one, and the last one takes what there is no room for.
 */
static void add(algsurf_bracket *b, int capacity, int *count, const algsurf_bracket *entry, int degree) {
    algsurf_bracket *last = b + *count - 1;
    int touch = *count > 0 && last->hi == entry->lo && last->kind == ALGSURF_ROOT_UNDECIDED &&
                entry->kind == ALGSURF_ROOT_UNDECIDED;
    if (!touch && *count < capacity) {
        b[(*count)++] = *entry;
        return;
    }
    algsurf_status status = last->status != ALGSURF_OK ? last->status : entry->status;
    if (status == ALGSURF_OK) status = ALGSURF_UNDECIDED_MULTIPLE;
    *last = (algsurf_bracket){last->lo, entry->hi, ALGSURF_ROOT_UNDECIDED, 0, degree, status};
}

/* The ranges in [from,to], which is finite. */
static algsurf_status find_ranges(const algsurf_i_coefficients *p, double from, double to,
                                  algsurf_exact_range *found, int capacity, int *count) {
    algsurf_limb block[STACK_WORDS];
    algsurf_memory memory;
    algsurf_zpoly centre, radius;
    int unit = algsurf_exact_piece_of(from, to).unit;
    algsurf_memory_begin(&memory, block, STACK_WORDS, ALGSURF_I_DECIDE_MEMORY);
    algsurf_memory_mark begin = algsurf_memory_here(&memory);
    int done = in_integers(&memory, p, unit, &centre, &radius) &&
               algsurf_exact_radii_isolate(&memory, &centre, &radius, unit, from, to, found, capacity, count);
    algsurf_memory_release(&memory, begin);
    return done ? ALGSURF_OK : ALGSURF_E_NO_MEMORY;
}

algsurf_status algsurf_i_decide_ranges(const algsurf_i_coefficients *p, double lo, double hi,
                                       algsurf_bracket *brackets, int capacity, int *count) {
    algsurf_exact_range found[ALGSURF_MAX_POLY_DEGREE];
    *count = 0;
    if (p->degree < 1) return ALGSURF_OK;
    int n = 0, bound = root_bound(p), open = bound > 1023;
    double most = open ? DBL_MAX : ldexp(1, bound), from = fmax(lo, -most), to = fmin(hi, most);
    if (from > to) return ALGSURF_OK;
    const algsurf_bracket below = beyond(lo, from, p->degree), above = beyond(to, hi, p->degree);
    algsurf_status status = find_ranges(p, from, to, found, capacity, &n);
    if (status != ALGSURF_OK) return status;
    if (open && from > lo) add(brackets, capacity, count, &below, p->degree);
    for (int i = 0; i < n; i++) {
        algsurf_bracket b = bracket_of(p, found + i);
        add(brackets, capacity, count, &b, p->degree);
    }
    if (open && to < hi) add(brackets, capacity, count, &above, p->degree);
    return ALGSURF_OK;
}
