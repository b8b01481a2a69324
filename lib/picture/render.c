/* render.c - a picture: arguments, totals. */
#include "../base/arithmetic.h"
#include "impl.h"

#include <stdint.h>
#include <stdlib.h>

#include "../base/fpenv.h"
#include "../base/options.h"
#include "../base/vec.h"

#define MAX_SIDE 65535

static algsurf_status read_options(const algsurf_render_options *given, algsurf_render_options *o) {
    algsurf_status status = algsurf_options_read(o, sizeof *o, given);
    if (status != ALGSURF_OK) return status;
    if (o->row_begin == 0 && o->row_end == 0) o->row_end = o->height;
    int good = o->width >= 1 && o->width <= MAX_SIDE && o->height >= 1 && o->height <= MAX_SIDE &&
               o->row_begin >= 0 && o->row_begin < o->row_end && o->row_end <= o->height && o->threads >= 0 &&
               o->threads <= ALGSURF_MAX_THREADS;
    return good ? ALGSURF_OK : ALGSURF_E_ARGUMENT;
}

/* The planes of a picture of that width, of which so many rows are drawn. */
static algsurf_status read_planes(const algsurf_picture *given, int width, int rows,
                                  algsurf_i_picture *picture) {
    algsurf_picture *planes = &picture->planes;
    algsurf_status status = algsurf_options_read(planes, sizeof *planes, given);
    if (status != ALGSURF_OK || !planes->pixels) return status;
    if (planes->format != ALGSURF_RGB8 && planes->format != ALGSURF_RGBA8) return ALGSURF_E_ARGUMENT;
    size_t row = (size_t)algsurf_i_channels(planes) * (size_t)width;
    if (planes->stride == 0) planes->stride = row;
    size_t most = (size_t)PTRDIFF_MAX / (size_t)rows;
    return planes->stride >= row && planes->stride <= most ? ALGSURF_OK : ALGSURF_E_ARGUMENT;
}

/* The rays through the picture's corners are finite, hence all rays between them. */
static int rays_are_finite(const algsurf_camera *camera, int width, int height) {
    for (int corner = 0; corner < 4; corner++) {
        algsurf_ray ray;
        algsurf_i_camera_ray(camera, width, height, corner & 1 ? width : 0, corner & 2 ? height : 0, &ray);
        if (!algsurf_is_finite3(ray.origin) || !algsurf_is_finite3(ray.direction)) return 0;
    }
    return 1;
}

/* Those of the surface, and of what is thin. */
static void prepare_colours(const algsurf_scene *scene, algsurf_i_picture *picture) {
    const int preview = scene->quality == ALGSURF_QUALITY_PREVIEW;
    algsurf_material thin = scene->material;
    algsurf_lighting lighting = picture->lighting;
    algsurf_i_colour_prepare(&lighting, preview, &picture->colours);
    for (int k = 0; k < 3; k++) thin.outside[k] = thin.inside[k] = scene->thin_colour[k];
    lighting.material = &thin;
    algsurf_i_colour_prepare(&lighting, preview, &picture->thin_colours);
}

static ALGSURF_NOINLINE algsurf_status prepare(const algsurf_scene *scene,
                                               const algsurf_render_options *options,
                                               algsurf_i_picture *picture) {
    picture->scene = scene;
    picture->width = options->width;
    picture->height = options->height;
    picture->row_begin = options->row_begin;
    picture->row_end = options->row_end;
    picture->selective = scene->antialias > 1 && scene->antialias_threshold > 0;
    atomic_init(&picture->stop, 0);
    algsurf_i_scene_lighting(scene, picture->lights, &picture->lighting);
    picture->shadows = scene->quality == ALGSURF_QUALITY_FULL && !scene->complex;
    prepare_colours(scene, picture);
    picture->kernel = algsurf_i_kernel_find(scene->intersect.kernel);
    picture->code = algsurf_i_beams_kernel_for(picture->kernel);
    picture->shader = algsurf_i_colour_kernel_for(picture->kernel);
    if (!algsurf_i_find_geometry(picture, picture->geometry)) picture->geometry = NULL;
    picture->thin =
        picture->geometry && scene->thin && !scene->complex && scene->extent.kind != ALGSURF_EXTENT_ALL;
    picture->tiled = picture->geometry && algsurf_i_tiles_pay(picture, picture->geometry);
    /* a scene's own lights are finite, the default one may be far away */
    int finite = rays_are_finite(&scene->camera, picture->width, picture->height) &&
                 (scene->light_count >= 0 || algsurf_is_finite3(picture->lights[0].position));
    return finite ? ALGSURF_OK : ALGSURF_E_NOT_FINITE;
}

/* Brings P to the picture's view; a frame that leaves the range of double is done without a view. */
static algsurf_status make_frame(algsurf_i_picture *picture) {
    if (!picture->geometry) return ALGSURF_OK;
    const algsurf_surface *surface = picture->scene->surface;
    void *memory = malloc(algsurf_i_frame_memory(surface->degree));
    if (!memory) return ALGSURF_E_NO_MEMORY;
    if (!algsurf_i_frame_expand(surface, &picture->geometry->frame, memory)) {
        picture->geometry = NULL;
        picture->tiled = picture->thin = 0;
    }
    if (picture->thin) algsurf_i_prepare_thin(picture->geometry);
    if (picture->geometry && picture->shadows) algsurf_i_make_shadows(picture, memory);
    free(memory);
    if (picture->geometry && picture->geometry->beams)
        algsurf_i_beam_expand(&picture->geometry->frame, picture->geometry->beams);
    return ALGSURF_OK;
}

static ALGSURF_NOINLINE algsurf_status draw(algsurf_i_picture *picture, const algsurf_render_options *options,
                                            algsurf_i_tally *total) {
    algsurf_i_worker *workers;
    int threads = algsurf_i_thread_count(options);
    double begun = algsurf_i_render_clock(picture);
    algsurf_status status = ALGSURF_E_NO_MEMORY;
    void *memory = algsurf_i_allocate(picture, threads, &workers);
    if (memory) {
        algsurf_i_srgb_curve(picture->curve);
        picture->colours.curve = picture->thin_colours.curve = picture->curve;
        if (picture->shadows) algsurf_i_place_samples(picture);
        status = make_frame(picture);
    }
    double expanded = algsurf_i_render_clock(picture);
    if (status == ALGSURF_OK) status = algsurf_i_render_threads(picture, options, threads, workers, total);
    total->stats.expand_s += expanded - begun;
    free(memory);
    return status;
}

ALGSURF_I_ENTRY(algsurf_status, render,
                (const algsurf_scene *scene, const algsurf_render_options *options,
                 const algsurf_picture *planes, algsurf_render_stats *stats),
                (scene, options, planes, stats)) {
    algsurf_i_geometry geometry;
    algsurf_i_picture picture = {.geometry = &geometry, .timed = stats != NULL};
    double begun = algsurf_i_render_clock(&picture);
    algsurf_render_options o;
    algsurf_i_tally total = {.without_memory = 0};
    if (!scene) return ALGSURF_E_ARGUMENT;
    if (stats && !algsurf_options_fit(stats, sizeof *stats)) return ALGSURF_E_SIZE;
    algsurf_status status = read_options(options, &o);
    if (status == ALGSURF_OK) status = read_planes(planes, o.width, o.row_end - o.row_begin, &picture);
    if (status == ALGSURF_OK) status = prepare(scene, &o, &picture);
    if (status == ALGSURF_OK) status = draw(&picture, &o, &total);
    if (status == ALGSURF_OK && total.without_memory > 0) status = ALGSURF_E_NO_MEMORY;
    if (!stats || (status < 0 && total.without_memory == 0)) return status;
    total.stats.total_s = algsurf_i_render_clock(&picture) - begun;
    total.stats.kernel = picture.kernel->name;
    algsurf_options_write(stats, &total.stats, sizeof total.stats);
    return status;
}
