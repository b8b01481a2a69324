/* packet_avx2.c - rays in packets of four, for AVX2. */
#include "../base/arithmetic.h"
#include "packets.h"

#include "../simd/avx2.h"
#ifdef LANES
#include "packet_template.h"
#endif
#include "../simd/end.h"
