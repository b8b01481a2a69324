/* planes.h - the part of a ray that cutting planes keep. */
#ifndef ALGSURF_PLANES_H
#define ALGSURF_PLANES_H
#include <stddef.h>

#include "algsurf/ray.h"

/* OK, E_ARGUMENT (more than ALGSURF_MAX_CLIP_PLANES, null, a normal that is 0) or E_NOT_FINITE. */
algsurf_status algsurf_i_planes_check(const algsurf_plane *planes, size_t count);

/* A part of a ray that planes cut, as far as doubles can tell: it reaches from some t in lo to some in hi. */
typedef struct algsurf_i_cut {
    double outer_lo, outer_hi; /* no point that all planes keep is before or behind */
    double inner_lo, inner_hi; /* all between are kept; lo > hi: none is known */
} algsurf_i_cut;

/* Cuts the ray between cut->outer_lo and outer_hi down to what all planes keep.  Returns 0 when that is
 * surely nothing.  The ray is checked. */
int algsurf_i_planes_cut(const algsurf_plane *planes, size_t count, const algsurf_ray *ray,
                         algsurf_i_cut *cut);

/* A plane in a unit of 2^exponent, its normal multiplied by a power of two so that its largest component is
 * in [1/2,1); components of less than 2^-1000 of that may be lost. */
algsurf_plane algsurf_i_plane_in_unit(const algsurf_plane *plane, int exponent);

#endif
