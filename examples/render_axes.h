/* render_axes.h - the options --axes and --box of render. */
#ifndef RENDER_AXES_H
#define RENDER_AXES_H
#include "render_options.h"

int render_has_axes(const render_options *options);

/* Narrows a view that no option asked for until all pictures have all of the box in them, and tells it. */
void render_make_room(const render_options *options, view *shown);

/* Draws them over the picture's rows, of which `rows` are drawn; hits: their distances, null without axes. */
void render_axes(const render_options *options, const algsurf_surface *surface, const view *shown,
                 const algsurf_camera *camera, int rows, uint8_t *pixels, const double *hits);

#endif
