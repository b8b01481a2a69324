/* pictures_report.c - see pictures.h: what is told. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "chart.h"
#include "pictures.h"
#include "sheet.h"

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

static double median(const result *r, int way, int part) { return measure_taken(&r->takes[way][part], 0.5); }

static double ns_per_ray(const result *r, int way, int part) {
    return 1e9 * median(r, way, part) / (double)r->rays;
}

/* ---- the tables ---- */

static const sheet_column cost_columns[] = {
    {"surface", -12, NULL}, {"degree", 6, NULL},  {"rays", 7, NULL},    {"hits", 7, NULL},
    {"manner", -9, NULL},   {"threads", 7, NULL}, {"ms50%", 8, NULL},   {"min", 8, NULL},
    {"max", 8, NULL},       {"ns/ray", 7, NULL},  {"per_s", 7, NULL},   {"expand%", 7, NULL},
    {"solve%", 6, NULL},    {"point%", 6, NULL},  {"shadow%", 7, NULL}, {"shade%", 6, NULL},
    {"times", 6, NULL}};
static const sheet_column floor_columns[] = {{"surface", -12, NULL}, {"degree", 6, NULL},
                                             {"kernel", -8, NULL},   {"solve", 8, NULL},
                                             {"floor", 8, NULL},     {"ratio", 6, NULL}};

static void add_cost(sheet *s, const result *r, const char *name, int way) {
    const measure_takes *all = &r->takes[way][PART_ALL];
    double seconds = median(r, way, PART_ALL), percent[PARTS];
    for (int part = 0; part < PARTS; part++)
        percent[part] = 100 * median(r, way, part) / (seconds * r->threads[way]);
    sheet_add(s, "%s\t%d\t%zu\t%zu\t%s\t%d\t%.3f\t%.3f\t%.3f\t%.1f\t%.2f\t%.1f\t%.1f\t%.1f\t%.1f\t%.1f\t%.2f",
              r->entry->name, r->entry->degree, r->rays, r->hits, name, r->threads[way], 1e3 * seconds,
              1e3 * measure_taken(all, 0), 1e3 * measure_taken(all, 1), ns_per_ray(r, way, PART_ALL),
              1 / seconds, percent[PART_EXPAND], percent[PART_SOLVE], percent[PART_POINT],
              percent[PART_SHADOW], percent[PART_SHADE], seconds / median(r, 0, PART_ALL));
}

/* ---- the charts ---- */

static void add_bars(chart *c, const report *r, const char *way, const char *label) {
    for (int i = 0; i < r->plan->count; i++) {
        if (r->plan->manner[i].lifted || strcmp(r->plan->manner[i].name, way) != 0) continue;
        chart_series(c, label, PLOT_BARS);
        for (const result *a = r->results; a < r->results + r->surfaces; a++)
            chart_bar(c, a->entry->name, 1e3 * median(a, i, PART_ALL));
    }
}

static void add_floor(chart *c, const report *r, int way, const char *label) {
    chart_series(c, label, PLOT_BARS);
    for (const result *a = r->results; a < r->results + r->surfaces; a++)
        chart_bar(c, a->entry->name, ns_per_ray(a, way, PART_SOLVE));
}

static void write_charts(const report *r, const char *folder) {
    static const plot_axis time = {.label = "time of a picture (ms)", .scale = PLOT_LOG};
    char size[64], machine[512];
    chart charts[] = {{.plot = {"A picture, by instruction set and threads", size, .y = time, .width = 960}},
                      {.plot = {"A picture, by tier, samples and light", "fastest kernel, one thread",
                                .y = time, .width = 960}},
                      {.plot = {"Solving a ray, and what cannot be spared of it", machine,
                                .y = {.label = "time of a ray (ns)"}, .width = 960}}};
    snprintf(size, sizeof size, "%dx%d, certified tier, one thread unless named", r->width, r->height);
    measure_machine(machine, sizeof machine);
    const manner *kernels = r->plan->manner;
    for (int i = 0; i < r->plan->kernels && i < CHART_MOST_SERIES - 2; i++)
        add_bars(&charts[0], r, kernels[i].name, kernels[i].name);
    add_bars(&charts[0], r, "all", "all threads");
    add_bars(&charts[0], r, "single", "ray by ray");
    add_bars(&charts[1], r, kernels[0].name, "certified tier");
    add_bars(&charts[1], r, "bounded", "bounded tier");
    add_bars(&charts[1], r, "antialias", "3x3 samples");
    add_bars(&charts[1], r, "adaptive", "3x3 on edges");
    add_bars(&charts[1], r, "full", "area lights and shadows");
    add_floor(&charts[2], r, 0, "solving");
    add_floor(&charts[2], r, r->plan->kernels, "its floor");
    chart_write(charts, sizeof charts / sizeof *charts, folder, "pictures.svg");
}

void report_all(const report *r, int tsv, const char *folder) {
    const char *mark = tsv ? "# " : "";
    const plan *p = r->plan;
    sheet costs = SHEET(cost_columns), floors = SHEET(floor_columns);
    for (const result *a = r->results; a < r->results + r->surfaces; a++) {
        for (int i = 0; i < p->count; i++)
            if (!p->manner[i].lifted) add_cost(&costs, a, p->manner[i].name, i);
        for (int i = 0; i < p->kernels; i++) {
            double solve = ns_per_ray(a, i, PART_SOLVE), least = ns_per_ray(a, p->kernels + i, PART_SOLVE);
            sheet_add(&floors, "%s\t%d\t%s\t%.1f\t%.1f\t%.2f", a->entry->name, a->entry->degree,
                      p->manner[i].name, solve, least, solve / least);
        }
    }
    measure_head(mark, (const char *const[]){legend, NULL});
    printf("%ssize: %dx%d\n%srepeat: %d\n", mark, r->width, r->height, mark, r->repeat);
    sheet_print(&costs, tsv);
    sheet_print(&floors, tsv);
    cli_finish_output();
    sheet_write(&costs, folder, "pictures.csv");
    sheet_write(&floors, folder, "pictures_floor.csv");
    write_charts(r, folder);
    free(costs.rows);
    free(floors.rows);
}
