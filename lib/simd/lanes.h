/* lanes.h - LANES doubles side by side, for the text that is compiled once for each instruction set.
 *
 * The includer defines LANES: 1 (any machine), 2 (SSE2, NEON), 4 (AVX2) or 8 (AVX-512).  Every lane is
 * rounded as a double alone would be, and no operation mixes lanes: so all kernels give the same bits.  (That
 * also forbids fused multiply-add; base/arithmetic.h sees to it.)  A mask has all bits of a lane set where it
 * is true. */
#ifndef ALGSURF_LANES_H
#define ALGSURF_LANES_H
#include <math.h>
#include <stddef.h>
#include <stdint.h>
#if defined(__x86_64__)
#include <immintrin.h>
#endif

#if defined(__x86_64__) && LANES > 1
#define X86_LANES LANES
#else
#define X86_LANES 0
#endif

#define INLINE static inline __attribute__((always_inline, unused))

/* Before a triangular pair of loops whose length the compiler knows: gcc would leave it half rolled. */
#if defined(__clang__)
#define UNROLLED
#else
#define UNROLLED _Pragma("GCC unroll 32")
#endif

/* Packets that go through a loop side by side, where that shares loads and hides latencies. */
#define PAIR 2

typedef double lanes __attribute__((vector_size(8 * LANES)));

typedef uint64_t words __attribute__((vector_size(8 * LANES)));

/* A truth value for each lane: with AVX-512 a bit, else all bits of a word.  Combined by & | ~ only. */
#if X86_LANES == 8
typedef unsigned mask;
#else
typedef int64_t mask __attribute__((vector_size(8 * LANES)));
#endif

INLINE lanes all_lanes(double a) { return a - (lanes){0}; }

#if X86_LANES == 8
INLINE mask less(lanes a, lanes b) { return _mm512_cmp_pd_mask(a, b, _CMP_LT_OQ); }
INLINE mask at_most(lanes a, lanes b) { return _mm512_cmp_pd_mask(a, b, _CMP_LE_OQ); }
INLINE mask negative(words a) { return _mm512_movepi64_mask((__m512i)a); }
INLINE mask no_lane(void) { return 0; }
#else
INLINE mask less(lanes a, lanes b) { return a < b; }
INLINE mask at_most(lanes a, lanes b) { return a <= b; }
INLINE mask negative(words a) { return (mask)a < 0; } /* the first bit is set */
INLINE mask no_lane(void) { return (mask){0}; }
#endif

/* a where the mask is set, b elsewhere. */
INLINE lanes choose(mask where, lanes a, lanes b) {
#if X86_LANES == 4
    return _mm256_blendv_pd(b, a, (lanes)where);
#elif X86_LANES == 8
    return _mm512_mask_blend_pd((__mmask8)where, b, a);
#elif X86_LANES == 2
    return _mm_or_pd(_mm_and_pd((lanes)where, a), _mm_andnot_pd((lanes)where, b));
#else
    return (lanes)(((mask)a & where) | ((mask)b & ~where));
#endif
}

/* 0, 1, 2 ... */
INLINE lanes numbered(void) {
    static const double numbers[8] = {0, 1, 2, 3, 4, 5, 6, 7};
    lanes a;
    __builtin_memcpy(&a, numbers, sizeof a);
    return a;
}

/* For p[0 .. LANES-1] anywhere in memory. */
INLINE lanes load(const double *p) {
    lanes a;
    __builtin_memcpy(&a, p, sizeof a);
    return a;
}

INLINE void store(double *p, lanes a) { __builtin_memcpy(p, &a, sizeof a); }

INLINE lanes absolute(lanes a) { return (lanes)((words)a & INT64_MAX); }

/* a < b ? a : b, and a > b ? a : b. */
#if X86_LANES == 8
INLINE lanes smaller(lanes a, lanes b) { return _mm512_min_pd(a, b); }
INLINE lanes larger(lanes a, lanes b) { return _mm512_max_pd(a, b); }
#elif X86_LANES == 4
INLINE lanes smaller(lanes a, lanes b) { return _mm256_min_pd(a, b); }
INLINE lanes larger(lanes a, lanes b) { return _mm256_max_pd(a, b); }
#elif X86_LANES == 2
INLINE lanes smaller(lanes a, lanes b) { return _mm_min_pd(a, b); }
INLINE lanes larger(lanes a, lanes b) { return _mm_max_pd(a, b); }
#else
INLINE lanes smaller(lanes a, lanes b) { return choose(less(a, b), a, b); }
INLINE lanes larger(lanes a, lanes b) { return choose(less(b, a), a, b); }
#endif

INLINE lanes root(lanes a) {
#if X86_LANES == 8
    return _mm512_sqrt_pd(a);
#elif X86_LANES == 4
    return _mm256_sqrt_pd(a);
#elif X86_LANES == 2
    return _mm_sqrt_pd(a);
#else
    for (int l = 0; l < LANES; l++) a[l] = sqrt(a[l]);
    return a;
#endif
}

/* Bit l: lane l is set. */
INLINE unsigned bits(mask m) {
#if X86_LANES == 8
    return m & 255;
#elif X86_LANES == 4
    return (unsigned)_mm256_movemask_pd((lanes)m);
#elif X86_LANES == 2
    return (unsigned)_mm_movemask_pd((lanes)m);
#else
    unsigned b = 0;
    for (int l = 0; l < LANES; l++) b |= (unsigned)(m[l] & 1) << l;
    return b;
#endif
}

INLINE int any(mask m) { return bits(m) != 0; }

/* The lanes chosen by bits, in their order, from p on; what follows up to p[LANES-1] is overwritten. */
INLINE void store_chosen(double *p, lanes a, unsigned chosen) {
#if X86_LANES == 8
    _mm512_storeu_pd(p, _mm512_maskz_compress_pd((__mmask8)chosen, a));
#elif X86_LANES == 4
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

/* Rounded down to a multiple of 2^-40, for |a| < 2^10. */
INLINE lanes floor40(lanes a) {
    lanes near = (a + 0x1.8p12) - 0x1.8p12;
    return choose(less(a, near), near - 0x1p-40, near);
}

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
    lanes a;
    for (int l = 0; l < LANES; l++) a[l] = p[l < count ? l : 0];
    return a;
}

INLINE void store_some(double *p, lanes a, int count) {
    if (count >= LANES) {
        store(p, a);
    } else {
        for (int l = 0; l < count; l++) p[l] = a[l];
    }
}

/* ---- error-free transforms ---- */

/* a + *low is exactly a + b. */
INLINE lanes exact_sum(lanes a, lanes b, lanes *low) {
    lanes s = a + b, t = s - a;
    *low = (a - (s - t)) + (b - t);
    return s;
}

/* The same for products (Dekker, Veltkamp: split by 2^27 + 1). */
INLINE lanes exact_product(lanes a, lanes b, lanes *low) {
    lanes p = a * b;
#if X86_LANES == 8
    *low = _mm512_fmsub_pd(a, b, p);
#else
    lanes ta = 0x1.0000002p27 * a, tb = 0x1.0000002p27 * b;
    lanes a_hi = ta - (ta - a), a_lo = a - a_hi, b_hi = tb - (tb - b), b_lo = b - b_hi;
    *low = ((a_hi * b_hi - p) + a_hi * b_lo + a_lo * b_hi) + a_lo * b_lo;
#endif
    return p;
}

/* ---- vectors of three ---- */

INLINE lanes dot(const lanes a[3], const lanes b[3]) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/* 2^-e, where 2^e <= |v| < 2^(e+1) for the largest component of v, if below 2^1023: its components may
 * be squared when multiplied by it. */
INLINE lanes scale_of(const lanes v[3]) {
    lanes size = larger(larger(absolute(v[0]), absolute(v[1])), absolute(v[2]));
    return (lanes)(0x7fe0000000000000u - ((words)size & 0x7ff0000000000000u));
}

/* v / |v|; 0 where v is 0, not finite or beyond 2^1023. */
INLINE void make_unit(lanes v[3]) {
    lanes scale = scale_of(v);
    for (int i = 0; i < 3; i++) v[i] *= scale;
    lanes square = dot(v, v), inverse = 1 / root(square);
    mask sound = less(all_lanes(0), square) & less(square, all_lanes(HUGE_VAL));
    for (int i = 0; i < 3; i++) v[i] = choose(sound, v[i] * inverse, all_lanes(0));
}

#endif
