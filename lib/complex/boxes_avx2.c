/* boxes_avx2.c - all complex roots in packets of four, for AVX2. */
#include "../base/arithmetic.h"
#include "boxes.h"

#include "../simd/avx2.h"
#ifdef LANES
#include "all_boxes_template.h"
#endif
#include "../simd/end.h"
