/* packet_baseline.c - all complex roots in packets of two, for every processor. */
#include "../base/arithmetic.h"
#include "kernel.h"

#include "../simd/baseline.h"
#include "packet_template.h"
