/* mesh_options.c - see mesh_options.h. */
#include "mesh_options.h"

#include <stdlib.h>
#include <string.h>

#include "output.h"
#include "portable.h"

static void set_length(const cli_option *option, const char *value, void *field) {
    double length;
    if (!cli_numbers(value, ',', 1, &length) || !(length > 0))
        cli_fail(CLI_BAD_INPUT, "%s: expected a number above 0, got '%s'", option->name,
                 cli_quote(value).text);
    *(double *)field = length;
}

static void set_progress(const cli_option *option, const char *value, void *field) {
    static const progress_mode modes[] = {PROGRESS_AUTO, PROGRESS_ALWAYS, PROGRESS_NEVER};
    *(progress_mode *)field = modes[cli_choice(option, value)];
}

#define FIELD(member) offsetof(mesh_arguments, member), 0, 0

static const cli_option options_table[] = {
    CLI_HEADING("The surface"),
    CLI_SURFACE_OPTIONS(mesh_arguments),
    {"--extent", "sphere:R|box:X,Y,Z",
     "takes only what lies in a ball of radius R, or in a box from -X,-Y,-Z to X,Y,Z.\n"
     "Default, as in render: for a named surface what suits it; for an equation all of\n"
     "the surface, or, if it goes on for ever, what is near its singular points or the\n"
     "origin",
     cli_set_extent, FIELD(view.extent)},
    {"--centre", "X,Y,Z", "the centre of that ball or box, default 0,0,0 (boy: 0,0,1)", cli_set_vector,
     FIELD(view.centre)},
    {"--clip", "A,B,C,D", "takes only the points with A x + B y + C z <= D; may be given up to 8 times",
     cli_set_clip, FIELD(clip)},
    CLI_HEADING("The mesh"),
    {"--output", "FILE",
     "the file: .stl, .ply, .obj or .glb; also -o.  Default NAME.stl, or surface.stl for\n"
     "an equation.  - is standard output; there, and into devices and pipes, an .stl is\n"
     "written",
     cli_set_text, FIELD(output)},
    {"--cells", "N",
     "cells of the lattice along the longest side of the extent, 4 to 2048, default 128.\n"
     "Twice as many: four times the triangles, a quarter of the distance to the surface",
     cli_set_int, offsetof(mesh_arguments, cells), MESH_LEAST_CELLS, MESH_MOST_CELLS},
    {"--tolerance", "E",
     "takes more cells, from --cells (default 32) to 1024, until no smooth vertex and\n"
     "no centre of a triangle is farther than E from the surface (by a step of Newton's\n"
     "method).  Vertices where it ends, is sharp or singular may be farther",
     set_length, FIELD(tolerance)},
    {"--on-surface", NULL,
     "puts each vertex on the surface, so that a ball becomes a little too small.\n"
     "Without this option triangles lie evenly on both sides of the surface: twice as\n"
     "near, and the volume is right",
     cli_set_flag, FIELD(on_surface)},
    {"--solid", NULL,
     "makes a solid: what is inside, where the equation's left side is less than its\n"
     "right side, closed where the extent ends.  Without this option the surface is open\n"
     "there",
     cli_set_flag, FIELD(solid)},
    {"--thicken", "D",
     "makes a wall of thickness D about the surface, D/2 to each side, closed along its\n"
     "boundary; for printing.  The wall meets itself where the surface bends more\n"
     "sharply than a ball of radius D/2, at singular points, and between sheets that are\n"
     "nearer than D: that is not looked for",
     set_length, FIELD(thickness)},
    {"--colour", "COLOUR",
     "the colour of the outer side in .ply and .glb: a name of CSS, as teal, or #rrggbb.\n"
     "Default: as in render",
     colour_set, FIELD(outside)},
    {"--inside", "COLOUR",
     "the colour of the inner side in .glb; in .ply and .glb also that of what closes a\n"
     "solid, and of a wall's inner side.  Default: as --colour, if that is given",
     colour_set, FIELD(inside)},
    CLI_HEADING("How fast"),
    {"--threads", "N",
     "how many threads work, 0 to 256; default 0: one for each processor.  The mesh is\nthe same",
     cli_set_int, offsetof(mesh_arguments, threads), 0, 256},
    {"--progress", "auto|always|never",
     "shows a bar with the time left on standard error; auto (default): on a terminal", set_progress,
     FIELD(progress)},
    {NULL, NULL, NULL, NULL, 0, 0, 0}};

static const cli_program program = {
    .name = "mesh",
    .synopsis = "[options] (NAME | EQUATION | FILE.jsurf | --terms FILE)",
    .about = "Makes triangles of an algebraic surface, for 3D printers and programs that take meshes.\n"
             "NAME is a surface that render --list shows.  EQUATION is text in x, y, z, as\n"
             "'x^2 + y^2 = z^2'; without '=' it is taken as \"= 0\".\n\n"
             "All crossings of the surface with the lines of a lattice are found, with a proof; each\n"
             "cell gets a vertex for each sheet of the surface in it.  Standard error tells what was\n"
             "made: triangles, pieces, whether it is watertight (and where not), Euler's number, size,\n"
             "and where the surface has more than the lattice shows: several crossings of one edge of\n"
             "a cell, singular points, points or lines without width.  For crossings and\n"
             "singular points more cells may help.",
    .options = options_table,
    .positional = offsetof(mesh_arguments, surface.name),
    .examples = "mesh torus --output torus.stl\n"
                "mesh barth --cells 200 --output barth.glb\n"
                "mesh 'x^2 + y^2 = z^2 + 0.1' --extent box:1,1,1 --solid --output waist.stl\n"
                "mesh 'x^2 + y^2 - z^2 = 0.1' --extent sphere:1 --thicken 0.05 --output wall.stl\n"
                "mesh sphere --tolerance 0.001 --output sphere.ply",
};

/* "folder/name.jsurf" becomes "name.stl", "barth" "barth.stl". */
static char *file_for(const char *name, int is_file) {
    const char *base = is_file ? name + portable_folder_length(name) : name;
    char *file = malloc(strlen(base) + sizeof ".stl");
    if (!file) cli_no_memory();
    strcpy(file, base);
    if (is_file) *strrchr(file, '.') = '\0';
    return strcat(file, ".stl");
}

static void check_output(mesh_arguments *a, const char *given) {
    if (!a->output) {
        const char *name = a->surface.name && *a->surface.name ? a->surface.name : "surface";
        if (a->surface.file) name = given;
        a->output = a->default_output = file_for(name, a->surface.file != NULL);
    }
    a->format = MESH_STL;
    if (!mesh_format_of(a->output, &a->format) && strcmp(a->output, "-") != 0 &&
        !output_is_special(a->output))
        cli_fail(CLI_BAD_INPUT, "--output: expected a name that ends in .stl, .ply, .obj or .glb, got '%s'",
                 cli_quote(a->output).text);
}

mesh_arguments mesh_parse_options(int argc, char **argv) {
    mesh_arguments a = {.cells = 0};
    cli_parse(&program, argc, argv, &a);
    const char *given = a.surface.name;
    const int coloured = a.outside.given || a.inside.given;
    cli_settle_surface(&a.surface);
    if (a.surface.file) {
        view_follow(&a.view, a.surface.file);
        if (!a.outside.given) {
            a.outside = a.surface.file->front;
            if (!a.inside.given) a.inside = a.surface.file->inside;
        }
    }
    view_check(&a.view);
    if (a.solid && a.thickness > 0)
        cli_fail(CLI_BAD_INPUT, "--thicken: makes a wall about the surface; leave --solid out");
    if (a.tolerance > 0 && a.cells > MESH_TOLERANCE_CELLS)
        cli_fail(CLI_BAD_INPUT, "--tolerance: begins with --cells, at most %d, got %d", MESH_TOLERANCE_CELLS,
                 a.cells);
    check_output(&a, given);
    if (coloured && (a.format == MESH_STL || a.format == MESH_OBJ))
        cli_fail(CLI_BAD_INPUT, "--colour, --inside: .stl and .obj have no colours; .ply and .glb have");
    return a;
}
