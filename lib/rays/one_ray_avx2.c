/* one_ray_avx2.c - single rays, for AVX2. */
#include "../base/arithmetic.h"
#include "packets.h"

#define PACKETS_OF_TWO
#include "../simd/avx2.h"
#ifdef LANES
#include "one_ray_template.h"
#endif
#include "../simd/end.h"
