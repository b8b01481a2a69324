/* plot.h - charts as SVG documents.
 *
 * A chart has a title, two axes, series of points, and a legend.  It stands alone: no font, script or style
 * from elsewhere, and a light panel of its own, so that it can be read on any page.  Series are told apart
 * by colour (distinguishable by colour-blind people), and by the shape of their marks or the dashes of
 * their lines.
 */
#ifndef PLOT_H
#define PLOT_H
#include <stddef.h>
#include <stdio.h>

typedef enum plot_scale {
    PLOT_LINEAR,
    PLOT_LOG,   /* base 10, values > 0 */
    PLOT_SYMLOG /* logarithmic on both sides of a linear middle */
} plot_scale;

typedef struct plot_axis {
    const char *label; /* what, and its unit; null: none */
    plot_scale scale;
    double lo, hi;            /* the values at its ends; lo == hi: from the data */
    double linear;            /* PLOT_SYMLOG: |values| up to it are linear; 0: chosen from the data */
    const char *const *names; /* of the x axis only: the places 0, 1, 2, .. are called so; ends with a null.
                                 Null: numbers */
} plot_axis;

typedef enum plot_mark {
    PLOT_LINE,
    PLOT_POINTS,
    PLOT_BOTH,
    PLOT_STEPS,    /* a value holds up to the next x */
    PLOT_BARS,     /* bars of several series at the same x stand side by side */
    PLOT_NUMBERED, /* points with their numbers, from 0, beside them where there is room */
    PLOT_BANDS,    /* shaded from x[0] to x[1], x[2] to x[3], ..., over the whole height; y plays no part */
    PLOT_RULES     /* a line from top to bottom at each x; y plays no part */
} plot_mark;

/* NaN breaks a line; values that their axis cannot show (<= 0 on a logarithmic one, infinite) are left out,
 * and so is what lies beyond the ends of an axis.  Bands and rules do not widen an axis. */
typedef struct plot_series {
    const char *name; /* in the legend; null: not there, and a line is a guide, thin and grey */
    plot_mark mark;
    const double *x, *y;
    size_t count;
} plot_series;

typedef struct plot {
    const char *title, *subtitle; /* null: none */
    plot_axis x, y;
    const plot_series *series;
    size_t count;
    int width, height; /* 0: 800 x 480 */
} plot;

/* Writes the chart as an SVG file.  Returns 0, or -1 when the file could not be written: nothing is left
 * behind then. */
int plot_write(const plot *p, const char *file);

/* Several charts in one file, one below the other. */
int plot_write_column(const plot *plots, size_t count, const char *file);

/* The same into an open file.  Returns 0, or -1 for want of memory; a write error is left to the caller to
 * see, in ferror(out). */
int plot_put_column(const plot *plots, size_t count, FILE *out);

#endif
