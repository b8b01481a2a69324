/* taylor.h - P about points of a frame: for rays from each of them in any direction.
 *
 * In the caller's axes, with a point at x, P is the sum of r_ijk(x) X^i Y^j Z^k, r_ijk its Taylor
 * coefficients; along x + t d, the coefficient of t^m is the sum of r_ijk d_1^i d_2^j d_3^k with i + j + k =
 * m.  P is brought to the unit of what is shown once a frame; points, and rays, are done side by side
 * (beams/segments_template.h).
 */
#ifndef ALGSURF_SURFACE_TAYLOR_H
#define ALGSURF_SURFACE_TAYLOR_H
#include "view.h"

#define ALGSURF_MAX_TAYLOR_DEGREE 10 /* beyond it rays cost less by themselves */
#define ALGSURF_I_TAYLOR_REACH 1.25  /* of points and of what is known of rays, in each coordinate */

/* How many coefficients P has. */
#define ALGSURF_I_SOLID(n) (((n) + 1) * ((n) + 2) * ((n) + 3) / 6)

typedef struct algsurf_i_taylor {
    int usable;                 /* 0: nothing else is known */
    algsurf_i_frame_form frame; /* its view has a centre, the caller's axes and a size */
    double weight, least_error; /* of a Bernstein coefficient: error <= weight S + least_error (taylor.c) */
    double inverse[ALGSURF_MAX_TAYLOR_DEGREE + 1]; /* of binomial coefficients: 1 / (degree over k) */
} algsurf_i_taylor;

/* For a frame that has a view's centre and size, and its arrays; `memory` as for algsurf_i_frame_expand.  Not
 * usable where values leave the range of double, and for a surface with an error. */
void algsurf_i_taylor_expand(const algsurf_surface *s, algsurf_i_taylor *taylor, void *memory);

#endif
