/* shadows_avx512.c - shadow rays in packets of eight, for AVX-512. */
#include "../base/arithmetic.h"
#include "shadow_kernel.h"

#include "../simd/avx512.h"
#ifdef LANES
#include "shadows_template.h"
#endif
#include "../simd/end.h"
