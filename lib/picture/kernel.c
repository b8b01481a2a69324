/* kernel.c - the table of kernels for rows. */
#include "../base/arithmetic.h"
#include "kernel.h"

const algsurf_i_picture_kernel *algsurf_i_picture_kernel_for(const algsurf_i_kernel *kernel) {
    static const algsurf_i_picture_kernel *const table[ALGSURF_KERNELS] =
        ALGSURF_KERNEL_TABLE(&algsurf_i_picture);
    return table[kernel->index];
}

const algsurf_i_picture_kernel *algsurf_i_single_kernel_for(const algsurf_i_kernel *kernel) {
    static const algsurf_i_picture_kernel *const table[ALGSURF_KERNELS] =
        ALGSURF_KERNEL_TABLE(&algsurf_i_single);
    return table[kernel->index];
}
