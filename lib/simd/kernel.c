/* kernel.c - which kernel this machine can run. */
#include "../base/arithmetic.h"
#include "kernel.h"

#include <stddef.h>
#include <string.h>

const algsurf_i_kernel *algsurf_i_kernel_at(int index) {
    static const algsurf_i_kernel kernels[ALGSURF_KERNELS] = {
        {"avx512", ALGSURF_AVX512}, {"avx2", ALGSURF_AVX2}, {"baseline", ALGSURF_BASELINE}};
    const algsurf_i_kernel *usable[ALGSURF_KERNELS];
    int count = 0;
#if defined(__x86_64__)
    __builtin_cpu_init(); /* asks the processor, and the operating system for the registers it saves */
#ifndef ALGSURF_NO_AVX512
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
        __builtin_cpu_supports("avx512vl"))
        usable[count++] = kernels + ALGSURF_AVX512;
#endif
#ifndef ALGSURF_NO_AVX2
    if (__builtin_cpu_supports("avx2")) usable[count++] = kernels + ALGSURF_AVX2;
#endif
#endif
    usable[count++] = kernels + ALGSURF_BASELINE;
    return index >= 0 && index < count ? usable[index] : NULL;
}

const algsurf_i_kernel *algsurf_i_kernel_find(const char *name) {
    const algsurf_i_kernel *kernel;
    for (int i = 0; (kernel = algsurf_i_kernel_at(i)); i++)
        if (!name || strcmp(name, kernel->name) == 0) return kernel;
    return NULL;
}
