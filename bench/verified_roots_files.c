/* verified_roots_files.c - see verified_roots_report.h: what is written. */
#include <math.h>
#include <string.h>

#include "results.h"
#include "verified_roots_report.h"

static void put_number(FILE *file, double x) {
    if (!isnan(x)) fprintf(file, "%.4g", x);
    fputc(',', file);
}

static void write_csv(const row *rows, int count, const char *folder) {
    FILE *file = results_create(folder, "verified_roots.csv");
    fprintf(file, "surface,degree,cluster,gap,polynomials,solver,start,complete%%,simple%%,ulps50%%,ulps99%%,"
                  "widest50%%,us50%%\n");
    for (const row *r = rows; r < rows + count; r++) {
        fprintf(file, "%s,%d,", r->family, r->degree);
        if (r->cluster > 0)
            fprintf(file, "%d,%g,", r->cluster, r->gap);
        else
            fprintf(file, ",,");
        fprintf(file, "%zu,%s,%s,%.2f,%.2f,", r->polynomials, r->solver, r->start, r->complete, r->simple);
        put_number(file, r->ulps50);
        put_number(file, r->ulps99);
        fprintf(file, "%.4g,%.4g\n", r->widest, r->us);
    }
    results_finish(file, folder, "verified_roots.csv");
}

/* ---- charts ---- */

enum { MAX_SERIES = 8, MAX_POINTS = 64 };

typedef enum figure { TIME, ULPS50, ULPS99, WIDEST, COMPLETE } figure;

static double figure_of(const row *r, figure what) {
    switch (what) {
    case TIME:
        return r->us;
    case ULPS50:
        return r->ulps50;
    case ULPS99:
        return r->ulps99;
    case WIDEST:
        return r->widest;
    case COMPLETE:
        break;
    }
    return r->complete;
}

/* A chart in the making. */
typedef struct chart {
    double x[MAX_SERIES][MAX_POINTS], y[MAX_SERIES][MAX_POINTS];
    plot_series series[MAX_SERIES];
    size_t count;
} chart;

/* A series of one solver and start: over degrees, or for a gap >= 0 over sizes of clusters. */
static void add_series(chart *c, const char *name, const row *rows, int count, const char *solver,
                       const char *start, double gap, figure what) {
    plot_series *s = &c->series[c->count];
    *s = (plot_series){name, PLOT_BOTH, c->x[c->count], c->y[c->count], 0};
    for (const row *r = rows; r < rows + count; r++) {
        int wanted = gap < 0 ? strncmp(r->family, "degree-", 7) == 0 : r->cluster > 0 && r->gap == gap;
        if (!wanted || strcmp(r->solver, solver) != 0 || strcmp(r->start, start) != 0) continue;
        c->x[c->count][s->count] = gap < 0 ? r->degree : r->cluster;
        c->y[c->count][s->count++] = figure_of(r, what);
    }
    c->count++;
}

static plot plot_of(const chart *c, const char *title, const char *subtitle, plot_axis x, plot_axis y) {
    return (plot){
        .title = title, .subtitle = subtitle, .x = x, .y = y, .series = c->series, .count = c->count};
}

static void write_degrees(const row *rows, int count, const char *folder) {
    const plot_axis x = {.label = "degree", .scale = PLOT_LOG, .lo = 3.5, .hi = 72};
    chart time = {.count = 0}, width = {.count = 0};
    add_series(&time, "this library, cold start", rows, count, "robust", "cold", -1, TIME);
    add_series(&time, "this library, near start", rows, count, "robust", "near", -1, TIME);
    add_series(&time, "Sanjuan-Estrada et al., cold start", rows, count, "paper", "cold", -1, TIME);
    add_series(&time, "Sanjuan-Estrada et al., near start", rows, count, "paper", "near", -1, TIME);
    add_series(&width, "this library, median", rows, count, "robust", "cold", -1, ULPS50);
    add_series(&width, "this library, 99 %", rows, count, "robust", "cold", -1, ULPS99);
    add_series(&width, "Sanjuan-Estrada et al., median", rows, count, "paper", "cold", -1, ULPS50);
    add_series(&width, "Sanjuan-Estrada et al., 99 %", rows, count, "paper", "cold", -1, ULPS99);
    const plot plots[] = {
        plot_of(&time, "All complex roots, verified: time against degree",
                "Random complex coefficients; near start: from the roots of a polynomial whose coefficients "
                "differ by up to a thousandth, as a neighbouring ray's (spatial coherence).",
                x, (plot_axis){.label = "time for all roots, microseconds, median", .scale = PLOT_LOG}),
        plot_of(
            &width, "Width of the verified boxes against degree",
            "Real or imaginary part, whichever is wider; cold start.", x,
            (plot_axis){.label = "width, units in the last place", .scale = PLOT_LOG, .lo = 0.5, .hi = 20})};
    results_plot(plots, sizeof plots / sizeof *plots, folder, "verified_roots_degree.svg");
}

static void write_clusters(const row *rows, int count, const char *folder) {
    static const double gaps[] = {1e-3, 1e-6, 1e-9, 0};
    static const char *const robust[] = {"this library, gap 1e-3", "this library, gap 1e-6",
                                         "this library, gap 1e-9", "this library, gap 0"},
                             *const paper[] = {
                                 "Sanjuan-Estrada et al., gap 1e-3", "Sanjuan-Estrada et al., gap 1e-6",
                                 "Sanjuan-Estrada et al., gap 1e-9", "Sanjuan-Estrada et al., gap 0"};
    const plot_axis x = {.label = "roots in the cluster", .lo = 1.5, .hi = 8.5};
    chart time = {.count = 0}, complete = {.count = 0}, width = {.count = 0};
    for (int i = 0; i < 4; i++) {
        add_series(&time, robust[i], rows, count, "robust", "cold", gaps[i], TIME);
        add_series(&complete, robust[i], rows, count, "robust", "cold", gaps[i], COMPLETE);
        add_series(&width, robust[i], rows, count, "robust", "cold", gaps[i], WIDEST);
    }
    for (int i = 0; i < 4; i++) {
        add_series(&time, paper[i], rows, count, "paper", "cold", gaps[i], TIME);
        add_series(&complete, paper[i], rows, count, "paper", "cold", gaps[i], COMPLETE);
    }
    const plot plots[] = {
        plot_of(&time, "All complex roots, verified: time against the size of a cluster",
                "Degree 12; so many of the roots are GAP apart, on a circle. Rounding of the coefficients "
                "spreads K roots to about (1e-16)^(1/K) besides; GAP 0: a multiple root, exactly.",
                x, (plot_axis){.label = "time for all roots, microseconds, median", .scale = PLOT_LOG}),
        plot_of(&complete, "Polynomials of which all roots were verified", NULL, x,
                (plot_axis){.label = "share, %", .lo = -5, .hi = 105}),
        plot_of(&width, "Width of the widest box of a polynomial, that of the cluster",
                "Real or imaginary part, whichever is wider; all roots lie in the unit disc.", x,
                (plot_axis){.label = "width, median", .scale = PLOT_LOG})};
    results_plot(plots, sizeof plots / sizeof *plots, folder, "verified_roots_cluster.svg");
}

void report_files(const row *rows, int count, const char *folder) {
    write_csv(rows, count, folder);
    write_degrees(rows, count, folder);
    write_clusters(rows, count, folder);
}
