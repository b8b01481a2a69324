/* contest_table.c - see contest.h: the table as text, CSV and chart. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "chart.h"
#include "contest.h"
#include "must.h"
#include "sheet.h"

/* In the row's unit: ns, us or ms. */
static double time_of(const contest_row *r, double share) {
    return (*r->unit == 'n' ? 1e9 : *r->unit == 'u' ? 1e6 : 1e3) * measure_taken(&r->takes, share);
}

/* Of the row's task, the time of the program "algsurf". */
static double own_time(const contest_table *t, const contest_row *row) {
    for (const contest_row *r = t->row; r < t->row + t->count; r++)
        if (strcmp(r->section, row->section) == 0 && strcmp(r->task, row->task) == 0 &&
            strcmp(r->program, "algsurf") == 0)
            return time_of(r, 0.5);
    return NAN;
}

typedef struct digits {
    char text[16];
} digits;

/* Four digits, no more than are known. */
static digits four_digits(double x) {
    digits d;
    snprintf(d.text, sizeof d.text, "%.*f", x < 10 ? 3 : x < 100 ? 2 : x < 1000 ? 1 : 0, x);
    return d;
}

static void add_row(sheet *s, const contest_chapter *c, const contest_row *r, double median, double times) {
    const char *mark = c->most_error > 0 && r->error > c->most_error ? " *" : "";
    sheet_add(s, "%s\t%s\t%d\t%s\t%s\t%s\t%s\t%s\t%s\t%zu\t%zu\t%zu\t%.1e%s\t%.2e", r->section, r->task,
              r->degree, r->program, r->unit, four_digits(median).text, four_digits(time_of(r, 0)).text,
              four_digits(time_of(r, 1)).text, four_digits(times).text, r->count, r->missed, r->extra,
              r->error, mark, r->error);
}

void contest_report(const char *others, int takes, const contest_chapter *chapters, size_t count,
                    const contest_table *table, const char *folder, const char *name) {
    enum { COUNT = 9 }; /* a column */
    char machine[512], head[32], label[16][32], file[64];
    sheet_column columns[] = {
        {"", 0, "section"}, {"task", -14, NULL}, {"degree", 6, NULL}, {"program", -22, NULL},
        {"", 0, "unit"},    {head, 9, "median"}, {"min", 9, NULL},    {"max", 9, NULL},
        {"times", 8, NULL}, {"", 7, "count"},    {"", 7, "missed"},   {"", 7, "extra"},
        {"", 8, ""},        {"", 0, "error"}};
    sheet rows = SHEET(columns);
    chart *charts = must_allocate(count, sizeof *charts);
    size_t drawn = 0;
    measure_machine(machine, sizeof machine);
    printf("libalgsurf and %s; medians of %d takes in turn; times: in units of algsurf's median\n"
           "machine: %s; kernel %s\n",
           others, takes, machine, algsurf_kernel_name(0));
    for (const contest_chapter *c = chapters; c < chapters + count; c++) {
        chart *d = &charts[drawn];
        for (const contest_row *r = table->row; r < table->row + table->count; r++) {
            if (strcmp(r->section, c->section) != 0) continue;
            const double median = time_of(r, 0.5);
            add_row(&rows, c, r, median, median / own_time(table, r));
            chart_series(d, r->program, PLOT_BARS);
            chart_bar(d, r->task, median);
            snprintf(head, sizeof head, "median %s", r->unit);
            snprintf(label[drawn], sizeof *label, "CPU time (%s)", r->unit);
        }
        if (rows.printed == rows.length) continue;
        for (int k = 0; k < 4; k++) columns[COUNT + k].title = c->heads[k];
        printf("\n%s\n", c->title);
        sheet_print(&rows, 0);
        d->plot.title = c->caption;
        d->plot.subtitle = c->subtitle;
        d->plot.y = (plot_axis){.label = label[drawn++], .scale = PLOT_LOG};
        d->plot.width = 960;
        chart_margins(d, 0, 2);
    }
    snprintf(file, sizeof file, "%s.csv", name);
    sheet_write(&rows, folder, file);
    snprintf(file, sizeof file, "%s.svg", name);
    chart_write(charts, drawn, folder, file);
    free(charts);
    free(rows.rows);
}
