/* one_ray_avx512.c - single rays, for AVX-512. */
#include "../base/arithmetic.h"
#include "packets.h"

#define PACKETS_OF_TWO
#include "../simd/avx512.h"
#ifdef LANES
#include "one_ray_template.h"
#endif
#include "../simd/end.h"
