/* render_impl.h - the pieces of render: a picture, its rows, the crew of threads that draws them.
 *
 *     render.c         checks the arguments, owns the memory, reports
 *     render_crew.c    hands rows to threads, calls progress, cancels
 *     render_row.c     one row: samples -> hits -> colours -> bytes
 *     render_complex.c one sample in complex space, started from its neighbours' roots
 *     render_shadow.c  which share of a light reaches a point
 */
#ifndef ALGSURF_RENDER_IMPL_H
#define ALGSURF_RENDER_IMPL_H
#include <stdatomic.h>
#include <stdint.h>

#include "scene_impl.h"

#define ALGSURF_MAX_THREADS 256

/* One sample of one pixel on its way through a row, and the pixel's sums over its samples. */
typedef struct algsurf_i_pixel {
    algsurf_ray ray;
    algsurf_hit hit;
    double colour[3]; /* sum of clamped colours */
    double nearest;   /* smallest t, NaN where none */
} algsurf_i_pixel;

/* The roots of the pixels drawn last, in complex space: degree-many for each pixel of a row, in the order
 * algsurf_intersect_complex returns them.  Null in real space. */
typedef struct algsurf_i_trail {
    algsurf_complex *above, *row; /* of the samples drawn before these, and of those being drawn */
    int has_above;                /* 0: above holds nothing yet */
} algsurf_i_trail;

/* What one thread draws with, and where it is. */
typedef struct algsurf_i_worker {
    algsurf_i_pixel *pixels; /* width of them */
    algsurf_i_trail trail;
    int row, row_end; /* what is left of the rows it has taken */
} algsurf_i_worker;

/* What is counted and timed: the fields of algsurf_render_stats that add up. */
typedef struct algsurf_i_tally {
    uint64_t rays, hits, uncertain, shadow_rays, iterations;
    double solve_s, shade_s;
} algsurf_i_tally;

/* What all rows of a picture share; only stop ever changes. */
typedef struct algsurf_i_picture {
    const algsurf_scene *scene;
    int width, height, row_begin, row_end;
    algsurf_light lights[ALGSURF_MAX_LIGHTS];
    int light_count;
    double centre[3], radius; /* the ball about what is shown */
    double reach;             /* how far it reaches from its centre along the view */
    uint8_t *pixels;
    size_t stride;
    double *hits;    /* or null */
    atomic_int stop; /* 1: rows in the making are to be abandoned */
} algsurf_i_picture;

/* Draws one row, row_begin <= row < row_end, and adds to the tally.  OK, CANCELLED when stop was set (the
 * row's bytes are untouched then), or what intersect returned. */
algsurf_status algsurf_i_render_row(const algsurf_i_picture *picture, int row, algsurf_i_worker *worker,
                                    algsurf_i_tally *tally);

/* pixel->hit of pixel x of a row in complex space, from pixel->ray; the roots go to the trail. */
algsurf_status algsurf_i_render_complex(const algsurf_i_picture *picture, int x, algsurf_i_trail *trail,
                                        algsurf_i_pixel *pixel, algsurf_i_tally *tally);

/* visible[l] = the share of light l's samples that reach the pixel's hit, for shading with
 * algsurf_i_shade: 0 where that adds nothing whatever the share. */
algsurf_status algsurf_i_render_shadows(const algsurf_i_picture *picture, const algsurf_i_pixel *pixel,
                                        double *visible, uint64_t *shadow_rays);

/* Draws all rows with at most the given number of threads, the caller's among them; there is a worker
 * for each.  threads_used receives how many could be had. */
algsurf_status algsurf_i_render_crew(algsurf_i_picture *picture, const algsurf_render_options *options,
                                     int threads, algsurf_i_worker *workers, algsurf_i_tally *total,
                                     int *threads_used);

/* Seconds since some moment in the past; never goes back. */
double algsurf_i_render_clock(void);

#endif
