/* chart.c - see chart.h. */
#include "chart.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "must.h"
#include "results.h"

enum { ROOM = 16 };

/* Room for one more of `count`: it grows where that is ROOM, or twice, four times .. as many. */
static void *grow(void *memory, size_t count, size_t size) {
    if (count > 0 && (count < ROOM || (count & (count - 1)) != 0)) return memory;
    memory = realloc(memory, (count > 0 ? 2 * count : ROOM) * size);
    if (!memory) cli_no_memory();
    return memory;
}

void chart_series(chart *c, const char *name, plot_mark mark) {
    size_t k = 0;
    while (k < c->plot.count && !(name && c->series[k].name && strcmp(c->name[k], name) == 0)) k++;
    if (k == CHART_MOST_SERIES) cli_fail(CLI_BROKEN, "no room for %s in the chart", name ? name : "a guide");
    if (k == c->plot.count) c->series[c->plot.count++] = (plot_series){name, mark, NULL, NULL, 0};
    if (name) snprintf(c->name[k], sizeof *c->name, "%s", name);
    c->current = k;
}

void chart_point(chart *c, double x, double y) {
    size_t k = c->current, n = c->series[k].count++;
    c->x[k] = grow(c->x[k], n, sizeof x);
    c->y[k] = grow(c->y[k], n, sizeof y);
    c->x[k][n] = x;
    c->y[k][n] = y;
}

void chart_bar(chart *c, const char *place, double y) {
    size_t n = 0;
    while (n < c->places && strcmp(c->place[n], place) != 0) n++;
    if (n == CHART_MOST_PLACES) cli_fail(CLI_BROKEN, "no room for %s in the chart", place);
    if (n == c->places) snprintf(c->place[c->places++], sizeof *c->place, "%s", place);
    chart_point(c, (double)n, y);
}

static void widen(plot_axis *axis, double times, double value) {
    if (times == 0) return;
    axis->lo = axis->lo == axis->hi ? value / times : fmin(axis->lo, value / times);
    axis->hi = fmax(axis->hi, value * times);
}

void chart_margins(chart *c, double x_times, double y_times) {
    for (size_t k = 0; k < c->plot.count; k++)
        for (size_t i = 0; i < c->series[k].count; i++) {
            widen(&c->plot.x, x_times, c->x[k][i]);
            widen(&c->plot.y, y_times, c->y[k][i]);
        }
}

void chart_write(chart *charts, size_t count, const char *folder, const char *name) {
    plot *plots = must_allocate(count, sizeof *plots);
    for (size_t i = 0; i < count; i++) {
        chart *c = &charts[i];
        for (size_t k = 0; k < c->plot.count; k++) {
            c->series[k].x = c->x[k];
            c->series[k].y = c->y[k];
            if (c->series[k].name) c->series[k].name = c->name[k];
        }
        if (!c->plot.title) c->plot.title = c->title;
        c->plot.series = c->series;
        for (size_t n = 0; n < c->places; n++) c->names[n] = c->place[n];
        if (c->places > 0) c->plot.x.names = c->names;
        plots[i] = c->plot;
    }
    if (folder) {
        FILE *file = results_open(folder, name, "wb");
        if (plot_put_column(plots, count, file) != 0) cli_no_memory();
        results_finish(file, folder, name);
    }
    for (chart *c = charts; c < charts + count; c++)
        for (size_t k = 0; k < c->plot.count; k++) free(c->x[k]), free(c->y[k]);
    free(plots);
}
