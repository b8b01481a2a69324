/* shadows_avx2.c - shadow rays in packets of four, for AVX2. */
#include "../base/arithmetic.h"
#include "shadow_kernel.h"

#include "../simd/avx2.h"
#ifdef LANES
#include "shadows_template.h"
#endif
#include "../simd/end.h"
