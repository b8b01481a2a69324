/* packet_avx512.c - rays in packets of eight, for AVX-512. */
#include "../base/arithmetic.h"
#include "kernel.h"

#include "../simd/avx512.h"
#ifdef LANES
#include "kernel_template.h"
#endif
#include "../simd/end.h"
