/* segments.h - what is asked of the kernels about rays from points of the surface, to lights and around. */
#ifndef ALGSURF_BEAMS_SEGMENTS_H
#define ALGSURF_BEAMS_SEGMENTS_H
#include "../surface/taylor.h"
#include "rows.h"

#define ALGSURF_I_STARTS 8       /* points whose shadow rays are found together: the lanes of any kernel */
#define ALGSURF_I_RAYS_OF_ONE 32 /* so many from each at once */

/* Points, lifted off the surface, and the side of it that the viewer is on: structure of arrays. */
typedef struct algsurf_i_starts {
    int count;
    double at[3][ALGSURF_I_STARTS], facing[3][ALGSURF_I_STARTS];
    double number[ALGSURF_I_STARTS], across[ALGSURF_I_STARTS], up[ALGSURF_I_STARTS]; /* as in lattice.h */
    double *seen[ALGSURF_I_STARTS]; /* where rays that arrive are added up */
} algsurf_i_starts;

/* P about these points, as a kernel has it. */
typedef struct algsurf_i_solids {
    _Alignas(64) unsigned char packets[ALGSURF_I_STARTS * (ALGSURF_I_SOLID(ALGSURF_MAX_TAYLOR_DEGREE) + 16) *
                                       sizeof(double)];
} algsurf_i_solids;

/* Where rays from points go, and what is known of those they may meet. */
typedef struct algsurf_i_shadow_job {
    const algsurf_i_taylor *taylor; /* for their expansion; null: nothing is known of rays */
    const double
        *light[3]; /* its middle and edges; null: rays end on a ball that touches the point's plane, */
    double ball;   /* of that radius, the same for all of a picture's jobs */
    const double *place[2]; /* of the light, in its edges from its middle: rays go there; or null: */
    double lattice;         /* they go to points of lattices, which have so many */
    double unit;            /* of the caller's coordinates, in natural ones */
    int extent_kind;        /* sphere or box, about the view's centre */
    double extent_size[3];  /* in the view's unit */
    const algsurf_i_cut_plane *planes; /* in the caller's axes */
    int plane_count;
} algsurf_i_shadow_job;

/* Rays of which it is not known whether they arrive. */
typedef struct algsurf_i_undecided {
    int count, start[ALGSURF_I_STARTS * ALGSURF_I_RAYS_OF_ONE];
    double direction[3][ALGSURF_I_STARTS * ALGSURF_I_RAYS_OF_ONE];
} algsurf_i_undecided;

#endif
