/* kernels_baseline.c - rays of pictures in packets of two, for every processor. */
#include "../base/arithmetic.h"
#include "../simd/baseline.h"
#include "kernels_template.h"
