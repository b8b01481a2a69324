/* fit.c - how long it takes to choose the view of an equation that comes without one: fit --help. */
#include "fit.h"

#include <stdlib.h>
#include <string.h>

#include "cli.h"
#include "measure.h"

enum { MOST = 4096, LINE = 2000, SLOWEST = 10, WIDTH = 640, HEIGHT = 480 };
static const double GOAL = 0.1; /* seconds */

typedef struct bench_options {
    const char *file; /* a plain argument */
    int all;
} bench_options;

static const cli_option options_table[] = {{"--all", NULL, "prints all of them, not the slowest ten",
                                            cli_set_flag, offsetof(bench_options, all), 0, 0},
                                           {NULL, NULL, NULL, NULL, 0, 0, 0}};

static const cli_program program = {
    .name = "fit",
    .synopsis = "[--all] FILE",
    .about =
        "Chooses extent and camera, as render does, for each line of FILE that is an equation without\n"
        "letters but x, y, z (tests/data/typed.txt: what stands in the tests, the page and the guide).\n"
        "Prints the slowest ten, with seconds of processor time and degree; then how many there are, mean,\n"
        "median, and how many take longer than a tenth of a second.",
    .options = options_table,
    .positional = offsetof(bench_options, file),
};

typedef struct fitted {
    double seconds;
    int degree;
    char equation[LINE];
} fitted;

/* 0: the line is no equation. */
static int fit(const char *line, fitted *result) {
    view_options options;
    view v;
    fit_choice choice;
    algsurf_surface *surface;
    if (algsurf_surface_from_equation(line, NULL, 0, &surface, NULL) != ALGSURF_OK) return 0;
    memset(&options, 0, sizeof options);
    options.width = WIDTH, options.height = HEIGHT;
    const double begun = measure_cpu();
    const algsurf_status status = fit_choose(&v, &options, surface, 0, 1, &choice);
    *result = (fitted){.seconds = measure_cpu() - begun, .degree = algsurf_surface_degree(surface)};
    strcpy(result->equation, line);
    algsurf_surface_free(surface);
    if (status != ALGSURF_OK) cli_fail(CLI_BROKEN, "%s: %s", line, algsurf_status_text(status));
    return 1;
}

static int slower_first(const void *a, const void *b) {
    const double x = ((const fitted *)a)->seconds, y = ((const fitted *)b)->seconds;
    return (x < y) - (x > y);
}

int main(int argc, char **argv) {
    static fitted all[MOST];
    char line[LINE];
    size_t count = 0, over = 0;
    double sum = 0;
    bench_options options = {0};
    cli_parse(&program, argc, argv, &options);
    FILE *file = options.file ? fopen(options.file, "r") : NULL;
    if (!file) cli_fail(CLI_BAD_INPUT, "%s: cannot be read", options.file ? options.file : "no FILE");
    while (count < MOST && fgets(line, sizeof line, file)) {
        line[strcspn(line, "\n")] = 0;
        count += (size_t)fit(line, &all[count]);
    }
    fclose(file);
    if (count == 0) cli_fail(CLI_BAD_INPUT, "%s: no equation", options.file);
    qsort(all, count, sizeof *all, slower_first);
    for (size_t i = 0; i < count; i++) {
        sum += all[i].seconds, over += all[i].seconds > GOAL;
        if (options.all || i < SLOWEST)
            printf("%.3f\t%d\t%s\n", all[i].seconds, all[i].degree, all[i].equation);
    }
    printf("%zu equations: mean %.3f s, median %.3f s, %zu take longer than %g s\n", count,
           sum / (double)count, all[count / 2].seconds, over, GOAL);
    return EXIT_SUCCESS;
}
