/* roots_main.c - what bench/roots compiles and runs: the contests, the table, roots.csv and roots.svg. */
#include <stdio.h>
#include <stdlib.h>

#include "cli.h"
#include "measure.h"
#include "results.h"
#include "roots.h"
#include "roots_others.h"

typedef struct main_options {
    const char *extra; /* a plain argument, which this program does not take */
    const char *output;
    int quick, only;
} main_options;

#define FIELD(member) offsetof(main_options, member)

static const cli_option options_table[] = {
    {"--quick", NULL, "fewer polynomials and takes", cli_set_flag, FIELD(quick), 0, 0},
    {"--only", "all|first|interval|line|complex|families|pictures", "one of the contests", cli_set_choice,
     FIELD(only), 0, 0},
    {"--output", "FOLDER", "gets roots.csv and roots.svg", cli_set_text, FIELD(output), 0, 0},
    {NULL, NULL, NULL, NULL, 0, 0, 0}};

static const cli_program program = {
    .name = "roots",
    .synopsis = "[options]",
    .about = "Compares libalgsurf with other root finders; called by bench/roots.",
    .options = options_table,
    .positional = FIELD(extra),
};

static const roots_effort full = {5, 20000, 400, 0.25, 64, ALGSURF_MAX_POLY_DEGREE, 5};
static const roots_effort quick = {3, 4000, 60, 0.03, 32, 100, 1};

static const contest_chapter chapters[] = {
    {.section = "first root",
     .title =
         "First real root in [-1,1], to 1e-12, for each polynomial: along rays of surfaces, and of rays "
         "that graze.\n"
         "algsurf proves its answers, one by one or many at once; in two steps: isolates, then refines; "
         "isolated + ...:\n"
         "isolated by algsurf, refined by others.  wrong: polynomials with a first root that is not what "
         "came (by more\n"
         "than 1e-6); ghosts: without a root, but one came; error: the largest of the right ones.",
     .unit = "ns",
     .count = "polys",
     .missed = "wrong",
     .extra = "ghosts",
     .error = "error",
     .caption = "The first real root of a polynomial",
     .subtitle = "in an interval, along rays; less is better"},
    {.section = "interval",
     .title =
         "All real roots in [-1,1], for each polynomial along rays.  algsurf and Arb prove them; algsurf's "
         "are one\n"
         "of the two doubles around each.  lost: roots that no answer comes near (1e-6); extra: answers "
         "near none.",
     .unit = "ns",
     .count = "polys",
     .missed = "lost",
     .extra = "extra",
     .error = "error",
     .caption = "All real roots in an interval",
     .subtitle = "of polynomials along rays; less is better"},
    {.section = "isolated",
     .title =
         "Real roots on the whole line, isolated, for each polynomial of a family (the largest degree is "
         "told); all\n"
         "these programs prove it.  refined: to doubles as well; complex: all complex roots.  fewer, "
         "more: polynomials\n"
         "with another number of roots than there are.",
     .unit = "us",
     .count = "polys",
     .missed = "fewer",
     .extra = "more",
     .error = "-",
     .caption = "All real roots on the line",
     .subtitle = "isolated, with proof; less is better"},
    {.section = "counted",
     .title = "The same families: real roots counted only.",
     .unit = "us",
     .count = "polys",
     .missed = "fewer",
     .extra = "more",
     .error = "-",
     .caption = "The number of real roots",
     .subtitle = "on the line, with proof; less is better"},
    {.section = "all roots",
     .title = "All complex roots, for each polynomial.  algsurf, Arb and MPSolve tell how far off they may "
              "be; PARI and\n"
              "GSL do not.  lost: roots that no answer comes near (1e-6, or its own disc); extra: answers "
              "near no root;\n"
              "error: the largest of simple roots.",
     .unit = "us",
     .count = "polys",
     .missed = "lost",
     .extra = "extra",
     .error = "error",
     .caption = "All complex roots of a polynomial",
     .subtitle = "along rays, and with random coefficients; less is better"},
    {.section = "real families",
     .title =
         "All complex roots of one polynomial with integer coefficients: families whose roots are real.  "
         "MPSolve: its\n"
         "secular (-as) and its classic (-au) algorithm, until roots are isolated, or known to 53 bits, as "
         "by "
         "the others.\n"
         "roots: how many came, of algsurf boxes; 0: no answer in 5 s (--quick: 1 s), and that is the time.  "
         "lost, extra:\n"
         "as above, 1e-6 being of a root's size.",
     .unit = "ms",
     .count = "roots",
     .missed = "lost",
     .extra = "extra",
     .error = "error",
     .caption = "All complex roots: families with real roots",
     .subtitle = "integer coefficients; less is better"},
    {.section = "families",
     .title = "The same: families with complex roots, roots that are close, sparse and random polynomials.",
     .unit = "ms",
     .count = "roots",
     .missed = "lost",
     .extra = "extra",
     .error = "error",
     .caption = "All complex roots: other families",
     .subtitle = "integer coefficients; less is better"},
    {.section = "complex pictures",
     .title =
         "Pictures of complex space, 640x480, one sample a pixel, one thread, shading included: roots in a "
         "sector of\n"
         "0.1 about the real axis.  The same picture by each kernel, and with every pixel by itself "
         "instead of\n"
         "starting from the row above.  single: pixels that rows leave undecided; open: still so; sweeps: "
         "corrections\n"
         "of each root, mean.",
     .unit = "ms",
     .count = "hits",
     .missed = "single",
     .extra = "open",
     .error = "sweeps",
     .caption = "A picture of complex space",
     .subtitle = "640x480, one thread; less is better"}};

/* In the order in which --only names them. */
static void (*const contests[])(const roots_effort *effort, contest_table *table) = {
    roots_first, roots_interval, roots_line, roots_complex, roots_families, roots_pictures};

enum { CONTESTS = sizeof contests / sizeof *contests, CHAPTERS = sizeof chapters / sizeof *chapters };

int others_in_interval(const other_root *roots, int count, double *real) {
    int n = 0;
    for (int i = 0; i < count; i++)
        if (roots[i].im == 0 && roots[i].re >= -1 && roots[i].re <= 1) real[n++] = roots[i].re;
    if (n > 0) measure_sort(real, (size_t)n);
    return n;
}

int main(int argc, char **argv) {
    main_options o = {.output = NULL};
    contest_table table = {NULL, 0, 0};
    cli_parse(&program, argc, argv, &o);
    if (o.extra) cli_fail(CLI_BAD_INPUT, "unexpected '%s'", cli_quote(o.extra).text);
    if (o.output) results_folder(o.output); /* before the work */
    const roots_effort *effort = o.quick ? &quick : &full;
    for (int i = 0; i < CONTESTS; i++)
        if (o.only == 0 || o.only == i + 1) contests[i](effort, &table);
    contest_head("other root finders", effort->takes);
    contest_print(chapters, CHAPTERS, &table);
    if (o.output) contest_write(chapters, CHAPTERS, &table, o.output, "roots");
    free(table.row);
    cli_finish_output();
    return 0;
}
