/* glue_picture.c - pictures of a state as render draws them, and the extent and the camera that it chooses.
 */
#include <stdint.h>

#include "axes.h"
#include "fit.h"
#include "glue.h"
#include "render_look.h"

static const double TRANSPARENT = -2; /* as background */

EXPORTED(page_state_length) int page_state_length(void) { return sizeof(page_state) / sizeof(double); }

/* ---- scenes ---- */

static css_colour colour_from(double number) {
    uint32_t rgb = number >= 0 ? (uint32_t)number : 0;
    return (css_colour){{(uint8_t)(rgb >> 16), (uint8_t)(rgb >> 8), (uint8_t)rgb}, number >= 0};
}

static render_look look_of(const page_state *state) {
    return (render_look){.outside = colour_from(state->outside),
                         .inside = colour_from(state->inside),
                         .background = colour_from(state->background),
                         .transparent = state->background == TRANSPARENT,
                         .light = state->light_given != 0 ? LIGHT_ANGLES : LIGHT_DEFAULT,
                         .place = {state->azimuth, state->elevation, 0}};
}

static void set_colours(const page_state *state, const render_look *look, algsurf_scene *scene,
                        algsurf_status *failed) {
    algsurf_light lights[ALGSURF_MAX_LIGHTS];
    algsurf_lighting lighting = {.size = sizeof lighting};
    keep(failed, algsurf_scene_get_lighting(scene, lights, &lighting));
    if (*failed != ALGSURF_OK) return;
    algsurf_material material = *lighting.material;
    render_paint(look, &material);
    keep(failed, algsurf_scene_set_material(scene, &material));
    keep(failed, algsurf_scene_set_thin(scene, state->thin != THIN_NONE ? material.outside : NULL));
}

/* A scene as render makes it for the options that say the same as the state; null: there is none.  The
 * surface must outlive it. */
EXPORTED(page_scene)
algsurf_scene *page_scene(const algsurf_surface *surface, const page_state *state, int32_t *status) {
    const algsurf_extent extent = extent_of(state);
    const algsurf_complex_space space = space_of(state);
    const render_look look = look_of(state);
    algsurf_plane planes[ALGSURF_MAX_CLIP_PLANES];
    const size_t plane_count = planes_of(state, planes);
    algsurf_scene *scene = NULL;
    algsurf_camera camera;
    algsurf_status failed = algsurf_scene_create(surface, &scene);
    keep(&failed, camera_of(state, &camera));
    if (failed == ALGSURF_OK) {
        keep(&failed, algsurf_scene_set_extent(scene, &extent));
        keep(&failed, algsurf_scene_set_clip(scene, planes, plane_count));
        set_colours(state, &look, scene, &failed);
        keep(&failed, algsurf_scene_set_antialias_threshold(scene, VIEW_THRESHOLD));
        keep(&failed, algsurf_scene_set_camera(scene, &camera));
        keep(&failed, render_light_scene(&look, &camera, &extent, scene));
        keep(&failed, algsurf_scene_set_complex_space(scene, state->complex_given != 0 ? &space : NULL));
    }
    *status = failed;
    if (failed == ALGSURF_OK) return scene;
    algsurf_scene_free(scene);
    return NULL;
}

/* With `bounded`, doubles alone decide; a ray that they leave undecided is drawn and counted as that.  For a
 * first picture where every ray takes long. */
EXPORTED(page_set_bounded) int page_set_bounded(algsurf_scene *scene, int bounded) {
    const algsurf_intersect_options options = {
        .size = sizeof options, .tier = bounded ? ALGSURF_TIER_BOUNDED : ALGSURF_TIER_CERTIFIED};
    return algsurf_scene_set_intersect_options(scene, &options);
}

/* ---- pictures ---- */

/* Draws rows row_begin .. row_end-1 of a picture.
 *   rgba    four bytes a pixel
 *   t       null, or a double a pixel
 *   counts  receives rays, hits, undecided, decided by integers, thin */
EXPORTED(page_render)
int page_render(const algsurf_scene *scene, int width, int height, int row_begin, int row_end, uint8_t *rgba,
                double *t, double counts[5]) {
    const algsurf_render_options options = {.size = sizeof options,
                                            .width = width,
                                            .height = height,
                                            .row_begin = row_begin,
                                            .row_end = row_end,
                                            .threads = 1};
    algsurf_render_stats stats = {.size = sizeof stats};
    const algsurf_picture picture = {.size = sizeof picture, .pixels = rgba, .format = ALGSURF_RGBA8, .t = t};
    algsurf_status status = algsurf_render(scene, &options, &picture, &stats);
    counts[0] = (double)stats.rays;
    counts[1] = (double)stats.hits;
    counts[2] = (double)stats.undecided;
    counts[3] = (double)stats.exact_rays;
    counts[4] = (double)stats.thin;
    return status;
}

/* ---- axes ---- */

/* what: of AXES_LINES, AXES_BOX. */
static algsurf_status axes_of(const page_state *state, int what, int width, int height, axes_scene *scene) {
    *scene = (axes_scene){.what = what, .extent = extent_of(state), .width = width, .height = height};
    return camera_of(state, &scene->camera);
}

/* Draws axes and box over rows of a picture.
 *   factor  so much larger it is shown, and smaller are letters
 *   t       its distances */
EXPORTED(page_axes)
int page_axes(const algsurf_surface *surface, const page_state *state, int what, int width, int height,
              int row_begin, int row_end, double factor, uint8_t *rgba, const double *t) {
    static const uint8_t white[3] = {255, 255, 255};
    const css_colour given = colour_from(state->background);
    const uint8_t *background = given.given ? given.srgb : state->background == TRANSPARENT ? NULL : white;
    algsurf_plane planes[ALGSURF_MAX_CLIP_PLANES];
    const algsurf_intersect_options options = {
        .size = sizeof options, .planes = planes, .plane_count = planes_of(state, planes)};
    axes_scene scene;
    algsurf_status status = axes_of(state, what, width, height, &scene);
    if (status != ALGSURF_OK) return status;
    scene.letter = axes_letter(factor * width, factor * height) / factor;
    scene.surface = surface;
    scene.options = &options;
    int drawn =
        axes_draw(&scene, row_begin, row_end, background, rgba, 4, state->complex_given != 0 ? NULL : t);
    return drawn ? ALGSURF_OK : ALGSURF_E_NO_MEMORY;
}

/* How much the picture must be magnified, at most 1, so that the box is in it. */
EXPORTED(page_room) int page_room(const page_state *state, int width, int height, double *zoom) {
    axes_scene scene;
    algsurf_status status = axes_of(state, AXES_BOX, width, height, &scene);
    if (status == ALGSURF_OK) *zoom = axes_zoom(&scene);
    return status;
}

/* ---- what is shown, and from where ---- */

/* Extent and camera for the surface, as render chooses them where no option says otherwise.
 *   state   its extent, if it is given, stays
 *   width, height  of the picture
 *   fitted  receives centre, size, eye, point looked at, up (three each), the field of view, and 0 where the
 *           surface goes on outside the extent */
EXPORTED(page_fit)
int page_fit(const algsurf_surface *surface, const page_state *state, int width, int height,
             double fitted[17]) {
    view_options options = {.width = width, .height = height};
    view v;
    fit_choice choice;
    if (state->extent_given != 0) {
        options.extent = (cli_extent){extent_of(state), 1};
        options.centre = (cli_vector){{state->centre[0], state->centre[1], state->centre[2]}, 1};
    }
    algsurf_status status =
        fit_choose(&v, &options, surface, state->complex_given != 0, state->thin != THIN_NONE, &choice);
    if (status != ALGSURF_OK) return status;
    const double *const threes[] = {v.extent.centre, v.extent.size, v.eye, v.look_at, v.up};
    for (int i = 0; i < 5; i++) memcpy(fitted + 3 * i, threes[i], sizeof v.eye);
    fitted[15] = v.fov;
    fitted[16] = choice.bounded;
    return ALGSURF_OK;
}
