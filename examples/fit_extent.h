/* fit_extent.h - an extent for a surface of which nothing is known but its equation. */
#ifndef FIT_EXTENT_H
#define FIT_EXTENT_H
#include "algsurf/algsurf.h"

#define FIT_POINT 1e-9 /* of a unit of length: what is smaller has no size that could fill a picture */

/* Keeps the first status that is not OK; what is computed after that may be anything, and is not used. */
void fit_demand(algsurf_status *failed, algsurf_status status);

/* An extent that holds a bounded surface (bounded: 1, as far as eyes can tell), and of another one what is
 * singular and near. */
algsurf_extent fit_extent(const algsurf_surface *surface, int *bounded, algsurf_status *failed);

/* A box about a part of the surface (an algsurf_part) within the extent. */
typedef struct fit_box {
    double lo[3], hi[3];
    int empty;
} fit_box;

fit_box fit_enclose(const algsurf_surface *surface, const algsurf_extent *extent, algsurf_part part,
                    algsurf_status *failed);

/* Half the box's longest edge; its middle. */
double fit_half_edge(const fit_box *box, double middle[3]);

/* Numbers as they are told to a user: printed with 15 digits and read again; rounded up to two digits;
 * rounded to three digits of a radius.  Where such a digit is below all doubles they stay as they are. */
double fit_as_told(double x);
double fit_rounded_up(double x);
double fit_rounded_place(double x, double radius);

#endif
