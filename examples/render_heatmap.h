/* render_heatmap.h - a picture of what pixels cost: which tiles decide all of theirs, what each other
 * pixel's ray costs, and which rays doubles leave open.
 *
 * Tiles are those of the picture (algsurf_picture.way): pale where they are empty, brown and shaded like the
 * picture where they see one sheet, each outlined above and on its left.  Cost is what an observer of
 * algsurf_intersect_first counts for the ray through the middle of a pixel: intervals looked at to isolate
 * the first root, and evaluations to refine it.  A picture solves such rays side by side, which takes the
 * same way for several at once and does not count.
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

/* The rows that the options ask for, of which the picture's pixels and ways are known; ends the program when
 * there is no memory. */
render_heatmap render_make_heatmap(const render_options *options, const algsurf_surface *surface,
                                   const algsurf_extent *extent, const algsurf_camera *camera,
                                   const uint8_t *pixels, const uint8_t *ways, progress *bar);

#endif
