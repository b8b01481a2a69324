/* seed_pictures.h - whole pictures by each of the library's methods, judged and timed. */
#ifndef SEED_PICTURES_H
#define SEED_PICTURES_H
#include <stdint.h>

#include "seed_rays.h"

/* A view as the library's renderer shows it, and where a proof has the surface. */
typedef struct seed_easel {
    const seed_view *view;
    algsurf_scene *scene;
    uint8_t *pixels;
    double *hits, *truth;
} seed_easel;

void seed_easel_open(seed_easel *easel, const seed_view *view);
void seed_easel_close(seed_easel *easel);

/* Draws with all processors.  Returns the CPU seconds; in packets: as the library does by itself with its
 * default method, else ray by ray.  *wrong: pixels whose hit is not where the surface is, or that have none
 * or one too many; ends the program if the method is one that may not fail. */
double seed_draw(seed_easel *easel, const seed_method *method, double tolerance, int packets, size_t *wrong);

#endif
