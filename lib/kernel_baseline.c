/* kernel_baseline.c - packets of two: what every 64-bit x86 (SSE2) and ARM (NEON) processor has. */
#include "kernels/kernel.h"

#define LANES 2
#define KERNEL_NAME "baseline"
#include "kernels/kernel.inc"

const algsurf_i_kernel *algsurf_i_kernel_baseline(void) { return &kernel; }
