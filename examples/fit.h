/* fit.h - extent and camera for a surface that has none of its own: what is there fills the picture. */
#ifndef FIT_H
#define FIT_H
#include "view.h"

/* Changes what of the view was not asked for in the options: the extent, so that it holds a bounded surface,
 * and of another one what is singular and near; then place and field of view of a pinhole camera, which looks
 * the same way as before.  Each choice is told on standard error as the options that repeat it. extent_only:
 * the camera stays, for pictures that show something else, complex space or all sides.  thin: so does what is
 * thin fill the picture. */
void fit_view(view *v, const view_options *options, const algsurf_surface *surface, int extent_only,
              int thin);

#endif
