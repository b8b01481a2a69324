/* cells.c - see cells.h. */
#include "../base/arithmetic.h"
#include "cells.h"
#include "impl.h"

#include <math.h>

int algsurf_i_has_cells(const algsurf_i_picture *picture, int row, int *begin, int *end) {
    return picture->packets && picture->packets->beams &&
           algsurf_i_pixels_within_bounds(picture, row, row + 1, 1, begin, end);
}

algsurf_i_cells algsurf_i_cells_of(const algsurf_i_picture *picture, int across, int row, double sx,
                                   double sy) {
    const algsurf_i_packets *p = picture->packets;
    algsurf_i_cells f = {.picture = picture,
                         .across = across,
                         .x = (int)(sx * across),
                         .y = row * across + (int)(sy * across),
                         .pixel = p->pixel / across,
                         .offset = -0.5 * picture->width * across,
                         .share = 1,
                         .rays = algsurf_i_any_row(picture)};
    f.rays.pixel = f.pixel;
    return f;
}

int algsurf_i_search_cells(const algsurf_i_cells *f, int size, int count, int thin, algsurf_i_tiling *t) {
    const algsurf_i_picture *picture = f->picture;
    const algsurf_i_packets *p = picture->packets;
    double h = -p->per_slope * (0.5 * f->share * size * f->pixel);
    double v = p->origin[1] + p->per_slope * ((0.5 * picture->height * f->across - (f->y + 0.5)) * f->pixel);
    algsurf_i_row_job rays = f->rays;
    rays.offset = f->offset + 0.5 - 0.5 * size;
    algsurf_i_tile_job job = {.row = &rays,
                              .beam = &t->beam,
                              .size = size,
                              .count = count,
                              .at = t->at,
                              .from = t->from,
                              .to = t->pixel_depth,
                              .within = thin ? t->pixel_low : NULL,
                              .noise = p->frame.value_error};
    algsurf_i_beam_row_expand(&p->frame, p->beams, v, h + copysign(ALGSURF_I_WIDER, h),
                              fabs(h) + ALGSURF_I_WIDER, t->square, &t->beam);
    algsurf_i_picture_kernel_for(picture->kernel)->search_tiles(&job);
    return job.count;
}
