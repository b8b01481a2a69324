/* mesh_report.c - see mesh_report.h. */
#include "mesh_report.h"

#include <inttypes.h>

#include "cli.h"

/* A number and what it counts. */
static const char *plural(size_t count) { return count == 1 ? "" : "s"; }

static void report_topology(const mesh_measures *of) {
    if (of->irregular > 0)
        cli_complain("not a manifold: %zu edge%s, near %.6g,%.6g,%.6g", of->irregular, plural(of->irregular),
                     of->irregular_at[0], of->irregular_at[1], of->irregular_at[2]);
    if (of->open > 0)
        cli_complain("open along %zu edge%s, near %.6g,%.6g,%.6g; %ld piece%s, Euler's number %ld", of->open,
                     plural(of->open), of->open_at[0], of->open_at[1], of->open_at[2], of->pieces,
                     plural((size_t)of->pieces), of->euler);
    else if (of->irregular == 0 && of->pieces == 1)
        cli_complain("watertight; 1 piece, Euler's number %ld: genus %ld", of->euler, 1 - of->euler / 2);
    else if (of->irregular == 0)
        cli_complain("watertight; %ld pieces, Euler's number %ld", of->pieces, of->euler);
}

static void report_doubts(const mesh_doubt doubts[MESH_DOUBTS]) {
    static const char *const what[MESH_DOUBTS] = {
        [MESH_CROWDED] = "edges of cells that the surface crosses more than once",
        [MESH_TOUCHED] =
            "places where a line of the lattice touches the surface, which is not in the mesh there",
        [MESH_UNDECIDED] = "places of lattice lines where it is undecided whether the surface is there",
        [MESH_SHARP] =
            "cells in which the surface turns by more than 60 degrees: singular, or too few cells"};
    for (int i = 0; i < MESH_DOUBTS; i++)
        if (doubts[i].count > 0)
            cli_complain("%zu %s; one is near %.6g,%.6g,%.6g", doubts[i].count, what[i], doubts[i].at[0],
                         doubts[i].at[1], doubts[i].at[2]);
}

void mesh_report(const mesh *m, const mesh_measures *of, int turned) {
    cli_complain("%zu triangle%s, %zu points, cells of %.4g", m->triangles, plural(m->triangles), m->points,
                 m->h);
    report_topology(of);
    cli_complain("x %.6g..%.6g, y %.6g..%.6g, z %.6g..%.6g; area %.6g", of->low[0], of->high[0], of->low[1],
                 of->high[1], of->low[2], of->high[2], of->area);
    if (of->open == 0)
        cli_complain("volume %.8g%s", of->volume, turned ? ", where the left side is larger" : "");
    report_doubts(m->doubts);
}

enum { WIDE = 256, HIGH = 192, THIN_DEGREE = 24 /* algsurf_scene_set_thin */ };

void mesh_report_thin(const algsurf_surface *surface, const algsurf_extent *extent,
                      const algsurf_plane *planes, size_t count, const algsurf_camera *camera, int threads) {
    static const double any_colour[3] = {1, 1, 1};
    const algsurf_render_options how = {
        .size = sizeof how, .width = WIDE, .height = HIGH, .threads = threads};
    static unsigned char state[WIDE * HIGH];
    const algsurf_picture planes_of = {.size = sizeof planes_of, .state = state};
    algsurf_render_stats counted = {.size = sizeof counted};
    algsurf_scene *scene;
    if (algsurf_surface_degree(surface) > THIN_DEGREE) return;
    if (algsurf_scene_create(surface, &scene) != ALGSURF_OK) cli_no_memory();
    if (algsurf_scene_set_extent(scene, extent) == ALGSURF_OK &&
        algsurf_scene_set_clip(scene, planes, count) == ALGSURF_OK &&
        algsurf_scene_set_thin(scene, any_colour) == ALGSURF_OK &&
        algsurf_scene_set_camera(scene, camera) == ALGSURF_OK &&
        algsurf_render(scene, &how, &planes_of, &counted) == ALGSURF_OK && counted.thin > 0)
        cli_complain("points or lines without width, in %" PRIu64 " of %d pixels of a picture, some of them "
                     "perhaps not there: they are not in the mesh",
                     counted.thin, WIDE * HIGH);
    algsurf_scene_free(scene);
}
