/* end.h - ends what avx512.h or avx2.h began. */
#if defined(LANES) && defined(__clang__)
#pragma clang attribute pop
#endif
