/* plot_draw.h - the series of a chart inside its frame, and their keys in the legend. */
#ifndef PLOT_DRAW_H
#define PLOT_DRAW_H
#include <stdio.h>

#include "plot_ruler.h"

enum { PLOT_SMALL = 12 }; /* height of all text but titles and labels */

/* Where the values are drawn, in pixels of the chart. */
typedef struct plot_frame {
    double left, top, width, height;
    plot_ruler x, y;
} plot_frame;

/* Text, with what SVG wants escaped. */
void plot_put_text(FILE *out, const char *text, size_t length);

/* What stands for series number `index` in the legend, its middle at the height y. */
double plot_key_width(const plot_series *s);
void plot_put_key(FILE *out, const plot_series *s, size_t index, double x, double y);

/* Where a value is in a frame, from its upper left corner. */
double plot_x_of(const plot_frame *f, double value);
double plot_y_of(const plot_frame *f, double value);

/* Do the points of such a series have values y?  Are they joined by a line?  Have they marks? */
int plot_has_values(plot_mark mark);
int plot_is_line(plot_mark mark);
int plot_has_points(plot_mark mark);

void plot_put_series(FILE *out, const plot *p, const plot_frame *f);

#endif
