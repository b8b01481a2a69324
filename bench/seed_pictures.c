/* seed_pictures.c - see seed.h.
 *
 * The truth is the default method at full accuracy.  A pixel is right if its t is within ten tolerances (one
 * is the method's; near an outline rounding adds to it) and the renderer's own 2^-36 of the radius; where
 * doubles leave it open whether, or where, it shows the surface, any answer is.
 */
#include "seed.h"

#include <math.h>
#include <stdlib.h>

#include "must.h"
#include "rays.h"

static void render(seed_easel *easel, const algsurf_intersect_options *intersect, double *hits) {
    const seed_view *view = easel->view;
    const algsurf_render_options options = {
        .size = sizeof options, .width = view->width, .height = view->height};
    const algsurf_picture picture = {.size = sizeof picture, .pixels = easel->pixels, .t = hits};
    must(algsurf_scene_set_intersect_options(easel->scene, intersect), view->entry->name);
    must(algsurf_render(easel->scene, &options, &picture, NULL), view->entry->name);
}

void seed_easel_open(seed_easel *easel, const seed_view *view) {
    size_t pixels = (size_t)view->width * (size_t)view->height;
    easel->view = view;
    easel->pixels = must_allocate(pixels, 3);
    easel->hits = must_allocate(pixels, sizeof *easel->hits);
    easel->truth = must_allocate(pixels, sizeof *easel->truth);
    easel->scene = rays_scene(view->surface, &view->entry->extent, &view->camera);
    render(easel, NULL, easel->truth);
}

void seed_easel_close(seed_easel *easel) {
    algsurf_scene_free(easel->scene);
    free(easel->pixels);
    free(easel->hits);
    free(easel->truth);
}

/* Do doubles leave open whether, or where, the pixel shows the surface? */
static int is_left_open(const seed_view *view, int pixel) {
    const algsurf_intersect_options bounded = {.size = sizeof bounded, .tier = ALGSURF_TIER_BOUNDED};
    algsurf_ray chord;
    algsurf_hit hit;
    if (!seed_chord(view, pixel, &chord)) return 1; /* its ray touches the extent at most */
    must(algsurf_intersect_first(view->surface, NULL, &chord, &bounded, &hit), view->entry->name);
    return hit.state == ALGSURF_STATE_UNDECIDED;
}

static int is_right(const seed_easel *easel, int pixel, double tolerance) {
    double t = easel->hits[pixel], truth = easel->truth[pixel];
    if (isinf(t) && isinf(truth)) return 1;
    double allowed = 10 * tolerance + 0x1p-36 * easel->view->entry->extent.size[0];
    return fabs(t - truth) <= allowed || is_left_open(easel->view, pixel);
}

double seed_draw(seed_easel *easel, const seed_method *method, double tolerance, int packets, size_t *wrong) {
    /* any limit of iterations of the caller's makes the renderer go ray by ray */
    const algsurf_intersect_options options = {.size = sizeof options,
                                               .method = method->method,
                                               .absolute_tolerance = tolerance,
                                               .max_iterations = packets ? 0 : 1000};
    const seed_view *view = easel->view;
    double begun = measure_cpu();
    render(easel, &options, easel->hits);
    double seconds = measure_cpu() - begun;
    *wrong = 0;
    for (int pixel = 0; pixel < view->width * view->height; pixel++) {
        if (is_right(easel, pixel, tolerance)) continue;
        if (!method->may_fail)
            cli_fail(CLI_BROKEN, "%s, picture by %s: pixel %d,%d shows t = %.17g, not %.17g",
                     view->entry->name, method->name, pixel % view->width, pixel / view->width,
                     easel->hits[pixel], easel->truth[pixel]);
        ++*wrong;
    }
    return seconds;
}
