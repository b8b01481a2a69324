/* rows.h - what is asked of the kernels about rows of pixels and of tiles, and what they tell. */
#ifndef ALGSURF_BEAMS_ROWS_H
#define ALGSURF_BEAMS_ROWS_H
#include <stdint.h>

#include "../complex/edges.h"
#include "../simd/kernel.h"
#include "../surface/beam.h"
#include "../surface/view.h"
#include "algsurf/ray.h"

/* A cutting plane about a view's centre and in its unit: it keeps normal.X <= offset, with a normal of length
 * 1, but for `error` in the distance of points X of what is shown. */
typedef struct algsurf_i_cut_plane {
    double normal[3], offset, error;
} algsurf_i_cut_plane;

/* The pixels of one row, one ray each: pixel x has u = u0 + du a, a = (x + offset) pixel. */
typedef struct algsurf_i_row_job {
    const algsurf_i_view *view;
    const double *basis;                 /* of the frame */
    const algsurf_i_row_form *row;       /* its v is the row's */
    double offset, pixel, u0, du, slope; /* slope = alpha v + beta[1]; a is the slope alpha u + beta[0] */
    const algsurf_extent *extent;        /* sphere or box about the view's centre, or all of space */
    int degree;                          /* P's along the rays, at most; for all of space */
    double extent_size[3];               /* in the view's unit */
    const algsurf_i_cut_plane *planes;   /* in the view's axes */
    int plane_count;
    double plane_room; /* added to their offsets */
    double near;       /* depth of the eye; the ray begins there */
    double tolerance;  /* wanted error of the depth; 0: all that the coefficients tell */
    /* what is thin: of a pixel the side in u and v; what belongs to a hit before it; |P| is large, at r from
     * the view's centre, beyond sum thin_bends[m] r^(m-2), m >= 2 */
    double thin_side, thin_before;
    const double *thin_bends;
} algsurf_i_row_job;

/* Pixels of a row, any: no ray has a root on its chord before the depth `low`.  In all of space chords are
 * the depths [-1,1], and a low > -1 tells, too, that the ray has a root in [low,1] or none. */
typedef struct algsurf_i_pixels {
    int count;
    const int *at;
    const double *low;
} algsurf_i_pixels;

/* Places before the hits of a row, or anywhere along rays that miss, where |P| is least, and not large: the
 * pixels, from the left, and the depths, which increase in each. */
typedef struct algsurf_i_dips {
    int count, *at;
    double *depth;
} algsurf_i_dips;

#define ALGSURF_I_MOST_DIPS 4 /* of a pixel */

#define ALGSURF_I_LEAF 4 /* pixels: the sides of the smallest tiles */

#define ALGSURF_I_WIDER 0x1p-42 /* added to half sizes of tiles, for the rounding of u and v */

#define ALGSURF_I_SERIES 10 /* terms up to the third order in two variables */

/* A tile of pixels that is not empty.  A sheet: along each ray through it there is one root with low < z <
 * high in the view's unit, none before, and P is monotone between; where |P| <= enough it is ALGSURF_I_NEAR
 * at most to the root.  A leaf: enough = 0, no ray has a root on its chord before low. */
typedef struct algsurf_i_tile {
    double x, y, inverse;           /* its middle in pixels, one over half its side */
    double depth[ALGSURF_I_SERIES]; /* of a sheet, about: of 1, xi, eta, xi^2, xi eta, eta^2, xi^3 .. */
    double low, high, enough;
} algsurf_i_tile;

#define ALGSURF_I_NEAR 0x1p-16 /* in the view's unit: Newton's method does the rest */

/* Tiles of one size in a row of them. */
typedef struct algsurf_i_tile_job {
    const algsurf_i_row_job *row; /* but for its v, slope, row: offset is that of a pixel's left edge */
    const algsurf_i_beam_row *beam;
    int y, size;    /* of the first pixels; a power of two */
    int count, *at; /* the tiles' first pixels, */
    double *from;   /* no ray has a root on its chord before this depth */
    double noise;   /* bound on rounding of P as the points' kernel evaluates it */
    int *cell;      /* of each leaf's place, at (y / 4) stride + x / 4: its tile + 1; or, if that is empty,
                       -side, as the caller has set it */
    int stride, from_y;    /* y of the first places */
    algsurf_i_tile *tiles; /* room for as many as there are places */
    int tile_count;
} algsurf_i_tile_job;

/* What a colour depends on, of N points: structure of arrays. */
typedef struct algsurf_i_looks {
    float *place[3];                 /* from a centre, in a radius */
    float *normal[3], *direction[3]; /* unit vectors */
} algsurf_i_looks;

/* Where places of looks are measured from, and one over the radius they are measured in. */
typedef struct algsurf_i_look_frame {
    double centre[3], per_radius;
} algsurf_i_look_frame;

/* N points of the surface, or rays that reach them: structure of arrays. */
typedef struct algsurf_i_points {
    double *t, *position[3], *normal[3], *direction[3];
    algsurf_i_looks looks;
} algsurf_i_points;

/* From depths to points, for pixels of one row. */
typedef struct algsurf_i_point_job {
    const algsurf_surface *surface;
    const algsurf_i_row_job *row;
    const algsurf_i_look_frame *looks; /* of the points, if they are asked for */
    int front; /* the sign that P has before every hit, if it has one, and so its normal's; else 0 */
} algsurf_i_point_job;

/* What algsurf_i_tile tells of the sheet of each entry. */
typedef struct algsurf_i_sheets {
    const double *low, *high, *enough;
} algsurf_i_sheets;

/* A row in complex space.  Arrays have an entry for each pixel of the row; root i of pixel x is at
 * i stride + x. */
typedef struct algsurf_i_complex_job {
    const algsurf_i_row_job *row;
    const algsurf_i_sector_edges *sector;
    const double *imaginary;           /* parts of t^k in natural units and scale, */
    int top;                           /* k <= top; -1: there are none */
    const algsurf_i_look_frame *looks; /* as in algsurf_i_point_job */
    double *x, *y;                     /* roots to start from, NaN for none; then those found */
    int stride;
    double *re, *im; /* depth of the root that is seen */
    uint8_t *state;
} algsurf_i_complex_job;

#endif
