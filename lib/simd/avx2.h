/* avx2.h - packets of four for AVX2, to be included before a template; of two if the includer defines
 * PACKETS_OF_TWO, of eight floats if SINGLE; nothing on other processors, and with
 * ALGSURF_NO_AVX2.  The includer ends with end.h. */
#if defined(__x86_64__) && !defined(ALGSURF_NO_AVX2)
#include "unrolled.h"
#include "moves.h"

#if defined(PACKETS_OF_TWO)
#define LANES 2
#elif defined(SINGLE)
#define LANES 8
#else
#define LANES 4
#endif
#define KERNEL(name) name##_avx2
#if defined(__clang__)
#pragma clang attribute push(__attribute__((target("avx2"))), apply_to = function)
#else
#pragma GCC target("avx2")
#endif
#endif
