/* first_avx512.c - first roots of polynomials in packets of eight, for AVX-512. */
#include "../base/arithmetic.h"
#include "polys.h"

#include "../simd/avx512.h"
#ifdef LANES
#include "all_template.h"
#endif
#include "../simd/end.h"
