/* first_baseline.c - first roots of polynomials in packets of two, for every processor. */
#include "../base/arithmetic.h"
#include "polys.h"

#include "../simd/baseline.h"
#include "all_template.h"
