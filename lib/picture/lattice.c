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

void algsurf_i_lattice(const algsurf_i_sample *sample, int purpose, int each, double *p, double *q) {
    uint32_t x = (uint32_t)sample->x, y = (uint32_t)sample->y,
             moved = hash(x >> 2, y >> 2, (uint32_t)purpose);
    uint64_t all = 16 * (uint64_t)sample->count * (uint64_t)each;
    for (int i = 0; i < each; i++) {
        uint32_t number = bayer[y & 3][x & 3] + 16 * (uint32_t)(sample->number * each + i);
        uint32_t across = (uint32_t)(((uint64_t)number << 32) / all) + (moved << 16);
        p[i] = across * 0x1p-32;
        q[i] = (uint32_t)(number * 0x69E3779Bu + (moved & 0xFFFF0000u)) * 0x1p-32;
    }
}
