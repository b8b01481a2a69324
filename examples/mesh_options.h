/* mesh_options.h - the command line of mesh. */
#ifndef MESH_OPTIONS_H
#define MESH_OPTIONS_H
#include "cli_surface.h"
#include "colour.h"
#include "mesh_write.h"
#include "progress.h"
#include "view.h"

enum { MESH_TOLERANCE_CELLS = 1024 }; /* --tolerance goes no farther */

typedef struct mesh_arguments {
    cli_surface surface;
    view_options view; /* only extent and centre have options */
    cli_planes clip;
    const char *output;
    char *default_output; /* to be freed; null when --output is given */
    mesh_format format;
    int cells;                   /* 0: not given */
    double tolerance, thickness; /* 0: not given */
    int solid, on_surface, threads;
    css_colour outside, inside;
    progress_mode progress;
} mesh_arguments;

/* Reads and checks the command line; ends the program when it is bad, or answers --help. */
mesh_arguments mesh_parse_options(int argc, char **argv);

#endif
