/* boxes_baseline.c - all complex roots in packets of two, for every processor. */
#include "../base/arithmetic.h"
#include "boxes.h"

#include "../simd/baseline.h"
#include "all_boxes_template.h"
