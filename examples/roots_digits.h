/* roots_digits.h - roots as decimals, to as many digits as are asked for. */
#ifndef ROOTS_DIGITS_H
#define ROOTS_DIGITS_H
#include "algsurf/algsurf.h"

/* A part of a root as texts, each to be freed: the nearest decimal, and an interval that holds the root. */
typedef struct roots_decimals {
    char *value, *lo, *hi;
} roots_decimals;

/* Both parts in units of 10^-places, such that the larger one has `digits` of them.  A part that is exactly a
 * shorter decimal has no zeros at its end, and lo and hi are that, too.  0: no memory. */
int roots_digits(const algsurf_precise_root *root, int digits, roots_decimals *re, roots_decimals *im);

/* Bits of a root that suffice for them. */
int roots_digits_bits(int digits);

void roots_digits_free(roots_decimals *d);

#endif
