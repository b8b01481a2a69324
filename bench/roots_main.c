/* roots_main.c - what bench/roots compiles and runs: the contests, the table, roots.csv and roots.svg. */
#include <stdio.h>
#include <stdlib.h>

#include "results.h"
#include "roots.h"

typedef struct main_options {
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
};

static const roots_effort full = {5, 20000, 400, 0.25, 64, ALGSURF_MAX_POLY_DEGREE, 5};
static const roots_effort quick = {3, 4000, 60, 0.03, 32, 100, 1};

static const contest_chapter chapters[] = {
    {.section = "first root",
     .title = "First real root in [-1,1], to 1e-12, for each polynomial: along rays of surfaces, and of\n"
              "rays that graze.  algsurf proves its answers, one by one or many at once; in two steps:\n"
              "isolates, then refines; isolated + ...: isolated by algsurf, refined by others.  wrong:\n"
              "polynomials with a first root that is not what came (by more than 1e-6); ghosts: without a\n"
              "root, but one came; error: the largest of the right ones.",
     .heads = {"polys", "wrong", "ghosts", "error"},
     .caption = "The first real root of a polynomial",
     .subtitle = "in an interval, along rays; less is better"},
    {.section = "interval",
     .title = "All real roots in [-1,1], for each polynomial along rays.  algsurf and Arb prove them;\n"
              "algsurf's are one of the two doubles around each.  lost: roots that no answer comes near\n"
              "(1e-6); extra: answers near none.",
     .heads = {"polys", "lost", "extra", "error"},
     .caption = "All real roots in an interval",
     .subtitle = "of polynomials along rays; less is better"},
    {.section = "isolated",
     .title = "Real roots on the whole line, isolated, for each polynomial of a family (the largest\n"
              "degree is told); all these programs prove it.  refined: to doubles as well; complex: all\n"
              "complex roots.  fewer, more: polynomials with another number of roots than there are.",
     .heads = {"polys", "fewer", "more", "-"},
     .caption = "All real roots on the line",
     .subtitle = "isolated, with proof; less is better"},
    {.section = "counted",
     .title = "The same families: real roots counted only.",
     .heads = {"polys", "fewer", "more", "-"},
     .caption = "The number of real roots",
     .subtitle = "on the line, with proof; less is better"},
    {.section = "all roots",
     .title = "All complex roots, for each polynomial.  algsurf, Arb and MPSolve tell how far off they\n"
              "may be; PARI and GSL do not.  lost: roots that no answer comes near (1e-6, or its own\n"
              "disc); extra: answers near no root; error: the largest of simple roots.",
     .heads = {"polys", "lost", "extra", "error"},
     .caption = "All complex roots of a polynomial",
     .subtitle = "along rays, and with random coefficients; less is better"},
    {.section = "real families",
     .title = "All complex roots of one polynomial with integer coefficients: families whose roots are\n"
              "real.  MPSolve: its secular (-as) and its classic (-au) algorithm, until roots are\n"
              "isolated, or known to 53 bits, as by the others. roots: how many came, of algsurf boxes;\n"
              "0: no answer in 5 s (--quick: 1 s), and that is the time.  lost, extra: as above, 1e-6\n"
              "being of a root's size.",
     .heads = {"roots", "lost", "extra", "error"},
     .caption = "All complex roots: families with real roots",
     .subtitle = "integer coefficients; less is better"},
    {.section = "families",
     .title = "The same: families with complex roots, roots that are close, sparse and random\n"
              "polynomials.",
     .heads = {"roots", "lost", "extra", "error"},
     .caption = "All complex roots: other families",
     .subtitle = "integer coefficients; less is better"},
    {.section = "complex pictures",
     .title = "Pictures of complex space, 640x480, one sample a pixel, one thread, shading included:\n"
              "roots in a sector of 0.1 about the real axis.  The same picture by each kernel, and with\n"
              "every pixel by itself instead of starting from the row above.  single: pixels that rows\n"
              "leave undecided; open: still so; sweeps: corrections of each root, mean.",
     .heads = {"hits", "single", "open", "sweeps"},
     .caption = "A picture of complex space",
     .subtitle = "640x480, one thread; less is better"}};

/* In the order in which --only names them. */
static roots_contests *const contests[] = {roots_first,   roots_interval, roots_line,
                                           roots_complex, roots_families, roots_pictures};

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
    results_begin(&program, argc, argv, &o, &o.output);
    const roots_effort *effort = o.quick ? &quick : &full;
    for (int i = 0; i < CONTESTS; i++)
        if (o.only == 0 || o.only == i + 1) contests[i](effort, &table);
    contest_report("other root finders", effort->takes, chapters, CHAPTERS, &table, o.output, "roots");
    free(table.row);
    cli_finish_output();
    return 0;
}
