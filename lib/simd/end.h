/* end.h - ends what avx512.h or avx2.h began. */
#if defined(__x86_64__) && defined(__clang__)
#pragma clang attribute pop
#endif
