/* kernel_avx2.c - packets of four for AVX2; nothing on other processors. */
#include "kernels/kernel.h"

#if defined(__x86_64__)
#if defined(__clang__)
#pragma clang attribute push(__attribute__((target("avx2"))), apply_to = function)
#else
#pragma GCC target("avx2")
#endif

#define LANES 4
#define KERNEL_NAME "avx2"
#include "kernels/kernel.inc"

#if defined(__clang__)
#pragma clang attribute pop
#endif

const algsurf_i_kernel *algsurf_i_kernel_avx2(void) { return &kernel; }
#endif
