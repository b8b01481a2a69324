/* single_baseline.c - rows of pictures in packets of four floats, for any machine. */
#include "../base/arithmetic.h"
#include "kernel.h"

#define SINGLE
#include "../simd/baseline.h"
#include "kernel_template.h"
