/* environments.h - the floating-point environments a caller may have set, for tests that nothing of them
 * shows in results and that they come back unchanged. */
#ifndef ENVIRONMENTS_H
#define ENVIRONMENTS_H
#include <fenv.h>

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

enum {
    ENVIRONMENTS = 8
}; /* 4 rounding modes, gradual underflow or (x86, ARM) flush to zero; 0: the usual one */

static const int environment_modes[4] = {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};

/* Subnormal results and operands become zero, or not.  On other processors nothing happens. */
static inline void environment_flush(int flush) {
#if defined(__SSE2__)
    _mm_setcsr((_mm_getcsr() & ~0x8040u) | (flush ? 0x8040u : 0u));
#elif defined(__aarch64__)
    unsigned long long fpcr;
    __asm__ volatile("mrs %0, fpcr" : "=r"(fpcr));
    fpcr = (fpcr & ~(1ull << 24)) | ((unsigned long long)flush << 24);
    __asm__ volatile("msr fpcr, %0" ::"r"(fpcr));
#else
    (void)flush;
#endif
}

/* Does it flush as it should? */
static inline int environment_flushes(int flush) {
#if defined(__SSE2__)
    return (_mm_getcsr() & 0x8040u) == (flush ? 0x8040u : 0u);
#elif defined(__aarch64__)
    unsigned long long fpcr;
    __asm__ volatile("mrs %0, fpcr" : "=r"(fpcr));
    return (int)(fpcr >> 24 & 1) == flush;
#else
    (void)flush;
    return 1;
#endif
}

/* Sets environment i. */
static inline void environment_set(int i) {
    (void)feclearexcept(FE_ALL_EXCEPT);
    (void)fesetround(environment_modes[i % 4]);
    environment_flush(i >= 4);
}

/* Back to the usual one; 1 if environment i was still there, exception flags included. */
static inline int environment_unset(int i) {
    int same = fegetround() == environment_modes[i % 4] && fetestexcept(FE_ALL_EXCEPT) == 0 &&
               environment_flushes(i >= 4);
    environment_set(0);
    return same;
}

#endif
