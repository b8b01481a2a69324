/* render_row.c - one row of a picture.
 *
 * A row is drawn in n x n passes, one for each sample of the pixels' grid: first all rays of the pass
 * meet the surface, then all hits are shaded.  So the buffer holds one row of one sample, however many
 * samples a pixel has, and solving and shading can be timed with two clock readings a pass.
 */
#define _POSIX_C_SOURCE 200809L /* clock_gettime */
#include "render_impl.h"

#include <time.h>

#include "camera_impl.h"
#include "shade_impl.h"
#include "vec.h"

double algsurf_i_render_clock(void) {
    struct timespec now = {0, 0};
    (void)clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static int stopped(const algsurf_i_picture *picture) {
    return atomic_load_explicit(&picture->stop, memory_order_relaxed);
}

/* The ray through offset (sx,sy) in each pixel of the row, and its hit. */
static algsurf_status solve_pass(const algsurf_i_picture *picture, int row, double sx, double sy,
                                 algsurf_i_worker *worker, algsurf_i_tally *tally) {
    const algsurf_scene *scene = picture->scene;
    for (int x = 0; x < picture->width; x++) {
        algsurf_i_pixel *pixel = &worker->pixels[x];
        if (stopped(picture)) return ALGSURF_CANCELLED;
        algsurf_i_camera_ray(&scene->camera, picture->width, picture->height, x + sx, row + sy, &pixel->ray);
        algsurf_status status = scene->complex
                                    ? algsurf_i_render_complex(picture, x, &worker->trail, pixel, tally)
                                    : algsurf_intersect_first(scene->surface, &scene->extent, &pixel->ray,
                                                              &scene->intersect, &pixel->hit);
        if (status < 0) return status;
        tally->rays++;
        tally->hits += pixel->hit.state == ALGSURF_HIT;
        tally->uncertain += pixel->hit.state == ALGSURF_UNCERTAIN;
    }
    algsurf_i_trail *trail = &worker->trail;
    *trail = (algsurf_i_trail){.above = trail->row, .row = trail->above, .has_above = 1};
    return ALGSURF_OK;
}

/* Depth of a point along the view: 0 at the near end of what is shown, 1 at its far end.  Measured from
 * its centre, so that a far eye costs no digits. */
static double depth_of(const algsurf_i_picture *picture, const double point[3]) {
    double from_centre[3];
    for (int i = 0; i < 3; i++) from_centre[i] = point[i] - picture->centre[i];
    double along = algsurf_dot(from_centre, picture->scene->camera.forward) / picture->reach;
    return fmin(1, fmax(0, 0.5 + 0.5 * along));
}

static algsurf_status colour_of(const algsurf_i_picture *picture, const algsurf_i_pixel *pixel,
                                double colour[3], uint64_t *shadow_rays) {
    const algsurf_scene *scene = picture->scene;
    const algsurf_hit *hit = &pixel->hit;
    double visible[ALGSURF_MAX_LIGHTS], *shares = NULL;
    if (hit->state == ALGSURF_MISS) {
        for (int i = 0; i < 3; i++) colour[i] = scene->background[i];
        return ALGSURF_OK;
    }
    if (scene->quality == ALGSURF_QUALITY_PREVIEW) {
        algsurf_i_shade_preview(&scene->material, hit->normal, pixel->ray.direction,
                                depth_of(picture, hit->position), colour);
        return ALGSURF_OK;
    }
    if (scene->quality == ALGSURF_QUALITY_FULL && !scene->complex) {
        shares = visible;
        algsurf_status status = algsurf_i_render_shadows(picture, pixel, shares, shadow_rays);
        if (status < 0) return status;
    }
    algsurf_i_shade(&scene->material, picture->lights, picture->light_count, shares, hit->position,
                    hit->normal, pixel->ray.direction, colour);
    return ALGSURF_OK;
}

static algsurf_status shade_pass(const algsurf_i_picture *picture, algsurf_i_pixel *buffer,
                                 algsurf_i_tally *tally) {
    for (int x = 0; x < picture->width; x++) {
        algsurf_i_pixel *pixel = &buffer[x];
        double colour[3];
        if (stopped(picture)) return ALGSURF_CANCELLED;
        algsurf_status status = colour_of(picture, pixel, colour, &tally->shadow_rays);
        if (status < 0) return status;
        for (int i = 0; i < 3; i++) pixel->colour[i] += fmin(1, fmax(0, colour[i]));
        if (pixel->hit.state != ALGSURF_MISS && !(pixel->nearest <= pixel->hit.t))
            pixel->nearest = pixel->hit.t;
    }
    return ALGSURF_OK;
}

/* The averages over the samples as bytes, and the nearest hits. */
static void store_row(const algsurf_i_picture *picture, int row, const algsurf_i_pixel *buffer) {
    size_t index = (size_t)(row - picture->row_begin), width = (size_t)picture->width;
    double samples = (double)picture->scene->antialias * picture->scene->antialias;
    uint8_t *bytes = picture->pixels + index * picture->stride;
    for (size_t x = 0; x < width; x++) {
        for (int i = 0; i < 3; i++)
            bytes[3 * x + (size_t)i] = (uint8_t)(255 * (buffer[x].colour[i] / samples) + 0.5);
        if (picture->hits) picture->hits[index * width + x] = buffer[x].nearest;
    }
}

algsurf_status algsurf_i_render_row(const algsurf_i_picture *picture, int row, algsurf_i_worker *worker,
                                    algsurf_i_tally *tally) {
    algsurf_i_pixel *buffer = worker->pixels;
    int n = picture->scene->antialias;
    for (int x = 0; x < picture->width; x++) {
        for (int i = 0; i < 3; i++) buffer[x].colour[i] = 0;
        buffer[x].nearest = NAN;
    }
    for (int k = 0; k < n * n; k++) {
        double begin = algsurf_i_render_clock();
        algsurf_status status = solve_pass(picture, row, (k % n + 0.5) / n, (k / n + 0.5) / n, worker, tally);
        double middle = algsurf_i_render_clock();
        if (status == ALGSURF_OK) status = shade_pass(picture, buffer, tally);
        tally->solve_s += middle - begin;
        tally->shade_s += algsurf_i_render_clock() - middle;
        if (status != ALGSURF_OK) return status;
    }
    store_row(picture, row, buffer);
    return ALGSURF_OK;
}
