/* packet_baseline.c - rays in packets of two, single ones, too, for every processor. */
#include "../base/arithmetic.h"
#include "kernel.h"

#include "../simd/baseline.h"
#include "kernel_template.h"
#include "single_template.h"
