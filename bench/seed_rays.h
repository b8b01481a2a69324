/* seed_rays.h - the rays of a picture as polynomials, the bracket of each one's first root, and that root. */
#ifndef SEED_RAYS_H
#define SEED_RAYS_H
#include <stddef.h>

#include "catalogue.h"
#include "seed_rivals.h"

enum { SEED_DEGREE = 10 };

/* A ray through the middle of a pixel that meets the extent; p is the surface along it, in units of half its
 * chord from the chord's middle: in [-1,1]. */
typedef struct seed_ray {
    double c[SEED_DEGREE + 1];
    int pixel;
    int bracketed;       /* 0: no root, a root met exactly, or one undecided; what follows is then not set */
    double lo, hi;       /* isolates the first root: verified */
    double root, radius; /* the first root lies within radius of root: verified */
} seed_ray;

typedef struct seed_view {
    const catalogue_entry *entry;
    int width, height;
    algsurf_surface *surface;
    algsurf_camera camera;
    seed_ray *rays;
    size_t count, bracketed, undecided;
} seed_view;

/* A surface of the catalogue, seen as it says.  Ends the program when that cannot be had. */
void seed_open(seed_view *view, const char *name, int width, int height);
void seed_close(seed_view *view);

/* The part inside the extent of the ray through the middle of a pixel; 0 when there is none. */
int seed_chord(const seed_view *view, int pixel, algsurf_ray *chord);

/* How far from the true root a method's may be that works: its bracket's final width, what is known of the
 * root, and the rounding error of p there. */
double seed_allowed(const seed_view *view, const seed_ray *ray, double tolerance);

#endif
