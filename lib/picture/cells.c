/* cells.c - see cells.h. */
#include "../base/arithmetic.h"
#include "cells.h"
#include "geometry.h"
#include "impl.h"

#include <math.h>

int algsurf_i_has_cells(const algsurf_i_picture *picture, int row, int *begin, int *end) {
    return picture->packets && picture->packets->beams &&
           algsurf_i_pixels_within_bounds(picture, row, row + 1, 1, begin, end);
}

int algsurf_i_search_cells(const algsurf_i_picture *picture, int row, double share, int count,
                           algsurf_i_tiling *t) {
    const algsurf_i_packets *p = picture->packets;
    const algsurf_i_row_job rays = algsurf_i_any_row(picture);
    double h = -p->per_slope * (0.5 * share * p->pixel);
    double v = p->origin[1] + p->per_slope * ((0.5 * picture->height - (row + 0.5)) * p->pixel);
    algsurf_i_tile_job job = {.row = &rays,
                              .beam = &t->beam,
                              .size = 1,
                              .count = count,
                              .at = t->at,
                              .from = t->from,
                              .noise = p->frame.value_error};
    algsurf_i_beam_row_expand(&p->frame, p->beams, v, h + copysign(ALGSURF_I_WIDER, h),
                              fabs(h) + ALGSURF_I_WIDER, t->square, &t->beam);
    picture->code->search_tiles(&job);
    return job.count;
}
