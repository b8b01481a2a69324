/* kernel.c - the table of kernels for rays. */
#include "../base/arithmetic.h"
#include "kernel.h"

ALGSURF_KERNEL_CHOICE(rays)
ALGSURF_KERNEL_CHOICE(ray)
