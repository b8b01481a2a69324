/* rays.h - surfaces of the catalogue, their views, rays and polynomials along them, as all benchmarks take
 * them. All of these end the program when they cannot. */
#ifndef RAYS_H
#define RAYS_H
#include <stddef.h>
#include <stdint.h>

#include "catalogue.h"

/* To be freed with algsurf_surface_free. */
algsurf_surface *rays_surface(const catalogue_entry *entry);

/* Its terms, to be freed; how many.  There is room for one more. */
algsurf_term *rays_terms(const algsurf_surface *surface, size_t *count);

/* The camera of the catalogue. */
algsurf_camera rays_catalogue_camera(const catalogue_entry *entry);

/* The camera of all pictures that are compared: its eye is 4 R from the centre of the extent, R the extent's
 * radius, in the direction (2,-3,1.2); the picture is 2.2 R high there. */
algsurf_camera rays_camera(const algsurf_extent *extent);

/* To be freed with algsurf_scene_free. */
algsurf_scene *rays_scene(const algsurf_surface *surface, const algsurf_extent *extent,
                          const algsurf_camera *camera);

/* The ray through the middle of pixel x, y. */
algsurf_ray rays_ray(const algsurf_camera *camera, int width, int height, int x, int y);

/* What of a ray is inside the extent; returns 0 when that is nothing. */
int rays_clip(const algsurf_ray *ray, const algsurf_extent *extent, algsurf_ray *chord);

/* Rays as a packet takes them fastest, in arrays of their own; and the end of these. */
algsurf_ray_packet rays_packet(const algsurf_ray *rays, size_t count);
void rays_packet_free(const algsurf_ray_packet *packet);

/* P along the chord, which becomes [-1,1]: degree + 1 coefficients, lowest first. */
void rays_expand(const algsurf_surface *surface, const algsurf_ray *chord, double *c);

/* count polynomials, the highest coefficient not 0, along the rays of random pixels of a picture of 1024x768
 * by rays_camera. */
void rays_polynomials(const catalogue_entry *entry, uint64_t seed, size_t count, double *c);

#endif
