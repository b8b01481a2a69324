/* accuracy_files.c - see accuracy_report.h: what is written. */
#include <math.h>
#include <stdlib.h>

#include "accuracy_report.h"
#include "cli.h"
#include "must.h"
#include "results.h"

/* ---- numbers ---- */

static void write_line(FILE *file, const record *r, const line *l) {
    for (int k = 0; k < TOLERANCES; k++) {
        const verdict *v = &l->verdict[k];
        fprintf(file, "%s,%d,%s,%s,%s,%g,%zu,%zu,", r->entry->name, r->entry->degree,
                way_name(l->setting.way), method_name(l->setting.method), tier_name(l->setting.tier),
                accuracy_tolerances[k], r->rays, r->hits);
        fprintf(file, "%.4g,%.4g,%.4g,%.4g,%.4g,%zu,%zu,", line_ns(l, k, 0.5), line_ns(l, k, 0),
                line_ns(l, k, 1), v->usual, v->largest, v->wrong, v->undecided);
        if (l->settled >= 0) fprintf(file, "%g", accuracy_tolerances[l->settled]);
        fputc('\n', file);
    }
}

static void write_csv(const record *records, int count, const char *folder) {
    FILE *file = results_create(folder, "accuracy.csv");
    fprintf(file, "surface,degree,way,method,tier,tolerance,rays,hits,ns_median,ns_min,ns_max,error_99.9,"
                  "error_largest,wrong,undecided,settled\n");
    for (const record *r = records; r < records + count; r++)
        for (const line *l = r->line; l < r->line + LINES; l++) write_line(file, r, l);
    results_finish(file, folder, "accuracy.csv");
}

/* ---- charts ---- */

/* Methods one by one, packets, pictures; then the fronts of single calls and of all. */
enum { MARKED = METHODS + 2, SERIES = MARKED + 2, POINTS = MARKED * TOLERANCES, TEXT = 256 };

/* The error of t is shown from half a unit in the last place of 1 to all of a surface. */
static const double LEAST_ERROR = 1e-16, MOST_ERROR = 1;

typedef struct point {
    double error, ns;
} point;

/* One tier's. */
typedef struct panel {
    char title[TEXT];
    double x[SERIES][POINTS + 1], y[SERIES][POINTS + 1];
    plot_series series[SERIES];
} panel;

static const char *const series_name[SERIES] = {
    "single, default", "single, Brent",    "single, bisection",     "single, regula falsi",
    "packet, default", "picture, default", "front of single calls", "front of all"};

static int by_error(const void *left, const void *right) {
    const point *a = left, *b = right;
    return a->error != b->error ? (a->error > b->error) - (a->error < b->error)
                                : (a->ns > b->ns) - (a->ns < b->ns);
}

/* The settings of the tier without a wrong answer, of which no other is both faster and closer: a staircase
 * that ends at the largest error shown. */
static plot_series front_of(const record *r, int tier, way last, const char *name, double *x, double *y) {
    point all[POINTS];
    size_t count = 0, kept = 0;
    for (const line *l = r->line; l < r->line + LINES; l++)
        for (int k = 0; k < TOLERANCES; k++)
            if (l->setting.tier == tier && l->setting.way <= last && l->verdict[k].wrong == 0)
                all[count++] = (point){l->verdict[k].usual, line_ns(l, k, 0.5)};
    qsort(all, count, sizeof *all, by_error);
    for (size_t i = 0; i < count; i++) {
        if (kept > 0 && all[i].ns >= y[kept - 1]) continue;
        x[kept] = all[i].error;
        y[kept++] = all[i].ns;
    }
    x[kept] = MOST_ERROR;
    y[kept] = kept > 0 ? y[kept - 1] : NAN;
    return (plot_series){name, PLOT_STEPS, x, y, kept + 1};
}

static void fill_panel(panel *p, const record *r, int tier) {
    int n = 0;
    for (const line *l = r->line; l < r->line + LINES; l++) {
        if (l->setting.tier != tier) continue;
        for (int k = 0; k < TOLERANCES; k++) {
            p->x[n][k] = l->verdict[k].usual;
            p->y[n][k] = line_ns(l, k, 0.5);
        }
        p->series[n] = (plot_series){series_name[n], PLOT_POINTS, p->x[n], p->y[n], TOLERANCES};
        n++;
    }
    p->series[n] = front_of(r, tier, WAY_SINGLE, series_name[n], p->x[n], p->y[n]);
    n++;
    p->series[n] = front_of(r, tier, WAY_PICTURE, series_name[n], p->x[n], p->y[n]);
}

/* The least and the largest time of all tiers, with some room. */
static plot_axis time_axis(const record *r) {
    plot_axis axis = {.label = "time a ray, ns", .scale = PLOT_LOG, .lo = INFINITY};
    for (const line *l = r->line; l < r->line + LINES; l++)
        for (int k = 0; k < TOLERANCES; k++) {
            axis.lo = fmin(axis.lo, line_ns(l, k, 0.5) / 1.2);
            axis.hi = fmax(axis.hi, line_ns(l, k, 0.5) * 1.2);
        }
    return axis;
}

static void write_charts(const record *r, const char *folder) {
    static const char about[] =
        "Each mark is one tolerance, from 1e-1 on the right to 1e-15 and 0 on the left.  A front joins the "
        "settings without a wrong answer that no other beats in both.";
    static const int tiers[TIERS] = {ALGSURF_TIER_BOUNDED, ALGSURF_TIER_CERTIFIED};
    char name[TEXT];
    panel *panels = must_allocate(TIERS, sizeof *panels);
    plot plots[TIERS];
    for (int i = 0; i < TIERS; i++) {
        panel *p = &panels[i];
        fill_panel(p, r, tiers[i]);
        snprintf(p->title, sizeof p->title, "Speed against accuracy: %s (degree %d), %s tier", r->entry->name,
                 r->entry->degree, tier_name(tiers[i]));
        plots[i] =
            (plot){.title = p->title,
                   .subtitle = i == 0 ? about : NULL,
                   .x = {.label = "error of t that 99.9 % of the hits do not exceed, in units of space",
                         .scale = PLOT_LOG,
                         .lo = LEAST_ERROR,
                         .hi = MOST_ERROR},
                   .y = time_axis(r),
                   .series = p->series,
                   .count = SERIES};
    }
    snprintf(name, sizeof name, "accuracy_%s.svg", r->entry->name);
    results_plot(plots, TIERS, folder, name);
    free(panels);
}

void report_files(const record *records, int count, const char *folder) {
    write_csv(records, count, folder);
    for (const record *r = records; r < records + count; r++) write_charts(r, folder);
}
