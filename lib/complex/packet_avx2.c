/* packet_avx2.c - all complex roots in packets of four, for AVX2. */
#include "../base/arithmetic.h"
#include "kernel.h"

#include "../simd/avx2.h"
#ifdef LANES
#include "packet_template.h"
#endif
#include "../simd/end.h"
