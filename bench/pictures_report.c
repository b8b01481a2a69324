/* pictures_report.c - see pictures_report.h. */
#include "pictures_report.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli.h"
#include "measure.h"
#include "must.h"
#include "results.h"

static const char legend[] =
    "Pictures, and what they cost: the eye 4 R from the extent's centre, R its radius, in the direction\n"
    "(2,-3,1.2), the picture 2.2 R high there.\n"
    "  rays       pixels whose ray meets the extent\n"
    "  hits       pixels that show the surface\n"
    "  manner     a kernel's name: that kernel with one thread, certified tier, standard quality; else the\n"
    "             fastest kernel: two, all: threads; all that follow have one thread.  bounded: the tier;\n"
    "             antialias: 3x3 samples a pixel; adaptive: the same for pixels that differ from a\n"
    "             neighbour by a tenth of a colour's range; single: ray by ray (Brent's method), one\n"
    "             picture; full: full quality, one picture\n"
    "  ms50%      wall time of algsurf_render, milliseconds: median; min, max: its spread\n"
    "  ns/ray     ms50% for each of the rays\n"
    "  per_s      pictures a second\n"
    "  expand% .. share of the threads' time spent there, as algsurf_render_stats tells; the rest is\n"
    "             bytes, and waiting for the other threads\n"
    "  times      ms50% in units of that of the fastest kernel, one thread\n"
    "Solving and its floor, a surface without points in the extent, so that each ray is a chord,\n"
    "coefficients and their signs:\n"
    "  solve      time spent in intersection, ns for each of the rays, median\n"
    "  floor      the same, of P + c, c twice what |P| can be in the extent\n"
    "  ratio      solve / floor\n";

static double median(const times *t, int part) { return measure_quantile(t->seconds[part], t->count, 0.5); }

static double ns_per_ray(const result *r, const times *t, int part) {
    return 1e9 * median(t, part) / (double)r->rays;
}

/* ---- the tables ---- */

enum { CELL = 24 };

typedef enum format { TEXT, TSV, CSV } format;

typedef struct column {
    const char *title;
    int width; /* negative: flush left */
} column;

static const column cost_columns[] = {
    {"surface", -12}, {"degree", 6}, {"rays", 7},    {"hits", 7},   {"manner", -9}, {"threads", 7},
    {"ms50%", 8},     {"min", 8},    {"max", 8},     {"ns/ray", 7}, {"per_s", 7},   {"expand%", 7},
    {"solve%", 6},    {"point%", 6}, {"shadow%", 7}, {"shade%", 6}, {"times", 6}};
static const column floor_columns[] = {{"surface", -12}, {"degree", 6}, {"kernel", -8},
                                       {"solve", 8},     {"floor", 8},  {"ratio", 6}};

enum {
    COST_COLUMNS = sizeof cost_columns / sizeof *cost_columns,
    FLOOR_COLUMNS = sizeof floor_columns / sizeof *floor_columns
};

static void put_row(FILE *to, const column *columns, int count, const char cell[][CELL], format form) {
    for (int k = 0; k < count; k++)
        if (form == TEXT)
            fprintf(to, "%s%*s", k > 0 ? "  " : "", columns[k].width, cell[k]);
        else
            fprintf(to, "%s%s", k == 0 ? "" : form == TSV ? "\t" : ",", cell[k]);
    fputc('\n', to);
}

static void put_titles(FILE *to, const column *columns, int count, format form) {
    static const char *const before[] = {"\n", "#", ""};
    char cell[COST_COLUMNS][CELL];
    for (int k = 0; k < count; k++) snprintf(cell[k], CELL, "%s", columns[k].title);
    fputs(before[form], to);
    put_row(to, columns, count, (const char(*)[CELL])cell, form);
}

static void put_cost(FILE *to, const result *r, const manner *m, const times *t, format form) {
    char cell[COST_COLUMNS][CELL];
    double seconds = median(t, PART_ALL);
    snprintf(cell[0], CELL, "%s", r->entry->name);
    snprintf(cell[1], CELL, "%d", r->entry->degree);
    snprintf(cell[2], CELL, "%zu", r->rays);
    snprintf(cell[3], CELL, "%zu", r->hits);
    snprintf(cell[4], CELL, "%s", m->name);
    snprintf(cell[5], CELL, "%d", t->threads);
    snprintf(cell[6], CELL, "%.3f", 1e3 * seconds);
    snprintf(cell[7], CELL, "%.3f", 1e3 * t->seconds[PART_ALL][0]);
    snprintf(cell[8], CELL, "%.3f", 1e3 * t->seconds[PART_ALL][t->count - 1]);
    snprintf(cell[9], CELL, "%.1f", ns_per_ray(r, t, PART_ALL));
    snprintf(cell[10], CELL, "%.2f", 1 / seconds);
    for (int part = PART_EXPAND; part < PARTS; part++)
        snprintf(cell[10 + part], CELL, "%.1f", 100 * median(t, part) / (seconds * t->threads));
    snprintf(cell[16], CELL, "%.2f", seconds / median(&r->times[0], PART_ALL));
    put_row(to, cost_columns, COST_COLUMNS, (const char(*)[CELL])cell, form);
}

static void put_floor(FILE *to, const result *r, const char *kernel, const times *whole, const times *lifted,
                      format form) {
    char cell[FLOOR_COLUMNS][CELL];
    double solve = ns_per_ray(r, whole, PART_SOLVE), least = ns_per_ray(r, lifted, PART_SOLVE);
    snprintf(cell[0], CELL, "%s", r->entry->name);
    snprintf(cell[1], CELL, "%d", r->entry->degree);
    snprintf(cell[2], CELL, "%s", kernel);
    snprintf(cell[3], CELL, "%.1f", solve);
    snprintf(cell[4], CELL, "%.1f", least);
    snprintf(cell[5], CELL, "%.2f", solve / least);
    put_row(to, floor_columns, FLOOR_COLUMNS, (const char(*)[CELL])cell, form);
}

static void put_costs(FILE *to, const report *r, format form) {
    const plan *p = r->plan;
    put_titles(to, cost_columns, COST_COLUMNS, form);
    for (const result *a = r->results; a < r->results + r->surfaces; a++)
        for (int i = 0; i < p->count; i++)
            if (!p->manner[i].lifted) put_cost(to, a, &p->manner[i], &a->times[i], form);
}

static void put_floors(FILE *to, const report *r, format form) {
    const plan *p = r->plan;
    put_titles(to, floor_columns, FLOOR_COLUMNS, form);
    for (const result *a = r->results; a < r->results + r->surfaces; a++)
        for (int i = 0; i < p->kernels; i++)
            put_floor(to, a, p->manner[i].name, &a->times[i], &a->times[p->kernels + i], form);
}

void report_print(const report *r, int tsv) {
    const char *mark = tsv ? "# " : "";
    measure_print_lines(legend, mark);
    measure_print_machine(mark);
    printf("%ssize: %dx%d\n%srepeat: %d\n", mark, r->width, r->height, mark, r->repeat);
    put_costs(stdout, r, tsv ? TSV : TEXT);
    put_floors(stdout, r, tsv ? TSV : TEXT);
    cli_finish_output();
}

/* ---- the files ---- */

enum { MOST_SERIES = 7 }; /* colours that plot.h has */

/* Places 0, 1, ... for the surfaces, and what is told of each. */
typedef struct chart {
    const char **name; /* of the surfaces; ends with a null */
    double *x, *y;     /* y: series by series */
    plot_series series[MOST_SERIES];
    size_t count, surfaces;
} chart;

static chart open_chart(const report *r) {
    size_t n = (size_t)r->surfaces;
    chart c = {.name = must_allocate(n + 1, sizeof *c.name),
               .x = must_allocate(n, sizeof *c.x),
               .y = must_allocate(MOST_SERIES * n, sizeof *c.y),
               .surfaces = n};
    for (size_t i = 0; i < n; i++) {
        c.name[i] = r->results[i].entry->name;
        c.x[i] = (double)i;
    }
    return c;
}

static void close_chart(chart *c) {
    free(c->name);
    free(c->x);
    free(c->y);
}

/* A series of a point or bar a surface; where its numbers go. */
static double *add_series(chart *c, const char *name, plot_mark mark) {
    double *y = c->y + c->count * c->surfaces;
    c->series[c->count++] = (plot_series){name, mark, c->x, y, c->surfaces};
    return y;
}

static void add_manner(chart *c, const report *r, int number, const char *name) {
    double *y = add_series(c, name, PLOT_BARS);
    for (size_t i = 0; i < c->surfaces; i++) y[i] = 1e3 * median(&r->results[i].times[number], PART_ALL);
}

static void chart_kernels(chart *c, const report *r) {
    for (int i = 0; i < r->plan->kernels && c->count < MOST_SERIES - 2; i++)
        add_manner(c, r, i, r->plan->manner[i].name);
    for (int i = 0; i < r->plan->count; i++)
        if (strcmp(r->plan->manner[i].name, "all") == 0)
            add_manner(c, r, i, "all threads");
        else if (strcmp(r->plan->manner[i].name, "single") == 0)
            add_manner(c, r, i, "ray by ray");
}

static void chart_quality(chart *c, const report *r) {
    static const char *const shown[][2] = {{"bounded", "bounded tier"},
                                           {"antialias", "3x3 samples"},
                                           {"adaptive", "3x3 on edges"},
                                           {"full", "area lights and shadows"}};
    add_manner(c, r, 0, "certified tier");
    for (size_t k = 0; k < sizeof shown / sizeof *shown; k++)
        for (int i = 0; i < r->plan->count; i++)
            if (strcmp(r->plan->manner[i].name, shown[k][0]) == 0) add_manner(c, r, i, shown[k][1]);
}

static void chart_floor(chart *c, const report *r) {
    double *solve = add_series(c, "solving", PLOT_BARS), *least = add_series(c, "its floor", PLOT_BARS);
    for (size_t i = 0; i < c->surfaces; i++) {
        const result *a = &r->results[i];
        solve[i] = ns_per_ray(a, &a->times[0], PART_SOLVE);
        least[i] = ns_per_ray(a, &a->times[r->plan->kernels], PART_SOLVE);
    }
}

static plot finish_chart(const chart *c, const char *title, const char *subtitle, plot_axis y) {
    return (plot){.title = title,
                  .subtitle = subtitle,
                  .x = {.names = c->name},
                  .y = y,
                  .series = c->series,
                  .count = c->count,
                  .width = 960};
}

static void write_charts(const report *r, const char *folder) {
    static const plot_axis time = {.label = "time of a picture (ms)", .scale = PLOT_LOG};
    chart kernels = open_chart(r), quality = open_chart(r), floor = open_chart(r);
    char size[64], machine[512];
    snprintf(size, sizeof size, "%dx%d, certified tier, one thread unless named", r->width, r->height);
    measure_machine(machine, sizeof machine);
    chart_kernels(&kernels, r);
    chart_quality(&quality, r);
    chart_floor(&floor, r);
    const plot plots[] = {
        finish_chart(&kernels, "A picture, by instruction set and threads", size, time),
        finish_chart(&quality, "A picture, by tier, samples and light", "fastest kernel, one thread", time),
        finish_chart(&floor, "Solving a ray, and what cannot be spared of it", machine,
                     (plot_axis){.label = "time of a ray (ns)"})};
    results_plot(plots, sizeof plots / sizeof *plots, folder, "pictures.svg");
    close_chart(&kernels);
    close_chart(&quality);
    close_chart(&floor);
}

static void write_table(const report *r, void (*put)(FILE *, const report *, format), const char *folder,
                        const char *name) {
    FILE *file = results_create(folder, name);
    put(file, r, CSV);
    results_finish(file, folder, name);
}

void report_write(const report *r, const char *folder) {
    write_table(r, put_costs, folder, "pictures.csv");
    write_table(r, put_floors, folder, "pictures_floor.csv");
    write_charts(r, folder);
}
