/* kernels.c - the table of kernels for beams. */
#include "../base/arithmetic.h"
#include "kernels.h"

ALGSURF_KERNEL_CHOICE(beams)
