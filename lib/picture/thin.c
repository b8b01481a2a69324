/* thin.c - the pixels of a row beside whose rays there is something thin. */
#include "../base/arithmetic.h"
#include <math.h>

#include "../base/vec.h"
#include "impl.h"
#include "srgb.h"

/* Of depth along the ray, for a t of 1. */
static double depth_per_t(const algsurf_i_picture *picture, const algsurf_ray *ray) {
    const algsurf_i_view *view = &picture->geometry->frame.view;
    double forward = algsurf_dot(ray->direction, picture->scene->camera.forward);
    return ldexp(forward, -picture->scene->surface->unit) / view->size;
}

/* Sample x shows what is thin instead of what it shows. */
static void show(const algsurf_i_picture *picture, int x, double t, algsurf_i_line *line, int point) {
    int i = point >= 0 ? point : line->count++;
    line->pixel[i] = x;
    line->state[x] = ALGSURF_STATE_THIN;
    line->points.t[i] = t;
    line->bytes[i] = 0;
    for (int k = 0; k < 3; k++) {
        double light = picture->scene->thin_colour[k];
        line->bytes[i] |= (uint32_t)algsurf_i_byte_of(picture->curve, light) << 8 * k;
        line->points.normal[k][i] = 0;
        line->colour[3 * i + k] = (float)light;
    }
}

/* Adds what P's terms of each degree are at most in a direction, but for the length of that: to `most`. */
static void look_in(const algsurf_i_frame_form *frame, const double d[3], double *most) {
    const int n = frame->degree, side = n + 1;
    double sum[ALGSURF_MAX_VIEW_DEGREE + 1] = {0}, size = 1, length = algsurf_length(d), x = 1;
    for (int i = 0; i <= n; i++, x *= d[0]) {
        double y = x;
        for (int j = 0; i + j <= n; j++, y *= d[1]) {
            const double *q = frame->q + (i * side + j) * side;
            double z = y;
            for (int k = 0; i + j + k <= n; k++, z *= d[2]) sum[i + j + k] += q[k] * z;
        }
    }
    for (int m = 0; m <= n; m++, size *= length) most[m] = fmax(most[m], fabs(sum[m]) / size);
}

/* The largest of them in 3 n^2 directions, through a lattice on the faces of a cube, are taken for the
 * largest of all. */
void algsurf_i_prepare_thin(algsurf_i_geometry *p, int across) {
    const int n = p->frame.degree;
    double most[ALGSURF_MAX_VIEW_DEGREE + 1] = {0};
    p->rays.thin_side = fabs(p->rays.du) * p->rays.pixel / across;
    p->rays.thin_before = 4 * p->rays.thin_side;
    double pixel = p->rays.thin_side * (1 + fabs(p->frame.view.alpha));
    for (int i = 0; i < n * n; i++) {
        const double a = (2 * (i % n) + 1.0) / n - 1, b = (2 * (i / n) + 1.0) / n - 1;
        look_in(&p->frame, (const double[]){1, a, b}, most);
        look_in(&p->frame, (const double[]){b, 1, a}, most);
        look_in(&p->frame, (const double[]){a, b, 1}, most);
    }
    for (int m = 0; m <= n; m++) p->thin_bends[m] = 0.5 * m * (m - 1) * (pixel * pixel) * most[m];
}

static int point_of(const algsurf_i_line *line, int x) {
    int i = line->count - 1;
    while (i >= 0 && line->pixel[i] != x) i--;
    return i;
}

void algsurf_i_add_thin(algsurf_i_worker *worker, int row, double sx, double sy) {
    const algsurf_i_picture *picture = worker->picture;
    const algsurf_scene *scene = picture->scene;
    algsurf_i_line *line = &worker->line;
    algsurf_i_dips *dips = &worker->tiling.dips;
    const double *depth = worker->tiling.thin;
    algsurf_i_row_job job;
    if (dips->count == 0) return;
    algsurf_i_make_row(picture, row + sy, sx, &worker->form, &job);
    const algsurf_i_point_job points = {scene->surface, &job, NULL, 0};
    picture->code->find_thin(&points, dips, worker->tiling.thin);
    for (int i = 0; i < dips->count; i++) {
        const int x = dips->at[i], is_hit = line->state[x] == ALGSURF_STATE_HIT &&
                                            scene->intersect.undecided_as != ALGSURF_AS_HIT;
        if (!(depth[i] < HUGE_VAL) || line->state[x] == ALGSURF_STATE_THIN) continue;
        algsurf_ray ray;
        algsurf_i_camera_ray(&scene->camera, picture->width, picture->height, x + sx, row + sy, &ray);
        double per_t = depth_per_t(picture, &ray);
        int point = point_of(line, x);
        if (is_hit && depth[i] > job.near + line->points.t[point] * per_t - job.thin_before) continue;
        show(picture, x, (depth[i] - job.near) / per_t, line, point);
        worker->tally->stats.thin++;
    }
}
