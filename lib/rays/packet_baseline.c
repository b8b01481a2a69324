/* packet_baseline.c - rays in packets of two, and single ones, for every processor. */
#include "kernel.h"

#include "../simd/baseline.h"
#include "packet_template.h"
#include "single_template.h"
