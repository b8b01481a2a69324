/* kernel.c - the table of kernels for complex roots. */
#include "../base/arithmetic.h"
#include "kernel.h"

ALGSURF_KERNEL_CHOICE(allroots)
