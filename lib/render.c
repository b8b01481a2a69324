/* render.c - a picture: arguments, memory, totals. */
#define _POSIX_C_SOURCE 200809L /* sysconf */
#include "render_impl.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "camera_impl.h"
#include "fpenv.h"
#include "options.h"
#include "vec.h"

#define MAX_SIDE 65535

static algsurf_status read_options(const algsurf_render_options *given, algsurf_render_options *o) {
    if (!given || !algsurf_options_read(o, sizeof *o, given)) return ALGSURF_E_ARGUMENT;
    if (o->row_begin == 0 && o->row_end == 0) o->row_end = o->height;
    int good = o->width >= 1 && o->width <= MAX_SIDE && o->height >= 1 && o->height <= MAX_SIDE &&
               o->row_begin >= 0 && o->row_begin < o->row_end && o->row_end <= o->height && o->threads >= 0 &&
               o->threads <= ALGSURF_MAX_THREADS;
    return good ? ALGSURF_OK : ALGSURF_E_ARGUMENT;
}

/* How many threads to draw with: never more than rows. */
static int thread_count(const algsurf_render_options *options) {
    long threads = options->threads > 0 ? options->threads : sysconf(_SC_NPROCESSORS_ONLN);
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
    atomic_init(&picture->stop, 0);
    picture->light_count = algsurf_i_scene_lights(scene, picture->lights);
    algsurf_i_scene_ball(scene, picture->centre, &picture->radius);
    picture->reach = reach_of(scene, picture->radius);
    if (!rays_are_finite(&scene->camera, picture->width, picture->height) ||
        !lights_are_finite(picture->lights, picture->light_count))
        return ALGSURF_E_NOT_FINITE;
    return ALGSURF_OK;
}

/* The caller's struct may be shorter or longer than ours; what is unknown here becomes 0. */
static void write_stats(algsurf_render_stats *stats, const algsurf_i_tally *total, double seconds,
                        int threads) {
    size_t size = stats->size;
    algsurf_render_stats ours = {.size = size,
                                 .rays = total->rays,
                                 .hits = total->hits,
                                 .uncertain = total->uncertain,
                                 .shadow_rays = total->shadow_rays,
                                 .solve_s = total->solve_s,
                                 .shade_s = total->shade_s,
                                 .total_s = seconds,
                                 .threads = threads,
                                 .iterations = total->iterations};
    memset(stats, 0, size);
    memcpy(stats, &ours, size < sizeof ours ? size : sizeof ours);
}

typedef struct work_memory {
    algsurf_i_pixel *pixels; /* a row for each worker */
    algsurf_complex *roots;  /* two rows for each in complex space, else null */
} work_memory;

/* Makes the memory and shares it out.  Returns 0 when there is none; to be freed either way. */
static int hire(const algsurf_i_picture *picture, int threads, work_memory *memory,
                algsurf_i_worker *workers) {
    size_t width = (size_t)picture->width,
           row = width * (size_t)algsurf_surface_degree(picture->scene->surface);
    int rooted = picture->scene->complex && row > 0;
    memory->pixels = calloc((size_t)threads, width * sizeof *memory->pixels);
    memory->roots = rooted ? calloc((size_t)threads, 2 * row * sizeof *memory->roots) : NULL;
    if (!memory->pixels || (rooted && !memory->roots)) return 0;
    for (size_t i = 0; i < (size_t)threads; i++) {
        workers[i] = (algsurf_i_worker){.pixels = memory->pixels + i * width};
        if (!rooted) continue;
        workers[i].trail.row = memory->roots + 2 * i * row;
        workers[i].trail.above = workers[i].trail.row + row;
    }
    return 1;
}

algsurf_status algsurf_render(const algsurf_scene *scene, const algsurf_render_options *options,
                              uint8_t *pixels, size_t stride, double *hits, algsurf_render_stats *stats) {
    double begin = algsurf_i_render_clock();
    algsurf_i_picture picture = {.pixels = pixels, .stride = stride, .hits = hits};
    algsurf_i_worker workers[ALGSURF_MAX_THREADS];
    algsurf_render_options o;
    work_memory memory;
    algsurf_i_tally total;
    algsurf_fpenv saved;
    int threads;

    if (!scene || !pixels || (stats && stats->size < sizeof stats->size)) return ALGSURF_E_ARGUMENT;
    algsurf_status status = read_options(options, &o);
    if (status != ALGSURF_OK) return status;
    if (stride < 3 * (size_t)o.width) return ALGSURF_E_ARGUMENT;
    algsurf_fpenv_enter(&saved);
    status = prepare(scene, &o, &picture);
    algsurf_fpenv_leave(&saved);
    if (status != ALGSURF_OK) return status;

    threads = thread_count(&o);
    status = hire(&picture, threads, &memory, workers)
                 ? algsurf_i_render_crew(&picture, &o, threads, workers, &total, &threads)
                 : ALGSURF_E_NO_MEMORY;
    free(memory.pixels);
    free(memory.roots);
    if (status >= 0 && stats) write_stats(stats, &total, algsurf_i_render_clock() - begin, threads);
    return status;
}
