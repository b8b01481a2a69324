/* first_avx2.c - first roots of polynomials in packets of four, for AVX2. */
#include "../base/arithmetic.h"
#include "polys.h"

#include "../simd/avx2.h"
#ifdef LANES
#include "all_template.h"
#endif
#include "../simd/end.h"
