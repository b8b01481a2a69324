/* single_avx512.c - single polynomials, for AVX-512. */
#include "../base/arithmetic.h"
#include "polys.h"

#define PACKETS_OF_TWO
#include "../simd/avx512.h"
#ifdef LANES
#include "single_template.h"
#endif
#include "../simd/end.h"
