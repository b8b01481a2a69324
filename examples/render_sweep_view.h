/* render_sweep_view.h - one view for several surfaces: those of a sweep. */
#ifndef RENDER_SWEEP_VIEW_H
#define RENDER_SWEEP_VIEW_H
#include "view.h"

/* Extent and camera, as far as they are not asked for, so that all of the surfaces are shown; each choice is
 * told as fit_view tells it.  The camera leaves out those of a high degree, but the first one. */
void render_sweep_view(view *v, const view_options *asked, algsurf_surface *const *surface, int count,
                       int extent_only);

#endif
