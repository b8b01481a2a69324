/* kernel_avx2.c - rows of pictures in packets of four, for AVX2. */
#include "../base/arithmetic.h"
#include "kernel.h"

#include "../simd/avx2.h"
#ifdef LANES
#include "kernel_template.h"
#endif
#include "../simd/end.h"
