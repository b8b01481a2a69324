/* kernels_avx512.c - rays of pictures in packets of eight, for AVX-512. */
#include "../base/arithmetic.h"
#include "../simd/avx512.h"
#ifdef LANES
#include "kernels_template.h"
#endif
#include "../simd/end.h"
