/* packets.h - first hits of many rays at once, all hits of one, by every kernel. */
#ifndef ALGSURF_RAYS_PACKETS_H
#define ALGSURF_RAYS_PACKETS_H
#include <stddef.h>
#include <stdint.h>

#include "../simd/kernel.h"
#include "algsurf/intersect.h"
#include "algsurf/ray.h"
#include "algsurf/surface.h"

/* Rays in any order, in the caller's units, all numbers finite but t_min and t_max; directions are not 0.
 * The surface has nodes and a unit within 2^+-800; in that unit the extent's sizes are within 2^+-100, its
 * centre and the offsets of planes are below 2^100. */
typedef struct algsurf_i_rays_job {
    const algsurf_surface *surface;
    const algsurf_extent *extent; /* null: all of space */
    const algsurf_plane *planes;  /* algsurf_i_plane_in_unit, of the natural one */
    int plane_count;
    const algsurf_ray_packet *rays;
    int any;                    /* 1: whether there is a root, not where: only states are written */
    int side;                   /* the sign of P before roots that count, 0: all count */
    algsurf_observer *observer; /* of a single ray, or null */
} algsurf_i_rays_job;

/* Packets of eight have surfaces up to this degree: with all degrees they would need 90 KiB of stack, more
 * than the threads of a renderer may have, and than the fastest cache. */
#define ALGSURF_MAX_WIDE_DEGREE 24

typedef struct algsurf_i_rays_kernel {
    /* Answers the active rays.  Of an undecided ray only the state means something. */
    void (*solve)(const algsurf_i_rays_job *job, const algsurf_hit_packet *hits);
} algsurf_i_rays_kernel;

ALGSURF_KERNEL_TABLES(rays);

/* The code for the job's one ray: packets of two, of which one lane is idle. */
typedef struct algsurf_i_ray_kernel {
    /* The first hits, at most `most` >= 1, in order, by the caller's method (null: the first of them has the
     * bits of the packets); for `any` 1 where there is one, of which only the state is set; 0: there is
     * none, and hits->side is that of the miss; -1: undecided.  hits has room for the surface's degree, or
     * `most`. */
    int (*all)(const algsurf_i_rays_job *job, const algsurf_refine_options *how, int most, algsurf_hit *hits);
} algsurf_i_ray_kernel;

ALGSURF_KERNEL_TABLES(ray);

#endif
