/* normal.h - the unit normal of a hit. */
#ifndef ALGSURF_NORMAL_H
#define ALGSURF_NORMAL_H
#include "algsurf/ray.h"
#include "algsurf/surface.h"

/* At a point of the ray, in the caller's units, that is `off` from its root at most, beside rounding of its
 * coordinates; limit: bytes that may be allocated. */
void algsurf_i_set_normal(const algsurf_surface *surface, const algsurf_ray *ray, const double position[3],
                          double off, size_t limit, double normal[3]);

#endif
