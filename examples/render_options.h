/* render_options.h - the command line of render. */
#ifndef RENDER_OPTIONS_H
#define RENDER_OPTIONS_H
#include "cli_surface.h"
#include "image.h"
#include "progress.h"
#include "render_look.h"
#include "render_space.h"
#include "view.h"

#define RENDER_THIN_DEGREE 24 /* algsurf_scene_set_thin */

typedef struct render_options {
    int list;
    view_options view;
    const char *output, *hits, *stats; /* hits, stats: null when not wanted; "-" is standard output */
    const char *heatmap;               /* the same */
    image_format heatmap_format;
    char *default_output; /* to be freed; null when --output is given */
    image_format format;
    algsurf_quality quality;
    int antialias;
    double antialias_threshold;
    enum { THIN_USUAL, THIN_ASKED, THIN_NONE } thin; /* usual: it is drawn as far as it can be */
    algsurf_intersect_options intersect;
    cli_planes clip;
    int threads;
    int row_begin, row_end; /* both 0: all rows */
    int frame;              /* of the sweep, from 1; 0: all */
    int a_second;           /* pictures of the sweep, in one animated file; 0: a file for each */
    render_look look;
    int axes, box; /* 1: drawn */
    render_space space;
    render_sweep sweep;
    progress_mode progress;
    cli_surface surface;
} render_options;

/* Reads and checks the command line; ends the program when it is bad, or answers --help. */
render_options render_parse_options(int argc, char **argv);

/* The format of a picture by the ending of its name, a PPM for one without a name; ends the program, naming
 * the option, when there is none. */
image_format render_image_format(const char *option, const char *path);

/* The name of a setting, as written on the command line. */
const char *render_quality_name(algsurf_quality quality);
const char *render_tier_name(int tier);

#endif
