/* single_avx2.c - single rays, for AVX2. */
#include "../base/arithmetic.h"
#include "kernel.h"

#define PACKETS_OF_TWO
#include "../simd/avx2.h"
#ifdef LANES
#include "single_template.h"
#endif
#include "../simd/end.h"
