/* thin.c - the pixels of a row beside whose rays there is something thin. */
#include "../base/arithmetic.h"
#include <math.h>

#include "../base/vec.h"
#include "impl.h"

#define END_ON 0x1p-10 /* the sine of an angle */

/* The direction from a line's axis, or a point, towards the viewer, as a normal; of a line that is seen from
 * its end, as of a point. */
static void face(const double direction[3], const double along[3], double normal[3]) {
    const double share = algsurf_dot(direction, along);
    for (int k = 0; k < 3; k++) normal[k] = share * along[k] - direction[k];
    const double length = algsurf_length(normal);
    for (int k = 0; k < 3; k++) normal[k] = length > END_ON ? normal[k] / length : -direction[k];
}

/* Entry i gets the colour of a place on what is thin. */
static void colour(const algsurf_i_picture *picture, const algsurf_ray *ray, double t, const double along[3],
                   algsurf_i_line *line, int i) {
    algsurf_i_looks looks;
    double position[3], normal[3];
    for (int k = 0; k < 3; k++) {
        position[k] = ray->origin[k] + t * ray->direction[k];
        looks.place[k] = line->points.looks.place[k] + i;
        looks.normal[k] = line->points.looks.normal[k] + i;
        looks.direction[k] = line->points.looks.direction[k] + i;
    }
    face(ray->direction, along, normal);
    algsurf_i_set_look(&picture->thin_colours.frame, position, normal, ray->direction, 0, &looks);
    picture->shader->colours(&picture->thin_colours, &looks, 1, NULL,
                             line->across == 1 ? NULL : line->colour + 3 * i, line->bytes + i);
}

/* Sample x shows what is thin instead of what it shows: its entry. */
static int show(int x, double t, algsurf_i_line *line, int point) {
    int i = point >= 0 ? point : line->count++;
    line->pixel[i] = x;
    line->state[x] = ALGSURF_STATE_THIN;
    line->points.t[i] = t;
    for (int k = 0; k < 3; k++) line->points.normal[k][i] = 0;
    return i;
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
void algsurf_i_prepare_thin(algsurf_i_geometry *p) {
    const int n = p->frame.degree;
    double most[ALGSURF_MAX_VIEW_DEGREE + 1] = {0};
    p->rays.thin_side = fabs(p->rays.du) * p->rays.pixel;
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

/* Leaves out those in pixels through which nothing thin is seen. */
static void keep_wanted(const algsurf_i_line *line, algsurf_i_dips *dips) {
    int kept = 0;
    for (int i = 0; i < dips->count; i++) {
        if (line->wanted[dips->at[i] / line->dense] < 2) continue;
        dips->at[kept] = dips->at[i];
        dips->depth[kept++] = dips->depth[i];
    }
    dips->count = kept;
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
    double *const *along = worker->tiling.thin_along;
    algsurf_i_row_job job;
    if (line->wanted) keep_wanted(line, dips);
    if (dips->count == 0) return;
    algsurf_i_make_row(picture, row + sy, sx, line->dense, &worker->form, &job);
    const algsurf_i_point_job points = {scene->surface, &job, NULL, 0};
    picture->code->find_thin(&points, dips, worker->tiling.thin, along);
    for (int i = 0; i < dips->count; i++) {
        const int x = dips->at[i], is_hit = line->state[x] == ALGSURF_STATE_HIT &&
                                            scene->intersect.undecided_as != ALGSURF_AS_HIT;
        if (!(depth[i] < HUGE_VAL) || line->state[x] == ALGSURF_STATE_THIN) continue;
        algsurf_ray ray;
        algsurf_i_camera_ray(&scene->camera, picture->width, picture->height, (x + sx) / line->dense,
                             row + sy, &ray);
        /* depth along the ray, for a t of 1 */
        double per_t = ldexp(algsurf_dot(ray.direction, scene->camera.forward), -scene->surface->unit) /
                       picture->geometry->frame.view.size;
        int point = point_of(line, x);
        if (is_hit && depth[i] > job.near + line->points.t[point] * per_t - job.thin_before) continue;
        const double t = (depth[i] - job.near) / per_t,
                     line_along[3] = {along[0][i], along[1][i], along[2][i]};
        const int entry = show(x, t, line, point);
        if (line->colours) colour(picture, &ray, t, line_along, line, entry);
        worker->tally->stats.thin++;
    }
}
