/* decided_report.c - see decided.h: what is told. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "chart.h"
#include "decided.h"
#include "sheet.h"

static double percent(size_t some, const finding *r) { return 100 * (double)some / (double)r->rays; }

static void add_row(sheet *s, const finding *r) {
    sheet_add(s, "%s\t%d\t%s\t%zu\t%.0f\t%zu\t%.4g\t%.4g\t%.4g\t%.3g\t%.3g\t%.3g\t%.3g\t%.0f\t%zu\t%.0f\t%zu",
              r->surface, r->degree, kind_names[r->kind], r->rays, percent(r->open, r), r->open, r->us,
              r->us_low, r->us_high, r->lanes, r->us / r->lanes, r->beside, r->ratio,
              percent(r->undecided, r), r->undecided, percent(r->wrong, r), r->wrong);
}

/* ---- charts ---- */

enum { GROUPS = 2, IN_GROUP = 5, PANELS = 2 * GROUPS + 1 };

static const struct {
    const char *what;
    kind kinds[IN_GROUP];
} groups[GROUPS] = {{"a ray that begins at a root, or with roots close together",
                     {KIND_CLEAR, KIND_END, KIND_GAP_20, KIND_GAP_60, KIND_GAP_200}},
                    {"a ray that touches, or in the surface",
                     {KIND_CLEAR, KIND_TANGENT, KIND_DOUBLE, KIND_INSIDE, KIND_BALL}}};

static int is_random(const finding *r, kind which) {
    return r->kind == which && strcmp(r->surface, "random") == 0;
}

/* Times of a group of rays, by degree; with another edition's name, that edition's in units of this one's,
 * and a guide where these are the same. */
static void draw_times(chart *c, int group, const char *other, const finding *f, size_t count) {
    const char *y = other ? "in units of this edition's time" : "microseconds a ray";
    c->plot.x.label = "degree of the surface";
    c->plot.y = (plot_axis){.label = y, .scale = PLOT_LOG};
    c->plot.height = 400;
    if (other)
        snprintf(c->title, sizeof c->title, "What it costs %.40s: %s", other, groups[group].what);
    else
        snprintf(c->title, sizeof c->title, "What it costs to decide %s", groups[group].what);
    for (int k = 0; k < IN_GROUP; k++) {
        const kind which = groups[group].kinds[k];
        chart_series(c, kind_names[which], PLOT_BOTH);
        for (const finding *r = f; r < f + count; r++)
            if (is_random(r, which)) chart_point(c, r->degree, other ? r->ratio : r->us);
    }
    if (!other) return;
    chart_series(c, NULL, PLOT_LINE);
    for (const finding *r = f; r < f + count; r++)
        if (is_random(r, KIND_CLEAR)) chart_point(c, r->degree, 1);
}

/* What another edition does not answer, by kind. */
static void draw_unanswered(chart *c, const char *other, const finding *f, size_t count) {
    snprintf(c->title, sizeof c->title, "Rays that %.40s leaves undecided, or answers wrongly", other);
    c->plot.x.label = "kind of ray";
    c->plot.y = (plot_axis){.label = "% of the rays", .lo = 0, .hi = 100};
    c->plot.height = 300;
    for (int k = 0; k < KINDS; k++) {
        finding sum = {.rays = 0};
        for (const finding *r = f; r < f + count; r++) {
            if ((int)r->kind != k) continue;
            sum.rays += r->rays;
            sum.undecided += r->undecided;
            sum.wrong += r->wrong;
        }
        chart_series(c, "undecided", PLOT_BARS);
        chart_bar(c, kind_names[k], percent(sum.undecided, &sum));
        chart_series(c, "wrong", PLOT_BARS);
        chart_bar(c, kind_names[k], percent(sum.wrong, &sum));
    }
}

void report(const finding *f, size_t count, const char *other, const char *folder) {
    const sheet_column columns[] = {{"surface", -12, NULL},
                                    {"degree", 6, NULL},
                                    {"kind", -9, NULL},
                                    {"rays", 6, NULL},
                                    {"open%", 6, ""},
                                    {"", 0, "open"},
                                    {"us50%", 9, "us_median"},
                                    {"10%", 9, "us_low"},
                                    {"90%", 9, "us_high"},
                                    {"lanes", 9, "lanes_us"},
                                    {"times", 9, NULL},
                                    {other ? "beside" : "", 9, "beside_us"},
                                    {other ? "ratio" : "", 9, "ratio"},
                                    {other ? "undec%" : "", 6, ""},
                                    {"", 0, "beside_undecided"},
                                    {other ? "wrong%" : "", 6, ""},
                                    {"", 0, "beside_wrong"}};
    sheet table = SHEET(columns);
    chart charts[PANELS] = {
        {.plot.subtitle = "dense random surfaces, certified tier, one ray at a time, median"}};
    for (const finding *r = f; r < f + count; r++) add_row(&table, r);
    for (int group = 0; group < GROUPS; group++) {
        draw_times(&charts[group], group, NULL, f, count);
        if (other) draw_times(&charts[GROUPS + group], group, other, f, count);
    }
    if (other) draw_unanswered(&charts[PANELS - 1], other, f, count);
    sheet_print(&table, 0);
    sheet_write(&table, folder, "decided.csv");
    chart_write(charts, other ? PANELS : GROUPS, folder, "decided.svg");
    free(table.rows);
}
