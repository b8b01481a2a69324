/* colours_avx512.c - colours of points in packets of 16 floats, for AVX-512. */
#include "../base/arithmetic.h"
#include "colours.h"

#define SINGLE
#include "../simd/avx512.h"
#ifdef LANES
#include "colours_template.h"
#endif
#include "../simd/end.h"
