/* fit.h - extent and camera for a surface that has none of its own: what is there fills the picture. */
#ifndef FIT_H
#define FIT_H
#include "view.h"

/* What was chosen. */
typedef struct fit_choice {
    int extent, camera; /* 1: it was */
    int narrowed;       /* 1: and the field of view */
    int turned;         /* 1: the eye was turned by the options, and what is up with it */
    int bounded; /* 0: the surface goes on outside the extent; 1: as far as eyes can tell it does not, or
                    the extent was given */
    double fov;  /* before anything magnifies */
} fit_choice;

/* Changes what of the view was not asked for in the options: the extent, so that it holds a bounded surface,
 * and of another one what is singular and near; then place and field of view of a pinhole camera, which looks
 * the same way as before.  extent_only: the camera stays, for pictures that show something else, complex
 * space or all sides.  thin: what is thin counts as seen.  The options have a size.  Of an error the
 * view is not to be used. */
algsurf_status fit_choose(view *v, const view_options *options, const algsurf_surface *surface,
                          int extent_only, int thin, fit_choice *choice);

/* The same in a program: each choice is told on standard error as the options that repeat it, and an error
 * ends it. */
void fit_view(view *v, const view_options *options, const algsurf_surface *surface, int extent_only,
              int thin);

#endif
