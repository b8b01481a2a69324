/* seed_report.c - see seed_report.h: the tables; the files are in seed_files.c. */
#include "seed_report.h"

#include "cli.h"
#include "measure.h"

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
    "  picture   all of it with one sample a pixel, lights and no shadows, ms of all processors, ray by "
    "ray;\n"
    "            packets: as the library draws by default\n"
    "  pixels%   of the picture that are wrong\n";

/* ---- cells ---- */

typedef struct cell {
    char text[32];
} cell;

static cell spread(const seed_times *t, double unit) {
    cell c = {"-"};
    if (t->count == 0) return c;
    double middle = measure_quantile(t->seconds, t->count, 0.5);
    snprintf(c.text, sizeof c.text, "%.0f (%.0f%%)", unit * middle,
             100 * (t->seconds[t->count - 1] - t->seconds[0]) / middle);
    return c;
}

static double percent(size_t part, size_t whole) { return 100 * (double)part / (double)whole; }

/* ---- tables ---- */

static double median(const seed_times *t) { return measure_quantile(t->seconds, t->count, 0.5); }

static void print_costs(const seed_result *r, size_t pixels) {
    printf("\n%s: degree %d, %zu rays, %zu brackets", r->name, r->degree, r->rays, r->brackets);
    if (r->undecided) printf(", %zu undecided", r->undecided);
    printf("; a call with nothing to refine: %.0f ns, a rival's %.0f ns\n", 1e9 * median(&r->idle[0]),
           1e9 * median(&r->idle[1]));
    printf("%-14s %6s %6s %6s %7s %14s %14s %14s %8s\n", "method", "a ray", "eval", "most", "wrong%",
           "refine", "solve", "picture", "pixels%");
    for (int m = 0; m < SEED_METHODS; m++) {
        const seed_cost *c = &r->cost[m];
        double a_ray = c->evaluations * (double)r->brackets / (double)r->rays;
        printf("%-14s %6.1f %6.1f %6d %7.2f %14s %14s %14s", seed_methods[m].name, a_ray, c->evaluations,
               c->evaluations_most, percent(c->wrong, r->brackets), spread(&c->refine, 1e9).text,
               spread(&c->solve, 1e9).text, spread(&c->picture, 1e3).text);
        if (m < SEED_OWN)
            printf(" %8.2f\n", percent(c->wrong_pixels, pixels));
        else
            printf(" %8s\n", "-");
    }
    printf("%-14s %6s %6s %6s %7s %14s %14s %14s %8.2f\n", "packets", "-", "-", "-", "-", "-", "-",
           spread(&r->packets, 1e3).text, 0.0);
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
    printf(
        "The last line is what the times in that paper's figure 2 come to; its text says 2 to 3, and the "
        "times\n"
        "themselves are not at hand.  Refinement can have been but a few per cent of that program's work.\n");
}

static void print_isolation(const seed_result *results) {
    printf(
        "\nIsolation alone, ns a ray that meets the extent: algsurf_isolate_first; bare: Descartes' rule and "
        "halving\n"
        "in plain double, nothing bounded or checked; bare%%: its brackets that are lacking or wrong\n"
        "%-14s %14s %14s %8s\n",
        "", "isolation", "bare", "bare%");
    for (int i = 0; i < SEED_SURFACES; i++) {
        const seed_result *r = &results[i];
        printf("%-14s %14s %14s %8.2f\n", r->name, spread(&r->isolation, 1e9).text,
               spread(&r->bare, 1e9).text, percent(r->bare_wrong, r->rays));
    }
}

static void print_evaluations(const seed_result *results) {
    printf("\nEvaluations for a bracket, and for a ray that meets the extent (one without a bracket: none); "
           "width: of\n"
           "the brackets isolation leaves, geometric mean, half chords\n"
           "%-14s %6s",
           "", "width");
    for (int m = 0; m < SEED_METHODS; m++) printf(" %12s", seed_methods[m].name);
    printf("\n");
    for (int i = 0; i < SEED_COUNTED; i++) {
        const seed_result *r = &results[i];
        printf("%-14s %6.3f", r->name, r->width);
        for (int m = 0; m < SEED_METHODS; m++) {
            double a_root = r->cost[m].evaluations;
            printf(" %6.1f %5.1f", a_root, a_root * (double)r->brackets / (double)r->rays);
        }
        printf("\n");
    }
}

static void print_decic(const seed_decic *d) {
    printf("\nBarth decic, %zu rays, %zu brackets, tolerance 1e-6, at most 1000 iterations\n", d->view.count,
           d->view.bracketed);
    printf("%-13s %-16s %7s %9s %7s %7s %9s %8s\n", "method", "stops at", "eval", "at limit%", "off%",
           "wrong%", "visible%", "largest");
    for (int i = 0; i < SEED_DECIC_ROWS; i++) {
        const seed_decic_row *r = &d->row[i];
        printf("%-13s %-16s %7.1f %9.2f %7.2f %7.2f %9.2f %8.1e\n", r->method, r->stop, r->evaluations,
               percent(r->at_limit, r->roots), percent(r->off, r->roots), percent(r->wrong, r->roots),
               percent(r->visible, r->roots), r->largest);
    }
    printf("off: by more than the tolerance (2.4 per cent of an earlier sample, 8982 roots seen from 4 radii "
           "in\n"
           "another direction, after 1000 iterations); wrong: ten tolerances; visible: a pixel's width; "
           "largest:\n"
           "error in half chords\n");
}

static void print_census(const seed_result *results, const seed_census *censuses) {
    printf("\nNewton's method without a bracket, from the middle of the bracket of the first root\n");
    printf("%-14s %8s %13s %13s\n", "surface", "roots", "other root%", "unsettled%");
    for (int i = 0; i < SEED_SURFACES; i++)
        printf("%-14s %8zu %13.2f %13.2f\n", results[i].name, censuses[i].roots,
               percent(censuses[i].other, censuses[i].roots), percent(censuses[i].lost, censuses[i].roots));
}

void seed_print(const seed_result *results, const seed_census *censuses, const seed_decic *decic) {
    char machine[512];
    measure_machine(machine, sizeof machine);
    printf("%smachine: %s\nkernel: %s\nsize: %dx%d\n", legend, machine, algsurf_kernel_name(0),
           decic->view.width, decic->view.height);
    size_t pixels = (size_t)decic->view.width * (size_t)decic->view.height;
    for (int i = 0; i < SEED_SURFACES; i++) print_costs(&results[i], pixels);
    print_evaluations(results);
    print_isolation(results);
    print_savings(results);
    print_decic(decic);
    print_census(results, censuses);
    cli_finish_output();
}
