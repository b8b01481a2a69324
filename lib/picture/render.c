/* render.c - a picture: arguments, memory, totals. */
#include "../base/arithmetic.h"
#include "impl.h"

#include <stdlib.h>
#include <string.h>

#include "camera_impl.h"
#include "../base/fpenv.h"
#include "../base/options.h"
#include "../base/vec.h"

#define MAX_SIDE 65535

static algsurf_status read_options(const algsurf_render_options *given, algsurf_render_options *o) {
    if (!given || !algsurf_options_read(o, sizeof *o, given)) return ALGSURF_E_ARGUMENT;
    if (o->row_begin == 0 && o->row_end == 0) o->row_end = o->height;
    int good = o->width >= 1 && o->width <= MAX_SIDE && o->height >= 1 && o->height <= MAX_SIDE &&
               o->row_begin >= 0 && o->row_begin < o->row_end && o->row_end <= o->height && o->threads >= 0 &&
               o->threads <= ALGSURF_MAX_THREADS;
    return good ? ALGSURF_OK : ALGSURF_E_ARGUMENT;
}

/* The planes of a picture of that width. */
static algsurf_status read_planes(const algsurf_picture *given, int width, algsurf_i_picture *picture) {
    algsurf_picture *planes = &picture->planes;
    if (!given || !algsurf_options_read(planes, sizeof *planes, given)) return ALGSURF_E_ARGUMENT;
    if (!planes->pixels) return ALGSURF_OK;
    if (planes->format != ALGSURF_RGB8 && planes->format != ALGSURF_RGBA8) return ALGSURF_E_ARGUMENT;
    picture->channels = planes->format == ALGSURF_RGBA8 ? 4 : 3;
    size_t row = (size_t)picture->channels * (size_t)width;
    if (planes->stride == 0) planes->stride = row;
    return planes->stride >= row ? ALGSURF_OK : ALGSURF_E_ARGUMENT;
}

/* How many threads to draw with: never more than rows. */
static int thread_count(const algsurf_render_options *options) {
    long threads = options->threads > 0 ? options->threads : algsurf_i_processors();
    int rows = options->row_end - options->row_begin;
    if (threads > ALGSURF_MAX_THREADS) threads = ALGSURF_MAX_THREADS;
    if (threads > rows) threads = rows;
    return threads < 1 ? 1 : (int)threads;
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

static int lights_are_finite(const algsurf_light *lights, int count) {
    for (int l = 0; l < count; l++)
        if (!algsurf_is_finite3(lights[l].position)) return 0;
    return 1;
}

/* Half the length of what is shown, seen along the view. */
static double reach_of(const algsurf_scene *scene, double radius) {
    double sum = 0;
    if (scene->extent.kind != ALGSURF_EXTENT_BOX) return radius;
    for (int i = 0; i < 3; i++) sum += scene->extent.size[i] * fabs(scene->camera.forward[i]);
    return sum;
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
    picture->light_count = algsurf_i_scene_lights(scene, picture->lights);
    picture->shadows = scene->quality == ALGSURF_QUALITY_FULL && !scene->complex;
    picture->colours = (algsurf_i_colour_job){&scene->material, picture->lights, picture->light_count};
    picture->at_once = picture->planes.pixels && !scene->complex && !picture->shadows &&
                       scene->quality != ALGSURF_QUALITY_PREVIEW;
    algsurf_i_count_samples(picture);
    algsurf_i_scene_ball(scene, picture->centre, &picture->radius);
    picture->reach = reach_of(scene, picture->radius);
    picture->kernel = algsurf_i_kernel_find(scene->intersect.kernel);
    picture->code = algsurf_i_picture_kernel_for(picture->kernel);
    if (!algsurf_i_packets_geometry(picture, picture->packets)) picture->packets = NULL;
    picture->tiled = picture->packets && algsurf_i_tiles_pay(picture, picture->packets);
    picture->thin = picture->packets && scene->thin && !scene->complex &&
                    scene->surface->degree <= ALGSURF_MAX_BEAM_DEGREE;
    if (!rays_are_finite(&scene->camera, picture->width, picture->height) ||
        !lights_are_finite(picture->lights, picture->light_count))
        return ALGSURF_E_NOT_FINITE;
    return ALGSURF_OK;
}

/* The caller's struct may be shorter or longer than ours; what is unknown here becomes 0. */
static void write_stats(algsurf_render_stats *stats, const algsurf_i_tally *total, double seconds,
                        int threads, const char *kernel) {
    algsurf_render_stats ours = {.size = sizeof ours,
                                 .rays = total->rays,
                                 .hits = total->hits,
                                 .undecided = total->undecided,
                                 .shadow_rays = total->shadow_rays,
                                 .solve_s = total->solve_s,
                                 .shade_s = total->shade_s,
                                 .total_s = seconds,
                                 .threads = threads,
                                 .iterations = total->iterations,
                                 .single_rays = total->single_rays,
                                 .expand_s = total->expand_s,
                                 .point_s = total->point_s,
                                 .shadow_s = total->shadow_s,
                                 .kernel = kernel,
                                 .tiles = total->tiles.all,
                                 .empty_tiles = total->tiles.empty,
                                 .sheet_tiles = total->tiles.sheets,
                                 .leaf_tiles = total->tiles.leaves,
                                 .empty_rays = total->empty_rays,
                                 .sheet_rays = total->sheet_rays,
                                 .exact_rays = total->exact_rays,
                                 .thin = total->thin};
    algsurf_options_write(stats, &ours, sizeof ours);
}

/* All the memory of a picture, in six blocks. */
typedef struct work_memory {
    algsurf_i_worker *workers;
    algsurf_i_fan *fans; /* of each light */
    double *doubles;     /* lines, middles and trails of all workers, the lights' samples, the frames */
    int *ints;           /* a row for each worker */
    uint16_t *counts;    /* likewise, and of their middles */
    uint8_t *bytes;      /* likewise */
} work_memory;

#define LINE_DOUBLES 18   /* for each pixel, besides normals and a share of each light */
#define LINE_BYTES 2      /* likewise */
#define MIDDLE_DOUBLES 12 /* likewise, in a selective picture */
#define MIDDLE_BYTES 16   /* likewise */
#define MIDDLES 3         /* rows of them */
#define APART 24          /* between a line's arrays: not a multiple of a page apart, for the cache's sake */

static double *take(double **from, size_t count) {
    double *taken = *from;
    *from += count;
    return taken;
}

static int *take_ints(int **from, size_t count) {
    int *taken = *from;
    *from += count;
    return taken;
}

static uint8_t *take_bytes(uint8_t **from, size_t count) {
    uint8_t *taken = *from;
    *from += count;
    return taken;
}

static void lay_out_shown(algsurf_i_shown *shown, size_t width, const algsurf_picture *planes,
                          uint16_t *counts, double **doubles, uint8_t **bytes) {
    shown->samples = counts;
    shown->sum = take(doubles, 3 * (width + APART));
    shown->nearest = take(doubles, width + APART);
    shown->normal = planes->normals ? take(doubles, 3 * (width + APART)) : NULL;
    shown->state = planes->state ? take_bytes(bytes, width) : NULL;
    shown->way = planes->way ? take_bytes(bytes, width) : NULL;
}

/* Places of leaves in a band. */
static size_t places_of(const algsurf_i_picture *picture) {
    size_t across = ((size_t)picture->width + ALGSURF_I_LEAF - 1) / ALGSURF_I_LEAF;
    return across * (ALGSURF_I_TILES / ALGSURF_I_LEAF);
}

static void lay_out_line(algsurf_i_line *line, size_t width, size_t lights, double **doubles) {
    width += APART;
    line->points.t = take(doubles, width);
    for (int k = 0; k < 3; k++) {
        line->points.position[k] = take(doubles, width);
        line->points.normal[k] = take(doubles, width);
        line->points.direction[k] = take(doubles, width);
    }
    line->colour = take(doubles, 3 * width);
    line->depth = take(doubles, width);
    line->visible = take(doubles, lights * width);
}

static void lay_out_middles(algsurf_i_middles *middles, size_t width, const algsurf_picture *planes,
                            uint16_t *counts, double **doubles, uint8_t **bytes) {
    for (size_t slot = 0; slot < MIDDLES; slot++) {
        lay_out_shown(&middles->shown[slot], width, planes, counts + slot * width, doubles, bytes);
        middles->bytes[slot] = take_bytes(bytes, 4 * width);
    }
    middles->wanted = take_bytes(bytes, width);
}

#define TILE_DOUBLES (sizeof(algsurf_i_tile) / sizeof(double))
#define TILING_DOUBLES 6 /* for each pixel of a row */
#define TILING_BYTES 2   /* likewise */

/* Two bands, two levels of lists; side: degree + 1. */
static void lay_out_tiling(algsurf_i_tiling *tiling, size_t width, size_t places, size_t side,
                           double **doubles, int **ints, uint8_t **bytes) {
    for (int b = 0; b < 2; b++) {
        tiling->band[b].number = -1;
        tiling->band[b].cell = take_ints(ints, places);
        tiling->band[b].tiles = (algsurf_i_tile *)(void *)take(doubles, places * TILE_DOUBLES);
    }
    tiling->beam.c = take(doubles, side * side * side);
    tiling->square = take(doubles, side * side);
    tiling->from = take(doubles, 2 * places);
    tiling->to = take(doubles, 2 * places);
    tiling->at = take_ints(ints, 2 * places);
    tiling->low = take(doubles, width);
    tiling->high = take(doubles, width);
    tiling->enough = take(doubles, width);
    tiling->leaf_low = take(doubles, width);
    tiling->leaf_high = take(doubles, width);
    tiling->leaf_depth = take(doubles, width);
    tiling->leaf = take_ints(ints, width);
    tiling->sure = take_bytes(bytes, width);
    tiling->leaf_state = take_bytes(bytes, width);
}

/* Fans of lights are for degrees that beams are for. */
static size_t fans_of(const algsurf_i_picture *picture) {
    int degree = algsurf_surface_degree(picture->scene->surface);
    int fans = picture->packets && picture->shadows && degree <= ALGSURF_MAX_FAN_DEGREE;
    return fans ? (size_t)picture->light_count : 0;
}

static void lay_out_frame(algsurf_i_frame_form *frame, size_t side, double **doubles) {
    frame->q = take(doubles, side * side * side);
    frame->basis = take(doubles, side * side);
    frame->sizes = take(doubles, side * side);
    frame->along = take(doubles, side * side);
}

/* Makes the memory and shares it out.  Returns 0 when there is none; to be freed either way. */
static int hire(algsurf_i_picture *picture, int threads, work_memory *memory) {
    int degree = algsurf_surface_degree(picture->scene->surface);
    size_t width = (size_t)picture->width, count = (size_t)threads;
    size_t side = picture->packets ? (size_t)degree + 1 : 0, frame = side * side * (side + 3);
    size_t lights = picture->shadows ? (size_t)picture->light_count : 0;
    size_t samples = picture->shadows ? (size_t)picture->light_samples.first[picture->light_count] : 0;
    size_t middle = picture->selective ? 1 : 0, rows = 1 + middle * MIDDLES;
    const algsurf_picture *planes = &picture->planes;
    size_t roots = picture->packets && picture->scene->complex ? (size_t)degree : 0;
    size_t doubles_each = LINE_DOUBLES + lights + middle * MIDDLE_DOUBLES + (planes->normals ? 3 * rows : 0) +
                          (roots > 0) + 2 * roots;
    size_t tiled = picture->tiled || picture->thin ? 1 : 0, places = tiled * places_of(picture),
           cube = tiled * side * side * side;
    size_t fans = fans_of(picture);
    size_t solids = fans > 0 ? (size_t)(ALGSURF_I_FANS * ALGSURF_I_FAN_SOLID(degree)) : 0;
    size_t tile_doubles =
        places * (2 * TILE_DOUBLES + 4) + cube + tiled * (side * side + TILING_DOUBLES * width);
    memory->workers = calloc(count, sizeof *memory->workers);
    memory->doubles = calloc(count * ((width + APART) * doubles_each + tile_doubles + solids) +
                                 frame * (1 + fans) + 5 * samples + cube,
                             sizeof *memory->doubles);
    memory->fans = calloc(fans + 1, sizeof *memory->fans);
    memory->ints = calloc(count * (2 * width + tiled * width + 4 * places), sizeof *memory->ints);
    memory->counts = calloc(count * width * rows, sizeof *memory->counts);
    memory->bytes = calloc(count * width, LINE_BYTES + middle * MIDDLE_BYTES + tiled * TILING_BYTES +
                                              (planes->way ? 1 + rows : 0));
    if (!memory->fans || !memory->workers || !memory->doubles || !memory->ints || !memory->counts ||
        !memory->bytes)
        return 0;
    double *doubles = memory->doubles;
    int *ints = memory->ints;
    uint8_t *bytes = memory->bytes;
    for (size_t i = 0; i < count; i++) {
        algsurf_i_worker *worker = &memory->workers[i];
        worker->line.pixel = take_ints(&ints, width);
        if (picture->scene->antialias == 1) worker->line.points.bytes = (uint32_t *)take_ints(&ints, width);
        uint16_t *counts = memory->counts + i * width * rows;
        worker->line.state = take_bytes(&bytes, width);
        worker->line.way = planes->way ? take_bytes(&bytes, width) : NULL;
        lay_out_line(&worker->line, width, lights, &doubles);
        if (fans > 0) worker->line.solids = take(&doubles, solids);
        lay_out_shown(&worker->line.shown, width, planes, counts, &doubles, &bytes);
        if (picture->selective)
            lay_out_middles(&worker->middles, width, planes, counts + width, &doubles, &bytes);
        if (tiled) lay_out_tiling(&worker->tiling, width, places, side, &doubles, &ints, &bytes);
        if (roots == 0) continue;
        worker->line.imaginary = take(&doubles, width + APART);
        worker->trail.x = take(&doubles, roots * width);
        worker->trail.y = take(&doubles, roots * width);
    }
    for (int k = 0; k < 3; k++) picture->light_samples.place[k] = take(&doubles, samples);
    for (int k = 0; k < 2; k++) picture->light_samples.aside[k] = take(&doubles, samples);
    if (picture->packets) lay_out_frame(&picture->packets->frame, side, &doubles);
    if (tiled) picture->packets->beams = take(&doubles, cube);
    if (picture->packets) picture->packets->fans = fans > 0 ? memory->fans : NULL;
    for (size_t i = 0; i < fans; i++) lay_out_frame(&memory->fans[i].frame, side, &doubles);
    return 1;
}

static void release(work_memory *memory) {
    free(memory->workers);
    free(memory->fans);
    free(memory->doubles);
    free(memory->ints);
    free(memory->counts);
    free(memory->bytes);
}

/* Brings P to the picture's view; a frame that leaves the range of double is done without packets. */
static algsurf_status make_frame(algsurf_i_picture *picture) {
    if (!picture->packets) return ALGSURF_OK;
    const algsurf_surface *surface = picture->scene->surface;
    void *memory = malloc(algsurf_i_frame_memory(surface->degree));
    if (!memory) return ALGSURF_E_NO_MEMORY;
    if (!algsurf_i_frame_expand(surface, &picture->packets->frame, memory)) picture->packets = NULL;
    if (picture->packets && picture->packets->fans) algsurf_i_make_fans(picture, memory);
    free(memory);
    if (picture->packets && (picture->tiled || picture->thin))
        algsurf_i_beam_expand(&picture->packets->frame, picture->packets->beams);
    picture->single = picture->packets && algsurf_i_single_suits(picture);
    if (picture->single) picture->code = algsurf_i_single_kernel_for(picture->kernel);
    return ALGSURF_OK;
}

static ALGSURF_NOINLINE algsurf_status draw(algsurf_i_picture *picture, const algsurf_render_options *options,
                                            algsurf_i_tally *total, int *threads_used) {
    work_memory memory;
    int threads = thread_count(options);
    double begun = algsurf_i_render_clock();
    algsurf_status status = ALGSURF_E_NO_MEMORY;
    if (hire(picture, threads, &memory)) {
        if (picture->shadows) algsurf_i_place_samples(picture);
        status = make_frame(picture);
    }
    double expanded = algsurf_i_render_clock();
    if (status == ALGSURF_OK)
        status = algsurf_i_render_crew(picture, options, threads, memory.workers, total, threads_used);
    total->expand_s += expanded - begun;
    release(&memory);
    return status;
}

/* In the standard environment. */
static ALGSURF_NOINLINE algsurf_status render(const algsurf_scene *scene,
                                              const algsurf_render_options *options,
                                              const algsurf_picture *planes, algsurf_render_stats *stats) {
    double begin = algsurf_i_render_clock();
    algsurf_i_packets packets;
    algsurf_i_picture picture = {.packets = &packets};
    algsurf_render_options o;
    algsurf_i_tally total = {0};
    int threads = 0;

    if (!scene || (stats && stats->size < sizeof *stats)) return ALGSURF_E_ARGUMENT;
    algsurf_status status = read_options(options, &o);
    if (status == ALGSURF_OK) status = read_planes(planes, o.width, &picture);
    if (status == ALGSURF_OK) status = prepare(scene, &o, &picture);
    if (status == ALGSURF_OK) status = draw(&picture, &o, &total, &threads);
    if (status >= 0 && total.without_memory > 0) status = ALGSURF_E_NO_MEMORY;
    if ((status >= 0 || total.without_memory > 0) && stats)
        write_stats(stats, &total, algsurf_i_render_clock() - begin, threads, picture.kernel->name);
    return status;
}

algsurf_status algsurf_render(const algsurf_scene *scene, const algsurf_render_options *options,
                              const algsurf_picture *picture, algsurf_render_stats *stats) {
    algsurf_fpenv saved;
    algsurf_fpenv_enter(&saved);
    algsurf_status status = render(scene, options, picture, stats);
    algsurf_fpenv_leave(&saved);
    return status;
}
