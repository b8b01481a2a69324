/* kernel.c - the tables of kernels for rows, colours and shadows. */
#include "../base/arithmetic.h"
#include "shadow_kernel.h"

const algsurf_i_picture_kernel *algsurf_i_picture_kernel_for(const algsurf_i_kernel *kernel) {
    static const algsurf_i_picture_kernel *const table[ALGSURF_KERNELS] =
        ALGSURF_KERNEL_TABLE(&algsurf_i_picture);
    return table[kernel->index];
}

const algsurf_i_colour_kernel *algsurf_i_colour_kernel_for(const algsurf_i_kernel *kernel) {
    static const algsurf_i_colour_kernel *const table[ALGSURF_KERNELS] =
        ALGSURF_KERNEL_TABLE(&algsurf_i_colour);
    return table[kernel->index];
}

const algsurf_i_shadow_kernel *algsurf_i_shadow_kernel_for(const algsurf_i_kernel *kernel) {
    static const algsurf_i_shadow_kernel *const table[ALGSURF_KERNELS] =
        ALGSURF_KERNEL_TABLE(&algsurf_i_shadow);
    return table[kernel->index];
}
