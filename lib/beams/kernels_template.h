/* kernels_template.h - the packet code of this room as one kernel. */
#ifndef ALGSURF_BEAMS_KERNELS_TEMPLATE_H
#define ALGSURF_BEAMS_KERNELS_TEMPLATE_H
#define COMMON_DEGREES DEGREES_PAY /* in WebAssembly, too */
#define WATCHED 0
#include "kernels.h"
#include "complex_pixels_template.h"
#include "pixels_template.h"
#include "points_template.h"
#include "segments_template.h"
#include "thin_template.h"
#include "tiles_template.h"

const algsurf_i_beams_kernel KERNEL(algsurf_i_beams) = {.solve_pixels = solve_pixels,
                                                        .search_tiles = search_tiles,
                                                        .points = find_points,
                                                        .find_thin = find_thin,
                                                        .solve_complex = solve_complex,
                                                        .complex_points = find_complex_points,
                                                        .lift = lift,
                                                        .expand = expand,
                                                        .see_rays = see_rays};

#endif
