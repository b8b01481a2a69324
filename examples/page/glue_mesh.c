/* glue_mesh.c - the surface of a scene as triangles, as the program mesh makes and writes them.
 */
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "glue.h"
#include "mesh_make.h"
#include "mesh_measure.h"
#include "mesh_open.h"
#include "mesh_write.h"

/* engine.js is told how far it is, and returns 0. */
__attribute__((import_module("page"), import_name("progress"))) int page_progress(int done, int total);

static int tell(int done, int total, void *nothing) {
    (void)nothing;
    return page_progress(done, total);
}

typedef struct file {
    uint8_t *bytes;
    size_t length, room;
} file;

static int put(const void *bytes, size_t count, void *data) {
    file *f = data;
    if (f->length + count > f->room) {
        const size_t room = f->room + f->room / 2 + count;
        void *larger = realloc(f->bytes, room);
        if (!larger) return 0;
        f->bytes = larger;
        f->room = room;
    }
    memcpy(f->bytes + f->length, bytes, count);
    f->length += count;
    return 1;
}

/* In the scene's colours.  A closed surface gets its outer side outside. */
static algsurf_status write(const algsurf_scene *scene, mesh_format format, mesh *m, file *f,
                            double told[5]) {
    algsurf_light lights[ALGSURF_MAX_LIGHTS];
    algsurf_lighting lighting = {.size = sizeof lighting};
    mesh_measures of;
    const algsurf_status status = algsurf_scene_get_lighting(scene, lights, &lighting);
    if (status != ALGSURF_OK) return status;
    if (!mesh_fits_floats(m, m->h)) return ALGSURF_E_RANGE;
    if (!mesh_measure(m, &of)) return ALGSURF_E_NO_MEMORY;
    const int turned = of.open == 0 && of.volume < 0;
    const double *outside = lighting.material->outside, *inside = lighting.material->inside;
    if (turned) mesh_open_turn(m);
    told[2] = (double)of.open;
    return mesh_write(m, format, turned ? inside : outside, turned ? outside : inside, put, f)
               ? ALGSURF_OK
               : ALGSURF_E_NO_MEMORY;
}

/* A file of the surface in the state's extent, uncoloured by light; to be freed.
 *   format  of mesh_format
 *   cells   along the longest side of the extent
 *   told    receives an algsurf_status; bytes of the file; edges at which the surface is open; triangles,
 *           at 0 of which there is no file; cells and edges of cells that may show less than there is */
EXPORTED(page_mesh)
uint8_t *page_mesh(const algsurf_surface *surface, const algsurf_scene *scene, const page_state *state,
                   int format, int cells, double told[5]) {
    const algsurf_extent extent = extent_of(state);
    algsurf_plane planes[ALGSURF_MAX_CLIP_PLANES];
    const mesh_options how = {
        .cells = cells, .planes = planes, .plane_count = planes_of(state, planes), .progress = tell};
    file f = {.length = 0};
    mesh m;
    algsurf_status status = mesh_make(surface, &extent, &how, &m);
    told[2] = 0;
    if (status == ALGSURF_OK && m.triangles > 0) status = write(scene, (mesh_format)format, &m, &f, told);
    told[0] = status;
    told[1] = (double)f.length;
    told[3] = (double)m.triangles;
    told[4] = 0;
    for (int i = 0; i < MESH_DOUBTS; i++) told[4] += (double)m.doubts[i].count;
    mesh_free(&m);
    if (status == ALGSURF_OK) return f.bytes;
    free(f.bytes);
    return NULL;
}
