/* kernel.h - what the packet code offers: one text, compiled once for each instruction set.
 *
 * All kernels give the same bits: each lane is rounded as a double alone would be, and no result depends on
 * how many lanes there are.  None of them decides a sign inside its error bound; a lane that would have to
 * is left to the exact scalar path.  To be called in the standard floating-point environment. */
#ifndef ALGSURF_KERNEL_H
#define ALGSURF_KERNEL_H
#include <stdint.h>

#include "../expand_view.h"
#include "algsurf/ray.h"
#include "algsurf/shade.h"

/* Answers of a lane. */
enum { ALGSURF_LANE_MISS = 0, ALGSURF_LANE_HIT = 1, ALGSURF_LANE_DOUBTFUL = 2 };

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

typedef struct algsurf_i_colour_job {
    const algsurf_material *material;
    const algsurf_light *lights; /* at their middles */
    int light_count;
} algsurf_i_colour_job;

/* Rays in any order, in the caller's units, all numbers finite but t_min and t_max; directions are not 0.
 * The surface has nodes and a unit within 2^+-900; in that unit the extent's sizes are within 2^+-100, its
 * centre is below 2^100. */
typedef struct algsurf_i_rays_job {
    const algsurf_surface *surface;
    const algsurf_extent *extent; /* null: all of space */
    const double *origin[3], *direction[3];
    const double *t_min, *t_max; /* null: 0, infinity */
    const unsigned char *active; /* null: all */
    int any;                     /* 1: whether there is a root, not where: only states are written */
    int bounded;                 /* 0: signs as computed, and t_lo = t_hi = t (the fast tier) */
} algsurf_i_rays_job;

/* What is found of each ray, as in algsurf_hit; any array may be null, but state. */
typedef struct algsurf_i_rays_hits {
    uint8_t *state;
    double *t, *t_lo, *t_hi, *position[3], *normal[3];
} algsurf_i_rays_hits;

/* Polynomials of degree 1 to ALGSURF_MAX_PACKET_DEGREE, as in algsurf_poly_packet, and their answers. */
typedef struct algsurf_i_polys_job {
    const double *const *c, *const *r;
    const double *lo, *hi;
    int degree;
    double tolerance;    /* relative to the interval */
    const double *basis; /* Bernstein coefficient j of v^k over [-1,1] at j (degree+1) + k; for degrees above 2 */
    uint8_t *state;
    double *root; /* +inf where there is none; may be null */
} algsurf_i_polys_job;

typedef struct algsurf_i_kernel {
    const char *name;
    int lanes;
    /* depth[x], state[x] for begin <= x < end: the first root along each ray. */
    void (*solve_row)(const algsurf_i_row_job *job, int begin, int end, double *depth, uint8_t *state);
    /* Entry i of points from depth[i] at pixel[i]: after one Newton step on P itself, t along the unit ray
     * from the eye, position, unit normal (0 at a singular point), unit direction, in the caller's units. */
    void (*points)(const algsurf_i_point_job *job, const int *pixel, const double *depth, int count,
                   const algsurf_i_points *points);
    /* colour[3 i ..] of entry i, as algsurf_shade; visible: null or light_count for each entry. */
    void (*colours)(const algsurf_i_colour_job *job, const algsurf_i_points *points, int count,
                    const double *visible, double *colour);
    /* hits of the active rays among the first `count`.  Of a doubtful ray only the state means something. */
    void (*solve_rays)(const algsurf_i_rays_job *job, size_t count, const algsurf_i_rays_hits *hits);
    /* state and root of the first `count` polynomials; of a doubtful one only the state means something. */
    void (*solve_polys)(const algsurf_i_polys_job *job, size_t count);
    /* Are all numbers finite, lo < hi, radii not negative?  Of any degree; basis, state, root are not read. */
    int (*good_polys)(const algsurf_i_polys_job *job, size_t count);
} algsurf_i_kernel;

/* The kernels this processor and operating system can run, the fastest first; null beyond the last. */
const algsurf_i_kernel *algsurf_i_kernel_at(int index);

/* The kernel of that name, or the fastest one for null, if this processor and operating system can run it;
 * null otherwise. */
const algsurf_i_kernel *algsurf_i_kernel_find(const char *name);

#endif
