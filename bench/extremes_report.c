/* extremes_report.c - see extremes_report.h. */
#include "extremes_report.h"

#include <math.h>
#include <stdio.h>

#include "results.h"

static double percent(size_t part, size_t whole) { return 100 * (double)part / (double)whole; }

/* ---- tables ---- */

/* Two digits will do; what there is none of is a dash. */
static const char *error_text(double error, char text[16]) {
    if (isnan(error))
        snprintf(text, 16, "-");
    else
        snprintf(text, 16, "%.2g", error);
    return text;
}

void report_table(const record *r) {
    char median[16], most[16];
    printf("\n%s\n%s: %s\n\n%8s  %-9s %6s %6s %10s %8s %8s %9s %9s %9s\n", r->sweep->title, r->sweep->name,
           r->sweep->quantity, r->sweep->name, "manner", "rays", "hits", "undecided%", "error50%", "max",
           "ns50%", "min", "max");
    for (int point = 0; point < r->sweep->points; point++)
        for (int m = 0; m < MANNERS; m++) {
            const finding *f = &r->finding[point][m];
            printf("%8.3g  %-9s %6zu %6zu %10.2f %8s %8s %9.0f %9.0f %9.0f\n", r->sweep->values[point],
                   manner_names[m], f->rays, f->hits, percent(f->undecided, f->rays),
                   error_text(f->error_median, median), error_text(f->error_max, most), f->ns, f->ns_min,
                   f->ns_max);
        }
}

/* ---- files ---- */

static void write_csv(const record *records, size_t count, const char *folder) {
    static const char name[] = "extremes.csv";
    char median[16], most[16];
    FILE *file = results_create(folder, name);
    fprintf(file, "sweep,value,manner,rays,hits,undecided,error_median,error_max,ns,ns_min,ns_max\n");
    for (const record *r = records; r < records + count; r++)
        for (int point = 0; point < r->sweep->points; point++)
            for (int m = 0; m < MANNERS; m++) {
                const finding *f = &r->finding[point][m];
                fprintf(file, "%s,%.3g,%s,%zu,%zu,%zu,%s,%s,%.1f,%.1f,%.1f\n", r->sweep->name,
                        r->sweep->values[point], manner_names[m], f->rays, f->hits, f->undecided,
                        error_text(f->error_median, median), error_text(f->error_max, most), f->ns, f->ns_min,
                        f->ns_max);
            }
    results_finish(file, folder, name);
}

#define ZERO_PLACE 1e-307 /* of 0 on a logarithmic axis: left of all that is swept */
#define LEAST_ERROR 1e-2  /* of t, shown: smaller ones, and none, are as good */
#define MOST_ERROR 10     /* the axis of errors ends there, or further up */

enum { PANELS = 3 };

static double shown(const finding *f, int panel) {
    if (panel == 0) return percent(f->undecided, f->rays);
    return panel == 1 ? fmax(f->error_max, LEAST_ERROR) : f->ns;
}

/* Doubt and error and time, one below the other. */
static void write_charts(const record *r, const char *folder) {
    static const char *const names[MANNERS] = {"bounded", "certified", "certified, packet"};
    static const plot_axis y[PANELS] = {
        {.label = "% of the rays", .scale = PLOT_SYMLOG, .hi = 100, .linear = 0.1},
        {.label = "largest error of t, in u \316\272 |t|", .scale = PLOT_LOG},
        {.label = "ns a ray", .scale = PLOT_LOG}};
    double x[MOST_POINTS], values[PANELS][MANNERS][MOST_POINTS];
    plot_series series[PANELS][MANNERS];
    plot plots[PANELS];
    char file[64];
    size_t count = (size_t)r->sweep->points;
    for (size_t i = 0; i < count; i++) {
        x[i] = r->sweep->values[i] > 0 ? r->sweep->values[i] : ZERO_PLACE;
        for (int p = 0; p < PANELS; p++)
            for (int m = 0; m < MANNERS; m++) values[p][m][i] = shown(&r->finding[i][m], p);
    }
    for (int p = 0; p < PANELS; p++) {
        for (int m = 0; m < MANNERS; m++)
            series[p][m] = (plot_series){names[m], PLOT_BOTH, x, values[p][m], count};
        plots[p] = (plot){.x = {.label = r->sweep->quantity, .scale = PLOT_LOG},
                          .y = y[p],
                          .series = series[p],
                          .count = MANNERS,
                          .height = 320};
    }
    plots[0].title = r->sweep->title;
    plots[0].subtitle = "rays that are left open; no answer is wrong";
    plots[1].title = "How far off a hit is at most";
    plots[1].subtitle =
        "u = 2^-53, \316\272: condition of the root; 0.01 stands for less, and where there is no hit";
    plots[2].title = "What a ray costs";
    plots[1].y.lo = LEAST_ERROR;
    plots[1].y.hi = MOST_ERROR;
    for (size_t i = 0; i < count; i++)
        for (int m = 0; m < MANNERS; m++) plots[1].y.hi = fmax(plots[1].y.hi, values[1][m][i]);
    snprintf(file, sizeof file, "extremes_%s.svg", r->sweep->name);
    results_plot(plots, PANELS, folder, file);
}

void report_files(const record *records, size_t count, const char *folder) {
    write_csv(records, count, folder);
    for (size_t i = 0; i < count; i++) write_charts(&records[i], folder);
}
