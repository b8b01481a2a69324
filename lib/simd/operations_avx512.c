/* operations_avx512.c - the operations of packets of eight, for AVX-512. */
#include "../base/arithmetic.h"
#include "operations.h"

#include "avx512.h"
#ifdef LANES
#include "operations_template.h"
#endif
#include "end.h"
