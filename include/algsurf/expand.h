/* algsurf/expand.h - a surface along a ray: from P(x,y,z) to a polynomial in one variable.
 *
 * p(t) = P(origin + t direction) for the exact surface and the exact ray.  Two forms are offered.  The power
 * basis in the caller's own t is what the literature calls p_0 .. p_d; it loses digits when the origin is far
 * from the surface, and its radii show that.  The Bernstein form on [t_min, t_max] does not lose them: it is
 * expanded about the middle of this interval and scaled to its length.
 */
#ifndef ALGSURF_EXPAND_H
#define ALGSURF_EXPAND_H
#include "algsurf/ray.h"
#include "algsurf/surface.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Coefficients of p in t about the ray's origin; the ray's t_min and t_max play no part.
 *   c, r  n+1 coefficients, lowest first, and their radii, n = algsurf_surface_degree(surface).
 *         Encloses: the exact coefficient p_i lies in [c[i]-r[i], c[i]+r[i]].  r may be null; c alone is not
 *         exact.
 * Errors: E_ARGUMENT (null, zero direction), E_NOT_FINITE (ray), E_RANGE (overflow, also on the way: where
 * terms differ by more than doubles do).
 * Cost: about two multiply-adds for each term and each degree.  Source: nested Horner scheme
 * over polynomials in t; radii by the same scheme on magnitudes.  Since 1.0. */
ALGSURF_API algsurf_status algsurf_expand_power(const algsurf_surface *surface, const algsurf_ray *ray,
                                                double *c, double *r);

/* Bernstein coefficients of p over [ray->t_min, ray->t_max], which must be finite, t_min < t_max.
 *   b, r  n+1 coefficients and their radii, or r null.  Encloses, as above: r covers the expansion, the
 *         change of basis and the rounding of the interval's middle and length.
 * Errors: as above; E_ARGUMENT for t_min >= t_max, E_NOT_FINITE for infinite ends.  Cost: as above, and
 * O(n^2) for the change of basis.  Source: as above, and as algsurf_poly_to_bernstein.  12 KiB of stack.
 * Since 1.0. */
ALGSURF_API algsurf_status algsurf_expand_bernstein(const algsurf_surface *surface, const algsurf_ray *ray,
                                                    double *b, double *r);

#ifdef __cplusplus
}
#endif
#endif
