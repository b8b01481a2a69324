/* contest_table.c - see contest.h: the table as text, CSV and chart. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "cli.h"
#include "algsurf/status.h"
#include "contest.h"
#include "measure.h"
#include "results.h"

/* Of the row's task, the time of the program "algsurf". */
static double own_time(const contest_table *t, const contest_row *row) {
    for (const contest_row *r = t->row; r < t->row + t->count; r++)
        if (strcmp(r->section, row->section) == 0 && strcmp(r->task, row->task) == 0 &&
            strcmp(r->program, "algsurf") == 0)
            return r->median;
    return NAN;
}

/* Four digits, no more than are known. */
static const char *four_digits(double x, char text[16]) {
    snprintf(text, 16, "%.*f", x < 10 ? 3 : x < 100 ? 2 : x < 1000 ? 1 : 0, x);
    return text;
}

static void print_row(const contest_row *r, double times, int marked) {
    char median[16], least[16], most[16], ratio[16];
    printf("%-14s %6d  %-22s %9s %9s %9s %8s %7zu %7zu %7zu %8.1e%s\n", r->task, r->degree, r->program,
           four_digits(r->median, median), four_digits(r->least, least), four_digits(r->most, most),
           four_digits(times, ratio), r->count, r->missed, r->extra, r->error, marked ? " *" : "");
}

static void print_chapter(const contest_chapter *c, const contest_table *t) {
    int some = 0;
    for (const contest_row *r = t->row; r < t->row + t->count; r++) {
        if (strcmp(r->section, c->section) != 0) continue;
        if (!some++) {
            printf("\n%s\n\n", c->title);
            printf("%-14s %6s  %-22s %6s %s %9s %9s %8s %7s %7s %7s %8s\n", "task", "degree", "program",
                   "median", c->unit, "min", "max", "times", c->count, c->missed, c->extra, c->error);
        }
        print_row(r, r->median / own_time(t, r), c->most_error > 0 && r->error > c->most_error);
    }
}

void contest_head(const char *others, int takes) {
    char machine[512];
    measure_machine(machine, sizeof machine);
    printf("libalgsurf and %s; medians of %d takes in turn; times: in units of algsurf's median\n"
           "machine: %s; kernel %s\n",
           others, takes, machine, algsurf_kernel_name(0));
}

void contest_print(const contest_chapter *chapters, size_t count, const contest_table *table) {
    for (size_t i = 0; i < count; i++) print_chapter(&chapters[i], table);
}

static void write_csv(const contest_table *t, const char *folder, const char *name) {
    FILE *file = results_create(folder, name);
    fprintf(file, "section,task,degree,program,unit,median,min,max,times,count,missed,extra,error\n");
    for (const contest_row *r = t->row; r < t->row + t->count; r++)
        fprintf(file, "%s,%s,%d,%s,%s,%.4g,%.4g,%.4g,%.4g,%zu,%zu,%zu,%.2e\n", r->section, r->task, r->degree,
                r->program, r->unit, r->median, r->least, r->most, r->median / own_time(t, r), r->count,
                r->missed, r->extra, r->error);
    results_finish(file, folder, name);
}

enum { MOST_CHAPTERS = 8, MOST_TASKS = 16, MOST_PROGRAMS = 8 }; /* colours */

/* One section as bars: tasks side by side, the programs in each. */
typedef struct chart {
    const char *task[MOST_TASKS + 1], *program[MOST_PROGRAMS];
    size_t tasks, programs;
    double x[MOST_TASKS], y[MOST_PROGRAMS][MOST_TASKS], least, most;
    plot_series series[MOST_PROGRAMS];
} chart;

static size_t place(const char **names, size_t *count, size_t most, const char *name) {
    size_t i = 0;
    while (i < *count && strcmp(names[i], name) != 0) i++;
    if (i == most) cli_fail(CLI_BROKEN, "no room for %s in the chart", name);
    if (i == *count) names[(*count)++] = name;
    return i;
}

static void fill_chart(chart *c, const char *section, const contest_table *t) {
    *c = (chart){.least = INFINITY};
    for (int p = 0; p < MOST_PROGRAMS; p++)
        for (int k = 0; k < MOST_TASKS; k++) c->y[p][k] = NAN;
    for (const contest_row *r = t->row; r < t->row + t->count; r++) {
        if (strcmp(r->section, section) != 0) continue;
        size_t k = place(c->task, &c->tasks, MOST_TASKS, r->task);
        size_t p = place(c->program, &c->programs, MOST_PROGRAMS, r->program);
        c->x[k] = (double)k;
        c->y[p][k] = r->median;
        c->least = fmin(c->least, r->median);
        c->most = fmax(c->most, r->median);
    }
    for (size_t p = 0; p < c->programs; p++)
        c->series[p] = (plot_series){c->program[p], PLOT_BARS, c->x, c->y[p], c->tasks};
}

static void write_svg(const contest_chapter *chapters, size_t count, const contest_table *t,
                      const char *folder, const char *name) {
    static chart charts[MOST_CHAPTERS];
    static char label[MOST_CHAPTERS][32];
    plot plots[MOST_CHAPTERS];
    size_t drawn = 0;
    for (size_t i = 0; i < count && i < MOST_CHAPTERS; i++) {
        chart *c = &charts[i];
        fill_chart(c, chapters[i].section, t);
        snprintf(label[i], sizeof label[i], "CPU time (%s)", chapters[i].unit);
        if (c->tasks > 0)
            plots[drawn++] = (plot){.title = chapters[i].caption,
                                    .subtitle = chapters[i].subtitle,
                                    .x = {.names = c->task},
                                    .y = {label[i], PLOT_LOG, 0.5 * c->least, 2 * c->most, 0, NULL},
                                    .series = c->series,
                                    .count = c->programs,
                                    .width = 960};
    }
    results_plot(plots, drawn, folder, name);
}

void contest_write(const contest_chapter *chapters, size_t count, const contest_table *table,
                   const char *folder, const char *name) {
    char file[64];
    snprintf(file, sizeof file, "%s.csv", name);
    write_csv(table, folder, file);
    snprintf(file, sizeof file, "%s.svg", name);
    write_svg(chapters, count, table, folder, file);
}
