/* polys.c - the table of kernels for roots, by itself: test_self_test puts another in its place. */
#include "../base/arithmetic.h"
#include "polys.h"

ALGSURF_KERNEL_CHOICE(roots)
