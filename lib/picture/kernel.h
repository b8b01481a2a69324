/* kernel.h - a row of pixels: depths, points, colours, by every kernel. */
#ifndef ALGSURF_PICTURE_KERNEL_H
#define ALGSURF_PICTURE_KERNEL_H
#include <stdint.h>

#include "../complex/edges.h"
#include "../simd/kernel.h"
#include "../surface/view.h"
#include "algsurf/ray.h"
#include "algsurf/shade.h"

/* The pixels of one row, one ray each: pixel x has u = u0 + du a, a = (x + offset) pixel. */
typedef struct algsurf_i_row_job {
    const algsurf_i_view *view;
    const double *basis;                 /* of the frame */
    const algsurf_i_row_form *row;       /* its v is the row's */
    double offset, pixel, u0, du, slope; /* slope = alpha v + beta[1]; a is the slope alpha u + beta[0] */
    const algsurf_extent *extent;        /* sphere or box, about the view's centre */
    double extent_size[3];               /* in the view's unit */
    double near;                         /* depth of the eye; the ray begins there */
    int bounded;                         /* 0: signs as computed (the fast tier) */
    double tolerance;                    /* wanted error of the depth; 0: all that the coefficients tell */
} algsurf_i_row_job;

/* N points of the surface, or rays that reach them: structure of arrays. */
typedef struct algsurf_i_points {
    double *t, *position[3], *normal[3], *direction[3];
} algsurf_i_points;

/* From depths to points, for pixels of one row. */
typedef struct algsurf_i_point_job {
    const algsurf_surface *surface;
    const algsurf_i_row_job *row;
} algsurf_i_point_job;

/* A row in complex space.  Arrays have an entry for each pixel of the row; root i of pixel x is at
 * i stride + x. */
typedef struct algsurf_i_complex_job {
    const algsurf_i_row_job *row;
    const algsurf_i_sector_edges *sector;
    const double *imaginary; /* parts of t^k in natural units and scale, */
    int top;                 /* k <= top; -1: there are none */
    double *x, *y;           /* roots to start from, NaN for none; then those found */
    int stride;
    double *re, *im; /* depth of the root that is seen */
    uint8_t *state;
} algsurf_i_complex_job;

typedef struct algsurf_i_colour_job {
    const algsurf_material *material;
    const algsurf_light *lights; /* at their middles */
    int light_count;
} algsurf_i_colour_job;

typedef struct algsurf_i_picture_kernel {
    /* depth[x], state[x] for begin <= x < end: the first root along each ray. */
    void (*solve_row)(const algsurf_i_row_job *job, int begin, int end, double *depth, uint8_t *state);
    /* Entry i of points from depth[i] at pixel[i]: after one Newton step on P itself, t along the unit ray
     * from the eye, position, unit normal (0 at a singular point), unit direction, in the caller's units. */
    void (*points)(const algsurf_i_point_job *job, const int *pixel, const double *depth, int count,
                   const algsurf_i_points *points);
    /* colour[3 i ..] of entry i, as algsurf_shade; visible: null or light_count for each entry. */
    void (*colours)(const algsurf_i_colour_job *job, const algsurf_i_points *points, int count,
                    const double *visible, double *colour);
    /* solve_row in complex space; returns how many corrections of roots it took. */
    uint64_t (*solve_complex)(const algsurf_i_complex_job *job, int begin, int end);
    /* points in complex space: entry i from the root re[i], im[i], whose own derivative and gradient tell the
     * normal. */
    void (*complex_points)(const algsurf_i_complex_job *job, const algsurf_surface *surface, const int *pixel,
                           const double *re, const double *im, int count, const algsurf_i_points *points);
} algsurf_i_picture_kernel;

extern const algsurf_i_picture_kernel algsurf_i_picture_avx512, algsurf_i_picture_avx2,
    algsurf_i_picture_baseline;

/* The code for a kernel. */
const algsurf_i_picture_kernel *algsurf_i_picture_kernel_for(const algsurf_i_kernel *kernel);

#endif
