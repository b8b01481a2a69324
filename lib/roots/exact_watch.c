/* exact_watch.c - a cell of the integers, as an observer sees it.
 *
 * In memory of its own: watching leaves the walk's as it is. */
#include "../base/arithmetic.h"
#include "algsurf/status.h"
#include "decide.h"
#include "exact_cell.h"

enum { STACK_WORDS = 64 };

int algsurf_exact_tell_cell(const algsurf_exact_cells *cells, const algsurf_exact_cell *cell) {
    algsurf_limb block[STACK_WORDS], *a, *b;
    algsurf_memory memory;
    int width, r, n = cell->b.degree;
    signed char signs[ALGSURF_MAX_POLY_DEGREE + 1];
    algsurf_memory_begin(&memory, block, STACK_WORDS, ALGSURF_I_DECIDE_MEMORY);
    algsurf_memory_mark begin = algsurf_memory_here(&memory);
    int done = algsurf_exact_cell_ends(&memory, cell, &cells->piece, cells->unit, &a, &b, &width, &r);
    for (int j = 0; j <= n; j++) signs[j] = (signed char)algsurf_exact_sign(cell, j);
    if (done) {
        const algsurf_cell told = {.lo = algsurf_z_round_down(a, width, cells->unit - r),
                                   .hi = algsurf_z_round_down(b, width, cells->unit - r),
                                   .variations = cell->variations,
                                   .engine = ALGSURF_ENGINE_INTEGERS,
                                   .degree = n,
                                   .signs = signs};
        algsurf_i_tell_cell(cells->watch, &told);
    }
    algsurf_memory_release(&memory, begin);
    return done;
}
