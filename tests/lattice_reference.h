/* lattice_reference.h - points of a sample's lattice (beams/lattice.h) once more, in integers. */
#ifndef ALGSURF_LATTICE_REFERENCE_H
#define ALGSURF_LATTICE_REFERENCE_H
#include <stdint.h>

#include "beams/lattice.h"

/* 0 <= p, q < 1. */
static inline void lattice_points(const algsurf_i_sample *sample, int purpose, int each, double *p,
                                  double *q) {
    const algsurf_i_lattice lattice = algsurf_i_lattice_of(sample, purpose, each);
    uint64_t all = ALGSURF_I_LATTICE_STEP * (uint64_t)sample->count * (uint64_t)each;
    for (int i = 0; i < each; i++) {
        uint32_t number = (uint32_t)lattice.number + ALGSURF_I_LATTICE_STEP * (uint32_t)i;
        p[i] = (uint32_t)(((uint64_t)number << 32) / all + (uint64_t)lattice.across) * 0x1p-32;
        q[i] = (uint32_t)(number * 0x69E3779Bu + (uint32_t)lattice.up) * 0x1p-32;
    }
}

#endif
