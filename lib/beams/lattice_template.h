/* lattice_template.h - points of lattices (lattice.h), LANES of them side by side.
 *
 * Point k of N is at (k / N, k g) and moved, modulo 1; coordinates are whole multiples of 2^-32, rounded
 * down. All is exact in doubles: N <= 2^13, so that k / N is no closer to a multiple of 2^-32 that it is not
 * than 2^-45, more than it is rounded by; and k g is a whole number of units, below 2^45. */
#ifndef ALGSURF_LATTICE_TEMPLATE_H
#define ALGSURF_LATTICE_TEMPLATE_H
#include "../simd/lanes.h"
#include "lattice.h"

#define LATTICE_UNIT 0x1p-32
#define LATTICE_GENERATOR 0x69E3779Bp0

/* The nearest integer, for |a| < 2^51. */
INLINE lanes nearest_integer(lanes a) {
    const lanes large = all_lanes(0x1.8p52);
    return (a + large) - large;
}

/* Points `number` of `all`, moved across and up by so many units; from the middle of the square: -1/2 <= p,
 * q < 1/2. */
INLINE void find_lattice_points(lanes number, lanes across, lanes up, double all, lanes *p, lanes *q) {
    lanes units = nearest_integer(number * (0x1p32 / all) + (0.5 / all - 0.5)) + across;
    *p = choose(less(units, all_lanes(0x1p32)), units, units - 0x1p32) * LATTICE_UNIT - 0.5;
    lanes turns = (number * LATTICE_GENERATOR + up) * LATTICE_UNIT;
    *q = turns - nearest_integer(turns - (0.5 - 0.5 * LATTICE_UNIT)) - 0.5;
}

#endif
