/* fpenv.h - a known floating-point environment for the length of one call.
 *
 * Every bound in this library assumes IEEE 754 double arithmetic, rounding to nearest, gradual
 * underflow, no traps.  A host may have set another rounding mode or flush-to-zero; each public
 * entry point therefore brackets its work:
 *     algsurf_fpenv saved; algsurf_fpenv_enter(&saved); ... algsurf_fpenv_leave(&saved);
 * which also leaves the caller's exception flags as they were.  About 5 ns when nothing needs to
 * change.  The work itself belongs in a function of its own, so that the compiler cannot move
 * arithmetic across the switch.
 *
 * Checks are work: comparing a NaN raises a flag, isfinite() of a signalling one or of a subnormal number
 * too, and either may trap.  Before entering and after leaving, a public function looks at pointers and
 * integers, and copies doubles, no more; tests/test_every_call.c holds each of them to that.
 */
#ifndef ALGSURF_FPENV_H
#define ALGSURF_FPENV_H
#include <float.h>

#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) ||               \
    (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error "libalgsurf proves its results: -ffast-math and what belongs to it break the proofs"
#endif
#if defined(FLT_EVAL_METHOD) && FLT_EVAL_METHOD != 0
#error "libalgsurf needs doubles evaluated as doubles (on i386: -msse2 -mfpmath=sse)"
#endif

#if defined(__SSE2__) || defined(__x86_64__)
#include <xmmintrin.h>
typedef unsigned algsurf_fpenv;
#define ALGSURF_MXCSR_STANDARD 0x1f80u /* all exceptions masked, nearest, FTZ and DAZ off */
#define ALGSURF_MXCSR_CONTROL 0xffc0u  /* everything but the six sticky flags */
static inline void algsurf_fpenv_enter(algsurf_fpenv *saved) {
    *saved = _mm_getcsr();
    if ((*saved & ALGSURF_MXCSR_CONTROL) != ALGSURF_MXCSR_STANDARD) _mm_setcsr(ALGSURF_MXCSR_STANDARD);
    __asm__ volatile("" ::: "memory");
}
static inline void algsurf_fpenv_leave(const algsurf_fpenv *saved) {
    __asm__ volatile("" ::: "memory");
    _mm_setcsr(*saved);
}
#elif defined(__aarch64__)
typedef struct {
    unsigned long long fpcr, fpsr;
} algsurf_fpenv;
static inline void algsurf_fpenv_enter(algsurf_fpenv *saved) {
    __asm__ volatile("mrs %0, fpcr" : "=r"(saved->fpcr)::"memory");
    __asm__ volatile("mrs %0, fpsr" : "=r"(saved->fpsr)::"memory");
    if (saved->fpcr != 0) __asm__ volatile("msr fpcr, %0" ::"r"(0ull) : "memory");
}
static inline void algsurf_fpenv_leave(const algsurf_fpenv *saved) {
    __asm__ volatile("msr fpsr, %0" ::"r"(saved->fpsr) : "memory");
    if (saved->fpcr != 0) __asm__ volatile("msr fpcr, %0" ::"r"(saved->fpcr) : "memory");
}
#else
#include <fenv.h>
typedef fenv_t algsurf_fpenv;
static inline void algsurf_fpenv_enter(algsurf_fpenv *saved) {
    (void)feholdexcept(saved);
    (void)fesetround(FE_TONEAREST);
}
static inline void algsurf_fpenv_leave(const algsurf_fpenv *saved) { (void)fesetenv(saved); }
#endif

/* A function the compiler must not inline: the work between enter and leave. */
#if defined(__GNUC__) || defined(__clang__)
#define ALGSURF_NOINLINE __attribute__((noinline))
#else
#define ALGSURF_NOINLINE
#endif

#endif
