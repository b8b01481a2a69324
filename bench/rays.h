/* rays.h - polynomials along rays, for the comparison of root finders. */
#ifndef RAYS_H
#define RAYS_H
#include <stddef.h>
#include <stdint.h>

#include "catalogue.h"

/* count polynomials, degree + 1 coefficients each, lowest first, the highest not 0; the chord of the ray
 * inside the extent is [-1,1].  The rays are those of random pixels of a picture of 1024x768 from 4 radii
 * away.  Ends the program when it cannot. */
void rays_polynomials(const catalogue_entry *entry, uint64_t seed, size_t count, double *c);

/* The camera of all pictures here: its eye is 4 R from the centre of the extent, R the extent's radius, in
 * the direction (2,-3,1.2); the picture is 2.2 R high there. */
void rays_camera(const algsurf_extent *extent, algsurf_camera *camera);

#endif
