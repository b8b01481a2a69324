/* colours_avx2.c - colours of points in packets of eight floats, for AVX2. */
#include "../base/arithmetic.h"
#include "colours.h"

#define SINGLE
#include "../simd/avx2.h"
#ifdef LANES
#include "colours_template.h"
#endif
#include "../simd/end.h"
