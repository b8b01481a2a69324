/* srgb.h - from linear light to the bytes of sRGB (IEC 61966-2-1), and back. */
#ifndef ALGSURF_SRGB_H
#define ALGSURF_SRGB_H
#include <stdint.h>

#define SRGB_STEPS 4096 /* of linear light, from 0 to 1: next to black one is 0.8 of a byte */

/* The byte of each step. */
void algsurf_i_srgb_curve(uint8_t curve[SRGB_STEPS]);

/* The step of 0 <= light <= 1.  The casts round where C computes with more than floats. */
static inline int algsurf_i_srgb_step(float light) {
    return (int)(float)((float)((SRGB_STEPS - 1) * light) + 0.5f);
}

/* The byte of 0 <= light <= 1. */
static inline uint8_t algsurf_i_byte_of(const uint8_t curve[SRGB_STEPS], double light) {
    return curve[algsurf_i_srgb_step((float)light)];
}

#endif
