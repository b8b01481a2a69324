/* integral_impl.h - small things that the files about integers share. */
#ifndef ALGSURF_INTEGRAL_IMPL_H
#define ALGSURF_INTEGRAL_IMPL_H
#include "integral.h"

#define LIMB_BITS 64

static inline int larger(int a, int b) { return a > b ? a : b; }
static inline int smaller(int a, int b) { return a < b ? a : b; }
static inline int bits_of_int(int a) { return algsurf_limb_bits((algsurf_limb)a); }

static inline algsurf_limb *take(algsurf_memory *m, int limbs) {
    return algsurf_memory_take(m, (size_t)limbs);
}
#endif
