/* algsurf/enclose.h - where a surface is: a box about all its points, or the proof that there are none. */
#ifndef ALGSURF_ENCLOSE_H
#define ALGSURF_ENCLOSE_H
#include "algsurf/ray.h"
#include "algsurf/surface.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Which points of a surface are enclosed. */
typedef enum algsurf_part {
    ALGSURF_PART_ALL = 0,     /* all of them */
    ALGSURF_PART_SINGULAR = 1 /* those where the gradient of P is 0, too: tips, double lines, cusps */
} algsurf_part;

/* A box that holds all points of a part of the surface within an extent.
 *   extent     a sphere or a box
 *   part       an algsurf_part
 *   precision  0 < precision <= 1: the search ends where a face cannot be pushed in by more than this share
 *              of the box's length; 1/16 is usual
 *   lo, hi     receive the box, lo[i] <= hi[i], with edges along the axes; it may reach beyond an extent that
 *              is a sphere; beyond one that is a box only by rounding outward, up to infinity
 *   empty      1: there is no such point, lo and hi are untouched; 0: there may be some
 *
 * Guarantee: verified.  No such point is outside of the box; if `empty` is 1, there is none.  The box is as
 * small as precision says unless that takes too long, as in degrees above 12 or where P is small in large
 * parts of space.  Nothing is said of points outside the extent, even if the box does not touch its boundary.
 * Errors: E_ARGUMENT (null; all of space; extent, part, precision out of range), E_NOT_FINITE (extent,
 * precision), E_NO_MEMORY.
 * Cost: milliseconds in degree 4 to 8, at most some 0.3 s.
 * Source: branch and bound (Skelboe 1974) on Taylor forms of P about the middles of cells, with a bound on
 * rounding.  Since 1.0. */
ALGSURF_API algsurf_status algsurf_surface_enclose(const algsurf_surface *surface,
                                                   const algsurf_extent *extent, algsurf_part part,
                                                   double precision, double lo[3], double hi[3], int *empty);

#ifdef __cplusplus
}
#endif
#endif
