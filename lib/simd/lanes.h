/* lanes.h - LANES numbers side by side, for the text that is compiled once for each instruction set.
 *
 * The includer defines LANES: 1 (any machine), 2 (SSE2, NEON), 4 (AVX2) or 8 (AVX-512).  Numbers are doubles,
 * or, for colours, floats, twice as many, where it defines SINGLE.  Every lane is rounded as a number alone
 * would be, and no operation mixes lanes: so all kernels give the same bits.  (That also forbids fused
 * multiply-add; base/arithmetic.h sees to it.)  A mask has all bits of a lane set where it is true.  A double
 * that meets floats goes through all_lanes(), which rounds it to one. */
#ifndef ALGSURF_LANES_H
#define ALGSURF_LANES_H
#include <math.h>
#include <stddef.h>
#include <stdint.h>
#if defined(__x86_64__)
#include <immintrin.h>
#elif defined(__wasm_simd128__)
#include <wasm_simd128.h>
#endif

/* BY_PRECISION: one or the other; PACKED, COMPARED: names of instructions of x86. */
#if defined(SINGLE)
#define BY_PRECISION(of_doubles, of_floats) of_floats
#define PACKED(name) name##_ps
#define COMPARED _mm512_cmp_ps_mask
#define WIDTH (32 * LANES)
#else
#define BY_PRECISION(of_doubles, of_floats) of_doubles
#define PACKED(name) name##_pd
#define COMPARED _mm512_cmp_pd_mask
#define WIDTH (64 * LANES)
#endif

/* Bits of the register of x86 that lanes are in; 0: of another one. */
#if defined(__x86_64__) && WIDTH >= 128
#define X86_WIDTH WIDTH
#else
#define X86_WIDTH 0
#endif

/* Lanes are a register of WebAssembly.  Its instructions are called by name where clang would make a loop
 * over memory of what is written lane by lane, which takes three times as long. */
#if defined(__wasm_simd128__) && WIDTH == 128
#define WASM 1
#else
#define WASM 0
#endif

#define INLINE static inline __attribute__((always_inline, unused))
#define APART static __attribute__((noinline, unused))

/* Before a triangular pair of loops whose length the compiler knows: gcc would leave it half rolled. */
#if defined(__clang__)
#define UNROLLED
#else
#define UNROLLED _Pragma("GCC unroll 32")
#endif

/* Packets that go through a loop side by side, where that shares loads and hides latencies. */
#define PAIR 2

typedef BY_PRECISION(double, float) scalar;

typedef scalar lanes __attribute__((vector_size(WIDTH / 8)));

typedef BY_PRECISION(uint64_t, uint32_t) words __attribute__((vector_size(WIDTH / 8)));

/* A truth value for each lane: with AVX-512 a bit, else all bits of a word.  Combined by & | ~ only. */
#if X86_WIDTH == 512
typedef unsigned mask;
#else
typedef BY_PRECISION(int64_t, int32_t) mask __attribute__((vector_size(WIDTH / 8)));
#endif

#if defined(SINGLE) && WASM
INLINE lanes all_lanes(double a) { return (lanes)wasm_f32x4_splat((float)a); }
#elif defined(SINGLE) && !X86_WIDTH
/* No sum of a float and lanes: where FLT_EVAL_METHOD is 1, C makes a double of the float. */
INLINE lanes all_lanes(double a) {
    lanes all;
    for (int l = 0; l < LANES; l++) all[l] = (scalar)a;
    return all;
}
#else
INLINE lanes all_lanes(double a) { return (scalar)a - (lanes){0}; }
#endif

#if X86_WIDTH == 512
INLINE mask less(lanes a, lanes b) { return COMPARED(a, b, _CMP_LT_OQ); }
INLINE mask at_most(lanes a, lanes b) { return COMPARED(a, b, _CMP_LE_OQ); }
#else
INLINE mask less(lanes a, lanes b) { return a < b; }
INLINE mask at_most(lanes a, lanes b) { return a <= b; }
#endif

/* a where the mask is set, b elsewhere. */
INLINE lanes choose(mask where, lanes a, lanes b) {
#if X86_WIDTH == 256
    return PACKED(_mm256_blendv)(b, a, (lanes)where);
#elif X86_WIDTH == 512
    return PACKED(_mm512_mask_blend)(BY_PRECISION((__mmask8)where, (__mmask16)where), b, a);
#elif X86_WIDTH == 128
    return PACKED(_mm_or)(PACKED(_mm_and)((lanes)where, a), PACKED(_mm_andnot)((lanes)where, b));
#else
    return (lanes)(((mask)a & where) | ((mask)b & ~where));
#endif
}

INLINE lanes absolute(lanes a) { return (lanes)((words)a & BY_PRECISION(INT64_MAX, INT32_MAX)); }

/* a < b ? a : b, and a > b ? a : b. */
#if X86_WIDTH == 512
INLINE lanes smaller(lanes a, lanes b) { return PACKED(_mm512_min)(a, b); }
INLINE lanes larger(lanes a, lanes b) { return PACKED(_mm512_max)(a, b); }
#elif X86_WIDTH == 256
INLINE lanes smaller(lanes a, lanes b) { return PACKED(_mm256_min)(a, b); }
INLINE lanes larger(lanes a, lanes b) { return PACKED(_mm256_max)(a, b); }
#elif X86_WIDTH == 128
INLINE lanes smaller(lanes a, lanes b) { return PACKED(_mm_min)(a, b); }
INLINE lanes larger(lanes a, lanes b) { return PACKED(_mm_max)(a, b); }
#else
INLINE lanes smaller(lanes a, lanes b) { return choose(less(a, b), a, b); }
INLINE lanes larger(lanes a, lanes b) { return choose(less(b, a), a, b); }
#endif

INLINE lanes root(lanes a) {
#if X86_WIDTH == 512
    return PACKED(_mm512_sqrt)(a);
#elif X86_WIDTH == 256
    return PACKED(_mm256_sqrt)(a);
#elif X86_WIDTH == 128
    return PACKED(_mm_sqrt)(a);
#elif WASM
    return (lanes)BY_PRECISION(wasm_f64x2_sqrt, wasm_f32x4_sqrt)((v128_t)a);
#else
    for (int l = 0; l < LANES; l++) a[l] = BY_PRECISION(sqrt, sqrtf)(a[l]);
    return a;
#endif
}

typedef int32_t integers __attribute__((vector_size(4 * LANES)));

/* ---- vectors of three ---- */

INLINE lanes dot(const lanes a[3], const lanes b[3]) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

INLINE lanes largest_size(const lanes v[3]) {
    return larger(larger(absolute(v[0]), absolute(v[1])), absolute(v[2]));
}

/* ---- floats only ---- */
#if defined(SINGLE)

/* LANES values, or as many of them as there are: the lanes behind the last one repeat the first. */
INLINE lanes load_some_floats(const float *p, int count) {
    lanes a;
    if (count >= LANES) {
        __builtin_memcpy(&a, p, sizeof a);
    } else {
        for (int l = 0; l < LANES; l++) a[l] = p[l < count ? l : 0];
    }
    return a;
}

/* ---- doubles only ---- */
#else

INLINE mask negative(words a) {
#if X86_WIDTH == 512
    return _mm512_movepi64_mask((__m512i)a);
#else
    return (mask)a < 0; /* the first bit is set */
#endif
}

INLINE mask no_lane(void) {
#if X86_WIDTH == 512
    return 0;
#else
    return (mask){0};
#endif
}

/* Bit l: lane l is set. */
INLINE unsigned bits(mask m) {
#if X86_WIDTH == 512
    return m & ((1u << LANES) - 1);
#elif X86_WIDTH == 256
    return (unsigned)_mm256_movemask_pd((lanes)m);
#elif X86_WIDTH == 128
    return (unsigned)_mm_movemask_pd((lanes)m);
#elif WASM
    return (unsigned)wasm_i64x2_bitmask((v128_t)m);
#else
    unsigned b = 0;
    for (int l = 0; l < LANES; l++) b |= (unsigned)(m[l] & 1) << l;
    return b;
#endif
}

INLINE int any(mask m) { return bits(m) != 0; }

/* 0, 1, 2 ... */
INLINE lanes numbered(void) {
    static const double numbers[8] = {0, 1, 2, 3, 4, 5, 6, 7};
    lanes a;
    __builtin_memcpy(&a, numbers, sizeof a);
    return a;
}

/* Rounded down to a multiple of 2^-40, for |a| < 2^10. */
INLINE lanes floor40(lanes a) {
    const lanes large = all_lanes(0x1.8p12), near = (a + large) - large;
    return choose(less(a, near), near - 0x1p-40, near);
}

/* For p[0 .. LANES-1] anywhere in memory. */
INLINE lanes load(const double *p) {
    lanes a;
    __builtin_memcpy(&a, p, sizeof a);
    return a;
}

INLINE void store(double *p, lanes a) { __builtin_memcpy(p, &a, sizeof a); }

/* LANES values, or as many of them as there are: the lanes behind the last one repeat the first. */
INLINE lanes load_some(const double *p, int count) {
    if (count >= LANES) return load(p);
    lanes a = all_lanes(p[0]);
    for (int l = 1; l < LANES; l++)
        if (l < count) a[l] = p[l];
    return a;
}

/* The same, `step` doubles from one to the next. */
INLINE lanes load_steps(const double *p, ptrdiff_t step, int count) {
    if (step == 1) return load_some(p, count);
    lanes a = all_lanes(p[0]);
    for (int l = 1; l < LANES; l++)
        if (l < count) a[l] = p[l * step];
    return a;
}

INLINE lanes load_some_integers(const int *p, int count) {
    integers a;
    if (count >= LANES) {
        __builtin_memcpy(&a, p, sizeof a);
    } else {
        for (int l = 0; l < LANES; l++) a[l] = p[l < count ? l : 0];
    }
    return __builtin_convertvector(a, lanes);
}

INLINE void store_some(double *p, lanes a, int count) {
    if (count >= LANES) {
        store(p, a);
    } else {
        for (int l = 0; l < count; l++) p[l] = a[l];
    }
}

/* The same as floats in memory. */
typedef float floats __attribute__((vector_size(4 * LANES)));
INLINE void store_some_floats(float *p, lanes a, int count) {
    floats b = __builtin_convertvector(a, floats);
    if (count >= LANES) {
        __builtin_memcpy(p, &b, sizeof b);
    } else {
        for (int l = 0; l < count; l++) p[l] = b[l];
    }
}

/* 2^-e, where 2^e <= |v| < 2^(e+1) for the largest component of v, if below 2^1023: its components may be
 * squared when multiplied by it. */
INLINE lanes scale_of(const lanes v[3]) {
    return (lanes)(0x7fe0000000000000u - ((words)largest_size(v) & 0x7ff0000000000000u));
}

/* v / |v|; 0 where v is 0, not finite or beyond that. */
INLINE void make_unit(lanes v[3]) {
    lanes scale = scale_of(v);
    for (int i = 0; i < 3; i++) v[i] *= scale;
    lanes square = dot(v, v), inverse = 1 / root(square);
    mask sound = less(all_lanes(0), square) & less(square, all_lanes(HUGE_VAL));
    for (int i = 0; i < 3; i++) v[i] = choose(sound, v[i] * inverse, all_lanes(0));
}

/* The lanes chosen by bits, in their order, from p on; what follows up to p[LANES-1] is overwritten. */
INLINE void store_chosen(double *p, lanes a, unsigned chosen) {
#if X86_WIDTH == 512
    _mm512_storeu_pd(p, _mm512_maskz_compress_pd((__mmask8)chosen, a));
#elif X86_WIDTH == 256
    static const uint32_t halves[16][8] = {
        {0, 0, 0, 0, 0, 0, 0, 0}, {0, 1, 0, 0, 0, 0, 0, 0}, {2, 3, 0, 0, 0, 0, 0, 0},
        {0, 1, 2, 3, 0, 0, 0, 0}, {4, 5, 0, 0, 0, 0, 0, 0}, {0, 1, 4, 5, 0, 0, 0, 0},
        {2, 3, 4, 5, 0, 0, 0, 0}, {0, 1, 2, 3, 4, 5, 0, 0}, {6, 7, 0, 0, 0, 0, 0, 0},
        {0, 1, 6, 7, 0, 0, 0, 0}, {2, 3, 6, 7, 0, 0, 0, 0}, {0, 1, 2, 3, 6, 7, 0, 0},
        {4, 5, 6, 7, 0, 0, 0, 0}, {0, 1, 4, 5, 6, 7, 0, 0}, {2, 3, 4, 5, 6, 7, 0, 0},
        {0, 1, 2, 3, 4, 5, 6, 7}};
    __m256i order = _mm256_loadu_si256((const __m256i *)halves[chosen]);
    _mm256_storeu_ps((float *)p, _mm256_permutevar8x32_ps((__m256)a, order));
#else
    for (int l = 0, to = 0; l < LANES; l++) {
        p[to] = a[l];
        to += (int)(chosen >> l & 1);
    }
#endif
}

/* a + *low is exactly a + b. */
INLINE lanes exact_sum(lanes a, lanes b, lanes *low) {
    lanes s = a + b, t = s - a;
    *low = (a - (s - t)) + (b - t);
    return s;
}

/* The same for products (Dekker, Veltkamp: split by 2^27 + 1). */
INLINE lanes exact_product(lanes a, lanes b, lanes *low) {
    lanes p = a * b;
#if X86_WIDTH == 512
    *low = _mm512_fmsub_pd(a, b, p);
#else
    lanes ta = 0x1.0000002p27 * a, tb = 0x1.0000002p27 * b;
    lanes a_hi = ta - (ta - a), a_lo = a - a_hi, b_hi = tb - (tb - b), b_lo = b - b_hi;
    *low = ((a_hi * b_hi - p) + a_hi * b_lo + a_lo * b_hi) + a_lo * b_lo;
#endif
    return p;
}

#endif
#endif
