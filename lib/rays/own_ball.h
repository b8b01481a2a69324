/* own_ball.h - a surface that is the sphere of its own extent. */
#ifndef ALGSURF_OWN_BALL_H
#define ALGSURF_OWN_BALL_H
#include "algsurf/ray.h"
#include "../surface/impl.h"

/* Is the surface exactly the sphere that bounds the extent?  Then the extent cuts nothing off: a larger one
 * may stand in its place, so that the roots of rays are not all on the extent's edge. */
int algsurf_i_is_own_ball(const algsurf_surface *surface, const algsurf_extent *extent);

/* The extent, or in *wider a ball twice as large where the surface is its own. */
const algsurf_extent *algsurf_i_without_own_ball(const algsurf_surface *surface, const algsurf_extent *extent,
                                                 algsurf_extent *wider);
#endif
