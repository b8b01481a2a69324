/* shortest.h - doubles as text, with the fewest digits that read back exactly, and of those the nearest. */
#ifndef SHORTEST_H
#define SHORTEST_H
#include <stdint.h>

enum { SHORTEST_LEAST = -292, SHORTEST_MOST = 324, SHORTEST_ROOM = 32 };

/* Powers of ten, 10^SHORTEST_LEAST .. 10^SHORTEST_MOST: 128 bits of each from its first 1, rounded up. */
typedef struct shortest_powers {
    uint64_t high[SHORTEST_MOST - SHORTEST_LEAST + 1], low[SHORTEST_MOST - SHORTEST_LEAST + 1];
} shortest_powers;

/* Some 30 microseconds. */
void shortest_fill(shortest_powers *powers);

/* x as printf's %.17g would have it, but for the digits; returns the length, less than SHORTEST_ROOM.  x may
 * be infinite or NaN. */
int shortest_write(const shortest_powers *powers, double x, char *text);

#endif
