/* chart.h - charts in the making: series by their names, points as they come. */
#ifndef CHART_H
#define CHART_H
#include "plot.h"

enum { CHART_MOST_SERIES = 8, CHART_MOST_PLACES = 64 };

/* `plot` is to be set, but for series and names, which the functions below fill. */
typedef struct chart {
    plot plot;
    char title[160]; /* a title that is made */
    plot_series series[CHART_MOST_SERIES];
    char name[CHART_MOST_SERIES][64];
    double *x[CHART_MOST_SERIES], *y[CHART_MOST_SERIES];
    size_t current, places;
    char place[CHART_MOST_PLACES][32];
    const char *names[CHART_MOST_PLACES + 1];
} chart;

/* The points that follow are of the series of that name, which is begun if there is none; of a guide (null)
 * always. */
void chart_series(chart *c, const char *name, plot_mark mark);

void chart_point(chart *c, double x, double y);
void chart_bar(chart *c, const char *place, double y); /* over a place of the x axis, by its name */

/* Lets the axes end at the least and the largest number over and times so many; 0: that one as it is. */
void chart_margins(chart *c, double x_times, double y_times);

/* Writes charts, one below the other, into the folder unless it is null; frees their points. */
void chart_write(chart *charts, size_t count, const char *folder, const char *name);

#endif
