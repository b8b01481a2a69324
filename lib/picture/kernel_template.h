/* kernel_template.h - the packet code of pictures, except that of colours and shadows, as one kernel. */
#ifndef ALGSURF_KERNEL_TEMPLATE_H
#define ALGSURF_KERNEL_TEMPLATE_H
#define COMMON_DEGREES DEGREES_PAY /* in WebAssembly, too */
#define WATCHED 0
#include "kernel.h"
#include "complex_template.h"
#include "pixels_template.h"
#include "points_template.h"
#include "thin_template.h"
#include "tiles_template.h"

const algsurf_i_picture_kernel KERNEL(algsurf_i_picture) = {.solve_pixels = solve_pixels,
                                                            .search_tiles = search_tiles,
                                                            .points = find_points,
                                                            .find_thin = find_thin,
                                                            .solve_complex = solve_complex,
                                                            .complex_points = find_complex_points};

#endif
