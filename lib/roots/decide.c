/* decide.c - from doubles to integers, and the walk of exact.c over them. */
#include "decide.h"

#include <math.h>

#include "exact.h"

enum { STACK_WORDS = 2048 };

static algsurf_real_root root_of(const algsurf_exact_root *root) {
    return (algsurf_real_root){root->t, root->lo, root->hi, root->multiplicity, root->sign_before};
}

static algsurf_status walk(algsurf_memory *m, const algsurf_zpoly *p, int unit, double lo, double hi, int most,
                           algsurf_real_root *roots, int *count, int *cells) {
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
        status = p.degree < 1 ? ALGSURF_OK
                              : walk(&memory, &p, unit, lo, hi, first_only ? 1 : capacity, roots, count, cells);
    algsurf_memory_release(&memory, begin);
    return status;
}
