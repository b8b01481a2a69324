/* pictures.c - what a picture costs, and where the time goes: pictures --help.
 *
 * Every named surface is drawn in the same view by each kernel, with one thread and more, fast, in full
 * quality, and ray by ray.  Beside it stands the floor, the same surface lifted by a constant until nothing
 * of it is left inside the extent: what remains to be done there is a chord, coefficients and their signs for
 * each ray.  Every picture that is timed is judged (pictures_draw.h), but for those of the fast tier, which
 * promises nothing; a contradiction ends the program without a table.  The ways to draw take turns, so that
 * what else runs on the machine hits them alike.
 */
#include <stdlib.h>
#include <string.h>

#include "cli.h"
#include "measure.h"
#include "pictures_draw.h"

enum { SMALLEST = 16, LARGEST = 65535, MAX_REPEAT = 100, MAX_SURFACES = 64 };

typedef struct bench_options {
    const char *extra; /* a plain argument, which this program does not take */
    int width, height, repeat, no_full, tsv;
    const catalogue_entry *surface[MAX_SURFACES];
    int surfaces;
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

static void add_surface(bench_options *o, const catalogue_entry *entry) {
    if (o->surfaces == MAX_SURFACES) cli_fail(CLI_BAD_INPUT, "more than %d surfaces", MAX_SURFACES);
    o->surface[o->surfaces++] = entry;
}

static void set_surface(const cli_option *option, const char *value, void *field) {
    const catalogue_entry *entry = catalogue_find(value);
    if (!entry) cli_expected(option, value);
    add_surface(field, entry);
}

static void set_choice(const cli_option *option, const char *value, void *field) {
    *(int *)field = cli_choice(option, value);
}

#define FIELD(member) offsetof(bench_options, member)

static const cli_option options_table[] = {
    {"--size", "WxH", "of the pictures, at least 16x16, default 1024x768", set_size, 0, 0, 0},
    {"--repeat", "N", "pictures of which the median is told, default 5", cli_set_int, FIELD(repeat), 1,
     MAX_REPEAT},
    {"--surface", "NAME", "a surface of the catalogue (repeatable), default all of them", set_surface, 0, 0,
     0},
    {"--no-full", NULL, "no pictures in full quality", cli_set_flag, FIELD(no_full), 0, 0},
    {"--format", "text|tsv", "to be read by people (default) or programs", set_choice, FIELD(tsv), 0, 0},
    {NULL, NULL, NULL, NULL, 0, 0, 0}};

static const cli_program program = {
    "pictures", "[options]",
    "Draws named surfaces with each kernel of this machine, with one thread and more, in the fast tier, in\n"
    "full quality, and ray by ray; checks the pictures against each other, then prints what they cost.\n"
    "Pictures that contradict each other: one line on standard error, no table, exit status 1.",
    options_table, FIELD(extra)};

static const char legend[] =
    "Pictures, and what they cost: the eye 4 R from the extent's centre, R its radius, in the direction\n"
    "(2,-3,1.2), the picture 2.2 R high there.\n"
    "  rays       pixels whose ray meets the extent\n"
    "  hits       pixels that show the surface\n"
    "  manner     a kernel's name: that kernel with one thread, standard tier and quality; else the fastest\n"
    "             kernel: two, all: threads; fast: one thread, fast tier, unchecked; full: one thread, full\n"
    "             quality, one picture; single: one thread, ray by ray (Brent's method), one picture\n"
    "  ms50%      wall time of algsurf_render, milliseconds: median; min, max: its spread\n"
    "  ns/ray     ms50% for each of the rays\n"
    "  per_s      pictures a second\n"
    "  expand% .. share of the threads' time spent there, as algsurf_render_stats tells; the rest is\n"
    "             bytes, and waiting for the other threads\n"
    "  times      ms50% in units of that of the fastest kernel, one thread\n"
    "Solving and its floor, a surface without points in the extent, so that each ray is a chord,\n"
    "coefficients and their signs:\n"
    "  solve      time spent in intersection, ns for each of the rays, median\n"
    "  floor      the same, of P + c, c twice what |P| can be in the extent\n"
    "  ratio      solve / floor\n";

/* ---- the ways to draw ---- */

enum { MAX_KERNELS = 8, MAX_MANNERS = 2 * MAX_KERNELS + 5 };

/* First the kernels, the fastest first, then their floors in the same order, then the others. */
typedef struct plan {
    manner manner[MAX_MANNERS];
    int kernels, count;
} plan;

#define STANDARD .quality = ALGSURF_QUALITY_STANDARD

static const manner others[] = {
    {.name = "two", .threads = 2, STANDARD, .duty = DUTY_PICTURE},
    {.name = "all", .threads = 0, STANDARD, .duty = DUTY_PICTURE},
    {.name = "fast", .threads = 1, STANDARD, .tier = ALGSURF_TIER_FAST, .duty = DUTY_NONE},
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

typedef struct times {
    size_t count;
    int threads;
    double seconds[PARTS][MAX_REPEAT]; /* sorted, each by itself */
} times;

typedef struct result {
    const catalogue_entry *entry;
    size_t rays, hits;
    times times[MAX_MANNERS];
} result;

static void draw(stage *s, const char *name, const manner *m, times *t) {
    drawing d;
    const char *breach = stage_draw(s, m, &d);
    if (breach) cli_fail(CLI_BROKEN, "%s, %s%s: %s", name, m->name, m->lifted ? " (floor)" : "", breach);
    for (int k = 0; k < PARTS; k++) t->seconds[k][t->count] = d.seconds[k];
    t->threads = d.threads;
    t->count++;
}

static void measure(const bench_options *o, const plan *p, const catalogue_entry *entry, result *r) {
    stage *s = stage_open(entry, o->width, o->height);
    *r = (result){.entry = entry, .rays = stage_rays(s), .hits = stage_hits(s)};
    for (int turn = 0; turn < o->repeat; turn++)
        for (int i = 0; i < p->count; i++)
            if (turn == 0 || !p->manner[i].once) draw(s, entry->name, &p->manner[i], &r->times[i]);
    stage_close(s);
    for (int i = 0; i < p->count; i++)
        for (int k = 0; k < PARTS; k++) measure_sort(r->times[i].seconds[k], r->times[i].count);
}

static double median(const times *t, int part) { return measure_quantile(t->seconds[part], t->count, 0.5); }

static double ns_per_ray(const result *r, const times *t, int part) {
    return 1e9 * median(t, part) / (double)r->rays;
}

/* ---- the tables ---- */

enum { CELL = 24 };

typedef struct column {
    const char *title;
    int width; /* negative: flush left */
} column;

static const column cost_columns[] = {
    {"surface", -12}, {"degree", 6}, {"rays", 7},    {"hits", 7},   {"manner", -8}, {"threads", 7},
    {"ms50%", 8},     {"min", 8},    {"max", 8},     {"ns/ray", 7}, {"per_s", 7},   {"expand%", 7},
    {"solve%", 6},    {"point%", 6}, {"shadow%", 7}, {"shade%", 6}, {"times", 6}};
static const column floor_columns[] = {{"surface", -12}, {"degree", 6}, {"kernel", -8},
                                       {"solve", 8},     {"floor", 8},  {"ratio", 6}};

enum {
    COST_COLUMNS = sizeof cost_columns / sizeof *cost_columns,
    FLOOR_COLUMNS = sizeof floor_columns / sizeof *floor_columns
};

static void print_row(const column *columns, int count, const char cell[][CELL], int tsv) {
    for (int k = 0; k < count; k++)
        if (tsv)
            printf("%s%s", k > 0 ? "\t" : "", cell[k]);
        else
            printf("%s%*s", k > 0 ? "  " : "", columns[k].width, cell[k]);
    putchar('\n');
}

static void print_titles(const column *columns, int count, int tsv) {
    char cell[COST_COLUMNS][CELL];
    for (int k = 0; k < count; k++) snprintf(cell[k], CELL, "%s", columns[k].title);
    printf(tsv ? "#" : "\n");
    print_row(columns, count, (const char(*)[CELL])cell, tsv);
}

static void print_cost(const result *r, const manner *m, const times *t, int tsv) {
    char cell[COST_COLUMNS][CELL];
    double seconds = median(t, PART_ALL);
    snprintf(cell[0], CELL, "%s", r->entry->name);
    snprintf(cell[1], CELL, "%d", r->entry->degree);
    snprintf(cell[2], CELL, "%zu", r->rays);
    snprintf(cell[3], CELL, "%zu", r->hits);
    snprintf(cell[4], CELL, "%s", m->name);
    snprintf(cell[5], CELL, "%d", t->threads);
    snprintf(cell[6], CELL, "%.3f", 1e3 * seconds);
    snprintf(cell[7], CELL, "%.3f", 1e3 * t->seconds[PART_ALL][0]);
    snprintf(cell[8], CELL, "%.3f", 1e3 * t->seconds[PART_ALL][t->count - 1]);
    snprintf(cell[9], CELL, "%.1f", ns_per_ray(r, t, PART_ALL));
    snprintf(cell[10], CELL, "%.2f", 1 / seconds);
    for (int part = PART_EXPAND; part < PARTS; part++)
        snprintf(cell[10 + part], CELL, "%.1f", 100 * median(t, part) / (seconds * t->threads));
    snprintf(cell[16], CELL, "%.2f", seconds / median(&r->times[0], PART_ALL));
    print_row(cost_columns, COST_COLUMNS, (const char(*)[CELL])cell, tsv);
}

static void print_floor(const result *r, const char *kernel, const times *whole, const times *lifted,
                        int tsv) {
    char cell[FLOOR_COLUMNS][CELL];
    double solve = ns_per_ray(r, whole, PART_SOLVE), least = ns_per_ray(r, lifted, PART_SOLVE);
    snprintf(cell[0], CELL, "%s", r->entry->name);
    snprintf(cell[1], CELL, "%d", r->entry->degree);
    snprintf(cell[2], CELL, "%s", kernel);
    snprintf(cell[3], CELL, "%.1f", solve);
    snprintf(cell[4], CELL, "%.1f", least);
    snprintf(cell[5], CELL, "%.2f", solve / least);
    print_row(floor_columns, FLOOR_COLUMNS, (const char(*)[CELL])cell, tsv);
}

static void print_head(const bench_options *o) {
    const char *mark = o->tsv ? "# " : "";
    char machine[512];
    measure_machine(machine, sizeof machine);
    for (const char *line = legend; *line; line += strcspn(line, "\n") + 1)
        printf("%s%.*s\n", mark, (int)strcspn(line, "\n"), line);
    printf("%smachine: %s\n%ssize: %dx%d\n%srepeat: %d\n", mark, machine, mark, o->width, o->height, mark,
           o->repeat);
}

static void print_tables(const bench_options *o, const plan *p, const result *results) {
    print_head(o);
    print_titles(cost_columns, COST_COLUMNS, o->tsv);
    for (const result *r = results; r < results + o->surfaces; r++)
        for (int i = 0; i < p->count; i++)
            if (!p->manner[i].lifted) print_cost(r, &p->manner[i], &r->times[i], o->tsv);
    print_titles(floor_columns, FLOOR_COLUMNS, o->tsv);
    for (const result *r = results; r < results + o->surfaces; r++)
        for (int i = 0; i < p->kernels; i++)
            print_floor(r, p->manner[i].name, &r->times[i], &r->times[p->kernels + i], o->tsv);
    cli_finish_output();
}

/* ---- the run ---- */

/* All of the catalogue, but for second names of a surface. */
static void add_all_surfaces(bench_options *o) {
    for (const catalogue_entry *entry = catalogue; entry->name; entry++) {
        const catalogue_entry *first = catalogue;
        while (strcmp(first->equation, entry->equation) != 0) first++;
        if (first == entry) add_surface(o, entry);
    }
}

int main(int argc, char **argv) {
    bench_options o = {.width = 1024, .height = 768, .repeat = 5};
    plan p;
    cli_parse(&program, argc, argv, &o);
    if (o.extra) cli_fail(CLI_BAD_INPUT, "unexpected '%s'", cli_quote(o.extra).text);
    if (o.surfaces == 0) add_all_surfaces(&o);
    make_plan(&p, o.no_full);
    result *results = calloc((size_t)o.surfaces, sizeof *results);
    if (!results) cli_no_memory();
    for (int i = 0; i < o.surfaces; i++) measure(&o, &p, o.surface[i], &results[i]);
    print_tables(&o, &p, results);
    free(results);
    return 0;
}
