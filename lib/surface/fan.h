/* fan.h - P along all segments from a point to a rectangle: those of the shadow rays to a light.
 *
 * In axes along the rectangle's sides, with the point at x and the rectangle's middle at x + d, they are
 *     x + t (d_1 + h_1 xi, d_2 + h_2 eta, d_3),  |xi|, |eta| <= 1,
 * 0 <= t <= 1; for the first part of the segments, d and h are multiplied by its share.  So P is
 *     sum over i + j <= n of (h_1 xi)^i (h_2 eta)^j t^(i+j) r_ij(t),
 * r_ij of degree n - i - j: a beam from a single point.  P is brought to these axes once a frame; points are
 * done side by side (picture/fans_template.h).
 */
#ifndef ALGSURF_SURFACE_FAN_H
#define ALGSURF_SURFACE_FAN_H
#include "beam.h"
#include "taylor.h"

#define ALGSURF_MAX_FAN_DEGREE 7   /* beyond it fans cost more than they save */
#define ALGSURF_I_SLANT 8          /* |d| / |d_3|: rectangles seen at a greater slant are not for fans */
#define ALGSURF_I_FAN_APART 0x1p-4 /* A of fan.c */

typedef struct algsurf_i_fan {
    int usable;                 /* 0: nothing else is known */
    algsurf_i_frame_form frame; /* its view has a centre, axes and a size */
    double light[3];            /* the rectangle's middle, */
    double half[2];             /* and half its sides, in the view's unit; rounding is taken in */
    double missed;              /* bound on what each coordinate of a place of it is off by */
    double weight, least_error; /* of a Bernstein coefficient: error <= weight S + least_error (fan.c) */
    double inverse[ALGSURF_MAX_FAN_DEGREE + 1]; /* of binomial coefficients: 1 / (degree over k) */
} algsurf_i_fan;

/* For a fan whose frame has a view's centre and size, and its arrays.  The rectangle has its middle at
 * `position`, natural units, and contains what edge_u and edge_v span to both sides of it; `places` bounds
 * the error of points of it.  `memory` as for algsurf_i_frame_expand.  A fan is not usable where values leave
 * the range of double, and for a surface with an error. */
void algsurf_i_fan_expand(const algsurf_surface *s, const double position[3], const double edge_u[3],
                          const double edge_v[3], double places, algsurf_i_fan *fan, void *memory);

#endif
