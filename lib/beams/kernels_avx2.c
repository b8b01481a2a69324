/* kernels_avx2.c - rays of pictures in packets of four, for AVX2. */
#include "../base/arithmetic.h"
#include "../simd/avx2.h"
#ifdef LANES
#include "kernels_template.h"
#endif
#include "../simd/end.h"
