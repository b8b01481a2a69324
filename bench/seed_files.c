/* seed_files.c - what seed measured, as CSV files and charts. */
#include <math.h>

#include "measure.h"
#include "results.h"
#include "seed_report.h"

/* ---- tables ---- */

static void put_times(FILE *file, const seed_times *t, double unit) {
    if (t->count == 0)
        fprintf(file, ",,,");
    else
        fprintf(file, ",%.6g,%.6g,%.6g", unit * measure_quantile(t->seconds, t->count, 0.5),
                unit * t->seconds[0], unit * t->seconds[t->count - 1]);
}

static void write_costs(const seed_result *results, const char *folder) {
    FILE *file = results_create(folder, "seed.csv");
    fprintf(file, "surface,degree,rays,brackets,method,evaluations,evaluations_most,wrong_roots,"
                  "refine_ns,refine_ns_min,refine_ns_max,solve_ns,solve_ns_min,solve_ns_max,"
                  "picture_ms,picture_ms_min,picture_ms_max,wrong_pixels\n");
    for (const seed_result *r = results; r < results + SEED_SURFACES; r++) {
        for (int m = 0; m < SEED_METHODS; m++) {
            const seed_cost *c = &r->cost[m];
            fprintf(file, "%s,%d,%zu,%zu,%s,%.6g,%d,%zu", r->name, r->degree, r->rays, r->brackets,
                    seed_methods[m].name, c->evaluations, c->evaluations_most, c->wrong);
            put_times(file, &c->refine, 1e9);
            put_times(file, &c->solve, 1e9);
            put_times(file, &c->picture, 1e3);
            if (c->picture.count > 0)
                fprintf(file, ",%zu\n", c->wrong_pixels);
            else
                fprintf(file, ",\n");
        }
        fprintf(file, "%s,%d,%zu,%zu,packets,,,,,,,,,", r->name, r->degree, r->rays, r->brackets);
        put_times(file, &r->packets, 1e3);
        fprintf(file, ",0\n");
    }
    results_finish(file, folder, "seed.csv");
}

/* What each method evaluates, and from how wide a bracket. */
static void write_evaluations(const seed_result *results, const char *folder) {
    FILE *file = results_create(folder, "seed_evaluations.csv");
    fprintf(file, "surface,degree,rays,brackets,width,method,a_root,a_ray,most\n");
    for (const seed_result *r = results; r < results + SEED_COUNTED; r++)
        for (int m = 0; m < SEED_METHODS; m++) {
            const seed_cost *c = &r->cost[m];
            fprintf(file, "%s,%d,%zu,%zu,%.4g,%s,%.6g,%.6g,%d\n", r->name, r->degree, r->rays, r->brackets,
                    r->width, seed_methods[m].name, c->evaluations,
                    c->evaluations * (double)r->brackets / (double)r->rays, c->evaluations_most);
        }
    results_finish(file, folder, "seed_evaluations.csv");
}

static void write_isolation(const seed_result *results, const char *folder) {
    FILE *file = results_create(folder, "seed_isolation.csv");
    fprintf(file, "surface,degree,isolation_ns,isolation_ns_min,isolation_ns_max,bare_ns,bare_ns_min,"
                  "bare_ns_max,bare_wrong,idle_ns,idle_ns_min,idle_ns_max,rival_idle_ns,rival_idle_ns_min,"
                  "rival_idle_ns_max\n");
    for (const seed_result *r = results; r < results + SEED_SURFACES; r++) {
        fprintf(file, "%s,%d", r->name, r->degree);
        put_times(file, &r->isolation, 1e9);
        put_times(file, &r->bare, 1e9);
        fprintf(file, ",%zu", r->bare_wrong);
        put_times(file, &r->idle[0], 1e9);
        put_times(file, &r->idle[1], 1e9);
        fprintf(file, "\n");
    }
    results_finish(file, folder, "seed_isolation.csv");
}

static void write_decic(const seed_decic *d, const char *folder) {
    FILE *file = results_create(folder, "seed_decic.csv");
    fprintf(file, "method,stops_at,roots,evaluations,at_limit,off,wrong,visible,largest_error\n");
    for (const seed_decic_row *r = d->row; r < d->row + SEED_DECIC_ROWS; r++)
        fprintf(file, "%s,%s,%zu,%.6g,%zu,%zu,%zu,%zu,%.3g\n", r->method, r->stop, r->roots, r->evaluations,
                r->at_limit, r->off, r->wrong, r->visible, r->largest);
    results_finish(file, folder, "seed_decic.csv");
}

static void write_census(const seed_result *results, const seed_census *censuses, const char *folder) {
    FILE *file = results_create(folder, "seed_newton.csv");
    fprintf(file, "surface,roots,other_root,unsettled\n");
    for (int i = 0; i < SEED_SURFACES; i++)
        fprintf(file, "%s,%zu,%zu,%zu\n", results[i].name, censuses[i].roots, censuses[i].other,
                censuses[i].lost);
    results_finish(file, folder, "seed_newton.csv");
}

static void put_polynomial(FILE *file, const char *figure, const seed_ray *ray, int degree) {
    fprintf(file, "%s,%.17g,%.17g,%.17g", figure, ray->lo, ray->hi, ray->root);
    for (int i = 0; i <= SEED_DEGREE; i++)
        if (i <= degree)
            fprintf(file, ",%.17g", ray->c[i]);
        else
            fprintf(file, ",");
    fprintf(file, "\n");
}

/* ---- charts ---- */

enum { BARS = SEED_METHODS + 1 };

/* Bars of all methods for all surfaces. */
typedef struct bars {
    double x[SEED_SURFACES], y[BARS][SEED_SURFACES];
    plot_series series[BARS];
    const char *names[SEED_SURFACES + 1];
    plot p;
} bars;

static void begin_bars(bars *b, const seed_result *results, int count, const char *title,
                       const char *subtitle, plot_axis axis) {
    for (int i = 0; i < SEED_SURFACES; i++) {
        b->x[i] = i;
        b->names[i] = results[i].name;
    }
    b->names[SEED_SURFACES] = NULL;
    for (int m = 0; m < count; m++)
        b->series[m] = (plot_series){m < SEED_METHODS ? seed_methods[m].name : "default, in packets",
                                     PLOT_BARS, b->x, b->y[m], SEED_SURFACES};
    b->p = (plot){.title = title,
                  .subtitle = subtitle,
                  .x = {.names = b->names},
                  .y = axis,
                  .series = b->series,
                  .count = (size_t)count};
}

static double median(const seed_times *t) { return measure_quantile(t->seconds, t->count, 0.5); }

static void plot_evaluations(const seed_result *results, const char *folder) {
    bars mean, most;
    begin_bars(
        &mean, results, SEED_METHODS, "Evaluations of P from bracket to root",
        "mean over the rays of a picture, tolerance 1e-7 of half the chord, both ends counted; default: "
        "evaluations of P with P'",
        (plot_axis){.label = "evaluations, mean"});
    begin_bars(&most, results, SEED_METHODS, "The worst ray", NULL,
               (plot_axis){.label = "evaluations, most", .scale = PLOT_LOG});
    for (int m = 0; m < SEED_METHODS; m++)
        for (int i = 0; i < SEED_SURFACES; i++) {
            mean.y[m][i] = results[i].cost[m].evaluations;
            most.y[m][i] = results[i].cost[m].evaluations_most;
        }
    most.p.height = 360;
    results_plot((plot[]){mean.p, most.p}, 2, folder, "seed_evaluations.svg");
}

static void plot_times(const seed_result *results, const char *machine, const char *folder) {
    bars refine, solve, picture;
    begin_bars(&refine, results, SEED_METHODS, "Refinement alone", machine,
               (plot_axis){.label = "ns a bracket"});
    begin_bars(&solve, results, SEED_METHODS, "The whole solve: isolation and refinement", NULL,
               (plot_axis){.label = "ns a ray"});
    begin_bars(&picture, results, SEED_OWN + 1, "The whole picture", "one sample a pixel, lights, no shadows",
               (plot_axis){.label = "ms of all processors", .scale = PLOT_LOG});
    picture.series[SEED_OWN].name = "default, in packets";
    for (int i = 0; i < SEED_SURFACES; i++) {
        for (int m = 0; m < SEED_METHODS; m++) {
            refine.y[m][i] = 1e9 * median(&results[i].cost[m].refine);
            solve.y[m][i] = 1e9 * median(&results[i].cost[m].solve);
        }
        for (int m = 0; m < SEED_OWN; m++) picture.y[m][i] = 1e3 * median(&results[i].cost[m].picture);
        picture.y[SEED_OWN][i] = 1e3 * median(&results[i].packets);
    }
    results_plot((plot[]){refine.p, solve.p, picture.p}, 3, folder, "seed_time.svg");
}

/* The surface whose example strays farthest, -1: none. */
static int best_example(const seed_census *censuses) {
    int best = -1;
    double farthest = 0;
    for (int i = 0; i < SEED_SURFACES; i++) {
        const seed_newton *n = &censuses[i].example;
        double far = n->count > 0 ? fabs(n->x[n->count - 1] - n->ray.root) : 0;
        if (far > farthest) farthest = far, best = i;
    }
    return best;
}

/* ---- all of it ---- */

void seed_write(const seed_result *results, const seed_census *censuses, const seed_decic *decic,
                const char *folder) {
    char machine[512];
    int example = best_example(censuses), degree = decic->view.entry->degree;
    measure_machine(machine, sizeof machine);
    write_costs(results, folder);
    write_evaluations(results, folder);
    write_isolation(results, folder);
    write_decic(decic, folder);
    write_census(results, censuses, folder);
    plot_evaluations(results, folder);
    plot_times(results, machine, folder);
    seed_plot_creep(decic->slow, degree, "barth-decic", folder, "seed_creep.svg");
    FILE *file = results_create(folder, "seed_polynomials.csv");
    fprintf(file, "figure,lo,hi,root,p0,p1,p2,p3,p4,p5,p6,p7,p8,p9,p10\n");
    put_polynomial(file, "seed_creep.svg", decic->slow, degree);
    if (example >= 0) {
        const seed_newton *n = &censuses[example].example;
        seed_plot_newton(n, results[example].name, folder, "seed_newton.svg");
        put_polynomial(file, "seed_newton.svg", &n->ray, n->degree);
    }
    results_finish(file, folder, "seed_polynomials.csv");
}
