/* render_options.h - the command line of render. */
#ifndef RENDER_OPTIONS_H
#define RENDER_OPTIONS_H
#include "cli.h"
#include "image.h"
#include "progress.h"
#include "render_space.h"

typedef struct render_options {
    int list;
    int width, height;
    const char *output, *hits, *stats; /* hits, stats: null when not wanted; "-" is standard output */
    char *default_output;              /* to be freed; null when --output is given */
    image_format format;
    algsurf_quality quality;
    int antialias;
    double antialias_threshold;
    cli_vector eye, look_at, up;
    double fov, orthographic; /* 0: not given */
    cli_extent extent;
    cli_vector centre;
    algsurf_intersect_options intersect;
    int threads;
    int row_begin, row_end; /* both 0: all rows */
    render_space space;
    render_sweep sweep;
    progress_mode progress;
    cli_surface surface;
} render_options;

/* Reads and checks the command line; ends the program when it is bad, or answers --help. */
render_options render_parse_options(int argc, char **argv);

/* The name of a setting, as written on the command line. */
const char *render_quality_name(algsurf_quality quality);
const char *render_tier_name(algsurf_tier tier);

#endif
