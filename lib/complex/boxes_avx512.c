/* boxes_avx512.c - all complex roots in packets of eight, for AVX-512. */
#include "../base/arithmetic.h"
#include "boxes.h"

#include "../simd/avx512.h"
#ifdef LANES
#include "all_boxes_template.h"
#endif
#include "../simd/end.h"
