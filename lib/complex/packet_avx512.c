/* packet_avx512.c - all complex roots in packets of eight, for AVX-512. */
#include "../base/arithmetic.h"
#include "kernel.h"

#include "../simd/avx512.h"
#ifdef LANES
#include "packet_template.h"
#endif
#include "../simd/end.h"
