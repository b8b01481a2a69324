/* shadows_baseline.c - shadow rays in packets of two, for every processor. */
#include "../base/arithmetic.h"
#include "shadow_kernel.h"

#include "../simd/baseline.h"
#include "shadows_template.h"
