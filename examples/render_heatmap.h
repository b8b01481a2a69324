/* render_heatmap.h - a picture of what each pixel's ray costs, and which rays doubles leave open.
 *
 * Cost is what an observer of algsurf_intersect_first counts for the ray through the middle of the pixel:
 * intervals looked at to isolate the first root, and evaluations to refine it.  A picture is drawn by
 * packets, which take the same way for several rays at once and do not count.
 */
#ifndef RENDER_HEATMAP_H
#define RENDER_HEATMAP_H
#include <stdint.h>

#include "progress.h"
#include "render_options.h"

typedef struct render_heatmap {
    int width, height; /* of the picture with its legend */
    uint8_t *pixels;   /* to be freed */
} render_heatmap;

/* The rows that the options ask for; ends the program when there is no memory. */
render_heatmap render_make_heatmap(const render_options *options, const algsurf_surface *surface,
                                   const algsurf_extent *extent, const algsurf_camera *camera, progress *bar);

#endif
