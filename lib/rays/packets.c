/* packets.c - the tables of kernels for rays. */
#include "../base/arithmetic.h"
#include "packets.h"

ALGSURF_KERNEL_CHOICE(rays)
ALGSURF_KERNEL_CHOICE(ray)
