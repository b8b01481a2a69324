/* single_avx512.c - single rays, for AVX-512. */
#include "../base/arithmetic.h"
#include "kernel.h"

#define PACKETS_OF_TWO
#include "../simd/avx512.h"
#ifdef LANES
#include "single_template.h"
#endif
#include "../simd/end.h"
