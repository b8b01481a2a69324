/* pair.h - two doubles side by side, in one register of any 64-bit processor (SSE2, NEON).
 *
 * The private rooms use it where two independent chains of operations would otherwise wait for each other.
 * Each half is rounded as a double alone would be, so results do not depend on how roots are paired.  The
 * error-free transforms are those of eft.h; a mask has all bits of a half set where a comparison holds. */
#ifndef ALGSURF_PAIR_H
#define ALGSURF_PAIR_H
#include <math.h>
#include <stdint.h>

#include "../base/eft.h"

/* For a function that is compiled anew for each constant it is called with. */
#define ALGSURF_INLINE inline __attribute__((always_inline))

typedef double algsurf_pair __attribute__((vector_size(16)));
typedef int64_t algsurf_pair_mask __attribute__((vector_size(16)));

typedef struct algsurf_pair_dd {
    algsurf_pair hi, lo;
} algsurf_pair_dd;

static inline algsurf_pair algsurf_both(double a) { return (algsurf_pair){a, a}; }

/* a where the mask is set, b elsewhere. */
static inline algsurf_pair algsurf_pair_select(algsurf_pair_mask where, algsurf_pair a, algsurf_pair b) {
    return (algsurf_pair)(((algsurf_pair_mask)a & where) | ((algsurf_pair_mask)b & ~where));
}

static inline algsurf_pair algsurf_pair_sqrt(algsurf_pair a) {
    return (algsurf_pair){sqrt(a[0]), sqrt(a[1])};
}

static inline algsurf_pair algsurf_pair_abs(algsurf_pair a) {
    return (algsurf_pair)((algsurf_pair_mask)a & (algsurf_pair_mask){INT64_MAX, INT64_MAX});
}

static inline algsurf_pair_dd algsurf_pair_two_sum(algsurf_pair a, algsurf_pair b) {
    algsurf_pair s = a + b, t = s - a;
    return (algsurf_pair_dd){s, (a - (s - t)) + (b - t)};
}

static inline algsurf_pair_dd algsurf_pair_two_prod(algsurf_pair a, algsurf_pair b) {
#if defined(__FMA__) || defined(__aarch64__)
    algsurf_dd x = algsurf_two_prod(a[0], b[0]), y = algsurf_two_prod(a[1], b[1]);
    return (algsurf_pair_dd){{x.hi, y.hi}, {x.lo, y.lo}};
#else
    algsurf_pair p = a * b, ta = ALGSURF_SPLITTER * a, tb = ALGSURF_SPLITTER * b;
    algsurf_pair ah = ta - (ta - a), al = a - ah, bh = tb - (tb - b), bl = b - bh;
    return (algsurf_pair_dd){p, ((ah * bh - p) + ah * bl + al * bh) + al * bl};
#endif
}

#endif
