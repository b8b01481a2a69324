/* peers_main.c - what bench/peers compiles and runs: the pictures, the table, peers.csv and peers.svg. */
#include <stdio.h>
#include <stdlib.h>

#include "peers.h"
#include "results.h"

typedef struct main_options {
    const char *output;
    int quick;
    peers_programs programs;
} main_options;

#define FIELD(member) offsetof(main_options, member)

static const cli_option options_table[] = {
    {"--quick", NULL, "fewer surfaces and takes", cli_set_flag, FIELD(quick), 0, 0},
    {"--output", "FOLDER", "gets peers.csv and peers.svg", cli_set_text, FIELD(output), 0, 0},
    {"--work", "FOLDER", "for scenes and pictures", cli_set_text, FIELD(programs.work), 0, 0},
    {"--povray", "FILE", "the program", cli_set_text, FIELD(programs.povray), 0, 0},
    {"--surf", "FILE", "the program", cli_set_text, FIELD(programs.surf), 0, 0},
    {NULL, NULL, NULL, NULL, 0, 0, 0}};

static const cli_program program = {
    .name = "peers",
    .synopsis = "--work FOLDER [options]",
    .about = "Compares pictures of libalgsurf with those of other software; called by bench/peers.",
    .options = options_table,
};

static const char *const all_surfaces[] = {"sphere", "whitney", "cusp", "steiner", "chair",       "tangle",
                                           "torus",  "pillow",  "boy",  "barth",   "barth-decic", NULL};
static const char *const few_surfaces[] = {"sphere", "torus", "barth", NULL};

static const contest_chapter chapter = {
    .section = "pictures",
    .title = "Pictures, 1024x768, one sample a pixel, one thread: CPU time of the picture proper, two\n"
             "point lights, no shadows.  hits: pixels that show the surface; lacking, extra: pixels that\n"
             "differ from the picture that is proved, without thin parts; off%: by how much the number\n"
             "of hits does, * where it is more than 0.1 %.",
    .heads = {"hits", "lacking", "extra", "off%"},
    .most_error = 0.1,
    .caption = "A picture",
    .subtitle = "1024x768, one sample a pixel, one thread; less is better"};

int main(int argc, char **argv) {
    main_options o = {.output = NULL};
    contest_table table = {NULL, 0, 0};
    results_begin(&program, argc, argv, &o, &o.output);
    if (!o.programs.work) cli_fail(CLI_BAD_INPUT, "--work: is missing");
    const int takes = o.quick ? 3 : 5;
    peers_pictures(o.quick ? few_surfaces : all_surfaces, takes, &o.programs, &table);
    contest_report("its peers", takes, &chapter, 1, &table, o.output, "peers");
    free(table.row);
    cli_finish_output();
    return 0;
}
