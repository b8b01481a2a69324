/* render_rounding.c - see render_rounding.h.
 *
 * The surface is drawn once more, coarsely, with the error that the rounding may have made: rays for which
 * that matters are undecided.  The bounded tier will do, as it leaves few others undecided. */
#include "render_rounding.h"

enum { COLUMNS = 96, ROWS = 72 };

static int is_changed(const algsurf_surface *with_error, const view *shown) {
    const algsurf_render_options size = {.size = sizeof size, .width = COLUMNS, .height = ROWS};
    const algsurf_intersect_options how = {.size = sizeof how, .tier = ALGSURF_TIER_BOUNDED};
    unsigned char state[COLUMNS * ROWS];
    const algsurf_picture picture = {.size = sizeof picture, .state = state};
    algsurf_render_stats counted = {.size = sizeof counted};
    algsurf_camera camera;
    algsurf_scene *scene = NULL;
    int changed = view_make_camera(shown, 0, 1, &camera) == ALGSURF_OK &&
                  algsurf_scene_create(with_error, &scene) == ALGSURF_OK &&
                  algsurf_scene_set_extent(scene, &shown->extent) == ALGSURF_OK &&
                  algsurf_scene_set_camera(scene, &camera) == ALGSURF_OK &&
                  algsurf_scene_set_intersect_options(scene, &how) == ALGSURF_OK &&
                  algsurf_render(scene, &size, &picture, &counted) == ALGSURF_OK &&
                  20 * counted.undecided > counted.hits + counted.undecided;
    algsurf_scene_free(scene);
    return changed;
}

void render_tell_of_rounding(const algsurf_surface *surface, const view *shown) {
    double error = algsurf_surface_rounding(surface);
    algsurf_surface *with_error = NULL;
    if (error > 0 && algsurf_surface_with_error(surface, error, &with_error) == ALGSURF_OK &&
        is_changed(with_error, shown))
        cli_complain(
            "the coefficients are rounded to doubles, which visibly changes this surface: place it nearer to "
            "the origin");
    algsurf_surface_free(with_error);
}
