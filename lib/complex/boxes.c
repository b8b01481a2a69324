/* boxes.c - the table of kernels for complex roots, by itself: test_self_test puts another in its place. */
#include "../base/arithmetic.h"
#include "boxes.h"

ALGSURF_KERNEL_CHOICE(allroots)
