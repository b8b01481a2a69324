/* cells.h - what a pixel's samples stand for: cells, 1/n of it wide and high, and tiles about them. */
#ifndef ALGSURF_CELLS_H
#define ALGSURF_CELLS_H
#include "kernel.h"
#include "geometry.h"
#include "tiling.h"

/* The cells about the samples of a pass are the pixels of a picture with as many times more pixels. */
typedef struct algsurf_i_cells {
    const algsurf_i_picture *picture;
    int across, x, y; /* its pixels for one of this; of each, those of the pass begin at x; the row */
    double pixel, offset;
    double share; /* of a tile's width and height that rays to be searched fill, about its middle; 1: all */
    algsurf_i_row_job rays;
} algsurf_i_cells;

/* Are there forms for tiles as small as the row's pixels?  Those begin <= x < end are within their bounds then,
 * and the rays of all others miss. */
int algsurf_i_has_cells(const algsurf_i_picture *picture, int row, int *begin, int *end);

algsurf_i_cells algsurf_i_cells_of(const algsurf_i_picture *picture, int across, int row, double sx,
                                   double sy);

/* Tiles of `size` cells about those of t->at, where each ray has its first root between t->from and
 * t->pixel_depth, or none: those that are neither empty nor sheets are left in the lists, with what is known
 * then.  thin: 1, pixel_low tells of them as algsurf_i_tile_job.within.  Returns how many. */
int algsurf_i_search_cells(const algsurf_i_cells *cells, int size, int count, int thin, algsurf_i_tiling *t);

#endif
