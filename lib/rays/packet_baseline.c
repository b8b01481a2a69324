/* packet_baseline.c - rays in packets of two, single ones, too, for every processor. */
#include "../base/arithmetic.h"
#include "packets.h"

#include "../simd/baseline.h"
#include "one_ray_template.h"
#include "packet_template.h"
