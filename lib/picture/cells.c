/* cells.c - see cells.h. */
#include "../base/arithmetic.h"
#include "cells.h"

#include <math.h>

algsurf_i_cells algsurf_i_cells_of(const algsurf_i_picture *picture, int across, int row, double sx,
                                   double sy) {
    const algsurf_i_packets *p = picture->packets;
    algsurf_i_cells f = {.picture = picture,
                         .across = across,
                         .x = (int)(sx * across),
                         .y = row * across + (int)(sy * across),
                         .pixel = p->pixel / across,
                         .offset = -0.5 * picture->width * across,
                         .share = 1};
    f.rays = (algsurf_i_row_job){.view = &p->frame.view,
                                 .pixel = f.pixel,
                                 .u0 = p->origin[0],
                                 .du = p->per_slope,
                                 .extent = &picture->scene->extent,
                                 .extent_size = {p->extent_size[0], p->extent_size[1], p->extent_size[2]},
                                 .planes = p->view_planes,
                                 .plane_count = p->plane_count,
                                 .near = p->near};
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
                              .to = t->leaf_depth,
                              .within = thin ? t->leaf_low : NULL,
                              .noise = p->frame.value_error};
    algsurf_i_beam_row_expand(&p->frame, p->beams, v, h + copysign(ALGSURF_I_WIDER, h),
                              fabs(h) + ALGSURF_I_WIDER, t->square, &t->beam);
    algsurf_i_picture_kernel_for(picture->kernel)->search_tiles(&job);
    return job.count;
}
