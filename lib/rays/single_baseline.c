/* single_baseline.c - single rays, for every processor. */
#include "../base/arithmetic.h"
#include "kernel.h"

#include "../simd/baseline.h"
#include "single_template.h"
