/* thin.h - is what a pixel's ray misses thin? */
#ifndef ALGSURF_PICTURE_THIN_H
#define ALGSURF_PICTURE_THIN_H
#include "../surface/beam.h"

/* The pixels about one: neighbour 3 (j + 1) + i + 1 is i pixels towards xi, j towards eta. */
#define ALGSURF_I_NEIGHBOURS 9

/* Finds at which depths the rays of neighbours first meet the surface, HUGE_VAL where they do not. */
typedef void algsurf_i_look_beside(void *looker, double depth[ALGSURF_I_NEIGHBOURS]);

/* A box of rays about a pixel's: twice as wide and high, between two depths. */
typedef struct algsurf_i_thin_box {
    const algsurf_i_view *view;
    const algsurf_i_beam_row *beam; /* of its height */
    double u, h;                    /* the middle ray's u, half the box's width */
    double from, to;                /* depths */
    double within;                  /* a depth on the middle ray's chord; 2: none is known */
    int ends_at_hit;                /* 1: what reaches `to` belongs to what the pixel shows */
    algsurf_i_look_beside *look_beside;
    void *looker;
} algsurf_i_thin_box;

/* Is there something thin in the pixel?  Then about `depth`.  memory: so many bytes, aligned for doubles. */
size_t algsurf_i_thin_memory(void);
int algsurf_i_is_thin(const algsurf_i_thin_box *box, void *memory, double *depth);

#endif
