/* chord.h - the part of a ray inside an extent, kept by planes, and the surface's polynomial on it.
 *
 * On the chord t = middle + half s with s in [-1,1].  The polynomial in s is expanded about the chord's
 * middle, a point near the surface: a far origin of the ray costs no digits.
 */
#ifndef CHORD_H
#define CHORD_H
#include "algsurf/algsurf.h"

typedef struct chord {
    double t_in, t_out;  /* its ends, t_in < t_out */
    double middle, half; /* in t */
    int degree;
    double c[ALGSURF_MAX_DEGREE + 1], r[ALGSURF_MAX_DEGREE + 1]; /* the polynomial in s, and its radii */
} chord;

/* Returns OK with *meets telling whether there is a chord (of some length), or why there is no polynomial:
 * a status of algsurf_ray_clip or algsurf_expand_power.  The extent must be bounded. */
algsurf_status chord_make(const algsurf_surface *surface, const algsurf_extent *extent,
                          const algsurf_plane *planes, size_t count, const algsurf_ray *ray, chord *result,
                          int *meets);

double chord_t(const chord *c, double s);
double chord_s(const chord *c, double t); /* limited to [-1,1] */

#endif
