/* geometry.c - the rays of a row as a job for kernels, and which of them need to be looked at.
 *
 * Clear rays.  A line of sight has the squared distance (u^2 + v^2 + (u b - v a)^2) / (1 + a^2 + b^2) from
 * the view's centre, with a = alpha u + beta_0, b = alpha v + beta_1: so it misses the ball of radius 1, in
 * which all is that is shown, if g(u) = u^2 + v^2 + (u b - v a)^2 - c (1 + a^2 + b^2) > 0,   c = 1. In the
 * plane of x and z alone, where the ball is a disc, g(u) = u^2 - c (1 + a^2) tells the same of all v. As u b
 * - v a = u beta_1 - v beta_0, both are quadratic in u, and convex where their leading coefficient is
 * positive.  Then, if g(u) > 0 on one side of the vertex, it is so for all u further out.
 *     c = CLEAR is larger than 1 by 2^-10, which covers the view's noise, below 2^-22, and the roundings of
 * u, v and g: for |v|, |beta| <= 4 these are below 2^-40 (1 + u^2) where g is convex, and g has to exceed
 * SURE (1 + u^2).
 *     In all of space no ray is clear. */
#include "../base/arithmetic.h"
#include "impl.h"

#include <math.h>

void algsurf_i_make_row(const algsurf_i_picture *picture, double y, double sx, int dense,
                        algsurf_i_row_form *form, algsurf_i_row_job *job) {
    const algsurf_i_geometry *p = picture->geometry;
    const algsurf_i_view *view = &p->frame.view;
    form->v = p->v0 + p->rays.du * ((0.5 * picture->height - y) * p->rays.pixel);
    *job = p->rays;
    job->row = form;
    job->offset = dense > 1 ? 0.5 - 0.5 * picture->width * dense : job->offset + sx;
    job->pixel /= dense;
    job->slope = view->alpha * form->v + view->beta[1];
}

/* The error bounds of forms hold for rays that stay within this of the view's centre in x and y, over the
 * depths of what is shown, |z| <= 1 (sight_template.h); a little less is used. */
#define BOUND (4 - 0x1p-10)
#define CLEAR (1 + 0x1p-10)
#define SURE 0x1p-30

/* g(u) = square u^2 - 2 half u + rest. */
typedef struct clearance {
    double square, half, rest;
} clearance;

/* Of rays at v, for beta = x, y; with y = v = 0, of all v, in the plane of x and z. */
static clearance clearance_of(double alpha, double x, double y, double v) {
    double b = alpha * v + y;
    return (clearance){1 + y * y - CLEAR * alpha * alpha, x * (y * v + CLEAR * alpha),
                       v * v * (1 + x * x) - CLEAR * (1 + x * x + b * b)};
}

/* Are the ray at u and all further out, on the side of larger u (1) or smaller (-1), clear? */
static int is_clear(const clearance *g, double u, int side) {
    double slope = g->square * u - g->half;
    return g->square > SURE && side * slope > 0 && (slope - g->half) * u + g->rest > SURE * (1 + u * u);
}

/* From the first edge (side -1) or the last one (1) on: the last multiple of `step` up to which all is surely
 * clear, by halving; or the edge itself. */
static int clear_up_to(const algsurf_i_picture *picture, const clearance *g, int side, int step) {
    const algsurf_i_row_job *rays = &picture->geometry->rays;
    const double per = rays->du * rays->pixel;
    const int width = picture->width;
    int clear = 0, open = (width + step - 1) / step;
    while (open - clear > 1) {
        int steps = (clear + open) / 2, position = side < 0 ? steps * step : (width / step - steps) * step;
        if (is_clear(g, rays->u0 + per * (position - 0.5 * width), per > 0 ? side : -side))
            clear = steps;
        else
            open = steps;
    }
    if (side < 0) return clear * step;
    return clear == 0 ? width : (width / step - clear) * step;
}

int algsurf_i_pixels_within_bounds(const algsurf_i_picture *picture, double top, double bottom, int step,
                                   int *begin, int *end) {
    const algsurf_i_geometry *p = picture->geometry;
    const algsurf_i_view *view = &p->frame.view;
    const double spread = 1 + fabs(view->alpha), per = p->rays.du * p->rays.pixel,
                 middle = 0.5 * picture->height;
    const double v0 = p->v0 + per * (middle - top), v1 = p->v0 + per * (middle - bottom);
    const int endless = picture->scene->extent.kind == ALGSURF_EXTENT_ALL, one_row = top == bottom;
    clearance rows = {0, 0, 0}, pixels = {0, 0, 0}; /* never */
    if (!endless) {
        rows = clearance_of(view->alpha, view->beta[1], 0, 0);
        pixels = clearance_of(view->alpha, view->beta[0], one_row ? view->beta[1] : 0, one_row ? v0 : 0);
    }
    *begin = *end = 0;
    if (!(fabs(view->beta[0]) < BOUND && fabs(view->beta[1]) < BOUND)) return 0;
    if ((is_clear(&rows, v0, 1) && is_clear(&rows, v1, 1)) ||
        (is_clear(&rows, v0, -1) && is_clear(&rows, v1, -1)))
        return 1;
    if (!(fmax(fabs(v0), fabs(v1)) * spread + fabs(view->beta[1]) < BOUND)) return 0;
    int first = clear_up_to(picture, &pixels, -1, step), last = clear_up_to(picture, &pixels, 1, step);
    if (first >= last) return 1;
    /* what is so many pixels or less from where u is 0 is within the bounds */
    double room = (BOUND - fabs(view->beta[0])) / spread / fabs(per),
           zero = 0.5 * picture->width - p->rays.u0 / per;
    double least = step * ceil((zero - room) / step), most = step * floor((zero + room) / step);
    if (!(fmax(least, first) < fmin(most, last))) return 0;
    *begin = (int)fmax(least, first);
    *end = (int)fmin(most, last);
    return *begin == first && *end == last;
}
