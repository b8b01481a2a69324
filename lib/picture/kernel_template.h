/* kernel_template.h - all the packet code of pictures, as one kernel; of floats what the fast tier needs. */
#ifndef ALGSURF_KERNEL_TEMPLATE_H
#define ALGSURF_KERNEL_TEMPLATE_H
#if defined(SINGLE)
#define COMMON_DEGREES DEGREES_EVERYWHERE
#else
#define COMMON_DEGREES !INSTRUMENTED /* in WebAssembly, too */
#endif
#define WATCHED 0
#include "kernel.h"
#include "leaves_template.h"
#include "points_template.h"
#include "row_template.h"
#include "tiles_template.h"
#if defined(SINGLE)
#include "colours_template.h"
#else
#include "complex_template.h"
#include "places_template.h"
#endif

#if defined(SINGLE)
const algsurf_i_picture_kernel KERNEL(algsurf_i_single) = {.colours = find_colours,
                                                           .mark_bytes = mark_bytes,
#else
const algsurf_i_picture_kernel KERNEL(algsurf_i_picture) = {.see_light = see_light,
                                                            .see_places = see_places,
                                                            .solve_complex = solve_complex,
                                                            .complex_points = find_complex_points,
#endif
                                                           .solve_row = solve_row,
                                                           .solve_leaves = solve_leaves,
                                                           .search_tiles = search_tiles,
                                                           .points = find_points,
                                                           .sheet_points = find_sheet_points};

#endif
