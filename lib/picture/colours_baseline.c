/* colours_baseline.c - colours of points in packets of four floats, for any machine. */
#include "../base/arithmetic.h"
#include "colours.h"

#define SINGLE
#include "../simd/baseline.h"
#include "colours_template.h"
