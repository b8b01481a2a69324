/* verified_roots_report.c - see verified_roots.h: what is told. */
#include "verified_roots.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "chart.h"
#include "sheet.h"

static const char legend[] =
    "Boxes proved to enclose all complex roots of a polynomial, and what they cost.\n"
    "  surface    along rays of random pixels of its view in the catalogue, re-centred, the chord inside\n"
    "             its extent scaled to [-1,1]; random-N: coefficients uniform in [-1,1] x [-1,1] i.\n"
    "             Coefficients count as exact.\n"
    "  solver     robust: algsurf_complex_solver_run; paper: algsurf_paper_zeros\n"
    "  start      cold: its own (robust), 0 + i (paper); near: the roots of the ray a pixel to the left\n"
    "  complete%  polynomials with all roots in verified boxes that are disjoint\n"
    "  simple%    roots verified to be simple and alone in their box, each counted once\n"
    "  ulps50%    width of verified boxes, median: real or imaginary part, whichever is wider, in units\n"
    "             in the last place of that part of the value (of the other part if the box straddles\n"
    "             an axis; a part that is exact counts 0)\n"
    "  ulps99%    the width that 99 of 100 boxes do not exceed\n"
    "  us50%      CPU time for all roots of a polynomial, microseconds, median\n";

static const char more_legend[] =
    "  degree-N   as random-N; near: the roots of one whose coefficients differ by up to a thousandth\n"
    "  cluster-K-GAP  degree 12, roots in the unit disc, K of them on a circle, GAP from one to the next;\n"
    "             the coefficients are rounded, which spreads K roots to about (1e-16)^(1/K); GAP 0: one\n"
    "             root K times, exactly\n";

static const sheet_column columns[] = {
    {"surface", -15, NULL},    {"degree", 6, NULL},  {"", 0, "cluster"},   {"", 0, "gap"},
    {"polynomials", 11, NULL}, {"solver", -6, NULL}, {"start", -5, NULL},  {"complete%", 9, NULL},
    {"simple%", 8, NULL},      {"ulps50%", 9, NULL}, {"ulps99%", 9, NULL}, {"", 0, "widest50%"},
    {"us50%", 9, NULL}};

static void add_row(sheet *s, const row *r) {
    char cluster[40] = "\t";
    if (r->cluster > 0) snprintf(cluster, sizeof cluster, "%d\t%g", r->cluster, r->gap);
    sheet_add(s, "%s\t%d\t%s\t%zu\t%s\t%s\t%.2f\t%.2f\t%.3g\t%.3g\t%.4g\t%.2f", r->family, r->degree, cluster,
              r->polynomials, r->solver, r->start, r->complete, r->simple, r->ulps50, r->ulps99, r->widest,
              r->us);
}

/* ---- charts ---- */

typedef struct told {
    const row *rows;
    int count;
} told;

typedef double figure(const row *r);
static double us(const row *r) { return r->us; }
static double ulps50(const row *r) { return r->ulps50; }
static double ulps99(const row *r) { return r->ulps99; }
static double widest(const row *r) { return r->widest; }
static double complete(const row *r) { return r->complete; }

static int is_by(const row *r, const char *solver, const char *start) {
    return strcmp(r->solver, solver) == 0 && strcmp(r->start, start) == 0;
}

static void draw_degrees(chart *c, const char *name, told t, const char *solver, const char *start,
                         figure *of) {
    chart_series(c, name, PLOT_BOTH);
    for (const row *r = t.rows; r < t.rows + t.count; r++)
        if (strncmp(r->family, "degree-", 7) == 0 && is_by(r, solver, start))
            chart_point(c, r->degree, of(r));
}

static void write_degrees(told t, const char *folder) {
    const plot_axis x = {.label = "degree", .scale = PLOT_LOG, .lo = 3.5, .hi = 72};
    chart charts[2] = {
        {.plot =
             {.title = "All complex roots, verified: time against degree",
              .subtitle =
                  "Random complex coefficients; near start: from the roots of a polynomial whose "
                  "coefficients differ by up to a thousandth, as a neighbouring ray's (spatial coherence).",
              .x = x,
              .y = {.label = "time for all roots, microseconds, median", .scale = PLOT_LOG}}},
        {.plot = {.title = "Width of the verified boxes against degree",
                  .subtitle = "Real or imaginary part, whichever is wider; cold start.",
                  .x = x,
                  .y = {.label = "width, units in the last place", .scale = PLOT_LOG, .lo = 0.5, .hi = 20}}}};
    draw_degrees(&charts[0], "this library, cold start", t, "robust", "cold", us);
    draw_degrees(&charts[0], "this library, near start", t, "robust", "near", us);
    draw_degrees(&charts[0], "Sanjuan-Estrada et al., cold start", t, "paper", "cold", us);
    draw_degrees(&charts[0], "Sanjuan-Estrada et al., near start", t, "paper", "near", us);
    draw_degrees(&charts[1], "this library, median", t, "robust", "cold", ulps50);
    draw_degrees(&charts[1], "this library, 99 %", t, "robust", "cold", ulps99);
    draw_degrees(&charts[1], "Sanjuan-Estrada et al., median", t, "paper", "cold", ulps50);
    draw_degrees(&charts[1], "Sanjuan-Estrada et al., 99 %", t, "paper", "cold", ulps99);
    chart_write(charts, 2, folder, "verified_roots_degree.svg");
}

/* A series for each size of gaps. */
static void draw_clusters(chart *c, const char *name, told t, const char *solver, figure *of) {
    static const double gaps[] = {1e-3, 1e-6, 1e-9, 0};
    static const char *const texts[] = {"1e-3", "1e-6", "1e-9", "0"};
    for (int i = 0; i < 4; i++) {
        char series[64];
        snprintf(series, sizeof series, "%s, gap %s", name, texts[i]);
        chart_series(c, series, PLOT_BOTH);
        for (const row *r = t.rows; r < t.rows + t.count; r++)
            if (r->cluster > 0 && r->gap == gaps[i] && is_by(r, solver, "cold"))
                chart_point(c, r->cluster, of(r));
    }
}

static void write_clusters(told t, const char *folder) {
    const plot_axis x = {.label = "roots in the cluster", .lo = 1.5, .hi = 8.5};
    chart charts[3] = {
        {.plot = {.title = "All complex roots, verified: time against the size of a cluster",
                  .subtitle =
                      "Degree 12; so many of the roots are GAP apart, on a circle. Rounding of the "
                      "coefficients spreads K roots to about (1e-16)^(1/K) besides; GAP 0: a multiple "
                      "root, exactly.",
                  .x = x,
                  .y = {.label = "time for all roots, microseconds, median", .scale = PLOT_LOG}}},
        {.plot = {.title = "Polynomials of which all roots were verified",
                  .x = x,
                  .y = {.label = "share, %", .lo = -5, .hi = 105}}},
        {.plot = {.title = "Width of the widest box of a polynomial, that of the cluster",
                  .subtitle = "Real or imaginary part, whichever is wider; all roots lie in the unit disc.",
                  .x = x,
                  .y = {.label = "width, median", .scale = PLOT_LOG}}}};
    draw_clusters(&charts[0], "this library", t, "robust", us);
    draw_clusters(&charts[0], "Sanjuan-Estrada et al.", t, "paper", us);
    draw_clusters(&charts[1], "this library", t, "robust", complete);
    draw_clusters(&charts[1], "Sanjuan-Estrada et al.", t, "paper", complete);
    draw_clusters(&charts[2], "this library", t, "robust", widest);
    chart_write(charts, 3, folder, "verified_roots_cluster.svg");
}

void report(const row *rows, int count, int seed, int tsv, const char *folder) {
    const char *mark = tsv ? "# " : "", *more = rows[count - 1].cluster > 0 ? more_legend : NULL;
    const told t = {rows, count};
    sheet table = SHEET(columns);
    for (int i = 0; i < count; i++) add_row(&table, &rows[i]);
    measure_head(mark, (const char *const[]){legend, more, NULL});
    printf("%sseed: %d\n", mark, seed);
    sheet_print(&table, tsv);
    cli_finish_output();
    sheet_write(&table, folder, "verified_roots.csv");
    free(table.rows);
    if (!folder) return;
    write_degrees(t, folder);
    write_clusters(t, folder);
}
