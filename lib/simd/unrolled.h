/* unrolled.h - kernels are compiled with -O3, whatever optimisation was asked for: only then does gcc unroll
 * the loops over the coefficients of a known degree early enough to keep these in registers, without which
 * pictures take 1.5 times as long.  Not where code is to be small, or debugged without any optimisation. */
#if defined(__OPTIMIZE__) && !defined(__OPTIMIZE_SIZE__) && !defined(__clang__)
#pragma GCC optimize("O3")
#endif
