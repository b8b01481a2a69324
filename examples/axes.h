/* axes.h - the coordinate axes, or a box about what is shown, with numbers: how large things are. */
#ifndef AXES_H
#define AXES_H
#include "algsurf/algsurf.h"

enum {
    AXES_LINES = 1, /* the axes: what of them lies in the box about the extent */
    AXES_BOX = 2    /* the edges of this box behind what is shown, with numbers along its outline */
};

/* The box about a ball touches it. */
typedef struct axes_scene {
    int what; /* of AXES_LINES, AXES_BOX */
    algsurf_extent extent;
    algsurf_camera camera;
    int width, height;                        /* of the whole picture, in pixels */
    double letter;                            /* height of digits in pixels; 0: axes_letter(width, height) */
    const algsurf_surface *surface;           /* for axes_draw with t: what hides numbers, */
    const algsurf_intersect_options *options; /* and the planes that cut it; may be null */
} axes_scene;

/* The usual height of digits: a part of the picture's smaller side, at least 7 pixels. */
double axes_letter(double width, double height);

/* How much a picture must be magnified, 0.01 to 1, so that the box and its numbers are in it; the camera
 * stays where it is.  1, too, where the eye is in the box. */
double axes_zoom(const axes_scene *scene);

/* Draws over rows row_begin .. row_end-1 of a picture, of which pixels and t are; rows that are drawn one by
 * one are those of the whole picture.
 *   background  sRGB, for a grey that reads on it; null: there is none
 *   pixels      bytes each: 3, or 4 with alpha, as algsurf_picture has them
 *   t           its distances: what is behind them is hidden; null: nothing is
 * Returns 0 when memory is short, and then has drawn nothing. */
int axes_draw(const axes_scene *scene, int row_begin, int row_end, const uint8_t *background, uint8_t *pixels,
              int bytes, const double *t);

#endif
