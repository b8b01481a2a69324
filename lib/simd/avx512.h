/* avx512.h - packets of eight for AVX-512, to be included before a template; of two if the includer defines
 * PACKETS_OF_TWO, of 16 floats if SINGLE; nothing on other processors, and with
 * ALGSURF_NO_AVX512.  The includer ends with end.h. */
#if defined(__x86_64__) && !defined(ALGSURF_NO_AVX512)
#include "unrolled.h"
#include "moves.h"

#if defined(PACKETS_OF_TWO)
#define LANES 2
#elif defined(SINGLE)
#define LANES 16
#else
#define LANES 8
#endif
#define KERNEL(name) name##_avx512
#if defined(__clang__)
#pragma clang attribute push(__attribute__((target("avx512f,avx512dq,avx512vl"))), apply_to = function)
#else
#pragma GCC target("avx512f,avx512dq,avx512vl")
#endif
#endif
