/* zerofind.c - plots the polynomial along one ray, and how its first root is found: zerofind --help.
 * After the program ZEROFIND in Chuyeshov, Visualization of algebraic surfaces, 2005, section 3.2. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli_surface.h"
#include "fit.h"
#include "output.h"
#include "table.h"
#include "view.h"
#include "zerofind_plot.h"
#include "zerofind_solve.h"

typedef struct zerofind_ray {
    int given;
    algsurf_ray ray;
} zerofind_ray;

typedef struct zerofind_pixel {
    int given, x, y;
} zerofind_pixel;

typedef struct zerofind_options {
    cli_surface surface;
    view_options view;
    zerofind_pixel pixel;
    zerofind_ray ray;
    cli_planes clip;
    algsurf_intersect_options how;
    int trace, json;
    const char *output;
} zerofind_options;

/* The text between commas; returns how many, of which at most `capacity` are stored. */
static int split_commas(char *text, char **fields, int capacity) {
    int count = 0;
    for (char *at = text; at;) {
        char *comma = strchr(at, ',');
        if (comma) *comma++ = '\0';
        if (count < capacity) fields[count] = at;
        count++;
        at = comma;
    }
    return count;
}

static char *copy_of(const char *text) {
    char *copy = malloc(strlen(text) + 1);
    if (!copy) cli_no_memory();
    return strcpy(copy, text);
}

static void set_pixel(const cli_option *option, const char *value, void *field) {
    zerofind_pixel pixel = {.given = 1};
    char *text = copy_of(value), *fields[2];
    if (split_commas(text, fields, 2) != 2 || !cli_whole(fields[0], 0, 65534, &pixel.x) ||
        !cli_whole(fields[1], 0, 65534, &pixel.y))
        cli_fail(CLI_BAD_INPUT, "%s: expected two whole numbers X,Y, got '%s'", option->name,
                 cli_quote(value).text);
    free(text);
    *(zerofind_pixel *)field = pixel;
}

/* Six numbers or eight; only the last two may be infinite. */
static void set_ray(const cli_option *option, const char *value, void *field) {
    char *text = copy_of(value), *fields[8];
    double x[8] = {[6] = 0, [7] = INFINITY};
    int count = split_commas(text, fields, 8), good = count == 6 || count == 8;
    for (int i = 0; i < count && good; i++)
        good = cli_number(fields[i], &x[i]) && !isnan(x[i]) && (i >= 6 || isfinite(x[i]));
    free(text);
    if (!good)
        cli_fail(CLI_BAD_INPUT, "%s: expected %s, got '%s'", option->name, option->argument,
                 cli_quote(value).text);
    if (x[3] == 0 && x[4] == 0 && x[5] == 0)
        cli_fail(CLI_BAD_INPUT, "%s: the direction is zero", option->name);
    *(zerofind_ray *)field = (zerofind_ray){1, {{x[0], x[1], x[2]}, {x[3], x[4], x[5]}, x[6], x[7]}};
}

#define FIELD(member) offsetof(zerofind_options, member), 0, 0

static const cli_option options_table[] = {
    CLI_HEADING("The surface"),
    CLI_SURFACE_OPTIONS(zerofind_options),
    CLI_HEADING("The ray"),
    {"--pixel", "X,Y", "the ray through the middle of that pixel; 0,0 is the upper left corner", set_pixel,
     FIELD(pixel)},
    {"--ray", "OX,OY,OZ,DX,DY,DZ[,TMIN,TMAX]",
     "the ray o + t d, TMIN <= t <= TMAX, default 0 and inf; not with the options of the\n"
     "camera: --size, --eye, --look-at, --up, --fov, --orthographic, --zoom, --turn",
     set_ray, FIELD(ray)},
    {"--clip", "A,B,C,D", "only hits with A x + B y + C z <= D; may be given up to 8 times", cli_set_clip,
     FIELD(clip)},
    CLI_HEADING("The view, as for render"),
    VIEW_OPTIONS(zerofind_options),
    CLI_HEADING("The search and what is written"),
    {"--method", "default|brent|bisection|regula-falsi",
     "how the root is computed when an interval is found that holds it alone; default:\n"
     "Newton's method, kept inside that interval",
     cli_set_method, FIELD(how.method)},
    {"--tolerance", "EPS", "how much t may be wrong, default 0: as little as doubles can", cli_set_tolerance,
     FIELD(how.absolute_tolerance)},
    {"--output", "FILE", "the plot, an SVG file; also -o; - is standard output", cli_set_text, FIELD(output)},
    {"--trace", NULL,
     "prints the search as a table on standard output; --output may then be left out.\n"
     "The columns: k, a number; point, what the row is: cell, end, iterate, root, other\n"
     "(a later root), undecided, or miss: no root; t; P, the value P*(t); t_lo, t_hi, the interval known\n"
     "then; signs, of a cell's Bernstein coefficients; engine, doubles or integers",
     cli_set_flag, FIELD(trace)},
    {"--format", "tsv|json",
     "of --trace.  tsv (default): a table.  json: an object a line, with null for '-'", cli_set_choice,
     FIELD(json)},
    {NULL, NULL, NULL, NULL, 0, 0, 0}};

static const cli_program program = {
    .name = "zerofind",
    .synopsis = "[options] (--pixel X,Y | --ray OX,OY,OZ,DX,DY,DZ[,TMIN,TMAX]) --output FILE.svg\n"
                "                (NAME | EQUATION | --terms FILE)",
    .about = "Shows how the first hit of one ray o + t d with a surface P = 0 is found.  It plots the\n"
             "polynomial P*(t) = P(o + t d) along the ray, as far as the ray is inside the extent and kept\n"
             "by --clip, with its roots, the interval that holds the first one alone, and each step\n"
             "towards it.  NAME is a surface that render --list shows.",
    .options = options_table,
    .positional = offsetof(zerofind_options, surface.name),
    .examples = "zerofind barth --pixel 500,300 --output p.svg\n"
                "zerofind tangle --ray -4,1,1.7,1,0,0 --method regula-falsi --trace",
};

static void refuse_camera(const view_options *asked) {
    const struct {
        const char *name;
        int given;
    } options[] = {
        {"--size", asked->width > 0},        {"--eye", asked->eye.given},
        {"--look-at", asked->look_at.given}, {"--up", asked->up.given},
        {"--fov", asked->fov > 0},           {"--orthographic", asked->orthographic > 0},
        {"--zoom", asked->zoom > 0},         {"--turn", asked->turn[0] != 0 || asked->turn[1] != 0}};
    for (size_t i = 0; i < sizeof options / sizeof *options; i++)
        if (options[i].given) cli_fail(CLI_BAD_INPUT, "%s: has no effect with --ray", options[i].name);
}

static zerofind_options parse(int argc, char **argv) {
    zerofind_options options = {.how = {.size = sizeof options.how}};
    cli_parse(&program, argc, argv, &options);
    cli_settle_surface(&options.surface);
    if (options.pixel.given + options.ray.given != 1)
        cli_fail(CLI_BAD_INPUT, "expected %s --pixel X,Y and --ray OX,OY,OZ,DX,DY,DZ",
                 options.pixel.given ? "only one of" : "one of");
    if (!options.output && !options.trace)
        cli_fail(CLI_BAD_INPUT, "expected --output FILE.svg, or --trace for a table");
    if (options.json && !options.trace) cli_fail(CLI_BAD_INPUT, "--format: has no effect without --trace");
    if (options.trace && options.output && strcmp(options.output, "-") == 0)
        cli_fail(CLI_BAD_INPUT, "--output: '-' takes the plot or the table of --trace, not both");
    if (options.ray.given) refuse_camera(&options.view);
    if (options.surface.file) view_follow(&options.view, options.surface.file);
    view_check(&options.view);
    if (options.pixel.given &&
        (options.pixel.x >= options.view.width || options.pixel.y >= options.view.height))
        cli_fail(CLI_BAD_INPUT, "--pixel: %d,%d is outside of a picture of %dx%d", options.pixel.x,
                 options.pixel.y, options.view.width, options.view.height);
    return options;
}

static void demand(algsurf_status status) {
    if (status == ALGSURF_E_NO_MEMORY) cli_no_memory();
    if (status != ALGSURF_OK) cli_fail(CLI_BAD_INPUT, "the ray: %s", algsurf_status_text(status));
}

static algsurf_ray choose_ray(const zerofind_options *options, const view *shown) {
    if (options->ray.given) return options->ray.ray;
    algsurf_camera camera = view_camera(shown, 0, 1);
    algsurf_ray ray;
    demand(algsurf_camera_ray(&camera, options->view.width, options->view.height, options->pixel.x + 0.5,
                              options->pixel.y + 0.5, &ray));
    return ray;
}

/* ---- the table ---- */

static const char *engine_name(int engine) {
    return engine == ALGSURF_ENGINE_INTEGERS ? "integers" : "doubles";
}

static void print_row(table *out, const char *kind, double t, double value, double lo, double hi,
                      const char *engine) {
    table_add(out, "%s\t%.17g\t%.17g\t%.17g\t%.17g\t-\t%s", kind, t, value, lo, hi, engine);
    table_end(out);
}

static void print_hit(table *out, const algsurf_hit *hit, const char *kind, const algsurf_surface *surface) {
    double value = 0;
    (void)algsurf_surface_value(surface, hit->position, &value, NULL);
    table_add(out, "-\t");
    print_row(out, hit->state == ALGSURF_STATE_HIT ? kind : "undecided", hit->t, value, hit->t_lo, hit->t_hi,
              "-");
}

static void print_trace(const zerofind *z, const algsurf_surface *surface, int json) {
    table out = {.columns = "k\tpoint\tt\tP\tt_lo\tt_hi\tsigns\tengine", .json = json};
    table_head(&out);
    for (int k = 0; k < z->cell_count; k++) {
        const zerofind_cell *c = &z->cells[k];
        table_add(&out, "%d\tcell\t-\t-\t%.17g\t%.17g\t%s\t%s", k, c->t_lo, c->t_hi, c->signs,
                  engine_name(c->engine));
        table_end(&out);
    }
    for (int k = 0; k < z->point_count; k++) {
        const zerofind_point *p = &z->points[k];
        table_add(&out, "%d\t", k);
        print_row(&out, p->is_end ? "end" : "iterate", p->t, p->value, p->t_lo, p->t_hi,
                  engine_name(p->engine));
    }
    for (int i = 0; i < z->count; i++) print_hit(&out, z->hits + i, i == 0 ? "root" : "other", surface);
    if (z->count == 0) {
        table_add(&out, "-\tmiss\t-\t-\t-\t-\t-\t-");
        table_end(&out);
    }
    free(out.row);
    cli_finish_output();
}

/* ---- the plot ---- */

static void write_plot(output_set *set, const char *path, const zerofind *z, const zerofind_words *words) {
    FILE *file = output_open(set, path);
    if (zerofind_plot(z, words, file) != 0) output_fail(set, path, "out of memory");
    output_close(set, path, file);
}

/* The ray, as the plot names it. */
static void describe_ray(const zerofind_options *options, const algsurf_ray *ray, char *text, size_t size) {
    const double *o = ray->origin, *d = ray->direction;
    if (options->pixel.given)
        snprintf(text, size, "The ray through pixel %d,%d of %dx%d", options->pixel.x, options->pixel.y,
                 options->view.width, options->view.height);
    else
        snprintf(text, size, "The ray (%.6g, %.6g, %.6g) + t (%.6g, %.6g, %.6g)", o[0], o[1], o[2], d[0],
                 d[1], d[2]);
}

int main(int argc, char **argv) {
    static zerofind z;
    output_set set = {.count = 0};
    zerofind_options options = parse(argc, argv);
    output_check(&options.output, 1, options.surface.path);
    const cli_surface *given = &options.surface;
    cli_quoted name = cli_quote(given->name       ? given->name
                                : given->equation ? given->equation
                                : given->terms    ? given->terms
                                                  : "");
    algsurf_surface *surface = cli_make_surface(&options.surface);
    view shown = view_make(&options.view, given->name ? catalogue_find(given->name) : NULL);
    if (!given->name && options.pixel.given) fit_view(&shown, &options.view, surface, 0, 1);
    algsurf_ray ray = choose_ray(&options, &shown);
    chord on;
    int meets;
    demand(chord_make(surface, &shown.extent, options.clip.plane, options.clip.count, &ray, &on, &meets));
    if (!meets)
        cli_fail(CLI_BAD_INPUT,
                 "the ray misses the extent%s: there is nothing to plot (--extent, --centre%s)",
                 options.clip.count > 0 ? ", or what --clip leaves of it" : "",
                 options.clip.count > 0 ? ", --clip" : "");
    options.how.planes = options.clip.plane;
    options.how.plane_count = options.clip.count;
    demand(zerofind_solve(surface, &shown.extent, &ray, &on, &options.how, &z));
    if (options.output) {
        char about[160];
        describe_ray(&options, &ray, about, sizeof about);
        zerofind_words words = {name.text, about, options.how.method,
                                options.pixel.given ? "t, the distance from the camera"
                                                    : "t, in lengths of the ray's direction"};
        write_plot(&set, options.output, &z, &words);
    }
    if (options.trace) print_trace(&z, surface, options.json);
    output_commit(&set); /* there is a plot only if there is a table, where both are wanted */
    algsurf_surface_free(surface);
    cli_forget_surface(&options.surface);
    return 0;
}
