/* decided_report.c - see decided_report.h. */
#include "decided_report.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "results.h"

enum { CELL = 16 };

/* Three digits; what there is none of is a dash. */
static const char *digits(double x, char text[CELL]) {
    if (isnan(x))
        snprintf(text, CELL, "-");
    else
        snprintf(text, CELL, "%.3g", x);
    return text;
}

void report_table(const finding *f, size_t count) {
    char us[CELL], low[CELL], high[CELL], lanes[CELL], times[CELL];
    printf("\n%-12s %6s  %-9s %6s %6s %9s %9s %9s %9s %9s\n", "surface", "degree", "kind", "rays", "open%",
           "us50%", "10%", "90%", "lanes", "times");
    for (const finding *r = f; r < f + count; r++)
        printf("%-12s %6d  %-9s %6zu %6.0f %9s %9s %9s %9s %9s\n", r->surface, r->degree, kind_names[r->kind],
               r->rays, 100 * (double)r->open / (double)r->rays, digits(r->us, us), digits(r->us_low, low),
               digits(r->us_high, high), digits(r->lanes, lanes), digits(r->us / r->lanes, times));
}

static void write_csv(const finding *f, size_t count, const char *folder) {
    static const char name[] = "decided.csv";
    char lanes[CELL], times[CELL];
    FILE *file = results_create(folder, name);
    fprintf(file, "surface,degree,kind,rays,open,us_median,us_low,us_high,lanes_us,times\n");
    for (const finding *r = f; r < f + count; r++)
        fprintf(file, "%s,%d,%s,%zu,%zu,%.4g,%.4g,%.4g,%s,%s\n", r->surface, r->degree, kind_names[r->kind],
                r->rays, r->open, r->us, r->us_low, r->us_high, digits(r->lanes, lanes),
                digits(r->us / r->lanes, times));
    results_finish(file, folder, name);
}

/* ---- charts ---- */

enum { MOST_DEGREES = 16, PANELS = 2, IN_PANEL = 6 };

typedef struct curve {
    double x[MOST_DEGREES], y[MOST_DEGREES];
    size_t count;
} curve;

/* Of the random surfaces: a kind's times by degree, or those of the lanes for a clear ray. */
static void fill_curve(curve *c, const finding *f, size_t count, kind which, int lanes) {
    c->count = 0;
    for (const finding *r = f; r < f + count && c->count < MOST_DEGREES; r++) {
        if (r->kind != which || strcmp(r->surface, "random") != 0) continue;
        c->x[c->count] = r->degree;
        c->y[c->count++] = lanes ? r->lanes : r->us;
    }
}

static void write_charts(const finding *f, size_t count, const char *folder) {
    static const kind panel[PANELS][IN_PANEL - 1] = {
        {KIND_CLEAR, KIND_END, KIND_TANGENT, KIND_SQUARE, KIND_INSIDE},
        {KIND_CLEAR, KIND_GAP_20, KIND_GAP_60, KIND_GAP_200, KIND_BALL}};
    static const char *const titles[PANELS] = {"What it costs to decide a ray that touches",
                                               "What it costs to decide a ray with roots close together"};
    curve curves[PANELS][IN_PANEL];
    plot_series series[PANELS][IN_PANEL];
    plot plots[PANELS];
    for (int p = 0; p < PANELS; p++) {
        for (int k = 0; k < IN_PANEL; k++) {
            curve *c = &curves[p][k];
            kind which = k ? panel[p][k - 1] : KIND_CLEAR;
            fill_curve(c, f, count, which, k == 0);
            series[p][k] = (plot_series){k ? kind_names[which] : "clear, doubles alone", PLOT_BOTH, c->x,
                                         c->y, c->count};
        }
        plots[p] = (plot){.title = titles[p],
                          .x = {.label = "degree of the surface"},
                          .y = {.label = "microseconds a ray", .scale = PLOT_LOG},
                          .series = series[p],
                          .count = IN_PANEL,
                          .height = 400};
    }
    plots[0].subtitle = "dense random surfaces, certified tier, one ray at a time, median";
    results_plot(plots, PANELS, folder, "decided.svg");
}

void report_files(const finding *f, size_t count, const char *folder) {
    write_csv(f, count, folder);
    write_charts(f, count, folder);
}
