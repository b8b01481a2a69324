/* arithmetic.h - doubles are computed as the text says, whatever options the compiler was given.
 *
 * The proofs count roundings: every +, -, *, / of the text is rounded to double, once.  A compiler may be
 * told otherwise, or do otherwise by default: gcc fuses a*b + c wherever the machine can (unless told
 * -std=c11), clang within an expression.  What the text can switch off is switched off here; what it cannot
 * is refused.  One option can be neither switched off nor seen: clang's -ffp-contract=fast.
 *
 * Every .c file of the library includes this before anything else, which tests/check_includes proves: gcc
 * does not inline functions from before the pragma into functions behind it.
 */
#ifndef ALGSURF_ARITHMETIC_H
#define ALGSURF_ARITHMETIC_H

#if defined(__clang__)
#pragma clang diagnostic push
#pragma clang diagnostic ignored "-Wignored-pragmas" /* targets that know no float_control */
#pragma float_control(precise, on)                   /* allows contraction, hence stands first */
#pragma clang diagnostic pop
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__)
#pragma GCC optimize("fp-contract=off", "signed-zeros")
#if __GNUC__ == 12 && __GNUC_MINOR__ < 3 && (defined(__FMA__) || defined(__ARM_FEATURE_COMPLEX))
#pragma GCC optimize("no-tree-slp-vectorize") /* which fuses all the same: gcc's bug 107647 */
#endif
#endif

#include <float.h>

#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) ||               \
    (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error "libalgsurf proves its results: -ffast-math and what belongs to it break the proofs"
#endif
/* 1 and 16 evaluate float and _Float16 in wider types; what is double stays double. */
#if FLT_EVAL_METHOD != 0 && FLT_EVAL_METHOD != 1 && FLT_EVAL_METHOD != 16
#error "libalgsurf needs doubles evaluated as doubles (on 32-bit x86: -msse2 -mfpmath=sse)"
#endif
_Static_assert(DBL_MANT_DIG == 53 && DBL_MAX_EXP == 1024 && DBL_MIN_EXP == -1021,
               "double is IEEE 754 binary64");
_Static_assert((long long)4503599627370497.0 == 4503599627370497,
               "constants are doubles: not -fsingle-precision-constant");

#endif
