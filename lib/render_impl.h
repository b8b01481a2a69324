/* render_impl.h - the pieces of render: a picture, its rows, the crew of threads that draws them.
 *
 *     render.c         checks the arguments, owns the memory, reports
 *     render_crew.c    hands rows to threads, calls progress, cancels
 *     render_row.c     one row: samples -> hits -> colours -> bytes
 *     render_view.c    camera and extent in the units of packets
 *     render_packets.c the hits of a row by packets
 *     render_complex.c one sample in complex space, started from its neighbours' roots
 *     render_shadow.c  which share of a light reaches a point
 */
#ifndef ALGSURF_RENDER_IMPL_H
#define ALGSURF_RENDER_IMPL_H
#include <stdatomic.h>
#include <stdint.h>

#include "kernels/kernel.h"
#include "scene_impl.h"

#define ALGSURF_MAX_THREADS 256

/* The points of a row that are seen through one sample of its pixels, and the pixels' sums over samples. */
typedef struct algsurf_i_line {
    int count;  /* points: hits and uncertain ones */
    int *pixel; /* of each point, in no particular order */
    algsurf_i_points points;
    double *colour;    /* 3 for each point */
    double *visible;   /* light_count for each point, in full quality */
    double *depth;     /* of each pixel: where packets found it */
    uint8_t *state;    /* of each pixel: an ALGSURF_LANE */
    uint16_t *samples; /* of each pixel: how many of its samples show a point */
    double *sum;       /* 3 for each such pixel: their clamped colours */
    double *nearest;   /* and their smallest t */
} algsurf_i_line;

/* What packets need to know of a picture. */
typedef struct algsurf_i_packets {
    algsurf_i_frame_form frame;
    int orthographic;
    double origin[2], per_slope, pixel; /* u = origin[0] + per_slope (x - width/2) pixel; v likewise */
    double near;                        /* depth of the eye */
    double extent_size[3], tolerance;   /* in the view's unit */
} algsurf_i_packets;

/* The roots of the pixels drawn last, in complex space: degree-many for each pixel of a row, in the order
 * algsurf_intersect_complex returns them.  Null in real space. */
typedef struct algsurf_i_trail {
    algsurf_complex *above, *row; /* of the samples drawn before these, and of those being drawn */
    int has_above;                /* 0: above holds nothing yet */
} algsurf_i_trail;

/* What is counted and timed: the fields of algsurf_render_stats that add up. */
typedef struct algsurf_i_tally {
    uint64_t rays, hits, uncertain, shadow_rays, iterations, single_rays;
    double expand_s, solve_s, point_s, shade_s, shadow_s;
} algsurf_i_tally;

/* What one thread draws with, and where it is. */
typedef struct algsurf_i_worker {
    algsurf_i_line line;
    algsurf_i_trail trail;
    int row, row_end; /* what is left of the rows it has taken */
    algsurf_i_tally tally;
} algsurf_i_worker;

/* What all rows of a picture share; only stop ever changes. */
typedef struct algsurf_i_picture {
    const algsurf_scene *scene;
    int width, height, row_begin, row_end;
    algsurf_light lights[ALGSURF_MAX_LIGHTS];
    int light_count;
    double centre[3], radius; /* the ball about what is shown */
    double reach;             /* how far it reaches from its centre along the view */
    const algsurf_i_kernel *kernel;
    algsurf_i_packets *packets; /* null: every ray by itself */
    uint8_t *pixels;
    size_t stride;
    double *hits;    /* or null */
    atomic_int stop; /* 1: rows in the making are to be abandoned */
} algsurf_i_picture;

/* Draws one row, row_begin <= row < row_end, and adds to the tally.  OK, CANCELLED when stop was set (the
 * row's bytes are untouched then), or what intersect returned. */
algsurf_status algsurf_i_render_row(const algsurf_i_picture *picture, int row, algsurf_i_worker *worker,
                                    algsurf_i_tally *tally);

/* Fills a picture's packets, but for the frame's arrays; 0 if this scene is not one for them. */
int algsurf_i_packets_geometry(const algsurf_i_picture *picture, algsurf_i_packets *packets);

/* The pixels of a row whose rays may meet the ball of radius 1 about the view's centre. */
void algsurf_i_packets_range(const algsurf_i_row_job *job, int width, int *begin, int *end);

/* The points of a row seen through offset (sx,sy) in each pixel. */
algsurf_status algsurf_i_render_packets(const algsurf_i_picture *picture, int row, double sx, double sy,
                                        algsurf_i_line *line, algsurf_i_tally *tally);

/* Appends a single ray's hit at pixel x to the line's points, if it is one, and counts it. */
void algsurf_i_line_add(algsurf_i_line *line, int x, const algsurf_ray *ray, const algsurf_hit *hit,
                        algsurf_i_tally *tally);

/* The hit of pixel x of a row in complex space, along its ray; the roots go to the trail. */
algsurf_status algsurf_i_render_complex(const algsurf_i_picture *picture, int x, const algsurf_ray *ray,
                                        algsurf_i_trail *trail, algsurf_hit *hit, algsurf_i_tally *tally);

/* line->visible: the share of each light's samples that reach each point; 0 where that adds nothing to the
 * point's colour whatever the share. */
algsurf_status algsurf_i_render_shadows(const algsurf_i_picture *picture, algsurf_i_line *line,
                                        uint64_t *shadow_rays);

/* Draws all rows with at most the given number of threads, the caller's among them; there is a worker
 * for each.  threads_used receives how many could be had. */
algsurf_status algsurf_i_render_crew(algsurf_i_picture *picture, const algsurf_render_options *options,
                                     int threads, algsurf_i_worker *workers, algsurf_i_tally *total,
                                     int *threads_used);

/* Seconds since some moment in the past; never goes back. */
double algsurf_i_render_clock(void);

#endif
