/* kernel.c - the table of kernels for rays. */
#include "../base/arithmetic.h"
#include "kernel.h"

const algsurf_i_rays_kernel *algsurf_i_rays_kernel_for(const algsurf_i_kernel *kernel) {
    static const algsurf_i_rays_kernel *const table[ALGSURF_KERNELS] = ALGSURF_KERNEL_TABLE(&algsurf_i_rays);
    return table[kernel->index];
}

const algsurf_i_ray_kernel *algsurf_i_ray_kernel_for(const algsurf_i_kernel *kernel) {
    static const algsurf_i_ray_kernel *const table[ALGSURF_KERNELS] = ALGSURF_KERNEL_TABLE(&algsurf_i_ray);
    return table[kernel->index];
}
