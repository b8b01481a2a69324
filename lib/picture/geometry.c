/* geometry.c - the rays of a row as a job for kernels, and which of them its forms are for.
 *
 * Misses.  A ray's point at depth z has x = u + z (alpha u + beta), and |z| <= 1 in the ball of radius 1 about
 * what is shown.  So |x| >= |u| (1 - |alpha|) - |beta| there: where that exceeds 1, the ray misses.  The same
 * holds for y.  On one side of the picture u changes one way from pixel to pixel, and so, for |alpha| < 1,
 * the pixels beyond one that misses miss, too.  CLEAR covers the view's noise, which is below 2^-22, and all
 * roundings here. */
#include "../base/arithmetic.h"
#include "geometry.h"

#include <math.h>

#include "impl.h"

algsurf_i_row_job algsurf_i_any_row(const algsurf_i_picture *picture) {
    const algsurf_i_packets *p = picture->packets;
    return (algsurf_i_row_job){.view = &p->frame.view,
                               .basis = p->frame.basis,
                               .offset = -0.5 * picture->width,
                               .pixel = p->pixel,
                               .u0 = p->origin[0],
                               .du = p->per_slope,
                               .extent = &picture->scene->extent,
                               .extent_size = {p->extent_size[0], p->extent_size[1], p->extent_size[2]},
                               .planes = p->view_planes,
                               .plane_count = p->plane_count,
                               .near = p->near,
                               .tolerance = p->tolerance,
                               .thin_side = p->thin_side,
                               .thin_before = 4 * p->thin_side,
                               .thin_bends = p->thin_bends};
}

void algsurf_i_make_row(const algsurf_i_picture *picture, double y, double sx, algsurf_i_row_form *form,
                        algsurf_i_row_job *job) {
    const algsurf_i_packets *p = picture->packets;
    const algsurf_i_view *view = &p->frame.view;
    form->v = p->origin[1] + p->per_slope * ((0.5 * picture->height - y) * p->pixel);
    *job = algsurf_i_any_row(picture);
    job->row = form;
    job->offset += sx;
    job->slope = view->alpha * form->v + view->beta[1];
}

/* The error bounds of forms hold for rays that stay within this of the view's centre in x and y, over the
 * depths of what is shown, |z| <= 1 (sight_template.h); a little less is used. */
#define BOUND (4 - 0x1p-10)
#define CLEAR (1 + 0x1p-10)

/* Do rays at w, one of u and v, surely miss?  beta: the view's for that axis. */
static int is_clear(double w, double alpha, double beta) {
    return fabs(w) * (1 - fabs(alpha)) - fabs(beta) > CLEAR;
}

/* Do all rays between two heights surely miss? */
static int are_clear(const algsurf_i_packets *p, double v0, double v1) {
    const algsurf_i_view *view = &p->frame.view;
    return (v0 > 0) == (v1 > 0) && is_clear(v0, view->alpha, view->beta[1]) &&
           is_clear(v1, view->alpha, view->beta[1]);
}

int algsurf_i_pixels_within_bounds(const algsurf_i_picture *picture, double top, double bottom, int step,
                                   int *begin, int *end) {
    const algsurf_i_packets *p = picture->packets;
    const algsurf_i_view *view = &p->frame.view;
    double spread = 1 + fabs(view->alpha), half = 0.5 * picture->width, per = p->per_slope * p->pixel;
    double v0 = p->origin[1] + per * (0.5 * picture->height - top);
    double v1 = p->origin[1] + per * (0.5 * picture->height - bottom);
    *begin = *end = 0;
    if (are_clear(p, v0, v1)) return 1;
    if (!(fmax(fabs(v0), fabs(v1)) * spread + fabs(view->beta[1]) < BOUND)) return 0;
    /* what is so many pixels or less from the middle is within them */
    double room = ((BOUND - fabs(view->beta[0])) / spread - fabs(p->origin[0])) / fabs(per);
    double whole = step * ceil((double)picture->width / step);
    double first = step * ceil(fmax(half - room, 0) / step), last = step * floor(fmin(half + room, whole) / step);
    if (!(first < last)) return 0;
    *begin = (int)first;
    *end = (int)fmin(last, picture->width);
    double u0 = p->origin[0] + per * (*begin - half), u1 = p->origin[0] + per * (*end - half);
    return (*begin == 0 || (per * u0 < 0 && is_clear(u0, view->alpha, view->beta[0]))) &&
           (*end == picture->width || (per * u1 > 0 && is_clear(u1, view->alpha, view->beta[0])));
}
