/* single_avx512.c - rows of pictures in packets of 16 floats, for AVX-512. */
#include "../base/arithmetic.h"
#include "kernel.h"

#define SINGLE
#include "../simd/avx512.h"
#ifdef LANES
#include "kernel_template.h"
#endif
#include "../simd/end.h"
