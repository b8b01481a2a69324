/* polys.c - the tables of kernels for roots. */
#include "../base/arithmetic.h"
#include "polys.h"

ALGSURF_KERNEL_CHOICE(roots)

algsurf_i_roots_single *algsurf_i_roots_single_fastest(void) {
    static algsurf_i_roots_single *const table[ALGSURF_KERNELS] =
        ALGSURF_KERNEL_TABLE(algsurf_i_roots_single);
    return table[algsurf_i_kernel_find(NULL)->index];
}

algsurf_i_roots_settle *algsurf_i_roots_settle_fastest(void) {
    static algsurf_i_roots_settle *const table[ALGSURF_KERNELS] =
        ALGSURF_KERNEL_TABLE(algsurf_i_roots_settle);
    return table[algsurf_i_kernel_find(NULL)->index];
}
