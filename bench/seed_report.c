/* seed_report.c - see seed.h: what is told. */
#include "seed.h"

#include <math.h>
#include <stdlib.h>

#include "chart.h"
#include "results.h"
#include "sheet.h"

static const char legend[] =
    "Six surfaces of Chuyeshov, Visualization of algebraic surfaces, 2005, as the catalogue shows them.\n"
    "Polynomials are those of the rays through the pixels' middles, in units of half the chord from its\n"
    "middle; tolerance 1e-7 of these.  Every bracket's root is compared with one that is proved.\n"
    "  method    default: Newton guarded by its bracket; Illinois, Chandrupatla and ITP are no part of the\n"
    "            library, and do without its checks of arguments and its guarded floating-point environment\n"
    "  a ray     evaluations (default: of p with p') for a ray that meets the extent, mean\n"
    "  eval      evaluations for a bracket, both ends counted: mean; most\n"
    "  wrong%    roots that are not where they should be: regula falsi stops where two points agree\n"
    "  refine    from bracket to root, ns a bracket: median (spread: largest less smallest)\n"
    "  solve     the same with the isolation before it, ns a ray that meets the extent\n"
    "  picture   all of it with one sample a pixel, lights and no shadows, ms of all processors,\n"
    "            ray by ray; packets: as the library draws by default\n"
    "  pixels%   of the picture that are wrong\n";

/* ---- cells ---- */

static double percent(size_t part, size_t whole) { return 100 * (double)part / (double)whole; }

static double median(const measure_takes *t) { return measure_taken(t, 0.5); }

static double a_ray(const seed_result *r, int m) {
    return r->cost[m].evaluations * (double)r->brackets / (double)r->rays;
}

typedef struct cells {
    char text[96];
} cells;

/* The cells of four columns: median and spread, median, least, most; or nothing. */
static cells times(const measure_takes *t, double unit) {
    cells c = {"\t\t\t"};
    const double least = unit * measure_taken(t, 0), middle = unit * median(t),
                 most = unit * measure_taken(t, 1);
    if (t->count > 0)
        snprintf(c.text, sizeof c.text, "%.0f (%.0f%%)\t%.6g\t%.6g\t%.6g", middle,
                 100 * (most - least) / middle, middle, least, most);
    return c;
}

#define TIMES(title, name)                                                                                   \
    {title, 14, ""}, {"", 0, name}, {"", 0, name "_min"}, { "", 0, name "_max" }

/* ---- tables ---- */

static void tell_costs(const seed_result *results, size_t pixels, const char *folder) {
    static const sheet_column columns[] = {{"", 0, "surface"},
                                           {"", 0, "degree"},
                                           {"", 0, "rays"},
                                           {"", 0, "brackets"},
                                           {"method", -14, NULL},
                                           {"a ray", 6, ""},
                                           {"eval", 8, "evaluations"},
                                           {"most", 6, "evaluations_most"},
                                           {"wrong%", 7, ""},
                                           {"", 0, "wrong_roots"},
                                           TIMES("refine", "refine_ns"),
                                           TIMES("solve", "solve_ns"),
                                           TIMES("picture", "picture_ms"),
                                           {"pixels%", 8, ""},
                                           {"", 0, "wrong_pixels"}};
    const cells none = times(&(measure_takes){.count = 0}, 1);
    sheet table = SHEET(columns);
    for (const seed_result *r = results; r < results + SEED_SURFACES; r++) {
        for (int m = 0; m < SEED_METHODS; m++) {
            const seed_cost *c = &r->cost[m];
            cells wrong = {"\t"};
            if (m < SEED_OWN)
                snprintf(wrong.text, sizeof wrong.text, "%.2f\t%zu", percent(c->wrong_pixels, pixels),
                         c->wrong_pixels);
            sheet_add(&table, "%s\t%d\t%zu\t%zu\t%s\t%.1f\t%.6g\t%d\t%.2f\t%zu\t%s\t%s\t%s\t%s", r->name,
                      r->degree, r->rays, r->brackets, seed_methods[m].name, a_ray(r, m), c->evaluations,
                      c->evaluations_most, percent(c->wrong, r->brackets), c->wrong,
                      times(&c->refine, 1e9).text, times(&c->solve, 1e9).text, times(&c->picture, 1e3).text,
                      wrong.text);
        }
        sheet_add(&table, "%s\t%d\t%zu\t%zu\tpackets\t\t\t\t\t\t%s\t%s\t%s\t0.00\t0", r->name, r->degree,
                  r->rays, r->brackets, none.text, none.text, times(&r->packets, 1e3).text);
        printf("\n%s: degree %d, %zu rays, %zu brackets", r->name, r->degree, r->rays, r->brackets);
        if (r->undecided) printf(", %zu undecided", r->undecided);
        printf("; a call with nothing to refine: %.0f ns, a rival's %.0f ns\n", 1e9 * median(&r->idle[0]),
               1e9 * median(&r->idle[1]));
        sheet_print(&table, 0);
    }
    sheet_write(&table, folder, "seed.csv");
    free(table.rows);
}

static void tell_evaluations(const seed_result *results, const char *folder) {
    static const sheet_column columns[] = {{"", 0, "surface"},  {"", 0, "degree"}, {"", 0, "rays"},
                                           {"", 0, "brackets"}, {"", 0, "width"},  {"", 0, "method"},
                                           {"", 0, "a_root"},   {"", 0, "a_ray"},  {"", 0, "most"}};
    sheet table = SHEET(columns);
    printf("\nEvaluations for a bracket, and for a ray that meets the extent (one without a bracket: none);\n"
           "width: of the brackets isolation leaves, geometric mean, half chords\n"
           "%-14s %6s",
           "", "width");
    for (int m = 0; m < SEED_METHODS; m++) printf(" %12s", seed_methods[m].name);
    for (const seed_result *r = results; r < results + SEED_COUNTED; r++) {
        printf("\n%-14s %6.3f", r->name, r->width);
        for (int m = 0; m < SEED_METHODS; m++) {
            const seed_cost *c = &r->cost[m];
            printf(" %6.1f %5.1f", c->evaluations, a_ray(r, m));
            sheet_add(&table, "%s\t%d\t%zu\t%zu\t%.4g\t%s\t%.6g\t%.6g\t%d", r->name, r->degree, r->rays,
                      r->brackets, r->width, seed_methods[m].name, c->evaluations, a_ray(r, m),
                      c->evaluations_most);
        }
    }
    printf("\n");
    sheet_write(&table, folder, "seed_evaluations.csv");
    free(table.rows);
}

static void tell_isolation(const seed_result *results, const char *folder) {
    static const sheet_column columns[] = {
        {"surface", -14, NULL},   {"", 0, "degree"},         TIMES("isolation", "isolation_ns"),
        TIMES("bare", "bare_ns"), {"bare%", 8, ""},          {"", 0, "bare_wrong"},
        TIMES("", "idle_ns"),     TIMES("", "rival_idle_ns")};
    sheet table = SHEET(columns);
    for (const seed_result *r = results; r < results + SEED_SURFACES; r++)
        sheet_add(&table, "%s\t%d\t%s\t%s\t%.2f\t%zu\t%s\t%s", r->name, r->degree,
                  times(&r->isolation, 1e9).text, times(&r->bare, 1e9).text, percent(r->bare_wrong, r->rays),
                  r->bare_wrong, times(&r->idle[0], 1e9).text, times(&r->idle[1], 1e9).text);
    printf("\nIsolation alone, ns a ray that meets the extent: algsurf_isolate_first; bare: Descartes'\n"
           "rule and halving in plain double, nothing bounded or checked; bare%%: its brackets that are\n"
           "lacking or wrong\n");
    sheet_print(&table, 0);
    sheet_write(&table, folder, "seed_isolation.csv");
    free(table.rows);
}

/* How much less Brent's method takes than the other, in per cent of the other. */
static double saved(const seed_result *r, int other) {
    return 100 * (1 - median(&r->cost[SEED_BRENT].picture) / median(&r->cost[other].picture));
}

static void print_savings(const seed_result *results) {
    printf("\nWhat Brent's method saves of a whole picture, ray by ray, per cent\n");
    printf("%-14s %16s %16s\n", "", "over bisection", "over regula falsi");
    for (int i = 0; i < SEED_SURFACES; i++)
        printf("%-14s %16.1f %16.1f\n", results[i].name, saved(&results[i], SEED_BISECTION),
               saved(&results[i], SEED_REGULA_FALSI));
    printf("%-14s %16s %16s\n", "Chuyeshov 2005", "0.9 to 1.7", "0 to 1.9");
    printf("The last line is what the times in that paper's figure 2 come to; its text says 2 to 3, and the\n"
           "times themselves are not at hand.  Refinement can have been but a few per cent of that\n"
           "program's work.\n");
}

static void tell_decic(const seed_decic *d, const char *folder) {
    static const sheet_column columns[] = {{"method", -13, NULL},
                                           {"stops at", -16, "stops_at"},
                                           {"", 0, "roots"},
                                           {"eval", 7, "evaluations"},
                                           {"at limit%", 9, ""},
                                           {"", 0, "at_limit"},
                                           {"off%", 7, ""},
                                           {"", 0, "off"},
                                           {"wrong%", 7, ""},
                                           {"", 0, "wrong"},
                                           {"visible%", 9, ""},
                                           {"", 0, "visible"},
                                           {"largest", 8, "largest_error"}};
    sheet table = SHEET(columns);
    for (const seed_decic_row *r = d->row; r < d->row + SEED_DECIC_ROWS; r++)
        sheet_add(&table, "%s\t%s\t%zu\t%.6g\t%.2f\t%zu\t%.2f\t%zu\t%.2f\t%zu\t%.2f\t%zu\t%.3g", r->method,
                  r->stop, r->roots, r->evaluations, percent(r->at_limit, r->roots), r->at_limit,
                  percent(r->off, r->roots), r->off, percent(r->wrong, r->roots), r->wrong,
                  percent(r->visible, r->roots), r->visible, r->largest);
    printf("\nBarth decic, %zu rays, %zu brackets, tolerance 1e-6, at most 1000 iterations\n", d->view.count,
           d->view.bracketed);
    sheet_print(&table, 0);
    printf("off: by more than the tolerance (2.4 per cent of an earlier sample, 8982 roots seen from 4\n"
           "radii in another direction, after 1000 iterations); wrong: ten tolerances; visible: a pixel's\n"
           "width; largest: error in half chords\n");
    sheet_write(&table, folder, "seed_decic.csv");
    free(table.rows);
}

static void tell_census(const seed_result *results, const seed_census *censuses, const char *folder) {
    static const sheet_column columns[] = {{"surface", -14, NULL},  {"roots", 8, NULL},
                                           {"other root%", 13, ""}, {"", 0, "other_root"},
                                           {"unsettled%", 13, ""},  {"", 0, "unsettled"}};
    sheet table = SHEET(columns);
    for (int i = 0; i < SEED_SURFACES; i++) {
        const seed_census *c = &censuses[i];
        sheet_add(&table, "%s\t%zu\t%.2f\t%zu\t%.2f\t%zu", results[i].name, c->roots,
                  percent(c->other, c->roots), c->other, percent(c->lost, c->roots), c->lost);
    }
    printf("\nNewton's method without a bracket, from the middle of the bracket of the first root\n");
    sheet_print(&table, 0);
    sheet_write(&table, folder, "seed_newton.csv");
    free(table.rows);
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

static double evaluations(const seed_cost *c) { return c->evaluations; }
static double evaluations_most(const seed_cost *c) { return c->evaluations_most; }
static double refine_ns(const seed_cost *c) { return 1e9 * median(&c->refine); }
static double solve_ns(const seed_cost *c) { return 1e9 * median(&c->solve); }
static double picture_ms(const seed_cost *c) { return 1e3 * median(&c->picture); }

/* Bars of methods for all surfaces. */
static void draw_bars(chart *c, const seed_result *results, int methods, double figure(const seed_cost *c)) {
    for (int m = 0; m < methods; m++) {
        chart_series(c, seed_methods[m].name, PLOT_BARS);
        for (int i = 0; i < SEED_SURFACES; i++) chart_bar(c, results[i].name, figure(&results[i].cost[m]));
    }
}

static void plot_evaluations(const seed_result *results, const char *folder) {
    chart charts[2] = {
        {.plot = {.title = "Evaluations of P from bracket to root",
                  .subtitle = "mean over the rays of a picture, tolerance 1e-7 of half the chord, both ends "
                              "counted; default: evaluations of P with P'",
                  .y = {.label = "evaluations, mean"}}},
        {.plot = {.title = "The worst ray",
                  .y = {.label = "evaluations, most", .scale = PLOT_LOG},
                  .height = 360}}};
    draw_bars(&charts[0], results, SEED_METHODS, evaluations);
    draw_bars(&charts[1], results, SEED_METHODS, evaluations_most);
    chart_write(charts, 2, folder, "seed_evaluations.svg");
}

static void plot_times(const seed_result *results, const char *machine, const char *folder) {
    chart charts[3] = {
        {.plot = {.title = "Refinement alone", .subtitle = machine, .y = {.label = "ns a bracket"}}},
        {.plot = {.title = "The whole solve: isolation and refinement", .y = {.label = "ns a ray"}}},
        {.plot = {.title = "The whole picture",
                  .subtitle = "one sample a pixel, lights, no shadows",
                  .y = {.label = "ms of all processors", .scale = PLOT_LOG}}}};
    draw_bars(&charts[0], results, SEED_METHODS, refine_ns);
    draw_bars(&charts[1], results, SEED_METHODS, solve_ns);
    draw_bars(&charts[2], results, SEED_OWN, picture_ms);
    chart_series(&charts[2], "default, in packets", PLOT_BARS);
    for (int i = 0; i < SEED_SURFACES; i++)
        chart_bar(&charts[2], results[i].name, 1e3 * median(&results[i].packets));
    chart_write(charts, 3, folder, "seed_time.svg");
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

static void plot_examples(const seed_result *results, const seed_census *censuses, const seed_decic *decic,
                          const char *folder) {
    const int example = best_example(censuses), degree = decic->view.entry->degree;
    seed_plot_creep(decic->slow, degree, "barth-decic", folder, "seed_creep.svg");
    FILE *file = results_open(folder, "seed_polynomials.csv", "wb");
    fprintf(file, "figure,lo,hi,root,p0,p1,p2,p3,p4,p5,p6,p7,p8,p9,p10\n");
    put_polynomial(file, "seed_creep.svg", decic->slow, degree);
    if (example >= 0) {
        const seed_newton *n = &censuses[example].example;
        seed_plot_newton(n, results[example].name, folder, "seed_newton.svg");
        put_polynomial(file, "seed_newton.svg", &n->ray, n->degree);
    }
    results_finish(file, folder, "seed_polynomials.csv");
}

/* ---- all of it ---- */

void seed_report(const seed_result *results, const seed_census *censuses, const seed_decic *decic,
                 const char *folder) {
    const int width = decic->view.width, height = decic->view.height;
    char machine[512];
    measure_machine(machine, sizeof machine);
    measure_head("", (const char *const[]){legend, NULL});
    printf("kernel: %s\nsize: %dx%d\n", algsurf_kernel_name(0), width, height);
    tell_costs(results, (size_t)width * (size_t)height, folder);
    tell_evaluations(results, folder);
    tell_isolation(results, folder);
    print_savings(results);
    tell_decic(decic, folder);
    tell_census(results, censuses, folder);
    cli_finish_output();
    if (!folder) return;
    plot_evaluations(results, folder);
    plot_times(results, machine, folder);
    plot_examples(results, censuses, decic, folder);
}
