/* peers_main.c - what bench/peers compiles and runs: the contests, the table, peers.csv and peers.svg. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli.h"
#include "measure.h"
#include "peers.h"
#include "results.h"

typedef struct main_options {
    const char *extra; /* a plain argument, which this program does not take */
    const char *output;
    int quick;
    peers_programs programs;
} main_options;

#define FIELD(member) offsetof(main_options, member)

static const cli_option options_table[] = {
    {"--quick", NULL, "fewer surfaces, polynomials and takes", cli_set_flag, FIELD(quick), 0, 0},
    {"--output", "FOLDER", "gets peers.csv and peers.svg", cli_set_text, FIELD(output), 0, 0},
    {"--work", "FOLDER", "for scenes and pictures", cli_set_text, FIELD(programs.work), 0, 0},
    {"--povray", "FILE", "the program", cli_set_text, FIELD(programs.povray), 0, 0},
    {"--surf", "FILE", "the program", cli_set_text, FIELD(programs.surf), 0, 0},
    {NULL, NULL, NULL, NULL, 0, 0, 0}};

static const cli_program program = {
    .name = "peers",
    .synopsis = "--work FOLDER [options]",
    .about = "Compares libalgsurf with other software; called by bench/peers.",
    .options = options_table,
    .positional = FIELD(extra),
};

static const char *const all_surfaces[] = {"sphere", "whitney", "cusp", "steiner", "chair",       "tangle",
                                           "torus",  "pillow",  "boy",  "barth",   "barth-decic", NULL};
static const char *const few_surfaces[] = {"sphere", "torus", "barth", NULL};

static const peers_effort full = {5, 20000, 200, 0.25, 64, all_surfaces};
static const peers_effort quick = {3, 4000, 40, 0.03, 32, few_surfaces};

static const double MOST_OFF = 0.1; /* per cent of the hits; more is marked */

/* ---- the table as text ---- */

typedef struct chapter {
    const char *section, *title, *unit, *count, *missed, *extra, *error;
} chapter;

static const chapter chapters[] = {
    {"pictures",
     "Pictures, 1024x768, one sample a pixel, one thread: CPU time of the picture proper, two point lights, "
     "no\n"
     "shadows.  hits: pixels that show the surface; lacking, extra: pixels where the picture of the "
     "certified\n"
     "tier differs; off%: by how much the number of hits does, * where it is more than 0.1 %.",
     "ms", "hits", "lacking", "extra", "off%"},
    {"first root",
     "First real root in [-1,1] of polynomials along rays, to 1e-12, for each polynomial.  algsurf isolates "
     "and\n"
     "refines them one by one, its packets many at once; isolated + ...: isolated by algsurf, refined by "
     "others;\n"
     "the others find all roots above degree 3.  wrong: polynomials with a first root that is not what came\n"
     "(by more than 1e-6); ghosts: without a root, but one came; error: the largest of the right ones.",
     "ns", "polys", "wrong", "ghosts", "error"},
    {"all roots",
     "All complex roots, for each polynomial.  algsurf, Arb and MPSolve tell how far off they may be; PARI "
     "and GSL\n"
     "do not.  lost: roots that no answer comes near (1e-6, or its own disc); extra: answers near no root; "
     "error:\n"
     "the largest of simple roots.",
     "us", "polys", "lost", "extra", "error"}};

enum { CHAPTERS = sizeof chapters / sizeof *chapters };

/* Of the row's task, the time of the program "algsurf". */
static double own_time(const peers_table *t, const peers_row *row) {
    for (const peers_row *r = t->row; r < t->row + t->count; r++)
        if (strcmp(r->section, row->section) == 0 && strcmp(r->task, row->task) == 0 &&
            strcmp(r->program, "algsurf") == 0)
            return r->median;
    return NAN;
}

/* Four digits, no more than are known. */
static const char *four_digits(double x, char text[16]) {
    snprintf(text, 16, "%.*f", x < 10 ? 3 : x < 100 ? 2 : x < 1000 ? 1 : 0, x);
    return text;
}

static void print_row(const peers_row *r, double times, int marked) {
    char median[16], least[16], most[16];
    printf("%-12s %6d  %-20s %9s %9s %9s %8s %7zu %7zu %7zu %8.1e%s\n", r->task, r->degree, r->program,
           four_digits(r->median, median), four_digits(r->least, least), four_digits(r->most, most),
           four_digits(times, (char[16]){""}), r->count, r->missed, r->extra, r->error, marked ? " *" : "");
}

static void print_chapter(const chapter *c, const peers_table *t) {
    printf("\n%s\n\n", c->title);
    printf("%-12s %6s  %-20s %6s %s %9s %9s %8s %7s %7s %7s %8s\n", "task", "degree", "program", "median",
           c->unit, "min", "max", "times", c->count, c->missed, c->extra, c->error);
    for (const peers_row *r = t->row; r < t->row + t->count; r++)
        if (strcmp(r->section, c->section) == 0)
            print_row(r, r->median / own_time(t, r), c == chapters && r->error > MOST_OFF);
}

/* ---- the files ---- */

static void write_csv(const peers_table *t, const char *folder) {
    FILE *file = results_create(folder, "peers.csv");
    fprintf(file, "section,task,degree,program,unit,median,min,max,times,count,missed,extra,error\n");
    for (const peers_row *r = t->row; r < t->row + t->count; r++)
        fprintf(file, "%s,%s,%d,%s,%s,%.4g,%.4g,%.4g,%.4g,%zu,%zu,%zu,%.2e\n", r->section, r->task, r->degree,
                r->program, r->unit, r->median, r->least, r->most, r->median / own_time(t, r), r->count,
                r->missed, r->extra, r->error);
    results_finish(file, folder, "peers.csv");
}

enum { MOST_TASKS = 12, MOST_PROGRAMS = 8 };

/* One section as bars: tasks side by side, the programs in each. */
typedef struct chart {
    const char *task[MOST_TASKS + 1], *program[MOST_PROGRAMS];
    size_t tasks, programs;
    double x[MOST_TASKS], y[MOST_PROGRAMS][MOST_TASKS], least, most;
    plot_series series[MOST_PROGRAMS];
} chart;

static size_t place(const char **names, size_t *count, size_t most, const char *name) {
    size_t i = 0;
    while (i < *count && strcmp(names[i], name) != 0) i++;
    if (i == most) cli_fail(CLI_BROKEN, "no room for %s in the chart", name);
    if (i == *count) names[(*count)++] = name;
    return i;
}

static void fill_chart(chart *c, const char *section, const peers_table *t) {
    *c = (chart){.least = INFINITY};
    for (int p = 0; p < MOST_PROGRAMS; p++)
        for (int k = 0; k < MOST_TASKS; k++) c->y[p][k] = NAN;
    for (const peers_row *r = t->row; r < t->row + t->count; r++) {
        if (strcmp(r->section, section) != 0) continue;
        size_t k = place(c->task, &c->tasks, MOST_TASKS, r->task);
        size_t p = place(c->program, &c->programs, MOST_PROGRAMS, r->program);
        c->x[k] = (double)k;
        c->y[p][k] = r->median;
        c->least = fmin(c->least, r->median);
        c->most = fmax(c->most, r->median);
    }
    for (size_t p = 0; p < c->programs; p++)
        c->series[p] = (plot_series){c->program[p], PLOT_BARS, c->x, c->y[p], c->tasks};
}

static void write_svg(const peers_table *t, const char *folder) {
    static const struct {
        const char *title, *subtitle, *label;
    } words[CHAPTERS] = {
        {"A picture", "1024x768, one sample a pixel, one thread; less is better", "CPU time (ms)"},
        {"The first real root of a polynomial", "along rays of the surfaces; less is better",
         "CPU time (ns)"},
        {"All complex roots of a polynomial",
         "along rays, and with random complex coefficients; less is better", "CPU time (us)"}};
    static chart charts[CHAPTERS];
    plot plots[CHAPTERS];
    size_t count = 0;
    for (int i = 0; i < CHAPTERS; i++) {
        chart *c = &charts[i];
        fill_chart(c, chapters[i].section, t);
        if (c->tasks > 0)
            plots[count++] = (plot){.title = words[i].title,
                                    .subtitle = words[i].subtitle,
                                    .x = {.names = c->task},
                                    .y = {words[i].label, PLOT_LOG, 0.5 * c->least, 2 * c->most, 0, NULL},
                                    .series = c->series,
                                    .count = c->programs,
                                    .width = 960};
    }
    results_plot(plots, count, folder, "peers.svg");
}

int main(int argc, char **argv) {
    main_options o = {.output = NULL};
    peers_table table = {NULL, 0, 0};
    char machine[512];
    cli_parse(&program, argc, argv, &o);
    if (o.extra) cli_fail(CLI_BAD_INPUT, "unexpected '%s'", cli_quote(o.extra).text);
    if (!o.programs.work) cli_fail(CLI_BAD_INPUT, "--work: is missing");
    if (o.output) results_folder(o.output); /* before the work */
    const peers_effort *effort = o.quick ? &quick : &full;
    peers_pictures(effort, &o.programs, &table);
    peers_first_roots(effort, &table);
    peers_all_roots(effort, &table);
    measure_machine(machine, sizeof machine);
    printf("libalgsurf and its peers; medians of %d takes in turn; times: in units of algsurf's median\n"
           "machine: %s; kernel %s\n",
           effort->takes, machine, algsurf_kernel_name(0));
    for (int i = 0; i < CHAPTERS; i++) print_chapter(&chapters[i], &table);
    if (o.output) {
        write_csv(&table, o.output);
        write_svg(&table, o.output);
    }
    free(table.row);
    cli_finish_output();
    return 0;
}
