/* environments.h - the floating-point environments a caller may have set, for tests that nothing of them
 * shows in results and that they come back unchanged. */
#ifndef ENVIRONMENTS_H
#define ENVIRONMENTS_H
#include <fenv.h>

#include "unit.h"

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif
#if defined(__i386__) ||                                                                                     \
    defined(_WIN32) /* where libm, or the return of a double, goes through the x87 unit */
#define ENVIRONMENT_X87 1
#else
#define ENVIRONMENT_X87 0
#endif

enum {
    ENVIRONMENTS = 8
}; /* 4 rounding modes, gradual underflow or (x86, ARM) flush to zero; 0: the usual one */

/* The control word of the x87 unit, where C computes nothing but where results pass through. */
static inline unsigned environment_x87(void) {
    unsigned short word = 0x37f;
#if ENVIRONMENT_X87
    __asm__ volatile("fnstcw %0" : "=m"(word));
#endif
    return word;
}

static const int environment_modes[4] = {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};

/* Subnormal results and operands become zero, or not; where it counts, the x87 unit rounds to 24 bits with
 * it.  On other processors nothing happens. */
static inline void environment_flush(int flush) {
#if defined(__SSE2__)
    _mm_setcsr((_mm_getcsr() & ~0x8040u) | (flush ? 0x8040u : 0u));
#if ENVIRONMENT_X87
    unsigned short word = (unsigned short)((environment_x87() & ~0x300u) | (flush ? 0u : 0x300u));
    __asm__ volatile("fldcw %0" ::"m"(word));
#endif
#elif defined(__aarch64__)
    unsigned long long fpcr;
    __asm__ volatile("mrs %0, fpcr" : "=r"(fpcr));
    fpcr = (fpcr & ~(1ull << 24)) | ((unsigned long long)flush << 24);
    __asm__ volatile("msr fpcr, %0" ::"r"(fpcr));
#elif defined(__arm__) && defined(__ARM_FP)
    unsigned fpscr;
    __asm__ volatile("vmrs %0, fpscr" : "=r"(fpscr));
    fpscr = (fpscr & ~(1u << 24)) | ((unsigned)flush << 24);
    __asm__ volatile("vmsr fpscr, %0" ::"r"(fpscr));
#else
    (void)flush;
#endif
}

/* Does it flush as it should? */
static inline int environment_flushes(int flush) {
#if defined(__SSE2__)
    unsigned narrow = flush && ENVIRONMENT_X87 ? 0u : 0x300u;
    return (_mm_getcsr() & 0x8040u) == (flush ? 0x8040u : 0u) && (environment_x87() & 0x300u) == narrow;
#elif defined(__aarch64__)
    unsigned long long fpcr;
    __asm__ volatile("mrs %0, fpcr" : "=r"(fpcr));
    return (int)(fpcr >> 24 & 1) == flush;
#elif defined(__arm__) && defined(__ARM_FP)
    unsigned fpscr;
    __asm__ volatile("vmrs %0, fpscr" : "=r"(fpscr));
    return (int)(fpscr >> 24 & 1) == flush;
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

/* What work writes has the same bits in every environment, which is there afterwards. */
static inline void environments_agree(void (*work)(void *answers), size_t size) {
    void *usual = calloc(1, size), *here = calloc(1, size);
    assert_true(usual != NULL && here != NULL);
    work(usual);
    for (int i = 1; i < ENVIRONMENTS; i++) {
        memset(here, 0, size);
        environment_set(i);
        work(here);
        int kept = environment_unset(i);
        assert_true(kept);
        assert_memory_equal(here, usual, size);
    }
    free(usual), free(here);
}

#endif
