/* accuracy_report.c - see accuracy.h: what is told of rays. */
#include "accuracy.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "chart.h"
#include "must.h"
#include "sheet.h"

const double accuracy_tolerances[TOLERANCES] = {1e-1, 1e-2,  1e-3,  1e-4,  1e-5,  1e-6,  1e-7,  1e-8,
                                                1e-9, 1e-10, 1e-11, 1e-12, 1e-13, 1e-14, 1e-15, 0};

enum { SHOWN = 4, CELL = 16, ALL_DIGITS = TOLERANCES - 1, COARSE = 2 };

/* The tolerances that the table shows: 1e-3, 1e-6, 1e-12, 0. */
static const int shown[SHOWN] = {COARSE, 5, 11, ALL_DIGITS};

static double line_ns(const line *l, int tolerance, double share) {
    return 1e9 * measure_taken(&l->takes[tolerance], share);
}

static const line *record_line(const record *r, way w, int method, int tier) {
    const line *l = r->line;
    while (l->setting.way != w || l->setting.method != method || l->setting.tier != tier) l++;
    return l;
}

/* ---- the table ---- */

static const char *tolerance_text(char text[CELL], double tolerance) {
    snprintf(text, CELL, tolerance > 0 ? "1e%.0f" : "0", tolerance > 0 ? log10(tolerance) : 0.0);
    return text;
}

static void print_titles(void) {
    char text[CELL];
    printf("%-8s%-13s%-9s", "", "", "");
    printf("  %-*s  %-*s  %-9s\n", 8 * SHOWN - 1, " ns a ray, at tolerance", 9 * SHOWN - 1,
           "99.9 % error of t, at tolerance", " largest");
    printf("%-8s%-13s%-9s ", "way", "method", "tier");
    for (int i = 0; i < SHOWN; i++) printf("%8s", tolerance_text(text, accuracy_tolerances[shown[i]]));
    printf(" ");
    for (int i = 0; i < SHOWN; i++) printf("%9s", tolerance_text(text, accuracy_tolerances[shown[i]]));
    printf("%10s%7s%7s%10s%9s\n", "at 0", "spread", "wrong", "undecided", "settled");
}

/* The most of all tolerances. */
static size_t most_wrong(const line *l) {
    size_t most = 0;
    for (int k = 0; k < TOLERANCES; k++) most = l->verdict[k].wrong > most ? l->verdict[k].wrong : most;
    return most;
}

/* Longest less shortest time over the median, median of all tolerances. */
static double spread(const line *l) {
    double each[TOLERANCES];
    for (int k = 0; k < TOLERANCES; k++) each[k] = (line_ns(l, k, 1) - line_ns(l, k, 0)) / line_ns(l, k, 0.5);
    return measure_quantile(each, TOLERANCES, 0.5);
}

static void print_line(const line *l) {
    char text[CELL];
    printf("%-8s%-13s%-9s ", way_names[l->setting.way], method_names[l->setting.method],
           tier_names[l->setting.tier]);
    for (int i = 0; i < SHOWN; i++) printf("%8.1f", line_ns(l, shown[i], 0.5));
    printf(" ");
    for (int i = 0; i < SHOWN; i++) printf("%9.1e", l->verdict[shown[i]].usual);
    printf("%10.1e%6.0f%%%7zu", l->verdict[ALL_DIGITS].largest, 100 * spread(l), most_wrong(l));
    printf("%10zu%9s\n", l->verdict[ALL_DIGITS].undecided,
           l->settled < 0 ? "-" : tolerance_text(text, accuracy_tolerances[l->settled]));
}

void report_table(const record *r) {
    printf("\n%s, degree %d: %zu rays, %zu hit, %zu undecided; the reference is known to %.0e\n",
           r->entry->name, r->entry->degree, r->rays, r->hits, r->open, r->worst);
    print_titles();
    for (const line *l = r->line; l < r->line + LINES; l++) print_line(l);
}

/* ---- advice ---- */

enum { DEFAULT = ALGSURF_METHOD_DEFAULT, CERTIFIED = ALGSURF_TIER_CERTIFIED, BOUNDED = ALGSURF_TIER_BOUNDED };

typedef struct choice {
    way way;
    int method, tier, tolerance;
} choice;

/* Time of one choice in units of another's. */
static const struct {
    const char *text;
    choice of, unit;
} ratios[] = {{"single call, all digits instead of 1e-3",
               {WAY_SINGLE, DEFAULT, CERTIFIED, ALL_DIGITS},
               {WAY_SINGLE, DEFAULT, CERTIFIED, COARSE}},
              {"picture, all digits instead of 1e-3",
               {WAY_PICTURE, DEFAULT, CERTIFIED, ALL_DIGITS},
               {WAY_PICTURE, DEFAULT, CERTIFIED, COARSE}},
              {"single call instead of a packet",
               {WAY_SINGLE, DEFAULT, CERTIFIED, ALL_DIGITS},
               {WAY_PACKET, DEFAULT, CERTIFIED, ALL_DIGITS}},
              {"single call instead of a picture",
               {WAY_SINGLE, DEFAULT, CERTIFIED, ALL_DIGITS},
               {WAY_PICTURE, DEFAULT, CERTIFIED, ALL_DIGITS}},
              {"single call, certified instead of bounded",
               {WAY_SINGLE, DEFAULT, CERTIFIED, ALL_DIGITS},
               {WAY_SINGLE, DEFAULT, BOUNDED, ALL_DIGITS}},
              {"picture, certified instead of bounded",
               {WAY_PICTURE, DEFAULT, CERTIFIED, ALL_DIGITS},
               {WAY_PICTURE, DEFAULT, BOUNDED, ALL_DIGITS}},
              {"single call, Brent instead of default",
               {WAY_SINGLE, ALGSURF_METHOD_BRENT, CERTIFIED, ALL_DIGITS},
               {WAY_SINGLE, DEFAULT, CERTIFIED, ALL_DIGITS}},
              {"single call, bisection instead of default",
               {WAY_SINGLE, ALGSURF_METHOD_BISECTION, CERTIFIED, ALL_DIGITS},
               {WAY_SINGLE, DEFAULT, CERTIFIED, ALL_DIGITS}},
              {"single call, regula falsi instead of default",
               {WAY_SINGLE, ALGSURF_METHOD_REGULA_FALSI, CERTIFIED, ALL_DIGITS},
               {WAY_SINGLE, DEFAULT, CERTIFIED, ALL_DIGITS}}};

static double ns_of(const record *r, const choice *c) {
    return line_ns(record_line(r, c->way, c->method, c->tier), c->tolerance, 0.5);
}

void report_advice(const record *records, int count) {
    size_t rays = 0, undecided = 0, wrong = 0;
    /* By method: the largest index of a tolerance from which on pictures do not change, and that in words. */
    int settled[3] = {0};
    char at[3][CELL];
    printf("\nWhat a choice costs, as a ratio of times, over the surfaces above:\n");
    for (size_t i = 0; i < sizeof ratios / sizeof *ratios; i++) {
        double least = INFINITY, most = 0;
        for (const record *r = records; r < records + count; r++) {
            double times = ns_of(r, &ratios[i].of) / ns_of(r, &ratios[i].unit);
            least = fmin(least, times);
            most = fmax(most, times);
        }
        printf("    %-66s %5.2f .. %.2f\n", ratios[i].text, least, most);
    }
    for (const record *r = records; r < records + count; r++) {
        rays += r->rays;
        undecided += record_line(r, WAY_SINGLE, DEFAULT, BOUNDED)->verdict[ALL_DIGITS].undecided;
        for (const line *l = r->line; l < r->line + LINES; l++) {
            const int method = l->setting.method;
            for (int k = 0; k < TOLERANCES; k++) wrong += l->verdict[k].wrong;
            if (method < 3 && l->setting.tier == CERTIFIED && l->settled > settled[method])
                settled[method] = l->settled;
        }
    }
    for (int m = 0; m < 3; m++) (void)tolerance_text(at[m], accuracy_tolerances[settled[m]]);
    printf(
        "\nWhich setting to choose:\n"
        "  - Rays that come in numbers: a packet, or a picture; no tolerance or method costs or saves as\n"
        "    much as solving rays side by side.\n"
        "  - A picture: the default method, certified tier, tolerance 0.  Its bytes no longer change below\n"
        "    tolerance %s (Brent: %s, bisection: %s); what a coarser one saves is in the second ratio.\n",
        at[DEFAULT], at[ALGSURF_METHOD_BRENT], at[ALGSURF_METHOD_BISECTION]);
    printf(
        "  - Certified decides every ray; only what doubles leave open, here %zu of %zu rays, goes to\n"
        "    integers.  Bounded leaves that undecided, for hosts that need a bounded time for every ray.\n",
        undecided, rays);
    printf("  - Brent and bisection find the same roots, at the ratios above: partly the method's own (the\n"
           "    seed comparison tells which part), mostly that only the default has packet code, which a\n"
           "    single call uses, too.  Regula falsi is for comparison only: wrong %zu times, in all\n"
           "    tolerances and tiers.\n",
           wrong);
}

/* ---- numbers ---- */

static const sheet_column columns[] = {
    {"surface", 0, NULL},       {"degree", 0, NULL},    {"way", 0, NULL},       {"method", 0, NULL},
    {"tier", 0, NULL},          {"tolerance", 0, NULL}, {"rays", 0, NULL},      {"hits", 0, NULL},
    {"ns_median", 0, NULL},     {"ns_min", 0, NULL},    {"ns_max", 0, NULL},    {"error_99.9", 0, NULL},
    {"error_largest", 0, NULL}, {"wrong", 0, NULL},     {"undecided", 0, NULL}, {"settled", 0, NULL}};

static void add_rows(sheet *s, const record *r, const line *l) {
    char settled[CELL] = "";
    if (l->settled >= 0) snprintf(settled, sizeof settled, "%g", accuracy_tolerances[l->settled]);
    for (int k = 0; k < TOLERANCES; k++) {
        const verdict *v = &l->verdict[k];
        sheet_add(s, "%s\t%d\t%s\t%s\t%s\t%g\t%zu\t%zu\t%.4g\t%.4g\t%.4g\t%.4g\t%.4g\t%zu\t%zu\t%s",
                  r->entry->name, r->entry->degree, way_names[l->setting.way],
                  method_names[l->setting.method], tier_names[l->setting.tier], accuracy_tolerances[k],
                  r->rays, r->hits, line_ns(l, k, 0.5), line_ns(l, k, 0), line_ns(l, k, 1), v->usual,
                  v->largest, v->wrong, v->undecided, settled);
    }
}

/* ---- charts ---- */

enum { MARKED = METHODS + 2 }; /* series: methods one by one, packets, pictures */

/* The error of t is shown from half a unit in the last place of 1 to all of a surface. */
static const double LEAST_ERROR = 1e-16, MOST_ERROR = 1;

typedef struct point {
    double error, ns;
} point;

static int by_error(const void *left, const void *right) {
    const point *a = left, *b = right;
    return a->error != b->error ? (a->error > b->error) - (a->error < b->error)
                                : (a->ns > b->ns) - (a->ns < b->ns);
}

/* The settings of the tier without a wrong answer, of which no other is both faster and closer: a staircase
 * that ends at the largest error shown. */
static void draw_front(chart *c, const record *r, int tier, way last, const char *name) {
    point all[MARKED * TOLERANCES];
    size_t count = 0;
    double least = INFINITY;
    for (const line *l = r->line; l < r->line + LINES; l++)
        for (int k = 0; k < TOLERANCES; k++)
            if (l->setting.tier == tier && l->setting.way <= last && l->verdict[k].wrong == 0)
                all[count++] = (point){l->verdict[k].usual, line_ns(l, k, 0.5)};
    qsort(all, count, sizeof *all, by_error);
    chart_series(c, name, PLOT_STEPS);
    for (size_t i = 0; i < count; i++) {
        if (all[i].ns >= least) continue;
        least = all[i].ns;
        chart_point(c, all[i].error, least);
    }
    chart_point(c, MOST_ERROR, count > 0 ? least : NAN);
}

static void draw_tier(chart *c, const record *r, int tier) {
    static const char *const names[MARKED] = {"single, default",      "single, Brent",   "single, bisection",
                                              "single, regula falsi", "packet, default", "picture, default"};
    int n = 0;
    c->plot.x = (plot_axis){.label = "error of t that 99.9 % of the hits do not exceed, in units of space",
                            .scale = PLOT_LOG,
                            .lo = LEAST_ERROR,
                            .hi = MOST_ERROR};
    snprintf(c->title, sizeof c->title, "Speed against accuracy: %s (degree %d), %s tier", r->entry->name,
             r->entry->degree, tier_names[tier]);
    for (const line *l = r->line; l < r->line + LINES; l++) {
        if (l->setting.tier != tier) continue;
        chart_series(c, names[n++], PLOT_POINTS);
        for (int k = 0; k < TOLERANCES; k++) chart_point(c, l->verdict[k].usual, line_ns(l, k, 0.5));
    }
    chart_margins(c, 0, 1.2);
    draw_front(c, r, tier, WAY_SINGLE, "front of single calls");
    draw_front(c, r, tier, WAY_PICTURE, "front of all");
}

static void write_charts(const record *r, const char *folder) {
    chart charts[TIERS] = {
        {.plot = {.subtitle =
                      "Each mark is one tolerance, from 1e-1 on the right to 1e-15 and 0 on the left.  A "
                      "front joins the settings without a wrong answer that no other beats in both."}}};
    char name[64];
    charts[0].plot.y = (plot_axis){.label = "time a ray, ns", .scale = PLOT_LOG};
    draw_tier(&charts[0], r, BOUNDED);
    charts[1].plot.y = charts[0].plot.y;
    draw_tier(&charts[1], r, CERTIFIED);
    charts[0].plot.y = charts[1].plot.y; /* with the times of both */
    snprintf(name, sizeof name, "accuracy_%s.svg", r->entry->name);
    chart_write(charts, TIERS, folder, name);
}

void report_files(const record *records, int count, const char *folder) {
    sheet table = SHEET(columns);
    for (const record *r = records; r < records + count; r++) {
        for (const line *l = r->line; l < r->line + LINES; l++) add_rows(&table, r, l);
        write_charts(r, folder);
    }
    sheet_write(&table, folder, "accuracy.csv");
    free(table.rows);
}
