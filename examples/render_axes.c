/* render_axes.c - see render_axes.h. */
#include "render_axes.h"

#include <math.h>

#include "axes.h"

int render_has_axes(const render_options *options) { return options->axes || options->box; }

static axes_scene scene_of(const render_options *options, const view *shown, const algsurf_camera *camera) {
    return (axes_scene){.what = (options->axes ? AXES_LINES : 0) | (options->box ? AXES_BOX : 0),
                        .extent = shown->extent,
                        .camera = *camera,
                        .width = options->view.width,
                        .height = options->view.height};
}

void render_make_room(const render_options *options, view *shown) {
    const view_options *given = &options->view;
    int pictures = options->sweep.kind == SWEEP_TURN ? options->sweep.pictures : 1;
    double zoom = 1;
    if (!options->box || given->eye.given || given->fov > 0 || given->zoom > 0 || given->orthographic > 0)
        return;
    for (int i = 0; i < pictures; i++) {
        algsurf_camera camera = view_camera(shown, i, pictures);
        axes_scene scene = scene_of(options, shown, &camera);
        zoom = fmin(zoom, axes_zoom(&scene));
    }
    if (zoom == 1) return;
    view_zoom(shown, zoom);
    cli_complain("chosen: --zoom %g", zoom);
}

/* In complex space distances are those of no point in real space, and nothing is hidden. */
void render_axes(const render_options *options, const algsurf_surface *surface, const view *shown,
                 const algsurf_camera *camera, int rows, uint8_t *pixels, const double *hits) {
    static const uint8_t white[3] = {255, 255, 255};
    const render_look *look = &options->look;
    const uint8_t *background = look->background.given ? look->background.srgb : white;
    algsurf_intersect_options how = options->intersect;
    axes_scene scene = scene_of(options, shown, camera);
    how.planes = options->clip.plane;
    how.plane_count = options->clip.count;
    scene.surface = surface;
    scene.options = &how;
    if (!render_has_axes(options)) return;
    if (!axes_draw(&scene, options->row_begin, options->row_begin + rows,
                   look->transparent ? NULL : background, pixels, look->transparent ? 4 : 3,
                   options->space.is_complex ? NULL : hits))
        cli_no_memory();
}
