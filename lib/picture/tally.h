/* tally.h - what is counted and timed while a picture is drawn: by each thread, then added up. */
#ifndef ALGSURF_TALLY_H
#define ALGSURF_TALLY_H
#include <stdint.h>

typedef struct algsurf_i_picture algsurf_i_picture; /* impl.h */

/* Tiles that were searched, and what they were found to be; the others were quartered. */
typedef struct algsurf_i_tile_counts {
    uint64_t all, empty, sheets, leaves;
} algsurf_i_tile_counts;

/* What is counted and timed: the fields of algsurf_render_stats that add up. */
typedef struct algsurf_i_tally {
    uint64_t rays, hits, undecided, shadow_rays, iterations, single_rays, thin;
    uint64_t empty_rays, sheet_rays, exact_rays;
    algsurf_i_tile_counts tiles;
    uint64_t without_memory; /* packets of rays of which some could not be decided for want of memory */
    double expand_s, solve_s, point_s, shade_s, shadow_s;
} algsurf_i_tally;

void algsurf_i_tally_add(algsurf_i_tally *total, const algsurf_i_tally *more);

/* Seconds since some moment in the past; never goes back.  0 if nobody asks for the picture's times. */
double algsurf_i_render_clock(const algsurf_i_picture *picture);

#endif
