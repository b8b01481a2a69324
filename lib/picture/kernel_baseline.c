/* kernel_baseline.c - rows of pictures in packets of two, for every processor. */
#include "../base/arithmetic.h"
#include "kernel.h"

#include "../simd/baseline.h"
#include "kernel_template.h"
