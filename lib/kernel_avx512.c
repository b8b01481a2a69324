/* kernel_avx512.c - packets of eight for AVX-512; nothing on other processors. */
#include "kernels/kernel.h"

#if defined(__x86_64__)
#if defined(__clang__)
#pragma clang attribute push(__attribute__((target("avx512f,avx512dq,avx512vl"))), apply_to = function)
#else
#pragma GCC target("avx512f,avx512dq,avx512vl")
#endif

#define LANES 8
#define KERNEL_NAME "avx512"
#include "kernels/kernel.inc"

#if defined(__clang__)
#pragma clang attribute pop
#endif

const algsurf_i_kernel *algsurf_i_kernel_avx512(void) { return &kernel; }
#endif
