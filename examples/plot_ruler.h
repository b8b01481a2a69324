/* plot_ruler.h - an axis of a chart: its range, places of values along it, its ticks. */
#ifndef PLOT_RULER_H
#define PLOT_RULER_H
#include "plot.h"

typedef struct plot_ruler {
    plot_scale scale;
    double lo, hi;
    double linear; /* PLOT_SYMLOG */
} plot_ruler;

typedef struct plot_tick {
    double at;      /* along the axis, 0..1 */
    char text[112]; /* SVG; empty: a minor tick */
    double width;   /* of the text in its own height, about */
} plot_tick;

enum { PLOT_MOST_TICKS = 400 };

/* Can an axis of that scale show the value at all? */
int plot_scale_shows(plot_scale scale, double value);

/* The ruler that shows count values (of which those that cannot be shown are left out); with_zero: bars
 * stand on it, so that it has to begin at or below 0, or at a power of ten. */
plot_ruler plot_ruler_make(const plot_axis *axis, const double *values, size_t count, int with_zero);

/* Where a value is: 0 at lo, 1 at hi, limited to -1000..1000; NaN when it cannot be shown. */
double plot_ruler_at(const plot_ruler *r, double value);

/* Ticks, at most `most` of them with a number (if possible).  Returns how many. */
int plot_ruler_ticks(const plot_ruler *r, int most, plot_tick ticks[PLOT_MOST_TICKS]);

/* About the width of a text in its own height; entities and markup are not understood. */
double plot_text_width(const char *text);

#endif
