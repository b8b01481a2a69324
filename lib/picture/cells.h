/* cells.h - pixels as the smallest tiles. */
#ifndef ALGSURF_CELLS_H
#define ALGSURF_CELLS_H
#include "../beams/rows.h"
#include "tiling.h"

/* Are there forms for tiles as small as the row's pixels?  Those begin <= x < end are within their bounds
 * then, and the rays of all others miss. */
int algsurf_i_has_cells(const algsurf_i_picture *picture, int row, int *begin, int *end);

/* Of the pixels t->at of a row, where no ray has a root before t->from: those that are neither empty nor
 * sheets are left in the lists, with what is known then.  Rays that are looked at fill a share of a pixel's
 * width and height, about its middle.  Returns how many. */
int algsurf_i_search_cells(const algsurf_i_picture *picture, int row, double share, int count,
                           algsurf_i_tiling *t);

#endif
