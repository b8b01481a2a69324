/* kernel.c - the table of kernels for rays. */
#include "kernel.h"

algsurf_i_rays_kernel *algsurf_i_rays_kernel_for(const algsurf_i_kernel *kernel) {
    static algsurf_i_rays_kernel *const table[ALGSURF_KERNELS] = ALGSURF_KERNEL_TABLE(algsurf_i_rays);
    return table[kernel->index];
}
