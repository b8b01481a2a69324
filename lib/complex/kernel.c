/* kernel.c - the table of kernels for complex roots. */
#include "../base/arithmetic.h"
#include "kernel.h"

const algsurf_i_allroots_kernel *algsurf_i_allroots_kernel_for(const algsurf_i_kernel *kernel) {
    static const algsurf_i_allroots_kernel *const table[ALGSURF_KERNELS] =
        ALGSURF_KERNEL_TABLE(&algsurf_i_allroots);
    return table[kernel->index];
}
