/* lattice.c - see lattice.h. */
#include "../base/arithmetic.h"
#include "lattice.h"

static const unsigned bayer[4][4] = {{0, 8, 2, 10}, {12, 4, 14, 6}, {3, 11, 1, 9}, {15, 7, 13, 5}};

/* Of 32 bits (multiplications and shifts after Murmur's finalizer). */
static uint32_t hash(uint32_t x, uint32_t y, uint32_t purpose) {
    uint32_t h = x * 0x9E3779B1u ^ (y * 0x85EBCA77u + purpose * 0xC2B2AE3Du);
    h = (h ^ h >> 16) * 0x7FEB352Du;
    h = (h ^ h >> 15) * 0x846CA68Bu;
    return h ^ h >> 16;
}

algsurf_i_lattice algsurf_i_lattice_of(const algsurf_i_sample *sample, int purpose, int each) {
    uint32_t x = (uint32_t)sample->x, y = (uint32_t)sample->y,
             moved = hash(x >> 2, y >> 2, (uint32_t)purpose);
    return (algsurf_i_lattice){bayer[y & 3][x & 3] +
                                   ALGSURF_I_LATTICE_STEP * (uint32_t)(sample->number * each),
                               moved << 16, moved & 0xFFFF0000u};
}
