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

#if defined(__SSE2__) || defined(__x86_64__)
#include <xmmintrin.h>
#define ALGSURF_MXCSR_STANDARD 0x1f80u /* all exceptions masked, nearest, FTZ and DAZ off */
#define ALGSURF_MXCSR_CONTROL 0xffc0u  /* everything but the six sticky flags */
#if defined(__i386__) || defined(_WIN32)
/* The x87 unit: 32-bit functions return doubles through it, and libm computes there, on Windows also in 64
 * bits, where a new thread starts with a precision of 53 bits.  All exceptions masked, nearest, 64 bits.  Its
 * stack has to be empty meanwhile, which the clobbers ask for. */
#define ALGSURF_X87_STANDARD 0x37f
#define ALGSURF_X87_STACK "st", "st(1)", "st(2)", "st(3)", "st(4)", "st(5)", "st(6)", "st(7)"
#endif
typedef struct {
    unsigned mxcsr;
#ifdef ALGSURF_X87_STANDARD
    unsigned x87[7];
#endif
} algsurf_fpenv;
static inline void algsurf_fpenv_enter(algsurf_fpenv *saved) {
    saved->mxcsr = _mm_getcsr();
    if ((saved->mxcsr & ALGSURF_MXCSR_CONTROL) != ALGSURF_MXCSR_STANDARD) _mm_setcsr(ALGSURF_MXCSR_STANDARD);
#ifdef ALGSURF_X87_STANDARD
    const unsigned short standard = ALGSURF_X87_STANDARD;
    __asm__ volatile("fnstenv %0" : "=m"(saved->x87)::ALGSURF_X87_STACK);
    __asm__ volatile("fldcw %0" ::"m"(standard));
#endif
    __asm__ volatile("" ::: "memory");
}
static inline void algsurf_fpenv_leave(const algsurf_fpenv *saved) {
    __asm__ volatile("" ::: "memory");
#ifdef ALGSURF_X87_STANDARD
    __asm__ volatile("fldenv %0" ::"m"(saved->x87) : ALGSURF_X87_STACK);
#endif
    _mm_setcsr(saved->mxcsr);
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
#elif defined(__arm__) && defined(__ARM_FP)
typedef unsigned algsurf_fpenv;
#define ALGSURF_FPSCR_CONTROL 0x07ff9f00u /* default NaN, flush-to-zero, rounding, vectors, traps */
static inline void algsurf_fpenv_enter(algsurf_fpenv *saved) {
    __asm__ volatile("vmrs %0, fpscr" : "=r"(*saved)::"memory");
    if (*saved & ALGSURF_FPSCR_CONTROL) __asm__ volatile("vmsr fpscr, %0" ::"r"(0u) : "memory");
}
static inline void algsurf_fpenv_leave(const algsurf_fpenv *saved) {
    __asm__ volatile("vmsr fpscr, %0" ::"r"(*saved) : "memory");
}
#else
/* Machines that flush no double to zero (riscv64, ppc64le, s390x), or have no modes at all (WebAssembly). */
#include <fenv.h>
typedef fenv_t algsurf_fpenv;
static inline void algsurf_fpenv_enter(algsurf_fpenv *saved) {
    (void)feholdexcept(saved);
    (void)fesetround(FE_TONEAREST);
}
static inline void algsurf_fpenv_leave(const algsurf_fpenv *saved) { (void)fesetenv(saved); }
#endif

/* A function the compiler must not inline: the work between enter and leave. */
#define ALGSURF_NOINLINE __attribute__((noinline))

/* The statement, in the standard environment: a call of a function that is not inlined. */
#define ALGSURF_STANDARD(...)                                                                                \
    do {                                                                                                     \
        algsurf_fpenv caller_environment;                                                                    \
        algsurf_fpenv_enter(&caller_environment);                                                            \
        __VA_ARGS__;                                                                                         \
        algsurf_fpenv_leave(&caller_environment);                                                            \
    } while (0)

/* Begins the definition of the public function algsurf_<name>(parameters): its body, which comes next, runs
 * in the standard environment. */
#define ALGSURF_I_ENTRY(type, name, parameters, arguments)                                                   \
    static ALGSURF_NOINLINE type bracketed_##name parameters;                                                \
    type algsurf_##name parameters {                                                                         \
        type in_standard_environment;                                                                        \
        ALGSURF_STANDARD(in_standard_environment = bracketed_##name arguments);                              \
        return in_standard_environment;                                                                      \
    }                                                                                                        \
    static ALGSURF_NOINLINE type bracketed_##name parameters

#endif
