/* roots_outward.h - ends of an enclosure as decimals that still enclose. */
#ifndef ROOTS_OUTWARD_H
#define ROOTS_OUTWARD_H
#include "algsurf/algsurf.h"

enum { ROOTS_OUTWARD_ROOM = 64 };

/* The interval as "[lo, hi]", lo rounded down, hi up, to as few digits as make it at most half as wide again,
 * and at most 17.  Ends may be infinite. */
void roots_outward(algsurf_interval x, char text[ROOTS_OUTWARD_ROOM]);

#endif
