/* packet_avx512.c - rays in packets of eight, for AVX-512. */
#include "../base/arithmetic.h"
#include "packets.h"

#include "../simd/avx512.h"
#ifdef LANES
#include "packet_template.h"
#endif
#include "../simd/end.h"
