/* operations_avx2.c - the operations of packets of four, for AVX2. */
#include "../base/arithmetic.h"
#include "operations.h"

#include "avx2.h"
#ifdef LANES
#include "operations_template.h"
#endif
#include "end.h"
