/* resolution_report.c - what resolution measured, as a table and as charts. */
#include <stdio.h>
#include <string.h>

#include "cli.h"
#include "measure.h"
#include "resolution.h"
#include "results.h"

static const char legend[] =
    "What a ray of a picture costs, by the picture's width; one thread, one sample a pixel, shading "
    "included\n"
    "  takes    pictures timed; the states of a thousand of their pixels are those of their rays alone\n"
    "  ns/ray   wall time of algsurf_render for each ray: median; min, max: its spread\n"
    "  rows%    of the rays: not decided by tiles, but by their own polynomials, with others of their row\n"
    "  single%  of the rays: solved by themselves\n";

typedef enum format { TEXT, TSV, CSV } format;

static void put_row(FILE *to, const record *a, const measured *m, format form) {
    static const char *const forms[] = {"%-12s  %6d  %5d  %6d  %5d  %7.2f  %7.2f  %7.2f  %6.2f  %7.4f\n",
                                        "%s\t%d\t%d\t%d\t%d\t%.2f\t%.2f\t%.2f\t%.2f\t%.4f\n",
                                        "%s,%d,%d,%d,%d,%.2f,%.2f,%.2f,%.2f,%.4f\n"};
    fprintf(to, forms[form], a->entry->name, a->entry->degree, m->width, m->height, m->takes, m->ns[0],
            m->ns[1], m->ns[2], 100 * m->by_rows, 100 * m->by_singles);
}

static void put_table(FILE *to, const report *r, format form) {
    static const char *const heads[] = {
        "\nsurface       degree  width  height  takes   ns/ray      min      max   rows%  single%\n",
        "#surface\tdegree\twidth\theight\ttakes\tns/ray\tmin\tmax\trows%\tsingle%\n",
        "surface,degree,width,height,takes,ns_ray,min,max,rows_percent,single_percent\n"};
    fputs(heads[form], to);
    for (const record *a = r->records; a < r->records + r->surfaces; a++)
        for (int i = 0; i < r->widths; i++) put_row(to, a, &a->at[i], form);
}

void report_print(const report *r, int tsv) {
    const char *mark = tsv ? "# " : "";
    measure_print_lines(legend, mark);
    measure_print_machine(mark);
    printf("%skernel: %s\n", mark, algsurf_kernel_name(0));
    put_table(stdout, r, tsv ? TSV : TEXT);
    cli_finish_output();
}

/* ---- the files ---- */

enum { CHARTS = 2 };

static void write_charts(const report *r, const char *folder) {
    static char names[MOST_WIDTHS][16];
    static double x[MOST_WIDTHS], y[CHARTS][MOST_SHOWN][MOST_WIDTHS];
    const char *name[MOST_WIDTHS + 1] = {NULL};
    plot_series series[CHARTS][MOST_SHOWN];
    char machine[512];
    for (int i = 0; i < r->widths; i++) {
        snprintf(names[i], sizeof names[i], "%d", r->records->at[i].width);
        name[i] = names[i];
        x[i] = i;
        for (int s = 0; s < r->surfaces; s++) {
            const measured *m = &r->records[s].at[i];
            y[0][s][i] = m->ns[0];
            y[1][s][i] = 100 * (m->by_rows + m->by_singles);
        }
    }
    for (int c = 0; c < CHARTS; c++)
        for (int s = 0; s < r->surfaces; s++)
            series[c][s] = (plot_series){r->records[s].entry->name, PLOT_BOTH, x, y[c][s], (size_t)r->widths};
    measure_machine(machine, sizeof machine);
    const plot_axis across = {.label = "width of the picture (pixels)", .names = name};
    const plot plots[CHARTS] = {{.title = "What a ray costs, by resolution",
                                 .subtitle = machine,
                                 .x = across,
                                 .y = {.label = "time of a ray (ns)", .scale = PLOT_LOG},
                                 .series = series[0],
                                 .count = (size_t)r->surfaces},
                                {.title = "Rays that no tile decides",
                                 .subtitle = "100 %: the picture is drawn without tiles, row by row",
                                 .x = across,
                                 .y = {.label = "% of the rays", .scale = PLOT_LOG},
                                 .series = series[1],
                                 .count = (size_t)r->surfaces}};
    results_plot(plots, CHARTS, folder, "resolution.svg");
}

void report_write(const report *r, const char *folder) {
    FILE *file = results_create(folder, "resolution.csv");
    put_table(file, r, CSV);
    results_finish(file, folder, "resolution.csv");
    write_charts(r, folder);
}
