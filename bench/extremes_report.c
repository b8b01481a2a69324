/* extremes_report.c - see extremes.h: what is told. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "chart.h"
#include "extremes.h"
#include "sheet.h"

static double percent(size_t part, size_t whole) { return 100 * (double)part / (double)whole; }

static const double ZERO_PLACE = 1e-307; /* of 0 on a logarithmic axis: left of all that is swept */
static const double LEAST_ERROR = 1e-2;  /* of t, shown: smaller ones, and none, are as good */
static const double MOST_ERROR = 10;     /* the axis of errors ends there, or further up */

/* Doubt and error and time, one below the other. */
static void write_charts(const record *r, const char *folder) {
    static const char *const names[MANNERS] = {"bounded", "certified", "certified, packet"};
    const plot_axis x = {.label = r->sweep->quantity, .scale = PLOT_LOG};
    const plot_axis doubt = {.label = "% of the rays", .scale = PLOT_SYMLOG, .hi = 100, .linear = 0.1};
    const plot_axis error = {.label = "largest error of t, in u \316\272 |t|",
                             .scale = PLOT_LOG,
                             .lo = LEAST_ERROR,
                             .hi = MOST_ERROR};
    const plot_axis time = {.label = "ns a ray", .scale = PLOT_LOG};
    chart charts[] = {
        {.plot = {r->sweep->title, "rays that are left open; no answer is wrong", x, doubt, .height = 320}},
        {.plot =
             {"How far off a hit is at most",
              "u = 2^-53, \316\272: condition of the root; 0.01 stands for less, and where there is no hit",
              x, error, .height = 320}},
        {.plot = {"What a ray costs", NULL, x, time, .height = 320}}};
    char file[64];
    for (int m = 0; m < MANNERS; m++) {
        for (int p = 0; p < 3; p++) chart_series(&charts[p], names[m], PLOT_BOTH);
        for (int i = 0; i < r->sweep->points; i++) {
            const finding *f = &r->finding[i][m];
            const double at = r->sweep->values[i] > 0 ? r->sweep->values[i] : ZERO_PLACE;
            chart_point(&charts[0], at, percent(f->undecided, f->rays));
            chart_point(&charts[1], at, fmax(f->error_max, LEAST_ERROR));
            chart_point(&charts[2], at, f->ns);
        }
    }
    chart_margins(&charts[1], 0, 1);
    snprintf(file, sizeof file, "extremes_%s.svg", r->sweep->name);
    chart_write(charts, sizeof charts / sizeof *charts, folder, file);
}

void report(const record *records, size_t count, const char *folder) {
    sheet_column columns[] = {{"", 0, "sweep"},        {"", 8, "value"},
                              {"manner", -9, NULL},    {"rays", 6, NULL},
                              {"hits", 6, NULL},       {"undecided%", 10, ""},
                              {"", 0, "undecided"},    {"error50%", 8, "error_median"},
                              {"max", 8, "error_max"}, {"ns50%", 9, "ns"},
                              {"min", 9, "ns_min"},    {"max", 9, "ns_max"}};
    sheet table = SHEET(columns);
    for (const record *r = records; r < records + count; r++) {
        const sweep *s = r->sweep;
        for (int point = 0; point < s->points; point++)
            for (int m = 0; m < MANNERS; m++) {
                const finding *f = &r->finding[point][m];
                sheet_add(&table, "%s\t%.3g\t%s\t%zu\t%zu\t%.2f\t%zu\t%.2g\t%.2g\t%.1f\t%.1f\t%.1f", s->name,
                          s->values[point], manner_names[m], f->rays, f->hits, percent(f->undecided, f->rays),
                          f->undecided, f->error_median, f->error_max, f->ns, f->ns_min, f->ns_max);
            }
        columns[1].title = s->name;
        printf("\n%s\n%s: %s\n", s->title, s->name, s->quantity);
        sheet_print(&table, 0);
        write_charts(r, folder);
    }
    sheet_write(&table, folder, "extremes.csv");
    free(table.rows);
}
