/* environments.h - the floating-point environments a caller may have set, for tests that nothing of them
 * shows in results and that they come back unchanged. */
#ifndef ENVIRONMENTS_H
#define ENVIRONMENTS_H
#include <fenv.h>

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

enum { ENVIRONMENTS = 8 }; /* 4 rounding modes, gradual underflow or (x86) FTZ and DAZ; 0: the usual one */

static const int environment_modes[4] = {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};

/* Sets environment i. */
static inline void environment_set(int i) {
    (void)feclearexcept(FE_ALL_EXCEPT);
    (void)fesetround(environment_modes[i % 4]);
#if defined(__SSE2__)
    _mm_setcsr((_mm_getcsr() & ~0x8040u) | (i >= 4 ? 0x8040u : 0u));
#endif
}

/* Back to the usual one; 1 if environment i was still there, exception flags included. */
static inline int environment_unset(int i) {
    int same = fegetround() == environment_modes[i % 4] && fetestexcept(FE_ALL_EXCEPT) == 0;
#if defined(__SSE2__)
    same = same && (_mm_getcsr() & 0x8040u) == (i >= 4 ? 0x8040u : 0u);
#endif
    environment_set(0);
    return same;
}

#endif
