/* expand_impl.h - a ray in the surface's natural units, and the expansion along it, for expand and
 * intersect.
 *
 * The ray's parameter is re-centred and scaled, t = (centre + step v) 2^-exponent, so that the roots of
 * interest have |v| of about 1 or less wherever the origin is: no digit is lost to a far camera.
 * All scalings are powers of two, hence exact; the point X at v = 0 is kept in double-double.
 */
#ifndef ALGSURF_EXPAND_IMPL_H
#define ALGSURF_EXPAND_IMPL_H
#include "algsurf/ray.h"
#include "../base/eft.h"
#include "../surface/impl.h"

typedef struct algsurf_i_frame {
    int exponent; /* natural parameter s = t 2^exponent; direction V has largest component in [1/2,1) */
    double centre, step; /* s = centre + step v, step a power of two */
    algsurf_dd X[3];     /* the point at v = 0, relative error 2^-104 */
    double V[3];         /* direction by s */
    double D[3];         /* direction by v: step V */
    int one_piece;       /* 1: the ray's t_min, t_max lie in [-1,1] of v */
    int lost;            /* 1: V is not the exact direction, and s so large that this shows in X and D */
} algsurf_i_frame;

/* A frame for the ray, t_min <= t_max.  About the middle of the chord if that is short against the
 * surface (or `chord` is set; t_min, t_max are then finite), otherwise about the ray's point nearest to
 * the origin of space, with the unit in which the surface's terms balance. */
void algsurf_i_frame_of(const algsurf_surface *s, const algsurf_ray *ray, int chord, algsurf_i_frame *frame);

/* x, a point of the frame at about t, in the caller's units; from t where it is lost in the frame: all of it
 * where it overflows there, or `lost` is set, and coordinates of which underflow there took digits. */
void algsurf_i_set_position(const algsurf_i_frame *f, const double x[3], const algsurf_ray *ray, int unit,
                            double t, int lost, double position[3]);

/* q(v) = 2^scale P(X + v D) = sum q_k v^k, X and D in natural units.  Radii: |q_k - exact| <= r_k for the
 * exact line, when each X_i is the exact coordinate up to a relative error of u and D is exact.  Overflow
 * shows as q or r that is not finite. */
void algsurf_i_expand_d(const algsurf_surface *s, const double X[3], const double D[3], double *q, double *r);

#endif
