/* packet_avx512.c - rays in packets of eight, for AVX-512. */
#include "../base/arithmetic.h"
#include "packets.h"

#include "../simd/avx512.h"
#ifdef LANES
#include "solve_rays_template.h"
#endif
#include "../simd/end.h"
