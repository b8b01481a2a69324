/* mesh.c - makes triangles of an algebraic surface: mesh --help. */
#include "mesh_make.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "fit.h"
#include "mesh_open.h"
#include "mesh_options.h"
#include "mesh_report.h"
#include "mesh_threads.h"
#include "output.h"
#include "portable.h"

enum { CELLS = 128, FIRST_CELLS = 32 /* with --tolerance */ };

typedef struct run {
    const mesh_arguments *arguments;
    algsurf_surface *surface;
    view shown;
    int threads;
    progress bar;
} run;

static void make(run *r, int cells, mesh *m) {
    const mesh_arguments *a = r->arguments;
    const mesh_options how = {.cells = cells,
                              .solid = a->solid,
                              .on_surface = a->on_surface,
                              .planes = a->clip.plane,
                              .plane_count = a->clip.count,
                              .run = mesh_threads_run,
                              .run_data = &r->threads,
                              .progress = progress_rows,
                              .progress_data = &r->bar};
    const algsurf_status status = mesh_make(r->surface, &r->shown.extent, &how, m);
    if (status == ALGSURF_E_NO_MEMORY) cli_no_memory();
    if (status == ALGSURF_E_RANGE)
        cli_fail(CLI_BAD_INPUT, "the extent is too large or too small (1e-30 to 1e30), or too far from the "
                                "origin for doubles to show its cells");
    if (status != ALGSURF_OK) cli_fail(CLI_BROKEN, "%s", algsurf_status_text(status));
}

/* Takes more cells until the mesh is near enough.  The distance falls as the square of a cell's edge, but at
 * singular points. */
static void make_within(run *r, double tolerance, mesh *m) {
    int cells = r->arguments->cells > 0 ? r->arguments->cells : FIRST_CELLS;
    for (;;) {
        make(r, cells, m);
        const double off = mesh_deviation(m, r->surface);
        if (off <= tolerance || cells >= MESH_TOLERANCE_CELLS) {
            progress_end(&r->bar);
            cli_complain("%d cells: triangles are within %.3g of the surface, as far as their centres and "
                         "smooth vertices tell%s",
                         cells, off, off <= tolerance ? "" : ": not within --tolerance");
            return;
        }
        const double times = fmin(fmax(1.05 * sqrt(off / tolerance), 1.3), 4);
        cells = (int)fmin(ceil(cells * times), MESH_TOLERANCE_CELLS);
        mesh_free(m);
    }
}

static int put(const void *bytes, size_t count, void *file) { return fwrite(bytes, 1, count, file) == count; }

static void write_mesh(const run *r, const mesh *m, int turned) {
    const mesh_arguments *a = r->arguments;
    const css_colour *inside = a->inside.given ? &a->inside : &a->outside;
    algsurf_scene *scene;
    if (algsurf_scene_create(r->surface, &scene) != ALGSURF_OK) cli_no_memory();
    algsurf_material colours = view_material(scene, a->surface.name ? catalogue_find(a->surface.name) : NULL);
    algsurf_scene_free(scene);
    if (a->outside.given) colour_of(&a->outside, colours.outside);
    if (inside->given) colour_of(inside, colours.inside);
    output_set set = {.count = 0};
    FILE *file = output_open(&set, a->output);
    const double *const side[2] = {turned ? colours.inside : colours.outside,
                                   turned ? colours.outside : colours.inside};
    if (!mesh_write(m, a->format, side[0], side[1], put, file))
        output_fail(&set, a->output, ferror(file) ? strerror(errno) : "too large for its format");
    output_close(&set, a->output, file);
    output_commit(&set);
}

static void make_mesh(run *r) {
    const mesh_arguments *a = r->arguments;
    mesh m;
    progress_begin(&r->bar, a->progress, 1);
    if (a->tolerance > 0)
        make_within(r, a->tolerance, &m);
    else
        make(r, a->cells > 0 ? a->cells : CELLS, &m);
    progress_end(&r->bar);
    algsurf_camera camera = view_camera(&r->shown, 0, 1);
    mesh_report_thin(r->surface, &r->shown.extent, a->clip.plane, a->clip.count, &camera, r->threads);
    if (m.triangles == 0)
        cli_fail(
            CLI_BAD_INPUT, "nothing to mesh: %s",
            m.doubts[MESH_TOUCHED].count > 0
                ? "lines of the lattice touch the surface and do not cross it, as where the equation is a "
                  "square: write its root"
                : "no line of the lattice crosses the surface in this extent; another --extent, or more "
                  "--cells");
    if (a->thickness > 0 && !mesh_open_thicken(&m, a->thickness)) cli_no_memory();
    if (!mesh_fits_floats(&m, a->thickness > 0 ? fmin(a->thickness, m.h) : m.h))
        cli_fail(CLI_BAD_INPUT, "too far from the origin for floats, as files have them, to show the mesh%s",
                 a->thickness > 0 ? ", or --thicken too large or too small" : "");
    mesh_measures of;
    if (!mesh_measure(&m, &of)) cli_no_memory();
    const int turned = of.open == 0 && of.volume < 0;
    if (turned) mesh_open_turn(&m);
    of.volume = fabs(of.volume);
    mesh_report(&m, &of, turned);
    write_mesh(r, &m, turned);
    mesh_free(&m);
}

int main(int argc, char **argv) {
    mesh_arguments a = mesh_parse_options(argc, argv);
    run r = {.arguments = &a, .surface = cli_make_surface(&a.surface), .threads = a.threads};
    if (r.threads == 0) r.threads = (int)fmin(fmax((double)portable_processors(), 1), 256);
    if (algsurf_surface_degree(r.surface) == 0)
        cli_fail(CLI_BAD_INPUT, "x, y and z are missing or cancel: the equation holds at no point");
    output_check(&a.output, 1, a.surface.path);
    r.shown = view_make(&a.view, a.surface.name ? catalogue_find(a.surface.name) : NULL);
    if (!a.surface.name) fit_view(&r.shown, &a.view, r.surface, 1, 1);
    if (strcmp(a.output, "-") == 0) portable_binary_output();
    make_mesh(&r);
    algsurf_surface_free(r.surface);
    cli_forget_surface(&a.surface);
    free(a.default_output);
    return 0;
}
