/* render_view.h - what is shown and from where: options, else the catalogue, else what frames the extent. */
#ifndef RENDER_VIEW_H
#define RENDER_VIEW_H
#include "catalogue.h"
#include "render_options.h"

typedef struct render_view {
    algsurf_extent extent;
    double eye[3], look_at[3], up[3];
    double fov;          /* degrees, vertical */
    double orthographic; /* height of the picture in space; 0: a pinhole camera */
} render_view;

/* entry: the catalogue's, null for a surface without a name. */
render_view render_make_view(const render_options *options, const catalogue_entry *entry);

/* The camera of picture number `picture` (from 0) of a turn of `pictures` about the upward axis through
 * the point looked at.  Ends the program when there is no such camera. */
algsurf_camera render_make_camera(const render_view *view, int picture, int pictures);

#endif
