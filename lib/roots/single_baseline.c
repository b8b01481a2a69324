/* single_baseline.c - single polynomials, for every processor. */
#include "../base/arithmetic.h"
#include "polys.h"

#include "../simd/baseline.h"
#include "single_template.h"
