/* polys.c - the table of kernels for roots. */
#include "../base/arithmetic.h"
#include "polys.h"

ALGSURF_KERNEL_CHOICE(roots)
