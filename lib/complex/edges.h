/* edges.h - a sector's ends as directions, for lanes. */
#ifndef ALGSURF_COMPLEX_EDGES_H
#define ALGSURF_COMPLEX_EDGES_H
#include "algsurf/select.h"

typedef struct algsurf_i_sector_edges {
    double begin[2], end[2]; /* cosine and sine: unit vectors, right to 2^-46 in all */
    int from_zero, to_pi;    /* 1: there is no lower, no upper edge */
} algsurf_i_sector_edges;

/* For a valid sector; 0: libm's cosine and sine could not be confirmed. */
int algsurf_i_sector_edges_of(const algsurf_sector *sector, algsurf_i_sector_edges *edges);

#endif
