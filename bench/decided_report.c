/* decided_report.c - see decided_report.h. */
#include "decided_report.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "results.h"

enum { CELL = 16 };

/* Three digits; what there is none of is a dash. */
static const char *digits(double x, char text[CELL]) {
    if (isnan(x))
        snprintf(text, CELL, "-");
    else
        snprintf(text, CELL, "%.3g", x);
    return text;
}

static double share(size_t some, const finding *r) { return 100 * (double)some / (double)r->rays; }

void report_table(const finding *f, size_t count, const char *beside) {
    char us[CELL], low[CELL], high[CELL], lanes[CELL], times[CELL];
    printf("\n%-12s %6s  %-9s %6s %6s %9s %9s %9s %9s %9s", "surface", "degree", "kind", "rays", "open%",
           "us50%", "10%", "90%", "lanes", "times");
    if (beside) printf(" %9s %9s %6s %6s", "beside", "ratio", "undec%", "wrong%");
    printf("\n");
    for (const finding *r = f; r < f + count; r++) {
        printf("%-12s %6d  %-9s %6zu %6.0f %9s %9s %9s %9s %9s", r->surface, r->degree, kind_names[r->kind],
               r->rays, share(r->open, r), digits(r->us, us), digits(r->us_low, low),
               digits(r->us_high, high), digits(r->lanes, lanes), digits(r->us / r->lanes, times));
        if (beside)
            printf(" %9s %9s %6.0f %6.0f", digits(r->beside, us), digits(r->ratio, times),
                   share(r->undecided, r), share(r->wrong, r));
        printf("\n");
    }
}

static void write_csv(const finding *f, size_t count, const char *folder) {
    static const char name[] = "decided.csv";
    char lanes[CELL], times[CELL], other[CELL], ratio[CELL];
    FILE *file = results_create(folder, name);
    fprintf(file, "surface,degree,kind,rays,open,us_median,us_low,us_high,lanes_us,times,"
                  "beside_us,ratio,beside_undecided,beside_wrong\n");
    for (const finding *r = f; r < f + count; r++)
        fprintf(file, "%s,%d,%s,%zu,%zu,%.4g,%.4g,%.4g,%s,%s,%s,%s,%zu,%zu\n", r->surface, r->degree,
                kind_names[r->kind], r->rays, r->open, r->us, r->us_low, r->us_high, digits(r->lanes, lanes),
                digits(r->us / r->lanes, times), digits(r->beside, other), digits(r->ratio, ratio),
                r->undecided, r->wrong);
    results_finish(file, folder, name);
}

/* ---- charts ---- */

enum { MOST_DEGREES = 16, GROUPS = 2, IN_GROUP = 5, PANELS = 2 * GROUPS + 1 };

static const struct {
    const char *what;
    kind kinds[IN_GROUP];
} groups[GROUPS] = {{"a ray that begins at a root, or with roots close together",
                     {KIND_CLEAR, KIND_END, KIND_GAP_20, KIND_GAP_60, KIND_GAP_200}},
                    {"a ray that touches, or in the surface",
                     {KIND_CLEAR, KIND_TANGENT, KIND_DOUBLE, KIND_INSIDE, KIND_BALL}}};

static double us(const finding *r) { return r->us; }
static double ratio(const finding *r) { return r->ratio; }
static double one(const finding *r) { return r->us / r->us; }

typedef struct curve {
    double x[MOST_DEGREES], y[MOST_DEGREES];
} curve;

/* Of the random surfaces of one kind: a value by degree. */
static plot_series series_of(const char *name, plot_mark mark, double (*value)(const finding *r), kind which,
                             const finding *f, size_t count, curve *c) {
    plot_series s = {name, mark, c->x, c->y, 0};
    for (const finding *r = f; r < f + count && s.count < MOST_DEGREES; r++) {
        if (r->kind != which || strcmp(r->surface, "random") != 0) continue;
        c->x[s.count] = r->degree;
        c->y[s.count++] = value(r);
    }
    return s;
}

/* What a plot points to. */
typedef struct panel {
    curve curves[IN_GROUP + 1];
    plot_series series[IN_GROUP + 1]; /* the last one is a guide */
    const char *names[KINDS + 1];
    char title[128];
} panel;

/* Times of a group of rays; with another edition's name, that edition's in units of this one's. */
static plot make_times(int group, const char *beside, const finding *f, size_t count, panel *p) {
    for (int k = 0; k < IN_GROUP; k++) {
        kind which = groups[group].kinds[k];
        p->series[k] =
            series_of(kind_names[which], PLOT_BOTH, beside ? ratio : us, which, f, count, &p->curves[k]);
    }
    p->series[IN_GROUP] = series_of(NULL, PLOT_LINE, one, KIND_CLEAR, f, count, &p->curves[IN_GROUP]);
    if (beside)
        snprintf(p->title, sizeof p->title, "What it costs %.40s: %s", beside, groups[group].what);
    else
        snprintf(p->title, sizeof p->title, "What it costs to decide %s", groups[group].what);
    return (plot){
        .title = p->title,
        .x = {.label = "degree of the surface"},
        .y = {.label = beside ? "in units of this edition's time" : "microseconds a ray", .scale = PLOT_LOG},
        .series = p->series,
        .count = beside ? IN_GROUP + 1 : IN_GROUP,
        .height = 400};
}

/* What another edition does not answer, by kind. */
static plot make_unanswered(const char *beside, const finding *f, size_t count, panel *p) {
    double *undecided = p->curves[0].y, *wrong = p->curves[1].y;
    for (int k = 0; k < KINDS; k++) {
        finding sum = {.rays = 0};
        for (const finding *r = f; r < f + count; r++) {
            if ((int)r->kind != k) continue;
            sum.rays += r->rays;
            sum.undecided += r->undecided;
            sum.wrong += r->wrong;
        }
        p->curves[0].x[k] = p->curves[1].x[k] = k;
        undecided[k] = share(sum.undecided, &sum);
        wrong[k] = share(sum.wrong, &sum);
        p->names[k] = kind_names[k];
    }
    p->names[KINDS] = NULL;
    p->series[0] = (plot_series){"undecided", PLOT_BARS, p->curves[0].x, undecided, KINDS};
    p->series[1] = (plot_series){"wrong", PLOT_BARS, p->curves[1].x, wrong, KINDS};
    snprintf(p->title, sizeof p->title, "Rays that %.40s leaves undecided, or answers wrongly", beside);
    return (plot){.title = p->title,
                  .x = {.label = "kind of ray", .names = p->names},
                  .y = {.label = "% of the rays", .lo = 0, .hi = 100},
                  .series = p->series,
                  .count = 2,
                  .height = 300};
}

static void write_charts(const finding *f, size_t count, const char *beside, const char *folder) {
    panel panels[PANELS];
    plot plots[PANELS];
    for (int group = 0; group < GROUPS; group++) {
        plots[group] = make_times(group, NULL, f, count, &panels[group]);
        if (beside) plots[GROUPS + group] = make_times(group, beside, f, count, &panels[GROUPS + group]);
    }
    if (beside) plots[PANELS - 1] = make_unanswered(beside, f, count, &panels[PANELS - 1]);
    plots[0].subtitle = "dense random surfaces, certified tier, one ray at a time, median";
    results_plot(plots, beside ? PANELS : GROUPS, folder, "decided.svg");
}

void report_files(const finding *f, size_t count, const char *beside, const char *folder) {
    write_csv(f, count, folder);
    write_charts(f, count, beside, folder);
}
