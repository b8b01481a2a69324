/* kernel.c - the table of kernels for first roots. */
#include "kernel.h"

const algsurf_i_roots_kernel *algsurf_i_roots_kernel_for(const algsurf_i_kernel *kernel) {
    static const algsurf_i_roots_kernel *const table[ALGSURF_KERNELS] =
        ALGSURF_KERNEL_TABLE(&algsurf_i_roots);
    return table[kernel->index];
}
