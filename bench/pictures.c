/* pictures.c - what a picture costs, and where the time goes: pictures --help.
 *
 * Every named surface is drawn in the same view by each kernel, with one thread and more, in each tier, with
 * antialiasing of all pixels or of edges only, in full quality, and ray by ray.  Beside it stands the floor,
 * the same surface lifted by a constant until nothing of it is left inside the extent: what remains to be
 * done there is a chord, coefficients and their signs for each ray.  Every picture that is timed is judged
 * (pictures.h); a contradiction ends the program without a table.  The ways to draw take turns, so that
 * what else runs on the machine hits them alike.
 */
#include <stdlib.h>
#include <string.h>

#include "must.h"
#include "pictures.h"
#include "results.h"
#include "surfaces.h"

enum { SMALLEST = 16, LARGEST = 65535 };

typedef struct bench_options {
    const char *output;
    int width, height, repeat, no_full, quick, tsv;
    surface_list surfaces;
} bench_options;

static void set_size(const cli_option *option, const char *value, void *field) {
    bench_options *o = field;
    char text[16];
    size_t cut = strcspn(value, "x");
    if (value[cut] == 'x' && cut < sizeof text) {
        memcpy(text, value, cut);
        text[cut] = '\0';
        if (cli_whole(text, SMALLEST, LARGEST, &o->width) &&
            cli_whole(value + cut + 1, SMALLEST, LARGEST, &o->height))
            return;
    }
    cli_fail(CLI_BAD_INPUT, "%s: expected WxH, each from %d to %d, got '%s'", option->name, SMALLEST, LARGEST,
             cli_quote(value).text);
}

#define FIELD(member) offsetof(bench_options, member)

static const cli_option options_table[] = {
    {"--size", "WxH", "of the pictures, at least 16x16, default 1024x768", set_size, 0, 0, 0},
    {"--repeat", "N", "pictures of which the median is reported, default 5", cli_set_int, FIELD(repeat), 1,
     MEASURE_MOST_TAKES},
    {"--surface", "NAME", "a surface of the catalogue (repeatable), default all of them", surfaces_set,
     FIELD(surfaces), 0, 0},
    {"--no-full", NULL, "no pictures in full quality", cli_set_flag, FIELD(no_full), 0, 0},
    {"--quick", NULL, "smaller defaults: 512x384, five surfaces", cli_set_flag, FIELD(quick), 0, 0},
    {"--output", "FOLDER", "gets pictures.csv, pictures_floor.csv and pictures.svg; made if there is none",
     cli_set_text, FIELD(output), 0, 0},
    {"--format", "text|tsv", "to be read by people (default) or programs", cli_set_choice, FIELD(tsv), 0, 0},
    {NULL, NULL, NULL, NULL, 0, 0, 0}};

static const cli_program program = {
    .name = "pictures",
    .synopsis = "[options]",
    .about = "Draws named surfaces with each kernel of this machine, with one thread and more, in\n"
             "each tier, with antialiasing, in full quality, and ray by ray; checks the pictures\n"
             "against each other, then prints what they cost.  Pictures that contradict each other:\n"
             "one line on standard error, no table, exit status 1.",
    .options = options_table,
};

/* ---- the ways to draw ---- */

#define STANDARD .quality = ALGSURF_QUALITY_STANDARD

static const manner others[] = {
    {.name = "two", .threads = 2, STANDARD, .duty = DUTY_PICTURE},
    {.name = "all", .threads = 0, STANDARD, .duty = DUTY_PICTURE},
    {.name = "bounded", .threads = 1, STANDARD, .tier = ALGSURF_TIER_BOUNDED, .duty = DUTY_OPEN},
    {.name = "antialias", .threads = 1, STANDARD, .antialias = 3, .duty = DUTY_SMOOTH},
    {.name = "adaptive", .threads = 1, STANDARD, .antialias = 3, .threshold = 0.1, .duty = DUTY_EITHER},
    {.name = "single", .threads = 1, STANDARD, .method = ALGSURF_METHOD_BRENT, .once = 1, .duty = DUTY_MASK},
    {.name = "full", .threads = 1, .quality = ALGSURF_QUALITY_FULL, .once = 1, .duty = DUTY_HITS}};

static void make_plan(plan *p, int no_full) {
    const char *kernel[MAX_KERNELS];
    p->kernels = p->count = 0;
    while (p->kernels < MAX_KERNELS && (kernel[p->kernels] = algsurf_kernel_name(p->kernels))) p->kernels++;
    for (int lifted = 0; lifted < 2; lifted++)
        for (int i = 0; i < p->kernels; i++)
            p->manner[p->count++] = (manner){.name = kernel[i],
                                             .kernel = kernel[i],
                                             .threads = 1,
                                             STANDARD,
                                             .lifted = lifted,
                                             .duty = lifted ? DUTY_EMPTY : DUTY_PICTURE};
    for (size_t i = 0; i < sizeof others / sizeof *others; i++)
        if (!(no_full && others[i].quality == ALGSURF_QUALITY_FULL)) p->manner[p->count++] = others[i];
}

/* ---- a surface in all of them ---- */

static void draw(stage *s, const char *name, const manner *m, int *threads, measure_takes takes[PARTS]) {
    algsurf_render_stats stats;
    const char *breach = stage_draw(s, m, &stats);
    if (breach) cli_fail(CLI_BROKEN, "%s, %s%s: %s", name, m->name, m->lifted ? " (floor)" : "", breach);
    const double seconds[PARTS] = {stats.total_s, stats.expand_s, stats.solve_s,
                                   stats.point_s, stats.shadow_s, stats.shade_s};
    for (int k = 0; k < PARTS; k++) measure_take(&takes[k], seconds[k]);
    *threads = stats.threads;
}

static void measure(const bench_options *o, const plan *p, const catalogue_entry *entry, result *r) {
    stage *s = stage_open(entry, o->width, o->height);
    *r = (result){.entry = entry, .rays = stage_rays(s), .hits = stage_hits(s)};
    for (int turn = 0; turn < o->repeat; turn++)
        for (int i = 0; i < p->count; i++)
            if (turn == 0 || !p->manner[i].once)
                draw(s, entry->name, &p->manner[i], &r->threads[i], r->takes[i]);
    stage_close(s);
}

/* ---- the run ---- */

static void set_defaults(bench_options *o) {
    static const char *const few[] = {"sphere", "torus", "boy", "barth", "barth-decic"};
    if (o->width == 0) {
        o->width = o->quick ? 512 : 1024;
        o->height = o->quick ? 384 : 768;
    }
    if (o->surfaces.count > 0) return;
    if (o->quick) surfaces_add_named(&o->surfaces, few, sizeof few / sizeof *few);
    for (const catalogue_entry *entry = catalogue; !o->quick && entry->name; entry++)
        if (catalogue_first_of(entry) == entry) surfaces_add(&o->surfaces, entry); /* no second names */
}

int main(int argc, char **argv) {
    bench_options o = {.repeat = 5, .surfaces = {.most = SURFACES_ROOM}};
    plan p;
    results_begin(&program, argc, argv, &o, &o.output);
    set_defaults(&o);
    make_plan(&p, o.no_full);
    result *results = must_allocate((size_t)o.surfaces.count, sizeof *results);
    for (int i = 0; i < o.surfaces.count; i++) measure(&o, &p, o.surfaces.entry[i], &results[i]);
    const report r = {&p, results, o.surfaces.count, o.width, o.height, o.repeat};
    report_all(&r, o.tsv, o.output);
    free(results);
    return 0;
}
