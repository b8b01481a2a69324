/* boxes.c - the table of kernels for complex roots. */
#include "../base/arithmetic.h"
#include "boxes.h"

ALGSURF_KERNEL_CHOICE(allroots)
