/* axes_parts.h - of which axes.c makes axes and a box: lines in space, and numbers beside them. */
#ifndef AXES_PARTS_H
#define AXES_PARTS_H
#include "axes.h"
#include "strokes.h"

enum { AXES_MOST_TEXTS = 100 };

/* In letter heights: a tick, the gap before a text, a long number. */
#define AXES_TICK 0.45
#define AXES_GAP 0.35
#define AXES_NUMBER 3.0

#define AXES_NEAR 1e-3 /* of the box's size: what is nearer to a pinhole's eye is cut off */

/* Where a text stands: its middle, and half its sides. */
typedef struct axes_text {
    double x, y, across, down;
} axes_text;

typedef struct axes_drawing {
    const axes_scene *scene;
    strokes s;
    double lo[3], hi[3]; /* the box */
    double size;         /* half its diagonal */
    double letter, line; /* height, width in pixels */
    double beyond;       /* a pixel in space, where the box's middle is */
    axes_text taken[AXES_MOST_TEXTS];
    int texts;
} axes_drawing;

/* A line in space parallel to an axis. */
typedef struct axes_edge {
    int axis;
    double from[3], to[3]; /* they differ in one coordinate */
} axes_edge;

/* Without rows to draw on. */
axes_drawing axes_begin(const axes_scene *scene);

double axes_dot(const double a[3], const double b[3]);

/* Where a point is in the picture; a pinhole's must not be at depth 0. */
stroke_point axes_seen(const axes_drawing *d, const double place[3]);

/* Leaves the part before the eye; returns 0 where there is none. */
int axes_clip(const axes_drawing *d, axes_edge *e);

void axes_draw_edge(axes_drawing *d, axes_edge e);

/* Writes beside a point in a direction of the picture, so that the text begins at a distance from it: unless
 * it would not be whole in the picture, another one is there, or the surface is before the point.  Returns
 * where it ends. */
double axes_write(axes_drawing *d, stroke_point p, const double direction[2], double distance,
                  const char *text);

/* Ticks and numbers along an edge before the eye, in a direction of the picture; inner: ticks on both sides,
 * and none at 0.  Returns how far they reach from it. */
double axes_put_ticks(axes_drawing *d, const axes_edge *e, const double direction[2], int inner);

#endif
