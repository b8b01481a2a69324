/* single_avx2.c - single polynomials, for AVX2. */
#include "../base/arithmetic.h"
#include "polys.h"

#define PACKETS_OF_TWO
#include "../simd/avx2.h"
#ifdef LANES
#include "single_template.h"
#endif
#include "../simd/end.h"
